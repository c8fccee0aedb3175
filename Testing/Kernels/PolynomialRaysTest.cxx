// Rays for which plain arithmetic cannot decide how the surface of a polynomial goes on: found among millions of hard
// cases.
#include "Measure.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

namespace
{

using namespace rtg::testing;

struct DoubtfulRay
{
  std::string what;
  int degree;
  glm::dvec3 origin;
  glm::vec3 direction, center, size;
  glm::vec4 rotation;
  std::vector<float> values; ///< of the polynomial, as the kernels take them
};

void PrintTo(const DoubtfulRay& ray, std::ostream* out)
{
  *out << ray.what;
}

const DoubtfulRay doubtfulRays[] = {
  { "rounding takes for a crossing what is none", 4,
    { 0x1.3dcb641b843cep-3, -0x1.51a29a0116df4p-3, 0x1.18870f046039p+0 },
    { -0x1.e37c74p-4f, 0x1.2a9f38p-4f, -0x1.fb0c68p-1f }, { 0x1.850a0ap-3f, -0x1.19c87cp-3f, -0x1.c42af2p-2f },
    { 0x1.4279c2p-1f, 0x1.7ca212p-1f, 0x1.33f638p-2f },
    { 0x1.e18fap-2f, 0x1.093506p-2f, -0x1.687328p-1f, 0x1.dc123ep-2f },
    { 0x1.da6cc8p-1f, 0x1.6ae372p-1f, 0x1.7991e6p-1f, -0x1.bce05cp-1f, -0x1.a9ee1ep-2f, -0x1.7668e6p-1f, 0x1.c74a6ep+0f,
      0x1.3f35eap+0f, 0x1.cfad9p-1f, 0x1.898acp+0f, -0x1.033c44p+1f, -0x1.14c202p+1f, 0x1.8fc49p-2f, -0x1.fc2114p-2f,
      -0x1.527b2ep+0f, 0x1.19384p+1f, 0x1.8291acp+0f, -0x1.fc5a94p-3f } },
  { "the same, again and again where the surface is flat", 4,
    { 0x1.24a6d10d16c2p-1, 0x1.ccf833dae924cp-1, -0x1.6dc52c6e0d86p-1 },
    { -0x1.d17faep+4f, -0x1.c0676p+3f, 0x1.79aed6p+4f }, { -0x1.128f88p-2f, 0x1.af26ep-2f, 0x1.d78752p-6f },
    { 0x1.122468p-1f, 0x1.17be68p-1f, 0x1.3b2446p-2f },
    { -0x1.9ce7e2p-2f, 0x1.0fa892p-2f, -0x1.74fa3p-1f, 0x1.f1d564p-2f },
    { 0x1.7d0eeep-1f, 0x1.96feb2p-1f, 0x1.8d0b86p-1f, 0x1.f091bap-2f, 0x1.00226ap+1f, -0x1.95415p-2f, -0x1.f2dfa8p+0f,
      0x1.049a72p-1f, -0x1.88bb48p+0f, -0x1.ab1ea6p-2f, 0x1.cf94b2p+1f, -0x1.959cc4p+0f, -0x1.0fbcap+1f, 0x1.79aaacp-2f,
      0x1.a54cb8p+0f, -0x1.2dfb12p+0f, -0x1.c9198cp-1f, 0x1.3211bcp-2f } },
  { "behind where it comes close the surface is crossed at once", 6,
    { -0x1.e2bd12e31a93p-3, 0x1.d0aa794e20e4p+0, 0x1.512f8496aa6p-2 },
    { -0x1.f47062p+1f, -0x1.3b76cp+5f, -0x1.5d1aa4p+2f }, { -0x1.d1a2fp-2f, -0x1.59236ap-3f, 0x1.f2be4ep-4f },
    { 0x1.898416p-1f, 0x1.214b1ap-1f, 0x1.eead48p-1f },
    { -0x1.f292cap-2f, -0x1.6aaf0ap-4f, 0x1.13903ap-1f, 0x1.5d4c8p-1f },
    { 0x1.2648ecp-1f, 0x1.34b9f2p-1f, 0x1.c70ce6p-1f, 0x1.f9977p-3f, 0x1.f03b24p-2f, 0x1.a0981ap-1f, -0x1.45c1d6p+0f,
      -0x1.d1b6d2p-2f, -0x1.471e5cp+1f, 0x1.47fb36p+1f, -0x1.cf9c3ap+2f, -0x1.433fb2p-2f, 0x1.3ee96ap+1f,
      0x1.139588p-2f, 0x1.0aa3fcp+2f, 0x1.83c59ep+2f, -0x1.2ea802p+2f, 0x1.2f5a68p+2f, 0x1.ae9f52p-1f, -0x1.4d4972p+1f,
      -0x1.365c8cp+3f, 0x1.96834p+2f, 0x1.dfde2p+1f, -0x1.35626ap+1f, -0x1.0bff74p-4f, 0x1.59a4d8p-3f, -0x1.7cd4fp-1f,
      -0x1.b858ap-6f, -0x1.26321ap-1f, 0x1.d76fb2p-1f, -0x1.1b5924p-3f } },
  { "next to the center the angle changes fast", 4, { -0x1.3c22d395a8438p+0, 0x1.a2faf767acfdp+1, 0x1.6e9949631e81p-3 },
    { 0x1.73949ap-2f, -0x1.dc507ap-1f, 0x1.b65aa6p-5f }, { -0x1.7f6768p-4f, 0x1.63a332p-2f, 0x1.63a364p-2f },
    { 0x1.8dc524p-1f, 0x1.1ccd84p-1f, 0x1.a2259ep-1f },
    { -0x1.3fa242p-3f, -0x1.3c544ap-4f, -0x1.db2d72p-4f, 0x1.f4aaaap-1f },
    { 0x1.72f994p-1f, 0x1.4083c4p-1f, 0x1.52e6b8p-1f, 0x1.624474p-3f, 0x1.19fd06p-1f, -0x1.345aa2p-1f, 0x1.50af1ap-1f,
      -0x1.7029e4p+0f, 0x1.92962ep-1f, 0x1.6552bcp-2f, -0x1.250ca8p+0f, 0x1.407306p+0f, -0x1.d336fap-2f, 0x1.1c6bb2p-4f,
      -0x1.370388p-2f, 0x1.fe23d6p-2f, -0x1.73e44ap-2f, 0x1.96a9cep-4f } },
  { "a lobe of the other sign follows within a window", 8,
    { -0x1.1fbbe387a321p-3, 0x1.938472e763bdp-1, -0x1.11090f4eefbbp+0 },
    { -0x1.0149aap-9f, -0x1.e68b62p-8f, 0x1.bde5f8p-7f }, { -0x1.07dbbp-2f, 0x1.6135b2p-2f, -0x1.04518ep-2f },
    { 0x1.1cc312p-1f, 0x1.5b21ecp-2f, 0x1.544682p-1f },
    { 0x1.5581c6p-5f, 0x1.7fef88p-5f, -0x1.dd6bbcp-2f, 0x1.c3ceb4p-1f },
    { 0x1.849f0cp-1f, 0x1.c96586p-1f, 0x1.37564ep-1f, 0x1.52d842p-1f, 0x1.3a0424p+0f, 0x1.240beap+0f, -0x1.30b1f8p+2f,
      0x1.9590b2p+1f, -0x1.9dcd14p+2f, -0x1.42b67p+0f, -0x1.c5964cp+3f, -0x1.b550bp-3f, -0x1.be217ap+2f, 0x1.b73802p+2f,
      0x1.6c3c9cp+1f, 0x1.0ac226p+3f, 0x1.0547f8p+2f, 0x1.f13e9cp+1f, 0x1.7e546p+0f, 0x1.e56124p+4f, -0x1.60411ep+5f,
      -0x1.3a724cp+3f, 0x1.722bb6p+2f, 0x1.4425b8p+3f, -0x1.848f08p-2f, 0x1.3875d2p-2f, 0x1.a38d8ep+3f, -0x1.c7d5f2p+4f,
      0x1.cbb79ep-2f, -0x1.f4c286p+3f, -0x1.4a278p+1f, -0x1.50aa0ap-1f, -0x1.54f3e6p+3f, 0x1.fad8a6p+2f, 0x1.12a6ecp+1f,
      0x1.bb6f54p+2f, -0x1.0e3fd2p-1f, -0x1.d1caf4p+0f, -0x1.448ecep+0f, 0x1.6f9e9cp-3f, 0x1.94bc32p+1f,
      -0x1.9c5edcp+2f, -0x1.7ceac8p+3f, 0x1.5a91fap+3f, 0x1.95918cp+3f, -0x1.afdb14p+1f, -0x1.b89f3cp+0f,
      0x1.4314f4p-2f } },
};

class PolynomialRaysTest : public ::testing::TestWithParam<DoubtfulRay>
{
};

TEST_P(PolynomialRaysTest, KeepTheBounds)
{
  const DoubtfulRay& given = this->GetParam();
  HardCase hard;
  hard.instances.shape = rtg::Shape::Polynomial;
  hard.instances.centers = { given.center };
  hard.instances.sizes3 = { given.size };
  if (given.rotation != glm::vec4(0, 0, 0, 1))
  {
    hard.instances.rotations = { given.rotation };
  }
  hard.instances.polynomialDegree = given.degree;
  hard.instances.polynomials.width = given.values.size();
  hard.instances.polynomials.values = given.values;
  hard.rays = { { given.origin, given.direction, 0 } };
  ReferenceCase reference(std::move(hard));
  const CaseReport report = Summarise(JudgeKernel<float>(reference));
  EXPECT_EQ(report.falseHits + report.falseMisses, 0u);
  EXPECT_EQ(report.compared, 1u);
  EXPECT_LE(report.maxExcess, 1.0);
  EXPECT_LE(report.maxNormalExcess, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Doubtful, PolynomialRaysTest, ::testing::ValuesIn(doubtfulRays));

} // namespace
