// GlyphBoxes, which computes in single precision, holds the bounds that double precision gives, and little more.
#include "GlyphBoxes.h"
#include "HardCases.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace
{

using namespace rtg;
using namespace rtg::testing;

/// Of each glyph; `centers` may be given low parts.
void ExpectTight(const GlyphInstances& instances)
{
  const std::vector<Box> boxes = GlyphBoxes(instances);
  ASSERT_EQ(boxes.size(), instances.Count());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
  {
    shapes::Kernel<double>::Glyph glyph = KernelGlyph<double>(instances, i);
    glm::dvec3 low(0.0);
    if (!instances.centersLow.empty())
    {
      low = glm::dvec3(instances.centersLow[i]);
    }
    const glm::dvec3 center = std::exchange(glyph.center, glm::dvec3(0.0)) + low;
    glm::dvec3 lower, upper;
    shapes::Kernel<double>::GlyphBounds(instances.shape, glyph, lower, upper);
    // Of arrows, from the tail, even when there is only a head.
    const double size = glm::length(glm::max(glm::abs(lower), glm::abs(upper)));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double least = center[axis] + lower[axis], most = center[axis] + upper[axis];
      ASSERT_LE(boxes[i].lower[axis], least) << i;
      ASSERT_GE(boxes[i].upper[axis], most) << i;
      ASSERT_GE(boxes[i].lower[axis], least - 4e-6 * size - 4e-7 * std::abs(least)) << i;
      ASSERT_LE(boxes[i].upper[axis], most + 4e-6 * size + 4e-7 * std::abs(most)) << i;
    }
  }
}

class GlyphBoxesTest : public ::testing::TestWithParam<Subject>
{
};

TEST_P(GlyphBoxesTest, HoldTheBounds)
{
  for (const HardCase& hard : HardCaseMaker(this->GetParam(), 200, 0).All())
  {
    SCOPED_TRACE(hard.subject + ": " + hard.situation);
    ExpectTight(hard.instances);
  }
}

/// Programs compute times in floats: next to time zero these are off by many of their own ulps.
TEST(GlyphBoxesOfMoving, HoldGlyphsAtTheTimesOfPrograms)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<float> unit;
  constexpr int slices = 64;
  for (int i = 0; i < 2000; ++i)
  {
    GlyphInstances instances;
    instances.centers = { glm::vec3(0.0f) };
    instances.uniformSize = 0.01f;
    instances.motion.velocities = { glm::vec3(100.0f, -70.0f, 30.0f) };
    instances.motion.accelerations = { glm::vec3(10.0f, 20.0f, -50.0f) };
    instances.motion.shutterOpen = -unit(random);
    instances.motion.shutterClose = unit(random);
    const float length = instances.motion.shutterClose - instances.motion.shutterOpen;
    const auto slice = static_cast<int>(-instances.motion.shutterOpen / length * slices);
    const Box box = GlyphBoxes(instances, double(slice) / slices, double(slice + 1) / slices).front();
    // The first and the last fraction of the slice.
    for (const float fraction : { float(slice) / slices, std::nextafter(float(slice + 1) / slices, 0.0f) })
    {
      const float product = fraction * length;
      const float time = instances.motion.shutterOpen + product;
      const glm::dvec3 center = instances.motion.Displacement(0, time);
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_LE(box.lower[axis], center[axis] - 0.5 * double(instances.uniformSize)) << time;
        ASSERT_GE(box.upper[axis], center[axis] + 0.5 * double(instances.uniformSize)) << time;
      }
    }
  }
}

TEST_P(GlyphBoxesTest, WithLowParts)
{
  HardCase hard = HardCaseMaker(this->GetParam(), 200, 0).Case("turned");
  for (glm::vec3& center : hard.instances.centers)
  {
    const glm::dvec3 far = glm::dvec3(center) + glm::dvec3(1e6, -1e7, 1.0);
    center = glm::vec3(far);
    hard.instances.centersLow.emplace_back(far - glm::dvec3(center));
  }
  ExpectTight(hard.instances);
}

INSTANTIATE_TEST_SUITE_P(Shapes, GlyphBoxesTest, ::testing::ValuesIn(HardSubjects()), SubjectName);

/// Exponents from round to nearly 1, where the reach of a turned superquadric is hardest to find, to 100.
TEST(GlyphBoxesOfSuperquadrics, HoldTheBounds)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit;
  std::normal_distribution<float> normal;
  GlyphInstances instances;
  instances.shape = Shape::Superquadric;
  for (int i = 0; i < 100000; ++i)
  {
    const auto exponent = [&]
    {
      const float u = unit(random);
      return i % 3 == 0 ? 1.0f + std::pow(10.0f, -7.0f * u) : std::pow(10.0f, -1.0f + 3.0f * u);
    };
    const float r = exponent(), s = exponent();
    instances.exponents3.emplace_back(r, s, exponent());
    const float x = std::pow(10.0f, -3.0f * unit(random)), y = std::pow(10.0f, -3.0f * unit(random));
    instances.sizes3.emplace_back(x, y, 1.0f);
    const float a = normal(random), b = normal(random), c = normal(random);
    instances.rotations.push_back(glm::normalize(glm::vec4(a, b, c, normal(random))));
    instances.centers.emplace_back(unit(random));
  }
  ExpectTight(instances);
}

/// Balls' boxes are found one by one as they stand in a list, to the bit.
TEST(GlyphBoxesOfBalls, AreFoundAsListed)
{
  std::mt19937 random(12);
  std::uniform_real_distribution<float> unit;
  GlyphInstances instances;
  instances.shape = Shape::Sphere;
  for (int i = 0; i < 10000; ++i)
  {
    const auto any = [&] { return (2.0f * unit(random) - 1.0f) * std::pow(10.0f, 16.0f * unit(random) - 8.0f); };
    const float x = any(), y = any();
    instances.centers.emplace_back(x, y, any());
    instances.sizes1.push_back(i % 100 == 0 ? 0.0f : std::abs(any()));
  }
  const auto expectAsListed = [&]
  {
    ASSERT_TRUE(AreBalls(instances));
    const std::vector<Box> list = GlyphBoxes(instances);
    const std::vector<Box> none;
    const BoxReader read(instances, none);
    ASSERT_EQ(read.Count(), list.size());
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      ASSERT_EQ(read[i].lower, list[i].lower) << i;
      ASSERT_EQ(read[i].upper, list[i].upper) << i;
    }
  };
  expectAsListed();
  for (const glm::vec3& center : instances.centers)
  {
    instances.centersLow.push_back(3e-8f * unit(random) * center);
  }
  expectAsListed();
  instances.sizes1.clear();
  instances.uniformSize = 0.3f;
  expectAsListed();
  instances.rotations.resize(instances.Count(), glm::vec4(0, 0, 0, 1));
  EXPECT_FALSE(AreBalls(instances));
}

} // namespace
