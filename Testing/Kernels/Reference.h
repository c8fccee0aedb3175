// Ray-glyph intersection in 113-bit arithmetic by other means than Kernels/Shapes: the surface is cut into
// pieces (rectangles, and the surfaces of revolution of a profile's segments and arc), each piece is
// met on its own, and the crossings are sorted.
#pragma once

#include "Glyphs.h"
#include "Quad.h"

#include <cstdint>
#include <vector>

namespace rtg::testing
{

struct QuadVector
{
  Quad x = 0, y = 0, z = 0;
};

inline glm::dvec3 ToDouble(const QuadVector& v)
{
  return { double(v.x), double(v.y), double(v.z) };
}

/// A point where the line of a ray crosses a glyph's surface.
struct ReferenceCrossing
{
  Quad t = 0;            ///< in lengths of the direction
  QuadVector normal;     ///< outward, unit, in the world frame
  Quad edgeDistance = 0; ///< to the nearest edge or apex, in the unit form's frame
  Quad edgeSizes = 0;    ///< at most the same in the world, in glyph sizes
};

/// One glyph whose inputs, as floats, are taken as exact.
class ReferenceGlyph
{
public:
  ReferenceGlyph(const GlyphInstances& instances, std::uint32_t index);

  /// The largest full extent of the glyph along its own axes, in world units; an arrow's length counts whole.
  double Size() const { return this->size_; }
  bool IsPolynomial() const { return this->shape_ == Shape::Polynomial; }

  /// All crossings of the whole line, in order; those that coincide are one.
  /// `origin` counts from GlyphInstances::origin. `factor` makes the glyph a little larger or smaller: affine
  /// glyphs scale about their center; an arrow's radii scale and its ends move outwards by the same as
  /// its largest radius, so that a long thin arrow's head stays where it is.
  std::vector<ReferenceCrossing> Crossings(const glm::dvec3& origin, const glm::vec3& direction, double factor = 1.0);

private:
  struct UnitRay
  {
    QuadVector origin, direction;
  };
  struct ProfilePoint
  {
    Quad h, r;
  };

  /// The part between two heights of a ball on the axis.
  struct Ball
  {
    Quad center, radius, from, to;
  };

  using Rotation = Quad[3][3];
  static void MakeRotation(const glm::vec4& quaternion, Rotation& rotation);
  static QuadVector Turned(const Rotation& rotation, const QuadVector& v, bool toWorld);
  void MakeArrow(Quad factor);
  void MakeRoundCone(const glm::vec3& size);
  void Add(Quad t, const QuadVector& unitNormal, Quad edgeDistance, std::vector<ReferenceCrossing>& crossings) const;
  /// Superquadrics: SuperquadricReference.cxx.
  void MeetSuperquadric(const UnitRay& ray, std::vector<ReferenceCrossing>& crossings) const;
  /// By bisection of the height: Shapes/README.md, Swept ellipsoids. `side`: -1 where the line enters, 1 where it
  /// leaves.
  void MeetSweep(const UnitRay& ray, int side, std::vector<ReferenceCrossing>& crossings) const;
  void MeetRectangles(const UnitRay& ray, std::vector<ReferenceCrossing>& crossings) const;
  void MeetBall(const UnitRay& ray, const Ball& ball, std::vector<ReferenceCrossing>& crossings) const;
  void MeetAnnulus(const UnitRay& ray, ProfilePoint a, ProfilePoint b, std::vector<ReferenceCrossing>& crossings) const;
  void MeetFrustum(const UnitRay& ray, ProfilePoint a, ProfilePoint b, bool smoothStart, bool smoothEnd,
    std::vector<ReferenceCrossing>& crossings) const;

  Shape shape_;
  QuadVector center_;
  QuadVector scale_; ///< world size of the unit frame's unit
  ArrowForm arrow_;
  QuadVector exponents_; ///< of superquadrics
  std::vector<Quad> polynomial_;
  int degree_ = 0;       ///< of the polynomial
  Quad arrowLength_ = 0; ///< in world units
  Rotation rotation_;
  Rotation diagonal_;       ///< of a swept ellipsoid, whose matrices are diagonal in that frame
  QuadVector shear_, half_; ///< from that of the unit ball half-way
  Quad halfWay_ = 0;
  /// Round shapes: the outline in the half plane of the axis (x here) and the distance from it.
  std::vector<ProfilePoint> profile_;
  bool smoothStart_ = false, smoothEnd_ = false; ///< the first, the last segment runs tangentially into a ball
  std::vector<Ball> balls_;
  double size_ = 0.0;
};

} // namespace rtg::testing
