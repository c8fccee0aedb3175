/**
 * @class   vtkGlyphPointGatherer
 * @brief   gathers the points of any data object that carry a glyph into one vtkPolyData
 *
 * Input may be any data set, hyper tree grid (cell centers carry the glyphs) or composite of them. Ghost points,
 * hidden points and the points that belong only to blanked cells (as under a finer AMR level) are left out; so are,
 * where a structured data set is spread over processes, points that its piece shares with a lower one. Where nothing
 * has to be copied, points and arrays are shared with the input.
 *
 * The output's point data has the union of all blocks' arrays (NaN where a block lacks one), and:
 * - what picking asks for (vtkRayTracedArrays.h): ids of points and, for hyper tree grids and data sets made of
 * vertices, of the cells that the glyphs stand for, flat indices of blocks, ranks.
 *
 * Its cell data has the cell arrays of data sets made of vertices only, one tuple a point; cell arrays of hyper tree
 * grids are point arrays. Its field data has, for a composite input, the hierarchy that block selectors speak about
 * (see vtkGlyphBlockAttributes).
 */
#ifndef vtkGlyphPointGatherer_h
#define vtkGlyphPointGatherer_h

#include "vtkRayTracedParallel.h"
#include "vtkSmartPointer.h"

class vtkCompositeDataSet;
class vtkDataObject;
class vtkHyperTreeGrid;
class vtkPolyData;

class vtkGlyphPointGatherer
{
public:
  /**
   * `processId` and `processes`: this process's rank among those whose points are put together for rendering.
   * `wholeExtent`: that of the structured data set of which the input is this process's piece; null when there is none.
   */
  static vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* input, int processId = 0, int processes = 1,
    const int* wholeExtent = nullptr, const vtkRayTracedParallel::Progress& progress = {});

  /**
   * Adds a cell array vtkRayTracedArrays::CellIds of each cell's number.
   */
  static void NumberCells(vtkHyperTreeGrid* grid);

  /**
   * Adds to the field data of `out` the tree that block selectors are paths in, with the flat index of each of its data
   * sets.
   */
  static void AddHierarchy(vtkCompositeDataSet* composite, vtkPolyData* out);
};

#endif
