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

/// Nested superquadrics, of tensors and of two exponents: in float. Exponential and logarithm (WordFunctions.glsl) have not the
/// digits that double words of doubles would need at grazing angles; ShapeErrorTable tells what those reach.
class NestedNumericsTest : public ShapeNumericsTest
{
};

TEST_P(NestedNumericsTest, Float)
{
  this->Run<float>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, NestedNumericsTest, ::testing::ValuesIn(NestedSubjects()),
  SubjectName);

} // namespace
