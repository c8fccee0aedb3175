#include "Prune.h"

#include "SpirvValues.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <map>
#include <set>

namespace rtg
{

namespace
{

using namespace spirv;

/// What the constants leave of a module.
class Pruning
{
public:
  Pruning(const programs::Code& code, const Constants& constants)
    : module_(code)
    , values_(module_, constants)
    , rayQueries_(constants.rayQueries)
  {
    for (const Instruction& instruction : this->module_.global)
    {
      const bool isTrue = instruction.Code() == OpConstantTrue;
      if (isTrue || instruction.Code() == OpConstantFalse)
      {
        this->boolean_[isTrue] = instruction.Operand(2);
      }
      else if (instruction.Code() == OpTypeBool)
      {
        this->booleanType_ = instruction.Operand(1);
      }
    }
  }
  std::vector<std::uint32_t> Write();

private:
  std::uint32_t Answer(const Instruction& call, const Facts& facts) const;
  bool DeclaresRayQueries(const Instruction& instruction, std::set<std::uint32_t>& declared) const;
  void WriteGlobal(
    const Instruction& instruction, const std::set<std::uint32_t>& gone, std::vector<std::uint32_t>& words) const;
  void Write(const Function& function, const Facts& facts, std::vector<std::uint32_t>& words) const;

  Module module_;
  Values values_;
  bool rayQueries_;
  std::array<std::uint32_t, 2> boolean_{}; ///< ids of false and true; 0: the module has none
  std::uint32_t booleanType_ = 0;
};

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
  for (const std::uint32_t entry : this->module_.entries)
  {
    called[entry];
    open.insert(entry);
  }
  while (!open.empty())
  {
    const std::uint32_t id = *open.begin();
    open.erase(open.begin());
    const Function& function = *this->module_.byId.at(id);
    Called& caller = called.at(id);
    caller.facts = this->values_.Follow(function, caller.arguments);
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
          arguments.push_back(this->values_.ValueOf(instruction.Operand(i), caller.facts));
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
  for (const Function& function : this->module_.functions)
  {
    const auto found = called.find(function.begin.Operand(2));
    if (found != called.end())
    {
      this->Write(function, found->second.facts, ofFunctions);
    }
  }

  // Names and decorations of what is left out go with it.
  std::set<std::uint32_t> gone;
  for (const Function& function : this->module_.functions)
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
  std::vector<std::uint32_t> pruned(this->module_.code->words, this->module_.code->words + headerWords);
  pruned.reserve(this->module_.code->bytes / sizeof(std::uint32_t));
  // Names come before what they name.
  std::vector<Instruction> globals;
  std::copy_if(this->module_.global.begin(), this->module_.global.end(), std::back_inserter(globals),
    [&](const Instruction& instruction) { return !this->DeclaresRayQueries(instruction, gone); });
  for (const Instruction& instruction : globals)
  {
    const bool about = instruction.Code() == OpName || instruction.Code() == OpDecorate;
    if (!about || !gone.count(instruction.Operand(1)))
    {
      this->WriteGlobal(instruction, gone, pruned);
    }
  }
  pruned.insert(pruned.end(), ofFunctions.begin(), ofFunctions.end());
  return pruned;
}

// Whether nothing but ray queries needs it, which the program has not. A device that lacks them must not be told of
// them. `declared`: the ids of what does.
bool Pruning::DeclaresRayQueries(const Instruction& instruction, std::set<std::uint32_t>& declared) const
{
  if (this->rayQueries_)
  {
    return false;
  }
  switch (instruction.Code())
  {
    case OpCapability:
      return instruction.Operand(1) == CapabilityRayQueryKHR;
    case OpExtension:
      return std::strcmp(reinterpret_cast<const char*>(instruction.words + 1), "SPV_KHR_ray_query") == 0;
    case OpTypeRayQueryKHR:
    case OpTypeAccelerationStructureKHR:
      return declared.insert(instruction.Operand(1)).second;
    case OpTypePointer:
      return declared.count(instruction.Operand(3)) && declared.insert(instruction.Operand(1)).second;
    case OpVariable:
      return declared.count(instruction.Operand(1)) && declared.insert(instruction.Operand(2)).second;
    default:
      return false;
  }
}

// Constants that a driver would be asked to specialise become plain ones: validation layers optimise and check a
// program anew for each pipeline that specialises it.
void Pruning::WriteGlobal(
  const Instruction& instruction, const std::set<std::uint32_t>& gone, std::vector<std::uint32_t>& words) const
{
  const std::uint32_t code = instruction.Code();
  const bool specialised =
    code == OpSpecConstantTrue || code == OpSpecConstantFalse || code == OpSpecConstant || code == OpSpecConstantOp;
  const Value value = specialised ? this->values_.ValueOf(instruction.Operand(2), Facts()) : Value();
  if (value && instruction.Operand(1) == this->booleanType_)
  {
    words.insert(words.end(),
      { 3u << 16 | (*value ? OpConstantTrue : OpConstantFalse), instruction.Operand(1), instruction.Operand(2) });
  }
  else if (value)
  {
    words.insert(words.end(), { 4u << 16 | OpConstant, instruction.Operand(1), instruction.Operand(2), *value });
  }
  else if (code == OpEntryPoint)
  {
    // Behind the name come all global variables.
    const std::size_t at = words.size();
    const char* const name = reinterpret_cast<const char*>(instruction.words + 3);
    const std::uint32_t* const variables = instruction.words + 4 + std::strlen(name) / sizeof(std::uint32_t);
    words.insert(words.end(), instruction.words, variables);
    std::copy_if(variables, instruction.words + instruction.Count(), std::back_inserter(words),
      [&](std::uint32_t id) { return !gone.count(id); });
    words[at] = static_cast<std::uint32_t>(words.size() - at) << 16 | OpEntryPoint;
  }
  else if (code != OpDecorate || instruction.Operand(2) != DecorationSpecId)
  {
    words.insert(words.end(), instruction.words, instruction.words + instruction.Count());
  }
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
