#include "Motion.h"

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

glm::dvec3 ValueOrZero(const std::vector<glm::vec3>& values, std::size_t glyph)
{
  return values.empty() ? glm::dvec3(0.0) : glm::dvec3(values[glyph]);
}

} // namespace

glm::dvec3 GlyphMotion::Displacement(std::size_t glyph, double time) const
{
  return ValueOrZero(this->velocities, glyph) * time + ValueOrZero(this->accelerations, glyph) * (0.5 * time * time);
}

glm::dquat GlyphMotion::RotationAt(std::size_t glyph, double time) const
{
  const glm::dvec3 rotation = time * ValueOrZero(this->angularVelocities, glyph);
  const double angle = glm::length(rotation);
  return glm::angleAxis(angle, angle > 0.0 ? rotation / angle : rotation);
}

DoubleBox RangeOfDisplacements(const GlyphMotion& motion, std::size_t glyph, double first, double last)
{
  const glm::dvec3 start = motion.Displacement(glyph, first);
  const glm::dvec3 end = motion.Displacement(glyph, last);
  DoubleBox range{ glm::min(start, end), glm::max(start, end) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double v = ValueOrZero(motion.velocities, glyph)[axis];
    const double a = ValueOrZero(motion.accelerations, glyph)[axis];
    const double turning = -v / a; // not finite, and so outside, without an apex
    if (turning > first && turning < last)
    {
      const double extreme = 0.5 * v * turning;
      range.lower[axis] = std::min(range.lower[axis], extreme);
      range.upper[axis] = std::max(range.upper[axis], extreme);
    }
  }
  return range;
}

DoubleBox PaddedRangeOfDisplacements(const GlyphMotion& motion, std::size_t glyph, double first, double last)
{
  const double time = std::max(std::abs(first), std::abs(last));
  const glm::dvec3 terms = glm::abs(ValueOrZero(motion.velocities, glyph)) * time +
    glm::abs(ValueOrZero(motion.accelerations, glyph)) * (0.5 * time * time);
  const glm::dvec3 padding = std::ldexp(1.0, -21) * terms;
  const DoubleBox range = RangeOfDisplacements(motion, glyph, first, last);
  return { range.lower - padding, range.upper + padding };
}

} // namespace rtg
