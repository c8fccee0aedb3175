#include "Partition.h"

#include "Parallel.h"

#include <algorithm>

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
  std::transform(entries.begin(), entries.end(), order.begin(), [](const PartitionEntry& e) { return e.index; });
  return order;
}

glm::vec3 Extent(const PartitionEntry* entries, std::size_t first, std::size_t last)
{
  if (first >= last)
  {
    return glm::vec3(0.0f);
  }
  glm::vec3 lower = entries[first].point;
  glm::vec3 upper = lower;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    lower = glm::min(lower, entries[i].point);
    upper = glm::max(upper, entries[i].point);
  }
  return upper - lower;
}

int LongestAxis(const glm::vec3& extent)
{
  return extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
}

void PartitionAlong(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last, int axis)
{
  if (last - first < 2)
  {
    return;
  }
  std::nth_element(entries + first, entries + middle, entries + last,
    [axis](const PartitionEntry& a, const PartitionEntry& b) { return a.point[axis] < b.point[axis]; });
}

int ForksFor(std::size_t count)
{
  int forks = 0;
  while ((std::size_t(1) << forks) < ThreadCount() && (count >> forks) > 20000)
  {
    ++forks;
  }
  return forks;
}

} // namespace rtg
