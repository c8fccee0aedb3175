// What the superquadric's intersection is made of: powers in double words, and a search whose steps are counted.
#include "HardCases.h"
#include "Measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace
{

using namespace rtg;
using namespace rtg::testing;

template <class Real>
double LargestPowerError(double leastExponent, double mostExponent)
{
  using Kernel = shapes::Kernel<Real>;
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> unit(0, 1);
  const double roundoff = std::numeric_limits<Real>::epsilon() / 2;
  double largest = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Real e = Real(leastExponent * std::pow(mostExponent / leastExponent, unit(engine)));
    const Real hi = Real(std::pow(10.0, -6 * unit(engine)) * (i % 2 ? 1.0 : 1.2));
    const typename Kernel::DoubleWord x = Kernel::FastTwoSum(hi, Real(hi * roundoff * unit(engine)));
    const typename Kernel::DoubleWord power = Kernel::Power(x, e);
    const Quad exact = powq(Quad(x.hi) + x.lo, e);
    if (exact < Quad(1e-18))
    {
      continue; // does not count beside one
    }
    const double error = double(fabsq(Quad(power.hi) + power.lo - exact) / exact);
    const double bound =
      8 * std::max(roundoff * roundoff, 0x1p-101) * (1 + double(e) * (1 + std::abs(std::log2(double(x.hi)))));
    largest = std::max(largest, error / bound);
  }
  return largest;
}

TEST(SuperquadricTest, PowersHaveTheDigitsTheyPromise)
{
  EXPECT_LT(LargestPowerError<float>(0.1, 100), 1.0);
  EXPECT_LT(LargestPowerError<double>(0.1, 100), 1.0);
}

/// The most evaluations of f that any ray of the hard cases needs for its first crossing, or to know that it has none,
/// all of them, how many rays exhaust RTG_STEPS, how many of those are not within the band of a silhouette, and how
/// many get a wrong answer.
struct StepCount
{
  int rays = 0, most = 0, exhausted = 0, wrongly = 0, wrong = 0;
  double steps = 0;

  template <class Crossing>
  void Add(const std::vector<Subject>& subjects, const Crossing& crossing)
  {
    for (const Subject& subject : subjects)
    {
      for (const HardCase& hard : HardCaseMaker(subject, 12, 100).All())
      {
        for (const HardRay& ray : hard.rays)
        {
          const auto found = crossing(KernelRay<float>(ray), KernelGlyph<float>(hard.instances, ray.glyph));
          const int taken = found.steps;
          ++this->rays;
          this->steps += taken;
          this->most = std::max(this->most, taken);
          if (taken >= RTG_STEPS)
          {
            ++this->exhausted;
            ReferenceGlyph reference(hard.instances, ray.glyph);
            this->wrongly += reference.Crossings(ray.origin, ray.direction, 1 - 2 * band).size() ==
              reference.Crossings(ray.origin, ray.direction, 1 + 2 * band).size();
            const Answer answer{ found.found, found.t, glm::dvec3(0.0) };
            const Verdict verdict =
              Judge<float>(reference, reference.Crossings(ray.origin, ray.direction), ray, -1e30, answer);
            // Within the band of a silhouette the crossing behind it is an answer, too.
            this->wrong += verdict.falseHit || verdict.falseMiss ||
              (verdict.bothHit && !verdict.nearSilhouette && !(verdict.excess <= 1.0));
          }
        }
      }
    }
  }

  void Expect(const char* name) const
  {
    std::cout << name << ": " << this->rays << " rays, steps " << this->steps / this->rays << " on average, at most "
              << this->most << ", exhausted " << this->exhausted << "\n";
    EXPECT_EQ(this->wrongly, 0);
    EXPECT_EQ(this->wrong, 0);
    EXPECT_LT(this->exhausted, this->rays / 1000);
    EXPECT_GT(this->most, 5);
  }
};

/// Only rays that touch the surface to within rounding can exhaust them, and those get an answer all the same.
TEST(SuperquadricTest, StepsAreExhaustedOnlyAtSilhouettes)
{
  using Kernel = shapes::Kernel<float>;
  std::vector<Subject> subjects = HardSubjects();
  std::erase_if(subjects, [](const Subject& subject) { return subject.shape != Shape::Superquadric; });
  StepCount axes, nested;
  axes.Add(subjects,
    [](const auto& ray, const auto& glyph) { return Kernel::SuperquadricCrossing(ray, glyph, -1e30f, 1e30f, false); });
  axes.Expect("superquadrics");
  nested.Add(NestedSubjects(),
    [](const auto& ray, const auto& glyph)
    { return Kernel::NestedSuperquadricCrossing(ray, glyph, -1e30f, 1e30f, false); });
  nested.Expect("nested");
}

} // namespace
