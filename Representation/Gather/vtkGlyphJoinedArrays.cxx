#include "vtkGlyphJoinedArrays.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRayTracedParallel.h"
#include "vtkSmartPointer.h"

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
void vtkGlyphJoinedArrays::Add(vtkPolyData* points, const std::string& name)
{
  const std::vector<std::string> parts = Parts(name);
  vtkPointData* data = points->GetPointData();
  if (parts.empty() || data->HasArray(name.c_str()))
  {
    return;
  }
  std::vector<vtkDataArray*> components;
  for (const std::string& part : parts)
  {
    vtkDataArray* component = data->GetArray(part.c_str());
    if (!component || component->GetNumberOfComponents() != 1)
    {
      return;
    }
    components.push_back(component);
  }
  auto joined = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(components.front()->GetDataType()));
  joined->SetName(name.c_str());
  joined->SetNumberOfComponents(static_cast<int>(components.size()));
  joined->SetNumberOfTuples(points->GetNumberOfPoints());
  vtkRayTracedParallel::ForChunks(points->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t c = 0; c < components.size(); ++c)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          joined->SetComponent(i, static_cast<int>(c), components[c]->GetComponent(i, 0));
        }
      }
    });
  data->AddArray(joined);
}
