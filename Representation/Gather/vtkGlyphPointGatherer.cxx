#include "vtkGlyphPointGatherer.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkDataObjectTreeIterator.h"
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
#include "vtkRayTracedArrays.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace
{
// One data set of the input and the points of it that carry glyphs.
struct Leaf
{
  vtkSmartPointer<vtkDataSet> Data;
  unsigned int FlatIndex = 0;
  unsigned int Block = 0; // number among the blocks of the input
  bool All = true;               // every point carries a glyph; Points is empty then
  std::vector<vtkIdType> Points; // otherwise these
  std::vector<vtkIdType>
    VertexCells; // per point of Data its only cell, where Data consists of vertices
  bool CellCenters = false; // points of Data are the centers of the input's cells, and their arrays say of which
  vtkIdType Count() const
  {
    return this->All ? this->Data->GetNumberOfPoints()
                     : static_cast<vtkIdType>(this->Points.size());
  }
  // The cell that a point's glyph stands for; -1: none.
  bool HasCells() const { return !this->VertexCells.empty(); }
  vtkIdType CellOf(vtkIdType point) const
  {
    return this->VertexCells.empty() ? -1 : this->VertexCells[point];
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

void DropGhosts(Leaf& leaf)
{
  vtkDataSet* data = leaf.Data;
  const vtkIdType count = data->GetNumberOfPoints();
  constexpr unsigned char noPoint =
    vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  constexpr unsigned char noCell = vtkDataSetAttributes::DUPLICATECELL |
    vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;

  vtkUnsignedCharArray* pointGhosts = data->GetPointGhostArray();
  vtkUnsignedCharArray* cellGhosts = data->GetCellGhostArray();
  const auto any = [](vtkUnsignedCharArray* ghosts, unsigned char mask)
  {
    for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfValues(); ++i)
    {
      if (ghosts->GetValue(i) & mask)
      {
        return true;
      }
    }
    return false;
  };
  const bool ghostPoints = any(pointGhosts, noPoint);
  const bool ghostCells = any(cellGhosts, noCell);
  if (!ghostPoints && !ghostCells)
  {
    return;
  }

  // A point goes when it is a ghost itself, or when all the cells that use it (and there are some) are.
  std::vector<unsigned char> usedByGhost, usedByCell;
  if (ghostCells)
  {
    usedByGhost.assign(count, 0);
    usedByCell.assign(count, 0);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      data->GetCellPoints(cell, ids);
      auto& used = (cellGhosts->GetValue(cell) & noCell) ? usedByGhost : usedByCell;
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        used[ids->GetId(i)] = 1;
      }
    }
  }
  leaf.All = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool ghost = (ghostPoints && (pointGhosts->GetValue(i) & noPoint)) ||
      (ghostCells && usedByGhost[i] && !usedByCell[i]);
    if (!ghost)
    {
      leaf.Points.push_back(i);
    }
  }
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

// Neighbouring pieces of a structured data set both have the points between them: they belong to the lower piece.
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
    const bool inside =
      extent[2 * axis] > wholeExtent[2 * axis] && extent[2 * axis + 1] <= wholeExtent[2 * axis + 1];
    first[axis] = extent[2 * axis] + (inside ? 1 : 0);
    shared |= inside;
  }
  if (!shared)
  {
    return;
  }
  const auto isShared = [&](vtkIdType point)
  {
    int ijk[3];
    vtkStructuredData::ComputePointStructuredCoordsForExtent(point, extent, ijk);
    return ijk[0] < first[0] || ijk[1] < first[1] || ijk[2] < first[2];
  };
  std::vector<vtkIdType> own;
  for (vtkIdType i = 0; i < leaf.Count(); ++i)
  {
    const vtkIdType point = leaf.All ? i : leaf.Points[i];
    if (!isShared(point))
    {
      own.push_back(point);
    }
  }
  leaf.All = false;
  leaf.Points = std::move(own);
}

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
  std::vector<vtkIdType> cells(count, -1);
  vtkIdType cell = 0;
  vtkDataArray* const connectivity = vertices->GetConnectivityArray();
  for (const auto point : vtk::DataArrayValueRange<1>(connectivity))
  {
    cells[static_cast<vtkIdType>(point)] = cell++;
  }
  if (std::find(cells.begin(), cells.end(), -1) == cells.end())
  {
    leaf.VertexCells = std::move(cells);
  }
}

std::vector<Leaf> Leaves(vtkDataObject* input)
{
  std::vector<Leaf> leaves;
  unsigned int block = 0;
  const auto add = [&](vtkDataObject* object, unsigned int flatIndex)
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
    add(input, 0);
    return leaves;
  }
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  iterator->SkipEmptyNodesOff(); // an empty block has a number, too
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem(), ++block)
  {
    if (vtkDataObject* data = iterator->GetCurrentDataObject())
    {
      add(data, iterator->GetCurrentFlatIndex());
    }
  }
  return leaves;
}

