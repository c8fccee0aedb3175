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

/// Ray generation, by Generation::program.
extern const Code drivenGeneration[];   ///< the driver traverses its structure
extern const Code ownTreesGeneration[]; ///< they walk the trees of all sets
extern const Code nothingMiss;
extern const Code triangleClosestHit;
/// Glyphs as boxes of the driver's structure: analytic ones, and those that are copies of a mesh with a tree.
extern const Code glyphIntersection, glyphClosestHit;
extern const Code meshIntersection, meshClosestHit;

} // namespace rtg::programs
