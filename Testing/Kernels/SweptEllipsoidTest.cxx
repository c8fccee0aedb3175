// Swept ellipsoids against a search in extended precision, and what makes them of two ellipsoids.
#include "SweptEllipsoid.h"

#include "Glyphs.h"
#include "HardCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using rtg::testing::KernelGlyph;
using Long = long double;
using Vector = glm::vec<3, Long>;
using Matrix = glm::mat<3, 3, Long>;

struct Situation
{
  const char* name;
  double length; ///< of the way, in sizes of the ellipsoids
  double thinness;
  enum
  {
    Turned, ///< every ellipsoid in its own way
    Alike,
    Upright,
    Discs, ///< one in the plane across x, the other one in that across y
    Tip    ///< one is a point
  } kind;
  double size;
  double away; ///< of the camera, in sizes of the glyph
};

const Situation situations[] = {
  { "plain", 2, 0.3, Situation::Turned, 1, 3 },
  { "long", 100, 0.3, Situation::Turned, 1, 1.5 },
  { "short", 1e-3, 0.3, Situation::Turned, 1, 3 },
  { "very short", 1e-6, 0.3, Situation::Turned, 1, 3 },
  { "alike", 2, 0.3, Situation::Alike, 1, 3 },
  { "thin", 2, 1e-2, Situation::Turned, 1, 3 },
  { "thin, long", 30, 3e-2, Situation::Turned, 1, 1.5 },
  { "thin, short", 0.01, 1e-2, Situation::Turned, 1, 3 },
  { "thin, upright", 2, 1e-2, Situation::Upright, 1, 3 },
  { "turned by 90 degrees", 2, 1e-2, Situation::Discs, 1, 3 },
  { "no thickness", 2, 0, Situation::Turned, 1, 3 },
  { "tip", 2, 0.3, Situation::Tip, 1, 3 },
  { "small", 2, 0.3, Situation::Turned, 1e-6, 3 },
  { "large", 2, 0.3, Situation::Turned, 1e6, 3 },
  { "far away", 2, 0.3, Situation::Turned, 1, 1e4 },
};

class Maker
{
public:
  double Uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->engine_); }

  glm::dvec3 Direction()
  {
    std::normal_distribution<double> normal;
    const glm::dvec3 v(normal(this->engine_), normal(this->engine_), normal(this->engine_));
    return glm::normalize(v);
  }

  rtg::SymmetricTensor Tensor(const Situation& situation, bool last)
  {
    glm::dvec3 half(1.0, std::pow(situation.thinness, std::abs(this->Uniform())), situation.thinness);
    half = situation.kind == Situation::Discs ? glm::dvec3(1.0) : half;
    if (situation.kind == Situation::Discs)
    {
      half[last ? 1 : 0] = situation.thinness;
    }
    half *= situation.kind == Situation::Tip && !last ? 0.0 : situation.size;
    const double angle = 4.0 * this->Uniform();
    const bool upright = situation.kind == Situation::Upright || situation.kind == Situation::Discs;
    const glm::dmat3 axes = glm::mat3_cast(upright ? glm::dquat(1, 0, 0, 0) : glm::angleAxis(angle, this->Direction()));
    const glm::dvec3 squares = half * half;
    const glm::dmat3 m = axes * glm::dmat3(squares.x, 0, 0, 0, squares.y, 0, 0, 0, squares.z) * glm::transpose(axes);
    return rtg::SymmetricTensor::Of(m);
  }

  rtg::GlyphInstances Sweep(const Situation& situation, rtg::SweepEnd (&ends)[2])
  {
    const glm::dvec3 way = 0.5 * situation.length * situation.size * this->Direction();
    ends[0] = { -way, this->Tensor(situation, false) };
    ends[1] = { way, situation.kind == Situation::Alike ? ends[0].matrix : this->Tensor(situation, true) };
    rtg::GlyphInstances glyphs;
    glyphs.shape = rtg::Shape::SweptEllipsoid;
    glyphs.centers.resize(1);
    glyphs.sizes3.resize(1);
    glyphs.rotations.resize(1);
    glyphs.before.resize(1);
    glyphs.after.resize(1);
    glyphs.exponents3.resize(1);
    rtg::StoreSweep(ends[0], ends[1], 0, glyphs);
    return glyphs;
  }

private:
  std::mt19937_64 engine_{ 5 };
};

/// By golden sections over the heights, and a bisection of how the crossing changes with the height.
class Reference
{
public:
  explicit Reference(const rtg::GlyphInstances& glyphs)
    : center_(glyphs.centers[0])
  {
    const glm::vec4 after = glyphs.after[0];
    const Vector size(glyphs.sizes3[0]);
    const Matrix turn = Rotation(glyphs.rotations[0]);
    this->frame_ =
      turn * Matrix(after.z, 0, 0, after.x, size.y / 2, 0, after.y, 0, size.z / 2) * Rotation(glyphs.before[0]);
    this->back_ = glm::inverse(this->frame_);
    this->growth_ = Vector(glyphs.exponents3[0]) - Vector(1);
    this->way_ = this->back_ * (turn * Vector(Long(after.w) / 2, 0, 0));
  }

