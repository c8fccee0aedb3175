/**
 * @class   GlyphScaleGuess
 * @brief   the world size of a unit glyph that makes the glyphs of any data visible
 *
 * Typical glyphs are 0.9 of the usual distance between neighbors long, arrows, which are thin, 2.5 times that. The
 * distance is the median, over some of the points of all ranks, of that to the nearest point elsewhere; the search is
 * exact, however the points are spread over the ranks, and points without a glyph do not count. Data that are
 * crowded in a small part of their box, or along one direction, would show nothing, so typical glyphs are at least an
 * 80th of the data's longest side, or half of their mean spacing where that is less (all of it of few). The sides are
 * between the outer percentiles of the same points: a lost particle does not count.
 *
 * Where an array or tensors scale the glyphs, the typical one has the 95th percentile of the scales. Of stress around a
 * load, say, most would then be specks: where all glyphs together cover less than a quarter of as many typical ones,
 * they grow until they do. No glyph is larger than a fifth of the longest side. Where the largest would be up to twice
 * that, all become smaller; where it would be more, a limit holds for those few, so that an outlier neither
 * fills the view nor makes the others vanish. The limit is lower where many glyphs have it, which then cover a quarter
 * of the longest side's square.
 *
 * Spheres that an array of one component named radius or diameter scales have exactly that size, unless they are
 * specks: smaller than a 200th of the longest side and than a tenth of the distance between neighbors.
 *
 * The factor has two significant digits.
 */
#ifndef GlyphScaleGuess_h
#define GlyphScaleGuess_h

#include "GlyphKeptGuess.h"

namespace rtglyphs::GlyphScaleGuess
{
/**
 * A size for the points: as Value the factor, as Limit GlyphSizing::Most. All ranks call it at once, and all get the
 * same. `unitSize` is the length of the unit glyph.
 */
const GlyphKeptGuess::Result&
Update(GlyphKeptGuess& kept, vtkPolyData* points, const GlyphSettings& settings, double unitSize, double time);
}

#endif
