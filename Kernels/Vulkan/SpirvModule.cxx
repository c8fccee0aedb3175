#include "SpirvModule.h"

namespace rtg::spirv
{

Module::Module(const programs::Code& c)
  : code(&c)
{
  const std::size_t size = c.bytes / sizeof(std::uint32_t);
  bool inFunction = false;
  for (std::size_t at = headerWords; at < size;)
  {
    const Instruction instruction{ c.words + at };
    at += instruction.Count();
    const std::uint32_t opcode = instruction.Code();
    if (opcode == OpFunction)
    {
      inFunction = true;
      this->functions.push_back({ instruction, {}, {}, {} });
    }
    else if (!inFunction)
    {
      if (opcode == OpEntryPoint)
      {
        this->entries.push_back(instruction.Operand(2));
      }
      this->global.push_back(instruction);
    }
    else if (opcode == OpFunctionParameter)
    {
      this->functions.back().parameters.push_back(instruction);
    }
    else if (opcode == OpLabel)
    {
      this->functions.back().blocks.push_back({ instruction.Operand(1), {} });
    }
    else if (opcode == OpFunctionEnd)
    {
      this->functions.back().end = instruction;
    }
    else
    {
      this->functions.back().blocks.back().instructions.push_back(instruction);
    }
  }
  for (const Function& function : this->functions)
  {
    this->byId[function.begin.Operand(2)] = &function;
  }
}

std::uint32_t ResultOf(const Instruction& instruction)
{
  switch (instruction.Code())
  {
    case OpLabel:
      return instruction.Operand(1);
    case OpStore:
    case OpLoopMerge:
    case OpSelectionMerge:
    case OpBranch:
    case OpBranchConditional:
    case OpSwitch:
    case OpReturn:
    case OpReturnValue:
    case OpUnreachable:
    case OpFunctionEnd:
    case OpRayQueryInitializeKHR:
    case OpRayQueryGenerateIntersectionKHR:
    case OpRayQueryConfirmIntersectionKHR:
      return 0;
    default:
      return instruction.Count() > 2 ? instruction.Operand(2) : 0;
  }
}

} // namespace rtg::spirv