  Matrix MatrixAt(Long height) const
  {
    const Vector squares = this->Squares(height);
    return this->frame_ * Matrix(squares.x, 0, 0, 0, squares.y, 0, 0, 0, squares.z) * glm::transpose(this->frame_);
  }

  /// The image of a point of the unit ball.
  glm::dvec3 Point(Long height, const glm::dvec3& v) const
  {
    return glm::dvec3(
      this->center_ + this->frame_ * (height * this->way_ + glm::sqrt(this->Squares(height)) * Vector(v)));
  }

  /// Whether the line enters, how deep it goes (0: it touches, 1: through the middle), where, and the normal there.
  bool Enter(const Vector& origin, const Vector& direction, Long& depth, Long& s, Vector& normal)
  {
    this->o_ = this->back_ * (origin - this->center_);
    this->d_ = this->back_ * direction;
    const Long deepest = this->Least(-1, 1, [&](Long height) { return this->At(height).excess; });
    depth = -this->At(deepest).excess;
    if (!(depth > 0))
    {
      return false;
    }
    const Long low = this->Edge(deepest, -1), high = this->Edge(deepest, 1);
    Long height = this->Least(low, high, [&](Long at) { return this->At(at).s; });
    Long below = std::max(low, height - Long(1e-6) * (high - low)),
         above = std::min(high, height + Long(1e-6) * (high - low));
    if (this->Rate(below) < 0 && this->Rate(above) > 0)
    {
      for (int i = 0; i < 60; ++i)
      {
        height = (below + above) / 2;
        (this->Rate(height) < 0 ? below : above) = height;
      }
    }
    const Met met = this->At(height);
    s = met.s;
    normal = glm::normalize(glm::transpose(this->back_) * met.gradient);
    return true;
  }

private:
  struct Met
  {
    Long s, excess;
    Vector gradient;
  };

  static Matrix Rotation(const glm::vec4& q)
  {
    return glm::mat3_cast(glm::normalize(glm::qua<Long>(Long(q.w), Long(q.x), Long(q.y), Long(q.z))));
  }

  Vector Squares(Long height) const { return glm::max(Vector(1) + height * this->growth_, Vector(Long(1e-9))); }

  Met At(Long height) const
  {
    const Vector weights = Vector(1) / this->Squares(height), y = this->o_ - height * this->way_;
    const Long a = glm::dot(weights * this->d_, this->d_), b = glm::dot(weights * y, this->d_);
    const Long discriminant = b * b - a * (glm::dot(weights * y, y) - 1);
    const Long s = (-b - std::sqrt(std::max(discriminant, Long(0)))) / a;
    return { s, -discriminant / a, weights * (y + s * this->d_) };
  }

  Long Rate(Long height) const
  {
    const Vector gradient = this->At(height).gradient;
    return -glm::dot(gradient, Long(2) * this->way_ + this->growth_ * gradient);
  }

  template <class Function>
  Long Least(Long low, Long high, const Function& f) const
  {
    const Long ends[] = { low, high }, section = (std::sqrt(Long(5)) - 1) / 2;
    for (int i = 0; i < 100; ++i)
    {
      const Long first = high - section * (high - low), second = low + section * (high - low);
      (f(first) < f(second) ? high : low) = f(first) < f(second) ? second : first;
    }
    Long best = (low + high) / 2;
    for (const Long end : ends)
    {
      best = f(end) < f(best) ? end : best;
    }
    return best;
  }

  // How far heights go whose ellipsoids the line meets.
  Long Edge(Long inside, Long outside) const
  {
    for (int i = 0; i < 64 && this->At(outside).excess > 0; ++i)
    {
      const Long middle = (inside + outside) / 2;
      if (this->At(middle).excess > 0)
      {
        outside = middle;
      }
      else
      {
        inside = middle;
      }
    }
    return this->At(outside).excess > 0 ? inside : outside;
  }

  Vector center_, growth_, way_, o_, d_;
  Matrix frame_, back_;
};

template <class Real>
class SweptEllipsoidTest : public ::testing::Test
{
};

using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SweptEllipsoidTest, Reals);

