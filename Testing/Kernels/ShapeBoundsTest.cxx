// GlyphBounds holds the glyph and touches it on all six sides.
#include "CaseRays.h"
#include "Reference.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

namespace
{

using namespace rtg;
using namespace rtg::testing;

/// Whether the plane x[axis] = value cuts the glyph, tried with lines in that plane: at first all over it, then
/// ever closer to `seed`, a point of the glyph near that plane, which a success replaces.
bool Cuts(ReferenceGlyph& glyph, int axis, double value, glm::dvec3& seed)
{
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double radius = glyph.Size();
  for (int i = 0; i < 3000; ++i)
  {
    glm::dvec3 point = seed + radius * glm::dvec3(uniform(engine), uniform(engine), uniform(engine));
    point[axis] = value;
    glm::dvec3 direction(uniform(engine), uniform(engine), uniform(engine));
    direction[axis] = 0.0;
    const glm::dvec3 exact(Rounded<float>(direction));
    const auto crossings = glyph.Crossings(point, glm::vec3(exact));
    if (crossings.size() >= 2)
    {
      seed = point + double(crossings[0].t + crossings[1].t) / 2 * exact;
      return true;
    }
    radius *= i % 20 == 19 ? 0.9 : 1.0;
  }
  return false;
}

/// Walks from inside to within 1e-5 glyph sizes of a face of the bounds.
bool Reaches(ReferenceGlyph& glyph, int axis, double bound, glm::dvec3 seed)
{
  const double full = bound - seed[axis];
  double left = full;
  while (std::abs(left) > 1e-5 * glyph.Size())
  {
    left = std::abs(0.3 * left) > 1e-5 * glyph.Size() ? 0.3 * left : std::copysign(0.99e-5 * glyph.Size(), full);
    if (!Cuts(glyph, axis, bound - left, seed))
    {
      return false;
    }
  }
  return true;
}

class ShapeBoundsTest : public ::testing::TestWithParam<Subject>
{
};

/// Points of the surface, from the reference, all over the glyph.
TEST_P(ShapeBoundsTest, HoldTheSurface)
{
  using Kernel = shapes::Kernel<float>;
  for (const HardCase& hard : Cases(this->GetParam(), 4, 10).All())
  {
    SCOPED_TRACE(hard.subject + ": " + hard.situation);
    for (std::uint32_t i = 0; i < hard.instances.Count(); ++i)
    {
      ReferenceGlyph reference(hard.instances, i);
      glm::vec3 lower, upper;
      Kernel::GlyphBounds(hard.instances.shape, KernelGlyph<float>(hard.instances, i), lower, upper);
      // Tight but for rounding: what the scene pads by.
      const glm::vec3 size(float(reference.Size()));
      const glm::vec3 pad = 4.0f * std::numeric_limits<float>::epsilon() * (glm::abs(hard.instances.centers[i]) + size);
      for (const HardRay& ray : hard.rays)
      {
        if (ray.glyph != i)
        {
          continue;
        }
        for (const auto& crossing : reference.Crossings(ray.origin, ray.direction))
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            const double p = double(Quad(ray.origin[axis]) + crossing.t * Quad(ray.direction[axis]));
            ASSERT_GE(p, lower[axis] - pad[axis]);
            ASSERT_LE(p, upper[axis] + pad[axis]);
          }
        }
      }
    }
  }
}

/// Stars with exponents below 1 are left out: their tips are too thin to be found, and beside exponents above 1 their
/// box is that of a larger body.
class TightBoundsTest : public ShapeBoundsTest
{
};

TEST_P(TightBoundsTest, TouchTheSurface)
{
  using Kernel = shapes::Kernel<float>;
  for (const char* situation : { "plain", "turned" })
  {
    const HardCase hard = HardCaseMaker(this->GetParam(), 4, 40).Case(situation);
    SCOPED_TRACE(hard.subject + ": " + hard.situation);
    for (std::uint32_t i = 0; i < hard.instances.Count(); ++i)
    {
      ReferenceGlyph reference(hard.instances, i);
      glm::vec3 lower, upper;
      Kernel::GlyphBounds(hard.instances.shape, KernelGlyph<float>(hard.instances, i), lower, upper);
      glm::dvec3 inside;
      bool found = false;
      for (const HardRay& ray : hard.rays)
      {
        if (ray.glyph == i && !found)
        {
          const auto crossings = reference.Crossings(ray.origin, ray.direction);
          found = crossings.size() == 2;
          inside =
            found ? ray.origin + double(crossings[0].t + crossings[1].t) / 2 * glm::dvec3(ray.direction) : inside;
        }
      }
      ASSERT_TRUE(found);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_TRUE(Reaches(reference, axis, upper[axis], inside)) << axis;
        EXPECT_TRUE(Reaches(reference, axis, lower[axis], inside)) << axis;
      }
    }
  }
}

std::vector<Subject> SubjectsWithoutWings()
{
  std::vector<Subject> subjects;
  for (const Subject& subject : HardSubjects())
  {
    const glm::vec3 e = subject.leastExponents;
    if (glm::min(e.x, glm::min(e.y, e.z)) >= 1.0f)
    {
      subjects.push_back(subject);
    }
  }
  return subjects;
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeBoundsTest, ::testing::ValuesIn(HardSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Polynomials, ShapeBoundsTest, ::testing::ValuesIn(PolynomialSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Shapes, TightBoundsTest, ::testing::ValuesIn(SubjectsWithoutWings()), SubjectName);

} // namespace
