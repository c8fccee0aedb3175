// Programs keep what their constants ask for, and lose the rest.
#include "HostDevice.h"
#include "Vulkan/Programs.h"
#include "Vulkan/Prune.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr std::uint32_t opName = 5, opDecorate = 71, opFunction = 54, opCapability = 17, specId = 1;
constexpr std::uint32_t opTypeRayQuery = 4472, capabilityRayQuery = 4472;

struct Contents
{
  std::set<std::uint32_t> constants;   ///< numbers of specialisation constants
  std::set<std::string> functionNames; ///< as GLSL has them
  bool declaresRayQueries = false;     ///< by capability or type
};

Contents Read(const std::uint32_t* words, std::size_t count)
{
  Contents contents;
  std::set<std::uint32_t> functions;
  for (std::size_t at = 5; at < count; at += words[at] >> 16)
  {
    if ((words[at] & 0xffffu) == opFunction)
    {
      functions.insert(words[at + 2]);
    }
  }
  for (std::size_t at = 5; at < count; at += words[at] >> 16)
  {
    const std::uint32_t code = words[at] & 0xffffu;
    contents.declaresRayQueries |=
      code == opTypeRayQuery || (code == opCapability && words[at + 1] == capabilityRayQuery);
    if (code == opDecorate && words[at + 2] == specId)
    {
      contents.constants.insert(words[at + 3]);
    }
    if (code == opName && functions.count(words[at + 1]))
    {
      const std::string name(reinterpret_cast<const char*>(words + at + 2));
      contents.functionNames.insert(name.substr(0, name.find('(')));
    }
  }
  return contents;
}

} // namespace

TEST(Prune, FixesConstantsAndLeavesWhatIsCalled)
{
  for (std::uint32_t program = 0; program <= rtg::probeProgram; ++program)
  {
    const rtg::programs::Code& code = rtg::programs::modules[program];
    const Contents before = Read(code.words, code.bytes / sizeof(std::uint32_t));
    EXPECT_FALSE(before.constants.empty());
    EXPECT_TRUE(before.declaresRayQueries);
    for (const bool rayQueries : { false, true })
    {
      rtg::Constants constants;
      constants.shapes = 1u << static_cast<std::uint32_t>(rtg::Shape::Sphere);
      constants.rayQueries = rayQueries;
      const std::vector<std::uint32_t> pruned = rtg::Prune(code, constants);
      const Contents after = Read(pruned.data(), pruned.size());
      EXPECT_TRUE(after.constants.empty());
      // Devices without ray queries refuse a program that declares them.
      EXPECT_EQ(after.declaresRayQueries, rayQueries);
      EXPECT_EQ(after.functionNames.count("QueryStructure"), std::size_t(rayQueries));
      EXPECT_EQ(after.functionNames.count("Traverse"), std::size_t(!rayQueries));
      for (const char* name : { "IntersectSphere", "SphereCrossing", "EllipsoidNormal" })
      {
        EXPECT_TRUE(before.functionNames.count(name)) << name;
        EXPECT_TRUE(after.functionNames.count(name)) << name;
      }
      // One set: what it has is known, so nobody asks.
      for (const char* name : { "IntersectNestedSuperquadric", "IntersectSuperquadric", "IntersectCylinder",
             "CylinderNormal", "PolynomialNormal", "IntersectMesh", "CrossTriangle", "AddLayersOf", "ColourBetweenEnds",
             "Has", "IsOfShape" })
      {
        EXPECT_TRUE(before.functionNames.count(name)) << name;
        EXPECT_FALSE(after.functionNames.count(name)) << name;
      }
      EXPECT_LT(2 * pruned.size() * sizeof(std::uint32_t), code.bytes);
    }
  }
}

// Sets that differ are asked for what some of them have, and for no more.
TEST(Prune, AsksWhatSetsDifferIn)
{
  const rtg::programs::Code& code = rtg::programs::modules[0];
  rtg::Constants constants;
  constants.shapes =
    1u << static_cast<std::uint32_t>(rtg::Shape::Sphere) | 1u << static_cast<std::uint32_t>(rtg::Shape::Cylinder);
  constants.someHave = rtg::device::VELOCITIES;
  const std::vector<std::uint32_t> pruned = rtg::Prune(code, constants);
  const Contents after = Read(pruned.data(), pruned.size());
  for (const char* name : { "IntersectSphere", "IntersectCylinder", "Has", "IsOfShape" })
  {
    EXPECT_TRUE(after.functionNames.count(name)) << name;
  }
  for (const char* name : { "IntersectBox", "ColourBetweenEnds" })
  {
    EXPECT_FALSE(after.functionNames.count(name)) << name;
  }
}
