/**
 * @class   vtkGlyphPointGatherer
 * @brief   gathers the points of any data object that carry a glyph into one vtkPolyData
 *
 * Input may be any data set, hyper tree grid or composite of them; vtkGlyphLeaves says which points carry a glyph, or
 * that the centers of cells do, which have the cells' arrays. Where nothing has to be copied, points and arrays are
 * shared with the input.
 *
 * The output's point data has the union of all blocks' arrays (NaN where a block lacks one), and:
 * - what picking asks for (vtkRayTracedArrays.h): ids of points and, for cell centers and data sets made of
 * vertices, of the cells that the glyphs stand for, flat indices of blocks, ranks.
 *
 * Its cell data has the cell arrays of data sets made of vertices only, one tuple a point; cell arrays of cell centers
 * are point arrays. Its field data has, for a composite input, the hierarchy that block selectors speak about
 * (see vtkGlyphBlockAttributes).
 */
#ifndef vtkGlyphPointGatherer_h
#define vtkGlyphPointGatherer_h

#include "vtkRayTracedParallel.h"
#include "vtkSmartPointer.h"

class vtkCompositeDataSet;
class vtkDataObject;
class vtkPolyData;

class vtkGlyphPointGatherer
{
public:
  struct Options
  {
    bool CellCenters = false; // instead of points; hyper tree grids always give those
    // This process's rank among those whose points are put together for rendering.
    int ProcessId = 0, Processes = 1;
    const int* WholeExtent = nullptr; // of the structured data set of which the input is this process's piece
    vtkRayTracedParallel::Progress Progress;
  };
  static vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* input, const Options& options);

  /**
   * Adds to the field data of `out` the trees that block selectors are paths in, with the flat index of each of their
   * data sets.
   */
  static void AddHierarchy(vtkCompositeDataSet* composite, vtkPolyData* out);
};

#endif
