// GlyphTree must contain every glyph's box on the way from the root to its leaf, whatever the boxes are like.
#include "GlyphTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using rtg::Box;
using rtg::GlyphTree;
using rtg::GlyphTreeNode;

// As Programs/tree.glsl decodes them, in double.
Box Child(const GlyphTreeNode& node, int child)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = std::ldexp(1.0, node.exponent[axis] - 127);
    // Rounded toward the inside, so that a plane a hair too tight shows.
    box.lower[axis] =
      std::nextafterf(static_cast<float>(node.origin[axis] + step * node.planes[axis][0][child]), INFINITY);
    box.upper[axis] =
      std::nextafterf(static_cast<float>(node.origin[axis] + step * node.planes[axis][1][child]), -INFINITY);
  }
  return box;
}

void ExpectContained(const std::vector<glm::vec3>& centers, const std::vector<glm::vec3>& halfSizes)
{
  const std::size_t count = centers.size();
  const std::uint32_t leafBits = GlyphTree::LeafBits(count, 2);
  std::vector<Box> unordered;
  for (std::size_t i = 0; i < count; ++i)
  {
    unordered.push_back({ centers[i] - halfSizes[i], centers[i] + halfSizes[i] });
  }
  const rtg::KdOrder kd = rtg::MakeKdOrder(unordered, leafBits);
  ASSERT_EQ(kd.order.size(), count);
  std::vector<Box> boxes;
  std::vector<bool> seen(count);
  for (std::uint32_t i : kd.order)
  {
    ASSERT_FALSE(seen[i]);
    seen[i] = true;
    boxes.push_back(unordered[i]);
  }
  const GlyphTree tree = rtg::BuildGlyphTree(boxes, leafBits, kd.axes);

  std::size_t glyphs = 0;
  for (std::size_t leaf = 0; leaf < (std::size_t(1) << leafBits); ++leaf)
  {
    const std::size_t end = GlyphTree::Start(leaf + 1, count, leafBits);
    for (std::size_t i = GlyphTree::Start(leaf, count, leafBits); i < end; ++i, ++glyphs)
    {
      for (std::uint32_t level = 0; level < tree.levels; ++level)
      {
        const std::size_t path = leaf >> (3 * (tree.levels - 1 - level));
        const GlyphTreeNode& node = tree.nodes.at(GlyphTree::LevelOffset(level) + path / 8);
        const Box child = Child(node, path % 8);
        // The pad that the scene adds before is far more than the two ulps of the rounding above.
        const glm::vec3 slack = 1e-30f + 4e-7f * glm::max(glm::abs(boxes[i].lower), glm::abs(boxes[i].upper));
        for (int axis = 0; axis < 3; ++axis)
        {
          ASSERT_LE(child.lower[axis], boxes[i].lower[axis] + slack[axis]) << count << ' ' << leaf << ' ' << level;
          ASSERT_GE(child.upper[axis], boxes[i].upper[axis] - slack[axis]) << count << ' ' << leaf << ' ' << level;
        }
      }
    }
  }
  EXPECT_EQ(glyphs, count);
}

std::vector<glm::vec3> Random(std::size_t count, const glm::vec3& size)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  std::vector<glm::vec3> points(count);
  for (auto& p : points)
  {
    p = size * glm::vec3(uniform(random), uniform(random), uniform(random));
  }
  return points;
}

std::vector<Box> Around(const std::vector<glm::vec3>& centers, float halfSize)
{
  std::vector<Box> boxes;
  for (const glm::vec3& center : centers)
  {
    boxes.push_back({ center - halfSize, center + halfSize });
  }
  return boxes;
}

} // namespace

TEST(GlyphTree, ContainsAllBoxesAtEveryCount)
{
  for (std::size_t count = 1; count < 70; ++count)
  {
    ExpectContained(Random(count, glm::vec3(1.0f)), std::vector<glm::vec3>(count, glm::vec3(0.05f)));
  }
  ExpectContained(Random(50000, glm::vec3(1.0f)), std::vector<glm::vec3>(50000, glm::vec3(0.01f)));
}

