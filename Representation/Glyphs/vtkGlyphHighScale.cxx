#include "vtkGlyphHighScale.h"

#include "Finite.h"
#include "vtkCommunicator.h"
#include "vtkGlyphTuples.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedParallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numeric>

namespace
{
constexpr double highShare = 0.95; // of the scales that are not above the high one
}

//----------------------------------------------------------------------------
// How many glyphs have about which scale.
struct vtkGlyphHighScale::Histogram
{
  std::vector<double> Counts = std::vector<double>(1 << 14), Largest = Counts; // of each bin

  // A positive float's leading bits rise with it; there are some 6 of its fraction among those that tell bins apart.
  void Add(double scale)
  {
    const std::uint32_t bin = std::bit_cast<std::uint32_t>(static_cast<float>(scale)) >> 17;
    this->Counts[bin] += 1.0;
    this->Largest[bin] = std::max(this->Largest[bin], scale);
  }

  void Add(const Histogram& other)
  {
    for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
    {
      this->Counts[bin] += other.Counts[bin];
      this->Largest[bin] = std::max(this->Largest[bin], other.Largest[bin]);
    }
  }

  // The 95 % quantile, but for 2 % of it, and always the scale of some glyph. 1 where there are none.
  double High() const
  {
    const double all = std::accumulate(this->Counts.begin(), this->Counts.end(), 0.0);
    double below = 0.0;
    for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
    {
      below += this->Counts[bin];
      if (below > 0.0 && below >= highShare * all)
      {
        return this->Largest[bin];
      }
    }
    return 1.0;
  }
};

//----------------------------------------------------------------------------
struct vtkGlyphHighScale::Known
{
  vtkGlyphSettings Settings;
  std::vector<vtkMTimeType> Times;
  std::vector<unsigned int> HiddenBlocks;
  Histogram Scales;
  double High = 0.0;
};

//----------------------------------------------------------------------------
vtkGlyphHighScale::vtkGlyphHighScale() = default;
vtkGlyphHighScale::~vtkGlyphHighScale() = default;

//----------------------------------------------------------------------------
double vtkGlyphHighScale::Get(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks, bool collective)
{
  if (!settings.NeedsHighScale())
  {
    return 0.0;
  }
  const bool any = points && points->GetNumberOfPoints() > 0;
  if (any)
  {
    const std::vector<unsigned int> hidden = vtkGlyphBlockAttributes::Hidden(blocks);
    std::vector<vtkMTimeType> times;
    for (vtkDataArray* array : vtkGlyphArrays::All(points, settings))
    {
      times.push_back(array ? array->GetMTime() : 0);
    }
    if (!this->Own || !(this->Own->Settings == settings) || this->Own->Times != times ||
      this->Own->HiddenBlocks != hidden)
    {
      this->Own = std::make_unique<Known>(Known{ settings, times, hidden, Count(points, settings, blocks) });
      this->Own->High = this->Own->Scales.High();
    }
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!collective || !controller || controller->GetNumberOfProcesses() <= 1)
  {
    return any ? this->Own->High : Histogram().High();
  }
  const Histogram own = any ? this->Own->Scales : Histogram();
  Histogram all;
  const auto bins = static_cast<vtkIdType>(all.Counts.size());
  controller->AllReduce(own.Counts.data(), all.Counts.data(), bins, vtkCommunicator::SUM_OP);
  controller->AllReduce(own.Largest.data(), all.Largest.data(), bins, vtkCommunicator::MAX_OP);
  return all.High();
}

//----------------------------------------------------------------------------
double vtkGlyphHighScale::Reference(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!settings.NeedsHighScale())
  {
    const bool scaled = settings.Scaling && !vtkRayTracedArrays::IsNone(settings.ScaleArray);
    return scaled && rtg::IsPositive(settings.ArrowReference) ? settings.Sizing(settings.ArrowReference) : 1.0;
  }
  return rtg::IsPositive(settings.HighScale) ? settings.HighScale : Count(points, settings, blocks).High();
}

//----------------------------------------------------------------------------
vtkGlyphHighScale::Histogram vtkGlyphHighScale::Count(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  Histogram all;
  vtkDataArray* array = vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, points, settings);
  const bool byComponents = vtkGlyphArrays::ScalesByComponents(array, settings);
  if (!array)
  {
    return all;
  }
  const std::vector<vtkIdType> candidates = vtkGlyphArrays::Candidates(points, settings, blocks);
  std::mutex mutex;
  vtkRayTracedParallel::ForChunks(static_cast<vtkIdType>(candidates.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGlyphTuples scales(array);
      Histogram own;
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double* tuple = scales.Get(candidates[k]);
        const double scale = byComponents ? settings.Sizing(glm::dvec3(std::abs(tuple[0]), tuple[1], tuple[2])).x
                                          : settings.Sizing(vtkMath::Norm(tuple, scales.Size()));
        if (rtg::IsPositive(scale)) // else there is no glyph
        {
          own.Add(scale);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      all.Add(own);
    });
  return all;
}
