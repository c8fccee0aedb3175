// The bounds that every shape keeps on every hard case, in float and double: t, normal, hit or miss.
#include "CaseRays.h"
#include "Measure.h"
#include "SubjectName.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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
    std::size_t rays = 0, hits = 0;
    for (HardCase& hard : Cases(this->GetParam(), 8, 8).All())
    {
      SCOPED_TRACE(hard.subject + ": " + hard.situation);
      rays += hard.rays.size();
      ReferenceCase reference(std::move(hard));
      hits += std::min({ Expect(Summarise(JudgeKernel<Reals>(reference)), sizeof(Reals))... });
    }
    // The cases are there to be hit.
    EXPECT_GT(7 * hits, rays);
  }

private:
  /// Returns how many hits were compared.
  static std::size_t Expect(const CaseReport& report, std::size_t bytes)
  {
    SCOPED_TRACE(bytes == sizeof(float) ? "float" : "double");
    EXPECT_EQ(report.falseHits, 0u);
    EXPECT_EQ(report.falseMisses, 0u);
    EXPECT_EQ(report.wrongSides, 0u);
    EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
    EXPECT_LE(report.maxDistanceExcess, 1.0) << "times the bound lies a point found from the surface";
    EXPECT_EQ(report.normalsOutOfBound, 0u) << "worst: " << report.maxRadians << " radians";
    return report.compared;
  }
};

TEST_P(ShapeNumericsTest, FloatAndDouble)
{
  this->Run<float, double>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeNumericsTest, ::testing::ValuesIn(HardSubjects()), SubjectName);

/// Nested superquadrics, of tensors and of two exponents: in float. Powers and logarithms (WordFunctions.glsl) have
/// not the digits that double words of doubles would need at grazing angles; ShapeErrorTable measures what those reach.
class NestedNumericsTest : public ShapeNumericsTest
{
};

TEST_P(NestedNumericsTest, Float)
{
  this->Run<float>();
}

INSTANTIATE_TEST_SUITE_P(Shapes, NestedNumericsTest, ::testing::ValuesIn(NestedSubjects()), SubjectName);

/// One ray at one nested superquadric; size and rotation as the glyph's arrays have them.
CaseReport ReportOfNested(
  glm::vec3 center, glm::vec3 size, glm::vec4 rotation, glm::vec3 exponents, glm::dvec3 origin, glm::vec3 direction)
{
  HardCase hard;
  hard.instances.shape = rtg::Shape::NestedSuperquadric;
  hard.instances.centers = { center };
  hard.instances.sizes3 = { size };
  hard.instances.rotations = { rotation };
  hard.instances.exponents3 = { exponents };
  hard.rays = { { origin, direction, 0 } };
  ReferenceCase reference(std::move(hard));
  return Summarise(JudgeKernel<float>(reference));
}

/// The ray hits, and t keeps the bound.
void ExpectHitOfNested(
  glm::vec3 center, glm::vec3 size, glm::vec4 rotation, glm::vec3 exponents, glm::dvec3 origin, glm::vec3 direction)
{
  const CaseReport report = ReportOfNested(center, size, rotation, exponents, origin, direction);
  EXPECT_EQ(report.compared, 1u);
  EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
}

/// A ray that enters a concave glyph twice, the first time for a ten-thousandth of its size and less deep than plain
/// arithmetic knows: there it must not be taken for one that enters once.
TEST(NestedRaysTest, AShallowEntryBeforeADeepOneCounts)
{
  ExpectHitOfNested({ 0.209176525f, -0.428002477f, -0.151852101f }, { 0.50910902f, 0.348379582f, 0.947074056f },
    { 0.0258827414f, -0.146365359f, 0.163249388f, 0.975323975f }, { 0.01f, 5.0f, 2.0f },
    { -0.23615198141739802, -1.7379998871681792, -1.5885088271656151 }, { 0.220271528f, 0.599205673f, 0.769696712f });
}

