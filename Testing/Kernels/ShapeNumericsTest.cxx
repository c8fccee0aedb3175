// The bounds that every shape keeps on every hard case, in float and double: t, normal, hit or miss.
#include "Measure.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace rtg::testing;

class ShapeNumericsTest : public ::testing::TestWithParam<Subject>
{
protected:
  /// `Reals`: the arithmetics that are judged, all by one reference.
  template <class... Reals>
  void Run()
  {
    constexpr int glyphs = 8, raysPerGlyph = 40;
    std::size_t hits = 0;
    for (HardCase& hard : HardCaseMaker(this->GetParam(), glyphs, raysPerGlyph).All())
    {
      SCOPED_TRACE(hard.subject + ": " + hard.situation);
      ReferenceCase reference(std::move(hard));
      hits += std::min({ Expect(Summarise(JudgeKernel<Reals>(reference)), sizeof(Reals))... });
    }
    // The cases are there to be hit.
    EXPECT_GT(hits, 1000u);
  }

private:
  /// Returns how many hits were compared.
  static std::size_t Expect(const CaseReport& report, std::size_t bytes)
  {
    SCOPED_TRACE(bytes == sizeof(float) ? "float" : "double");
    EXPECT_EQ(report.falseHits, 0u);
    EXPECT_EQ(report.falseMisses, 0u);
    EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
    EXPECT_EQ(report.normalsOutOfBound, 0u) << "worst: " << report.maxRadians << " radians";
    return report.compared;
  }
};

TEST_P(ShapeNumericsTest, FloatAndDouble)
{
  this->Run<float, double>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeNumericsTest, ::testing::ValuesIn(HardSubjects()), SubjectName);

/// Nested superquadrics, of tensors and of two exponents: in float. Exponential and logarithm (WordFunctions.glsl) have
/// not the digits that double words of doubles would need at grazing angles; ShapeErrorTable tells what those reach.
class NestedNumericsTest : public ShapeNumericsTest
{
};

TEST_P(NestedNumericsTest, Float)
{
  this->Run<float>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, NestedNumericsTest, ::testing::ValuesIn(NestedSubjects()), SubjectName);

} // namespace
