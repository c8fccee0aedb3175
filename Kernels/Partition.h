// The steps that spatial sorts share.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <future>
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

/// Reorders [first, last) so that, along the axis in which it extends furthest, nothing in [first, middle) lies above
/// anything in [middle, last). Returns the axis.
int PartitionAt(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last);

/// How often to fork a recursion over so many points for all cores to have work worth a thread.
int ForksFor(std::size_t count);

/// Runs both; on two threads when asked.
template <class Left, class Right>
void ForkJoin(bool fork, Left&& left, Right&& right)
{
  if (!fork)
  {
    left();
    right();
    return;
  }
  auto other = std::async(std::launch::async, left);
  right();
  other.get();
}

} // namespace rtg
