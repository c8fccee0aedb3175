/**
 * Numbers of the points of all ranks: samples, quantiles, and what scales their glyphs. All ranks call at once what
 * says so, and get the same.
 */
#ifndef GlyphSample_h
#define GlyphSample_h

#include "RayTracedRanges.h"
#include "GlyphSettings.h"
#include "RayTracedParallel.h"
#include "RayTracedRanks.h"

#include <array>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace rtglyphs::GlyphSample
{
/**
 * The value below which that fraction of the values lies; there is at least one.
 */
constexpr double typicalQuantile = 0.95;
double Quantile(std::vector<double> values, double fraction);

/**
 * Down to two significant digits.
 */
double TwoDigits(double value);

/**
 * The points that carry glyphs. All ranks construct it at once.
 */
class Points
{
public:
  Points(vtkPolyData* points, const rtglyphs::GlyphScaling& scaling, const RayTracedRanges& hidden = {});

  /**
   * Leaves those of which isWanted(point) is true; all ranks at once.
   */
  template <class IsWanted>
  void Keep(const IsWanted& isWanted)
  {
    std::vector<vtkIdType> kept =
      RayTracedParallel::Select(this->Count, [&](vtkIdType i) { return isWanted((*this)[i]); });
    for (vtkIdType& point : kept)
    {
      point = (*this)[point];
    }
    this->SetChosen(std::move(kept));
  }

  /**
   * Leaves those whose value, of those of all points, is positive; Values() of them. Without values all are 1.
   */
  std::vector<double> KeepPositive(const std::vector<double>& values);

  vtkIdType Number() const { return this->Count; }
  double NumberOfAll() const { return this->CountOfAll; }
  vtkDataArray* GetPositions() const { return this->Positions; }
  vtkIdType operator[](vtkIdType i) const { return this->Thinned ? this->Chosen[i] : i; }

  /**
   * Evenly spread over the points of all ranks, at least one of each rank that has some; about `wanted` in all.
   */
  std::vector<vtkIdType> Sample(double wanted) const;

  /**
   * value(point) of a sample of all ranks' points, or the finite positions; all ranks at once.
   */
  template <class Value>
  std::vector<double> Values(const Value& value) const
  {
    std::vector<double> own;
    for (vtkIdType point : this->Sample(2e4))
    {
      own.push_back(value(point));
    }
    return RayTracedRanks::Gather(own);
  }
  std::vector<double> SampledPositions(double wanted) const;

private:
  void SetChosen(std::vector<vtkIdType> chosen);

  vtkDataArray* Positions;
  bool Thinned;
  vtkIdType Count;
  std::vector<vtkIdType> Chosen;
  double CountOfAll = 0.0;
};

/**
 * The sides of the box of positions, one after another, between its outer percentiles: a lost particle does not count.
 */
std::array<double, 3> Sides(const std::vector<double>& positions);

/**
 * The longest of the sides, or of the whole box. 0: there is none that is positive.
 */
double LongestSide(const std::vector<double>& positions);

///@{
/**
 * Of each of this rank's points what scales the longest axis (GlyphMagnitudes; empty: 1 for all), or the length of
 * arrows by the scale array alone; 0: it has no glyph.
 */
std::vector<double> Magnitudes(vtkPolyData* data, const rtglyphs::GlyphScaling& scaling);
std::vector<double> ArrowScales(vtkPolyData* data, const rtglyphs::GlyphScaling& scaling);
///@}
}

#endif
