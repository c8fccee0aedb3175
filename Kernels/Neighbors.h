// Glyphs and triangles that another process needs because they lie near its own, serialized.
#pragma once

#include "Box.h"
#include "Glyphs.h"

#include <vector>

namespace rtg
{

/// Packs the glyphs of a set whose boxes (GlyphBoxes()) touch `region`, which is in world coordinates; of a surface,
/// which is a single mesh, the triangles. Empty: there are none. The bytes are for processes with the same byte order.
std::vector<char> PackNear(
  const GlyphInstances& instances, const GlyphColors& colors, const std::vector<Box>& boxes, const DoubleBox& region);

/// Unpacks PackNear()'s bytes. Throws rtg::Error where the bytes end too early.
void Unpack(const std::vector<char>& bytes, GlyphInstances& instances, GlyphColors& colors);

/// A box round all glyphs of a set, in world coordinates; `boxes` as above.
DoubleBox BoundsOf(const GlyphInstances& instances, const std::vector<Box>& boxes);

} // namespace rtg
