#include "GlyphForms.h"

#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{
using FormSettings = rtglyphs::GlyphForms::Settings;

struct FormKind
{
  const char *Need, *Property, *Counts; // for messages
  bool (*Fits)(vtkDataArray*, const FormSettings&);
  rtg::FormMap (*Map)(int components, const FormSettings&);
};
// In the order of GlyphForms::Kinds.
const FormKind formKinds[] = {
  { "Spherical harmonics need coefficients", "GlyphHarmonicsArray", "1, 6, 15, 28, 45, 66 or 91",
    [](vtkDataArray* array, const FormSettings&)
    { return rtg::FormMap::IsHarmonicsLength(array->GetNumberOfComponents()); },
    [](int components, const FormSettings& settings) { return rtg::FormMap::Harmonics(components, settings.Basis); } },
  { "Tensor glyphs need tensors", "GlyphTensorArray", "6 or 9",
    [](vtkDataArray* array, const FormSettings& settings)
    { return static_cast<bool>(rtglyphs::GlyphTensors::Order(array, settings.Layout)); },
    [](int, const FormSettings&) { return rtg::FormMap::NormalStress(); } },
  { "Tensor glyphs need tensors", "GlyphTensorArray", "15, 21, 36 or 81",
    [](vtkDataArray* array, const FormSettings&)
    { return rtg::FormMap::IsFourthOrderLength(array->GetNumberOfComponents()); },
    [](int components, const FormSettings&) { return rtg::FormMap::FourthOrder(components); } },
};
}

//----------------------------------------------------------------------------
rtglyphs::GlyphForms::Settings rtglyphs::GlyphForms::Settings::Effective() const
{
  const Settings none;
  if (!this->On)
  {
    return none;
  }
  Settings settings = *this;
  settings.Layout = this->Kind == REYNOLDS ? this->Layout : none.Layout;
  settings.Basis = this->Kind == HARMONICS ? this->Basis : none.Basis;
  settings.Coloring = this->Coloring == rtglyphs::GlyphTensors::SIGN ? this->Coloring : none.Coloring;
  return settings;
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphForms::Array(vtkPolyData* points, const Settings& settings)
{
  const bool wanted = settings.On && !rtglyphs::RayTracedArrays::IsNone(settings.Array);
  return wanted ? points->GetPointData()->GetArray(settings.Array.c_str()) : nullptr;
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphForms::Problem(vtkDataArray* array, const Settings& settings)
{
  const FormKind& kind = formKinds[settings.Kind];
  return rtglyphs::GlyphArrays::Problem(
    settings.Array, array, array && kind.Fits(array, settings), kind.Need, kind.Property, kind.Counts);
}

//----------------------------------------------------------------------------
rtglyphs::GlyphForms::GlyphForms(vtkDataArray* array, const Settings& settings)
  : How(settings)
  , Read(array, settings.Layout)
  , Map(formKinds[settings.Kind].Map(array->GetNumberOfComponents(), settings))
  , Meter(this->Map.Degree())
{
}

//----------------------------------------------------------------------------
rtglyphs::GlyphForms::Coefficients
rtglyphs::GlyphForms::CoefficientsOf(rtglyphs::GlyphTuples& tuples, vtkIdType point) const
{
  const double* components = tuples.Get(point);
  double stress[6];
  if (this->How.Kind == REYNOLDS)
  {
    const rtg::SymmetricTensor t = this->Read(components);
    const double ordered[6] = { t.xx, t.yy, t.zz, t.xy, t.yz, t.xz };
    std::copy(ordered, ordered + 6, stress);
    components = stress;
  }
  Coefficients coefficients{};
  this->Map.Apply(components, coefficients.data());
  return coefficients;
}

//----------------------------------------------------------------------------
rtg::FormExtent rtglyphs::GlyphForms::Measure(rtglyphs::GlyphTuples& tuples, vtkIdType point, float* values) const
{
  const Coefficients coefficients = this->CoefficientsOf(tuples, point);
  const rtg::FormExtent extent = this->Meter.Measure(coefficients.data());
  if (extent.radius > 0.0)
  {
    this->Meter.Store(coefficients.data(), extent, values);
  }
  return extent;
}

//----------------------------------------------------------------------------
rtg::FormExtent rtglyphs::GlyphForms::MeasureRoughly(rtglyphs::GlyphTuples& tuples, vtkIdType point) const
{
  return this->Meter.MeasureRoughly(this->CoefficientsOf(tuples, point).data());
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphForms::LargestRadius(vtkDataArray* array, const Settings& settings)
{
  const rtglyphs::GlyphForms forms(array, settings);
  const vtkIdType count = array->GetNumberOfTuples();
  return rtglyphs::RayTracedParallel::Reduce(
    count, 0.0,
    [&](vtkIdType begin, vtkIdType end, double& most)
    {
      rtglyphs::GlyphTuples tuples(array);
      std::vector<float> values(forms.Width());
      for (vtkIdType point = begin; point < end; ++point)
      {
        // Rough bounds, which take a quarter of the time, show for most points that they are smaller.
        if (forms.MeasureRoughly(tuples, point).bound > most)
        {
          most = std::max(most, forms.Measure(tuples, point, values.data()).radius);
        }
      }
    },
    [](double& all, double most) { all = std::max(all, most); });
}
