#include "vtkGlyphHighScale.h"

#include "vtkGlyphSample.h"

//----------------------------------------------------------------------------
double vtkGlyphHighScale::Get(
  vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!settings.NeedsHighScale())
  {
    return 0.0;
  }
  const vtkGlyphScaling scaling = settings.OfMagnitudes();
  const bool changed = this->Known.Update(vtkGlyphArrays::KeyOf(points, { scaling }, blocks), [] {});
  if (vtkGlyphSample::Largest(changed ? 1.0 : 0.0) > 0.0)
  {
    vtkGlyphSample::Points glyphs(points, scaling, blocks);
    const std::vector<double> scales = glyphs.KeepPositive(vtkGlyphSample::ArrowScales(points, scaling));
    this->High = scales.empty() ? 1.0 : vtkGlyphSample::Quantile(scales, vtkGlyphSample::typicalQuantile);
  }
  return this->High;
}
