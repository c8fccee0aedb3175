// Loops on the pool of threads: each item once, nested or from several threads, whatever throws; and the same boxes,
// orders and trees for any number of threads.
#include "GlyphBoxes.h"
#include "GlyphTree.h"
#include "Glyphs.h"
#include "Parallel.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>

namespace
{

class Parallel : public ::testing::Test
{
protected:
  ~Parallel() override { rtg::SetThreadCount(this->before_); }

private:
  const std::size_t before_ = rtg::ThreadCount();
};

/// A file for each thread of this process, on Linux.
constexpr const char* threadFolder = "/proc/self/task";

std::size_t Threads()
{
  const std::filesystem::directory_iterator tasks(threadFolder);
  return std::size_t(std::distance(begin(tasks), end(tasks)));
}

TEST_F(Parallel, EachItemOnce)
{
  for (const std::size_t threads : { 1, 2, 7 })
  {
    rtg::SetThreadCount(threads);
    for (const std::size_t count : { 0, 1, 2, 6, 7, 8, 1000 })
    {
      std::vector<std::atomic<int>> calls(count);
      rtg::ParallelFor(count, [&](std::size_t i) { ++calls[i]; });
      for (const auto& times : calls)
      {
        ASSERT_EQ(times, 1) << threads << ' ' << count;
      }
    }
  }
}

TEST_F(Parallel, ChunksCoverTheRange)
{
  rtg::SetThreadCount(3);
  for (const std::size_t count : { std::size_t(0), std::size_t(1), rtg::parallelChunk, 5 * rtg::parallelChunk + 1 })
  {
    std::vector<int> calls(count);
    rtg::ParallelChunks(count,
      [&](std::size_t first, std::size_t last)
      {
        EXPECT_EQ(first % rtg::parallelChunk, 0u);
        for (std::size_t i = first; i < last; ++i)
        {
          ++calls[i];
        }
      });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), std::size_t(0)), count);
  }
}

TEST_F(Parallel, NestedAndFromSeveralThreads)
{
  rtg::SetThreadCount(4);
  std::atomic<int> calls{ 0 };
  const auto outer = [&]
  {
    for (int repeat = 0; repeat < 50; ++repeat)
    {
      rtg::ParallelFor(8, [&](std::size_t) { rtg::ParallelFor(8, [&](std::size_t) { ++calls; }); });
    }
  };
  std::vector<std::thread> others;
  for (int i = 0; i < 3; ++i)
  {
    others.emplace_back(outer);
  }
  outer();
  for (std::thread& other : others)
  {
    other.join();
  }
  EXPECT_EQ(calls, 4 * 50 * 64);
}

/// All threads take part: seven items that wait for each other.
TEST_F(Parallel, AsManyThreadsAsWanted)
{
  rtg::SetThreadCount(7);
  std::atomic<int> present{ 0 };
  rtg::ParallelFor(7,
    [&](std::size_t)
    {
      ++present;
      while (present < 7)
      {
        std::this_thread::yield();
      }
    });
  EXPECT_EQ(present, 7);
}

TEST_F(Parallel, ThreadsStay)
{
  if (!std::filesystem::exists(threadFolder))
  {
    GTEST_SKIP() << "this system has no " << threadFolder;
  }
  rtg::SetThreadCount(4);
  rtg::ParallelFor(100, [](std::size_t) {});
  const std::size_t before = Threads();
  for (int i = 0; i < 200; ++i)
  {
    rtg::ParallelFor(100, [](std::size_t) {});
  }
  EXPECT_EQ(Threads(), before);
}

TEST_F(Parallel, ExceptionsReachTheCaller)
{
  rtg::SetThreadCount(4);
  for (int repeat = 0; repeat < 20; ++repeat)
  {
    std::atomic<int> calls{ 0 };
    const auto work = [&](std::size_t i)
    {
      ++calls;
      if (i == 3)
      {
        throw std::runtime_error("item 3");
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    };
    EXPECT_THROW(rtg::ParallelFor(100000, work), std::runtime_error);
    EXPECT_LT(calls, 1000) << "no further items begin";
  }
  std::atomic<int> calls{ 0 };
  rtg::ParallelFor(100, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 100);
}

/// Turned superquadrics that move and spin.
rtg::GlyphInstances Crowd(std::size_t count)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  const auto vector = [&]
  {
    const float x = uniform(random), y = uniform(random);
    return glm::vec3(x, y, uniform(random));
  };
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Superquadric;
  for (std::size_t i = 0; i < count; ++i)
  {
    instances.centers.push_back(vector());
    instances.sizes3.push_back(0.02f + 0.01f * vector());
    const glm::quat q = glm::angleAxis(3.0f * uniform(random), glm::normalize(vector()));
    instances.rotations.emplace_back(q.x, q.y, q.z, q.w);
    instances.exponents3.push_back(glm::exp2(2.0f * vector()));
    instances.motion.velocities.push_back(0.1f * vector());
    instances.motion.angularVelocities.push_back(vector());
  }
  return instances;
}

template <class T>
void ExpectSameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

TEST_F(Parallel, SameTreeForAnyNumberOfThreads)
{
  const rtg::GlyphInstances instances = Crowd(20000);
  const std::uint32_t leafBits = rtg::GlyphTree::LeafBits(instances.Count(), 2);
  rtg::SetThreadCount(1);
  const std::vector<rtg::Box> boxes = rtg::GlyphBoxes(instances);
  const rtg::KdOrder kd = rtg::MakeKdOrder(boxes, leafBits);
  const std::vector<rtg::Box> ordered = rtg::InOrder(boxes, kd.order);
  const double surface = rtg::LeafSurface(ordered, leafBits);
  const rtg::GlyphTree tree = rtg::BuildGlyphTree(ordered, leafBits, kd.axes);
  for (const std::size_t threads : { 2, 7 })
  {
    rtg::SetThreadCount(threads);
    ExpectSameBytes(rtg::GlyphBoxes(instances), boxes);
    const rtg::KdOrder other = rtg::MakeKdOrder(boxes, leafBits);
    EXPECT_EQ(other.order, kd.order);
    EXPECT_EQ(other.axes, kd.axes);
    ExpectSameBytes(rtg::InOrder(boxes, kd.order), ordered);
    EXPECT_EQ(rtg::LeafSurface(ordered, leafBits), surface);
    ExpectSameBytes(rtg::BuildGlyphTree(ordered, leafBits, kd.axes).nodes, tree.nodes);
    ExpectSameBytes(rtg::BuildGlyphTree({ boxes, kd.order }, leafBits, kd.axes).nodes, tree.nodes);
    EXPECT_EQ(rtg::LeafSurface({ boxes, kd.order }, leafBits), surface);
  }
}

} // namespace
