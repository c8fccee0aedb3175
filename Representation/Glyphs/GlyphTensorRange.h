/**
 * @class   GlyphTensorRange
 * @brief   least and largest number that colors tensor glyphs or polynomials, over all ranks
 */
#ifndef GlyphTensorRange_h
#define GlyphTensorRange_h

#include "GlyphSettings.h"
#include "RayTracedCache.h"
#include "vtkType.h"

#include <array>
#include <tuple>

class vtkPolyData;

namespace rtglyphs
{

class GlyphTensorRange
{
public:
  /**
   * An empty interval (1, -1) where there is no number. Radii of polynomials begin at 0. All ranks call it at once.
   * What this rank's array gives is kept while it and the settings are the same. `points` may be null.
   */
  std::array<double, 2> Get(vtkPolyData* points, const GlyphSettings& settings);

  /**
   * The fraction of the tensors, if glyphs show any, that have a negative eigenvalue, over all ranks.
   */
  double NegativeFraction(vtkPolyData* points, const GlyphSettings& settings);

private:
  std::array<double, 2> Own{}; // of this rank: the least number, and the negative of the largest
  RayTracedCache<std::tuple<GlyphTensors::Settings, GlyphForms::Settings, vtkMTimeType>> Known;
  glm::dvec2 Counts{ 0.0 }; // of this rank's tensors: with a negative eigenvalue, all
  RayTracedCache<std::tuple<GlyphTensors::Source, vtkMTimeType>> Counted;
};

} // namespace rtglyphs

#endif
