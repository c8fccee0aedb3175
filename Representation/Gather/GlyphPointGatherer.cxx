#include "GlyphPointGatherer.h"

#include "GlyphLeaves.h"
#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cstddef>
#include <numeric>

namespace
{
namespace parallel = rtglyphs::RayTracedParallel;

using Leaf = rtglyphs::GlyphLeaves::Leaf;

// The tuples of a leaf's glyphs: of their points, or of the cells that they stand for.
void CopyArrays(const Leaf& leaf, bool cells, vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  const vtkIdType count = leaf.Count();
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(count);
  parallel::ForEach(count, [&](vtkIdType i) { ids->SetId(i, cells ? leaf.Cell(i) : leaf.Point(i)); });
  std::size_t bytes = 0;
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    bytes += rtglyphs::RayTracedArrays::BytesOf(from->GetAbstractArray(i), count);
  }
  rtglyphs::RayTracedArrays::Check(bytes);
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->CopyData(from, ids);
  to->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}

void CopyPoints(const Leaf& leaf, vtkPolyData* out, const parallel::Progress& progress)
{
  // The precision of the input is kept; grids whose points are computed get double.
  auto* set = vtkPointSet::SafeDownCast(leaf.Data);
  vtkNew<vtkPoints> points;
  points->SetDataType(set ? set->GetPoints()->GetDataType() : VTK_DOUBLE);
  rtglyphs::RayTracedArrays::Resize(points->GetData(), leaf.Count());
  double first[3];
  leaf.Data->GetPoint(0, first); // builds what the threads need
  parallel::ForEach(
    leaf.Count(),
    [&](vtkIdType i)
    {
      double x[3];
      leaf.Data->GetPoint(leaf.Point(i), x);
      points->SetPoint(i, x);
    },
    progress);
  out->SetPoints(points);
}

// An array of value(i) for the i-th point.
template <typename ArrayType, typename Value>
void AddIds(vtkPolyData* out, const char* name, const Value& value)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  rtglyphs::RayTracedArrays::Resize(array, out->GetNumberOfPoints());
  auto* values = array->GetPointer(0);
  parallel::ForEach(out->GetNumberOfPoints(), [&](vtkIdType i) { values[i] = value(i); });
  out->GetPointData()->AddArray(array);
}

void AddPickingIds(const Leaf& leaf, bool isBlock, vtkPolyData* out)
{
  if (isBlock || rtglyphs::RayTracedRanks::Count() > 1 || !leaf.All || leaf.CellIds)
  {
    AddIds<vtkIdTypeArray>(out, rtglyphs::RayTracedArrays::PointIds,
      [&leaf](vtkIdType i)
      {
        const vtkIdType point = leaf.Point(i);
        return leaf.CellIds ? rtglyphs::RayTracedArrays::EncodeCellId(leaf.CellIds->GetValue(point)) : point;
      });
  }
  if (leaf.HasCells())
  {
    AddIds<vtkIdTypeArray>(out, rtglyphs::RayTracedArrays::CellIds, [&leaf](vtkIdType i) { return leaf.Cell(i); });
  }
  if (rtglyphs::RayTracedRanks::Count() > 1)
  {
    AddIds<vtkUnsignedIntArray>(out, rtglyphs::RayTracedArrays::ProcessId,
      [own = rtglyphs::RayTracedRanks::Own()](vtkIdType) { return static_cast<unsigned int>(own); });
  }
}

// One vertex a point.
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType count)
{
  const auto counting = [](vtkIdType last)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    rtglyphs::RayTracedArrays::Resize(array, last);
    vtkIdType* values = array->GetPointer(0);
    parallel::ForChunks(
      last, [values](vtkIdType begin, vtkIdType end) { std::iota(values + begin, values + end, begin); });
    return array;
  };
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(counting(count + 1), counting(count));
  return vertices;
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> rtglyphs::GlyphPointGatherer::Gather(vtkDataObject* data, bool cellCenters, bool isBlock,
  const int* wholeExtent, const rtglyphs::RayTracedParallel::Progress& progress)
{
  auto out = vtkSmartPointer<vtkPolyData>::New();
  Leaf leaf = rtglyphs::GlyphLeaves::Find(data, cellCenters);
  if (!leaf.Data || leaf.Data->GetNumberOfPoints() == 0)
  {
    return out;
  }
  if (!isBlock && rtglyphs::RayTracedRanks::Count() > 1 && wholeExtent)
  {
    rtglyphs::GlyphLeaves::DropSharedFaces(leaf, wholeExtent);
  }
  out->GetFieldData()->PassData(leaf.Data->GetFieldData());
  const vtkIdType count = leaf.Count();

  // Points and arrays are shared with the input where all of them carry glyphs.
  auto* set = leaf.All ? vtkPointSet::SafeDownCast(leaf.Data) : nullptr;
  if (set)
  {
    out->SetPoints(set->GetPoints());
  }
  else if (count > 0)
  {
    CopyPoints(leaf, out, parallel::Part(progress, 0.0, 0.8));
  }
  if (leaf.All)
  {
    out->GetPointData()->ShallowCopy(leaf.Data->GetPointData());
  }
  else if (count > 0)
  {
    CopyArrays(leaf, false, leaf.Data->GetPointData(), out->GetPointData());
  }
  const bool sharesCells = leaf.All && leaf.HasCells() && leaf.CellOfPoint.empty();
  if (sharesCells)
  {
    out->GetCellData()->ShallowCopy(leaf.Data->GetCellData());
    out->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  }
  else if (leaf.HasCells() && count > 0)
  {
    CopyArrays(leaf, true, leaf.Data->GetCellData(), out->GetCellData());
  }
  AddPickingIds(leaf, isBlock, out);
  // Filters that redistribute between ranks, and cell data, need a cell for each point.
  if (rtglyphs::RayTracedRanks::Count() > 1 || out->GetCellData()->GetNumberOfArrays() > 0)
  {
    out->SetVerts(sharesCells ? vtkSmartPointer<vtkCellArray>(leaf.Vertices) : MakeVertices(count));
  }
  return out;
}
