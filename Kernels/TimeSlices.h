// The trees of glyphs that move.
#pragma once

#include "GlyphTree.h"
#include "Glyphs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// Versions of a set's GlyphTree, one for each of 2^bits slices of the shutter's opening: a ray reads the one in whose
/// slice its time falls, where boxes are little longer than the glyphs.
///
/// Measured (Testing/Benchmarks/MotionBenchmark.cxx): a single tree over whole paths costs no more while paths are
/// shorter than a glyph, 2.5 times at 10 radii and 16 times at 50.
struct TimeSlices
{
  std::uint32_t bits = 0;
  std::vector<GlyphTreeNode> nodes; ///< slice by slice, of each as many as `axes` has
  /// Slice by slice, the place in the common order of the glyph at each place of its tree; empty: all slices have that
  /// order.
  std::vector<std::uint32_t> order;
};

/// When slices are sorted each for itself.
enum class SliceSorting
{
  WhereDecayed, ///< where the order of the middle would leave the leaves a fifth more surface than their own
  Never,
  Always
};

/// Of glyphs placed in `order`, the kd order of the middle of the opening, whose splits are `axes`; boxes are widened
/// by `pad`.
TimeSlices BuildTimeSlices(const GlyphInstances& instances, const std::vector<std::uint32_t>& order,
  std::uint32_t leafBits, const std::vector<std::uint8_t>& axes, float pad, std::uint32_t bits, SliceSorting sorting);

} // namespace rtg
