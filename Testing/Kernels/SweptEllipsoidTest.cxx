// Swept ellipsoids of lines beside the hard cases, and what makes them of two ellipsoids.
#include "SweptEllipsoid.h"

#include "Glyphs.h"
#include "Measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace
{

using rtg::testing::KernelGlyph;

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

/// The matrices of a stored sweep.
class Sweep
{
public:
  explicit Sweep(const rtg::GlyphInstances& glyphs)
    : growth_(glm::dvec3(glyphs.exponents3[0]) - 1.0)
  {
    const glm::dvec4 after(glyphs.after[0]);
    const glm::dvec3 size(glyphs.sizes3[0]);
    this->frame_ = Rotation(glyphs.rotations[0]) *
      glm::dmat3(after.z, 0, 0, after.x, size.y / 2, 0, after.y, 0, size.z / 2) * Rotation(glyphs.before[0]);
  }

  glm::dmat3 MatrixAt(double height) const
  {
    const glm::dvec3 squares = 1.0 + height * this->growth_;
    return this->frame_ * glm::dmat3(squares.x, 0, 0, 0, squares.y, 0, 0, 0, squares.z) * glm::transpose(this->frame_);
  }

  /// Of the ellipsoid at that height, from its middle: the image of a point of the unit ball.
  glm::dvec3 Point(double height, const glm::dvec3& v) const
  {
    return this->frame_ * (glm::sqrt(glm::max(1.0 + height * this->growth_, 0.0)) * v);
  }

private:
  static glm::dmat3 Rotation(const glm::vec4& q)
  {
    return glm::mat3_cast(glm::normalize(glm::dquat(q.w, q.x, q.y, q.z)));
  }

  glm::dvec3 growth_;
  glm::dmat3 frame_;
};

template <class Real>
class SweptEllipsoidTest : public ::testing::Test
{
};

using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SweptEllipsoidTest, Reals);

TYPED_TEST(SweptEllipsoidTest, CrossingsAreRight)
{
  for (const Situation& situation : situations)
  {
    SCOPED_TRACE(situation.name);
    Maker maker;
    std::vector<rtg::testing::Verdict> verdicts;
    for (int i = 0; i < 12; ++i)
    {
      rtg::SweepEnd ends[2];
      rtg::testing::HardCase hard;
      hard.instances = maker.Sweep(situation, ends);
      const Sweep sweep(hard.instances);
      const glm::vec3 size = hard.instances.sizes3[0];
      const double away = situation.away * std::max({ size.x, size.y, size.z });
      for (int k = 0; k < 40; ++k)
      {
        // Through all of it, along the surface, and along the axis.
        const double radius = k % 2 ? std::cbrt(std::abs(maker.Uniform())) : 1.0 + 1e-3 * maker.Uniform();
        const double height = maker.Uniform();
        const glm::dvec3 target = height * ends[1].middle + sweep.Point(height, radius * maker.Direction());
        const glm::dvec3 along = glm::normalize(ends[1].middle - ends[0].middle);
        const glm::vec3 way(k % 7 ? maker.Direction() : glm::normalize(along + 1e-2 * maker.Direction()));
        hard.rays.push_back(rtg::testing::RayFrom(target - away * glm::dvec3(way), way, 0));
      }
      rtg::testing::ReferenceCase reference(std::move(hard));
      const auto more = rtg::testing::JudgeKernel<TypeParam>(reference);
      verdicts.insert(verdicts.end(), more.begin(), more.end());
    }
    const rtg::testing::CaseReport report = rtg::testing::Summarise(verdicts);
    EXPECT_GT(report.compared, 180u);
    EXPECT_EQ(report.falseHits + report.falseMisses, 0u);
    EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
    EXPECT_EQ(report.normalsOutOfBound, 0u) << "worst: " << report.maxRadians << " radians";
  }
}

/// A plain ray, whose t differed with and without a normal so much that the normal was that of where it leaves.
TEST(SweptEllipsoidNormalTest, BelongsToTheSameCrossing)
{
  using namespace rtg::testing;
  const std::vector<Subject> subjects = HardSubjects();
  const auto sweep = std::find_if(subjects.begin(), subjects.end(),
    [](const Subject& subject) { return subject.shape == rtg::Shape::SweptEllipsoid; });
  HardCase hard = HardCaseMaker(*sweep, 8, 60, 33).Case("plain");
  hard.rays = { hard.rays[38] };
  ReferenceCase reference(std::move(hard));
  const CaseReport report = Summarise(JudgeKernel<float>(reference));
  EXPECT_EQ(report.compared, 1u);
  EXPECT_EQ(report.normalsOutOfBound, 0u) << report.maxRadians << " radians";
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
      const Sweep sweep(glyphs);
      for (int end = 0; end < 2; ++end)
      {
        const glm::dmat3 found(sweep.MatrixAt(end == 0 ? -1 : 1)), given = ends[end].matrix.Matrix();
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
          const double height = step / 1000.0 - 1.0, reach = std::sqrt(double(sweep.MatrixAt(height)[axis][axis]));
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
