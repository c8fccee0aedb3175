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

struct ShapeCode
{
  Code intersection;     ///< a glyph is a primitive
  Code treeIntersection; ///< a set's GlyphTree is
  Code closestHit;
  Code
    whole[3]; ///< ray generation for a scene that is one set with a tree, by rtg::Program; without words: there is none
};

extern const Code imageGeneration; ///< local shading
extern const Code occlusionGeneration;
extern const Code pathGeneration;
extern const Code probeGeneration;
extern const Code nothingMiss;
extern const Code triangleClosestHit;
extern const ShapeCode shapes[]; ///< by rtg::Shape

} // namespace rtg::programs
