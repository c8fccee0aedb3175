#include "GlyphSizes.h"

#include "Finite.h"
#include "GlyphPlacement.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

using namespace rtglyphs::GlyphOutcomes;

//----------------------------------------------------------------------------
rtglyphs::GlyphMagnitudes::GlyphMagnitudes(
  vtkPolyData* points, const rtglyphs::GlyphScaling& scaling, const std::vector<vtkIdType>& chosen)
  : Scaling(scaling)
  , ScaleArray(rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::SCALE, points, scaling))
  , FormArray(rtglyphs::GlyphForms::Array(points, scaling.Forms))
  , ByComponents(scaling.ScaleMode == rtglyphs::GlyphScaling::COMPONENTS && this->ScaleArray &&
      this->ScaleArray->GetNumberOfComponents() > 1) // one is a magnitude
  , RankLacksScales(scaling.Scaling && !rtglyphs::RayTracedArrays::IsNone(scaling.ScaleArray) &&
      rtglyphs::RayTracedBlocks::IsOnOtherRanks(points, scaling.ScaleArray) &&
      !points->GetPointData()->HasArray(scaling.ScaleArray.c_str()))
{
  if (scaling.Tensors.On)
  {
    vtkDataArray* array = rtglyphs::GlyphTensors::Array(points, scaling.Tensors);
    this->Problem = rtglyphs::GlyphTensors::Problem(array, scaling.Tensors);
    if (this->Problem.empty())
    {
      this->Tensors = std::make_unique<rtglyphs::GlyphTensors>(array, scaling.Tensors, chosen);
      this->MissingTensors = rtglyphs::RayTracedBlocks::MissingTuples(array);
    }
  }
  if (scaling.IsOfVectors())
  {
    const int components = this->ScaleArray ? this->ScaleArray->GetNumberOfComponents() : 0;
    this->Problem =
      rtglyphs::GlyphArrays::Problem(scaling.ScaleArray, this->ScaleArray, components == 2 || components == 3,
        "Split and uncertain vectors need vectors", "SelectOrientationVectors", "2 or 3");
  }
  if (scaling.Forms.On)
  {
    this->Problem = rtglyphs::GlyphForms::Problem(this->FormArray, scaling.Forms);
    if (this->Problem.empty())
    {
      this->Forms = std::make_unique<rtglyphs::GlyphForms>(this->FormArray, scaling.Forms);
    }
  }
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphMagnitudes::Scale(vtkIdType point, Tuples& tuples) const
{
  if (!tuples.Scales.Has(point))
  {
    return glm::dvec3(1.0);
  }
  const double* tuple = tuples.Scales.Get(point);
  const int size = tuples.Scales.Size();
  return this->ByComponents
    ? this->Scaling.Sizing(glm::dvec3(tuple[0], tuple[1], size == 2 ? tuple[1] : tuple[2]))
    : glm::dvec3(this->Scaling.Scale(size == 1 ? std::abs(*tuple) : vtkMath::Norm(tuple, size)));
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphMagnitudes::Bound(vtkIdType point, Tuples& tuples, rtg::FormExtent& form) const
{
  glm::dvec3 scale = this->Scale(point, tuples);
  if (this->Tensors)
  {
    scale *= this->Scaling.Sizing(this->Tensors->Extent(point));
  }
  if (this->Forms)
  {
    form = this->Forms->MeasureRoughly(tuples.Forms, point);
    scale *= form.radius > 0.0 ? this->Scaling.Sizing(form.radius) : 0.0;
  }
  return glm::abs(scale);
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphMagnitudes::Magnitude(vtkIdType point, Tuples& tuples) const
{
  rtg::FormExtent form;
  const double longest = this->Problem.empty() && !this->Lacks(point, tuples)
    ? rtglyphs::GlyphSizing::Largest(this->Bound(point, tuples, form))
    : 0.0;
  return rtg::IsPositive(longest) ? longest : 0.0;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSizes::GlyphSizes(
  vtkPolyData* points, const rtglyphs::GlyphSettings& settings, const std::vector<vtkIdType>& chosen)
  : rtglyphs::GlyphMagnitudes(points, settings, chosen)
  , Settings(settings)
  , RadiusArray(rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::RADIUS, points, settings))
  , ReducedArray(points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::Reduced))
{
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSizes::ArrowUnit() const
{
  const double reference = this->HasScales() ? this->Settings.ReferenceScale() : 1.0;
  return this->HasRadii() ? 0.0 : std::abs(this->Settings.ScaleFactor) * reference;
}

//----------------------------------------------------------------------------
// The limits, what a radius replaces, and how much larger a glyph is that stands for several.
void rtglyphs::GlyphSizes::Finish(vtkIdType point, Tuples& tuples, glm::dvec3& size) const
{
  size = this->Settings.Sizing.Limited(size);
  if (tuples.Radii.Has(point))
  {
    size.y = size.z = this->Settings.Width(*tuples.Radii.Get(point));
  }
  size *= tuples.Reduced.Has(point) ? tuples.Reduced.Get(point)[2] : 1.0;
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphSizes::Extents(vtkIdType point, Tuples& tuples, glm::dvec3& part) const
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
Outcome rtglyphs::GlyphSizes::Make(vtkIdType point, Tuples& tuples, Glyph& glyph, float* polynomial) const
{
  if (this->Lacks(point, tuples))
  {
    return MISSING_ARRAY;
  }
  glyph.Size = this->Settings.ScaleFactor * this->Settings.UnitSize * this->Scale(point, tuples);
  if (const rtglyphs::GlyphTensors* tensors = this->GetTensors(); tensors && this->Settings.Tensors.Axes)
  {
    glm::dvec3 axis;
    if (!tensors->Axis(point, axis))
    {
      return NOT_SHOWN; // nothing to show is no fault
    }
    glyph.Size *= this->Settings.Sizing(tensors->Extent(point));
    rtglyphs::GlyphPlacement::RotationFromTuple(&axis.x, rtglyphs::GlyphSettings::DIRECTION, glyph.Rotation);
  }
  else if (tensors)
  {
    if (const Outcome outcome = tensors->Glyph(point, glyph.Tensor); outcome != SHOWN)
    {
      return outcome;
    }
    glyph.Size *= this->Settings.Sizing(glyph.Tensor.halfLengths);
    glyph.Rotation = glyph.Tensor.rotation;
  }
  if (const rtglyphs::GlyphForms* forms = this->GetForms())
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
    // The unit glyph is a little smaller than the largest that is possible
    glyph.Size *= this->Settings.Sizing(extent.radius) * (extent.bound / extent.radius);
  }
  this->Finish(point, tuples, glyph.Size);
  const bool good = !tuples.Radii.Has(point) || rtg::IsPositive(glyph.Size.y);
  return good ? SHOWN : glyph.Size.y == 0.0 ? ZERO_RADIUS : RADIUS;
}

//----------------------------------------------------------------------------
Outcome rtglyphs::GlyphSizes::MakeCone(
  const Glyph& glyph, rtglyphs::GlyphTuples& vectors, vtkIdType point, rtglyphs::GlyphTensors::Cone& cone) const
{
  const glm::dvec3 vector = vectors.Has(point) ? glm::make_vec3(vectors.Get(point)) : glm::dvec3(NAN);
  if (!rtg::IsFinite(vector))
  {
    return NOT_SHOWN; // the arrows' messages name it
  }
  const double confidence = this->Settings.Tensors.Confidence;
  const glm::dvec3 deviations = glm::abs(glyph.Size) / (2.0 * rtglyphs::GlyphTensors::RadiusOf(confidence));
  const bool found =
    rtglyphs::GlyphTensors::ConeOf(this->Settings.ScaleFactor * vector, deviations, glyph.Rotation, confidence, cone);
  return found ? SHOWN : DIRECTION;
}
