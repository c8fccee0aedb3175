#include "vtkGlyphSelection.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedParallel.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
using Id = std::pair<unsigned int, vtkTypeInt64>; // flat index of the block, number in it

// Those of points, and Marked() those of cells, sorted.
void AddIds(std::vector<Id>& ids, vtkDataSet* extracted, unsigned int block)
{
  if (!extracted)
  {
    return;
  }
  const auto add = [&](vtkDataArray* originals, vtkTypeInt64 mark)
  {
    for (vtkIdType i = 0; originals && i < originals->GetNumberOfTuples(); ++i)
    {
      ids.emplace_back(block, static_cast<vtkTypeInt64>(originals->GetComponent(i, 0)) + mark);
    }
  };
  add(extracted->GetPointData()->GetArray("vtkOriginalPointIds"), 0);
  add(extracted->GetCellData()->GetArray("vtkOriginalCellIds"), vtkRayTracedArrays::Mark);
}

// Of each cell of data that have lines and maybe vertices; 0 of those without points.
std::vector<vtkIdType> FirstPoints(vtkPolyData* data)
{
  std::vector<vtkIdType> first(data->GetNumberOfCells(), 0);
  vtkIdType cell = data->GetNumberOfVerts();
  auto line = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    line->GetCurrentCell(size, points);
    first[cell] = size > 0 ? points[0] : 0;
  }
  return first;
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkGlyphSelection::Mark(vtkPolyData* points, vtkDataObject* extracted)
{
  if (!extracted)
  {
    return points;
  }
  std::vector<Id> ids;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(extracted))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      AddIds(ids, vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()), leaf->GetCurrentFlatIndex());
    }
  }
  else
  {
    AddIds(ids, vtkDataSet::SafeDownCast(extracted), 0);
  }
  std::sort(ids.begin(), ids.end());

  vtkDataArray* blocks = points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex);
  const auto marks = [&](vtkIdType count, vtkDataArray* numbers, vtkTypeInt64 mark, const auto& pointOf)
  {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName(vtkRayTracedArrays::Selected);
    array->SetNumberOfValues(count);
    vtkRayTracedParallel::ForChunks(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id id(blocks ? static_cast<unsigned int>(blocks->GetComponent(pointOf(i), 0)) : 0,
            mark + (numbers ? static_cast<vtkTypeInt64>(numbers->GetComponent(i, 0)) : i));
          array->SetValue(i, std::binary_search(ids.begin(), ids.end(), id) ? 1 : 0);
        }
      });
    return array;
  };
  auto marked = vtkSmartPointer<vtkPolyData>::New();
  marked->ShallowCopy(points);
  vtkPointData* data = points->GetPointData();
  marked->GetPointData()->AddArray(
    marks(points->GetNumberOfPoints(), data->GetArray(vtkRayTracedArrays::PointIds), 0, [](vtkIdType i) { return i; }));
  if (points->GetNumberOfLines() > 0)
  {
    const std::vector<vtkIdType> first = FirstPoints(points);
    marked->GetCellData()->AddArray(
      marks(static_cast<vtkIdType>(first.size()), points->GetCellData()->GetArray(vtkRayTracedArrays::CellIds),
        vtkRayTracedArrays::Mark, [&first](vtkIdType i) { return first[i]; }));
  }
  return marked;
}
