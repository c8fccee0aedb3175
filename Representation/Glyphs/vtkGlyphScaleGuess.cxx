#include "vtkGlyphScaleGuess.h"

#include "Finite.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkGlyphArrayNames.h"
#include "vtkGlyphTuples.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedParallel.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
///@{
// Lengths, as shares of the data's longest side.
constexpr double largestGlyph = 0.2;
constexpr double seen = 1.0 / 200.0; // in a picture of all data
constexpr double coincident = 1e-6;  // at the same place, but for rounding
constexpr double flat = 1e-3;        // along an axis that the data do not fill
///@}
constexpr double specks = 0.1; // size of spheres that are far apart, as a share of the distance between neighbors
constexpr double typicalQuantile = 0.95;
constexpr double leastArea = 0.25;  // of all glyphs, as a share of that of as many of the typical size
constexpr double mostExcess = 2.0;  // so much smaller all glyphs become for the largest to fit
constexpr double manyLimited = 8.0; // so many of the largest glyphs cover a quarter of the longest side's square
constexpr double arrowLength = 2.5; // of typical glyphs' size: arrows are thin

vtkMultiProcessController* Others()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

void Reduce(std::vector<double>& values, int operation)
{
  if (vtkMultiProcessController* controller = Others())
  {
    const std::vector<double> own = values;
    controller->AllReduce(own.data(), values.data(), static_cast<vtkIdType>(own.size()), operation);
  }
}

double Reduce(double value, int operation)
{
  std::vector<double> values{ value };
  Reduce(values, operation);
  return values[0];
}

// Those of all ranks, one rank after another.
std::vector<double> Gather(const std::vector<double>& own)
{
  vtkMultiProcessController* controller = Others();
  if (!controller)
  {
    return own;
  }
  const int ranks = controller->GetNumberOfProcesses();
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(ranks), offsets(ranks, 0);
  controller->AllGather(&length, lengths.data(), 1);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<double> all(offsets.back() + lengths.back());
  controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  return all;
}

// Of at least one value.
double Quantile(std::vector<double> values, double share)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// Down to two significant digits.
double TwoDigits(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  const double digits = std::floor(value / unit * (1.0 + 1e-12));
  return rtg::IsPositive(unit) && digits > 0.0 ? (unit < 1.0 ? digits / std::round(1.0 / unit) : digits * unit) : value;
}

// The points that carry glyphs.
class Points
{
public:
  Points(vtkPolyData* points, const vtkGlyphSettings& settings)
    : Positions(points->GetPoints() ? points->GetPoints()->GetData() : nullptr)
    , Thinned(settings.Mask.On)
    , Count(Positions ? points->GetNumberOfPoints() : 0)
  {
    if (this->Thinned)
    {
      this->Chosen = vtkGlyphArrays::Candidates(points, settings, {});
      this->Count = static_cast<vtkIdType>(this->Chosen.size());
    }
    this->CountOfAll = Reduce(static_cast<double>(this->Count), vtkCommunicator::SUM_OP);
  }

  // Leaves those of which isWanted(point) is true; all ranks at once.
  template <class IsWanted>
  void Keep(const IsWanted& isWanted)
  {
    std::vector<vtkIdType> kept =
      vtkRayTracedParallel::Select(this->Count, [&](vtkIdType i) { return isWanted((*this)[i]); });
    for (vtkIdType& point : kept)
    {
      point = (*this)[point];
    }
    this->Chosen = std::move(kept);
    this->Thinned = true;
    this->Count = static_cast<vtkIdType>(this->Chosen.size());
    this->CountOfAll = Reduce(static_cast<double>(this->Count), vtkCommunicator::SUM_OP);
  }

  vtkIdType Number() const { return this->Count; }
  double NumberOfAll() const { return this->CountOfAll; }
  vtkDataArray* GetPositions() const { return this->Positions; }
  vtkIdType operator[](vtkIdType i) const { return this->Thinned ? this->Chosen[i] : i; }

