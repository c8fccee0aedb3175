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

#define RTG_HOST
#define RTG_FN static inline
#define RTG_FN_SHAPE                                                                                                   \
  template <int RTG_SHAPE>                                                                                             \
  static inline
#define RTG_OF_SHAPE <RTG_SHAPE>
#define RTG_OUT(type) type&
#define RTG_PRECISE
#define RTG_ROUNDOFF (std::numeric_limits<Real>::epsilon() / 2)
#define RTG_SPLITTER splitter<Real>
#define RTG_NEVER 1.0e30

/// GlyphRay, Glyph, IntersectGlyph, EstimateGlyph, GlyphNormal and GlyphBounds of Registry.glsl.
template <class Real>
struct Kernel
{
  using real = Real;
  using real2 = glm::vec<2, Real>;
  using real3 = glm::vec<3, Real>;
  using real4 = glm::vec<4, Real>;

#include "Registry.glsl"

  /// IntersectGlyph of a shape that is known at run time.
  static bool Intersect(Shape shape, const GlyphRay& ray, const Glyph& glyph, Real tMin, Real tMax, Real& t)
  {
#define RTG_CASE(number, Name)                                                                                         \
  if (shape == Shape(number))                                                                                          \
  {                                                                                                                    \
    return Intersect##Name(ray, glyph, tMin, tMax, t);                                                                 \
  }
    RTG_SHAPES(RTG_CASE)
#undef RTG_CASE
    return false;
  }

  /// EstimateGlyph of a shape that is known at run time.
  static int Estimate(Shape shape, const GlyphRay& ray, const Glyph& glyph, Real tMin, Real tMax, Real& low, Real& high)
  {
#define RTG_CASE(number, Name)                                                                                         \
  if (shape == Shape(number))                                                                                          \
  {                                                                                                                    \
    return EstimateGlyph<number>(ray, glyph, tMin, tMax, low, high);                                                   \
  }
    RTG_SHAPES(RTG_CASE)
#undef RTG_CASE
    return missed;
  }
  static constexpr int missed = RTG_MISSED, met = RTG_MET, unknown = RTG_UNKNOWN;

  /// GlyphNormal of a shape that is known at run time.
  static real3 Normal(Shape shape, const GlyphRay& ray, const Glyph& glyph, Real t)
  {
#define RTG_CASE(number, Name)                                                                                         \
  if (shape == Shape(number))                                                                                          \
  {                                                                                                                    \
    return Name##Normal(ray, glyph, t);                                                                                \
  }
    RTG_SHAPES(RTG_CASE)
#undef RTG_CASE
    return -ray.direction;
  }

  /// GlyphBounds of a shape that is known at run time.
  static void Bounds(Shape shape, const Glyph& glyph, real3& lower, real3& upper)
  {
#define RTG_CASE(number, Name)                                                                                         \
  if (shape == Shape(number))                                                                                          \
  {                                                                                                                    \
    Name##Bounds(glyph, lower, upper);                                                                                 \
  }
    RTG_SHAPES(RTG_CASE)
#undef RTG_CASE
  }
};

#undef RTG_HOST
#undef RTG_FN
#undef RTG_FN_SHAPE
#undef RTG_OF_SHAPE
#undef RTG_OUT
#undef RTG_PRECISE
#undef RTG_ROUNDOFF
#undef RTG_SPLITTER
#undef RTG_NEVER

} // namespace rtg::shapes
