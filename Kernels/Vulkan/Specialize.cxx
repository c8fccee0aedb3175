#include "Pipeline.h"

#include "../Shapes/List.h"

#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace rtg
{

namespace
{

using Words = std::span<const std::uint32_t>;
constexpr std::size_t headerWords = 5;

// SPIR-V's instructions (specification 1.5, section 3.42) and their operands.
enum : std::uint32_t
{
  OpUndef = 1,
  OpName = 5,
  OpMemberName = 6,
  OpExtension = 10,
  OpEntryPoint = 15,
  OpCapability = 17,
  OpFunction = 54,
  OpFunctionCall = 57,
  OpVariable = 59,
  OpDecorate = 71,
  OpFAdd = 129,
  OpFSub = 131,
  OpFMul = 133,
  OpFDiv = 136,
  OpVectorTimesScalar = 142,
  CapabilityRayQuery = 4472,
  DecorationBlock = 2,
  DecorationNoContraction = 42
};

// Whether a program with these constants never calls a function of this name.
bool NeverCalls(std::string_view name, const Constants& constants)
{
#define RTG_LACKS(number, Name) || (name.starts_with("Intersect" #Name "(") && (constants.shapes >> number & 1u) == 0)
  return (name.starts_with("QueryStructure(") && !constants.rayQueries) ||
    (name.starts_with("WalkSets(") && constants.rayQueries) RTG_SHAPES(RTG_LACKS) RTG_LACKS(RTG_MESH, Mesh);
#undef RTG_LACKS
}

// The program with undefined values in place of calls that are never made, and without the functions that nothing else
// calls: SPIRV-Tools' passes take a quarter of the time for the rest.
std::vector<std::uint32_t> WithoutUncalled(const programs::Code& code, const Constants& constants)
{
  std::vector<Words> globals;
  std::map<std::uint32_t, std::vector<Words>> functions;
  std::vector<Words>* part = &globals;
  std::vector<std::uint32_t> reached;
  std::set<std::uint32_t> uncalled;
  const Words module(code.words, code.bytes / sizeof(std::uint32_t));
  for (std::size_t at = headerWords; at < module.size(); at += module[at] >> 16)
  {
    const Words words = module.subspan(at, module[at] >> 16);
    const std::uint32_t operation = words[0] & 0xffffu;
    const auto text = [&](std::size_t first) { return std::string_view(reinterpret_cast<const char*>(&words[first])); };
    const bool queries = (operation == OpCapability && words[1] == CapabilityRayQuery) ||
      (operation == OpExtension && text(1) == "SPV_KHR_ray_query");
    if (operation == OpName && NeverCalls(text(2), constants))
    {
      uncalled.insert(words[1]);
    }
    else if (operation == OpEntryPoint)
    {
      reached.push_back(words[2]);
    }
    else if (operation == OpFunction)
    {
      part = &functions[words[2]];
    }
    if (operation != OpName && operation != OpMemberName && (!queries || constants.rayQueries))
    {
      part->push_back(words);
    }
  }

  std::vector<std::uint32_t> bodies;
  std::unordered_set<std::uint32_t> ids; // with other operands among them
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const Words& words : functions[reached[i]])
    {
      const bool calls = (words[0] & 0xffffu) == OpFunctionCall;
      if (calls && uncalled.count(words[3]) > 0)
      {
        bodies.insert(bodies.end(), { 3u << 16 | OpUndef, words[1], words[2] });
        continue;
      }
      if (calls && std::find(reached.begin(), reached.end(), words[3]) == reached.end())
      {
        reached.push_back(words[3]);
      }
      bodies.insert(bodies.end(), words.begin(), words.end());
      ids.insert(words.size() > 2 ? words[2] : 0);
    }
  }
  for (const Words& words : globals)
  {
    ids.insert((words[0] & 0xffffu) == OpVariable ? words[2] : 0);
  }
  std::vector<std::uint32_t> all(code.words, code.words + headerWords);
  for (const Words& words : globals)
  {
    // Those without operands are of variables and values, but for Block.
    const bool ofValues = (words[0] & 0xffffu) == OpDecorate && words.size() == 3 && words[2] != DecorationBlock;
    if (!ofValues || ids.count(words[1]) > 0)
    {
      all.insert(all.end(), words.begin(), words.end());
    }
  }
  all.insert(all.end(), bodies.begin(), bodies.end());
  return all;
}

// Keeps drivers from fusing products and sums: some would, and round otherwise than others.
void DecorateArithmetic(std::vector<std::uint32_t>& words)
{
  std::vector<std::uint32_t> decorations;
  std::size_t first = 0;
  for (std::size_t at = headerWords; at < words.size(); at += words[at] >> 16)
  {
    switch (words[at] & 0xffffu)
    {
      case OpDecorate:
        first = at;
        break;
      case OpFAdd:
      case OpFSub:
      case OpFMul:
      case OpFDiv:
      case OpVectorTimesScalar:
        decorations.insert(decorations.end(), { 3u << 16 | OpDecorate, words[at + 2], DecorationNoContraction });
        break;
    }
  }
  words.insert(words.begin() + std::ptrdiff_t(first), decorations.begin(), decorations.end());
}

} // namespace

std::vector<std::uint32_t> Specialize(const programs::Code& code, const Constants& constants)
{
  // SPIRV-Tools takes words for scalars; a boolean is one word, too.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
#define RTG_VALUE_OF(id, type, name) values[id] = { constants.name };
  RTG_CONSTANTS(RTG_VALUE_OF)
#undef RTG_VALUE_OF

  std::string messages;
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  optimizer.SetMessageConsumer(
    [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) { messages += message; });
  // Conditions are followed within a function only: Has() and IsOfShape() in Programs/bindings.glsl are macros.
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
    .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
    .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
    .RegisterPass(spvtools::CreateCCPPass())
    .RegisterPass(spvtools::CreateDeadBranchElimPass())
    .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
    .RegisterPass(spvtools::CreateAggressiveDCEPass());
  // The programs are the build's own: SpecializeTest validates them.
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> words = WithoutUncalled(code, constants);
  if (!optimizer.Run(words.data(), words.size(), &words, options))
  {
    throw Error("SPIRV-Tools cannot specialize a shader: " + messages +
      ". Build the plugin with another version of SPIRV-Tools.");
  }
  DecorateArithmetic(words);
  return words;
}

} // namespace rtg
