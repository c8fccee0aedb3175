#include "GlyphTree.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace rtg
{

namespace
{

Box LeafBox(const BoxReader& boxes, std::size_t leaf, std::uint32_t leafBits)
{
  const std::size_t last = GlyphTree::Start(leaf + 1, boxes.Count(), leafBits);
  Box box;
  for (std::size_t i = GlyphTree::Start(leaf, boxes.Count(), leafBits); i < last; ++i)
  {
    box.Include(boxes[i]);
  }
  return box;
}

// The middle of a box during the sort, and its index before.
struct Entry
{
  glm::vec3 point;
  std::uint32_t index;
};

// Equal coordinates go by the index: what the sort does depends on nothing but the points, and many equal ones cost it
// no more than others.
void PartitionAlong(Entry* first, Entry* middle, Entry* last, int axis)
{
  std::nth_element(first, middle, last,
    [axis](const Entry& a, const Entry& b)
    { return a.point[axis] < b.point[axis] || (a.point[axis] == b.point[axis] && a.index < b.index); });
}

// How often to fork a recursion over so many points for all cores to have work worth a thread: into some more parts
// than threads, because parts are never equally fast.
int ForksFor(std::size_t count)
{
  int forks = 0;
  while ((std::size_t(1) << forks) < 4 * ThreadCount() && (count >> forks) > 20000)
  {
    ++forks;
  }
  return ThreadCount() > 1 ? forks : 0;
}

// Splits a node has: three, but for the root what is left.
std::uint32_t SplitsOf(std::uint32_t level, std::uint32_t leafBits)
{
  return level > 0 ? 3 : leafBits - 3 * (GlyphTree::Levels(leafBits) - 1);
}

// The last splits of the kd tree: those of a node whose children are leaves. The axes are those that leave the boxes of
// the halves the least surface, with which the number of rays that meet them grows. Further up it makes no difference
// worth its time. Glyphs are sorted along each axis once; every split keeps these orders.
class LeafSplitter
{
public:
  static constexpr std::size_t mostGlyphs = 64;

  LeafSplitter(Entry* entries, std::size_t count, const BoxReader& boxes)
    : entries_(entries)
    , count_(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const glm::vec3 middle = entries[i].point, half = boxes.HalfExtent(entries[i].index);
      const glm::vec3 lower = middle - half, upper = middle + half;
      this->boxes_[i] = { lower.x, lower.y, lower.z, 0.0f, -upper.x, -upper.y, -upper.z, 0.0f };
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // A glyph's place is the number of those before it, counted without unpredictable branches.
      std::uint8_t places[mostGlyphs] = {};
      for (std::size_t i = 1; i < count; ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          const bool before = entries[i].point[axis] < entries[j].point[axis];
          places[j] += before;
          places[i] += !before;
        }
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        this->sorted_[axis][places[i]] = static_cast<std::uint8_t>(i);
      }
    }
  }

  // Halves each part; places[0] ... places[halves] are where the halves start and end. Returns the axis.
  int Split(const std::size_t* places, std::size_t halves)
  {
    int best = 0;
    float least = INFINITY;
    for (int axis = 0; axis < 3; ++axis)
    {
      float area = 0.0f;
      for (std::size_t half = 0; half < halves; ++half)
      {
        area += this->Area(axis, places[half], places[half + 1]);
      }
      if (area < least)
      {
        least = area;
        best = axis;
      }
    }
    for (std::size_t half = 0; half < halves; half += 2)
    {
      this->Divide(best, places[half], places[half + 1], places[half + 2]);
    }
    return best;
  }

  // Puts the entries where the splits want them.
  void Apply() const
  {
    Entry before[mostGlyphs];
    std::copy_n(this->entries_, this->count_, before);
    for (std::size_t i = 0; i < this->count_; ++i)
    {
      this->entries_[i] = before[this->sorted_[0][i]];
    }
  }

private:
  // Of a box: its lower corner, and its upper one with the sign turned, so that all eight take the same instruction.
  using Planes = std::array<float, 8>;

  float Area(int axis, std::size_t first, std::size_t last) const
  {
    if (first == last)
    {
      return 0.0f;
    }
    Planes planes = this->boxes_[this->sorted_[axis][first]];
    for (std::size_t i = first + 1; i < last; ++i)
    {
      const Planes& other = this->boxes_[this->sorted_[axis][i]];
      for (std::size_t plane = 0; plane < planes.size(); ++plane)
      {
        planes[plane] = std::min(planes[plane], other[plane]);
      }
    }
    return HalfSurface(-glm::vec3(planes[4] + planes[0], planes[5] + planes[1], planes[6] + planes[2]));
  }

  void Divide(int along, std::size_t first, std::size_t middle, std::size_t last)
  {
    std::uint64_t lower = 0;
    for (std::size_t i = first; i < middle; ++i)
    {
      lower |= std::uint64_t(1) << this->sorted_[along][i];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      std::uint8_t* const sorted = this->sorted_[axis];
      std::uint8_t upper[mostGlyphs];
      std::size_t kept = first, moved = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        const std::uint8_t glyph = sorted[i];
        const bool below = lower >> glyph & 1;
        sorted[kept] = glyph;
        upper[moved] = glyph;
        kept += below;
        moved += !below;
      }
      std::copy_n(upper, moved, sorted + kept);
    }
  }

  Entry* entries_;
  std::size_t count_;
  Planes boxes_[mostGlyphs];
  std::uint8_t sorted_[3][mostGlyphs]; // glyphs along each axis, part by part
};

