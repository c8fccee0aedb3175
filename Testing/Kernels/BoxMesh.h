// The unit box as a mesh.
#pragma once

#include "TriangleMesh.h"

#include <memory>
#include <utility>

namespace rtg::testing
{

/// Twelve triangles, outwards, round `middle`.
inline TriangleMesh BoxMesh(const glm::vec3& middle = glm::vec3(0.0f))
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.positions.push_back(middle + glm::vec3(i & 1, (i >> 1) & 1, i >> 2) - 0.5f);
  }
  const glm::uvec4 sides[] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  for (const glm::uvec4& side : sides)
  {
    mesh.triangles.push_back({ side.x, side.y, side.z });
    mesh.triangles.push_back({ side.x, side.z, side.w });
  }
  return mesh;
}

inline std::shared_ptr<const TriangleMesh> Share(TriangleMesh mesh)
{
  return std::make_shared<TriangleMesh>(std::move(mesh));
}

} // namespace rtg::testing