  // Evenly spread over the points of all ranks, at least one of each rank that has some; about `wanted` in all.
  std::vector<vtkIdType> Sample(double wanted) const
  {
    const double share = std::min(1.0, wanted / std::max(this->CountOfAll, 1.0));
    const auto number = static_cast<vtkIdType>(std::ceil(share * static_cast<double>(this->Count)));
    std::vector<vtkIdType> sample(number);
    for (vtkIdType k = 0; k < number; ++k)
    {
      const double middle = (static_cast<double>(k) + 0.5) / static_cast<double>(number);
      sample[k] = (*this)[std::min(static_cast<vtkIdType>(middle * static_cast<double>(this->Count)), this->Count - 1)];
    }
    return sample;
  }

private:
  vtkDataArray* Positions;
  bool Thinned;
  vtkIdType Count;
  std::vector<vtkIdType> Chosen;
  double CountOfAll = 0.0;
};

// Where the points are.
struct Extents
{
  double Longest = 0.0;   // side of their box
  double Neighbors = 0.0; // usual distance, as a share of Longest; 0: all are in one place
  double Spacing = 0.0;   // mean, if they filled their box, as a share of Longest
};

// Squared distances, in units of `length`, from each of the pivots to the nearest point of this rank that is not at
// the same place.
std::vector<double> NearestSquared(const Points& points, const std::vector<double>& pivots, double length)
{
  const std::size_t count = pivots.size() / 3;
  std::vector<double> x(count), y(count), z(count), nearest(count, HUGE_VAL);
  for (std::size_t j = 0; j < count; ++j)
  {
    x[j] = pivots[3 * j] / length;
    y[j] = pivots[3 * j + 1] / length;
    z[j] = pivots[3 * j + 2] / length;
  }
  std::vector<std::vector<double>> found(vtkRayTracedParallel::NumberOfChunks(points.Number()));
  vtkRayTracedParallel::ForChunks(points.Number(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGlyphTuples positions(points.GetPositions());
      std::vector<double> own(count, HUGE_VAL);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double* p = positions.Get(points[i]);
        const double px = p[0] / length, py = p[1] / length, pz = p[2] / length;
        for (std::size_t j = 0; j < count; ++j)
        {
          const double dx = px - x[j], dy = py - y[j], dz = pz - z[j];
          const double d = dx * dx + dy * dy + dz * dz; // NaN is never less
          own[j] = d > coincident * coincident && d < own[j] ? d : own[j];
        }
      }
      found[vtkRayTracedParallel::ChunkOf(begin)] = std::move(own);
    });
  for (const std::vector<double>& own : found)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      nearest[j] = std::min(nearest[j], own[j]);
    }
  }
  return nearest;
}

Extents Measure(const Points& points)
{
  // Few for many points, so that all of them can be compared with each in no time; 64 tell a median to some percent.
  const double wanted = std::clamp(1e8 / std::max(points.NumberOfAll(), 1.0), 64.0, 512.0);
  std::vector<double> own;
  vtkGlyphTuples positions(points.GetPositions());
  for (vtkIdType i : points.Sample(wanted))
  {
    const double* p = positions.Get(i);
    if (rtg::IsFinite(p))
    {
      own.insert(own.end(), p, p + 3);
    }
  }
  const std::vector<double> pivots = Gather(own);
  Extents extents;
  if (pivots.empty())
  {
    return extents;
  }
  double sides[3], whole = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> values;
    for (std::size_t j = axis; j < pivots.size(); j += 3)
    {
      values.push_back(pivots[j]);
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    whole = std::max(whole, *most - *least);
    sides[axis] = Quantile(values, 0.99);
    sides[axis] -= Quantile(values, 0.01);
    extents.Longest = std::max(extents.Longest, sides[axis]);
  }
  extents.Longest = extents.Longest > 0.0 ? extents.Longest : whole;
  if (!rtg::IsPositive(extents.Longest))
  {
    extents.Longest = 0.0;
    return extents;
  }

  double volume = 1.0, axes = 0.0;
  for (double side : sides)
  {
    volume *= side > flat * extents.Longest ? side / extents.Longest : 1.0;
    axes += side > flat * extents.Longest ? 1.0 : 0.0;
  }
  extents.Spacing = std::pow(volume / points.NumberOfAll(), 1.0 / std::max(axes, 1.0));

  std::vector<double> nearest = NearestSquared(points, pivots, extents.Longest);
  Reduce(nearest, vtkCommunicator::MIN_OP);
  nearest.erase(std::remove(nearest.begin(), nearest.end(), HUGE_VAL), nearest.end());
  extents.Neighbors = nearest.empty() ? 0.0 : std::sqrt(Quantile(nearest, 0.5));
  return extents;
}

