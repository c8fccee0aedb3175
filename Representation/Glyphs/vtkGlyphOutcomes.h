/**
 * What becomes of points: a glyph, or why they have none.
 */
#ifndef vtkGlyphOutcomes_h
#define vtkGlyphOutcomes_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

struct vtkGlyphSettings;

namespace vtkGlyphOutcomes
{
/**
 * Zeros are ordinary: grains without stress, walls without slip.
 */
enum Outcome : unsigned char
{
  POSITION,
  SCALE,
  RADIUS,
  ORIENTATION,
  TENSOR,
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
  const Counts& counts, const vtkGlyphSettings& settings, std::size_t candidates, std::vector<std::string>& messages);
}

#endif
// VTK-HeaderTest-Exclude: vtkGlyphOutcomes.h
