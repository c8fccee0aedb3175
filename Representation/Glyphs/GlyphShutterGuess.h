/**
 * @class   GlyphShutterGuess
 * @brief   the shutter time that makes motion blur of any data visible
 *
 * Of the points that move, the one with the 95th percentile of the speeds makes a streak three typical glyphs long, or
 * a twentieth of the data's longest side where what moves has no size, as surfaces. The fastest goes no farther than
 * half that side, or three such glyphs where these are longer, so that an outlier does not make the others vanish.
 * Where nothing but an angular velocity is known, the rotation of that percentile is one radian.
 *
 * It has two significant digits.
 */
#ifndef GlyphShutterGuess_h
#define GlyphShutterGuess_h

#include "GlyphKeptGuess.h"

namespace rtglyphs::GlyphShutterGuess
{
/**
 * A shutter time for glyphs of the points; all ranks call it at once, and all get the same. `unitSize` is the length of
 * the unit glyph. 0: nothing moves yet.
 */
double Update(GlyphKeptGuess& kept, vtkPolyData* points, const GlyphSettings& settings, double unitSize, double time);
}

#endif
