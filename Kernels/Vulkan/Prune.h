#pragma once

#include "Pipeline.h"
#include "Programs.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// A program without the functions that its constants say are never called: of shapes that no set has, of meshes and of
/// layers. Drivers inline every function before they look at constants, which takes seconds for shapes that are not
/// there. A shape's Intersect<Name>, <Name>Normal and <Name>Enclosure must be called by Shapes/Registry.glsl alone:
/// with the shape they are cut out of programs of other shapes, too.
std::vector<std::uint32_t> Prune(const programs::Code& code, const Constants& constants);

} // namespace rtg
