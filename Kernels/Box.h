#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace rtg
{

/// Half the surface of a box of that extent, to which the number of lines that meet it is in proportion (Cauchy).
template <class Vector>
typename Vector::value_type HalfSurface(const Vector& extent)
{
  return extent.x * extent.y + extent.y * extent.z + extent.z * extent.x;
}

/// An axis-aligned box, at first of nothing.
template <class Vector>
struct BoxOf
{
  Vector lower{ INFINITY };
  Vector upper{ -INFINITY };

  bool Empty() const { return this->lower.x > this->upper.x; }
  void Include(const BoxOf& other)
  {
    this->lower = glm::min(this->lower, other.lower);
    this->upper = glm::max(this->upper, other.upper);
  }
  BoxOf Widened(typename Vector::value_type by) const { return { this->lower - by, this->upper + by }; }
  /// Largest absolute coordinate.
  typename Vector::value_type Reach() const
  {
    const Vector reach = glm::max(glm::abs(this->lower), glm::abs(this->upper));
    return this->Empty() ? 0 : std::max({ reach.x, reach.y, reach.z });
  }
};
using Box = BoxOf<glm::vec3>;
using DoubleBox = BoxOf<glm::dvec3>;

/// A driver's slab test in float errs by a few ulps of the distances that it subtracts: at most 16 half-ulps of
/// `reach`, a bound of coordinates of boxes and of ray origins. Boxes that are widened by that much stay
/// conservative.
inline float SlabPadding(float reach)
{
  return std::ldexp(reach, -20);
}

} // namespace rtg
