#include "GlyphShutterGuess.h"

#include "Finite.h"
#include "GlyphTuples.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using namespace rtglyphs::GlyphSample;

constexpr double streak = 3.0;              // in sizes of typical glyphs
constexpr double streakOfNoSize = 1.0 / 20; // as a fraction of the data's longest side
constexpr double longestStreak = 0.5;       // the same

// Of a glyph; 0: it has none, or there are no glyphs. Settings of ranks may differ.
double TypicalSize(vtkPolyData* data, const rtglyphs::GlyphSettings& settings, Points points)
{
  double typical = 1.0;
  if (rtglyphs::RayTracedRanks::Largest(settings.Scaling || settings.Tensors.On || settings.Forms.On ? 1.0 : 0.0) > 0.0)
  {
    const std::vector<double> sample = points.KeepPositive(Magnitudes(data, settings));
    typical = sample.empty() ? 0.0 : Quantile(sample, typicalQuantile);
  }
  return rtglyphs::RayTracedRanks::Largest(settings.Length(typical));
}

rtglyphs::GlyphKeptGuess::Result Find(vtkPolyData* data, const rtglyphs::GlyphSettings& settings, double unitSize)
{
  const rtglyphs::GlyphMotion::Settings& motion = settings.Motion;
  const std::array<vtkDataArray*, 4> arrays = rtglyphs::GlyphMotion::Arrays(data, motion);
  const auto isThere = [&](int kind) { return rtglyphs::RayTracedRanks::Largest(arrays[kind] ? 1.0 : 0.0) > 0.0; };
  const int kind = isThere(0) ? 0 : isThere(1) ? 1 : 2; // velocities, accelerations, angular velocities
  vtkDataArray* array = arrays[kind];
  array = array && array->GetNumberOfComponents() <= 3 ? array : nullptr;
  const auto speed = [array](vtkIdType point)
  {
    double tuple[3] = { 0.0, 0.0, 0.0 };
    if (array)
    {
      array->GetTuple(point, tuple);
    }
    return vtkMath::Norm(tuple);
  };
  const Points all(data, settings);
  Points moving = all;
  moving.Keep([&](vtkIdType point) { return rtg::IsPositive(speed(point)); });
  if (moving.NumberOfAll() == 0.0)
  {
    return {};
  }
  const double typical = Quantile(moving.Values(speed), typicalQuantile);
  if (kind == 2)
  {
    return { TwoDigits(1.0 / typical) };
  }
  const double longest = LongestSide(all.SampledPositions(512));
  const double fastest = rtglyphs::RayTracedRanks::Largest(
    rtglyphs::RayTracedParallel::Largest(moving.Number(), [&](vtkIdType i) { return speed(moving[i]); }));
  const double size = TypicalSize(data, settings, all) * unitSize;
  const double length = size > 0.0 ? streak * size : streakOfNoSize * longest;
  double time = std::min(length / typical, std::max(length, longestStreak * longest) / fastest);
  if (kind == 1) // from rest, in both halves of a centered shutter the same way
  {
    time = (motion.Opening == rtglyphs::GlyphMotion::CENTERED ? 2.0 : 1.0) * std::sqrt(2.0 * time);
  }
  return { rtg::IsPositive(time) ? TwoDigits(time) : 0.0 };
}
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphShutterGuess::Update(rtglyphs::GlyphKeptGuess& kept, vtkPolyData* points,
  const rtglyphs::GlyphSettings& settings, double unitSize, double time)
{
  if (rtglyphs::RayTracedRanks::Largest(points->GetNumberOfPoints() > 0 ? 1.0 : 0.0) == 0.0)
  {
    return kept.Last().Value; // a step without points changes nothing
  }
  rtglyphs::GlyphSettings matter = settings.OfMagnitudes();
  matter.ScaleFactor = settings.ScaleFactor;
  matter.Sizing = settings.Sizing;
  matter.Motion.On = settings.Motion.On;
  matter.Motion.Velocity = settings.Motion.Velocity;
  matter.Motion.Acceleration = settings.Motion.Acceleration;
  matter.Motion.AngularVelocity = settings.Motion.AngularVelocity;
  matter.Motion.Opening = settings.Motion.Opening;
  unitSize = rtg::IsPositive(unitSize) ? unitSize : 1.0;
  return kept.Get(points, matter, unitSize, time, [&](bool) { return Find(points, matter, unitSize); }).Value;
}
