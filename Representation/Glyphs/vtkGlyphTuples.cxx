#include "vtkGlyphTuples.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedParallel.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{
bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

using Settings = vtkGlyphSettings;

// Of the lengths of orientation tuples, the first that a mode takes.
int ModeFrom(int mode)
{
  return mode == Settings::QUATERNION ? 1 : mode == Settings::MATRIX || mode == Settings::AXES ? 2 : 0;
}

// A row of the table of arrays.
struct Description
{
  std::string Settings::*Name;
  bool (*IsWanted)(const Settings&);
  std::vector<int> (*Lengths)(const Settings&); // of tuples that make sense; none: any
  const char* Property;
  const char* Without; // what happens without the array
};

// In the order of vtkGlyphArrays::Id.
const std::array<Description, vtkGlyphArrays::NUMBER_OF_IDS> table = { {
  { &Settings::ScaleArray, [](const Settings& settings) { return settings.Scaling; },
    [](const Settings& settings) {
      return settings.ScaleMode == Settings::COMPONENTS ? std::vector<int>{ 1, 3 } : std::vector<int>{};
    },
    "GlyphScaleArray", "all glyphs get the same size" },
  { &Settings::OrientationArray, [](const Settings& settings) { return settings.Orient; },
    [](const Settings& settings)
    {
      const std::vector<int> all = { 3, 4, 9 }; // longer tuples say by themselves what they are
      return std::vector<int>(all.begin() + ModeFrom(settings.OrientationMode), all.end());
    },
    "GlyphOrientationArray", "the glyphs are not turned" },
  { &Settings::TableIndexArray, [](const Settings& settings) { return settings.HasTable(); },
    [](const Settings&) { return std::vector<int>{}; }, "GlyphMeshIndexArray",
    "all points have the table's first form" },
  { &Settings::ExponentArray, [](const Settings& settings) { return settings.HasOwnExponents(); },
    [](const Settings&) {
      return std::vector<int>{ 1, 2, 3 };
    },
    "GlyphExponentArray", "GlyphExponents count" },
  { &Settings::OpacityArray, [](const Settings&) { return true; },
    [](const Settings&) { return std::vector<int>{ 1 }; }, "GlyphOpacityArray", "all glyphs have the same opacity" },
} };

// A number whose order is random but the same for a point at every time step, whatever the maximum.
std::uint64_t SampleOrder(std::uint64_t point, std::uint64_t block, std::uint64_t seed)
{
  std::uint64_t x = point + 0x9e3779b97f4a7c15ull * (block + 1) + 0xd1342543de82ef95ull * seed;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

using SampleRank = std::pair<std::uint64_t, vtkIdType>; // order and point
}

//----------------------------------------------------------------------------
vtkDataArray*
vtkGlyphArrays::Find(Id id, vtkPolyData* points, const vtkGlyphSettings& settings, std::vector<std::string>* messages)
{
  const Description& how = table[id];
  const std::string& name = settings.*how.Name;
  if (!how.IsWanted(settings) || vtkRayTracedArrays::IsNone(name))
  {
    return nullptr;
  }
  vtkDataArray* array = points->GetPointData()->GetArray(name.c_str());
  const std::vector<int> lengths = how.Lengths(settings);
  const bool fits = array &&
    (lengths.empty() || std::find(lengths.begin(), lengths.end(), array->GetNumberOfComponents()) != lengths.end());
  if (!array && messages)
  {
    messages->push_back("There is no point array '" + name + "', which " + how.Property + " names; " + how.Without +
      ". Choose one that exists, or None.");
  }
  else if (!fits && messages)
  {
    std::ostringstream text;
    text << "The point array '" << name << "', which " << how.Property << " names, has "
         << array->GetNumberOfComponents() << " components where " << lengths.front();
    for (std::size_t i = 1; i < lengths.size(); ++i)
    {
      text << (i + 1 < lengths.size() ? ", " : " or ") << lengths[i];
    }
    text << " are needed; " << how.Without << ". Choose another array or mode.";
    messages->push_back(text.str());
  }
  return fits ? array : nullptr;
}

//----------------------------------------------------------------------------
bool vtkGlyphArrays::ScalesByComponents(vtkDataArray* scales, const vtkGlyphSettings& settings)
{
  return settings.ScaleMode == Settings::COMPONENTS && !(scales && scales->GetNumberOfComponents() == 1);
}

