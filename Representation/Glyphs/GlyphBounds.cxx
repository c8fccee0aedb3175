#include "GlyphBounds.h"

#include "Finite.h"
#include "GlyphBoxes.h"
#include "GlyphMotion.h"
#include "GlyphSizes.h"
#include "RayTracedParallel.h"
#include "Stopwatch.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
// The boxes of all glyphs of one kind.
class Collector
{
public:
  Collector(vtkPolyData* points, const rtglyphs::GlyphSettings& settings, const rtglyphs::RayTracedRanges& hidden)
    : Settings(settings)
    , Sizes(points, settings)
    , Hidden(hidden)
    , Positions(points->GetPoints()->GetData())
    , Motion(points, settings.Motion)
    , Arrow(settings.Arrow)
    , AnchorShift(settings.AnchorShift())
  {
    const bool arrow = settings.Shape == rtg::Shape::Arrow;
    this->Turned = rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::ORIENTATION, points, settings) ||
      settings.Tensors.On || arrow || settings.Shape == rtg::Shape::Cone || this->Motion.Spins();
    if (arrow && settings.Arrow.fixedHeads)
    {
      this->Arrow.unitLength = static_cast<float>(this->Sizes.ArrowUnit());
    }
    else if (settings.Shape == rtg::Shape::Mesh && settings.Mesh)
    {
      for (const glm::vec3& position : settings.Mesh->positions)
      {
        this->Mesh.Include({ position, position });
      }
    }
  }

  rtglyphs::RayTracedParallel::Box Box(vtkIdType count) const
  {
    return rtglyphs::RayTracedParallel::BoxOf(count,
      [this](vtkIdType begin, vtkIdType end, rtglyphs::RayTracedParallel::Box& box)
      { this->AddRange(begin, end, box); });
  }

private:
  void AddRange(vtkIdType begin, vtkIdType end, rtglyphs::RayTracedParallel::Box& box) const
  {
    rtglyphs::GlyphTuples positions(this->Positions);
    rtglyphs::GlyphSizes::Tuples tuples(this->Sizes);
    for (vtkIdType i = begin; i < end; ++i)
    {
      const double* x = positions.Get(i);
      if (!rtg::IsFinite(x) || this->Hidden.Has(i))
      {
        continue;
      }
      const glm::dvec3 position(x[0], x[1], x[2]);
      glm::dvec3 lower = position, upper = position;
      if (this->Motion.On() && this->Motion.IsFinite(i))
      {
        const rtg::DoubleBox range = this->Motion.Range(i);
        lower = glm::min(lower, position + range.lower);
        upper = glm::max(upper, position + range.upper);
      }
      const glm::dvec3 reach = this->Reach(i, tuples);
      box.Add(lower - reach, upper + reach);
    }
  }

  // The glyph's extent from its point along each axis; zero where it has no finite size.
  glm::dvec3 Reach(vtkIdType point, rtglyphs::GlyphSizes::Tuples& tuples) const
  {
    glm::dvec3 part;
    const glm::dvec3 size = this->Sizes.Extents(point, tuples, part);
    part *= this->Settings.Tensors.Parts() > 1 ? 0.5 : 1.0; // crosses begin at the center
    rtg::DoubleBox box = this->Settings.Shape == rtg::Shape::Mesh
      ? rtg::DoubleBox{ this->Mesh.lower * size, this->Mesh.upper * size }
      : rtg::GlyphExtent(this->Settings.Shape, this->Arrow, size);
    box.lower *= part;
    box.upper *= part;
    box.lower.x += this->AnchorShift * size.x;
    box.upper.x += this->AnchorShift * size.x;
    glm::dvec3 reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    if (this->Turned)
    {
      reach = glm::dvec3(this->Settings.Shape == rtg::Shape::Sphere || this->Sizes.GetForms()
          ? std::max({ reach.x, reach.y, reach.z })
          : glm::length(reach));
    }
    return std::isfinite(reach.x + reach.y + reach.z) ? reach : glm::dvec3(0.0);
  }

  const rtglyphs::GlyphSettings& Settings;
  const rtglyphs::GlyphSizes Sizes;
  const rtglyphs::RayTracedRanges& Hidden;
  vtkDataArray* Positions;
  const rtglyphs::GlyphMotion Motion;
  bool Turned = false;
  rtg::ArrowForm Arrow;
  rtg::DoubleBox Mesh; // the unit glyph's, where it is one
  const double AnchorShift;
};
}

//----------------------------------------------------------------------------
const double* rtglyphs::GlyphBounds::Get(
  vtkPolyData* points, const std::vector<rtglyphs::GlyphSettings>& settings, const rtglyphs::RayTracedRanges& hidden)
{
  // Neither colors nor the mask count: glyphs that a mask leaves out stay in the box, which does not jump then.
  std::vector<rtglyphs::GlyphSettings> all = settings;
  for (rtglyphs::GlyphSettings& form : all)
  {
    form.Mask = {};
  }
  this->Known.Update(
    rtglyphs::GlyphArrays::KeyOf(points, std::move(all), hidden), [&] { this->Build(points, settings, hidden); });
  return this->Bounds;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphBounds::Build(
  vtkPolyData* points, const std::vector<rtglyphs::GlyphSettings>& settings, const rtglyphs::RayTracedRanges& hidden)
{
  rtg::Stopwatch watch;
  rtglyphs::RayTracedParallel::Box box;
  if (points->GetPoints() && points->GetNumberOfPoints() > 0)
  {
    for (const rtglyphs::GlyphSettings& form : settings)
    {
      const rtglyphs::RayTracedParallel::Box all = Collector(points, form, hidden).Box(points->GetNumberOfPoints());
      if (!all.IsEmpty())
      {
        box.Add(all.Lower, all.Upper);
      }
    }
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (!box.IsEmpty())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] = box.Lower[axis];
      this->Bounds[2 * axis + 1] = box.Upper[axis];
    }
  }
  ++this->Builds;
  this->Seconds += watch.Lap();
}