// What scales each of this rank's points besides the factor: of its longest axis; 0: it has no glyph. Empty: 1 for all.
std::vector<double> Magnitudes(vtkPolyData* data, const vtkGlyphSettings& settings)
{
  vtkDataArray* scales = vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, data, settings);
  if (!scales && !settings.Tensors.On && !settings.Forms.On)
  {
    return {};
  }
  const bool byComponents = vtkGlyphArrays::ScalesByComponents(scales, settings);
  vtkDataArray* array = vtkGlyphTensors::Array(data, settings.Tensors);
  std::unique_ptr<vtkGlyphTensors> tensors;
  if (array && vtkGlyphTensors::Problem(array, settings.Tensors).empty())
  {
    vtkGlyphTensors::Settings how = settings.Tensors;
    how.Kind = rtg::TensorGlyphKind::Ellipsoid; // whose extent is the largest eigenvalue
    tensors = std::make_unique<vtkGlyphTensors>(array, how, std::vector<vtkIdType>());
  }
  vtkDataArray* formArray = vtkGlyphForms::Array(data, settings.Forms);
  std::unique_ptr<vtkGlyphForms> forms;
  if (formArray && vtkGlyphForms::Problem(formArray, settings.Forms).empty())
  {
    forms = std::make_unique<vtkGlyphForms>(formArray, settings.Forms);
  }
  std::vector<double> magnitudes(data->GetNumberOfPoints());
  vtkRayTracedParallel::ForChunks(data->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkGlyphTuples tuples(scales), formTuples(formArray);
      for (vtkIdType i = begin; i < end; ++i)
      {
        double magnitude = settings.Tensors.On ? (tensors ? settings.Sizing(tensors->Extent(i)) : 0.0) : 1.0;
        if (settings.Forms.On)
        {
          const rtg::FormExtent extent = forms ? forms->MeasureRoughly(formTuples, i) : rtg::FormExtent();
          magnitude = extent.radius > 0.0 ? settings.Sizing(forms->Magnitude(extent)) : 0.0;
        }
        if (scales)
        {
          const double* tuple = tuples.Get(i);
          magnitude *=
            settings.Sizing(byComponents ? std::max({ std::abs(tuple[0]), std::abs(tuple[1]), std::abs(tuple[2]) })
                                         : vtkMath::Norm(tuple, tuples.Size()));
        }
        magnitudes[i] = rtg::IsPositive(magnitude) ? magnitude : 0.0;
      }
    });
  return magnitudes;
}

// The factor that makes glyphs of typical magnitude so large; lengths are shares of the longest side.
double FactorFor(const std::vector<double>& magnitudes, double size)
{
  const auto area = [&](double factor)
  {
    double sum = 0.0;
    for (double magnitude : magnitudes)
    {
      const double length = std::min(factor * magnitude, largestGlyph);
      sum += length * length;
    }
    return sum / static_cast<double>(magnitudes.size());
  };
  const double bySize = size / Quantile(magnitudes, typicalQuantile);
  const double wanted = leastArea * size * size;
  if (area(bySize) >= wanted)
  {
    return bySize;
  }
  // Most of the glyphs are much smaller than the typical one.
  double low = std::log(bySize), high = low;
  do
  {
    high += 1.0;
  } while (area(std::exp(high)) < wanted);
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (area(std::exp(middle)) < wanted ? low : high) = middle;
  }
  return std::exp(low);
}

// Of spheres whose size the array says: 2 for radii, 1 for diameters. 0: there is no such array.
double ExactFactor(vtkPolyData* data, const vtkGlyphSettings& settings)
{
  vtkDataArray* scales = vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, data, settings);
  const bool sizes = scales && scales->GetNumberOfComponents() == 1 && settings.Shape == rtg::Shape::Sphere &&
    !settings.Tensors.On && settings.Sizing.Function == vtkGlyphSizing::LINEAR;
  return !sizes                                           ? 0.0
    : vtkGlyphArrayNames::IsRadius(settings.ScaleArray)   ? 2.0
    : vtkGlyphArrayNames::IsDiameter(settings.ScaleArray) ? 1.0
                                                          : 0.0;
}

