#include "GlyphScalePercentile.h"

#include "GlyphSample.h"

//----------------------------------------------------------------------------
double rtglyphs::GlyphScalePercentile::Get(
  vtkPolyData* points, const rtglyphs::GlyphSettings& settings, const rtglyphs::RayTracedRanges& hidden)
{
  if (!settings.NeedsScalePercentile())
  {
    return 0.0;
  }
  const rtglyphs::GlyphScaling scaling = settings.OfMagnitudes();
  rtglyphs::GlyphArrays::Key key = rtglyphs::GlyphArrays::KeyOf(points, { scaling }, hidden);
  if (rtglyphs::RayTracedRanks::Largest(this->Known.Holds(key) ? 0.0 : 1.0) > 0.0)
  {
    this->Known.Forget();
    this->Known.Update(std::move(key),
      [&]
      {
        rtglyphs::GlyphSample::Points glyphs(points, scaling, hidden);
        const std::vector<double> scales = glyphs.KeepPositive(rtglyphs::GlyphSample::ArrowScales(points, scaling));
        this->High =
          scales.empty() ? 1.0 : rtglyphs::GlyphSample::Quantile(scales, rtglyphs::GlyphSample::typicalQuantile);
      });
  }
  return this->High;
}
