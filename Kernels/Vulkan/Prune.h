#pragma once

#include "Pipeline.h"
#include "Programs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// A program whose specialisation constants have these values, without the branches that they say are never taken, and
/// without the functions that are called in these alone. Drivers inline every function before they look at constants,
/// which takes seconds for shapes that are not there. Conditions are followed through arithmetic on booleans and
/// integers and through functions that have nothing else, as in Wegman and Zadeck, "Constant Propagation with
/// Conditional Branches", ACM TOPLAS 13(2), 1991. SPIRV-Tools' passes follow them within one function only: these would
/// have to be put into one first, which takes half a minute a program.
std::vector<std::uint32_t> Prune(const programs::Code& code, const Constants& constants);

} // namespace rtg
