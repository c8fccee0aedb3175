// From two ellipsoids to the numbers of the one swept between them: Shapes/SweptEllipsoid.glsl.
#pragma once

#include "Tensor.h"

namespace rtg
{

struct GlyphInstances;

/// (p - middle)^T matrix^-1 (p - middle) <= 1, relative to GlyphInstances::origin.
struct SweepEnd
{
  glm::dvec3 middle{ 0.0 };
  SymmetricTensor matrix; ///< positive semidefinite; not both are zero, nor are both middles the same
};

/// Stores a Shape::SweptEllipsoid as the glyph of that index, which the arrays have. A half-axis is at least the
/// fraction thinnestTensorGlyph of its ellipsoid's largest.
void StoreSweep(const SweepEnd& first, const SweepEnd& last, std::size_t index, GlyphInstances& instances);

} // namespace rtg
