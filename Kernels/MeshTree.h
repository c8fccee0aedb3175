// The tree of a mesh's triangles, for meshes that move: drivers know no triangles that do.
#pragma once

#include "GlyphTree.h"
#include "TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// True when its positions move in its own frame.
bool Deforms(const TriangleMesh& mesh);

/// A box round all corners of triangles between two times, in the mesh's frame; without rounding of the device's
/// arithmetic, which may displace corners by a few ulps of their way.
DoubleBox BoundsOf(const TriangleMesh& mesh, double firstTime, double lastTime);

/// A GlyphTree over triangles, all slices with the triangles in the order of the opening's middle.
struct MeshTree
{
  GlyphTree tree;
  std::vector<std::uint32_t> order; ///< place in the tree -> triangle
  glm::vec3 middle{ 0.0f };         ///< what the tree's boxes and `positions` are relative to
  float radius = 0.0f;              ///< of the ball round the middle that holds all triangles all the time
  std::vector<glm::vec3> positions;
};

/// `shutter` says when the shutter is open.
MeshTree BuildMeshTree(const TriangleMesh& mesh, const GlyphMotion& shutter);

} // namespace rtg
