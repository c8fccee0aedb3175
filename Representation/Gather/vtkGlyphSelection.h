/**
 * @class   vtkGlyphSelection
 * @brief   which glyphs ParaView's selection has chosen
 *
 * ParaView draws what is selected of a source as points, which lie inside the glyphs. Where the data are, the filter
 * that extracts them for that purpose tells the ids.
 */
#ifndef vtkGlyphSelection_h
#define vtkGlyphSelection_h

#include "vtkSmartPointer.h"

class vtkDataObject;

class vtkGlyphSelection
{
public:
  /**
   * The vtkRayTracedTree `gathered` with an array vtkRayTracedArrays::Selected of the points of each leaf, 1 where the
   * extracted data have the point or the cell that the glyph stands for and 0 elsewhere; lines have one of their cells,
   * too. Data of several ranks, some without a selected point, are put together, so all have the array; `gathered`
   * itself where `extracted` is null. Leaves as vtkGlyphPointGatherer makes them, or lines as
   * vtkRayTracedSurfaceGatherer does.
   */
  static vtkSmartPointer<vtkDataObject> Mark(vtkDataObject* gathered, vtkDataObject* extracted);
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphSelection.h
