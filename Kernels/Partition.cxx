#include "Partition.h"

#include <algorithm>
#include <thread>

namespace rtg
{

std::vector<PartitionEntry> MakePartitionEntries(const std::vector<glm::vec3>& points)
{
  std::vector<PartitionEntry> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    entries[i] = { points[i], static_cast<std::uint32_t>(i) };
  }
  return entries;
}

std::vector<std::uint32_t> OrderOf(const std::vector<PartitionEntry>& entries)
{
  std::vector<std::uint32_t> order(entries.size());
  std::transform(
    entries.begin(), entries.end(), order.begin(), [](const PartitionEntry& e) { return e.index; });
  return order;
}

int PartitionAt(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last)
{
  if (last - first < 2)
  {
    return 0;
  }
  glm::vec3 lower = entries[first].point;
  glm::vec3 upper = lower;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    lower = glm::min(lower, entries[i].point);
    upper = glm::max(upper, entries[i].point);
  }
  const glm::vec3 extent = upper - lower;
  const int axis =
    extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
  std::nth_element(entries + first, entries + middle, entries + last,
    [axis](const PartitionEntry& a, const PartitionEntry& b)
    { return a.point[axis] < b.point[axis]; });
  return axis;
}

int ForksFor(std::size_t count)
{
  int forks = 0;
  while ((1u << forks) < std::thread::hardware_concurrency() && (count >> forks) > 20000)
  {
    ++forks;
  }
  return forks;
}

} // namespace rtg
