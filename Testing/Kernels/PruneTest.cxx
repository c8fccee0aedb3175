// Programs keep what their constants ask for, and lose the functions of shapes that no set has.
#include "Shapes/List.h"
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

constexpr std::uint32_t opName = 5, opDecorate = 71, opFunction = 54, opFunctionCall = 57, specId = 1;

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

// The functions that call each function.
std::map<std::string, std::set<std::string>> Callers(const rtg::programs::Code& code)
{
  const std::size_t count = code.bytes / sizeof(std::uint32_t);
  std::map<std::uint32_t, std::string> names;
  std::map<std::string, std::set<std::string>> callers;
  std::uint32_t caller = 0;
  for (std::size_t at = 5; at < count; at += code.words[at] >> 16)
  {
    const std::uint32_t* words = code.words + at;
    switch (words[0] & 0xffffu)
    {
      case opName:
      {
        const std::string name(reinterpret_cast<const char*>(words + 2));
        names[words[1]] = name.substr(0, name.find('('));
        break;
      }
      case opFunction:
        caller = words[2];
        break;
      case opFunctionCall:
        callers[names[words[3]]].insert(names[caller]);
        break;
      default:
        break;
    }
  }
  return callers;
}

} // namespace

// What is cut out with a shape must not be called for another one.
TEST(Prune, EntriesOfShapesAreCalledByTheRegistryAlone)
{
  for (std::uint32_t program = 0; program <= rtg::probeProgram; ++program)
  {
    const auto callers = Callers(rtg::programs::ownTreesGeneration[program]);
    const auto of = [&](const std::string& function)
    {
      const auto found = callers.find(function);
      return found == callers.end() ? std::set<std::string>() : found->second;
    };
    ASSERT_FALSE(of("IntersectBox").empty());
#define RTG_ENTRIES(number, Name)                                                                                      \
  EXPECT_EQ(of("Intersect" #Name), of("IntersectBox")) << #Name;                                                       \
  EXPECT_EQ(of(#Name "Normal"), of("BoxNormal")) << #Name;                                                             \
  EXPECT_EQ(of(#Name "Enclosure"), of("BoxEnclosure")) << #Name;
    RTG_SHAPES(RTG_ENTRIES)
#undef RTG_ENTRIES
  }
}

TEST(Prune, LeavesConstantsAndWhatIsCalled)
{
  for (std::uint32_t program = 0; program <= rtg::probeProgram; ++program)
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
