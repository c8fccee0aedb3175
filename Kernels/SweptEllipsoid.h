// From two ellipsoids to the numbers of the one swept between them: Shapes/SweptEllipsoid.glsl.
#pragma once

#include "Tensor.h"

#include <cstddef>
#include <optional>

namespace rtg
{

struct GlyphInstances;

/// (p - middle)^T matrix^-1 (p - middle) <= 1, relative to GlyphInstances::origin.
struct SweepEnd
{
  glm::dvec3 middle{ 0.0 };
  SymmetricTensor matrix; ///< positive semidefinite; not both are zero, nor are both middles the same
};

/// Width of GlyphInstances::polynomials of pieces of lines inside which nothing is left.
constexpr std::size_t valuesOfNextSweeps = 20;

/// Stores a Shape::SweptEllipsoid as the glyph of that index, which the arrays have. A half-axis is at least the
/// fraction thinnestTensorGlyph of its ellipsoid's largest. `before` and `after`: the far ends of the pieces before
/// `first` and after `last`; they count where GlyphInstances::polynomials is there.
void StoreSweep(const SweepEnd& first, const SweepEnd& last, std::size_t index, GlyphInstances& instances,
  const std::optional<SweepEnd>& before = {}, const std::optional<SweepEnd>& after = {});

} // namespace rtg
