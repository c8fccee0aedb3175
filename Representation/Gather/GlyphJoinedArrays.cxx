#include "GlyphJoinedArrays.h"

#include "RayTracedParallel.h"
#include "RayTracedArrays.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPeriodicTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace
{
// The arrays whose names have commas between them, without blanks round them; fewer than two are none. A name may have
// commas itself: the longest that is there counts.
std::vector<vtkDataArray*> Parts(vtkPointData* data, const std::string& name)
{
  std::vector<vtkDataArray*> parts;
  for (std::size_t begin = 0; begin <= name.size();)
  {
    begin = std::min(name.find_first_not_of(' ', begin), name.size());
    vtkDataArray* found = nullptr;
    std::size_t next = 0;
    for (std::size_t end = name.size(); !found && end != std::string::npos && end > begin;
         end = name.rfind(',', end - 1))
    {
      found = data->GetArray(name.substr(begin, name.find_last_not_of(' ', end - 1) + 1 - begin).c_str());
      next = end + 1;
    }
    if (!found)
    {
      return {};
    }
    parts.push_back(found);
    begin = next;
  }
  return parts.size() < 2 ? std::vector<vtkDataArray*>() : parts;
}

// Adds an array of the radii of elements; 0 where there is none of that number.
void AddRadii(vtkPointData* data, const std::string& name, vtkDataArray* numbers)
{
  vtkNew<vtkPeriodicTable> elements;
  vtkNew<vtkFloatArray> radii;
  radii->SetName(name.c_str());
  radii->SetNumberOfTuples(numbers->GetNumberOfTuples());
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    const double number = numbers->GetComponent(i, 0);
    const bool known = number >= 1.0 && number < elements->GetNumberOfElements();
    radii->SetValue(i, known ? elements->GetVDWRadius(static_cast<unsigned short>(number)) : 0.0f);
  }
  data->AddArray(radii);
}
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphJoinedArrays::Add(vtkPolyData* points, const std::string& name)
{
  vtkPointData* data = points->GetPointData();
  if (data->HasArray(name.c_str()))
  {
    return;
  }
  vtkDataArray* numbers = name.starts_with(vanDerWaals) ? data->GetArray(name.c_str() + vanDerWaals.size()) : nullptr;
  if (numbers)
  {
    AddRadii(data, name, numbers);
    return;
  }
  const std::vector<vtkDataArray*> arrays = Parts(data, name);
  if (arrays.empty())
  {
    return;
  }
  int components = 0;
  for (vtkDataArray* array : arrays)
  {
    components += array->GetNumberOfComponents();
  }
  // A reader of tables makes columns of whole numbers and of fractions; doubles hold what glyphs read of any type.
  const int type = arrays.front()->GetDataType();
  const bool alike =
    std::all_of(arrays.begin(), arrays.end(), [type](vtkDataArray* array) { return array->GetDataType() == type; });
  auto joined = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(alike ? type : VTK_DOUBLE));
  joined->SetName(name.c_str());
  joined->SetNumberOfComponents(components);
  for (int i = 0; components == static_cast<int>(arrays.size()) && i < components; ++i)
  {
    joined->SetComponentName(i, arrays[i]->GetName()); // stress_xx, ... say the order of a tensor
  }
  rtglyphs::RayTracedArrays::Resize(joined, points->GetNumberOfPoints());
  rtglyphs::RayTracedParallel::ForChunks(points->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      int to = 0;
      for (vtkDataArray* array : arrays)
      {
        for (int from = 0; from < array->GetNumberOfComponents(); ++from, ++to)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            joined->SetComponent(i, to, array->GetComponent(i, from));
          }
        }
      }
    });
  data->AddArray(joined);
}
