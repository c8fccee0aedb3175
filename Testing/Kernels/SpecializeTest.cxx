// Programs are valid for all values of their constants, and hold no more than these ask for.
#include "HostDevice.h"
#include "Shading/List.h"
#include "Vulkan/Pipeline.h"
#include "Vulkan/Programs.h"

#include <gtest/gtest.h>
#include <spirv-tools/libspirv.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace
{

#define RTG_COUNT(...) +1
constexpr std::uint32_t programs = RTG_SHADINGS(RTG_COUNT);
#undef RTG_COUNT
constexpr std::uint32_t opSpecConstantTrue = 48, opSpecConstantOp = 52;

// Instructions of specialization constants.
int SpecializationConstants(const std::uint32_t* words, std::size_t count)
{
  int found = 0;
  for (std::size_t at = 5; at < count; at += words[at] >> 16)
  {
    const std::uint32_t code = words[at] & 0xffffu;
    found += code >= opSpecConstantTrue && code <= opSpecConstantOp;
  }
  return found;
}

std::string Faults(const std::vector<std::uint32_t>& words)
{
  std::string faults;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message)
    { faults += std::string(message) + "\n"; });
  spvtools::ValidatorOptions options;
  options.SetScalarBlockLayout(true);
  return tools.Validate(words.data(), words.size(), options) ? "" : "invalid: " + faults;
}

rtg::Constants ConstantsOf(std::initializer_list<rtg::Shape> shapes, std::uint32_t variants)
{
  rtg::Constants constants;
  for (const rtg::Shape shape : shapes)
  {
    constants.shapes |= 1u << static_cast<std::uint32_t>(shape);
  }
  constants.inSomeSets = variants;
  return constants;
}

// The bytes of a program for these; `code`: one that shapes are cut out of.
std::size_t Bytes(const rtg::programs::Code& code, std::initializer_list<rtg::Shape> shapes, std::uint32_t variants = 0)
{
  const std::vector<std::uint32_t> words = rtg::Specialize(code, ConstantsOf(shapes, variants));
  EXPECT_EQ(Faults(words), "");
  EXPECT_EQ(SpecializationConstants(words.data(), words.size()), 0);
  return words.size() * sizeof(std::uint32_t);
}

} // namespace

TEST(Specialize, LeavesWhatIsUsed)
{
  using rtg::Shape;
  for (std::uint32_t program = 0; program < programs; ++program)
  {
    const rtg::programs::Code& code = rtg::programs::modules[program];
    EXPECT_GT(SpecializationConstants(code.words, code.bytes / sizeof(std::uint32_t)), 0);
    const std::size_t spheres = Bytes(code, { Shape::Sphere });
    EXPECT_LT(2 * spheres, code.bytes);
    EXPECT_LT(spheres, Bytes(code, { Shape::Sphere }, rtg::device::VELOCITIES));
    const std::size_t two = Bytes(code, { Shape::Sphere, Shape::Superquadric });
    EXPECT_LT(spheres, two);
    EXPECT_LT(two, Bytes(code, { Shape::Sphere, Shape::Superquadric, Shape::Cylinder }));
  }
}

TEST(Specialize, AsksForRayQueriesOnlyWhereTheyAreMade)
{
  constexpr std::uint32_t opCapability = 2u << 16 | 17u, rayQuery = 4472;
  for (std::uint32_t program = 0; program < programs; ++program)
  {
    rtg::Constants constants = ConstantsOf({ rtg::Shape::Sphere }, 0);
    for (const std::uint32_t queries : { 0u, 1u })
    {
      constants.rayQueries = queries;
      const std::vector<std::uint32_t> words = rtg::Specialize(rtg::programs::modules[program], constants);
      EXPECT_EQ(Faults(words), "");
      const std::uint32_t capability[] = { opCapability, rayQuery };
      const auto found = std::search(words.begin(), words.end(), std::begin(capability), std::end(capability));
      EXPECT_EQ(found != words.end(), queries != 0);
    }
  }
}

// Drivers may neither fuse products and sums nor choose the order of a sum.
TEST(Specialize, LeavesNoRoundingToTheDriver)
{
  constexpr std::uint32_t opExtInst = 12, opDecorate = 71, noContraction = 42, fMix = 46, length = 66, refract = 72;
  const std::set<std::uint32_t> single = { 129, 131, 133, 136, 142 };       // OpFAdd ... OpVectorTimesScalar
  const std::set<std::uint32_t> several = { 143, 144, 145, 146, 147, 148 }; // OpMatrixTimesScalar ... OpDot
  for (std::uint32_t program = 0; program < programs; ++program)
  {
    const std::vector<std::uint32_t> words =
      rtg::Specialize(rtg::programs::modules[program], ConstantsOf({ rtg::Shape::Sphere, rtg::Shape::Mesh }, ~0u));
    std::set<std::uint32_t> decorated;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16)
    {
      const std::uint32_t code = words[at] & 0xffffu;
      if (code == opDecorate && words[at + 2] == noContraction)
      {
        decorated.insert(words[at + 1]);
      }
      EXPECT_TRUE(!single.contains(code) || decorated.contains(words[at + 2])) << code;
      EXPECT_FALSE(several.contains(code)) << code;
      const std::uint32_t function = code == opExtInst ? words[at + 4] : 0;
      EXPECT_FALSE(function == fMix || (function >= length && function <= refract)) << function;
    }
    EXPECT_GT(decorated.size(), 400u);
  }
}

TEST(Specialize, IsValidForMeshes)
{
  for (std::uint32_t program = 0; program < programs; ++program)
  {
    const rtg::programs::Code& code = rtg::programs::modules[program];
    const std::size_t plain = Bytes(code, { rtg::Shape::Mesh });
    EXPECT_LT(plain, Bytes(code, { rtg::Shape::Mesh }, ~0u));
    EXPECT_LT(plain, code.bytes);
  }
}
