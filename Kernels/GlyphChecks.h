// Input that a scene refuses: device programs would read past arrays, and boxes of NaN hold nothing.
#pragma once

#include "Glyphs.h"
#include "HostDevice.h"

#include <cstddef>

namespace rtg
{

/// Throws rtg::Error unless arrays fit together, sizes, centers, rotations and exponents are what Glyphs.h says, and
/// no array has more than `most` elements.
void CheckInstances(const GlyphInstances& instances, std::size_t most);

/// Likewise of the colors of these glyphs.
void CheckColors(const GlyphInstances& instances, const GlyphColors& colors);

/// Likewise of a cut.
void CheckSection(const Section& section);
/// The slabs whose intersection is a cut's body, relative to `origin`: two planes back to back are one.
std::vector<device::SectionSlab> SlabsOf(const Section& section, const glm::dvec3& origin);

/// Likewise of periodic images.
void CheckImages(const PeriodicImages& images);

/// The same of a mesh, which may also be missing or have no triangle.
void CheckMesh(const TriangleMesh* mesh, const GlyphMotion& shutter, std::size_t most);

} // namespace rtg
