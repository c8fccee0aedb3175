#include "GlyphBounds.h"

#include "Finite.h"
#include "GlyphMotion.h"
#include "RayTracedParallel.h"
#include "Stopwatch.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/gtc/type_ptr.hpp>

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
    , Trails(rtglyphs::GlyphArrays::Trail(points, settings))
    , Motion(points, settings.Motion)
    , Unturned(settings, this->Sizes)
  {
    const bool arrow = settings.Shape == rtg::Shape::Arrow;
    this->Orientations = rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::ORIENTATION, points, settings);
    this->Turned =
      this->Orientations || settings.Tensors.On || arrow || settings.Shape == rtg::Shape::Cone || this->Motion.Spins();
  }

  rtg::DoubleBox Box(vtkIdType count) const
  {
    return rtglyphs::RayTracedParallel::BoxOf(
      count, [this](vtkIdType begin, vtkIdType end, rtg::DoubleBox& box) { this->AddRange(begin, end, box); });
  }

private:
  void AddRange(vtkIdType begin, vtkIdType end, rtg::DoubleBox& box) const
  {
    rtglyphs::GlyphTuples positions(this->Positions), trails(this->Trails);
    rtglyphs::GlyphSizes::Tuples tuples(this->Sizes);
    rtglyphs::GlyphTuples vectors(this->Settings.IsAroundVectors() ? this->Orientations : nullptr);
    for (vtkIdType i = begin; i < end; ++i)
    {
      const double* x = positions.Get(i);
      if (!rtg::IsFinite(x) || this->Hidden.Has(i))
      {
        continue;
      }
      glm::dvec3 position(x[0], x[1], x[2]);
      if (vectors.Has(i) && rtg::IsFinite(vectors.Get(i)) && this->Settings.Frame == rtglyphs::GlyphFrame::Tip)
      {
        position += this->Settings.ScaleFactor * glm::make_vec3(vectors.Get(i));
      }
      glm::dvec3 lower = position, upper = position;
      if (this->Motion.On() && this->Motion.IsFinite(i))
      {
        const rtg::DoubleBox range = this->Motion.Range(i);
        lower = glm::min(lower, position + range.lower);
        upper = glm::max(upper, position + range.upper);
      }
      const double* trail = trails.Has(i) ? trails.Get(i) : nullptr;
      for (int k = 0; trail && k < trails.Size(); k += 3)
      {
        const glm::dvec3 earlier(trail[k], trail[k + 1], trail[k + 2]);
        lower = rtg::IsFinite(earlier) ? glm::min(lower, earlier) : lower;
        upper = rtg::IsFinite(earlier) ? glm::max(upper, earlier) : upper;
      }
      if (this->Settings.Frame == rtglyphs::GlyphFrame::Cones)
      {
        this->AddCone(i, tuples, vectors, lower, upper);
        box.Include({ lower, upper });
        continue;
      }
      const glm::dvec3 reach = this->Reach(i, tuples);
      box.Include({ lower - reach, upper + reach });
    }
  }

  // Of the longer cone apex and base.
  void AddCone(vtkIdType point, rtglyphs::GlyphSizes::Tuples& tuples, rtglyphs::GlyphTuples& vectors, glm::dvec3& lower,
    glm::dvec3& upper) const
  {
    rtglyphs::GlyphSizes::Glyph glyph;
    rtglyphs::GlyphTensors::Cone cone;
    const bool shown = this->Sizes.Make(point, tuples, glyph, nullptr) == rtglyphs::GlyphOutcomes::SHOWN &&
      this->Sizes.MakeCone(glyph, vectors, point, cone) == rtglyphs::GlyphOutcomes::SHOWN;
    if (shown)
    {
      const glm::dmat3 axes = glm::mat3_cast(cone.Rotation) * cone.Most;
      const glm::dvec3 y = axes[1] * cone.Slopes[0], z = axes[2] * cone.Slopes[1], reach = glm::sqrt(y * y + z * z);
      lower = glm::min(lower, lower + axes[0] - reach);
      upper = glm::max(upper, upper + axes[0] + reach);
    }
  }

  // The glyph's extent from its point along each axis; zero where it has no finite size.
  glm::dvec3 Reach(vtkIdType point, rtglyphs::GlyphSizes::Tuples& tuples) const
  {
    const rtg::DoubleBox box = this->Unturned(point, tuples);
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
  vtkDataArray *Positions, *Trails, *Orientations = nullptr;
  const rtglyphs::GlyphMotion Motion;
  const rtglyphs::GlyphUnturnedBox Unturned;
  bool Turned = false;
};
}

