// How glyphs move while the shutter is open, as plain host data.
#pragma once

#include "Box.h"

#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace rtg
{

/// Motion of one set's glyphs. A glyph whose center is x at time 0 is at x + v t + a t^2 / 2 at time t; an angular
/// velocity w rotates it about its center by |w| t round w's direction, after its own rotation. One light path sees the
/// whole scene at one time; times are spread evenly over the shutter's opening. Arrays that a set does not need stay
/// empty; a set without any is at rest and costs nothing.
struct GlyphMotion
{
  std::vector<glm::vec3> velocities;        ///< world units per time, one a glyph
  std::vector<glm::vec3> accelerations;     ///< world units per time squared, one a glyph
  std::vector<glm::vec3> angularVelocities; ///< radians per time, world frame, one a glyph
  /// When the shutter opens and closes, relative to the time of the centers: open < close, both finite.
  float shutterOpen = -0.5f;
  float shutterClose = 0.5f;

  bool Moves() const { return !this->velocities.empty() || !this->accelerations.empty(); }
  bool Spins() const { return !this->angularVelocities.empty(); }
  bool Any() const { return this->Moves() || this->Spins(); }
  /// Time at a fraction of the opening in [0, 1].
  double Time(double fraction) const
  {
    return this->shutterOpen + fraction * (double(this->shutterClose) - this->shutterOpen);
  }
  ///@{
  /// Bounds of that time as programs compute it, in float: next to time zero that is off by many of its own ulps.
  double EarliestTime(double fraction) const { return this->Time(fraction) - this->ErrorOfTime(); }
  double LatestTime(double fraction) const { return this->Time(fraction) + this->ErrorOfTime(); }
  double ErrorOfTime() const
  {
    return std::ldexp(std::max(std::abs(double(this->shutterOpen)), std::abs(double(this->shutterClose))), -21);
  }
  ///@}

  /// x(t) - x(0).
  glm::dvec3 Displacement(std::size_t glyph, double time) const;
  /// Unit quaternion of the rotation since time 0.
  glm::dquat RotationAt(std::size_t glyph, double time) const;

  bool operator==(const GlyphMotion&) const = default;
};

/// All displacements between two times, first <= last: those of the ends, and of the turning points of the parabola.
DoubleBox RangeOfDisplacements(const GlyphMotion& motion, std::size_t glyph, double first, double last);
/// That range widened by the rounding of the device's arithmetic in float: a few ulps of its terms.
DoubleBox PaddedRangeOfDisplacements(const GlyphMotion& motion, std::size_t glyph, double first, double last);

} // namespace rtg
