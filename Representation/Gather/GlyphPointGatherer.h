/**
 * The points of a data set that carry a glyph, as poly data.
 *
 * Input may be any data set or hyper tree grid, one leaf of RayTracedTree; GlyphLeaves says which points carry a
 * glyph, or that the centers of cells do, which have the cells' arrays. Where nothing has to be copied, points and
 * arrays are shared with the input.
 *
 * The output's point data has the input's arrays, and the arrays for picking (RayTracedArrays.h): ids of points and,
 * for cell centers and data sets made of vertices, of the cells that the glyphs stand for, and ranks.
 *
 * Its cell data has the cell arrays of data sets made of vertices only, one tuple a point; cell arrays of cell centers
 * are point arrays. Its field data are the input's.
 */
#ifndef GlyphPointGatherer_h
#define GlyphPointGatherer_h

#include "RayTracedParallel.h"
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

namespace rtglyphs::GlyphPointGatherer
{
/**
 * `cellCenters`: instead of points; hyper tree grids always give those. `isBlock`: of composite data. `wholeExtent`: of
 * the structured data set of which the input is this process's piece; null: it is none.
 */
vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, bool cellCenters, bool isBlock, const int* wholeExtent,
  const RayTracedParallel::Progress& progress);
}

#endif
