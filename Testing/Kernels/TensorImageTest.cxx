// Rays at tensor glyphs, by the kernel in double: what TensorTest.cxx finds about sizes and exponents holds for what
// one sees.
#include "CaseRays.h"
#include "Shapes/Shapes.h"
#include "RandomTensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{

using namespace rtg;
using rtg::testing::Random;
using rtg::testing::TensorOf;
using rtg::testing::TimesRays;
using Kernel = shapes::Kernel<double>;

constexpr TensorGlyphKind kinds[] = { TensorGlyphKind::Ellipsoid, TensorGlyphKind::Superquadric,
  TensorGlyphKind::SignedSuperquadric };

/// A tensor's glyph as the kernel has it, of the full extents |l|.
struct Subject
{
  Shape shape;
  Kernel::Glyph glyph;

  Subject(const SymmetricTensor& tensor, TensorGlyphKind kind)
    : shape(kind == TensorGlyphKind::Ellipsoid ? Shape::Sphere : Shape::NestedSuperquadric)
    , glyph()
  {
    const TensorGlyph made = MakeTensorGlyph(Decompose(tensor), kind, 3.0);
    this->glyph.size = made.halfLengths;
    this->glyph.rotation = { made.rotation.x, made.rotation.y, made.rotation.z, made.rotation.w };
    this->glyph.rotated = true;
    this->glyph.exponents = made.exponents;
    this->glyph.unitLength = 1.0;
  }

  bool Hit(const glm::dvec3& origin, const glm::dvec3& direction, double& t) const
  {
    return Kernel::IntersectGlyph(this->shape, Ray(origin, direction), this->glyph, 0.0, 1e30, t);
  }
  double Thickness() const { return std::min({ this->glyph.size.x, this->glyph.size.y, this->glyph.size.z }); }
  /// Thinnest: as thin as glyphs of vanishing eigenvalues are made.
  bool IsThinnest() const
  {
    const glm::dvec3& size = this->glyph.size;
    return this->Thickness() <= 1.001 * thinnestTensorGlyph * std::max({ size.x, size.y, size.z });
  }
  glm::dvec3 Normal(const glm::dvec3& origin, const glm::dvec3& direction, double t) const
  {
    return Kernel::GlyphNormal(this->shape, Ray(origin, direction), this->glyph, t);
  }

  /// How far a point of another glyph's surface is from this one's at most: the least of the ways along the line
  /// through the center, along `direction`, and to the point of this surface that lies in its frame as the other does
  /// in that of `other`. A knife's edge that has turned a little is far along any fixed line.
  double Distance(const glm::dvec3& point, const glm::dvec3& direction, const Subject& other) const
  {
    double distance = glm::distance(point, this->Toward(point));
    if (distance > 1e-5)
    {
      distance = std::min(distance, glm::distance(point, this->Toward(this->Counterpart(point, other))));
    }
    double t = 0.0;
    for (const double sign : { 1.0, -1.0 })
    {
      if (distance > 1e-5 && this->Hit(point, sign * direction, t))
      {
        distance = std::min(distance, t);
      }
    }
    return distance;
  }

private:
  /// The surface's point in the direction of `point` from the center.
  glm::dvec3 Toward(const glm::dvec3& point) const
  {
    const glm::dvec3 direction = glm::normalize(point);
    double t = 0.0;
    return this->Hit(glm::dvec3(0.0), direction, t) ? t * direction : glm::dvec3(1e3);
  }

  glm::dvec3 Axis(int i) const { return Kernel::RotateToWorld(this->glyph, glm::dvec3(i == 0, i == 1, i == 2)); }

  /// The point with the same coordinates along this glyph's axes, in its sizes, as `point` has along the other's. Axes
  /// belong together that point the same way, or the opposite one, as the glyphs are symmetric.
  glm::dvec3 Counterpart(const glm::dvec3& point, const Subject& other) const
  {
    glm::dvec3 counterpart(0.0);
    for (int i = 0; i < 3; ++i)
    {
      int nearest = 0;
      for (int k = 1; k < 3; ++k)
      {
        const bool nearer =
          std::abs(glm::dot(this->Axis(i), other.Axis(k))) > std::abs(glm::dot(this->Axis(i), other.Axis(nearest)));
        nearest = nearer ? k : nearest;
      }
      const glm::dvec3 theirs = other.Axis(nearest);
      const double sign = glm::dot(this->Axis(i), theirs) < 0.0 ? -1.0 : 1.0;
      counterpart += sign * glm::dot(point, theirs) * this->glyph.size[i] / other.glyph.size[nearest] * this->Axis(i);
    }
    return counterpart;
  }

  static Kernel::GlyphRay Ray(const glm::dvec3& origin, const glm::dvec3& direction)
  {
    return { origin, glm::dvec3(0.0), direction };
  }
};

/// The rays of a small image in parallel projection, from a direction that is no glyph's axis.
constexpr int side = 6;
const glm::dvec3 toward = glm::normalize(glm::dvec3(-0.48, 0.36, -0.8));

