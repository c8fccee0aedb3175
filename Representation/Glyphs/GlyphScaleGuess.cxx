#include "GlyphScaleGuess.h"

#include "Finite.h"
#include "GlyphArrayRoles.h"
#include "GlyphTuples.h"
#include "RayTracedParallel.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace rtglyphs::GlyphSample;

///@{
// Lengths, as fractions of the data's longest side.
constexpr double largestGlyph = 0.2;
constexpr double exactlySeen = 1.0 / 200.0; // in a picture of all data; of sizes that the data say
constexpr double seen = 1.0 / 80.0;         // of others: a dozen pixels
constexpr double coincident = 1e-6;         // at the same place, but for rounding
constexpr double flat = 1e-3;               // along an axis that the data do not fill
///@}
// Ratios of the distances in most of the space and of most points: more than in any random points, and of a graded
// mesh.
constexpr double random = 2.5, graded = 10.0;
constexpr double specks = 0.1; // size of spheres that are far apart, as a fraction of the distance between neighbors
constexpr double mostNeighbors = 10.0; // size of spheres in another unit than their places, the same
constexpr double leastArea = 0.25;     // of all glyphs, as a fraction of that of as many of the typical size
constexpr double mostExcess = 2.0;     // so much smaller all glyphs become for the largest to fit
constexpr double manyLimited = 8.0;    // so many of the largest glyphs cover a quarter of the longest side's square
constexpr double few = 2000.0;         // so few are distinguishable, also where some touch
constexpr double arrowLength = 2.5;    // of typical glyphs' size: arrows are thin

// Where the points are.
struct Extents
{
  double Longest = 0.0;   // side of their box
  double Neighbors = 0.0; // usual distance, as a fraction of Longest; 0: all points coincide
  double Spacing = 0.0;   // mean, if they filled their box, as a fraction of Longest
};

// Squared distances, in units of `length`, from each of the pivots to the nearest point of this rank that is not at
// the same place.
std::vector<double> NearestSquared(const Points& points, const std::vector<double>& pivots, double length)
{
  const std::size_t count = pivots.size() / 3;
  std::vector<double> x(count), y(count), z(count);
  for (std::size_t j = 0; j < count; ++j)
  {
    x[j] = pivots[3 * j] / length;
    y[j] = pivots[3 * j + 1] / length;
    z[j] = pivots[3 * j + 2] / length;
  }
  return rtglyphs::RayTracedParallel::Reduce(
    points.Number(), std::vector<double>(count, HUGE_VAL),
    [&](vtkIdType begin, vtkIdType end, std::vector<double>& own)
    {
      rtglyphs::GlyphTuples positions(points.GetPositions());
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
    },
    [](std::vector<double>& all, const std::vector<double>& own)
    {
      std::transform(
        own.begin(), own.end(), all.begin(), all.begin(), [](double a, double b) { return std::min(a, b); });
    });
}

// The median of squared distances over the space that points fill: each counts as much as it has of that.
double MedianOfSpace(std::vector<double> squared, double axes)
{
  std::sort(squared.begin(), squared.end());
  const auto space = [axes](double square) { return std::pow(square, 0.5 * axes); };
  double all = 0.0, sum = 0.0;
  for (double square : squared)
  {
    all += space(square);
  }
  return *std::find_if(squared.begin(), squared.end() - 1,
    [&](double square)
    {
      sum += space(square);
      return sum >= 0.5 * all;
    });
}

Extents Measure(const Points& points, bool rough)
{
  // Few for many points, so that all of them can be compared with each in no time; 64 give a median to some percent.
  const double wanted = rough ? 64.0 : std::clamp(1e8 / std::max(points.NumberOfAll(), 1.0), 64.0, 512.0);
  const std::vector<double> pivots = points.SampledPositions(wanted);
  Extents extents;
  extents.Longest = LongestSide(pivots);
  if (!(extents.Longest > 0.0))
  {
    return extents;
  }

  double volume = 1.0, axes = 0.0;
  for (double side : Sides(pivots))
  {
    volume *= side > flat * extents.Longest ? side / extents.Longest : 1.0;
    axes += side > flat * extents.Longest ? 1.0 : 0.0;
  }
  extents.Spacing = std::pow(volume / points.NumberOfAll(), 1.0 / std::max(axes, 1.0));

  std::vector<double> nearest = NearestSquared(points, pivots, extents.Longest);
  rtglyphs::RayTracedRanks::Reduce(nearest, vtkCommunicator::MIN_OP);
  nearest.erase(std::remove(nearest.begin(), nearest.end(), HUGE_VAL), nearest.end());
  if (!nearest.empty())
  {
    // From the one to the other without a jump, so that meshes that are nearly alike have nearly the same size.
    const double ofPoints = std::sqrt(Quantile(nearest, 0.5));
    const double ratio = std::sqrt(MedianOfSpace(nearest, axes)) / ofPoints;
    extents.Neighbors =
      ofPoints * std::pow(ratio, std::clamp(std::log(ratio / random) / std::log(graded / random), 0.0, 1.0));
  }
  return extents;
}

// The factor that makes glyphs of typical magnitude so large; lengths are fractions of the longest side.
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

