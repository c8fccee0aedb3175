#include "Prune.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace rtg
{

namespace
{

// Opcodes of the SPIR-V specification 1.5, section 3.42.
enum Opcode : std::uint32_t
{
  OpName = 5,
  OpEntryPoint = 15,
  OpTypeBool = 20,
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
  OpUnreachable = 255
};

constexpr std::uint32_t specId = 1; // a decoration
constexpr std::size_t headerWords = 5;
constexpr std::size_t boundAt = 3; ///< in the header: all ids are below

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

using Value = std::optional<std::uint32_t>; ///< of a bool or an integer of 32 bits; none: unknown

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

// The id that an instruction of a function defines, or 0.
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
      return 0;
    default:
      return instruction.Count() > 2 ? instruction.Operand(2) : 0;
  }
}

/// What the constants leave of a module.
class Pruning
{
public:
  Pruning(const programs::Code& code, const Constants& constants);
  std::vector<std::uint32_t> Write();

private:
  // What is certain about one function.
  struct Facts
  {
    std::set<std::uint32_t> blocks;                          ///< labels of those that may run
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges; ///< from which to which
    std::map<std::uint32_t, std::uint32_t> values;           ///< of ids
    std::map<std::uint32_t, std::uint32_t> targets;          ///< of branches that have one left, by block
    Value returned;
    bool whole = false; ///< nothing is left out
  };

  void ReadGlobal(const Instruction& instruction, const std::map<std::uint32_t, std::uint32_t>& specialised);
  Value ValueOf(std::uint32_t id, const Facts& facts) const;
  Value ValueOf(const Instruction& instruction, const Facts& facts, std::uint32_t firstOperand) const;
  Facts Follow(const Function& function, const std::vector<Value>& arguments) const;
  void Pass(const Function& function, Facts& facts) const;
  Value Call(const Instruction& call, const Facts& facts) const;
  static bool IsSimple(const Function& function);
  static bool LosesLoop(const Function& function, const Facts& facts);
  std::uint32_t Answer(const Instruction& call, const Facts& facts) const;
  void Write(const Function& function, const Facts& facts, std::vector<std::uint32_t>& words) const;

  const programs::Code* code_;
  std::vector<Instruction> global_;
  std::vector<Function> functions_;
  std::map<std::uint32_t, const Function*> byId_;
  std::set<std::uint32_t> simple_;
  std::map<std::uint32_t, std::uint32_t> constants_;
  std::vector<std::uint32_t> entries_;
  std::array<std::uint32_t, 2> boolean_{}; ///< ids of false and true; 0: the module has none
  std::uint32_t booleanType_ = 0;
};

Pruning::Pruning(const programs::Code& code, const Constants& constants)
  : code_(&code)
{
  const std::map<std::uint32_t, std::uint32_t> specialised{
#define RTG_ENTRY(id, type, name) { id, constants.name },
    RTG_CONSTANTS(RTG_ENTRY)
#undef RTG_ENTRY
  };
  std::map<std::uint32_t, std::uint32_t> byId; // those of ids that are specialised
  const std::size_t size = code.bytes / sizeof(std::uint32_t);
  bool inFunction = false;
  for (std::size_t at = headerWords; at < size;)
  {
    const Instruction instruction{ code.words + at };
    at += instruction.Count();
    const std::uint32_t opcode = instruction.Code();
    if (opcode == OpFunction)
    {
      inFunction = true;
      this->functions_.push_back({ instruction, {}, {}, {} });
    }
    else if (!inFunction)
    {
      if (opcode == OpDecorate && instruction.Operand(2) == specId)
      {
        byId[instruction.Operand(1)] = specialised.at(instruction.Operand(3));
      }
      this->global_.push_back(instruction);
      this->ReadGlobal(instruction, byId);
    }
    else if (opcode == OpFunctionParameter)
    {
      this->functions_.back().parameters.push_back(instruction);
    }
    else if (opcode == OpLabel)
    {
      this->functions_.back().blocks.push_back({ instruction.Operand(1), {} });
    }
    else if (opcode == OpFunctionEnd)
    {
      this->functions_.back().end = instruction;
    }
    else
    {
      this->functions_.back().blocks.back().instructions.push_back(instruction);
    }
  }
  for (const Function& function : this->functions_)
  {
    this->byId_[function.begin.Operand(2)] = &function;
    if (IsSimple(function))
    {
      this->simple_.insert(function.begin.Operand(2));
    }
  }
}

