// SpatialOrder must be a permutation whose ranges, split at (first + last) / 2, separate in space.
#include "SpatialOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

std::vector<glm::vec3> RandomPoints(std::size_t count, float sizeZ)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  std::vector<glm::vec3> points(count);
  for (auto& p : points)
  {
    p = { uniform(random), uniform(random), sizeZ * uniform(random) };
  }
  return points;
}

// Along some axis, all of [first, middle] lies at or below all of [middle + 1, last].
bool SeparatesEverywhere(const std::vector<glm::vec3>& sorted, std::size_t first, std::size_t last)
{
  if (last - first < 2)
  {
    return true;
  }
  const std::size_t middle = (first + last) / 2;
  bool separated = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto less = [axis](const glm::vec3& a, const glm::vec3& b) { return a[axis] < b[axis]; };
    const auto highest = std::max_element(sorted.begin() + first, sorted.begin() + middle + 1, less);
    const auto lowest = std::min_element(sorted.begin() + middle + 1, sorted.begin() + last + 1, less);
    separated = separated || (*highest)[axis] <= (*lowest)[axis];
  }
  return separated && SeparatesEverywhere(sorted, first, middle) && SeparatesEverywhere(sorted, middle + 1, last);
}

void ExpectKdOrder(const std::vector<glm::vec3>& points)
{
  const auto order = rtg::SpatialOrder(points);
  ASSERT_EQ(order.size(), points.size());
  std::vector<bool> seen(points.size());
  std::vector<glm::vec3> sorted;
  for (std::uint32_t i : order)
  {
    ASSERT_LT(i, points.size());
    EXPECT_FALSE(seen[i]);
    seen[i] = true;
    sorted.push_back(points[i]);
  }
  if (!sorted.empty())
  {
    EXPECT_TRUE(SeparatesEverywhere(sorted, 0, sorted.size() - 1));
  }
}

} // namespace

TEST(SpatialOrder, SmallCounts)
{
  for (std::size_t count = 0; count < 20; ++count)
  {
    ExpectKdOrder(RandomPoints(count, 1.0f));
  }
}

TEST(SpatialOrder, ManyPointsOnAllThreads)
{
  ExpectKdOrder(RandomPoints(100000, 1.0f));
}

TEST(SpatialOrder, FlatAndCoincidentPoints)
{
  ExpectKdOrder(RandomPoints(5000, 0.0f));
  ExpectKdOrder(std::vector<glm::vec3>(3000, glm::vec3(1.0f)));
}
