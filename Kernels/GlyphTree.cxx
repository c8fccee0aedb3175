#include "GlyphTree.h"

#include "Partition.h"

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

const Box nothing = { glm::vec3(INFINITY), glm::vec3(-INFINITY) };

Box Union(const Box& a, const Box& b)
{
  return { glm::min(a.lower, b.lower), glm::max(a.upper, b.upper) };
}

// Splits the leaves [leaf, leaf + 2^bits) of `order.size()` glyphs until each has its own.
struct KdSplitter
{
  PartitionEntry* entries;
  std::size_t count;
  std::uint32_t leafBits;
  std::uint8_t* axes;

  void Split(std::size_t leaf, std::uint32_t bits, std::size_t heapIndex, int forks) const
  {
    if (bits == 0)
    {
      return;
    }
    const std::size_t half = std::size_t(1) << (bits - 1);
    const auto start = [this](std::size_t l)
    { return GlyphTree::Start(l, this->count, this->leafBits); };
    this->axes[heapIndex] = static_cast<std::uint8_t>(
      PartitionAt(this->entries, start(leaf), start(leaf + half), start(leaf + 2 * half)));
    ForkJoin(
      forks > 0, [&] { this->Split(leaf, bits - 1, 2 * heapIndex + 1, forks - 1); },
      [&] { this->Split(leaf + half, bits - 1, 2 * heapIndex + 2, forks - 1); });
  }
};

// Smallest exponent (biased) with 255 steps of 2^(exponent - 127) covering `extent`.
std::uint8_t StepExponent(float extent)
{
  int exponent;
  std::frexp(extent / 255.0f, &exponent); // extent / 255 < 2^exponent
  return static_cast<std::uint8_t>(std::clamp(extent > 0.0f ? exponent + 127 : 1, 1, 254));
}

GlyphTreeNode Quantise(const Box& whole, const Box (&children)[4], std::uint8_t axes)
{
  GlyphTreeNode node{};
  node.origin = whole.lower;
  node.axes = axes;
  std::uint8_t* lower[3] = { node.lowerX, node.lowerY, node.lowerZ };
  std::uint8_t* upper[3] = { node.upperX, node.upperY, node.upperZ };
  for (int axis = 0; axis < 3; ++axis)
  {
    // The extent is rounded up, so that the last step reaches the upper plane.
    const float extent = std::nextafterf(whole.upper[axis] - whole.lower[axis], INFINITY);
    node.exponent[axis] = StepExponent(extent);
    const double step = std::ldexp(1.0, node.exponent[axis] - 127);
    const double origin = whole.lower[axis];
    for (int child = 0; child < 4; ++child)
    {
      const Box& box = children[child];
      if (box.lower.x > box.upper.x)
      {
        lower[axis][child] = 255;
        upper[axis][child] = 0;
        continue;
      }
      lower[axis][child] = static_cast<std::uint8_t>(
        std::clamp(std::floor((box.lower[axis] - origin) / step), 0.0, 255.0));
      upper[axis][child] = static_cast<std::uint8_t>(
        std::clamp(std::ceil((box.upper[axis] - origin) / step), 0.0, 255.0));
    }
  }
  return node;
}

// Number of nodes on the levels above `level`: 1 + 4 + 16 + ...
std::size_t LevelOffset(std::uint32_t level)
{
  return ((std::size_t(1) << (2 * level)) - 1) / 3;
}

} // namespace

std::uint32_t GlyphTree::LeafBits(std::size_t count, std::size_t glyphsPerLeaf)
{
  std::uint32_t bits = 1;
  while ((count >> bits) >= glyphsPerLeaf)
  {
    ++bits;
  }
  return bits;
}

KdOrder MakeKdOrder(const std::vector<glm::vec3>& centres, std::uint32_t leafBits)
{
  KdOrder result;
  std::vector<PartitionEntry> entries = MakePartitionEntries(centres);
  result.axes.resize((std::size_t(1) << leafBits) - 1);
  const KdSplitter splitter{ entries.data(), entries.size(), leafBits, result.axes.data() };
  splitter.Split(0, leafBits, 0, ForksFor(entries.size()));
  result.order = OrderOf(entries);
  return result;
}

GlyphTree BuildGlyphTree(
  const std::vector<Box>& boxes, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes)
{
  GlyphTree tree;
  tree.leafBits = leafBits;
  tree.levels = (leafBits + 1) / 2;

  // Boxes of the leaves, then of every level's nodes upwards.
  std::vector<Box> below(std::size_t(1) << leafBits, nothing);
  for (std::size_t leaf = 0; leaf < below.size(); ++leaf)
  {
    const std::size_t end = GlyphTree::Start(leaf + 1, boxes.size(), leafBits);
    for (std::size_t i = GlyphTree::Start(leaf, boxes.size(), leafBits); i < end; ++i)
    {
      below[leaf] = Union(below[leaf], boxes[i]);
    }
  }

  const std::uint32_t last = tree.levels - 1;
  const std::size_t lastCount = std::max<std::size_t>(1, below.size() / 4);
  tree.nodes.resize(LevelOffset(last) + lastCount);
  for (std::uint32_t up = 0; up < tree.levels; ++up)
  {
    const std::uint32_t level = last - up;
    const std::size_t count = std::max<std::size_t>(1, below.size() / 4);
    const bool twoChildren = below.size() < 4;
    std::vector<Box> current(count, nothing);
    // Binary depth of this level's first split.
    const std::uint32_t depth = twoChildren ? 0 : leafBits - 2 * (up + 1);
    const std::size_t heapFirst = (std::size_t(1) << depth) - 1;
    for (std::size_t i = 0; i < count; ++i)
    {
      Box children[4] = { nothing, nothing, nothing, nothing };
      for (std::size_t child = 0; child < (twoChildren ? 2 : 4); ++child)
      {
        children[child] = below[4 * i + child];
        current[i] = Union(current[i], below[4 * i + child]);
      }
      const std::size_t heap = heapFirst + i;
      const auto axis = [&](std::size_t split) { return split < axes.size() ? axes[split] : 0; };
      // Two children are the lower pair of a node whose upper pair is empty.
      const int packed = twoChildren
        ? axis(heap) << 2
        : axis(heap) | axis(2 * heap + 1) << 2 | axis(2 * heap + 2) << 4;
      tree.nodes[LevelOffset(level) + i] =
        Quantise(current[i], children, static_cast<std::uint8_t>(packed));
    }
    below = std::move(current);
  }
  return tree;
}

} // namespace rtg
