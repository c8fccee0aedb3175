#include "SpirvValues.h"

#include <algorithm>
#include <array>

namespace rtg::spirv
{

namespace
{

// The value of an operation by the specification, section 3.42, when what is known of its operands decides it.
Value Evaluate(std::uint32_t code, const std::array<Value, 3>& operands)
{
  const auto& [a, b, c] = operands;
  if (code == OpLogicalAnd || code == OpBitwiseAnd)
  {
    const bool zero = (a && *a == 0) || (b && *b == 0);
    return zero ? Value(0) : a && b ? Value(*a & *b) : Value();
  }
  if (code == OpLogicalOr)
  {
    const bool one = (a && *a) || (b && *b);
    return one ? Value(1) : a && b ? Value(0) : Value();
  }
  if (code == OpSelect)
  {
    return a ? (*a ? b : c) : b == c ? b : Value();
  }
  if (code == OpCopyObject)
  {
    return a;
  }
  if (code == OpLogicalNot || code == OpNot)
  {
    return a ? Value(code == OpNot ? ~*a : !*a) : Value();
  }
  if (!a || !b)
  {
    return {};
  }
  switch (code)
  {
    case OpIAdd:
      return *a + *b;
    case OpISub:
      return *a - *b;
    case OpIMul:
      return *a * *b;
    case OpLogicalEqual:
    case OpIEqual:
      return *a == *b;
    case OpLogicalNotEqual:
    case OpINotEqual:
      return *a != *b;
    case OpUGreaterThan:
      return *a > *b;
    case OpUGreaterThanEqual:
      return *a >= *b;
    case OpULessThan:
      return *a < *b;
    case OpULessThanEqual:
      return *a <= *b;
    case OpShiftRightLogical:
      return *b < 32 ? Value(*a >> *b) : Value();
    case OpShiftLeftLogical:
      return *b < 32 ? Value(*a << *b) : Value();
    case OpBitwiseOr:
      return *a | *b;
    case OpBitwiseXor:
      return *a ^ *b;
    default:
      return {};
  }
}

// Whether Evaluate() knows it.
bool IsOperation(std::uint32_t code)
{
  const std::array<Value, 3> ones{ 1, 1, 1 };
  return Evaluate(code, ones).has_value();
}

} // namespace

Values::Values(const Module& module, const Constants& constants)
  : module_(&module)
{
  const std::map<std::uint32_t, std::uint32_t> byNumber{
#define RTG_ENTRY(id, type, name) { id, constants.name },
    RTG_CONSTANTS(RTG_ENTRY)
#undef RTG_ENTRY
  };
  std::map<std::uint32_t, std::uint32_t> specialised; // by id
  for (const Instruction& instruction : module.global)
  {
    if (instruction.Code() == OpDecorate && instruction.Operand(2) == DecorationSpecId)
    {
      specialised[instruction.Operand(1)] = byNumber.at(instruction.Operand(3));
    }
    else if (const Value value = this->ReadGlobal(instruction, specialised))
    {
      this->constants_[instruction.Operand(2)] = *value;
    }
  }
  for (const Function& function : module.functions)
  {
    if (IsSimple(function))
    {
      this->simple_.insert(function.begin.Operand(2));
    }
  }
}

Value Values::ReadGlobal(
  const Instruction& instruction, const std::map<std::uint32_t, std::uint32_t>& specialised) const
{
  switch (instruction.Code())
  {
    case OpConstantTrue:
      return 1;
    case OpConstantFalse:
      return 0;
    case OpConstant:
      return instruction.Count() == 4 ? Value(instruction.Operand(3)) : Value();
    case OpSpecConstantTrue:
    case OpSpecConstantFalse:
    case OpSpecConstant:
    {
      const auto found = specialised.find(instruction.Operand(2));
      return found == specialised.end() ? Value() : found->second;
    }
    case OpSpecConstantOp:
    {
      std::array<Value, 3> operands;
      for (std::uint32_t i = 4; i < std::min(instruction.Count(), 7u); ++i)
      {
        operands[i - 4] = this->ValueOf(instruction.Operand(i), Facts());
      }
      return Evaluate(instruction.Operand(3), operands);
    }
    default:
      return {};
  }
}

Value Values::ValueOf(std::uint32_t id, const Facts& facts) const
{
  const auto constant = this->constants_.find(id);
  if (constant != this->constants_.end())
  {
    return constant->second;
  }
  const auto found = facts.values.find(id);
  return found == facts.values.end() ? Value() : found->second;
}

// Functions of arithmetic alone, like Has() and IsOfShape(), whose answer may follow from some of their arguments.
bool Values::IsSimple(const Function& function)
{
  return std::all_of(function.blocks.begin(), function.blocks.end(),
    [](const Block& block)
    {
      return std::all_of(block.instructions.begin(), block.instructions.end(),
        [](const Instruction& instruction)
        {
          const std::uint32_t opcode = instruction.Code();
          return IsOperation(opcode) || opcode == OpPhi || opcode == OpSelectionMerge || opcode == OpBranch ||
            opcode == OpBranchConditional || opcode == OpReturnValue;
        });
    });
}

Value Values::Call(const Instruction& call, const Facts& facts) const
{
  if (!this->simple_.count(call.Operand(3)))
  {
    return {};
  }
  std::vector<Value> arguments;
  for (std::uint32_t i = 4; i < call.Count(); ++i)
  {
    arguments.push_back(this->ValueOf(call.Operand(i), facts));
  }
  return this->Follow(*this->module_->byId.at(call.Operand(3)), arguments).returned;
}

// Passes add blocks until none is new; values are those of the last pass. So blocks that run at most some time are all
// found, and what is said of values holds for all of them.
Facts Values::Follow(const Function& function, const std::vector<Value>& arguments) const
{
  Facts facts;
  facts.blocks.insert(function.blocks.front().label);
  std::size_t known = 0;
  do
  {
    known = facts.blocks.size() + facts.edges.size();
    facts.values.clear();
    facts.targets.clear();
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
      if (arguments[i])
      {
        facts.values[function.parameters[i].Operand(2)] = *arguments[i];
      }
    }
    this->Pass(function, facts);
  } while (facts.blocks.size() + facts.edges.size() > known);
  if (LosesLoop(function, facts))
  {
    facts = {};
    facts.whole = true;
    for (const Block& block : function.blocks)
    {
      facts.blocks.insert(block.label);
    }
  }
  return facts;
}

