// A mesh about its middle, and the tree of its triangles.
#pragma once

#include "GlyphTree.h"
#include "TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// Boxes round a mesh's triangles between two times, which hold what motion the mesh itself has.
struct TrianglePaths
{
  const std::vector<glm::vec3>& positions; ///< of the mesh, in any frame
  const TriangleMesh& mesh;

  DoubleBox Corner(std::uint32_t corner, double first, double last) const;
  DoubleBox Triangle(std::size_t triangle, double first, double last) const;
};

/// A box round all corners of triangles between two times, in the mesh's frame; without rounding of the device's
/// arithmetic, which may displace corners by a few ulps of their displacement.
DoubleBox BoundsOf(const TriangleMesh& mesh, double firstTime, double lastTime);

/// A mesh's positions relative to its middle.
struct CenteredMesh
{
  glm::vec3 middle{ 0.0f };
  float radius = 0.0f; ///< of the ball round the middle that holds all triangles all the time
  std::vector<glm::vec3> positions;
};

/// `shutter` says when the shutter is open.
CenteredMesh Center(const TriangleMesh& mesh, const GlyphMotion& shutter);

/// A GlyphTree over triangles, all slices with the triangles in the order of the opening's middle.
struct MeshTree
{
  GlyphTree tree;                   ///< boxes are relative to the middle
  std::vector<std::uint32_t> order; ///< place in the tree -> triangle
};

MeshTree BuildMeshTree(const TriangleMesh& mesh, const CenteredMesh& centered, const GlyphMotion& shutter);

} // namespace rtg