vtkGlyphScaleGuess::Result Find(vtkPolyData* data, const vtkGlyphSettings& settings, double unitSize)
{
  vtkGlyphScaleGuess::Result result;
  Points points(data, settings);
  std::vector<double> sample{ 1.0 };
  double largest = 1.0;
  if (settings.Scaling || settings.Tensors.On || settings.Forms.On)
  {
    const std::vector<double> magnitudes = Magnitudes(data, settings);
    const auto of = [&](vtkIdType point) { return magnitudes.empty() ? 1.0 : magnitudes[point]; };
    points.Keep([&](vtkIdType point) { return of(point) > 0.0; });
    largest = Reduce(vtkRayTracedParallel::Largest(points.Number(), [&](vtkIdType i) { return of(points[i]); }),
      vtkCommunicator::MAX_OP);
    std::vector<double> own;
    for (vtkIdType point : points.Sample(2e4))
    {
      own.push_back(of(point));
    }
    sample = Gather(own);
  }
  if (points.NumberOfAll() == 0.0)
  {
    return result;
  }
  const Extents extents = Measure(points);
  const double typical = Quantile(sample, typicalQuantile);
  const double exact = Reduce(ExactFactor(data, settings), vtkCommunicator::MAX_OP);
  if (exact * typical >= extents.Longest * std::min(seen, specks * extents.Neighbors) && exact > 0.0)
  {
    result.Factor = exact;
    return result;
  }
  if (!(extents.Longest > 0.0))
  {
    result.Factor = TwoDigits(1.0 / typical / unitSize); // any size will do
    return result;
  }

  double size = std::max(0.9 * extents.Neighbors, std::min(seen, 0.5 * extents.Spacing));
  size *= settings.Shape == rtg::Shape::Arrow && !settings.Tensors.On ? arrowLength : 1.0;
  double factor = FactorFor(sample, std::min(size, largestGlyph));
  const double excess = factor * largest / largestGlyph;
  double limit = 0.0;
  if (excess > mostExcess)
  {
    const auto limited =
      std::count_if(sample.begin(), sample.end(), [&](double magnitude) { return factor * magnitude > largestGlyph; });
    const double number = static_cast<double>(limited) * points.NumberOfAll() / static_cast<double>(sample.size());
    limit = std::max(std::min(size, largestGlyph), largestGlyph / std::sqrt(std::max(1.0, number / manyLimited)));
  }
  else if (excess > 1.0)
  {
    factor /= excess;
  }
  factor *= extents.Longest / unitSize;
  if (rtg::IsPositive(factor))
  {
    result.Factor = TwoDigits(factor);
    result.Limit = limit * extents.Longest / unitSize;
  }
  return result;
}
}

//----------------------------------------------------------------------------
const vtkGlyphScaleGuess::Result&
vtkGlyphScaleGuess::Get(vtkPolyData* points, const vtkGlyphSettings& settings, double unitSize, double time)
{
  vtkGlyphSettings matter;
  matter.Shape = settings.Shape;
  matter.Scaling = settings.Scaling;
  matter.ScaleArray = settings.Scaling ? settings.ScaleArray : std::string();
  matter.ScaleMode = settings.ScaleMode;
  matter.Sizing.Function = settings.Sizing.Function;
  matter.Sizing.Reference = settings.Sizing.Reference;
  matter.Tensors.On = settings.Tensors.On;
  matter.Tensors.Array = settings.Tensors.On ? settings.Tensors.Array : std::string();
  matter.Tensors.Layout = settings.Tensors.Layout;
  matter.Forms = settings.Forms.Effective();
  matter.Forms.Coloring = vtkGlyphTensors::NONE;
  matter.Mask = settings.Mask.Effective();

  std::vector<vtkMTimeType> times;
  for (vtkDataArray* array : { points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
         vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, points, matter), vtkGlyphTensors::Array(points, matter.Tensors),
         vtkGlyphForms::Array(points, matter.Forms) })
  {
    times.push_back(array ? array->GetMTime() : 0);
  }
  const bool otherData = times != this->Times && time == this->Time;
  const bool wanted = !this->IsKnown || otherData || unitSize != this->UnitSize || !(matter == this->Settings);
  this->Settings = matter;
  this->UnitSize = unitSize;
  this->Times = times;
  this->Time = time;
  // One rank's reason is all ranks'.
  if (Reduce(wanted ? 1.0 : 0.0, vtkCommunicator::MAX_OP) > 0.0)
  {
    this->Found = Find(points, matter, rtg::IsPositive(unitSize) ? unitSize : 1.0);
    this->IsKnown = this->Found.Factor > 0.0;
  }
  return this->Found;
}