//----------------------------------------------------------------------------
rtglyphs::GlyphUnturnedBox::GlyphUnturnedBox(const rtglyphs::GlyphSettings& settings, const rtglyphs::GlyphSizes& sizes)
  : Settings(settings)
  , Sizes(sizes)
  , Arrow(settings.Arrow)
  , Stretched(
      settings.Shape != rtg::Shape::Capsule && !(settings.Shape == rtg::Shape::Arrow && settings.Arrow.fixedHeads))
  , AnchorShift(settings.AnchorShift())
{
  this->Arrow.unitLength = static_cast<float>(sizes.ArrowUnit());
  if (settings.Shape != rtg::Shape::Mesh)
  {
    this->Unit = rtg::GlyphExtent(settings.Shape, this->Arrow, glm::dvec3(1.0));
  }
  else if (settings.Mesh)
  {
    for (const glm::vec3& position : settings.Mesh->positions)
    {
      this->Unit.Include({ position, position });
    }
  }
}

//----------------------------------------------------------------------------
rtg::DoubleBox rtglyphs::GlyphUnturnedBox::operator()(vtkIdType point, rtglyphs::GlyphSizes::Tuples& tuples) const
{
  glm::dvec3 part;
  const glm::dvec3 size = this->Sizes.Extents(point, tuples, part);
  if (this->Settings.Frame == GlyphFrame::Split)
  {
    const double radius = std::max(this->Arrow.shaftRadius, this->Arrow.tipRadius) * this->Settings.ScaleFactor;
    const glm::dvec3 reach = size.x > 0.0 ? glm::dvec3(size.x, radius, radius) : glm::dvec3(0.0);
    return { -reach, reach };
  }
  part *= this->Settings.Frame == GlyphFrame::Cross ? 0.5 : 1.0; // crosses begin at the center
  rtg::DoubleBox box = this->Stretched ? rtg::DoubleBox{ this->Unit.lower * size, this->Unit.upper * size }
                                       : rtg::GlyphExtent(this->Settings.Shape, this->Arrow, size);
  box.lower *= part;
  box.upper *= part;
  box.lower.x += this->AnchorShift * size.x;
  box.upper.x += this->AnchorShift * size.x;
  return box;
}

//----------------------------------------------------------------------------
const double* rtglyphs::GlyphBounds::Get(
  vtkPolyData* points, const std::vector<rtglyphs::GlyphSettings>& settings, const rtglyphs::RayTracedRanges& hidden)
{
  // Neither colors nor the mask count: glyphs that a mask leaves out stay in the box, which does not jump then.
  std::vector<rtglyphs::GlyphSettings> all = settings;
  for (rtglyphs::GlyphSettings& one : all)
  {
    one.Mask = {};
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
  rtg::DoubleBox box;
  if (points->GetPoints() && points->GetNumberOfPoints() > 0)
  {
    for (const rtglyphs::GlyphSettings& one : settings)
    {
      box.Include(Collector(points, one, hidden).Box(points->GetNumberOfPoints()));
    }
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (!box.Empty())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] = box.lower[axis];
      this->Bounds[2 * axis + 1] = box.upper[axis];
    }
  }
  ++this->Builds;
  this->Seconds += watch.Lap();
}
