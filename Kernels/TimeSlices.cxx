#include "TimeSlices.h"

#include "Parallel.h"

#include <algorithm>
#include <numeric>

namespace rtg
{

std::uint32_t ChooseSliceBits(std::size_t count, std::size_t bytesPerSlice,
  const std::function<DoubleBox(std::size_t, double)>& still,
  const std::function<DoubleBox(std::size_t, double, double)>& moving)
{
  constexpr std::size_t mostBytes = std::size_t(1) << 29;
  constexpr double mostGrowth = 2.0;
  // Some thousand glyphs are a sufficient sample.
  const std::size_t step = std::max<std::size_t>(1, count / 4096);
  std::uint32_t bits = 0;
  for (; bits < maxTimeSliceBits && (bytesPerSlice << (bits + 1)) <= mostBytes; ++bits)
  {
    double stillSurface = 0.0, movingSurface = 0.0;
    const double length = 1.0 / double(1u << bits);
    for (std::size_t i = 0; i < count; i += step)
    {
      // A slice that is another one for every thing stands for all of them.
      const double first = length * double((i / step) & ((1u << bits) - 1));
      const DoubleBox own = still(i, first + 0.5 * length), swept = moving(i, first, first + length);
      stillSurface += HalfSurface(own.upper - own.lower);
      movingSurface += HalfSurface(swept.upper - swept.lower);
    }
    if (movingSurface <= mostGrowth * stillSurface)
    {
      break;
    }
  }
  return bits;
}

GlyphTree BuildSlices(std::uint32_t sliceBits, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes,
  bool sorts, const std::function<std::vector<Box>(double, double)>& boxesBetween)
{
  const std::size_t count = std::size_t(1) << sliceBits;
  const auto boxesOf = [&](std::size_t slice)
  { return boxesBetween(double(slice) / double(count), double(slice + 1) / double(count)); };
  GlyphTree tree;
  tree.leafBits = leafBits;
  tree.levels = GlyphTree::Levels(leafBits);
  tree.sliceBits = sliceBits;
  tree.nodesPerSlice = static_cast<std::uint32_t>(axes.size());
  tree.nodes.resize(count * axes.size());
  std::size_t things = 0;
  double mostSurface = 0.0; // of the leaves, beyond which a slice is sorted for itself
  if (sorts && count > 1)
  {
    // Few slices need it when the first does not, which is the furthest from the middle.
    const std::vector<Box> first = boxesOf(0);
    mostSurface = orderDecay * LeafSurface({ first, MakeKdOrder(first, leafBits).order }, leafBits);
    things = LeafSurface(first, leafBits) > mostSurface ? first.size() : 0;
  }
  tree.order.resize(count * things);
  ParallelFor(count,
    [&](std::size_t slice)
    {
      std::vector<Box> boxes = boxesOf(slice);
      KdOrder kd;
      if (!tree.order.empty())
      {
        const auto places = tree.order.begin() + slice * things;
        std::iota(places, places + things, 0u);
        if (LeafSurface(boxes, leafBits) > mostSurface)
        {
          kd = MakeKdOrder(boxes, leafBits);
          std::copy(kd.order.begin(), kd.order.end(), places);
          boxes = InOrder(boxes, kd.order);
        }
      }
      const GlyphTree own = BuildGlyphTree(boxes, leafBits, kd.axes.empty() ? axes : kd.axes);
      std::copy(own.nodes.begin(), own.nodes.end(), tree.nodes.begin() + slice * axes.size());
    });
  return tree;
}

} // namespace rtg
