/**
 * Which points of a data set carry a glyph: all but ghost points, hidden points and
 * those that belong only to blanked cells (as under a finer AMR level); or instead of the points the centers of the
 * cells.
 */
#ifndef GlyphLeaves_h
#define GlyphLeaves_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCellArray;
class vtkDataObject;
class vtkHyperTreeGrid;
class vtkIdTypeArray;

namespace rtglyphs::GlyphLeaves
{
// One data set of the input and the points of it that carry glyphs.
struct Leaf
{
  vtkSmartPointer<vtkDataSet> Data;
  bool All = true;               // every point carries a glyph; Points is empty then
  std::vector<vtkIdType> Points; // otherwise these
  // Where Data consists of vertices of one point each, and each point has one: these.
  vtkCellArray* Vertices = nullptr;
  std::vector<vtkIdType> CellOfPoint; // empty where the cell of point i is i
  vtkIdTypeArray* CellIds = nullptr;  // where points of Data are the centers of the input's cells: of which

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

/**
 * A data set, or hyper tree grid, and the points of it that carry glyphs. `cells`: glyphs stand at the centers of
 * cells; those of hyper tree grids always do. Without Data where it is neither.
 */
Leaf Find(vtkDataObject* object, bool cells);

/**
 * Of structured data that are spread over processes, as a piece of `wholeExtent`: leaves out the points that a lower
 * piece has, too.
 */
void DropSharedFaces(Leaf& leaf, const int wholeExtent[6]);

/**
 * The same grid with a cell array RayTracedArrays::CellIds of each cell's number.
 */
vtkSmartPointer<vtkHyperTreeGrid> Number(vtkHyperTreeGrid* grid);
}

#endif
