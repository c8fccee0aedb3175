// Programs keep what their constants ask for, and lose the functions of shapes that no set has.
#include "Vulkan/Programs.h"
#include "Vulkan/Prune.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr std::uint32_t opName = 5, opDecorate = 71, opFunction = 54, specId = 1;

struct Contents
{
  std::set<std::uint32_t> constants;   ///< numbers of specialisation constants
  std::set<std::string> functionNames; ///< as GLSL has them
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

TEST(Prune, LeavesConstantsAndWhatIsCalled)
{
  for (int program = 0; program < 4; ++program)
  {
    const rtg::programs::Code& code = rtg::programs::ownTreesGeneration[program];
    const Contents before = Read(code.words, code.bytes / sizeof(std::uint32_t));
    EXPECT_TRUE(before.functionNames.count("NestedSuperquadricCrossing"));
    rtg::Constants constants;
    constants.shapes = 1u << static_cast<std::uint32_t>(rtg::Shape::Sphere);
    const std::vector<std::uint32_t> pruned = rtg::Prune(code, constants);
    const Contents after = Read(pruned.data(), pruned.size());
    EXPECT_EQ(after.constants, before.constants);
    EXPECT_TRUE(after.functionNames.count("SphereCrossing"));
    EXPECT_TRUE(after.functionNames.count("Traverse"));
    for (const char* name :
      { "NestedSuperquadricCrossing", "SuperquadricCrossing", "CylinderCrossing", "CrossTriangle" })
    {
      EXPECT_FALSE(after.functionNames.count(name)) << name;
    }
    EXPECT_LT(pruned.size() * sizeof(std::uint32_t), code.bytes);
  }
}
