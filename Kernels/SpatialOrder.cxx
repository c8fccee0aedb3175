#include "SpatialOrder.h"

#include <algorithm>
#include <future>
#include <thread>

namespace rtg
{

namespace
{

struct Entry
{
  glm::vec3 point;
  std::uint32_t index;
};

// Partitions [first, last], both included.
void Split(Entry* entries, std::size_t first, std::size_t last, int forks)
{
  while (last - first >= 2)
  {
    glm::vec3 lower = entries[first].point;
    glm::vec3 upper = lower;
    for (std::size_t i = first + 1; i <= last; ++i)
    {
      lower = glm::min(lower, entries[i].point);
      upper = glm::max(upper, entries[i].point);
    }
    const glm::vec3 extent = upper - lower;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const std::size_t middle = (first + last) / 2;
    std::nth_element(entries + first, entries + middle, entries + last + 1,
      [axis](const Entry& a, const Entry& b) { return a.point[axis] < b.point[axis]; });

    if (forks > 0)
    {
      auto lowerHalf = std::async(std::launch::async, Split, entries, first, middle, forks - 1);
      Split(entries, middle + 1, last, forks - 1);
      lowerHalf.get();
      return;
    }
    Split(entries, first, middle, 0);
    first = middle + 1;
  }
}

} // namespace

std::vector<std::uint32_t> SpatialOrder(const std::vector<glm::vec3>& points)
{
  std::vector<Entry> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    entries[i] = { points[i], static_cast<std::uint32_t>(i) };
  }
  if (entries.size() > 2)
  {
    // Threads only where a half is worth one.
    int forks = 0;
    while ((1u << forks) < std::thread::hardware_concurrency() && (points.size() >> forks) > 20000)
    {
      ++forks;
    }
    Split(entries.data(), 0, entries.size() - 1, forks);
  }
  std::vector<std::uint32_t> order(points.size());
  std::transform(
    entries.begin(), entries.end(), order.begin(), [](const Entry& e) { return e.index; });
  return order;
}

} // namespace rtg
