/**
 * @class   GlyphBounds
 * @brief   a box around all glyphs of a set of points
 *
 * Each glyph counts with its own size: a point whose scale is large and another one whose tensor is do not add up.
 * Boxes of rotated glyphs are those of the balls round them. All cores compute them; they are kept until data or
 * settings change.
 */
#ifndef GlyphBounds_h
#define GlyphBounds_h

#include "RayTracedRanges.h"
#include "GlyphBoxes.h"
#include "GlyphSizes.h"
#include "GlyphTuples.h"
#include "RayTracedCache.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace rtglyphs
{

/**
 * The boxes of glyphs that are not turned, relative to their points, before the actor's transform.
 */
class GlyphUnturnedBox
{
public:
  /**
   * The settings and their sizes stay the caller's.
   */
  GlyphUnturnedBox(const GlyphSettings& settings, const GlyphSizes& sizes);
  rtg::DoubleBox operator()(vtkIdType point, GlyphSizes::Tuples& tuples) const;

private:
  const GlyphSettings& Settings;
  const GlyphSizes& Sizes;
  rtg::ArrowForm Arrow;
  const bool Stretched; // along its axes the unit glyph becomes any other
  rtg::DoubleBox Unit;
  const double AnchorShift;
};

class GlyphBounds
{
public:
  /**
   * The box of glyphs of all these settings at the same points, before the actor's transform. Uninitialized when there
   * are none. Hidden points as RayTracedBlocks has them.
   */
  const double* Get(vtkPolyData* points, const std::vector<GlyphSettings>& settings, const RayTracedRanges& hidden);

  ///@{
  /**
   * How often the box was computed, and the seconds of that.
   */
  std::uint64_t GetBuilds() const { return this->Builds; }
  double GetSeconds() const { return this->Seconds; }
  ///@}

private:
  void Build(vtkPolyData* points, const std::vector<GlyphSettings>& settings, const RayTracedRanges& hidden);

  RayTracedCache<GlyphArrays::Key> Known;
  double Bounds[6];
  std::uint64_t Builds = 0;
  double Seconds = 0.0;
};

} // namespace rtglyphs

#endif