TEST(GlyphTree, ContainsBoxesOfVeryDifferentSizes)
{
  std::vector<glm::vec3> sizes = Random(3000, glm::vec3(1.0f));
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    sizes[i] = glm::abs(sizes[i]) * std::pow(10.0f, -float(i % 9));
  }
  ExpectContained(Random(3000, glm::vec3(100.0f, 1.0f, 1e-5f)), sizes);
}

TEST(GlyphTree, ContainsFlatCoincidentAndSinglePoints)
{
  ExpectContained(Random(777, glm::vec3(1.0f, 0.0f, 1.0f)), std::vector<glm::vec3>(777, glm::vec3(0.0f)));
  ExpectContained(std::vector<glm::vec3>(500, glm::vec3(3.0f)), std::vector<glm::vec3>(500, glm::vec3(1.0f)));
}

TEST(GlyphTree, OrdersChildrenAlongTheSplits)
{
  // Children whose number differs only in the bit of one split lie on either side of it, as the order of visits
  // assumes.
  const std::vector<glm::vec3> centers = Random(5000, glm::vec3(3.0f, 1.0f, 0.2f));
  const std::uint32_t leafBits = GlyphTree::LeafBits(centers.size(), 2);
  const rtg::KdOrder kd = rtg::MakeKdOrder(Around(centers, 0.0f), leafBits);
  std::vector<Box> points;
  for (std::uint32_t i : kd.order)
  {
    points.push_back({ centers[i], centers[i] });
  }
  const GlyphTree tree = rtg::BuildGlyphTree(points, leafBits, kd.axes);
  ASSERT_EQ(tree.nodes.size(), kd.axes.size());
  // The root has what splits are left over, the levels below all three.
  for (std::size_t i = 1; i < tree.nodes.size(); ++i)
  {
    const GlyphTreeNode& node = tree.nodes[i];
    // The first split parts the lower four from the upper four; the planes may touch, and quantizing moves them by a
    // step.
    const int axis = node.axes & 3;
    int lowerHalf = 0, upperHalf = 255;
    for (int child = 0; child < 4; ++child)
    {
      lowerHalf = std::max<int>(lowerHalf, node.planes[axis][1][child]);
      upperHalf = std::min<int>(upperHalf, node.planes[axis][0][child + 4]);
    }
    EXPECT_LE(lowerHalf, upperHalf + 1) << i;
    for (int pair = 0; pair < 8; pair += 2)
    {
      const int third = node.axes >> 4 & 3;
      EXPECT_LE(node.planes[third][1][pair], node.planes[third][0][pair + 1] + 1) << i;
    }
  }
}

TEST(GlyphTree, TightEnoughToBeUseful)
{
  // A child's decoded box exceeds its contents by at most one step a side: 1/127 of the parent's extent, or less.
  const std::vector<glm::vec3> centers = Random(4096, glm::vec3(1.0f));
  const std::uint32_t leafBits = GlyphTree::LeafBits(centers.size(), 2);
  const rtg::KdOrder kd = rtg::MakeKdOrder(Around(centers, 0.0f), leafBits);
  std::vector<Box> boxes;
  for (std::uint32_t i : kd.order)
  {
    boxes.push_back({ centers[i] - 0.01f, centers[i] + 0.01f });
  }
  const GlyphTree tree = rtg::BuildGlyphTree(boxes, leafBits, kd.axes);
  Box whole = boxes[0];
  for (const Box& box : boxes)
  {
    whole = { glm::min(whole.lower, box.lower), glm::max(whole.upper, box.upper) };
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    float lower = INFINITY, upper = -INFINITY;
    for (int child = 0; child < 8; ++child)
    {
      lower = std::min(lower, Child(tree.nodes[0], child).lower[axis]);
      upper = std::max(upper, Child(tree.nodes[0], child).upper[axis]);
    }
    const float extent = whole.upper[axis] - whole.lower[axis];
    EXPECT_LT(upper - lower, extent * (1.0f + 2.1f / 127.0f));
  }
}
