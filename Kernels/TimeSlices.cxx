#include "TimeSlices.h"

#include "GlyphBoxes.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rtg
{

namespace
{

// Surface of the leaves beyond which a slice is sorted for itself. Few slices need it when the first does not, which is
// the furthest from the middle.
double SurfaceToSort(const std::vector<Box>& first, std::uint32_t leafBits, SliceSorting sorting)
{
  constexpr double decay = 1.2;
  if (sorting != SliceSorting::WhereDecayed)
  {
    return sorting == SliceSorting::Always ? 0.0 : INFINITY;
  }
  const double own = LeafSurface(InOrder(first, MakeKdOrder(first, leafBits).order), leafBits);
  return LeafSurface(first, leafBits) > decay * own ? decay * own : INFINITY;
}

} // namespace

TimeSlices BuildTimeSlices(const GlyphInstances& instances, const std::vector<std::uint32_t>& order,
  std::uint32_t leafBits, const std::vector<std::uint8_t>& axes, float pad, std::uint32_t bits, SliceSorting sorting)
{
  const std::size_t count = std::size_t(1) << bits;
  const std::size_t glyphs = instances.Count();
  const auto boxesOf = [&](std::size_t slice)
  { return InOrder(GlyphBoxes(instances, double(slice) / double(count), double(slice + 1) / double(count)), order); };
  TimeSlices slices;
  slices.bits = bits;
  slices.nodes.resize(count * axes.size());
  const double tooLarge = count > 1 ? SurfaceToSort(boxesOf(0), leafBits, sorting) : INFINITY;
  if (tooLarge < INFINITY)
  {
    slices.order.resize(count * glyphs);
  }
  ParallelFor(count,
    [&](std::size_t slice)
    {
      std::vector<Box> boxes = boxesOf(slice);
      KdOrder kd;
      if (!slices.order.empty())
      {
        const auto places = slices.order.begin() + slice * glyphs;
        std::iota(places, places + glyphs, 0u);
        if (LeafSurface(boxes, leafBits) > tooLarge)
        {
          kd = MakeKdOrder(boxes, leafBits);
          std::copy(kd.order.begin(), kd.order.end(), places);
          boxes = InOrder(boxes, kd.order);
        }
      }
      for (Box& box : boxes)
      {
        box.lower -= pad;
        box.upper += pad;
      }
      const GlyphTree tree = BuildGlyphTree(boxes, leafBits, kd.axes.empty() ? axes : kd.axes);
      std::copy(tree.nodes.begin(), tree.nodes.end(), slices.nodes.begin() + slice * axes.size());
    });
  return slices;
}

} // namespace rtg
