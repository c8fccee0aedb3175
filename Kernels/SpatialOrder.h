#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace rtg
{

/// A permutation of the points in which a structure that splits every range of its input at the index
/// median (first + last) / 2, as lavapipe's does (Mesa 25), becomes a kd tree over the points: each
/// range is partitioned at exactly that index along the axis in which it extends furthest.
/// Result: order[i] is the index of the point that comes i-th. Points must be finite.
std::vector<std::uint32_t> SpatialOrder(const std::vector<glm::vec3>& points);

} // namespace rtg
