#include "GlyphMask.h"

#include "Finite.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedIntArray.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace
{
constexpr int bitsPerAxis = 21;
constexpr int allBits = 3 * bitsPerAxis;

// A candidate: its box, where space counts, and a random number that is the same at each time step.
struct Sample
{
  std::uint64_t Box, Order;
  vtkIdType Point;

  bool operator<(const Sample& other) const
  {
    return std::tie(this->Box, this->Order, this->Point) < std::tie(other.Box, other.Order, other.Point);
  }
};

bool ComesFirst(const Sample& a, const Sample& b)
{
  return std::tie(a.Order, a.Point) < std::tie(b.Order, b.Point);
}

std::uint64_t RandomOrder(std::uint64_t number, std::uint64_t block)
{
  std::uint64_t x = number + 0x9e3779b97f4a7c15ull * (block + 1) + 0xd1342543de82ef95ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// The number in which every third bit is one of these 21.
std::uint64_t Spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

// Gives each sample the smallest box that it lies in, numbered so that larger boxes are leading bits. Positions that
// are not finite are in the first box.
void FindBoxes(std::vector<Sample>& samples, vtkDataArray* positions)
{
  const auto count = static_cast<vtkIdType>(samples.size());
  const rtg::DoubleBox bounds = rtglyphs::RayTracedParallel::BoxOf(count,
    [&](vtkIdType begin, vtkIdType end, rtg::DoubleBox& box)
    {
      rtglyphs::GlyphTuples tuples(positions);
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double* x = tuples.Get(samples[k].Point);
        if (rtg::IsFinite(x))
        {
          box.Include({ glm::make_vec3(x), glm::make_vec3(x) });
        }
      }
    });
  if (bounds.Empty())
  {
    return;
  }
  const glm::dvec3 lower = bounds.lower, sides = bounds.upper - lower;
  const double longest = std::max({ sides.x, sides.y, sides.z });
  constexpr double most = (1 << bitsPerAxis) - 1;
  rtglyphs::RayTracedParallel::ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      rtglyphs::GlyphTuples tuples(positions);
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double* x = tuples.Get(samples[k].Point);
        std::uint64_t box = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double share = longest > 0.0 ? (x[axis] - lower[axis]) / longest : 0.0;
          const double cell = share > 0.0 ? std::min(std::floor(share * (most + 1.0)), most) : 0.0;
          box |= Spread(static_cast<std::uint64_t>(cell)) << (2 - axis);
        }
        samples[k].Box = box;
      }
    });
}

// Of each box that so many leading bits distinguish, the sample of lowest order; sorted samples.
std::vector<Sample> OneOfEachBox(const std::vector<Sample>& samples, int bits)
{
  const auto box = [bits](const Sample& sample) { return bits == 0 ? 0 : sample.Box >> (allBits - bits); };
  std::vector<Sample> chosen;
  for (const Sample& sample : samples)
  {
    if (chosen.empty() || box(chosen.back()) != box(sample))
    {
      chosen.push_back(sample);
    }
    else if (ComesFirst(sample, chosen.back()))
    {
      chosen.back() = sample;
    }
  }
  return chosen;
}

// The samples that a maximum leaves; there are more.
void KeepFirst(std::vector<Sample>& samples, std::size_t maximum)
{
  std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(maximum), samples.end(), ComesFirst);
  samples.resize(maximum);
}

void KeepEven(std::vector<Sample>& samples, std::size_t maximum)
{
  vtkSMPTools::Sort(samples.begin(), samples.end());
  // numbers[b]: how many boxes b leading bits distinguish, less those that fewer bits do
  std::vector<std::size_t> numbers(allBits + 1, 0);
  numbers[0] = 1;
  for (std::size_t k = 1; k < samples.size(); ++k)
  {
    const std::uint64_t differs = samples[k].Box ^ samples[k - 1].Box;
    if (differs != 0)
    {
      ++numbers[std::countl_zero(differs) - (64 - allBits) + 1];
    }
  }
  int bits = 0;
  for (std::size_t boxes = numbers[0]; bits < allBits && boxes + numbers[bits + 1] <= maximum; ++bits)
  {
    boxes += numbers[bits + 1];
  }
  std::vector<Sample> chosen = OneOfEachBox(samples, bits);
  std::vector<Sample> halves = bits < allBits ? OneOfEachBox(samples, bits + 1) : std::move(samples);
  // A box's sample is that of one of its halves.
  std::vector<Sample> further;
  std::set_difference(halves.begin(), halves.end(), chosen.begin(), chosen.end(), std::back_inserter(further));
  KeepFirst(further, maximum - chosen.size());
  chosen.insert(chosen.end(), further.begin(), further.end());
  samples = std::move(chosen);
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphMask rtglyphs::GlyphMask::Effective() const
{
  const rtglyphs::GlyphMask none;
  if (!this->On)
  {
    return none;
  }
  rtglyphs::GlyphMask mask = *this;
  if (mask.Mode == EVERY_NTH)
  {
    mask.MaximumNumberOfGlyphs = none.MaximumNumberOfGlyphs;
    mask.PointsOfAllRanks = none.PointsOfAllRanks;
  }
  else
  {
    mask.Stride = none.Stride;
  }
  return mask;
}

//----------------------------------------------------------------------------
std::vector<vtkIdType> rtglyphs::GlyphMask::Choose(vtkPolyData* points, std::vector<vtkIdType> candidates) const
{
  const auto all = static_cast<double>(std::max(this->PointsOfAllRanks, points->GetNumberOfPoints()));
  const double share = static_cast<double>(points->GetNumberOfPoints()) / std::max(1.0, all);
  const auto maximum = static_cast<std::size_t>(std::max(1.0, std::floor(share * this->MaximumNumberOfGlyphs)));
  if (!this->On || (this->Mode != EVERY_NTH && candidates.size() <= maximum))
  {
    return candidates;
  }
  vtkDataArray* ids = points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::PointIds);
  const auto number = [ids](vtkIdType point)
  {
    const vtkTypeInt64 id = ids ? static_cast<vtkTypeInt64>(ids->GetComponent(point, 0)) : point;
    return static_cast<std::uint64_t>(rtglyphs::RayTracedArrays::InputId(id));
  };
  if (this->Mode == EVERY_NTH)
  {
    const auto stride = static_cast<std::uint64_t>(std::max(this->Stride, 1));
    std::vector<vtkIdType> chosen = rtglyphs::RayTracedParallel::Select(
      static_cast<vtkIdType>(candidates.size()), [&](vtkIdType k) { return number(candidates[k]) % stride == 0; });
    std::transform(chosen.begin(), chosen.end(), chosen.begin(), [&](vtkIdType k) { return candidates[k]; });
    return chosen;
  }

  auto* blocks =
    vtkUnsignedIntArray::SafeDownCast(points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::CompositeIndex));
  std::vector<Sample> samples(candidates.size());
  rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(samples.size()),
    [&](vtkIdType k)
    {
      const vtkIdType point = candidates[k];
      samples[k] = { 0, RandomOrder(number(point), blocks ? blocks->GetValue(point) : 0), point };
    });
  if (this->Mode == EVEN_IN_SPACE)
  {
    FindBoxes(samples, points->GetPoints()->GetData());
    KeepEven(samples, maximum);
  }
  else
  {
    KeepFirst(samples, maximum);
  }
  candidates.resize(samples.size());
  std::transform(samples.begin(), samples.end(), candidates.begin(), [](const Sample& sample) { return sample.Point; });
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}
