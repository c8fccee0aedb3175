/**
 * @class   vtkGlyphHighScale
 * @brief   the scale of the arrow whose fixed head has the proportions of the unit arrow
 *
 * It is the 95 % quantile of the scales of all glyphs where the settings name no magnitude, so that hardly an arrow has
 * a head that is too large for it. Heads have one size on all ranks.
 */
#ifndef vtkGlyphHighScale_h
#define vtkGlyphHighScale_h

#include "vtkGlyphTuples.h"
#include "vtkRayTracedCache.h"

class vtkGlyphHighScale
{
public:
  /**
   * For vtkGlyphSettings::HighScale; 0 where the settings need none. Blocks as vtkRayTracedBlocks::GetTable() has them.
   * All ranks that have data call it at once; they exchange more than one number only where points, settings or visible
   * blocks of one have changed.
   */
  double Get(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks);

private:
  vtkRayTracedCache<vtkGlyphArrays::Key> Known;
  double High = 1.0;
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphHighScale.h
