#include "vtkGlyphSizes.h"

#include "Finite.h"
#include "vtkGlyphPlacement.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkGlyphOutcomes;

//----------------------------------------------------------------------------
vtkGlyphMagnitudes::vtkGlyphMagnitudes(
  vtkPolyData* points, const vtkGlyphScaling& scaling, const std::vector<vtkIdType>& chosen)
  : Scaling(scaling)
  , ScaleArray(vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, points, scaling))
  , FormArray(vtkGlyphForms::Array(points, scaling.Forms))
  , ByComponents(scaling.ScaleMode == vtkGlyphScaling::COMPONENTS && this->ScaleArray &&
      this->ScaleArray->GetNumberOfComponents() > 1) // one is a magnitude
{
  if (scaling.Tensors.On)
  {
    vtkDataArray* array = vtkGlyphTensors::Array(points, scaling.Tensors);
    this->Problem = vtkGlyphTensors::Problem(array, scaling.Tensors);
    if (this->Problem.empty())
    {
      this->Tensors = std::make_unique<vtkGlyphTensors>(array, scaling.Tensors, chosen);
    }
  }
  if (scaling.Forms.On)
  {
    this->Problem = vtkGlyphForms::Problem(this->FormArray, scaling.Forms);
    if (this->Problem.empty())
    {
      this->Forms = std::make_unique<vtkGlyphForms>(this->FormArray, scaling.Forms);
    }
  }
}

//----------------------------------------------------------------------------
glm::dvec3 vtkGlyphMagnitudes::Scale(vtkIdType point, Tuples& tuples) const
{
  if (!tuples.Scales.Has(point))
  {
    return glm::dvec3(1.0);
  }
  const double* tuple = tuples.Scales.Get(point);
  return this->ByComponents ? this->Scaling.Sizing(glm::dvec3(tuple[0], tuple[1], tuple[2]))
                            : glm::dvec3(this->Scaling.Sizing(vtkMath::Norm(tuple, tuples.Scales.Size())));
}

//----------------------------------------------------------------------------
glm::dvec3 vtkGlyphMagnitudes::Bound(vtkIdType point, Tuples& tuples, rtg::FormExtent& form) const
{
  glm::dvec3 scale = this->Scale(point, tuples);
  if (this->Tensors)
  {
    scale *= this->Scaling.Sizing(this->Tensors->Extent(point));
  }
  if (this->Forms)
  {
    form = this->Forms->MeasureRoughly(tuples.Forms, point);
    scale *= form.radius > 0.0 ? this->Scaling.Sizing(this->Forms->Magnitude(form)) : 0.0;
  }
  return glm::abs(scale);
}

//----------------------------------------------------------------------------
double vtkGlyphMagnitudes::Magnitude(vtkIdType point, Tuples& tuples) const
{
  rtg::FormExtent form;
  const double longest = this->Problem.empty() ? vtkGlyphSizing::Largest(this->Bound(point, tuples, form)) : 0.0;
  return rtg::IsPositive(longest) ? longest : 0.0;
}

//----------------------------------------------------------------------------
vtkGlyphSizes::vtkGlyphSizes(
  vtkPolyData* points, const vtkGlyphSettings& settings, const std::vector<vtkIdType>& chosen)
  : vtkGlyphMagnitudes(points, settings, chosen)
  , Settings(settings)
  , RadiusArray(vtkGlyphArrays::Find(vtkGlyphArrays::RADIUS, points, settings))
{
}

//----------------------------------------------------------------------------
double vtkGlyphSizes::ArrowUnit() const
{
  const double reference = this->HasScales() ? this->Settings.ReferenceScale() : 1.0;
  return this->HasRadii() ? 0.0 : std::abs(this->Settings.ScaleFactor) * reference;
}

//----------------------------------------------------------------------------
// The limits, and what a radius replaces.
void vtkGlyphSizes::Finish(vtkIdType point, Tuples& tuples, glm::dvec3& size) const
{
  size = this->Settings.Sizing.Limited(size);
  if (tuples.Radii.Has(point))
  {
    size.y = size.z = this->Settings.Width(*tuples.Radii.Get(point));
  }
}

//----------------------------------------------------------------------------
glm::dvec3 vtkGlyphSizes::Extents(vtkIdType point, Tuples& tuples, glm::dvec3& part) const
{
  rtg::FormExtent form;
  glm::dvec3 size = std::abs(this->Settings.ScaleFactor) * this->Settings.UnitSize * this->Bound(point, tuples, form);
  part = glm::dvec3(1.0);
  if (form.radius > 0.0)
  {
    size *= form.bound / form.radius;
    part = form.reach / form.bound;
  }
  this->Finish(point, tuples, size);
  return size;
}

//----------------------------------------------------------------------------
Outcome vtkGlyphSizes::Make(vtkIdType point, Tuples& tuples, Glyph& glyph, float* polynomial) const
{
  glyph.Size = this->Settings.ScaleFactor * this->Settings.UnitSize * this->Scale(point, tuples);
  if (const vtkGlyphTensors* tensors = this->GetTensors(); tensors && this->Settings.Tensors.Axes)
  {
    double axis[3];
    if (!tensors->Axis(point, axis))
    {
      return NOT_SHOWN; // nothing to show is no fault
    }
    glyph.Size *= this->Settings.Sizing(tensors->Extent(point));
    vtkGlyphPlacement::RotationFromTuple(axis, vtkGlyphSettings::DIRECTION, glyph.Rotation);
  }
  else if (tensors)
  {
    if (!tensors->Glyph(point, glyph.Tensor))
    {
      return tensors->IsZero(point) ? ZERO_TENSOR : TENSOR;
    }
    glyph.Size *= this->Settings.Sizing(glyph.Tensor.halfLengths);
    glyph.Rotation = glyph.Tensor.rotation;
  }
  if (const vtkGlyphForms* forms = this->GetForms())
  {
    const rtg::FormExtent extent = forms->Measure(tuples.Forms, point, polynomial);
    if (!(extent.radius > 0.0))
    {
      const double* tuple = tuples.Forms.Get(point);
      const bool zero =
        std::all_of(tuple, tuple + tuples.Forms.Size(), [](double component) { return component == 0.0; });
      return zero ? ZERO_POLYNOMIAL : POLYNOMIAL;
    }
    glyph.Radius = static_cast<float>(extent.bound);
    // Of the unit glyph, which is a little less than the largest that is possible
    glyph.Size *= this->Settings.Sizing(forms->Magnitude(extent)) * (extent.bound / extent.radius);
  }
  this->Finish(point, tuples, glyph.Size);
  const bool good = !tuples.Radii.Has(point) || rtg::IsPositive(glyph.Size.y);
  return good ? SHOWN : glyph.Size.y == 0.0 ? ZERO_RADIUS : RADIUS;
}
