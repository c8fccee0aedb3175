#include "Partition.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace rtg
{

namespace
{

// Order-preserving: negative floats have all bits flipped, others the sign.
std::uint32_t ToInteger(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits ^ ((bits >> 31) ? 0xffffffffu : 0x80000000u);
}

float ToFloat(std::uint32_t integer)
{
  const std::uint32_t bits = integer ^ ((integer >> 31) ? 0x80000000u : 0xffffffffu);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// Moves entries whose key is less than the pivot before all others; returns the first of these. Without branches on
// what is compared: at random half of them would be predicted wrong, which costs more than the moves.
template <int Axis>
PartitionEntry* SplitBelow(PartitionEntry* first, PartitionEntry* last, std::uint64_t pivot)
{
  for (PartitionEntry* at = first; at != last; ++at)
  {
    const PartitionEntry entry = *at;
    *at = *first;
    *first = entry;
    first += entry.Key(Axis) < pivot;
  }
  return first;
}

// The key that about so many of the range lie below, from a sample spread over it.
template <int Axis>
std::uint64_t Pivot(const PartitionEntry* first, std::size_t count, double below)
{
  std::uint64_t sample[128];
  const std::size_t size = std::clamp<std::size_t>(count / 16, 16, std::size(sample));
  for (std::size_t i = 0; i < size; ++i)
  {
    sample[i] = first[i * count / size].Key(Axis);
  }
  const auto rank = static_cast<std::ptrdiff_t>(below / double(count) * double(size));
  std::uint64_t* const pivot = sample + std::clamp<std::ptrdiff_t>(rank, 0, size - 1);
  std::nth_element(sample, pivot, sample + size);
  return *pivot;
}

// Selection with pivots from samples, a little beyond the wanted rank so that the larger part falls away each time
// (after Floyd and Rivest, "Expected time bounds for selection", Communications of the ACM 18(3), 1975).
template <int Axis>
void Select(PartitionEntry* first, PartitionEntry* middle, PartitionEntry* last)
{
  constexpr std::ptrdiff_t few = 256;
  // Where samples fail again and again, on points in an unlucky order, the library's algorithm is left.
  for (int tries = 0; last - first > few && tries < 64; ++tries)
  {
    const double count = double(last - first), below = double(middle - first);
    // About one standard deviation of the sample's rank.
    const double beyond = std::sqrt(below * (count - below) / std::clamp(count / 16.0, 16.0, 128.0)) + 0.002 * count;
    const std::uint64_t pivot = Pivot<Axis>(first, last - first, 2.0 * below < count ? below + beyond : below - beyond);
    PartitionEntry* const split = SplitBelow<Axis>(first, last, pivot);
    if (split == first)
    {
      break;
    }
    (split <= middle ? first : last) = split;
  }
  std::nth_element(
    first, middle, last, [](const PartitionEntry& a, const PartitionEntry& b) { return a.Key(Axis) < b.Key(Axis); });
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
  ParallelChunks(count,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        order[i] = entries[i].index;
      }
    });
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
  constexpr void (*select[])(PartitionEntry*, PartitionEntry*, PartitionEntry*) = { Select<0>, Select<1>, Select<2> };
  select[axis](entries + first, entries + middle, entries + last);
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
