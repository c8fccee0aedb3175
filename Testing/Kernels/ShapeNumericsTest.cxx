// The bounds that every shape keeps on every hard case, in float and double: t, normal, hit or miss.
#include "Measure.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

namespace
{

using namespace rtg::testing;

class ShapeNumericsTest : public ::testing::TestWithParam<Subject>
{
protected:
  template <class Real>
  void Run()
  {
    constexpr int glyphs = 8, raysPerGlyph = 40;
    for (const HardCase& hard : HardCaseMaker(this->GetParam(), glyphs, raysPerGlyph).All())
    {
      SCOPED_TRACE(hard.subject + ": " + hard.situation);
      const CaseReport report = Summarise(JudgeKernel<Real>(hard));
      EXPECT_EQ(report.falseHits, 0u);
      EXPECT_EQ(report.falseMisses, 0u);
      EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
      EXPECT_LE(report.maxNormalExcess, 1.0) << report.maxRadians << " radians";
      this->hits_ += report.compared;
    }
    // The cases are there to be hit.
    EXPECT_GT(this->hits_, 1000u);
  }

  std::size_t hits_ = 0;
};

TEST_P(ShapeNumericsTest, Float)
{
  this->Run<float>();
}

TEST_P(ShapeNumericsTest, Double)
{
  this->Run<double>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeNumericsTest, ::testing::ValuesIn(HardSubjects()),
  SubjectName);

/// Nested superquadrics: t and normals of the smooth, convex ones; hits and misses of all. What t and normals of the
/// others are like at the very edge of grazing and at rims thinner than rounding, ShapeErrorTable says.
class SmoothNestedTest : public ShapeNumericsTest
{
};

TEST_P(SmoothNestedTest, Float)
{
  this->Run<float>();
}

class NestedHitsTest : public ::testing::TestWithParam<Subject>
{
};

TEST_P(NestedHitsTest, Float)
{
  for (const HardCase& hard : HardCaseMaker(this->GetParam(), 8, 60).All())
  {
    SCOPED_TRACE(hard.subject + ": " + hard.situation);
    const CaseReport report = Summarise(JudgeKernel<float>(hard));
    EXPECT_EQ(report.falseHits, 0u);
    EXPECT_EQ(report.falseMisses, 0u);
  }
}

std::vector<Subject> SmoothNestedSubjects()
{
  std::vector<Subject> smooth;
  for (const Subject& subject : NestedSubjects())
  {
    if (subject.leastExponents.y < 2.0f)
    {
      smooth.push_back(subject);
    }
  }
  return smooth;
}

INSTANTIATE_TEST_SUITE_P(Shapes, SmoothNestedTest, ::testing::ValuesIn(SmoothNestedSubjects()),
  SubjectName);
INSTANTIATE_TEST_SUITE_P(Shapes, NestedHitsTest, ::testing::ValuesIn(NestedSubjects()), SubjectName);

} // namespace
