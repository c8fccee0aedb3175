#include "GlyphTensorRange.h"

#include "GlyphSample.h"
#include "RayTracedParallel.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using Range = std::array<double, 2>; // the least number, and the negative of the largest

constexpr Range nothing{ HUGE_VAL, HUGE_VAL };

void Include(Range& all, const Range& own)
{
  all = { std::min(all[0], own[0]), std::min(all[1], own[1]) };
}

Range RangeOfTensors(vtkDataArray* array, vtkIdType count, const rtglyphs::GlyphTensors::Settings& settings)
{
  const rtglyphs::GlyphTensors tensors(array, settings, {});
  return rtglyphs::RayTracedParallel::Reduce(
    count, nothing,
    [&](vtkIdType begin, vtkIdType end, Range& own)
    {
      double value = 0.0;
      for (vtkIdType point = begin; point < end; ++point)
      {
        if (tensors.Number(point, value))
        {
          Include(own, { value, -value });
        }
      }
    },
    &Include);
}

Range RangeOfPolynomials(vtkDataArray* array, const rtglyphs::GlyphForms::Settings& settings)
{
  const double largest = rtglyphs::GlyphForms::LargestRadius(array, settings);
  return largest > 0.0 ? Range{ 0.0, -largest } : nothing;
}
}

//----------------------------------------------------------------------------
std::array<double, 2> rtglyphs::GlyphTensorRange::Get(vtkPolyData* points, const rtglyphs::GlyphSettings& settings)
{
  const rtglyphs::GlyphTensors::Settings& tensors = settings.Tensors;
  const rtglyphs::GlyphForms::Settings& forms = settings.Forms;
  vtkDataArray* array = !points ? nullptr
    : forms.On                  ? rtglyphs::GlyphForms::Array(points, forms)
                                : rtglyphs::GlyphTensors::Array(points, tensors);
  this->Known.Update({ tensors, forms, array ? array->GetMTime() : 0 },
    [&]
    {
      const bool good = array &&
        (forms.On ? rtglyphs::GlyphForms::Problem(array, forms) : rtglyphs::GlyphTensors::Problem(array, tensors))
          .empty();
      this->Own = !good ? nothing
        : forms.On      ? RangeOfPolynomials(array, forms)
                        : RangeOfTensors(array, points->GetNumberOfPoints(), tensors);
    });
  std::vector<double> all(this->Own.begin(), this->Own.end());
  rtglyphs::RayTracedRanks::Reduce(all, vtkCommunicator::MIN_OP);
  return all[0] <= -all[1] ? std::array<double, 2>{ all[0], -all[1] } : std::array<double, 2>{ 1.0, -1.0 };
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphTensorRange::NegativeFraction(vtkPolyData* points, const rtglyphs::GlyphSettings& settings)
{
  constexpr double rounding = 1e-6;
  rtglyphs::GlyphTensors::Settings tensors;
  static_cast<rtglyphs::GlyphTensors::Source&>(tensors) = settings.Tensors;
  tensors.On = settings.Tensors.On || settings.Forms.On;
  vtkDataArray* array = points ? rtglyphs::GlyphTensors::Array(points, tensors) : nullptr;
  this->Counted.Update({ tensors, array ? array->GetMTime() : 0 },
    [&]
    {
      this->Counts = {};
      if (!array || !rtglyphs::GlyphTensors::Problem(array, tensors).empty())
      {
        return;
      }
      const rtglyphs::GlyphTensors all(array, tensors, {});
      this->Counts = rtglyphs::RayTracedParallel::Reduce(
        points->GetNumberOfPoints(), glm::dvec2(0.0),
        [&](vtkIdType begin, vtkIdType end, glm::dvec2& own)
        {
          rtg::Eigensystem eigen;
          for (vtkIdType point = begin; point < end; ++point)
          {
            const bool good = all.Decompose(point, eigen);
            const glm::dvec3& values = eigen.values;
            own[0] += good && values.z < -rounding * std::max(std::abs(values.x), std::abs(values.z)) ? 1.0 : 0.0;
            own[1] += good ? 1.0 : 0.0;
          }
        },
        [](glm::dvec2& all, const glm::dvec2& own) { all += own; });
    });
  std::vector<double> counts{ this->Counts[0], this->Counts[1] };
  rtglyphs::RayTracedRanks::Reduce(counts, vtkCommunicator::SUM_OP);
  return counts[1] > 0.0 ? counts[0] / counts[1] : 0.0;
}
