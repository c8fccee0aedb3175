#include "SpatialOrder.h"

#include "Parallel.h"
#include "Partition.h"

namespace rtg
{

namespace
{

// [first, last], both included, as lavapipe counts.
void Split(PartitionEntry* entries, std::size_t first, std::size_t last, int forks)
{
  if (last - first < 2)
  {
    return;
  }
  const std::size_t middle = (first + last) / 2;
  PartitionAlong(entries, first, middle + 1, last + 1, LongestAxis(Extent(entries, first, last + 1)));
  ParallelInvoke(
    forks > 0, [=] { Split(entries, first, middle, forks - 1); }, [=] { Split(entries, middle + 1, last, forks - 1); });
}

} // namespace

std::vector<std::uint32_t> SpatialOrder(const std::vector<glm::vec3>& points)
{
  std::vector<PartitionEntry> entries = MakePartitionEntries(points);
  if (!entries.empty())
  {
    Split(entries.data(), 0, entries.size() - 1, ForksFor(entries.size()));
  }
  return OrderOf(entries);
}

} // namespace rtg