void Pruning::ReadGlobal(const Instruction& instruction, const std::map<std::uint32_t, std::uint32_t>& specialised)
{
  Value value;
  switch (instruction.Code())
  {
    case OpEntryPoint:
      this->entries_.push_back(instruction.Operand(2));
      return;
    case OpConstantTrue:
    case OpConstantFalse:
      value = instruction.Code() == OpConstantTrue;
      this->boolean_[*value] = instruction.Operand(2);
      this->booleanType_ = instruction.Operand(1);
      break;
    case OpConstant:
      value = instruction.Count() == 4 ? Value(instruction.Operand(3)) : Value();
      break;
    case OpSpecConstantTrue:
    case OpSpecConstantFalse:
    case OpSpecConstant:
    {
      const auto found = specialised.find(instruction.Operand(2));
      value = found == specialised.end() ? Value() : found->second;
      break;
    }
    case OpSpecConstantOp:
    {
      std::array<Value, 3> operands;
      for (std::uint32_t i = 4; i < std::min(instruction.Count(), 7u); ++i)
      {
        operands[i - 4] = this->ValueOf(instruction.Operand(i), Facts());
      }
      value = Evaluate(instruction.Operand(3), operands);
      break;
    }
    default:
      return;
  }
  if (value)
  {
    this->constants_[instruction.Operand(2)] = *value;
  }
}

Value Pruning::ValueOf(std::uint32_t id, const Facts& facts) const
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
bool Pruning::IsSimple(const Function& function)
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

Value Pruning::Call(const Instruction& call, const Facts& facts) const
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
  return this->Follow(*this->byId_.at(call.Operand(3)), arguments).returned;
}

// Passes add blocks until none is new; values are those of the last pass. So blocks that run at most some time are all
// found, and what is said of values holds for all of them.
Pruning::Facts Pruning::Follow(const Function& function, const std::vector<Value>& arguments) const
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
bool Pruning::LosesLoop(const Function& function, const Facts& facts)
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

void Pruning::Pass(const Function& function, Facts& facts) const
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

std::vector<std::uint32_t> Pruning::Write()
{
  // What is called, beginning with what the driver calls. A parameter that is the same wherever its function is called
  // is known in it.
  struct Called
  {
    std::vector<Value> arguments;
    Facts facts;
  };
  std::map<std::uint32_t, Called> called;
  std::set<std::uint32_t> open;
  for (const std::uint32_t entry : this->entries_)
  {
    called[entry];
    open.insert(entry);
  }
  while (!open.empty())
  {
    const std::uint32_t id = *open.begin();
    open.erase(open.begin());
    const Function& function = *this->byId_.at(id);
    Called& caller = called.at(id);
    caller.facts = this->Follow(function, caller.arguments);
    for (const Block& block : function.blocks)
    {
      for (const Instruction& instruction : block.instructions)
      {
        if (!caller.facts.blocks.count(block.label) || instruction.Code() != OpFunctionCall ||
          this->Answer(instruction, caller.facts))
        {
          continue;
        }
        std::vector<Value> arguments;
        for (std::uint32_t i = 4; i < instruction.Count(); ++i)
        {
          arguments.push_back(this->ValueOf(instruction.Operand(i), caller.facts));
        }
        const auto [found, isNew] = called.insert({ instruction.Operand(3), { arguments, {} } });
        bool changed = isNew;
        for (std::size_t i = 0; i < arguments.size(); ++i)
        {
          Value& known = found->second.arguments[i];
          changed = changed || (known && known != arguments[i]);
          known = known == arguments[i] ? known : Value();
        }
        if (changed)
        {
          open.insert(instruction.Operand(3));
        }
      }
    }
  }

  std::vector<std::uint32_t> ofFunctions;
  for (const Function& function : this->functions_)
  {
    const auto found = called.find(function.begin.Operand(2));
    if (found != called.end())
    {
      this->Write(function, found->second.facts, ofFunctions);
    }
  }

  // Names and decorations of what is left out go with it.
  std::set<std::uint32_t> gone;
  for (const Function& function : this->functions_)
  {
    gone.insert(function.begin.Operand(2));
    for (const Instruction& parameter : function.parameters)
    {
      gone.insert(parameter.Operand(2));
    }
    for (const Block& block : function.blocks)
    {
      gone.insert(block.label);
      for (const Instruction& instruction : block.instructions)
      {
        gone.insert(ResultOf(instruction));
      }
    }
  }
  for (std::size_t at = 0; at < ofFunctions.size(); at += ofFunctions[at] >> 16)
  {
    gone.erase(ResultOf({ &ofFunctions[at] }));
  }
  std::vector<std::uint32_t> pruned(this->code_->words, this->code_->words + headerWords);
  pruned.reserve(this->code_->bytes / sizeof(std::uint32_t));
  for (const Instruction& instruction : this->global_)
  {
    const bool about = instruction.Code() == OpName || instruction.Code() == OpDecorate;
    if (!about || !gone.count(instruction.Operand(1)))
    {
      pruned.insert(pruned.end(), instruction.words, instruction.words + instruction.Count());
    }
  }
  pruned.insert(pruned.end(), ofFunctions.begin(), ofFunctions.end());
  return pruned;
}

