#include "Prune.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string>

namespace rtg
{

namespace
{

// Opcodes of the SPIR-V specification 1.5, section 3.42.
enum Opcode : std::uint32_t
{
  OpUndef = 1,
  OpName = 5,
  OpFunction = 54,
  OpFunctionParameter = 55,
  OpFunctionEnd = 56,
  OpFunctionCall = 57,
  OpStore = 62,
  OpDecorate = 71,
  OpLoopMerge = 246,
  OpSelectionMerge = 247,
  OpLabel = 248,
  OpBranch = 249,
  OpBranchConditional = 250,
  OpSwitch = 251,
  OpReturn = 253,
  OpReturnValue = 254
};

constexpr std::size_t headerWords = 5;
constexpr std::size_t boundAt = 3; ///< in the header: all ids are below

struct Instruction
{
  const std::uint32_t* words;
  std::uint32_t Code() const { return this->words[0] & 0xffffu; }
  std::uint32_t Count() const { return this->words[0] >> 16; }
  std::uint32_t Operand(std::uint32_t i) const { return this->words[i]; }
};

// A function as it stands in the module.
struct Function
{
  std::uint32_t type, id;
  std::vector<Instruction> instructions;
  std::vector<std::uint32_t> calls;
  bool stub = false; ///< it is called only where it never runs
};

// Names of the functions that are never called; such functions return something.
std::set<std::string> NeverCalled(const Constants& constants)
{
  std::set<std::string> names;
  const auto leaveOut = [&](bool used, std::initializer_list<const char*> functions)
  {
    if (!used)
    {
      names.insert(functions.begin(), functions.end());
    }
  };
#define RTG_FUNCTIONS(number, Name)                                                                                    \
  leaveOut((constants.shapes >> number & 1u) != 0, { "Intersect" #Name, #Name "Enclosure", #Name "Normal" });
  RTG_SHAPES(RTG_FUNCTIONS)
#undef RTG_FUNCTIONS
  leaveOut(
    (constants.shapes >> RTG_MESH & 1u) != 0, { "IntersectMesh", "EstimateMesh", "HitOnMesh", "TriangleColour" });
  leaveOut(constants.layered != 0, { "AddLayersOf" });
  leaveOut((constants.someHave & device::END_COLOURS) != 0, { "ColourBetweenEnds" });
  leaveOut((constants.someHave & (device::BEFORE | device::AFTER)) != 0, { "IsInner" });
  leaveOut((constants.someHave & device::SIGN_COLOURS) != 0, { "PolynomialIsNegative" });
  return names;
}

// What a function is called in GLSL.
std::string NameOf(const Instruction& name)
{
  const auto* text = reinterpret_cast<const char*>(name.words + 2);
  const std::string whole(text, strnlen(text, 4 * (name.Count() - 2)));
  return whole.substr(0, whole.find('('));
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
    case OpFunctionEnd:
      return 0;
    default:
      return instruction.Count() > 2 ? instruction.Operand(2) : 0;
  }
}

} // namespace

std::vector<std::uint32_t> Prune(const programs::Code& code, const Constants& constants)
{
  const std::size_t size = code.bytes / sizeof(std::uint32_t);
  const std::set<std::string> neverCalled = NeverCalled(constants);
  std::vector<Instruction> global;
  std::vector<Function> functions;
  std::set<std::uint32_t> stubs;
  for (std::size_t at = headerWords; at < size;)
  {
    const Instruction instruction{ code.words + at };
    at += instruction.Count();
    if (instruction.Code() == OpName && neverCalled.count(NameOf(instruction)))
    {
      stubs.insert(instruction.Operand(1));
    }
    if (instruction.Code() == OpFunction)
    {
      functions.push_back({ instruction.Operand(1), instruction.Operand(2), {}, {} });
      functions.back().stub = stubs.count(instruction.Operand(2)) != 0;
    }
    if (functions.empty())
    {
      global.push_back(instruction);
      continue;
    }
    functions.back().instructions.push_back(instruction);
    if (instruction.Code() == OpFunctionCall)
    {
      functions.back().calls.push_back(instruction.Operand(3));
    }
  }

  // What is called, beginning with what nobody calls but the driver: the entry is the function named main.
  std::map<std::uint32_t, const Function*> byId;
  for (const Function& function : functions)
  {
    byId[function.id] = &function;
  }
  std::set<std::uint32_t> called;
  std::vector<std::uint32_t> open;
  for (const Instruction& instruction : global)
  {
    if (instruction.Code() == OpName && byId.count(instruction.Operand(1)) && NameOf(instruction) == "main")
    {
      open.push_back(instruction.Operand(1));
    }
  }
  while (!open.empty())
  {
    const Function& function = *byId.at(open.back());
    open.pop_back();
    if (called.insert(function.id).second && !function.stub)
    {
      open.insert(open.end(), function.calls.begin(), function.calls.end());
    }
  }

  // Names and decorations of what is left out go with it.
  const auto kept = [&](const Function& function, const Instruction& instruction)
  {
    return called.count(function.id) &&
      (!function.stub || instruction.Code() == OpFunction || instruction.Code() == OpFunctionParameter);
  };
  std::vector<bool> gone(code.words[boundAt], false);
  for (const Function& function : functions)
  {
    for (const Instruction& instruction : function.instructions)
    {
      if (!kept(function, instruction))
      {
        gone[ResultOf(instruction)] = true;
      }
    }
  }

  std::vector<std::uint32_t> pruned(code.words, code.words + headerWords);
  pruned.reserve(size);
  const auto append = [&](const Instruction& instruction)
  { pruned.insert(pruned.end(), instruction.words, instruction.words + instruction.Count()); };
  for (const Instruction& instruction : global)
  {
    const bool about = instruction.Code() == OpName || instruction.Code() == OpDecorate;
    if (!about || !gone[instruction.Operand(1)])
    {
      append(instruction);
    }
  }
  for (const Function& function : functions)
  {
    for (const Instruction& instruction : function.instructions)
    {
      if (kept(function, instruction))
      {
        append(instruction);
      }
    }
    if (function.stub && called.count(function.id))
    {
      const std::uint32_t label = pruned[boundAt]++;
      const std::uint32_t undefined = pruned[boundAt]++;
      pruned.insert(pruned.end(),
        { 2u << 16 | OpLabel, label, 3u << 16 | OpUndef, function.type, undefined, 2u << 16 | OpReturnValue, undefined,
          1u << 16 | OpFunctionEnd });
    }
  }
  return pruned;
}

} // namespace rtg