// Orders entries into leaves, node by node. All children of a node are split along the same axes, so
// that three signs of the ray's direction give the order of all eight.
struct KdSplitter
{
  Entry* entries;
  const BoxReader& boxes;
  std::size_t count;
  std::uint32_t leafBits;
  std::uint8_t* axes;

  std::size_t Start(std::size_t leaf) const { return GlyphTree::Start(leaf, this->count, this->leafBits); }

  // `bits` binary levels lie below the node, whose first leaf is `leaf`.
  void SplitNode(std::uint32_t level, std::size_t node, std::size_t leaf, std::uint32_t bits, int forks) const
  {
    const std::uint32_t splits = SplitsOf(level, this->leafBits);
    int chosen[3] = { 0, 0, 0 };
    const bool done = bits == splits && this->SplitByArea(leaf, splits, chosen);
    if (!done)
    {
      this->ChooseByExtent(leaf, bits, splits, chosen);
    }
    std::uint8_t packed = 0;
    for (std::uint32_t i = 0; i < splits; ++i)
    {
      // The bit of a child's number that split i decides is splits - 1 - i; the first field is that of bit 2.
      packed |= static_cast<std::uint8_t>(chosen[i] << (2 * (3 - splits + i)));
    }
    this->axes[GlyphTree::LevelOffset(level) + node] = packed;
    if (!done)
    {
      this->Split(level, node << splits, leaf, bits, chosen, splits, forks);
    }
  }

  void ChooseByExtent(std::size_t leaf, std::uint32_t bits, std::uint32_t splits, int* chosen) const
  {
    Box box;
    for (std::size_t i = this->Start(leaf); i < this->Start(leaf + (std::size_t(1) << bits)); ++i)
    {
      box.Include({ this->entries[i].point, this->entries[i].point });
    }
    glm::vec3 extent = box.upper - box.lower;
    for (std::uint32_t i = 0; i < splits; ++i)
    {
      chosen[i] = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
      extent[chosen[i]] *= 0.5f;
    }
  }

  // Returns false when there are too many glyphs for that.
  bool SplitByArea(std::size_t leaf, std::uint32_t splits, int* chosen) const
  {
    const std::size_t leaves = std::size_t(1) << splits;
    const std::size_t first = this->Start(leaf), count = this->Start(leaf + leaves) - first;
    if (count > LeafSplitter::mostGlyphs)
    {
      return false;
    }
    LeafSplitter splitter(this->entries + first, count, this->boxes);
    for (std::uint32_t i = 0; i < splits; ++i)
    {
      const std::size_t halves = std::size_t(2) << i;
      std::size_t places[9];
      for (std::size_t half = 0; half <= halves; ++half)
      {
        places[half] = this->Start(leaf + half * leaves / halves) - first;
      }
      chosen[i] = splitter.Split(places, halves);
    }
    splitter.Apply();
    return true;
  }

  // The remaining `splits` of a node, which lead to the children from `child` on.
  void Split(std::uint32_t level, std::size_t child, std::size_t leaf, std::uint32_t bits, const int* chosen,
    std::uint32_t splits, int forks) const
  {
    if (splits == 0)
    {
      if (bits > 0)
      {
        this->SplitNode(level + 1, child, leaf, bits, forks);
      }
      return;
    }
    const std::size_t half = std::size_t(1) << (bits - 1);
    Entry* const first = this->entries;
    PartitionAlong(
      first + this->Start(leaf), first + this->Start(leaf + half), first + this->Start(leaf + 2 * half), *chosen);
    const auto splitHalf = [&](std::size_t i)
    { this->Split(level, child + (i << (splits - 1)), leaf + i * half, bits - 1, chosen + 1, splits - 1, forks - 1); };
    if (forks > 0)
    {
      ParallelFor(2, splitHalf);
      return;
    }
    splitHalf(0);
    splitHalf(1);
  }
};

// Smallest exponent (biased) with 255 steps of 2^(exponent - 127) covering `extent`.
std::uint8_t StepExponent(float extent)
{
  int exponent;
  std::frexp(extent / 255.0f, &exponent); // extent / 255 < 2^exponent
  return static_cast<std::uint8_t>(std::clamp(extent > 0.0f ? exponent + 127 : 1, 1, 254));
}

// Whole numbers beside one that is not negative, 255 at most.
std::uint8_t StepBelow(double value)
{
  return static_cast<std::uint8_t>(std::min(value, 255.0));
}

std::uint8_t StepAbove(double value)
{
  const std::uint8_t down = StepBelow(value);
  return static_cast<std::uint8_t>(down + (down < 255 && down < value));
}

