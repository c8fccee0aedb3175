/**
 * The glyphs of one display as exporters write them: a few meshes, and for each the positions, rotations and sizes of
 * its copies.
 */
#ifndef GlyphTessellatedSet_h
#define GlyphTessellatedSet_h

#include "Glyphs.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rtglyphs
{

/// Copies of one mesh: scaled along its axes, turned, moved. One entry a copy in each array.
struct GlyphTessellatedPart
{
  std::string Name;
  std::shared_ptr<const rtg::TriangleMesh> Mesh;
  std::vector<std::uint32_t> Glyphs;   // the glyph that each copy belongs to
  std::vector<glm::vec3> Positions;    // relative to the set's origin
  std::vector<glm::vec4> Orientations; // unit quaternions (x, y, z, w)
  std::vector<glm::vec3> Scales;
  std::vector<glm::vec3> Velocities, Accelerations, AngularVelocities; // as in rtg::GlyphMotion; empty: none
};

struct GlyphTessellatedSet
{
  std::string Name;
  glm::dvec3 Origin{ 0.0 };
  std::vector<GlyphTessellatedPart> Parts;
  ///@{
  /// Linear red, green, blue and opacity: of each glyph, or empty for Color.
  std::vector<glm::vec4> Colors;
  glm::vec4 Color{ 1.0f };
  ///@}
  float Metallic = 0.0f, Roughness = 0.5f;

  bool IsTranslucent() const;
  const glm::vec4& ColorOf(std::uint32_t glyph) const;

  /**
   * Glyphs as their shape's parts. Those whose meshes would be more than MostMeshes are left out, as are colors that
   * change over a glyph: `messages` then says what and the remedy.
   */
  static GlyphTessellatedSet Make(const std::string& number, const rtg::GlyphInstances& instances,
    const rtg::GlyphColors& colors, const rtg::Material& material, std::vector<std::string>& messages);

  static constexpr std::size_t MostMeshes = 1000;
};

} // namespace rtglyphs

#endif
