// What the superquadric's intersection is made of: powers in double words, and a search whose steps are counted.
#include "HardCases.h"
#include "Measure.h"

#include <gtest/gtest.h>

#include <quadmath.h>

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
    const __float128 exact = powq(__float128(x.hi) + x.lo, e);
    if (exact < __float128(1e-18))
    {
      continue; // does not count beside one
    }
    const double error = double(fabsq(__float128(power.hi) + power.lo - exact) / exact);
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
/// and how many exhaust RTG_STEPS, and how many of those are not within the band of a silhouette.
struct StepCount
{
  int rays = 0, most = 0, exhausted = 0, wrongly = 0;
};

template <class Real>
StepCount CountSteps()
{
  using Kernel = shapes::Kernel<Real>;
  StepCount count;
  for (const Subject& subject : HardSubjects())
  {
    if (subject.shape != Shape::Superquadric)
    {
      continue;
    }
    for (const HardCase& hard : HardCaseMaker(subject, 12, 100).All())
    {
      for (const HardRay& ray : hard.rays)
      {
        const auto glyph = KernelGlyph<Real>(hard.instances, ray.glyph);
        typename Kernel::LocalRay local;
        if (!Kernel::ToBoxFrame(KernelRay<Real>(ray), glyph, Real(0.5) * glyph.size, local))
        {
          continue;
        }
        // As SuperquadricCrossing does it.
        const glm::dvec3 d = glm::abs(glm::dvec3(local.direction.hi));
        const Real scale = std::ldexp(Real(1), -int(std::floor(std::log2(std::max({ d.x, d.y, d.z })))));
        local.direction.hi *= scale;
        local.direction.lo *= scale;
        const auto unit = Kernel::MakeSuperquadricRay(local, glyph.exponents);
        if (!(unit.sIn < unit.sOut))
        {
          continue;
        }
        auto search = Kernel::StartSearch(unit);
        while (Kernel::NextCrossing(local, unit, search, search))
        {
          typename Kernel::DoubleWord s;
          Real resume;
          const bool crossed = Kernel::Polish(local, unit, search, s, resume);
          if (crossed)
          {
            break;
          }
          search = Kernel::Continue(unit, search, crossed, resume);
        }
        ++count.rays;
        count.most = std::max(count.most, search.steps);
        if (search.steps >= RTG_STEPS)
        {
          ++count.exhausted;
          ReferenceGlyph reference(hard.instances, ray.glyph);
          count.wrongly += reference.Crossings(ray.origin, ray.direction, 1 - 2 * band).size() ==
            reference.Crossings(ray.origin, ray.direction, 1 + 2 * band).size();
        }
      }
    }
  }
  return count;
}

/// Only rays that touch the surface to within rounding can exhaust them: a miss is right there.
TEST(SuperquadricTest, StepsAreExhaustedOnlyAtSilhouettes)
{
  const StepCount count = CountSteps<float>();
  std::cout << count.rays << " rays, most steps " << count.most << ", exhausted " << count.exhausted << "\n";
  EXPECT_EQ(count.wrongly, 0);
  EXPECT_LT(count.exhausted, count.rays / 1000);
  EXPECT_GT(count.most, 5);
}

} // namespace