// A loop that never begins anew has no place in SPIR-V; none of our programs has one. Its function stays as it is.
bool Values::LosesLoop(const Function& function, const Facts& facts)
{
  return std::any_of(function.blocks.begin(), function.blocks.end(),
    [&](const Block& block)
    {
      const Instruction* merge = block.Merge();
      return facts.blocks.count(block.label) && merge && merge->Code() == OpLoopMerge &&
        std::none_of(facts.edges.begin(), facts.edges.end(),
          [merge](const auto& edge) { return edge.second == merge->Operand(2); });
    });
}

void Values::Pass(const Function& function, Facts& facts) const
{
  facts.returned = {};
  bool returns = false;
  std::set<std::uint32_t> seen; // blocks; a branch to one of them ends a loop's turn
  for (const Block& block : function.blocks)
  {
    if (!facts.blocks.count(block.label))
    {
      continue;
    }
    seen.insert(block.label);
    const auto runs = [&](std::uint32_t target)
    {
      facts.blocks.insert(target);
      facts.edges.insert({ block.label, target });
    };
    for (const Instruction& instruction : block.instructions)
    {
      Value value;
      const std::uint32_t opcode = instruction.Code();
      if (opcode == OpPhi)
      {
        bool first = true;
        for (std::uint32_t i = 3; i + 1 < instruction.Count(); i += 2)
        {
          if (facts.edges.count({ instruction.Operand(i + 1), block.label }))
          {
            const Value incoming = this->ValueOf(instruction.Operand(i), facts);
            value = first || value == incoming ? incoming : Value();
            first = false;
          }
        }
      }
      else if (opcode == OpFunctionCall)
      {
        value = this->Call(instruction, facts);
      }
      else if (opcode == OpReturnValue)
      {
        const Value own = this->ValueOf(instruction.Operand(1), facts);
        facts.returned = !returns || facts.returned == own ? own : Value();
        returns = true;
      }
      else if (opcode == OpBranch)
      {
        runs(instruction.Operand(1));
      }
      else if (opcode == OpBranchConditional)
      {
        const Value condition = this->ValueOf(instruction.Operand(1), facts);
        const bool repeats = seen.count(instruction.Operand(2)) || seen.count(instruction.Operand(3));
        if (condition && !repeats)
        {
          facts.targets[block.label] = instruction.Operand(*condition ? 2 : 3);
          runs(facts.targets[block.label]);
        }
        else
        {
          runs(instruction.Operand(2));
          runs(instruction.Operand(3));
        }
      }
      else if (opcode == OpSwitch)
      {
        runs(instruction.Operand(2));
        for (std::uint32_t i = 4; i < instruction.Count(); i += 2)
        {
          runs(instruction.Operand(i));
        }
      }
      else if (IsOperation(opcode))
      {
        std::array<Value, 3> operands;
        for (std::uint32_t i = 3; i < std::min(instruction.Count(), 6u); ++i)
        {
          operands[i - 3] = this->ValueOf(instruction.Operand(i), facts);
        }
        value = Evaluate(opcode, operands);
      }
      if (value)
      {
        facts.values[instruction.Operand(2)] = *value;
      }
    }
  }
}

} // namespace rtg::spirv