// Of spheres whose size the array says: 2 for radii, 1 for diameters; three equal components have a magnitude that is
// larger than each. Ellipsoids of covariances of places have their size, too. 0: there is no such array.
double ExactFactor(vtkPolyData* data, const rtglyphs::GlyphScaling& settings, double unitSize)
{
  if (settings.Tensors.Covariances)
  {
    return 1.0;
  }
  vtkDataArray* scales = rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::SCALE, data, settings);
  const int components = scales ? scales->GetNumberOfComponents() : 0;
  const bool sizes = (components == 1 || components == 3) && settings.Shape == rtg::Shape::Sphere &&
    !settings.Tensors.On && settings.Sizing.Function == rtglyphs::GlyphSizing::LINEAR;
  const bool byMagnitude = components == 3 && settings.ScaleMode == rtglyphs::GlyphScaling::MAGNITUDE;
  return sizes
    ? rtglyphs::GlyphArrayRoles::DiametersOf(settings.ScaleArray) / (byMagnitude ? std::sqrt(3.0) : 1.0) / unitSize
    : 0.0;
}

rtglyphs::GlyphKeptGuess::Result
Find(vtkPolyData* data, const rtglyphs::GlyphScaling& settings, double unitSize, bool rough)
{
  rtglyphs::GlyphKeptGuess::Result result;
  Points points(data, settings);
  std::vector<double> sample{ 1.0 };
  double largest = 1.0;
  if (settings.Scaling || settings.Tensors.On || settings.Forms.On)
  {
    const std::vector<double> magnitudes = Magnitudes(data, settings);
    sample = points.KeepPositive(magnitudes);
    largest = rtglyphs::RayTracedRanks::Largest(rtglyphs::RayTracedParallel::Largest(
      points.Number(), [&](vtkIdType i) { return magnitudes.empty() ? 1.0 : magnitudes[points[i]]; }));
  }
  if (points.NumberOfAll() == 0.0)
  {
    return result;
  }
  const Extents extents = Measure(points, rough);
  result.Extent = extents.Longest;
  const double typical = Quantile(sample, typicalQuantile);
  const double exact = rtglyphs::RayTracedRanks::Largest(ExactFactor(data, settings, unitSize));
  const double most = extents.Longest * std::max(1.0, mostNeighbors * extents.Neighbors);
  if (exact * typical >= extents.Longest * std::min(exactlySeen, specks * extents.Neighbors) && exact > 0.0 &&
    (exact * typical <= most || !(most > 0.0)))
  {
    result.Value = exact;
    return result;
  }
  if (!(extents.Longest > 0.0))
  {
    result.Value = TwoDigits(1.0 / typical / unitSize); // any size will do
    return result;
  }

  const double space = points.NumberOfAll() < few ? extents.Spacing : 0.5 * extents.Spacing;
  double size = std::max(0.9 * extents.Neighbors, std::min(seen, space));
  const bool arrows = (settings.Shape == rtg::Shape::Arrow && !settings.Tensors.On) || settings.IsOfVectors();
  size *= arrows ? arrowLength : 1.0;
  double factor = FactorFor(sample, std::min(size, largestGlyph));
  const double excess = factor * largest / largestGlyph;
  double limit = 0.0;
  if (excess > mostExcess)
  {
    const auto above = [&](double length)
    {
      const auto larger =
        std::count_if(sample.begin(), sample.end(), [&](double magnitude) { return factor * magnitude > length; });
      return static_cast<double>(larger) / static_cast<double>(sample.size());
    };
    const double number = above(largestGlyph) * points.NumberOfAll();
    limit = std::max(std::min(size, largestGlyph), largestGlyph / std::sqrt(std::max(1.0, number / manyLimited)));
    result.Limited = above(1.01 * limit); // visibly
  }
  else if (excess > 1.0)
  {
    factor /= excess;
  }
  factor *= extents.Longest / unitSize;
  if (rtg::IsPositive(factor))
  {
    result.Value = TwoDigits(factor);
    result.Limit = limit * extents.Longest / unitSize;
  }
  return result;
}
}

//----------------------------------------------------------------------------
const rtglyphs::GlyphKeptGuess::Result& rtglyphs::GlyphScaleGuess::Update(rtglyphs::GlyphKeptGuess& kept,
  vtkPolyData* points, const rtglyphs::GlyphSettings& settings, double unitSize, double time)
{
  rtglyphs::GlyphScaling scaling = settings.OfMagnitudes();
  vtkDataArray* scales = rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::SCALE, points, scaling);
  std::vector<double> has{ points->GetNumberOfPoints() > 0 ? 1.0 : 0.0, scales ? 1.0 : 0.0 };
  rtglyphs::RayTracedRanks::Reduce(has, vtkCommunicator::MAX_OP);
  if (has[0] == 0.0)
  {
    return kept.Last(); // a step without points changes nothing
  }
  if (has[1] == 0.0)
  {
    // A step that lacks the array says nothing of those that have it.
    scaling.Scaling = false;
    scaling.ScaleArray.clear();
  }
  unitSize = rtg::IsPositive(unitSize) ? unitSize : 1.0;
  return kept.Get(points, scaling, unitSize, time, [&](bool rough) { return Find(points, scaling, unitSize, rough); });
}
