#include "vtkGlyphTuples.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

vtkDataArray* Wanted(vtkPolyData* points, bool wanted, const std::string& name)
{
  return wanted && !vtkGlyphSettings::IsNone(name) ? points->GetPointData()->GetArray(name.c_str()) : nullptr;
}

// A number whose order is random but the same for a point at every time step, whatever the maximum.
std::uint64_t SampleOrder(std::uint64_t point, std::uint64_t block, std::uint64_t seed)
{
  std::uint64_t x = point + 0x9e3779b97f4a7c15ull * (block + 1) + 0xd1342543de82ef95ull * seed;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphArrays::Scale(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  return Wanted(points, settings.Scaling, settings.ScaleArray);
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphArrays::Orientation(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  return Wanted(points, settings.Orient, settings.OrientationArray);
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphArrays::Exponents(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  return Wanted(points, settings.HasOwnExponents(), settings.ExponentArray);
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphArrays::TableIndex(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  return Wanted(points, settings.TableSize > 1, settings.TableIndexArray);
}

//----------------------------------------------------------------------------
std::vector<vtkDataArray*> vtkGlyphArrays::All(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  const std::array<vtkDataArray*, 3> motion = vtkGlyphMotion::Arrays(points, settings.Motion);
  return { points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
    points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex), Scale(points, settings),
    Orientation(points, settings), Exponents(points, settings), TableIndex(points, settings),
    vtkGlyphTensors::Array(points, settings.Tensors), motion[0], motion[1], motion[2] };
}

//----------------------------------------------------------------------------
std::vector<vtkIdType> vtkGlyphArrays::Candidates(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  const vtkIdType count = points->GetNumberOfPoints();
  auto* blockIds = vtkUnsignedIntArray::SafeDownCast(
    points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex));
  std::vector<vtkIdType> candidates;
  candidates.reserve(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (blockIds && !blocks.empty())
    {
      const auto block = blocks.find(blockIds->GetValue(i));
      if (block != blocks.end() && !block->second.Visible)
      {
        continue;
      }
    }
    candidates.push_back(i);
  }

  const auto maximum =
    static_cast<std::size_t>(std::max<vtkIdType>(settings.MaximumNumberOfGlyphs, 0));
  if (settings.Mask && candidates.size() > maximum)
  {
    vtkDataArray* ids = points->GetPointData()->GetArray(vtkRayTracedArrays::PointIds);
    std::vector<std::pair<std::uint64_t, vtkIdType>> order;
    order.reserve(candidates.size());
    for (vtkIdType i : candidates)
    {
      const auto id = static_cast<std::uint64_t>(ids ? ids->GetTuple1(i) : i);
      order.emplace_back(SampleOrder(id, blockIds ? blockIds->GetValue(i) : 0, settings.Seed), i);
    }
    std::nth_element(order.begin(), order.begin() + maximum, order.end());
    candidates.clear();
    std::transform(order.begin(), order.begin() + maximum, std::back_inserter(candidates),
      [](const auto& item) { return item.second; });
    std::sort(candidates.begin(), candidates.end());
  }
  return candidates;
}

//----------------------------------------------------------------------------
vtkGlyphArrays::ScaleSum vtkGlyphArrays::SumScales(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  ScaleSum sum;
  vtkDataArray* array = Scale(points, settings);
  const bool byComponents = settings.ScaleMode == vtkGlyphSettings::COMPONENTS;
  if (!array || (byComponents && array->GetNumberOfComponents() != 3))
  {
    return sum;
  }
  vtkGlyphTuples scales(array);
  for (vtkIdType i : Candidates(points, settings, blocks))
  {
    const double* tuple = scales.Get(i);
    const double scale = byComponents ? std::abs(tuple[0]) : vtkMath::Norm(tuple, scales.Size());
    if (IsPositive(scale)) // else there is no glyph
    {
      sum.Sum += scale;
      sum.Count += 1.0;
    }
  }
  return sum;
}

//----------------------------------------------------------------------------
double vtkGlyphArrays::ReferenceScale(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!settings.NeedsMeanScale())
  {
    const bool scaled = settings.Scaling && !vtkGlyphSettings::IsNone(settings.ScaleArray);
    return scaled && IsPositive(settings.ArrowReference) ? settings.ArrowReference : 1.0;
  }
  return IsPositive(settings.MeanScale) ? settings.MeanScale : SumScales(points, settings, blocks).Mean();
}