// The id of a constant that a call may be replaced by; 0: there is none.
std::uint32_t Pruning::Answer(const Instruction& call, const Facts& facts) const
{
  const auto found = facts.values.find(call.Operand(2));
  const bool known = found != facts.values.end() && call.Operand(1) == this->booleanType_ && found->second < 2;
  return known ? this->boolean_[found->second] : 0;
}

void Pruning::Write(const Function& function, const Facts& facts, std::vector<std::uint32_t>& words) const
{
  const auto append = [&](const Instruction& instruction)
  { words.insert(words.end(), instruction.words, instruction.words + instruction.Count()); };
  append(function.begin);
  std::for_each(function.parameters.begin(), function.parameters.end(), append);
  // Structures must have an end, also one that is never reached.
  std::set<std::uint32_t> ends;
  for (const Block& block : function.blocks)
  {
    if (!facts.blocks.count(block.label))
    {
      continue;
    }
    const Instruction* merge = block.Merge();
    if (merge && !(facts.targets.count(block.label) && merge->Code() == OpSelectionMerge))
    {
      ends.insert(merge->Operand(1));
    }
  }
  for (const Block& block : function.blocks)
  {
    const bool runs = facts.blocks.count(block.label) != 0;
    if (runs || ends.count(block.label))
    {
      words.insert(words.end(), { 2u << 16 | OpLabel, block.label });
    }
    if (!runs)
    {
      if (ends.count(block.label))
      {
        words.push_back(1u << 16 | OpUnreachable);
      }
      continue;
    }
    const auto target = facts.targets.find(block.label);
    for (const Instruction& instruction : block.instructions)
    {
      if (instruction.Code() == OpPhi && !facts.whole)
      {
        const std::size_t at = words.size();
        words.insert(words.end(), instruction.words, instruction.words + 3);
        for (std::uint32_t i = 3; i + 1 < instruction.Count(); i += 2)
        {
          if (facts.edges.count({ instruction.Operand(i + 1), block.label }))
          {
            words.insert(words.end(), instruction.words + i, instruction.words + i + 2);
          }
        }
        words[at] = static_cast<std::uint32_t>(words.size() - at) << 16 | OpPhi;
      }
      else if (instruction.Code() == OpFunctionCall && this->Answer(instruction, facts))
      {
        words.insert(words.end(),
          { 4u << 16 | OpCopyObject, instruction.Operand(1), instruction.Operand(2),
            this->Answer(instruction, facts) });
      }
      else if (target != facts.targets.end() && &instruction == &block.Last())
      {
        words.insert(words.end(), { 2u << 16 | OpBranch, target->second });
      }
      else if (target == facts.targets.end() || instruction.Code() != OpSelectionMerge)
      {
        append(instruction);
      }
    }
  }
  append(function.end);
}

} // namespace

std::vector<std::uint32_t> Prune(const programs::Code& code, const Constants& constants)
{
  return Pruning(code, constants).Write();
}

} // namespace rtg
