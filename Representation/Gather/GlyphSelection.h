/**
 * @class   GlyphSelection
 * @brief   which glyphs ParaView's selection has chosen
 *
 * ParaView draws what is selected of a source as points, which lie inside the glyphs. Where the data are, the filter
 * that extracts them for that purpose has the ids.
 */
#ifndef GlyphSelection_h
#define GlyphSelection_h

#include "vtkSmartPointer.h"

class vtkDataObject;

namespace rtglyphs
{

class GlyphSelection
{
public:
  /**
   * The RayTracedTree `gathered` with an array RayTracedArrays::Selected of the points of each leaf, 1 where the
   * extracted data have the point or the cell that the glyph stands for and 0 elsewhere; lines have one of their cells,
   * too. Data of several ranks, some without a selected point, are put together, so all have the array; `gathered`
   * itself where `extracted` is null. Leaves as GlyphPointGatherer makes them, or lines as
   * RayTracedSurfaceGatherer does.
   */
  static vtkSmartPointer<vtkDataObject> Mark(vtkDataObject* gathered, vtkDataObject* extracted);
};

} // namespace rtglyphs

#endif
