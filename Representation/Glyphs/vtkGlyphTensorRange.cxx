#include "vtkGlyphTensorRange.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkGlyphSample.h"
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

Range RangeOfTensors(vtkDataArray* array, vtkIdType count, const vtkGlyphTensors::Settings& settings)
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

Range RangeOfPolynomials(vtkDataArray* array, const vtkGlyphForms::Settings& settings)
{
  const double largest = vtkGlyphForms::LargestRadius(array, settings);
  return largest > 0.0 ? Range{ 0.0, -largest } : nothing;
}
}

//----------------------------------------------------------------------------
std::array<double, 2> vtkGlyphTensorRange::Get(vtkPolyData* points, const vtkGlyphSettings& settings, bool collective)
{
  const vtkGlyphTensors::Settings& tensors = settings.Tensors;
  const vtkGlyphForms::Settings& forms = settings.Forms;
  vtkDataArray* array = !points ? nullptr
    : forms.On                  ? vtkGlyphForms::Array(points, forms)
                                : vtkGlyphTensors::Array(points, tensors);
  this->Known.Update({ tensors, forms, array ? array->GetMTime() : 0 },
    [&]
    {
      const bool good =
        array && (forms.On ? vtkGlyphForms::Problem(array, forms) : vtkGlyphTensors::Problem(array, tensors)).empty();
      this->Own = !good ? nothing
        : forms.On      ? RangeOfPolynomials(array, forms)
                        : RangeOfTensors(array, points->GetNumberOfPoints(), tensors);
    });
  std::vector<double> all(this->Own.begin(), this->Own.end());
  if (collective)
  {
    vtkGlyphSample::Reduce(all, vtkCommunicator::MIN_OP);
  }
  return all[0] <= -all[1] ? std::array<double, 2>{ all[0], -all[1] } : std::array<double, 2>{ 1.0, -1.0 };
}
