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
class vtkPolyData;

class vtkGlyphSelection
{
public:
  /**
   * The points with an array vtkRayTracedArrays::Selected, 1 where the extracted data have the point or the cell that
   * the glyph stands for and 0 elsewhere; lines have one of their cells, too. Data of several ranks, some without a
   * selected point, are put together, so all have the array; `points` itself where `extracted` is null. Points as
   * vtkGlyphPointGatherer makes them, or lines as vtkRayTracedSurfaceGatherer does.
   */
  static vtkSmartPointer<vtkPolyData> Mark(vtkPolyData* points, vtkDataObject* extracted);
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphSelection.h
