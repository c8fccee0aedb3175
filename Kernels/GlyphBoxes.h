// Boxes of glyphs, for acceleration structures.
#pragma once

#include "Box.h"
#include "Glyphs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// Boxes of the glyphs relative to instances.origin, tight but for 2e-6 of a glyph's size and the outward rounding to
/// float: of glyphs that move, of all they touch between two fractions of the shutter's opening, 0 <= first <= last
/// <= 1.
std::vector<Box> GlyphBoxes(const GlyphInstances& instances, double first = 0.0, double last = 1.0);

/// The box of a glyph of these sizes, not turned, relative to its centre; of polynomials the largest. None of
/// Shape::Mesh.
DoubleBox GlyphExtent(Shape shape, const ArrowForm& arrow, const glm::dvec3& size);

/// ChooseSliceBits() of glyphs (TimeSlices.h).
std::uint32_t TimeSliceBits(const GlyphInstances& instances, std::size_t bytesPerSlice);

} // namespace rtg
