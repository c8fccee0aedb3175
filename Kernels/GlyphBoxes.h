// Boxes of glyphs, for acceleration structures.
#pragma once

#include "GlyphTree.h"
#include "Glyphs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// Boxes of the glyphs relative to instances.origin, tight but for 2e-6 of a glyph's size and the outward rounding to
/// float: of glyphs that move, of all they touch between two fractions of the shutter's opening, 0 <= first <= last
/// <= 1.
std::vector<Box> GlyphBoxes(const GlyphInstances& instances, double first = 0.0, double last = 1.0);

/// Largest TimeSliceBits().
constexpr std::uint32_t maxTimeSliceBits = 5;

/// Logarithm to base 2 of the number of slices of time in each of which the boxes' surface, with which the number of
/// rays that meet them grows, is at most half as large again as that of glyphs at rest. `bytesPerSlice` limits it.
std::uint32_t TimeSliceBits(const GlyphInstances& instances, std::size_t bytesPerSlice);

} // namespace rtg
