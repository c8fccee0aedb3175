// The steps that spatial sorts share.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <thread>
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

/// Runs work(0) ... work(count - 1) on all cores.
template <class Work>
void InParallel(std::size_t count, Work&& work)
{
  const std::size_t threads = std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<std::size_t> next{ 0 };
  const auto run = [&]
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      work(i);
    }
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < threads; ++i)
  {
    others.push_back(std::async(std::launch::async, run));
  }
  run();
  for (auto& other : others)
  {
    other.get();
  }
}

} // namespace rtg
