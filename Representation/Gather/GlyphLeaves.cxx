#include "GlyphLeaves.h"

#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkCellArray.h"
#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridCellCenters.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace
{
namespace parallel = rtglyphs::RayTracedParallel;
using Leaf = rtglyphs::GlyphLeaves::Leaf;

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

// The lowest indices of points of structured data with that extent whose cells are no ghosts.
void FindOwn(vtkDataSet* data, const int extent[6], int lowest[3])
{
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  int cells[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[axis] = std::max(1, extent[2 * axis + 1] - extent[2 * axis]);
    lowest[axis] = ghosts ? extent[2 * axis + 1] : extent[2 * axis];
  }
  vtkIdType cell = 0;
  for (int k = 0; ghosts && k < cells[2]; ++k)
  {
    for (int j = 0; j < cells[1]; ++j)
    {
      for (int i = 0; i < cells[0]; ++i, ++cell)
      {
        if ((ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) == 0)
        {
          lowest[0] = std::min(lowest[0], extent[0] + i);
          lowest[1] = std::min(lowest[1], extent[2] + j);
          lowest[2] = std::min(lowest[2], extent[4] + k);
        }
      }
    }
  }
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
  if (!vertices || vertices->GetNumberOfCells() != count || vertices->IsHomogeneous() != 1)
  {
    return;
  }
  vtkDataArray* const points = vertices->GetConnectivityArray();
  const auto isOfOtherPoint = [points](vtkIdType cell) { return points->GetComponent(cell, 0) == cell ? 0.0 : 1.0; };
  if (parallel::Largest(count, isOfOtherPoint) > 0.0)
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

// The same cells, with their numbers.
template <class Data>
vtkSmartPointer<Data> Numbered(Data* data)
{
  auto numbered = vtkSmartPointer<Data>::Take(data->NewInstance());
  numbered->ShallowCopy(data);
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(rtglyphs::RayTracedArrays::CellIds);
  rtglyphs::RayTracedArrays::Resize(ids, data->GetNumberOfCells());
  vtkIdType* values = ids->GetPointer(0);
  parallel::ForChunks(data->GetNumberOfCells(),
    [values](vtkIdType begin, vtkIdType end) { std::iota(values + begin, values + end, begin); });
  numbered->GetCellData()->AddArray(ids);
  return numbered;
}

// Points at the centers of cells of a data set or a hyper tree grid, which have the cells' arrays; without the cells
// that other ranks have or that are hidden. Coarse cells of a hyper tree grid, and empty ones, are numbered, too, but
// have no center: the arrays say which cell is which.
template <class Centers, class Data>
Leaf CentersOf(Data* data)
{
  const vtkSmartPointer<Data> numbered = Numbered(data);
  const char* ghostName = vtkDataSetAttributes::GhostArrayName();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(data->GetCellData()->GetArray(ghostName));
  numbered->GetCellData()->RemoveArray(ghostName);
  vtkNew<Centers> centers;
  centers->SetInputDataObject(numbered);
  centers->VertexCellsOn();
  centers->Update();
  Leaf leaf;
  leaf.Data = vtkDataSet::SafeDownCast(centers->GetOutputDataObject(0));
  leaf.CellIds = vtkIdTypeArray::SafeDownCast(leaf.Data->GetPointData()->GetArray(rtglyphs::RayTracedArrays::CellIds));
  vtkIdTypeArray* ids = leaf.CellIds;
  if (ids && HasAny(ghosts, ghostCell))
  {
    leaf.All = false;
    leaf.Points = parallel::Select(
      ids->GetNumberOfTuples(), [&](vtkIdType i) { return (ghosts->GetValue(ids->GetValue(i)) & ghostCell) == 0; });
  }
  return leaf;
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphLeaves::Leaf rtglyphs::GlyphLeaves::Find(vtkDataObject* object, bool cells)
{
  if (auto* grid = vtkHyperTreeGrid::SafeDownCast(object))
  {
    return CentersOf<vtkHyperTreeGridCellCenters>(grid);
  }
  auto* data = vtkDataSet::SafeDownCast(object);
  if (data && cells)
  {
    return CentersOf<vtkCellCenters>(data);
  }
  Leaf leaf;
  leaf.Data = data;
  if (data && data->GetNumberOfPoints() > 0)
  {
    DropGhosts(leaf);
    FindVertexCells(leaf);
  }
  return leaf;
}

//----------------------------------------------------------------------------
// Neighboring pieces of a structured data set both have the points between them: they belong to the lower piece.
// Ghosts, which filters that request them leave, mark those beyond, and not always these.
void rtglyphs::GlyphLeaves::DropSharedFaces(Leaf& leaf, const int wholeExtent[6])
{
  if (leaf.CellIds || leaf.Data->GetExtentType() != VTK_3D_EXTENT)
  {
    return; // no two pieces have the same cell
  }
  int extent[6];
  leaf.Data->GetInformation()->Get(vtkDataObject::DATA_EXTENT(), extent);
  int first[3];
  FindOwn(leaf.Data, extent, first);
  bool shared = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inside = first[axis] > wholeExtent[2 * axis] && extent[2 * axis + 1] <= wholeExtent[2 * axis + 1];
    first[axis] += inside ? 1 : 0;
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

//----------------------------------------------------------------------------
vtkSmartPointer<vtkHyperTreeGrid> rtglyphs::GlyphLeaves::Number(vtkHyperTreeGrid* grid)
{
  return Numbered(grid);
}
