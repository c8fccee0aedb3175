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
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridCellCenters.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
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
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace
{
namespace parallel = vtkRayTracedParallel;

// One data set of the input and the points of it that carry glyphs.
struct Leaf
{
  vtkSmartPointer<vtkDataSet> Data;
  unsigned int FlatIndex = 0;
  unsigned int Block = 0;        // number among the blocks of the input
  bool All = true;               // every point carries a glyph; Points is empty then
  std::vector<vtkIdType> Points; // otherwise these
  // Where Data consists of vertices of one point each, and each point has one: these.
  vtkCellArray* Vertices = nullptr;
  std::vector<vtkIdType> CellOfPoint; // empty where the cell of point i is i
  bool CellCenters = false; // points of Data are the centers of the input's cells, and their arrays say of which

  vtkIdType Count() const
  {
    return this->All ? this->Data->GetNumberOfPoints() : static_cast<vtkIdType>(this->Points.size());
  }
  vtkIdType Point(vtkIdType i) const { return this->All ? i : this->Points[i]; }
  // The cell that a point's glyph stands for.
  bool HasCells() const { return this->Vertices != nullptr; }
  vtkIdType Cell(vtkIdType i) const
  {
    return this->CellOfPoint.empty() ? this->Point(i) : this->CellOfPoint[this->Point(i)];
  }
};

vtkSmartPointer<vtkDataSet> AsDataSet(vtkDataObject* object)
{
  if (auto* grid = vtkHyperTreeGrid::SafeDownCast(object))
  {
    // Coarse cells are numbered, too, but have no center: the arrays say which cell is which.
    vtkNew<vtkHyperTreeGrid> numbered;
    numbered->ShallowCopy(grid);
    vtkGlyphPointGatherer::NumberCells(numbered);
    vtkNew<vtkHyperTreeGridCellCenters> centers;
    centers->SetInputDataObject(numbered);
    centers->VertexCellsOn();
    centers->Update();
    return vtkDataSet::SafeDownCast(centers->GetOutputDataObject(0));
  }
  return vtkDataSet::SafeDownCast(object);
}

constexpr unsigned char ghostPoint = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
constexpr unsigned char ghostCell =
  vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;

bool HasAny(vtkUnsignedCharArray* ghosts, unsigned char mask)
{
  return ghosts &&
    std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(0) + ghosts->GetNumberOfValues(),
      [mask](unsigned char ghost) { return (ghost & mask) != 0; });
}

// Bits of the cells that use a point.
enum Users : unsigned char
{
  USED_BY_GHOST = 1,
  USED_BY_CELL = 2
};

std::vector<unsigned char> UsersOf(vtkDataSet* data, vtkUnsignedCharArray* ghosts)
{
  std::vector<unsigned char> users(data->GetNumberOfPoints(), 0);
  vtkNew<vtkIdList> first;
  data->GetCellPoints(0, first); // builds what the threads need
  parallel::ForChunks(data->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        data->GetCellPoints(cell, ids);
        const unsigned char user = (ghosts->GetValue(cell) & ghostCell) ? USED_BY_GHOST : USED_BY_CELL;
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
        {
          std::atomic_ref<unsigned char>(users[ids->GetId(i)]).fetch_or(user, std::memory_order_relaxed);
        }
      }
    });
  return users;
}

// vtkRemoveGhosts would copy the data set, drop no hidden points and lose the ids of the others.
void DropGhosts(Leaf& leaf)
{
  vtkDataSet* data = leaf.Data;
  vtkUnsignedCharArray* pointGhosts = data->GetPointGhostArray();
  vtkUnsignedCharArray* cellGhosts = data->GetCellGhostArray();
  const bool ghostPoints = HasAny(pointGhosts, ghostPoint);
  const bool ghostCells = HasAny(cellGhosts, ghostCell);
  if (!ghostPoints && !ghostCells)
  {
    return;
  }
  // A point goes when it is a ghost itself, or when all the cells that use it (and there are some) are.
  std::vector<unsigned char> users;
  if (ghostCells)
  {
    users = UsersOf(data, cellGhosts);
  }
  leaf.All = false;
  leaf.Points = parallel::Select(data->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      const bool ghost =
        (ghostPoints && (pointGhosts->GetValue(i) & ghostPoint)) || (ghostCells && users[i] == USED_BY_GHOST);
      return !ghost;
    });
}

