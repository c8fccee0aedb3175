// The SPIR-V of Kernels/Programs, compiled at build time and embedded.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rtg::programs
{

struct Code
{
  std::size_t bytes;
  const std::uint32_t* words;
};

extern const Code modules[]; ///< by Specialization::program

} // namespace rtg::programs
