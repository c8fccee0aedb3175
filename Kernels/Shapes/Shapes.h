// The shapes of this folder as C++, in float and double, from the same text that the GPU runs.
// Compile with -ffp-contract=off: the compensated arithmetic needs every operation rounded once.
#pragma once

#include "../Glyphs.h"

#include <glm/glm.hpp>

#include <cmath>
#include <limits>

namespace rtg::shapes
{

using glm::clamp;
using glm::cross;
using glm::dot;
using glm::inversesqrt;
using glm::length;
using glm::max;
using glm::min;
using glm::normalize;
using std::abs;
using std::exp2;
using std::floor;
using std::ldexp;
using std::log;
using std::log2;
using std::pow;
using std::sqrt;

/// Dekker's constant 2^ceil(p / 2) + 1 for a significand of p bits.
template <class Real>
constexpr Real splitter = Real((1LL << ((std::numeric_limits<Real>::digits + 1) / 2)) + 1);

#define RTG_FN static inline
#define RTG_SHAPE Shape
#define RTG_IS(shape, number) (shape == Shape(number))
#define RTG_OUT(type) type&
#define RTG_UNROLL
#define RTG_VALUES const float*
#define RTG_VALUE(glyph, index) Real((glyph).values[index])
#define RTG_DEGREE(glyph) (glyph).degree
#define RTG_ROUNDOFF (std::numeric_limits<Real>::epsilon() / 2)
#define RTG_SPLITTER splitter<Real>
#define RTG_NEVER 1.0e30

/// GlyphRay, Glyph, IntersectGlyph, EstimateGlyph, GlyphNormal and GlyphBounds of Registry.glsl; the shape is an
/// rtg::Shape.
template <class Real>
struct Kernel
{
  using real = Real;
  using real2 = glm::vec<2, Real>;
  using real3 = glm::vec<3, Real>;
  using real4 = glm::vec<4, Real>;

#include "Registry.glsl"

  static constexpr int missed = RTG_MISSED, hit = RTG_HIT, unknown = RTG_UNKNOWN;
};

#undef RTG_FN
#undef RTG_SHAPE
#undef RTG_IS
#undef RTG_OUT
#undef RTG_UNROLL
#undef RTG_VALUES
#undef RTG_VALUE
#undef RTG_DEGREE
#undef RTG_ROUNDOFF
#undef RTG_SPLITTER
#undef RTG_NEVER

} // namespace rtg::shapes
