#include "vtkGlyphPointGatherer.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDataSetRange.h"
#include "vtkDataArrayRange.h"
#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGlyphLeaves.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrayUnion.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedParallel.h"
#include "vtkStringArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace
{
namespace parallel = vtkRayTracedParallel;

using Leaf = vtkGlyphLeaves::Leaf;

vtkDataSetAttributes* AttributesOf(const Leaf& leaf, bool cells)
{
  if (cells)
  {
    return leaf.HasCells() ? leaf.Data->GetCellData() : nullptr;
  }
  return leaf.Data->GetPointData();
}

vtkRayTracedArrayUnion UnionOf(const std::vector<Leaf>& leaves, bool cells)
{
  std::vector<vtkDataSetAttributes*> sets(leaves.size());
  std::transform(
    leaves.begin(), leaves.end(), sets.begin(), [cells](const Leaf& leaf) { return AttributesOf(leaf, cells); });
  return { sets, [](vtkDataSetAttributes*, vtkAbstractArray* array) {
            return vtkDataSetAttributes::GhostArrayName() != std::string(array->GetName());
          } };
}

// The leaf's tuples become those of another array of the same values, from `next` on.
struct CopyTuples
{
  template <class From, class To>
  void operator()(From* from, To* to, const Leaf& leaf, bool cells, vtkIdType next) const
  {
    const auto source = vtk::DataArrayTupleRange(from);
    auto target = vtk::DataArrayTupleRange(to);
    parallel::ForChunks(leaf.Count(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          target[next + i] = source[cells ? leaf.Cell(i) : leaf.Point(i)];
        }
      });
  }
};

void CopyLeaf(vtkAbstractArray* from, vtkAbstractArray* to, const Leaf& leaf, bool cells, vtkIdType next)
{
  CopyTuples copy;
  auto* numbers = vtkDataArray::SafeDownCast(from);
  auto* target = vtkDataArray::SafeDownCast(to);
  if (numbers && target && vtkArrayDispatch::Dispatch2SameValueType::Execute(numbers, target, copy, leaf, cells, next))
  {
    return;
  }
  const auto copyRange = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      to->SetTuple(next + i, cells ? leaf.Cell(i) : leaf.Point(i), from);
    }
  };
  // Tuples of bits share bytes, and texts are no numbers.
  if (numbers && target && from->GetDataType() != VTK_BIT && to->GetDataType() != VTK_BIT)
  {
    parallel::ForChunks(leaf.Count(), copyRange);
  }
  else
  {
    copyRange(0, leaf.Count());
  }
}

// Appends the union of all leaves' arrays to `out`, in the order of the leaves' points.
void AppendArrays(const std::vector<Leaf>& leaves, vtkIdType count, bool cells, vtkDataSetAttributes* out,
  const parallel::Progress& progress)
{
  const vtkRayTracedArrayUnion all = UnionOf(leaves, cells);
  double done = 0.0;
  for (const auto& [name, item] : all.Items())
  {
    vtkSmartPointer<vtkAbstractArray> array = item.Make(count, all.IsExact(item));
    vtkIdType next = 0;
    for (const Leaf& leaf : leaves)
    {
      if (vtkAbstractArray* from = item.Of(AttributesOf(leaf, cells)))
      {
        CopyLeaf(from, array, leaf, cells, next);
      }
      else
      {
        vtkRayTracedArrayUnion::Holes::Fill(array, next, leaf.Count());
      }
      next += leaf.Count();
    }
    out->AddArray(array);
    done += 1.0;
    if (progress)
    {
      progress(done / static_cast<double>(all.Items().size()));
    }
  }
}