// Extent of structured data; false: the data are not structured.
bool ExtentOf(vtkDataSet* data, int extent[6])
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetExtent(extent);
    return true;
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetExtent(extent);
    return true;
  }
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
  {
    curvilinear->GetExtent(extent);
    return true;
  }
  return false;
}

// Neighboring pieces of a structured data set both have the points between them: they belong to the lower piece.
void DropSharedFaces(Leaf& leaf, const int wholeExtent[6])
{
  int extent[6];
  if (!ExtentOf(leaf.Data, extent) || leaf.Data->GetPointGhostArray())
  {
    return; // ghosts already say whose the points are
  }
  int first[3];
  bool shared = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inside = extent[2 * axis] > wholeExtent[2 * axis] && extent[2 * axis + 1] <= wholeExtent[2 * axis + 1];
    first[axis] = extent[2 * axis] + (inside ? 1 : 0);
    shared |= inside;
  }
  if (!shared)
  {
    return;
  }
  const auto isOwn = [&](vtkIdType i)
  {
    int ijk[3];
    vtkStructuredData::ComputePointStructuredCoordsForExtent(leaf.Point(i), extent, ijk);
    return ijk[0] >= first[0] && ijk[1] >= first[1] && ijk[2] >= first[2];
  };
  std::vector<vtkIdType> own = parallel::Select(leaf.Count(), isOwn);
  if (!leaf.All)
  {
    std::transform(own.begin(), own.end(), own.begin(), [&leaf](vtkIdType i) { return leaf.Points[i]; });
  }
  leaf.All = false;
  leaf.Points = std::move(own);
}

// Whether cell i of vertices of one point each is that of point i.
struct AreInOrder
{
  template <class Array>
  void operator()(Array* points, std::atomic<bool>& inOrder) const
  {
    const auto range = vtk::DataArrayValueRange<1>(points);
    parallel::ForChunks(points->GetNumberOfValues(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          if (static_cast<vtkIdType>(range[i]) != i)
          {
            inOrder = false;
            return;
          }
        }
      });
  }
};

// The one cell of each point, where every cell is a single vertex of its own; as in particle files.
void FindVertexCells(Leaf& leaf)
{
  vtkCellArray* vertices = nullptr;
  if (auto* poly = vtkPolyData::SafeDownCast(leaf.Data))
  {
    vertices = poly->GetNumberOfVerts() == poly->GetNumberOfCells() ? poly->GetVerts() : nullptr;
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
  {
    vertices = grid->GetCells();
  }
  const vtkIdType count = leaf.Data->GetNumberOfPoints();
  if (!vertices || leaf.CellCenters || vertices->GetNumberOfCells() != count || vertices->IsHomogeneous() != 1)
  {
    return;
  }
  vtkDataArray* const points = vertices->GetConnectivityArray();
  std::atomic<bool> inOrder{ true };
  AreInOrder check;
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(points, check, inOrder))
  {
    check(points, inOrder);
  }
  if (!inOrder)
  {
    std::vector<vtkIdType> cells(count, -1);
    vtkIdType cell = 0;
    for (const auto point : vtk::DataArrayValueRange<1>(points))
    {
      cells[static_cast<vtkIdType>(point)] = cell++;
    }
    if (std::find(cells.begin(), cells.end(), -1) != cells.end())
    {
      return;
    }
    leaf.CellOfPoint = std::move(cells);
  }
  leaf.Vertices = vertices;
}

