// The steps that spatial sorts share.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtg
{

/// A point on its way through a sort, and where it was before.
struct PartitionEntry
{
  glm::vec3 point;
  std::uint32_t index;
};

std::vector<PartitionEntry> MakePartitionEntries(const std::vector<glm::vec3>& points);
std::vector<std::uint32_t> OrderOf(const std::vector<PartitionEntry>& entries);

/// Size of the smallest box round the points of [first, last); 0 for none.
glm::vec3 Extent(const PartitionEntry* entries, std::size_t first, std::size_t last);
int LongestAxis(const glm::vec3& extent);

/// Reorders [first, last) so that nothing in [first, middle) lies above anything in [middle, last) along the axis.
void PartitionAlong(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last, int axis);

/// How often to fork a recursion over so many points for all cores to have work worth a thread.
int ForksFor(std::size_t count);

} // namespace rtg