// The traversal rounds the parameter at which a ray meets a plane by a few ulps of what the plane lies from the node's
// origin, which the boxes are wider by; BoxRay in Programs/tree.glsl has the rest.
GlyphTreeNode Quantize(const Box& whole, const Box* children, std::size_t count, std::uint8_t axes)
{
  GlyphTreeNode node{};
  node.axes = axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double padding = std::ldexp(double(whole.upper[axis]) - whole.lower[axis], -20);
    node.origin[axis] = std::nextafterf(static_cast<float>(whole.lower[axis] - padding), -INFINITY);
    // The extent is rounded up, so that the last step reaches the upper plane.
    const float extent = std::nextafterf(static_cast<float>(whole.upper[axis] + padding - node.origin[axis]), INFINITY);
    node.exponent[axis] = StepExponent(extent);
    const double perStep = std::ldexp(1.0, 127 - node.exponent[axis]);
    const double origin = node.origin[axis];
    for (std::size_t child = 0; child < 8; ++child)
    {
      const bool none = child >= count || children[child].Empty();
      const double lower = none ? 255.0 : (children[child].lower[axis] - padding - origin) * perStep;
      const double upper = none ? 0.0 : (children[child].upper[axis] + padding - origin) * perStep;
      node.planes[axis][0][child] = StepBelow(lower);
      node.planes[axis][1][child] = StepAbove(upper);
    }
  }
  return node;
}

} // namespace

std::uint32_t GlyphTree::LeafBits(std::size_t count, std::size_t glyphsPerLeaf)
{
  std::uint32_t bits = 1;
  while ((count >> bits) >= glyphsPerLeaf)
  {
    ++bits;
  }
  return std::min(bits, 3 * maxLevels);
}

KdOrder MakeKdOrder(const BoxReader& boxes, std::uint32_t leafBits)
{
  KdOrder result;
  const std::size_t count = boxes.Count();
  // Not made by a vector, which would write zeros into all of them first, on one core.
  const std::unique_ptr<Entry[]> entries(new Entry[count]);
  ParallelEach(count,
    [&](std::size_t i)
    {
      const Box box = boxes[i];
      entries[i] = { 0.5f * box.lower + 0.5f * box.upper, static_cast<std::uint32_t>(i) };
    });
  const std::uint32_t last = GlyphTree::Levels(leafBits) - 1;
  const std::size_t lastCount = std::size_t(1) << (last > 0 ? leafBits - 3 : 0);
  result.axes.resize(GlyphTree::LevelOffset(last) + lastCount);
  const KdSplitter splitter{ entries.get(), boxes, count, leafBits, result.axes.data() };
  splitter.SplitNode(0, 0, 0, leafBits, ForksFor(count));
  result.order.resize(count);
  ParallelEach(count, [&](std::size_t i) { result.order[i] = entries[i].index; });
  return result;
}

double LeafSurface(const BoxReader& boxes, std::uint32_t leafBits)
{
  constexpr std::size_t mostVisited = std::size_t(1) << 16;
  const std::size_t leaves = std::size_t(1) << leafBits;
  // An odd step visits children of every place in their node.
  const std::size_t step = leaves / mostVisited | 1;
  const std::size_t visited = (leaves + step - 1) / step;
  std::vector<double> surfaces((visited + parallelChunk - 1) / parallelChunk);
  ParallelChunks(visited,
    [&](std::size_t begin, std::size_t end)
    {
      double& surface = surfaces[begin / parallelChunk];
      for (std::size_t i = begin; i < end; ++i)
      {
        const Box box = LeafBox(boxes, i * step, leafBits);
        surface += box.Empty() ? 0.0 : HalfSurface(glm::dvec3(box.upper - box.lower));
      }
    });
  const double sum = std::accumulate(surfaces.begin(), surfaces.end(), 0.0);
  return sum * (double(leaves) / double(visited));
}

GlyphTree BuildGlyphTree(const BoxReader& boxes, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes)
{
  GlyphTree tree;
  tree.leafBits = leafBits;
  tree.levels = GlyphTree::Levels(leafBits);
  tree.nodesPerSlice = static_cast<std::uint32_t>(axes.size());
  tree.nodes.resize(axes.size());

  // Boxes of every level's nodes, from the lowest upwards; those of leaves are not kept.
  std::vector<Box> below;
  for (std::uint32_t level = tree.levels; level-- > 0;)
  {
    const std::size_t children = std::size_t(1) << SplitsOf(level, leafBits);
    const bool lowest = level + 1 == tree.levels;
    std::vector<Box> current(lowest ? (std::size_t(1) << leafBits) / children : below.size() / children);
    ParallelEach(current.size(),
      [&](std::size_t i)
      {
        Box leaves[8];
        for (std::size_t child = 0; lowest && child < children; ++child)
        {
          leaves[child] = LeafBox(boxes, children * i + child, leafBits);
        }
        const Box* const parts = lowest ? leaves : &below[children * i];
        std::for_each(parts, parts + children, [&](const Box& part) { current[i].Include(part); });
        const std::size_t node = GlyphTree::LevelOffset(level) + i;
        tree.nodes[node] = Quantize(current[i], parts, children, axes[node]);
      });
    below = std::move(current);
  }
  return tree;
}

} // namespace rtg