void AppendPoints(
  const std::vector<Leaf>& leaves, vtkIdType count, vtkPolyData* out, const parallel::Progress& progress)
{
  // The precision of the input is kept; grids whose points are computed get double.
  int type = VTK_FLOAT;
  for (const Leaf& leaf : leaves)
  {
    auto* set = vtkPointSet::SafeDownCast(leaf.Data);
    if (!set || set->GetPoints()->GetDataType() != VTK_FLOAT)
    {
      type = VTK_DOUBLE;
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(count);
  vtkIdType next = 0;
  for (const Leaf& leaf : leaves)
  {
    double first[3];
    leaf.Data->GetPoint(0, first); // builds what the threads need
    parallel::ForChunks(
      leaf.Count(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          double x[3];
          leaf.Data->GetPoint(leaf.Point(i), x);
          points->SetPoint(next + i, x);
        }
      },
      parallel::Part(progress, static_cast<double>(next) / static_cast<double>(count),
        static_cast<double>(next + leaf.Count()) / static_cast<double>(count)));
    next += leaf.Count();
  }
  out->SetPoints(points);
}

// An array of value(leaf, i) for the i-th point of each leaf.
template <typename ArrayType, typename Value>
void AddIds(vtkPolyData* out, const char* name, const std::vector<Leaf>& leaves, const Value& value)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfTuples(out->GetNumberOfPoints());
  auto* values = array->GetPointer(0);
  for (const Leaf& leaf : leaves)
  {
    parallel::ForChunks(leaf.Count(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          values[i] = value(leaf, i);
        }
      });
    values += leaf.Count();
  }
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  out->GetPointData()->AddArray(array);
}

void AddPickingIds(const std::vector<Leaf>& leaves, bool composite, int processId, int processes, vtkPolyData* out)
{
  const bool identity = leaves.size() == 1 && leaves.front().All && !leaves.front().CellIds && processes == 1;
  if (!identity)
  {
    AddIds<vtkIdTypeArray>(out, vtkRayTracedArrays::PointIds, leaves,
      [](const Leaf& leaf, vtkIdType i)
      {
        const vtkIdType point = leaf.Point(i);
        return leaf.CellIds ? vtkRayTracedArrays::Marked(leaf.CellIds->GetValue(point)) : point;
      });
  }
  if (std::any_of(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return leaf.HasCells(); }))
  {
    AddIds<vtkIdTypeArray>(out, vtkRayTracedArrays::CellIds, leaves,
      [](const Leaf& leaf, vtkIdType i) { return leaf.HasCells() ? leaf.Cell(i) : -1; });
  }
  if (composite)
  {
    AddIds<vtkUnsignedIntArray>(
      out, vtkRayTracedArrays::CompositeIndex, leaves, [](const Leaf& leaf, vtkIdType) { return leaf.FlatIndex; });
    AddIds<vtkUnsignedIntArray>(out, vtkRayTracedArrays::BlockColors, leaves,
      [](const Leaf& leaf, vtkIdType) { return leaf.Block % vtkRayTracedArrays::DistinctBlockColors; });
  }
  if (processes > 1)
  {
    AddIds<vtkUnsignedIntArray>(out, vtkRayTracedArrays::ProcessId, leaves,
      [processId](const Leaf&, vtkIdType) { return static_cast<unsigned int>(processId); });
  }
}