/// Rays along the flat face of a glyph that is hardly concave: the search must not end before it comes to where they
/// are inside.
TEST(NestedRaysTest, RaysAlongAFaceAreFollowedToTheEnd)
{
  const auto report = [](glm::dvec3 origin, glm::vec3 direction)
  {
    return ReportOfNested({ 0.17151016f, 0.469451904f, 0.0141131971f }, { 1e-4f, 1.0f, 1.0f },
      { -0.0164998341f, -0.00438104756f, 0.0069904332f, 0.999829829f }, { 0.0615272522f, 2.00014448f, 2.00014448f },
      origin, direction);
  };
  EXPECT_EQ(report({ 0.20749434126901267, -1.1791949346171275, -1.4865784962511412 },
              { -0.0163604319f, 0.802222908f, 0.596800387f })
              .falseMisses,
    0u);
  EXPECT_EQ(report({ 0.19777435135345767, -1.7480755882940624, 0.61913749015713648 },
              { -0.0108048953f, 0.950510204f, -0.31050539f })
              .falseMisses,
    0u);
}

/// Behind a coordinate plane that is a cusp of f: a window that is empty but for its end must not be cut at that end
/// alone, where no number is left between the two.
TEST(NestedRaysTest, AWindowIsNotCutAtItsEndForEver)
{
  ExpectHitOfNested({ -0.0813211575f, 0.380455166f, 0.314071238f }, { 0.63004452f, 0.787221134f, 0.964844286f },
    { -0.136537984f, 0.225010738f, -0.148304939f, 0.953274965f }, { 2.51176715f, 0.198100254f, 0.198100254f },
    { -1.95115984732813, 0.92127812391314956, 2.5981760470947393 }, { 0.0105826221f, -0.00221383059f, -0.0112804119f });
}

/// Nearly in the plane of an end, where plain arithmetic knows nothing of the profile: the steps of that piece run out,
/// and the signs at its ends prove that the ray enters in it.
TEST(NestedRaysTest, APieceThatTakesTooManyStepsIsAnswered)
{
  ExpectHitOfNested({ 0.456414253f, -0.195864558f, -0.057646431f }, { 0.659690499f, 0.719446659f, 0.696018875f },
    { 0.273797244f, -0.457849085f, 0.59493655f, 0.601215303f }, { 3.23458982f, 0.372498721f, 0.372498721f },
    { 1.3233048958666016, 0.30149680156260894, 0.59259699102675611 }, { -0.691816151f, -0.16946879f, -0.701905072f });
}

/// Along a face of a sharp cross-section, never deeper inside than a millionth of the size and less than plain
/// arithmetic knows for a third of the way, the ray crosses the surface four times: the first crossing counts.
TEST(NestedRaysTest, AShallowEntryAlongAFaceCounts)
{
  ExpectHitOfNested({ -0.062800236f, 0.434366435f, 0.239545241f }, { 0.840200126f, 0.687748015f, 0.89151001f },
    { -0.12970756f, -0.530111909f, -0.597240746f, 0.587759137f }, { 0.00999999978f, 2.04811978f, 2.00003624f },
    { -1.4274462407395099, 0.88639314695761229, 1.0070471923273718 }, { 0.887465835f, -0.0745470226f, -0.45480451f });
}

/// The signs of f differ at the ends of a window where plain arithmetic has f = 0 at both: its crossing counts.
TEST(NestedRaysTest, AWindowBetweenZerosOfPlainArithmeticHasItsCrossing)
{
  ExpectHitOfNested({ -0.00838106032f, 0.122956738f, -0.484573424f }, { 0.881117225f, 0.517911255f, 0.551478386f },
    { 0.893588066f, 0.257132858f, 0.0350464359f, 0.366271436f }, { 0.00999999978f, 5, 2 },
    { 0.27841967019916503, 1.8720543466201187, -0.71509787003738801 }, { -0.202940956f, -0.978777707f, 0.0284457803f });
}

/// Three crossings within rounding of plain arithmetic, in a window that is taken for one with one extremum.
TEST(NestedRaysTest, TheFirstOfThreeCrossingsCounts)
{
  ExpectHitOfNested({ 0.193328142f, -0.252853274f, -0.385602713f }, { 0.383690715f, 0.81610769f, 0.476153105f },
    { 0.142854542f, -0.339742631f, -0.121299252f, 0.921658278f }, { 0.00999999978f, 5, 2 },
    { -0.24141432350288855, -2.0068608790703024, -0.74990142771130941 }, { 0.199889481f, 0.951443493f, 0.234092772f });
}

/// Polynomials: in float, which is what their windows' width and noise are made for.
INSTANTIATE_TEST_SUITE_P(Polynomials, NestedNumericsTest, ::testing::ValuesIn(PolynomialSubjects()), SubjectName);