vtkDataSetAttributes* AttributesOf(const Leaf& leaf, bool cells)
{
  if (cells)
  {
    return leaf.VertexCells.empty() ? nullptr : leaf.Data->GetCellData();
  }
  return leaf.Data->GetPointData();
}

// Appends the union of all leaves' arrays to `out`, in the order of the leaves' points.
void AppendArrays(
  const std::vector<Leaf>& leaves, vtkIdType count, bool cells, vtkDataSetAttributes* out)
{
  struct Source
  {
    vtkAbstractArray* First = nullptr;
    std::size_t Leaves = 0;
    bool SameType = true;
  };
  std::map<std::string, Source> sources;
  for (const Leaf& leaf : leaves)
  {
    vtkDataSetAttributes* attributes = AttributesOf(leaf, cells);
    for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      if (!array->GetName() ||
        vtkDataSetAttributes::GhostArrayName() == std::string(array->GetName()))
      {
        continue;
      }
      Source& source = sources[array->GetName()];
      source.First = source.First ? source.First : array;
      source.SameType &= source.First->GetDataType() == array->GetDataType();
      // Arrays of one name and different lengths of tuple are different things: the first kind wins.
      source.Leaves += source.First->GetNumberOfComponents() == array->GetNumberOfComponents();
    }
  }

  for (const auto& item : sources)
  {
    const Source& source = item.second;
    const bool numeric = vtkDataArray::SafeDownCast(source.First) != nullptr;
    const bool exact = source.Leaves == leaves.size() && source.SameType;
    if (!exact && !numeric)
    {
      continue;
    }
    // A hole becomes NaN, which colour maps know; integer types have none.
    vtkSmartPointer<vtkAbstractArray> array = exact
      ? vtkSmartPointer<vtkAbstractArray>::Take(source.First->NewInstance())
      : vtkSmartPointer<vtkAbstractArray>(vtkSmartPointer<vtkDoubleArray>::New());
    const int components = source.First->GetNumberOfComponents();
    array->SetName(item.first.c_str());
    array->SetNumberOfComponents(components);
    for (int c = 0; c < components; ++c)
    {
      array->SetComponentName(c, source.First->GetComponentName(c));
    }
    array->SetNumberOfTuples(count);

    vtkIdType next = 0;
    for (const Leaf& leaf : leaves)
    {
      const vtkIdType leafCount = leaf.Count();
      vtkDataSetAttributes* attributes = AttributesOf(leaf, cells);
      vtkAbstractArray* from =
        attributes ? attributes->GetAbstractArray(item.first.c_str()) : nullptr;
      if (from && from->GetNumberOfComponents() != components)
      {
        from = nullptr;
      }
      if (from && leaf.All && !cells)
      {
        array->InsertTuples(next, leafCount, 0, from);
        next += leafCount;
        continue;
      }
      for (vtkIdType i = 0; i < leafCount; ++i, ++next)
      {
        const vtkIdType point = leaf.All ? i : leaf.Points[i];
        if (from)
        {
          array->SetTuple(next, cells ? leaf.VertexCells[point] : point, from);
        }
        else
        {
          for (int c = 0; c < components; ++c)
          {
            vtkDataArray::SafeDownCast(array)->SetComponent(next, c, vtkMath::Nan());
          }
        }
      }
    }
    out->AddArray(array);
  }
}

void AppendPoints(const std::vector<Leaf>& leaves, vtkIdType count, vtkPolyData* out)
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
    const vtkIdType leafCount = leaf.Count();
    for (vtkIdType i = 0; i < leafCount; ++i, ++next)
    {
      double x[3];
      leaf.Data->GetPoint(leaf.All ? i : leaf.Points[i], x);
      points->SetPoint(next, x);
    }
  }
  out->SetPoints(points);
}

template <typename ArrayType, typename Value>
void AddIds(vtkPolyData* out, const char* name, vtkIdType count, Value value)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, value(i));
  }
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  out->GetPointData()->AddArray(array);
}

