// Properties that hold for every shape, without a reference.
#include "HardCases.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

namespace
{

using namespace rtg;
using namespace rtg::testing;

class ShapePropertiesTest : public ::testing::TestWithParam<Subject>
{
protected:
  using Kernel = shapes::Kernel<float>;

  /// Calls with (ray, glyph, t, normal) for the first hit of every ray of the everyday cases.
  template <class Function>
  void ForEachHit(Function function)
  {
    std::size_t hits = 0;
    for (const char* situation : { "plain", "turned" })
    {
      const HardCase hard = HardCaseMaker(this->GetParam(), 8, 400).Case(situation);
      for (const HardRay& hardRay : hard.rays)
      {
        const auto ray = KernelRay<float>(hardRay);
        const auto glyph = KernelGlyph<float>(hard.instances, hardRay.glyph);
        float t = 0;
        if (Kernel::IntersectGlyph(hard.instances.shape, ray, glyph, 0.0f, 1e30f, t))
        {
          ++hits;
          function(ray, glyph, t, Kernel::GlyphNormal(hard.instances.shape, ray, glyph, t));
        }
      }
    }
    EXPECT_GT(hits, 200u);
  }

  bool Hit(const Kernel::GlyphRay& ray, const Kernel::Glyph& glyph, float& t, float tMin = 0.0f, float tMax = 1e30f)
  {
    return Kernel::IntersectGlyph(this->GetParam().shape, ray, glyph, tMin, tMax, t);
  }
};

class ConvexShapePropertiesTest : public ShapePropertiesTest
{
};

/// From outside the first surface met faces the ray; so it does from inside the other way round.
TEST_P(ShapePropertiesTest, NormalsPointOutwards)
{
  this->ForEachHit(
    [&](const auto& ray, const auto& glyph, float t, const glm::vec3& normal)
    {
      EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
      EXPECT_LT(glm::dot(normal, ray.direction), 1e-6f * glm::length(ray.direction));
      // The wings of a star may be thinner than an ulp of t: then the next crossing is where another one begins.
      const bool winged = glm::min(glyph.exponents.x, glm::min(glyph.exponents.y, glyph.exponents.z)) < 1.0f;
      float exit = 0;
      if (!winged && this->Hit(ray, glyph, exit, std::nextafter(t, 1e30f)))
      {
        const glm::vec3 out = Kernel::GlyphNormal(this->GetParam().shape, ray, glyph, exit);
        EXPECT_GT(glm::dot(out, ray.direction), -1e-6f * glm::length(ray.direction));
      }
    });
}

/// A ray that leaves from a hit point, lifted by the bound on t, outwards, never meets a convex glyph again.
TEST_P(ConvexShapePropertiesTest, LeavingRaysDoNotReturn)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  this->ForEachHit(
    [&](const auto& ray, const auto& glyph, float t, const glm::vec3& normal)
    {
      const glm::dvec3 point =
        glm::dvec3(ray.origin) + glm::dvec3(ray.originLow) + double(t) * glm::dvec3(ray.direction);
      const double size = glm::max(glyph.size.x, glm::max(glyph.size.y, glyph.size.z));
      const double lift =
        8.0 * std::numeric_limits<float>::epsilon() * double(t) * glm::length(glm::dvec3(ray.direction)) + 1e-6 * size;
      glm::vec3 direction(uniform(engine), uniform(engine), uniform(engine));
      direction *= glm::dot(direction, normal) < 0.0f ? -1.0f : 1.0f;
      const HardRay leaving{ Rounded<float>(point + 2.0 * lift * glm::dvec3(normal)), direction, 0 };
      float again = 0;
      EXPECT_FALSE(this->Hit(KernelRay<float>(leaving), glyph, again)) << again;
    });
}

/// What lies at t is found again by every range that holds t, and by none that ends before it.
TEST_P(ShapePropertiesTest, RangesAreKept)
{
  this->ForEachHit(
    [&](const auto& ray, const auto& glyph, float t, const glm::vec3&)
    {
      float again = 0;
      EXPECT_TRUE(this->Hit(ray, glyph, again, t, t));
      EXPECT_EQ(again, t);
      EXPECT_FALSE(this->Hit(ray, glyph, again, 0.0f, std::nextafter(t, 0.0f)));
      if (this->Hit(ray, glyph, again, std::nextafter(t, 1e30f)))
      {
        EXPECT_GT(again, t);
      }
    });
}

/// Doubling all lengths doubles t and nothing else: powers of two change no rounding.
TEST_P(ShapePropertiesTest, ScaleByPowersOfTwo)
{
  this->ForEachHit(
    [&](auto ray, auto glyph, float t, const glm::vec3& normal)
    {
      for (const float scale : { 0x1p-20f, 0x1p20f })
      {
        auto scaledRay = ray;
        auto scaledGlyph = glyph;
        scaledRay.origin *= scale;
        scaledRay.originLow *= scale;
        scaledGlyph.center *= scale;
        scaledGlyph.size *= scale;
        scaledGlyph.unitLength *= scale;
        scaledGlyph.after *= this->GetParam().shape == Shape::SweptEllipsoid ? scale : 1.0f; // lengths
        float scaled = 0;
        ASSERT_TRUE(this->Hit(scaledRay, scaledGlyph, scaled));
        EXPECT_EQ(scaled, t * scale);
        EXPECT_EQ(Kernel::GlyphNormal(this->GetParam().shape, scaledRay, scaledGlyph, scaled), normal);
      }
    });
}

/// Moving glyph and ray together, far from the origin, changes nothing but the rounding of the inputs: none
/// here, the low words hold it.
TEST_P(ShapePropertiesTest, MoveTogether)
{
  const glm::vec3 shift(1e4f, -2e4f, 3e4f);
  this->ForEachHit(
    [&](auto ray, auto glyph, float t, const glm::vec3& normal)
    {
      const auto move = [&](glm::vec3& high, glm::vec3& low)
      {
        for (int i = 0; i < 3; ++i)
        {
          const auto sum = Kernel::Add(Kernel::TwoSum(high[i], shift[i]), low[i]);
          high[i] = sum.hi;
          low[i] = sum.lo;
        }
      };
      move(ray.origin, ray.originLow);
      move(glyph.center, glyph.centerLow);
      float moved = 0;
      ASSERT_TRUE(this->Hit(ray, glyph, moved));
      EXPECT_NEAR(moved, t, 2e-7f * t);
      EXPECT_LT(glm::length(Kernel::GlyphNormal(this->GetParam().shape, ray, glyph, moved) - normal), 1e-4f);
    });
}

std::vector<Subject> ConvexSubjects()
{
  std::vector<Subject> convex;
  for (const Subject& subject : HardSubjects())
  {
    const glm::vec3 e = subject.leastExponents;
    if (subject.shape != Shape::Arrow && glm::min(e.x, glm::min(e.y, e.z)) >= 1.0f)
    {
      convex.push_back(subject);
    }
  }
  return convex;
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapePropertiesTest, ::testing::ValuesIn(HardSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Polynomials, ShapePropertiesTest, ::testing::ValuesIn(PolynomialSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Shapes, ConvexShapePropertiesTest, ::testing::ValuesIn(ConvexSubjects()), SubjectName);

} // namespace
