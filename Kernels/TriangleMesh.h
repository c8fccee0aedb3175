// Triangles as plain host data: the mesh of glyphs, or a surface among the glyphs.
#pragma once

#include "Motion.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rtg
{

///@{
/// Among values that become colors: NaN, and a missing value.
constexpr float notANumber = -1e9f, noValue = -1e12f;
///@}

/// An indexed triangle mesh in its own frame. Arrays that are not needed stay empty.
struct TriangleMesh
{
  std::vector<glm::vec3> positions;  ///< finite
  std::vector<glm::uvec3> triangles; ///< indices of positions, counter-clockwise seen from outside
  /// Unit normals: one a position (smooth), or empty (flat: the triangles' own).
  std::vector<glm::vec3> normals;
  /// RGBA8 (red in the lowest byte): one a position, interpolated, or one a triangle, or empty for the glyph's or the
  /// material's color.
  std::vector<std::uint32_t> positionColors;
  std::vector<std::uint32_t> triangleColors;
  /// Instead of both: one value a position, interpolated. From 0 to 1 they go over a table of RGBA8 colors but its last
  /// two; values below and above, -1000 and 1000 at most, have the first and the last of these. The last entry is that
  /// of noValue, the one before that of notANumber; each applies to the triangles of its corner.
  std::vector<float> positionValues;
  std::vector<std::uint32_t> valueColors;
  /// How its positions move in its own frame, one velocity and acceleration a position; no angular velocities. The
  /// shutter is that of the glyphs' own motion (GlyphInstances::motion).
  GlyphMotion motion;
};

/// Whether some of these RGBA8 colors are not opaque.
inline bool AnyTranslucent(const std::vector<std::uint32_t>& colors)
{
  return std::any_of(colors.begin(), colors.end(), [](std::uint32_t color) { return (color >> 24) != 255u; });
}

/// Whether the mesh's own colors are not all opaque.
inline bool IsTranslucent(const TriangleMesh& mesh)
{
  return AnyTranslucent(mesh.positionColors) || AnyTranslucent(mesh.triangleColors) || AnyTranslucent(mesh.valueColors);
}

/// True when they differ in colors at most.
inline bool SameShape(const TriangleMesh& a, const TriangleMesh& b)
{
  return a.positions == b.positions && a.triangles == b.triangles && a.normals == b.normals &&
    a.motion.velocities == b.motion.velocities && a.motion.accelerations == b.motion.accelerations;
}

} // namespace rtg
