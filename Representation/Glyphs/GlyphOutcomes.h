/**
 * Outcomes of points: a glyph, or why they have none.
 */
#ifndef GlyphOutcomes_h
#define GlyphOutcomes_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rtglyphs
{
struct GlyphSettings;
}

namespace rtglyphs::GlyphOutcomes
{
/**
 * Zeros are ordinary: grains without stress, walls without slip.
 */
enum Outcome : unsigned char
{
  POSITION,
  MISSING_ARRAY, // in blocks that lack one of those that follow; RayTracedBlocks reports it
  SCALE,
  RADIUS,
  ORIENTATION,
  TENSOR,
  COVARIANCE,
  DIRECTION,
  EXPONENT,
  MOTION,
  FORM,
  POLYNOMIAL,
  ZERO_SCALE,
  ZERO_RADIUS,
  ZERO_ORIENTATION,
  ZERO_TENSOR,
  ZERO_POLYNOMIAL,
  REASONS,
  NOT_SHOWN = REASONS, // none of this set's, or nothing to show
  SHOWN
};

using Counts = std::array<vtkIdType, SHOWN + 1>;

/**
 * Adds what can be said of so many points to the messages, with remedies. Returns how many could not be shown.
 */
vtkIdType Describe(
  const Counts& counts, const GlyphSettings& settings, std::size_t candidates, std::vector<std::string>& messages);
}

#endif
