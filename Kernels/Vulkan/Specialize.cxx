#include "Specialize.h"

#include <spirv-tools/optimizer.hpp>

#include <string>
#include <unordered_map>

namespace rtg
{

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
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(code.words, code.bytes / sizeof(std::uint32_t), &words, options))
  {
    throw Error("SPIRV-Tools cannot specialize a program of the renderer: " + messages +
      ". Build the plugin with another version of SPIRV-Tools.");
  }
  return words;
}

} // namespace rtg
