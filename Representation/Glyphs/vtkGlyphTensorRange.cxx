#include "vtkGlyphTensorRange.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkRayTracedParallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using Range = std::array<double, 2>; // the least number, and the negative of the largest

constexpr Range nothing{ HUGE_VAL, HUGE_VAL };

Range Both(const Range& a, const Range& b)
{
  return { std::min(a[0], b[0]), std::min(a[1], b[1]) };
}

Range RangeOf(vtkDataArray* array, vtkIdType count, const vtkGlyphTensors::Settings& settings)
{
  const vtkGlyphTensors tensors(array, settings, {});
  std::vector<Range> ranges(vtkRayTracedParallel::NumberOfChunks(count), nothing);
  vtkRayTracedParallel::ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      Range own = nothing;
      double value = 0.0;
      for (vtkIdType point = begin; point < end; ++point)
      {
        if (tensors.Number(point, value))
        {
          own = Both(own, { value, -value });
        }
      }
      ranges[vtkRayTracedParallel::ChunkOf(begin)] = own;
    });
  Range all = nothing;
  for (const Range& range : ranges)
  {
    all = Both(all, range);
  }
  return all;
}
}

//----------------------------------------------------------------------------
std::array<double, 2>
vtkGlyphTensorRange::Get(vtkPolyData* points, const vtkGlyphTensors::Settings& settings, bool collective)
{
  vtkDataArray* array = points ? vtkGlyphTensors::Array(points, settings) : nullptr;
  const vtkMTimeType time = array ? array->GetMTime() : 0;
  if (time != this->Time || !(settings == this->Settings))
  {
    const bool good = array && vtkGlyphTensors::Problem(array, settings).empty();
    this->Own = good ? RangeOf(array, points->GetNumberOfPoints(), settings) : nothing;
    this->Time = time;
    this->Settings = settings;
  }
  Range all = this->Own;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (collective && controller && controller->GetNumberOfProcesses() > 1)
  {
    controller->AllReduce(this->Own.data(), all.data(), 2, vtkCommunicator::MIN_OP);
  }
  return all[0] <= -all[1] ? std::array<double, 2>{ all[0], -all[1] } : std::array<double, 2>{ 1.0, -1.0 };
}
