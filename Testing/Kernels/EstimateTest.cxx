// What EstimateGlyph says is never contradicted by IntersectGlyph, on every hard case, and it is worth asking.
#include "CaseRays.h"
#include "Measure.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace
{

using namespace rtg::testing;

/// Whether the ray passes so close by a silhouette that both a hit and a miss are right.
template <class Real>
bool InBand(const HardCase& hard, const HardRay& ray, Real t)
{
  ReferenceGlyph reference(hard.instances, ray.glyph);
  Answer hit;
  hit.hit = true;
  hit.t = double(t);
  const Verdict verdict = Judge<Real>(reference, reference.Crossings(ray.origin, ray.direction), ray, 0.0, hit);
  return !verdict.hit && !verdict.falseHit;
}

class EstimateTest : public ::testing::TestWithParam<Subject>
{
protected:
  template <class Real>
  void Run()
  {
    using Kernel = rtg::shapes::Kernel<Real>;
    std::size_t asked = 0, decided = 0;
    for (const HardCase& hard : Cases(this->GetParam(), 8, 10).All())
    {
      SCOPED_TRACE(hard.subject + ": " + hard.situation);
      std::size_t wrong = 0;
      for (const HardRay& hardRay : hard.rays)
      {
        const auto glyph = KernelGlyph<Real>(hard.instances, hardRay.glyph);
        const auto ray = KernelRay<Real>(hardRay);
        const rtg::Shape shape = hard.instances.shape;
        Real whole = 0;
        const bool meets = Kernel::IntersectGlyph(shape, ray, glyph, Real(0), Real(1e30), whole);
        // All of the ray, then only what lies well before the crossing, behind it, and around it.
        const Real ranges[][2] = { { Real(0), Real(1e30) }, { Real(0), whole * Real(0.99) },
          { whole * Real(1.01), Real(1e30) }, { whole * Real(0.99), whole * Real(1.01) } };
        for (const auto& range : ranges)
        {
          Real t = 0, low = 0, high = 0;
          const bool hit = Kernel::IntersectGlyph(shape, ray, glyph, range[0], range[1], t);
          const int verdict = Kernel::EstimateGlyph(shape, ray, glyph, range[0], range[1], low, high);
          const bool contradiction = (verdict == Kernel::missed && hit) ||
            (verdict == Kernel::hit && !(hit && low <= t && t <= high)) ||
            (verdict == Kernel::unknown && hit && !(low <= t));
          // A crossing that the exact answer finds where the ray passes within its tolerance is no contradiction.
          wrong += contradiction && !InBand<Real>(hard, hardRay, whole);
          ++asked;
          decided += verdict != Kernel::unknown;
          if (!meets)
          {
            break;
          }
        }
      }
      EXPECT_EQ(wrong, 0u);
    }
    EXPECT_GT(decided, asked / 20);
  }
};

TEST_P(EstimateTest, Float)
{
  this->Run<float>();
}

TEST_P(EstimateTest, Double)
{
  this->Run<double>();
}

std::vector<Subject> AllSubjects()
{
  std::vector<Subject> subjects = HardSubjects();
  for (const auto& more : { NestedSubjects(), PolynomialSubjects() })
  {
    subjects.insert(subjects.end(), more.begin(), more.end());
  }
  return subjects;
}

INSTANTIATE_TEST_SUITE_P(Shapes, EstimateTest, ::testing::ValuesIn(AllSubjects()), SubjectName);

/// Plain scenes: spheres, ellipsoids and round cones need no exact answer but near their silhouettes, and of rays that
/// pass by another shape's box hardly one does.
TEST(EstimatePlainTest, LeavesLittleOpen)
{
  using Kernel = rtg::shapes::Kernel<float>;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  // By shape the fraction of rays that may miss it and stay open: what it leaves of its box and of the ball round it.
  const std::pair<rtg::Shape, double> shares[] = { { rtg::Shape::Sphere, 0.005 }, { rtg::Shape::Box, 0.005 },
    { rtg::Shape::Capsule, 0.03 }, { rtg::Shape::Arrow, 0.1 }, { rtg::Shape::RoundCone, 0.005 } };
  for (const auto& [shape, share] : shares)
  {
    int open = 0, openMisses = 0;
    const int rays = 20000;
    for (int i = 0; i < rays; ++i)
    {
      Kernel::Glyph glyph{};
      glyph.center = 10.0f * glm::vec3(unit(random), unit(random), unit(random));
      glyph.size = 0.6f + 0.4f * glm::vec3(unit(random), unit(random), unit(random));
      glyph.rotation = glm::normalize(glm::vec4(unit(random), unit(random), unit(random), unit(random)));
      glyph.rotated = true;
      glyph.arrow = glm::vec4(0.03f, 0.1f, 0.35f, 0.3f);
      Kernel::GlyphRay ray{};
      ray.origin = glm::vec3(0.0f, 0.0f, 50.0f);
      const glm::vec3 target = glyph.center + 0.8f * glm::vec3(unit(random), unit(random), unit(random));
      ray.direction = target - ray.origin;
      float t = 0, low = 0, high = 0;
      const bool hit = Kernel::IntersectGlyph(shape, ray, glyph, 0.0f, 1e30f, t);
      const bool unknown = Kernel::EstimateGlyph(shape, ray, glyph, 0.0f, 1e30f, low, high) == Kernel::unknown;
      open += unknown;
      openMisses += unknown && !hit;
      if (unknown && hit)
      {
        // The hull is the glyph's size.
        EXPECT_LE((t - low) * glm::length(ray.direction), 1.8f * glm::length(glyph.size));
      }
    }
    EXPECT_LT(openMisses, share * rays) << int(shape);
    if (shape == rtg::Shape::Sphere || shape == rtg::Shape::RoundCone)
    {
      EXPECT_LT(open, rays / 200);
    }
  }
}

} // namespace
