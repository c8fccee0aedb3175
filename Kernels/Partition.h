// Steps common to spatial sorts.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtg
{

/// A point during a sort, and its index before. Coordinates are held as integers of the same order, so
/// that one comparison of 64 bits also orders points with the same coordinate: what a sort does then depends on
/// nothing but the points, which are finite, and many equal ones cost it no more than others.
struct PartitionEntry
{
  std::uint32_t coordinates[3];
  std::uint32_t index;

  PartitionEntry() = default;
  PartitionEntry(const glm::vec3& point, std::uint32_t i);
  glm::vec3 Point() const;
  /// Its place along an axis: unlike that of every other point.
  std::uint64_t Key(int axis) const { return std::uint64_t(this->coordinates[axis]) << 32 | this->index; }
};

std::vector<std::uint32_t> OrderOf(const PartitionEntry* entries, std::size_t count);

/// Size of the smallest box around the points of [first, last); 0 for none.
glm::vec3 Extent(const PartitionEntry* entries, std::size_t first, std::size_t last);
int LongestAxis(const glm::vec3& extent);

/// Reorders [first, last) so that nothing in [first, middle) lies above anything in [middle, last) along the axis.
void PartitionAlong(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last, int axis);

/// How often to fork a recursion over so many points for all cores to have work worth a thread.
int ForksFor(std::size_t count);

} // namespace rtg
