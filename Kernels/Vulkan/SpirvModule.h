// A SPIR-V module as lists of its instructions.
#pragma once

#include "Programs.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace rtg::spirv
{

/// Those that Prune() looks at; numbers of the SPIR-V specification 1.5, section 3.42.
enum Opcode : std::uint32_t
{
  OpName = 5,
  OpExtension = 10,
  OpEntryPoint = 15,
  OpCapability = 17,
  OpTypeBool = 20,
  OpTypePointer = 32,
  OpConstantTrue = 41,
  OpConstantFalse = 42,
  OpConstant = 43,
  OpSpecConstantTrue = 48,
  OpSpecConstantFalse = 49,
  OpSpecConstant = 50,
  OpSpecConstantOp = 52,
  OpFunction = 54,
  OpFunctionParameter = 55,
  OpFunctionEnd = 56,
  OpFunctionCall = 57,
  OpVariable = 59,
  OpStore = 62,
  OpDecorate = 71,
  OpCopyObject = 83,
  OpIAdd = 128,
  OpISub = 130,
  OpIMul = 132,
  OpLogicalEqual = 164,
  OpLogicalNotEqual = 165,
  OpLogicalOr = 166,
  OpLogicalAnd = 167,
  OpLogicalNot = 168,
  OpSelect = 169,
  OpIEqual = 170,
  OpINotEqual = 171,
  OpUGreaterThan = 172,
  OpUGreaterThanEqual = 174,
  OpULessThan = 176,
  OpULessThanEqual = 178,
  OpShiftRightLogical = 194,
  OpShiftLeftLogical = 196,
  OpBitwiseOr = 197,
  OpBitwiseXor = 198,
  OpBitwiseAnd = 199,
  OpNot = 200,
  OpPhi = 245,
  OpLoopMerge = 246,
  OpSelectionMerge = 247,
  OpLabel = 248,
  OpBranch = 249,
  OpBranchConditional = 250,
  OpSwitch = 251,
  OpReturn = 253,
  OpReturnValue = 254,
  OpUnreachable = 255,
  OpTypeRayQueryKHR = 4472,
  OpRayQueryInitializeKHR = 4473,
  OpRayQueryGenerateIntersectionKHR = 4475,
  OpRayQueryConfirmIntersectionKHR = 4476,
  OpTypeAccelerationStructureKHR = 5341
};

constexpr std::uint32_t CapabilityRayQueryKHR = 4472; ///< section 3.31

constexpr std::uint32_t DecorationSpecId = 1; ///< section 3.20: the number of a specialisation constant

/// One in its module, which must stay.
struct Instruction
{
  const std::uint32_t* words;
  std::uint32_t Code() const { return this->words[0] & 0xffffu; }
  std::uint32_t Count() const { return this->words[0] >> 16; }
  std::uint32_t Operand(std::uint32_t i) const { return this->words[i]; }
};

struct Block
{
  std::uint32_t label;
  std::vector<Instruction> instructions; ///< behind the label
  const Instruction& Last() const { return this->instructions.back(); }
  /// The merge instruction before the last one; null: it has none.
  const Instruction* Merge() const
  {
    const std::size_t count = this->instructions.size();
    const Instruction* before = count < 2 ? nullptr : &this->instructions[count - 2];
    return before && (before->Code() == OpLoopMerge || before->Code() == OpSelectionMerge) ? before : nullptr;
  }
};

struct Function
{
  Instruction begin;
  std::vector<Instruction> parameters;
  std::vector<Block> blocks;
  Instruction end;
};

constexpr std::size_t headerWords = 5;

struct Module
{
  explicit Module(const programs::Code& code);

  const programs::Code* code;
  std::vector<Instruction> global; ///< before the functions
  std::vector<Function> functions;
  std::map<std::uint32_t, const Function*> byId;
  std::vector<std::uint32_t> entries; ///< functions that the driver calls
};

/// The id that an instruction of a function defines, or 0.
std::uint32_t ResultOf(const Instruction& instruction);

} // namespace rtg::spirv
