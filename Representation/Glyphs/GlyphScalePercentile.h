/**
 * @class   GlyphScalePercentile
 * @brief   the scale of the arrow whose fixed head has the proportions of the unit arrow
 *
 * It is the 95th percentile of the scales of all glyphs where the settings name no magnitude, so that hardly an arrow
 * has a head that is too large for it. Heads have one size on all ranks.
 */
#ifndef GlyphScalePercentile_h
#define GlyphScalePercentile_h

#include "GlyphTuples.h"
#include "RayTracedCache.h"

namespace rtglyphs
{

class GlyphScalePercentile
{
public:
  /**
   * For GlyphSettings::ScalePercentile; 0 where the settings need none. Hidden points as RayTracedBlocks
   * has them.
   * All ranks that have data call it at once; they exchange more than one number only where points, settings or visible
   * blocks of one have changed.
   */
  double Get(vtkPolyData* points, const GlyphSettings& settings, const RayTracedRanges& hidden);

private:
  RayTracedCache<GlyphArrays::Key> Known;
  double High = 1.0;
};

} // namespace rtglyphs

#endif
