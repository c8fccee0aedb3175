#pragma once

#include "Pipeline.h"
#include "Programs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// A program whose specialization constants have these values, without the branches that are then never taken and
/// without the functions that are called in these alone. Drivers inline every function before they look at constants,
/// which takes seconds for shapes that are not there. Throws rtg::Error.
std::vector<std::uint32_t> Specialize(const programs::Code& code, const Constants& constants);

} // namespace rtg