glm::dvec3 Origin(int pixel)
{
  const glm::dvec3 right = glm::normalize(glm::cross(toward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, toward);
  const double x = (pixel % side + 0.5) / side - 0.5, y = (pixel / side + 0.5) / side - 0.5;
  return 1.1 * (x * right + y * up) - 2.0 * toward;
}

/// The largest distance of what the image of one glyph shows from the surface of the other. Where an eigenvalue is zero
/// the true glyph is flat, and its profile may be another on either side; what is drawn has a thickness, half of which
/// does not count.
double ImageChange(const Subject& a, const Subject& b)
{
  const double thickness = a.IsThinnest() && b.IsThinnest() ? a.Thickness() : 0.0;
  double change = 0.0;
  for (int pixel = 0; pixel < side * side; ++pixel)
  {
    const glm::dvec3 origin = Origin(pixel);
    double t = 0.0;
    if (b.Hit(origin, toward, t))
    {
      change = std::max(change, -0.5 * thickness + a.Distance(origin + t * toward, b.Normal(origin, toward, t), b));
    }
  }
  return change;
}

/// 2,000 steps, or RTGLYPHS_RAYS times as many, through equal, zero and sign-changing eigenvalues, the frame turning as
/// well. All that the image of a step shows lies near the surface of the step before; and where it lies farthest, a
/// step ten times smaller takes it about a tenth as far: there is no jump.
TEST(TensorImageTest, ImagesChangeContinuously)
{
  // Two equal, all equal, one zero, signs that change one after the other, two of opposite sign and one magnitude, all
  // negative: through all ten zones of the square of eigenvalues.
  const std::vector<glm::dvec3> stations = { { 1, 0.6, 0.2 }, { 1, 1, 0.2 }, { 1, 1, 1 }, { 1, 0.5, 0.5 },
    { 1, 0.4, 0 }, { 1, 0.3, -0.5 }, { 0.6, 0.4, -1 }, { 1, 0, -1 }, { 1, -0.4, -0.6 }, { 0.7, -0.3, -1 },
    { 0, -0.6, -1 }, { -0.4, -1, -1 }, { -0.3, -0.3, -1 }, { -0.8, -0.8, -0.8 } };
  const int steps = 2000 * TimesRays();
  const auto at = [&](double s, TensorGlyphKind kind)
  {
    const double along = s * static_cast<double>(stations.size() - 1);
    const auto leg = std::min(static_cast<std::size_t>(along), stations.size() - 2);
    const double f = along - static_cast<double>(leg);
    const glm::dquat turn = glm::angleAxis(3.0 * s, glm::normalize(glm::dvec3(1, 2, 3)));
    return Subject(TensorOf((1.0 - f) * stations[leg] + f * stations[leg + 1], turn), kind);
  };
  for (const TensorGlyphKind kind : kinds)
  {
    double largest = 0.0, where = 0.0;
    Subject previous = at(0.0, kind);
    for (int i = 1; i <= steps; ++i)
    {
      const Subject next = at(static_cast<double>(i) / steps, kind);
      const double change = ImageChange(previous, next);
      where = change > largest ? static_cast<double>(i) / steps : where;
      largest = std::max(largest, change);
      previous = next;
    }
    double fine = 0.0;
    for (int i = 0; i < 10; ++i)
    {
      const double s = where - 1.0 / steps + i / (10.0 * steps);
      fine = std::max(fine, ImageChange(at(s, kind), at(std::min(s + 0.1 / steps, 1.0), kind)));
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_LT(fine, 0.2 * largest) << static_cast<int>(kind) << " at " << where;
    std::cout << "kind " << static_cast<int>(kind) << ": largest change of an image " << largest << " at " << where
              << ", of a tenth of the step " << fine << '\n';
  }
}

/// Rays turned with a tensor meet its glyph at the same distances, with normals turned likewise; also where equal
/// eigenvalues leave the eigenvectors open, and the glyph must look the same whichever are chosen.
TEST(TensorImageTest, ImagesTurnWithTheirTensors)
{
  Random random(23);
  const std::vector<glm::dvec3> tensors = { { 1, 0.5, 0.2 }, { 1, 1, 0.3 }, { 1, 0.3, 0.3 }, { 1, 1, 1 },
    { 1, 0.4, -0.7 }, { 1, -0.4, -0.7 }, { 1, 1, -0.6 }, { 1, 1, -1 }, { 0.5, -1, -1 }, { 1, -1, -1 }, { 0.8, 0, -0.8 },
    { -0.2, -0.5, -1 }, { -1, -1, -1 }, { 0, -1, -1 } };
  for (const TensorGlyphKind kind : kinds)
  {
    int hits = 0, judged = 0;
    for (const glm::dvec3& values : tensors)
    {
      for (int trial = 0; trial < 20; ++trial)
      {
        const glm::dquat first = random.Rotation(), turn = random.Rotation();
        const Subject still(TensorOf(values, first), kind), turned(TensorOf(values, turn * first), kind);
        for (int pixel = 0; pixel < side * side; ++pixel)
        {
          const glm::dvec3 origin = Origin(pixel);
          double t = 0.0, other = 0.0;
          const bool hit = still.Hit(origin, toward, t);
          const bool same = turned.Hit(turn * origin, turn * toward, other);
          hits += hit;
          // Rounding may decide on rays that graze: those that meet the surface at less than 10 degrees do not count.
          const glm::dvec3 normal = hit ? still.Normal(origin, toward, t) : glm::dvec3(0.0);
          if (hit && -glm::dot(normal, toward) > 0.17)
          {
            ++judged;
            ASSERT_TRUE(same) << static_cast<int>(kind) << ", eigenvalues " << values.x << ' ' << values.y << ' '
                              << values.z;
            ASSERT_NEAR(t, other, 1e-9) << static_cast<int>(kind) << ", eigenvalues " << values.x << ' ' << values.y
                                        << ' ' << values.z;
          }
        }
      }
    }
    EXPECT_GT(judged, hits / 2);
    std::cout << "kind " << static_cast<int>(kind) << ": " << judged << " of " << hits << " hits judged\n";
  }
}

} // namespace
