// The arrays of a set of glyphs one after the other, by the table in Variants.h.
#pragma once

#include "Glyphs.h"
#include "HostDevice.h"

#include <cstddef>

namespace rtg
{

#define RTG_COUNT(...) +1
constexpr std::size_t glyphArrays = RTG_GLYPH_ARRAYS(RTG_COUNT);
#undef RTG_COUNT

/// Calls visit(number, bit, values, words) for each array of GlyphInstances, constant or not, and for the colors.
template <class Instances, class Colors, class Visit>
void ForEachArray(Instances& instances, Colors& colors, const Visit& visit)
{
#define RTG_VISIT(number, BIT, type, name, values, words) visit(number, device::BIT, values, words);
  RTG_GLYPH_ARRAYS(RTG_VISIT)
#undef RTG_VISIT
}

} // namespace rtg