std::vector<Leaf> Leaves(vtkDataObject* input)
{
  std::vector<Leaf> leaves;
  const auto add = [&](vtkDataObject* object, unsigned int block, unsigned int flatIndex)
  {
    Leaf leaf;
    leaf.Block = block;
    leaf.Data = AsDataSet(object);
    leaf.CellCenters = leaf.Data != object;
    leaf.FlatIndex = flatIndex;
    if (leaf.Data && leaf.Data->GetNumberOfPoints() > 0)
    {
      DropGhosts(leaf);
      FindVertexCells(leaf);
      leaves.push_back(std::move(leaf));
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    add(input, 0, 0);
    return leaves;
  }
  unsigned int block = 0;
  for (auto node : vtk::Range(composite)) // an empty block has a number, too
  {
    if (node.GetDataObject())
    {
      add(node.GetDataObject(), block, node.GetFlatIndex());
    }
    ++block;
  }
  return leaves;
}

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
    const bool exact = all.IsExact(item);
    if (!exact && !vtkDataArray::SafeDownCast(item.First))
    {
      continue; // there is no text that stands for a hole
    }
    vtkSmartPointer<vtkAbstractArray> array = item.Make(count, exact);
    vtkIdType next = 0;
    for (const Leaf& leaf : leaves)
    {
      if (vtkAbstractArray* from = item.Of(AttributesOf(leaf, cells)))
      {
        CopyLeaf(from, array, leaf, cells, next);
      }
      else
      {
        auto* numbers = vtkDoubleArray::SafeDownCast(array);
        const int components = numbers->GetNumberOfComponents();
        std::fill_n(numbers->GetPointer(next * components), leaf.Count() * components, vtkMath::Nan());
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
  const bool identity = leaves.size() == 1 && leaves.front().All && processes == 1;
  if (!identity)
  {
    AddIds<vtkIdTypeArray>(
      out, vtkRayTracedArrays::PointIds, leaves, [](const Leaf& leaf, vtkIdType i) { return leaf.Point(i); });
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
vtkSmartPointer<vtkPolyData> vtkGlyphPointGatherer::Gather(vtkDataObject* input, int processId, int processes,
  const int* wholeExtent, const vtkRayTracedParallel::Progress& progress)
{
  auto out = vtkSmartPointer<vtkPolyData>::New();
  if (!input)
  {
    return out;
  }
  std::vector<Leaf> leaves = Leaves(input);
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite && !leaves.empty() && processes > 1 && wholeExtent)
  {
    DropSharedFaces(leaves.front(), wholeExtent);
  }
  const vtkIdType count = std::accumulate(
    leaves.begin(), leaves.end(), vtkIdType(0), [](vtkIdType sum, const Leaf& leaf) { return sum + leaf.Count(); });

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
    AddPickingIds(leaves, composite != nullptr, processId, processes, out);
  }
  if (composite)
  {
    AddHierarchy(composite, out);
  }
  // Filters that redistribute between ranks, and cell data, need a cell for each point.
  if (processes > 1 || out->GetCellData()->GetNumberOfArrays() > 0)
  {
    out->SetVerts(sharesCells ? vtkSmartPointer<vtkCellArray>(whole->Vertices) : MakeVertices(count));
  }
  return out;
}

//----------------------------------------------------------------------------
void vtkGlyphPointGatherer::NumberCells(vtkHyperTreeGrid* grid)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(vtkRayTracedArrays::CellIds);
  ids->SetNumberOfTuples(grid->GetNumberOfCells());
  vtkIdType* values = ids->GetPointer(0);
  parallel::ForChunks(grid->GetNumberOfCells(),
    [values](vtkIdType begin, vtkIdType end) { std::iota(values + begin, values + end, begin); });
  grid->GetCellData()->AddArray(ids);
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
  out->GetFieldData()->AddArray(xml);
  out->GetFieldData()->AddArray(leaves);
}