//----------------------------------------------------------------------------
int vtkGlyphArrays::OrientationMode(vtkDataArray* orientations, const vtkGlyphSettings& settings)
{
  const int components = orientations ? orientations->GetNumberOfComponents() : 0;
  if (components == 4)
  {
    return Settings::QUATERNION;
  }
  return components == 9 && settings.OrientationMode != Settings::AXES ? Settings::MATRIX : settings.OrientationMode;
}

//----------------------------------------------------------------------------
std::vector<vtkDataArray*> vtkGlyphArrays::All(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  const std::array<vtkDataArray*, 3> motion = vtkGlyphMotion::Arrays(points, settings.Motion);
  std::vector<vtkDataArray*> all = { points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
    points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex),
    vtkGlyphTensors::Array(points, settings.Tensors), motion[0], motion[1], motion[2] };
  for (int id = 0; id < NUMBER_OF_IDS; ++id)
  {
    all.push_back(Find(static_cast<Id>(id), points, settings));
  }
  return all;
}

//----------------------------------------------------------------------------
std::vector<vtkIdType> vtkGlyphArrays::Candidates(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  auto* blockIds =
    vtkUnsignedIntArray::SafeDownCast(points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex));
  const auto isVisible = [&](vtkIdType i)
  {
    if (!blockIds || blocks.empty())
    {
      return true;
    }
    const auto block = blocks.find(blockIds->GetValue(i));
    return block == blocks.end() || block->second.Visible;
  };
  std::vector<vtkIdType> candidates = vtkRayTracedParallel::Select(points->GetNumberOfPoints(), isVisible);
  const vtkIdType maximum = std::max<vtkIdType>(settings.MaximumNumberOfGlyphs, 0);
  if (!settings.Mask || static_cast<vtkIdType>(candidates.size()) <= maximum)
  {
    return candidates;
  }

  vtkDataArray* ids = points->GetPointData()->GetArray(vtkRayTracedArrays::PointIds);
  std::vector<SampleRank> ranks(candidates.size());
  vtkRayTracedParallel::ForChunks(static_cast<vtkIdType>(ranks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        const vtkIdType i = candidates[k];
        const auto id = static_cast<std::uint64_t>(ids ? ids->GetComponent(i, 0) : i);
        ranks[k] = { SampleOrder(id, blockIds ? blockIds->GetValue(i) : 0, settings.Seed), i };
      }
    });
  // Those before the one that would be in the place `maximum` when all were sorted.
  std::vector<SampleRank> sorted = ranks;
  std::nth_element(sorted.begin(), sorted.begin() + maximum, sorted.end());
  const SampleRank end = sorted[maximum];
  std::vector<vtkIdType> chosen =
    vtkRayTracedParallel::Select(static_cast<vtkIdType>(ranks.size()), [&](vtkIdType k) { return ranks[k] < end; });
  std::transform(chosen.begin(), chosen.end(), chosen.begin(), [&](vtkIdType k) { return candidates[k]; });
  return chosen;
}

//----------------------------------------------------------------------------
vtkGlyphArrays::ScaleSum vtkGlyphArrays::SumScales(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  ScaleSum sum;
  vtkDataArray* array = Find(SCALE, points, settings);
  const bool byComponents = ScalesByComponents(array, settings);
  if (!array)
  {
    return sum;
  }
  const std::vector<vtkIdType> candidates = Candidates(points, settings, blocks);
  const auto count = static_cast<vtkIdType>(candidates.size());
  std::vector<ScaleSum> sums(vtkRayTracedParallel::NumberOfChunks(count));
  vtkRayTracedParallel::ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGlyphTuples scales(array);
      ScaleSum own;
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double* tuple = scales.Get(candidates[k]);
        const double scale = byComponents ? settings.Sizing(glm::dvec3(std::abs(tuple[0]), tuple[1], tuple[2])).x
                                          : settings.Sizing(vtkMath::Norm(tuple, scales.Size()));
        if (IsPositive(scale)) // else there is no glyph
        {
          own.Sum += scale;
          own.Count += 1.0;
        }
      }
      sums[vtkRayTracedParallel::ChunkOf(begin)] = own;
    });
  for (const ScaleSum& own : sums)
  {
    sum.Sum += own.Sum;
    sum.Count += own.Count;
  }
  return sum;
}

//----------------------------------------------------------------------------
double vtkGlyphArrays::ReferenceScale(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!settings.NeedsMeanScale())
  {
    const bool scaled = settings.Scaling && !vtkRayTracedArrays::IsNone(settings.ScaleArray);
    return scaled && IsPositive(settings.ArrowReference) ? settings.Sizing(settings.ArrowReference) : 1.0;
  }
  return IsPositive(settings.MeanScale) ? settings.MeanScale : SumScales(points, settings, blocks).Mean();
}
