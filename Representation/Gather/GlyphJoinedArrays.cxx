#include "GlyphJoinedArrays.h"

#include "RayTracedParallel.h"
#include "RayTracedArrays.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace
{
// The names between the commas, without blanks around them; fewer than two are none.
std::vector<std::string> Parts(const std::string& name)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();)
  {
    const std::size_t end = std::min(name.find(',', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    const std::size_t first = part.find_first_not_of(' ');
    parts.push_back(
      first == std::string::npos ? std::string() : part.substr(first, part.find_last_not_of(' ') - first + 1));
    begin = end + 1;
  }
  return parts.size() < 2 ? std::vector<std::string>() : parts;
}
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphJoinedArrays::Add(vtkPolyData* points, const std::string& name)
{
  const std::vector<std::string> parts = Parts(name);
  vtkPointData* data = points->GetPointData();
  if (parts.empty() || data->HasArray(name.c_str()))
  {
    return;
  }
  std::vector<vtkDataArray*> arrays;
  int components = 0;
  for (const std::string& part : parts)
  {
    vtkDataArray* array = data->GetArray(part.c_str());
    if (!array)
    {
      return;
    }
    arrays.push_back(array);
    components += array->GetNumberOfComponents();
  }
  // A reader of tables makes columns of whole numbers and of fractions; doubles hold what glyphs read of any type.
  const int type = arrays.front()->GetDataType();
  const bool alike =
    std::all_of(arrays.begin(), arrays.end(), [type](vtkDataArray* array) { return array->GetDataType() == type; });
  auto joined = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(alike ? type : VTK_DOUBLE));
  joined->SetName(name.c_str());
  joined->SetNumberOfComponents(components);
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
