#include "vtkGlyphHighScale.h"

#include "Finite.h"
#include "vtkCommunicator.h"
#include "vtkGlyphSample.h"
#include "vtkGlyphSizes.h"
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
// A positive float's leading bits rise with it; there are some 6 of its fraction among those that tell bins apart.
void vtkGlyphHighScale::Histogram::Add(double scale)
{
  const std::uint32_t bin = std::bit_cast<std::uint32_t>(static_cast<float>(scale)) >> 17;
  this->Counts[bin] += 1.0;
  this->Largest[bin] = std::max(this->Largest[bin], scale);
}

//----------------------------------------------------------------------------
void vtkGlyphHighScale::Histogram::Add(const Histogram& other)
{
  for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
  {
    this->Counts[bin] += other.Counts[bin];
    this->Largest[bin] = std::max(this->Largest[bin], other.Largest[bin]);
  }
}

//----------------------------------------------------------------------------
// The 95 % quantile, but for 2 % of it, and always the scale of some glyph. 1 where there are none.
double vtkGlyphHighScale::Histogram::High() const
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

//----------------------------------------------------------------------------
double vtkGlyphHighScale::Get(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!settings.NeedsHighScale())
  {
    return 0.0;
  }
  const vtkGlyphSettings matter = settings.OfMagnitudes();
  const bool changed = this->Known.Update(
    vtkGlyphArrays::KeyOf(points, { matter }, blocks), [&] { this->Own = Count(points, matter, blocks); });
  if (vtkGlyphSample::Largest(changed ? 1.0 : 0.0) > 0.0)
  {
    Histogram all = this->Own;
    vtkGlyphSample::Reduce(all.Counts, vtkCommunicator::SUM_OP);
    vtkGlyphSample::Reduce(all.Largest, vtkCommunicator::MAX_OP);
    this->High = all.High();
  }
  return this->High;
}

//----------------------------------------------------------------------------
vtkGlyphHighScale::Histogram vtkGlyphHighScale::Count(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  Histogram all;
  const vtkGlyphMagnitudes magnitudes(points, settings);
  if (!magnitudes.HasScales())
  {
    return all;
  }
  const std::vector<vtkIdType> candidates = vtkGlyphArrays::Candidates(points, settings, blocks);
  std::mutex mutex;
  vtkRayTracedParallel::ForChunks(static_cast<vtkIdType>(candidates.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGlyphMagnitudes::Tuples tuples(magnitudes);
      Histogram own;
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double length = std::abs(magnitudes.Scale(candidates[k], tuples).x);
        if (rtg::IsPositive(length)) // else there is no glyph
        {
          own.Add(length);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      all.Add(own);
    });
  return all;
}
