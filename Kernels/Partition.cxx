#include "Partition.h"

#include "Parallel.h"

#include <algorithm>

namespace rtg
{

namespace
{

// Order-preserving: negative floats have all bits flipped, others the sign.
std::uint32_t ToInteger(float value)
{
  const std::uint32_t bits = glm::floatBitsToUint(value);
  return bits ^ ((bits >> 31) ? 0xffffffffu : 0x80000000u);
}

float ToFloat(std::uint32_t integer)
{
  return glm::uintBitsToFloat(integer ^ ((integer >> 31) ? 0x80000000u : 0xffffffffu));
}

} // namespace

PartitionEntry::PartitionEntry(const glm::vec3& point, std::uint32_t i)
  // + 0: the zeros are one.
  : coordinates{ ToInteger(point.x + 0.0f), ToInteger(point.y + 0.0f), ToInteger(point.z + 0.0f) }
  , index(i)
{
}

glm::vec3 PartitionEntry::Point() const
{
  return { ToFloat(this->coordinates[0]), ToFloat(this->coordinates[1]), ToFloat(this->coordinates[2]) };
}

std::vector<std::uint32_t> OrderOf(const PartitionEntry* entries, std::size_t count)
{
  std::vector<std::uint32_t> order(count);
  ParallelEach(count, [&](std::size_t i) { order[i] = entries[i].index; });
  return order;
}

glm::vec3 Extent(const PartitionEntry* entries, std::size_t first, std::size_t last)
{
  if (first >= last)
  {
    return glm::vec3(0.0f);
  }
  glm::vec3 extent;
  std::uint32_t lower[3], upper[3];
  std::copy_n(entries[first].coordinates, 3, lower);
  std::copy_n(lower, 3, upper);
  for (std::size_t i = first + 1; i < last; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], entries[i].coordinates[axis]);
      upper[axis] = std::max(upper[axis], entries[i].coordinates[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[axis] = ToFloat(upper[axis]) - ToFloat(lower[axis]);
  }
  return extent;
}

int LongestAxis(const glm::vec3& extent)
{
  return extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
}

void PartitionAlong(PartitionEntry* entries, std::size_t first, std::size_t middle, std::size_t last, int axis)
{
  if (last - first < 2 || middle == first || middle == last)
  {
    return;
  }
  std::nth_element(entries + first, entries + middle, entries + last,
    [axis](const PartitionEntry& a, const PartitionEntry& b) { return a.Key(axis) < b.Key(axis); });
}

int ForksFor(std::size_t count)
{
  // Some more parts than threads: parts are never equally fast.
  int forks = 0;
  while ((std::size_t(1) << forks) < 4 * ThreadCount() && (count >> forks) > 20000)
  {
    ++forks;
  }
  return ThreadCount() > 1 ? forks : 0;
}

} // namespace rtg
