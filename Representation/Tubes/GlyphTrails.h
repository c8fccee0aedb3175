/**
 * Where glyphs have been, as tubes.
 *
 * A trail goes from the glyph's point through those of RayTracedArrays::Trail. At the point it is half as wide as the
 * middle one of the glyph's three extents, and its width falls with each step by the same amount, to nothing at the
 * last of GlyphSettings::TrailSteps; where there are fewer it ends round.
 */
#ifndef GlyphTrails_h
#define GlyphTrails_h

#include "GlyphSettings.h"
#include "Glyphs.h"
#include "RayTracedRanges.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

namespace rtglyphs::GlyphTrails
{
struct Result
{
  rtg::GlyphInstances Instances;
  std::vector<vtkIdType> Points;                   // of each piece
  std::vector<std::array<std::uint16_t, 2>> Steps; // its ends, by the number of steps before the one shown
};

/**
 * Hidden points as RayTracedBlocks has them; `modelToWorld` may be null.
 */
Result
Build(vtkPolyData* points, const GlyphSettings& settings, const RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld);
}

#endif