/// A ray at the first glyph through a point in its frame, from three lengths of the direction before it.
HardRay RayThrough(const rtg::shapes::Kernel<double>::Glyph& glyph, const glm::dvec3& point, const glm::vec3& direction)
{
  const glm::dvec3 exact = Rounded<float>(glm::dvec3(direction));
  return RayFrom(rtg::shapes::Kernel<double>::RotateToWorld(glyph, point) - 3.0 * exact, direction, 0);
}

/// Heads of a millionth of the arrow, met along it: a ray's place beside the rim must count from there, not from the
/// arrow's middle.
TEST(TinyHeadsTest, RimsAreKeptToTheirSize)
{
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  HardCase hard;
  hard.instances.shape = rtg::Shape::Arrow;
  hard.instances.centers = { glm::vec3(0.0f) };
  hard.instances.sizes3 = { { 1.0f, 1.0f, 1.0f } };
  hard.instances.rotations = { glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f)) };
  hard.instances.arrow.shaftRadius = 0.0f;
  hard.instances.arrow.fixedHeads = true;
  hard.instances.arrow.unitLength = 1e-6f;
  const auto glyph = KernelGlyph<double>(hard.instances, 0);
  for (int i = 0; i < 5000; ++i)
  {
    // Past the base, within a hundredth to a ten-thousandth of the rim, and hardly inclined.
    const double angle = std::numbers::pi * uniform(engine), beside = std::pow(10.0, uniform(engine) - 3.0);
    const double radius = 1e-6 * double(glyph.arrow.y) * (1.0 + std::copysign(beside, uniform(engine)));
    const glm::dvec3 point(1.0 - 1e-6 * double(glyph.arrow.z), radius * std::cos(angle), radius * std::sin(angle));
    const glm::dvec3 along = rtg::shapes::Kernel<double>::RotateToWorld(glyph, glm::dvec3(-1.0, 0.0, 0.0));
    hard.rays.push_back(RayThrough(glyph, point, glm::vec3(along)));
  }
  ReferenceCase reference(std::move(hard));
  const CaseReport report = Summarise(JudgeKernel<float>(reference));
  EXPECT_EQ(report.falseHits, 0u);
  EXPECT_EQ(report.falseMisses, 0u);
  EXPECT_GT(report.compared, 2000u);
}

/// Along the rims of flat ellipsoids and of flat capsules' ends the surface turns round within a ten-thousandth of the
/// size: there the normal shows the last digits of the ray's parameter.
TEST(FlatRimsTest, NormalsKeepTheBound)
{
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const rtg::Shape shape : { rtg::Shape::Sphere, rtg::Shape::Capsule })
  {
    HardCase hard;
    hard.instances.shape = shape;
    hard.instances.centers = { glm::vec3(0.0f) };
    hard.instances.sizes3 = { { 1.0f, 1.0f, 1e-4f } };
    hard.instances.rotations = { glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f)) };
    const auto glyph = KernelGlyph<double>(hard.instances, 0);
    for (int i = 0; i < 5000; ++i)
    {
      // On the unit sphere, 1e-6 to 0.1 from the circle z = 0; a capsule's halves lie half its length away.
      const double angle = std::numbers::pi * uniform(engine), z = std::pow(10.0, 2.5 * uniform(engine) - 3.5);
      const glm::dvec3 unit(std::cos(angle) * std::sqrt(1 - z * z), std::sin(angle) * std::sqrt(1 - z * z), z);
      glm::dvec3 point = 0.5 * unit * glm::dvec3(glyph.size);
      point.x += shape == rtg::Shape::Capsule ? std::copysign(0.5 * glyph.size.x, unit.x) : 0.0;
      hard.rays.push_back(RayThrough(glyph, point, glm::vec3(uniform(engine), uniform(engine), uniform(engine))));
    }
    ReferenceCase reference(std::move(hard));
    const CaseReport report = Summarise(JudgeKernel<float>(reference));
    EXPECT_EQ(report.falseHits + report.falseMisses, 0u);
    EXPECT_EQ(report.normalsOutOfBound, 0u) << "worst: " << report.maxRadians << " radians";
    EXPECT_GT(report.compared, 4500u);
  }
}

} // namespace
