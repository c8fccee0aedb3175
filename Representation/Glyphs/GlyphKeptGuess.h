/**
 * @class   GlyphKeptGuess
 * @brief   a number that the data suggest, kept while time goes on
 *
 * It is found anew when the settings that it depends on have changed, or the data, unless the time has changed with
 * them: over the steps of an animation a picture must not pulse. What a step suggests is taken only where the number of
 * the steps before is more than 2.5 times as large: of a motion that sets in, or of loads that grow from zero, too much
 * would be shown. So the number changes seldom, and of steps that are shown again it is the same. It grows only where
 * the points come to fill a space more than 2.5 times as long, as a spray does; steps of little space then do not
 * count.
 */
#ifndef GlyphKeptGuess_h
#define GlyphKeptGuess_h

#include "GlyphSample.h"
#include "GlyphTuples.h"

#include <algorithm>
#include <utility>

namespace rtglyphs
{

class GlyphKeptGuess
{
public:
  static constexpr double mostExcess = 2.5;

  /**
   * Value of 0: the data suggest nothing yet, which is not kept. Limit of the sizes that it leads to, which outliers
   * have; 0: none. Limited: the fraction of all that have it. Extent: the longest side of the points, if it matters.
   */
  struct Result
  {
    double Value = 0.0, Limit = 0.0, Limited = 0.0, Extent = 0.0;
  };

  /**
   * For these settings, which are all that matter, and the length of the unit glyph. All ranks call it at once;
   * find(rough) gives all of them the same, and may do with less work when `rough` is true.
   */
  template <class Find>
  const Result& Get(vtkPolyData* points, const GlyphSettings& settings, double unitSize, double time, const Find& find)
  {
    GlyphArrays::Key key = GlyphArrays::KeyOf(points, { settings }, {});
    const bool otherData = key.Times != this->Known.Times;
    const bool otherStep = otherData && time != this->Time;
    const bool anew = this->Found.Value <= 0.0 || !(key.Settings == this->Known.Settings) ||
      unitSize != this->UnitSize || (otherData && !otherStep);
    // The reason of one rank is that of all.
    const double reason = RayTracedRanks::Largest(anew ? 2.0 : otherStep ? 1.0 : 0.0);
    if (reason > 0.0)
    {
      const bool onlyTime = reason == 1.0;
      const Result found = find(onlyTime);
      const bool narrow = mostExcess * found.Extent < this->Found.Extent;
      const bool isExceeded = !narrow && found.Value > 0.0 && mostExcess * found.Value < this->Found.Value;
      const bool isOutgrown =
        found.Extent > mostExcess * this->Found.Extent && found.Value > mostExcess * this->Found.Value;
      if (!onlyTime || isExceeded || isOutgrown)
      {
        this->Found = onlyTime ? find(false) : found;
      }
      else if (found.Limit > 0.0 && !narrow)
      {
        this->Found.Limit = this->Found.Limit > 0.0 ? std::min(this->Found.Limit, found.Limit) : found.Limit;
        this->Found.Limited = found.Limited;
      }
    }
    this->Known = std::move(key);
    this->UnitSize = unitSize;
    this->Time = time;
    return this->Found;
  }

  const Result& Last() const { return this->Found; }

  /**
   * Makes Get() find it anew.
   */
  void Forget() { this->Found = Result(); }

private:
  Result Found;
  GlyphArrays::Key Known;
  double UnitSize = 0.0, Time = 0.0;
};

} // namespace rtglyphs

#endif