TYPED_TEST(SweptEllipsoidTest, CrossingsAreRight)
{
  using Kernel = rtg::shapes::Kernel<TypeParam>;
  using RealVector = glm::vec<3, TypeParam>;
  constexpr double apart = 4e-5; // of the thickness twice, from the silhouette
  for (const Situation& situation : situations)
  {
    SCOPED_TRACE(situation.name);
    const bool exactNormals = situation.thinness > 0 && situation.away < 100;
    Maker maker;
    int judged = 0, wrong = 0, far = 0, askew = 0, outside = 0, misjudged = 0;
    for (int i = 0; i < 12; ++i)
    {
      rtg::SweepEnd ends[2];
      const rtg::GlyphInstances glyphs = maker.Sweep(situation, ends);
      Reference reference(glyphs);
      const auto glyph = KernelGlyph<TypeParam>(glyphs, 0);
      const double size = glm::max(glyph.size.x, glm::max(glyph.size.y, glyph.size.z));
      RealVector lower, upper;
      Kernel::GlyphBounds(glyphs.shape, glyph, lower, upper);
      for (int k = 0; k < 40; ++k)
      {
        // Through all of it, along the surface, and along the axis.
        const double radius = k % 2 ? std::cbrt(std::abs(maker.Uniform())) : 1.0 + 1e-3 * maker.Uniform();
        const glm::dvec3 target = reference.Point(maker.Uniform(), radius * maker.Direction());
        const glm::dvec3 along = glm::normalize(ends[1].middle - ends[0].middle);
        const glm::dvec3 way = k % 7 ? maker.Direction() : glm::normalize(along + 1e-2 * maker.Direction());
        typename Kernel::GlyphRay ray{};
        ray.origin = RealVector(glm::vec3(target - situation.away * size * way));
        ray.direction = RealVector(glm::vec3(way));
        Long depth = 0, s = 0;
        Vector normal;
        const bool hits = reference.Enter(Vector(ray.origin), Vector(ray.direction), depth, s, normal);
        TypeParam t = 0, low = 0, high = 0;
        RealVector found;
        const bool met = Kernel::IntersectGlyph(glyphs.shape, ray, glyph, 0, TypeParam(1e30), true, t, found);
        const int verdict = Kernel::EstimateGlyph(glyphs.shape, ray, glyph, 0, TypeParam(1e30), low, high);
        misjudged += met && (verdict == Kernel::missed || low > t);
        if (std::abs(depth) < apart)
        {
          continue;
        }
        ++judged;
        wrong += hits != met;
        if (hits && met)
        {
          const Long error = std::abs(Long(t) - s), ulps = Long(8) * std::numeric_limits<TypeParam>::epsilon() * s;
          far += error > ulps + Long(sizeof(TypeParam) == sizeof(float) ? 1e-6 : 1e-8) * size;
          askew += exactNormals && glm::length(glm::cross(normal, Vector(found))) > Long(1e-5);
          const RealVector point = ray.origin + t * ray.direction,
                           padding = TypeParam(2e-6) * (upper - lower) + TypeParam(4e-7) * glm::abs(ray.origin);
          outside +=
            glm::any(glm::lessThan(point, lower - padding)) || glm::any(glm::greaterThan(point, upper + padding));
        }
      }
    }
    EXPECT_GT(judged, 400);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(far, 0);
    EXPECT_EQ(askew, 0);
    EXPECT_EQ(outside, 0);
    EXPECT_EQ(misjudged, 0);
  }
}

/// Both ends are the given ellipsoids, and bounds touch the sweep.
TYPED_TEST(SweptEllipsoidTest, IsWhatWasGiven)
{
  using Kernel = rtg::shapes::Kernel<TypeParam>;
  for (const Situation& situation : situations)
  {
    SCOPED_TRACE(situation.name);
    Maker maker;
    for (int i = 0; i < 20; ++i)
    {
      rtg::SweepEnd ends[2];
      const rtg::GlyphInstances glyphs = maker.Sweep(situation, ends);
      const Reference reference(glyphs);
      for (int end = 0; end < 2; ++end)
      {
        const glm::dmat3 found(reference.MatrixAt(end == 0 ? -1 : 1)), given = ends[end].matrix.Matrix();
        const double largest = std::max(ends[0].matrix.Largest(), ends[1].matrix.Largest());
        for (int column = 0; column < 3; ++column)
        {
          EXPECT_LT(glm::length(found[column] - given[column]), 4e-6 * largest);
        }
      }
      glm::vec<3, TypeParam> lower, upper;
      Kernel::GlyphBounds(glyphs.shape, KernelGlyph<TypeParam>(glyphs, 0), lower, upper);
      for (int axis = 0; axis < 3; ++axis)
      {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int step = 0; step <= 2000; ++step)
        {
          const double height = step / 1000.0 - 1.0, reach = std::sqrt(double(reference.MatrixAt(height)[axis][axis]));
          const double middle = height * ends[1].middle[axis];
          least = std::min(least, middle - reach);
          most = std::max(most, middle + reach);
        }
        EXPECT_NEAR(lower[axis], least, 1e-5 * (most - least));
        EXPECT_NEAR(upper[axis], most, 1e-5 * (most - least));
      }
    }
  }
}

} // namespace
