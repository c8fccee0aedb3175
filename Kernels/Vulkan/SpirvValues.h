// What the constants of a SPIR-V module decide: conditional constant propagation, function by function.
#pragma once

#include "Pipeline.h"
#include "SpirvModule.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace rtg::spirv
{

using Value = std::optional<std::uint32_t>; ///< of a bool or an integer of 32 bits; none: unknown

/// What is certain about one function.
struct Facts
{
  std::set<std::uint32_t> blocks;                          ///< labels of those that may run
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges; ///< from which to which
  std::map<std::uint32_t, std::uint32_t> values;           ///< of ids
  std::map<std::uint32_t, std::uint32_t> targets;          ///< of branches that have one left, by block
  Value returned;
  bool whole = false; ///< nothing is left out
};

class Values
{
public:
  /// Of the specialisation constants.
  Values(const Module& module, const Constants& constants);

  /// What holds in a function that is called with these arguments.
  Facts Follow(const Function& function, const std::vector<Value>& arguments) const;

  Value ValueOf(std::uint32_t id, const Facts& facts) const;

private:
  Value ReadGlobal(const Instruction& instruction, const std::map<std::uint32_t, std::uint32_t>& specialised) const;
  void Pass(const Function& function, Facts& facts) const;
  Value Call(const Instruction& call, const Facts& facts) const;
  static bool IsSimple(const Function& function);
  static bool LosesLoop(const Function& function, const Facts& facts);

  const Module* module_;
  std::set<std::uint32_t> simple_;
  std::map<std::uint32_t, std::uint32_t> constants_;
};

} // namespace rtg::spirv
