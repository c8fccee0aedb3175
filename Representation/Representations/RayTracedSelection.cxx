#include "RayTracedSelection.h"

#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTree.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
using Id = std::pair<unsigned int, vtkTypeInt64>; // flat index of the block, number in it

// Appends ids of points, and of cells as EncodeCellId() has them.
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
  add(extracted->GetCellData()->GetArray("vtkOriginalCellIds"), rtglyphs::RayTracedArrays::CellIdOffset);
}

// For each of so many points or cells, whether it is among the ids, which are sorted.
vtkSmartPointer<vtkUnsignedCharArray>
Marks(const std::vector<Id>& ids, unsigned int block, vtkIdType count, vtkDataArray* numbers, vtkTypeInt64 mark)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(rtglyphs::RayTracedArrays::Selected);
  rtglyphs::RayTracedArrays::Resize(array, count);
  rtglyphs::RayTracedParallel::ForEach(count,
    [&](vtkIdType i)
    {
      const Id id(block, mark + (numbers ? static_cast<vtkTypeInt64>(numbers->GetComponent(i, 0)) : i));
      array->SetValue(i, std::binary_search(ids.begin(), ids.end(), id) ? 1 : 0);
    });
  return array;
}
}

//----------------------------------------------------------------------------
// ParaView puts a filter that does nothing behind the one that extracts what is selected, whose second input is the
// selection.
bool rtglyphs::RayTracedSelection::Exists(vtkAlgorithm* representation, int port)
{
  vtkAlgorithm* producer =
    representation->GetNumberOfInputConnections(port) > 0 ? representation->GetInputAlgorithm(port, 0) : nullptr;
  while (producer && producer->GetNumberOfInputPorts() == 1 && producer->GetNumberOfInputConnections(0) > 0)
  {
    producer = producer->GetInputAlgorithm(0, 0);
  }
  return producer && producer->GetNumberOfInputPorts() > 1 && producer->GetNumberOfInputConnections(1) > 0;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> rtglyphs::RayTracedSelection::Mark(vtkDataObject* gathered, vtkDataObject* extracted)
{
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

  return rtglyphs::RayTracedTree::Change(gathered,
    [&ids](vtkPolyData* points)
    {
      auto marked = vtkSmartPointer<vtkPolyData>::New();
      marked->ShallowCopy(points);
      const unsigned int block = rtglyphs::RayTracedTree::FlatIndex(points);
      vtkDataArray* numbers = points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::PointIds);
      marked->GetPointData()->AddArray(Marks(ids, block, points->GetNumberOfPoints(), numbers, 0));
      if (points->GetNumberOfLines() > 0)
      {
        numbers = points->GetCellData()->GetArray(rtglyphs::RayTracedArrays::CellIds);
        marked->GetCellData()->AddArray(
          Marks(ids, block, points->GetNumberOfCells(), numbers, rtglyphs::RayTracedArrays::CellIdOffset));
      }
      return marked;
    });
}