// One vertex a point.
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType count)
{
  const auto counting = [](vtkIdType last)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(last);
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
vtkSmartPointer<vtkPolyData> vtkGlyphPointGatherer::Gather(vtkDataObject* input, const Options& options)
{
  auto out = vtkSmartPointer<vtkPolyData>::New();
  if (!input)
  {
    return out;
  }
  std::vector<Leaf> leaves = vtkGlyphLeaves::Find(input, options.CellCenters);
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite && !leaves.empty() && options.Processes > 1 && options.WholeExtent)
  {
    vtkGlyphLeaves::DropSharedFaces(leaves.front(), options.WholeExtent);
  }
  const vtkIdType count = std::accumulate(
    leaves.begin(), leaves.end(), vtkIdType(0), [](vtkIdType sum, const Leaf& leaf) { return sum + leaf.Count(); });
  const parallel::Progress progress = parallel::Worthwhile(options.Progress, count);

  // A single data set of points is shared with the input where all of them carry glyphs.
  const Leaf* whole = leaves.size() == 1 && leaves.front().All ? &leaves.front() : nullptr;
  auto* single = whole ? vtkPointSet::SafeDownCast(whole->Data) : nullptr;
  const bool sharesCells = whole && whole->HasCells() && whole->CellOfPoint.empty();
  if (single)
  {
    out->SetPoints(single->GetPoints());
    out->GetPointData()->ShallowCopy(single->GetPointData());
  }
  else if (count > 0)
  {
    AppendPoints(leaves, count, out, parallel::Part(progress, 0.0, 0.3));
    AppendArrays(leaves, count, false, out->GetPointData(), parallel::Part(progress, 0.3, 0.8));
    // Which array the global ids are must not get lost.
    if (vtkDataArray* ids = leaves.front().Data->GetPointData()->GetGlobalIds())
    {
      out->GetPointData()->SetActiveGlobalIds(ids->GetName());
    }
  }
  if (sharesCells)
  {
    const vtkRayTracedArrayUnion arrays = UnionOf(leaves, true);
    for (const auto& [name, item] : arrays.Items())
    {
      out->GetCellData()->AddArray(item.First);
    }
  }
  else if (count > 0)
  {
    AppendArrays(leaves, count, true, out->GetCellData(), parallel::Part(progress, 0.8, 0.9));
  }
  if (count > 0)
  {
    AddPickingIds(leaves, composite != nullptr, options.ProcessId, options.Processes, out);
  }
  if (composite)
  {
    AddHierarchy(composite, out);
  }
  // Filters that redistribute between ranks, and cell data, need a cell for each point.
  if (options.Processes > 1 || out->GetCellData()->GetNumberOfArrays() > 0)
  {
    out->SetVerts(sharesCells ? vtkSmartPointer<vtkCellArray>(whole->Vertices) : MakeVertices(count));
  }
  return out;
}

//----------------------------------------------------------------------------
// Small, and so delivered with the points to wherever they are rendered.
void vtkGlyphPointGatherer::AddHierarchy(vtkCompositeDataSet* composite, vtkPolyData* out)
{
  vtkNew<vtkDataAssembly> hierarchy;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  if (!vtkDataAssemblyUtilities::GenerateHierarchy(composite, hierarchy, collection) || !collection->GetDataAssembly())
  {
    return;
  }
  // Of the two copies of the hierarchy only the collection's speaks of data sets by their index in it.
  std::map<vtkDataObject*, unsigned int> dataSetIndex;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int p = 0; p < collection->GetNumberOfPartitions(i); ++p)
    {
      dataSetIndex[collection->GetPartitionAsDataObject(i, p)] = i;
    }
  }
  vtkNew<vtkUnsignedIntArray> leaves;
  leaves->SetName(vtkRayTracedArrays::Leaves);
  leaves->SetNumberOfComponents(2);
  for (auto node : vtk::Range(composite, vtk::CompositeDataSetOptions::SkipEmptyNodes))
  {
    const auto found = dataSetIndex.find(node.GetDataObject());
    if (found != dataSetIndex.end())
    {
      const unsigned int pair[2] = { node.GetFlatIndex(), found->second };
      leaves->InsertNextTypedTuple(pair);
    }
  }
  vtkNew<vtkStringArray> xml;
  xml->SetName(vtkRayTracedArrays::Hierarchy);
  xml->InsertNextValue(collection->GetDataAssembly()->SerializeToXML(vtkIndent()));
  // Both trees of a collection have its data sets by the same numbers.
  auto* own = vtkPartitionedDataSetCollection::SafeDownCast(composite);
  if (own && own->GetDataAssembly())
  {
    xml->InsertNextValue(own->GetDataAssembly()->SerializeToXML(vtkIndent()));
  }
  out->GetFieldData()->AddArray(xml);
  out->GetFieldData()->AddArray(leaves);
}
