#include "vtkGlyphSettings.h"

#include <algorithm>
#include <cmath>

//----------------------------------------------------------------------------
vtkGlyphSettings vtkGlyphSettings::Effective() const
{
  const vtkGlyphSettings none;
  vtkGlyphSettings settings = *this;
  if (settings.Shape != rtg::Shape::Arrow)
  {
    settings.Arrow = none.Arrow;
  }
  if (settings.Shape != rtg::Shape::Arrow || !settings.Scaling)
  {
    settings.ArrowReference = none.ArrowReference;
  }
  if (!settings.NeedsMeanScale())
  {
    settings.MeanScale = none.MeanScale;
  }
  if (!settings.Scaling)
  {
    settings.ScaleArray.clear();
    settings.ScaleMode = none.ScaleMode;
  }
  if (settings.Sizing.Function != vtkGlyphSizing::LOGARITHM)
  {
    settings.Sizing.Reference = none.Sizing.Reference;
  }
  if (!settings.Orient || settings.Tensors.On)
  {
    settings.Orient = false;
    settings.OrientationArray.clear();
    settings.OrientationMode = none.OrientationMode;
  }
  if (!settings.HasTable())
  {
    settings.TableSize = none.TableSize;
    settings.TableEntry = none.TableEntry;
    settings.TableIndexArray.clear();
  }
  if (settings.HasOwnExponents())
  {
    // In the nested form the third is not used.
    settings.Exponents[2] =
      settings.Shape == rtg::Shape::NestedSuperquadric ? none.Exponents[2] : settings.Exponents[2];
  }
  else
  {
    std::copy_n(none.Exponents, 3, settings.Exponents);
    settings.ExponentArray.clear();
  }
  settings.Tensors = settings.Tensors.Effective();
  settings.Motion = settings.Motion.Effective();
  if (!settings.Mask)
  {
    settings.MaximumNumberOfGlyphs = none.MaximumNumberOfGlyphs;
    settings.Seed = none.Seed;
  }
  return settings;
}

//----------------------------------------------------------------------------
vtkGlyphSettings vtkGlyphSettings::AxesOfTensors() const
{
  vtkGlyphSettings settings = *this;
  settings.Shape = rtg::Shape::Arrow;
  settings.Tensors.Axes = true;
  settings.Scaling &= settings.ScaleMode != COMPONENTS;
  settings.ScaleFactor = std::abs(settings.ScaleFactor);
  // Thin, so as to hide little, and of one form: short ones are small.
  settings.Arrow.shaftRadius = 0.015f;
  settings.Arrow.tipRadius = 0.05f;
  settings.Arrow.tipLength = 0.15f;
  settings.Arrow.tipRounding = 0.0f;
  settings.Arrow.fixedHeads = false;
  return settings;
}
