// Numbers that glyphs may have.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace rtg
{

/// No component is infinite or NaN: differences of what is finite are zero.
template <int n, class Real>
bool IsFinite(const glm::vec<n, Real>& v)
{
  return v - v == glm::vec<n, Real>(Real(0));
}

inline bool IsFinite(const double v[3])
{
  return IsFinite(glm::dvec3(v[0], v[1], v[2]));
}

/// The same of what single precision makes of it, which the device works with.
inline bool IsFiniteInFloat(const glm::dvec3& v)
{
  return IsFinite(glm::vec3(v));
}

/// Above zero and finite, as sizes and factors must be.
inline bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

} // namespace rtg
