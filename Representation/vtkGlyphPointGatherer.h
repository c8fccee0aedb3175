/**
 * @class   vtkGlyphPointGatherer
 * @brief   gathers the points of any data object that carry a glyph into one vtkPolyData
 *
 * Input may be any data set, hyper tree grid (cell centres carry the glyphs) or composite of them. Ghost points,
 * hidden points and the points that belong only to blanked cells (as under a finer AMR level) are left out; so are,
 * where a structured data set is spread over processes, points that its piece shares with a lower one. Where nothing
 * has to be copied, points and arrays are shared with the input.
 *
 * The output's point data has the union of all blocks' arrays (NaN where a block lacks one), and:
 * - `vtkOriginalPointIds`, `vtkCompositeIndex` (flat index of the block), `vtkProcessId` for picking. The first and
 *   the last are missing where they would be the identity and this only process, the second for a single data set.
 *
 * Its cell data has the cell arrays of data sets made of vertices only, one tuple a point. Its field data has, for a
 * composite input, the hierarchy that block selectors speak about (see vtkGlyphBlockAttributes).
 */
#ifndef vtkGlyphPointGatherer_h
#define vtkGlyphPointGatherer_h

#include "vtkSmartPointer.h"

class vtkCompositeDataSet;
class vtkDataObject;
class vtkPolyData;

class vtkGlyphPointGatherer
{
public:
  /**
   * `processId` and `processes`: this process's rank among those whose points are put together for rendering.
   * `wholeExtent`: that of the structured data set of which the input is this process's piece; null when there is none.
   */
  static vtkSmartPointer<vtkPolyData> Gather(
    vtkDataObject* input, int processId = 0, int processes = 1, const int* wholeExtent = nullptr);

  /**
   * Adds to the field data of `out` the tree that block selectors are paths in, with the flat index of each of its data
   * sets.
   */
  static void AddHierarchy(vtkCompositeDataSet* composite, vtkPolyData* out);

  ///@{
  /**
   * Names of the arrays that Gather() adds. Leaves holds pairs (flat index, data set index in the hierarchy).
   */
  static const char* PointIdsName() { return "vtkOriginalPointIds"; }
  static const char* CompositeIndexName() { return "vtkCompositeIndex"; }
  static const char* ProcessIdName() { return "vtkProcessId"; }
  static const char* HierarchyName() { return "RayTracedGlyphsHierarchy"; }
  static const char* LeavesName() { return "RayTracedGlyphsLeaves"; }
  ///@}
};

#endif
