#include "GlyphSample.h"

#include "Finite.h"
#include "GlyphSizes.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
// Coordinates along one axis.
std::vector<double> Along(int axis, const std::vector<double>& positions)
{
  std::vector<double> values;
  for (std::size_t j = axis; j < positions.size(); j += 3)
  {
    values.push_back(positions[j]);
  }
  return values;
}

// value(point, tuples) of each point.
template <class Value>
std::vector<double> Each(vtkPolyData* data, const rtglyphs::GlyphMagnitudes& all, const Value& value)
{
  std::vector<double> values(data->GetNumberOfPoints());
  rtglyphs::RayTracedParallel::ForChunks(data->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      rtglyphs::GlyphMagnitudes::Tuples tuples(all);
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[i] = value(i, tuples);
      }
    });
  return values;
}
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSample::Quantile(std::vector<double> values, double fraction)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSample::TwoDigits(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  const double digits = std::floor(value / unit * (1.0 + 1e-12));
  return rtg::IsPositive(unit) && digits > 0.0 ? (unit < 1.0 ? digits / std::round(1.0 / unit) : digits * unit) : value;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSample::Points::Points(
  vtkPolyData* points, const rtglyphs::GlyphScaling& scaling, const rtglyphs::RayTracedRanges& hidden)
  : Positions(points->GetPoints() ? points->GetPoints()->GetData() : nullptr)
  , Thinned(false)
  , Count(Positions ? points->GetNumberOfPoints() : 0)
  , CountOfAll(static_cast<double>(Count))
{
  if (scaling.Mask.On || !hidden.empty())
  {
    this->SetChosen(rtglyphs::GlyphArrays::Candidates(points, scaling, hidden));
    return;
  }
  std::vector<double> count{ this->CountOfAll };
  rtglyphs::RayTracedRanks::Reduce(count, vtkCommunicator::SUM_OP);
  this->CountOfAll = count[0];
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSample::Points::SetChosen(std::vector<vtkIdType> chosen)
{
  this->Chosen = std::move(chosen);
  this->Thinned = true;
  this->Count = static_cast<vtkIdType>(this->Chosen.size());
  std::vector<double> count{ static_cast<double>(this->Count) };
  rtglyphs::RayTracedRanks::Reduce(count, vtkCommunicator::SUM_OP);
  this->CountOfAll = count[0];
}

//----------------------------------------------------------------------------
std::vector<vtkIdType> rtglyphs::GlyphSample::Points::Sample(double wanted) const
{
  const double fraction = std::min(1.0, wanted / std::max(this->CountOfAll, 1.0));
  const auto number = static_cast<vtkIdType>(std::ceil(fraction * static_cast<double>(this->Count)));
  std::vector<vtkIdType> sample(number);
  for (vtkIdType k = 0; k < number; ++k)
  {
    const double middle = (static_cast<double>(k) + 0.5) / static_cast<double>(number);
    sample[k] = (*this)[std::min(static_cast<vtkIdType>(middle * static_cast<double>(this->Count)), this->Count - 1)];
  }
  return sample;
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::GlyphSample::Points::SampledPositions(double wanted) const
{
  std::vector<double> own;
  rtglyphs::GlyphTuples positions(this->Positions);
  for (vtkIdType i : this->Sample(wanted))
  {
    const double* p = positions.Get(i);
    if (rtg::IsFinite(p))
    {
      own.insert(own.end(), p, p + 3);
    }
  }
  return rtglyphs::RayTracedRanks::Gather(own);
}

//----------------------------------------------------------------------------
std::array<double, 3> rtglyphs::GlyphSample::Sides(const std::vector<double>& positions)
{
  std::array<double, 3> sides{};
  for (int axis = 0; axis < 3 && !positions.empty(); ++axis)
  {
    const std::vector<double> values = Along(axis, positions);
    sides[axis] = Quantile(values, 0.99) - Quantile(values, 0.01);
  }
  return sides;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSample::LongestSide(const std::vector<double>& positions)
{
  const std::array<double, 3> sides = Sides(positions);
  double longest = *std::max_element(sides.begin(), sides.end()), whole = 0.0;
  for (int axis = 0; axis < 3 && !positions.empty(); ++axis)
  {
    const std::vector<double> values = Along(axis, positions);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    whole = std::max(whole, *most - *least);
  }
  longest = longest > 0.0 ? longest : whole;
  return rtg::IsPositive(longest) ? longest : 0.0;
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::GlyphSample::Points::KeepPositive(const std::vector<double>& values)
{
  const auto of = [&values](vtkIdType point) { return values.empty() ? 1.0 : values[point]; };
  this->Keep([&of](vtkIdType point) { return of(point) > 0.0; });
  return this->Values(of);
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::GlyphSample::Magnitudes(vtkPolyData* data, const rtglyphs::GlyphScaling& scaling)
{
  const rtglyphs::GlyphMagnitudes all(data, scaling);
  const bool same = !all.HasScales() && !scaling.Tensors.On && !scaling.Forms.On;
  return same ? std::vector<double>()
              : Each(data, all, [&](vtkIdType i, auto& tuples) { return all.Magnitude(i, tuples); });
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::GlyphSample::ArrowScales(vtkPolyData* data, const rtglyphs::GlyphScaling& scaling)
{
  const rtglyphs::GlyphMagnitudes all(data, scaling);
  return Each(data, all,
    [&](vtkIdType i, auto& tuples)
    {
      const double length = all.HasScales() ? std::abs(all.Scale(i, tuples).x) : 0.0;
      return rtg::IsPositive(length) ? length : 0.0;
    });
}