void AddPickingIds(
  const std::vector<Leaf>& leaves, bool composite, int processId, int processes, vtkPolyData* out)
{
  const vtkIdType count = out->GetNumberOfPoints();
  const bool identity = leaves.size() == 1 && leaves.front().All && processes == 1;
  if (!identity)
  {
    std::vector<vtkIdType> ids;
    ids.reserve(count);
    for (const Leaf& leaf : leaves)
    {
      for (vtkIdType i = 0; i < leaf.Count(); ++i)
      {
        ids.push_back(leaf.All ? i : leaf.Points[i]);
      }
    }
    AddIds<vtkIdTypeArray>(
      out, vtkRayTracedArrays::PointIds, count, [&ids](vtkIdType i) { return ids[i]; });
  }
  if (std::any_of(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return leaf.HasCells(); }))
  {
    std::vector<vtkIdType> cells;
    cells.reserve(count);
    for (const Leaf& leaf : leaves)
    {
      for (vtkIdType i = 0; i < leaf.Count(); ++i)
      {
        cells.push_back(leaf.CellOf(leaf.All ? i : leaf.Points[i]));
      }
    }
    AddIds<vtkIdTypeArray>(
      out, vtkRayTracedArrays::CellIds, count, [&cells](vtkIdType i) { return cells[i]; });
  }
  if (composite)
  {
    std::vector<unsigned int> flat;
    flat.reserve(count);
    for (const Leaf& leaf : leaves)
    {
      flat.insert(flat.end(), leaf.Count(), leaf.FlatIndex);
    }
    AddIds<vtkUnsignedIntArray>(out, vtkRayTracedArrays::CompositeIndex, count,
      [&flat](vtkIdType i) { return flat[i]; });
    flat.clear();
    for (const Leaf& leaf : leaves)
    {
      flat.insert(flat.end(), leaf.Count(), leaf.Block % vtkRayTracedArrays::DistinctBlockColors);
    }
    AddIds<vtkUnsignedIntArray>(out, vtkRayTracedArrays::BlockColors, count,
      [&flat](vtkIdType i) { return flat[i]; });
  }
  if (processes > 1)
  {
    AddIds<vtkUnsignedIntArray>(out, vtkRayTracedArrays::ProcessId, count,
      [processId](vtkIdType) { return static_cast<unsigned int>(processId); });
  }
}

void AddVertices(vtkPolyData* out)
{
  const vtkIdType count = out->GetNumberOfPoints();
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  out->SetVerts(vertices);
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkGlyphPointGatherer::Gather(
  vtkDataObject* input, int processId, int processes, const int* wholeExtent)
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
  const vtkIdType count = std::accumulate(leaves.begin(), leaves.end(), vtkIdType(0),
    [](vtkIdType sum, const Leaf& leaf) { return sum + leaf.Count(); });

  auto* single = leaves.size() == 1 && leaves.front().All
    ? vtkPointSet::SafeDownCast(leaves.front().Data)
    : nullptr;
  if (single)
  {
    out->SetPoints(single->GetPoints());
    out->GetPointData()->ShallowCopy(single->GetPointData());
  }
  else if (count > 0)
  {
    AppendPoints(leaves, count, out);
    AppendArrays(leaves, count, false, out->GetPointData());
    // Which array the global ids are must not get lost.
    if (vtkDataArray* ids = leaves.front().Data->GetPointData()->GetGlobalIds())
    {
      out->GetPointData()->SetActiveGlobalIds(ids->GetName());
    }
  }
  if (count > 0)
  {
    AppendArrays(leaves, count, true, out->GetCellData());
    AddPickingIds(leaves, composite != nullptr, processId, processes, out);
  }
  if (composite)
  {
    AddHierarchy(composite, out);
  }
  // Filters that redistribute between ranks, and cell data, need a cell for each point.
  if (processes > 1 || out->GetCellData()->GetNumberOfArrays() > 0)
  {
    AddVertices(out);
  }
  return out;
}

//----------------------------------------------------------------------------
void vtkGlyphPointGatherer::NumberCells(vtkHyperTreeGrid* grid)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(vtkRayTracedArrays::CellIds);
  ids->SetNumberOfTuples(grid->GetNumberOfCells());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetValue(i, i);
  }
  grid->GetCellData()->AddArray(ids);
}

//----------------------------------------------------------------------------
// Small, and so delivered with the points to wherever they are rendered.
void vtkGlyphPointGatherer::AddHierarchy(vtkCompositeDataSet* composite, vtkPolyData* out)
{
  vtkNew<vtkDataAssembly> hierarchy;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  if (!vtkDataAssemblyUtilities::GenerateHierarchy(composite, hierarchy, collection) ||
    !collection->GetDataAssembly())
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
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const auto found = dataSetIndex.find(iterator->GetCurrentDataObject());
    if (found != dataSetIndex.end())
    {
      const unsigned int pair[2] = { iterator->GetCurrentFlatIndex(), found->second };
      leaves->InsertNextTypedTuple(pair);
    }
  }
  vtkNew<vtkStringArray> xml;
  xml->SetName(vtkRayTracedArrays::Hierarchy);
  xml->InsertNextValue(collection->GetDataAssembly()->SerializeToXML(vtkIndent()));
  out->GetFieldData()->AddArray(xml);
  out->GetFieldData()->AddArray(leaves);
}
