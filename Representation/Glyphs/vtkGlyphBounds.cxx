#include "vtkGlyphBounds.h"

#include "Finite.h"
#include "GlyphBoxes.h"
#include "Stopwatch.h"
#include "vtkDataArray.h"
#include "vtkGlyphHighScale.h"
#include "vtkGlyphMotion.h"
#include "vtkGlyphTuples.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedParallel.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
// The boxes of all glyphs of one kind.
class Collector
{
public:
  Collector(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks)
    : Settings(settings)
    , Blocks(blocks)
    , Positions(points->GetPoints()->GetData())
    , Scales(vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, points, settings))
    , Radii(vtkGlyphArrays::Find(vtkGlyphArrays::RADIUS, points, settings))
    , TensorArray(vtkGlyphTensors::Array(points, settings.Tensors))
    , BlockIds(vtkUnsignedIntArray::SafeDownCast(points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex)))
    , Motion(points, settings.Motion)
    , Arrow(settings.Arrow)
    , AnchorShift(settings.AnchorShift())
  {
    this->ByComponents =
      vtkGlyphArrays::ScalesByComponents(vtkGlyphArrays::Find(vtkGlyphArrays::SCALE, points, settings), settings);
    if (this->TensorArray && vtkGlyphTensors::Problem(this->TensorArray, settings.Tensors).empty())
    {
      this->Tensors = std::make_unique<vtkGlyphTensors>(this->TensorArray, settings.Tensors, std::vector<vtkIdType>());
    }
    this->FormArray = vtkGlyphForms::Array(points, settings.Forms);
    if (this->FormArray && vtkGlyphForms::Problem(this->FormArray, settings.Forms).empty())
    {
      this->Forms = std::make_unique<vtkGlyphForms>(this->FormArray, settings.Forms);
    }
    const vtkGlyphSizing& sizing = settings.Sizing;
    this->LimitSlack = this->Tensors && (sizing.Least > 0.0 || sizing.Most > 0.0) ? std::sqrt(3.0) : 1.0;
    const bool arrow = settings.Shape == rtg::Shape::Arrow;
    this->Turned = vtkGlyphArrays::Find(vtkGlyphArrays::ORIENTATION, points, settings) || settings.Tensors.On ||
      arrow || settings.Shape == rtg::Shape::Cone || this->Motion.Spins();
    if (arrow && settings.Arrow.fixedHeads)
    {
      this->Arrow.unitLength = this->Radii
        ? 0.0f
        : static_cast<float>(std::abs(settings.ScaleFactor) * vtkGlyphHighScale::Reference(points, settings, blocks));
    }
    else if (settings.Shape == rtg::Shape::Mesh && settings.Mesh)
    {
      for (const glm::vec3& position : settings.Mesh->positions)
      {
        this->Mesh.Include({ position, position });
      }
    }
  }

  vtkRayTracedParallel::Box Box(vtkIdType count) const
  {
    return vtkRayTracedParallel::BoxOf(count,
      [this](vtkIdType begin, vtkIdType end, vtkRayTracedParallel::Box& box) { this->AddRange(begin, end, box); });
  }

private:
  void AddRange(vtkIdType begin, vtkIdType end, vtkRayTracedParallel::Box& box) const
  {
    vtkGlyphTuples positions(this->Positions), scales(this->Scales), radii(this->Radii), forms(this->FormArray);
    for (vtkIdType i = begin; i < end; ++i)
    {
      const double* x = positions.Get(i);
      if (!rtg::IsFinite(x) || !this->IsVisible(i))
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
      const glm::dvec3 reach = this->Reach(i, scales, radii, forms);
      box.Add(lower - reach, upper + reach);
    }
  }

  bool IsVisible(vtkIdType point) const
  {
    if (!this->BlockIds || this->Blocks.empty())
    {
      return true;
    }
    const auto block = this->Blocks.find(this->BlockIds->GetValue(point));
    return block == this->Blocks.end() || block->second.Visible;
  }

  // How far the glyph reaches from its point along each axis; zero where it has no finite size.
  glm::dvec3 Reach(vtkIdType point, vtkGlyphTuples& scales, vtkGlyphTuples& radii, vtkGlyphTuples& forms) const
  {
    glm::dvec3 size(std::abs(this->Settings.ScaleFactor) * this->Settings.UnitSize);
    if (this->Scales)
    {
      const double* tuple = scales.Get(point);
      size *= this->ByComponents ? this->Settings.Sizing(glm::abs(glm::dvec3(tuple[0], tuple[1], tuple[2])))
                                 : glm::dvec3(this->Settings.Sizing(vtkMath::Norm(tuple, scales.Size())));
    }
    if (this->Tensors)
    {
      size *= this->Settings.Sizing.Bound(this->Tensors->Extent(point));
    }
    glm::dvec3 share(this->Settings.Tensors.Parts() > 1 ? 0.5 : 1.0); // of the unit glyph's box
    if (this->Forms)
    {
      const rtg::FormExtent extent = this->Forms->MeasureRoughly(forms, point);
      if (!(extent.radius > 0.0))
      {
        return glm::dvec3(0.0);
      }
      size *= this->Settings.Sizing(this->Forms->Magnitude(extent)) * (extent.bound / extent.radius);
      share = extent.reach / extent.bound;
    }
    size = this->Settings.Sizing.Limited(size) * this->LimitSlack;
    if (radii)
    {
      size.y = size.z = this->Settings.Width(*radii.Get(point));
    }
    rtg::DoubleBox box = this->Settings.Shape == rtg::Shape::Mesh
      ? rtg::DoubleBox{ this->Mesh.lower * size, this->Mesh.upper * size }
      : rtg::GlyphExtent(this->Settings.Shape, this->Arrow, size);
    box.lower *= share;
    box.upper *= share;
    box.lower.x += this->AnchorShift * size.x;
    box.upper.x += this->AnchorShift * size.x;
    glm::dvec3 reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    if (this->Turned)
    {
      reach =
        glm::dvec3(this->Settings.Shape == rtg::Shape::Sphere || this->Forms ? std::max({ reach.x, reach.y, reach.z })
                                                                             : glm::length(reach));
    }
    return std::isfinite(reach.x + reach.y + reach.z) ? reach : glm::dvec3(0.0);
  }

  const vtkGlyphSettings& Settings;
  const vtkGlyphBlockAttributes::Table& Blocks;
  vtkDataArray *Positions, *Scales, *Radii, *TensorArray;
  vtkUnsignedIntArray* BlockIds;
  vtkDataArray* FormArray = nullptr;
  std::unique_ptr<vtkGlyphTensors> Tensors;
  std::unique_ptr<vtkGlyphForms> Forms;
  const vtkGlyphMotion Motion;
  bool ByComponents = false, Turned = false;
  rtg::ArrowForm Arrow;
  rtg::DoubleBox Mesh; // the unit glyph's, where it is one
  const double AnchorShift;
  double LimitSlack = 1.0; // extents of tensors are known to a factor of sqrt(3) only; limits are of the extents
};
}

//----------------------------------------------------------------------------
const double* vtkGlyphBounds::Get(
  vtkPolyData* points, const std::vector<vtkGlyphSettings>& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  // Neither colors nor the mask count: glyphs that a mask leaves out stay in the box, which does not jump then.
  Key key{ {}, {}, vtkGlyphBlockAttributes::Hidden(blocks) };
  for (const vtkGlyphSettings& form : settings)
  {
    key.Settings.push_back(form.Effective());
    key.Settings.back().Mask = {};
  }
  for (const vtkGlyphSettings& form : key.Settings)
  {
    for (vtkDataArray* array : vtkGlyphArrays::All(points, form))
    {
      key.Times.push_back(array ? array->GetMTime() : 0);
    }
  }
  if (this->IsKnown && this->Known == key)
  {
    return this->Bounds;
  }
  rtg::Stopwatch watch;
  vtkRayTracedParallel::Box box;
  if (points->GetPoints() && points->GetNumberOfPoints() > 0)
  {
    for (const vtkGlyphSettings& form : settings)
    {
      const vtkRayTracedParallel::Box all = Collector(points, form, blocks).Box(points->GetNumberOfPoints());
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
  this->Known = std::move(key);
  this->IsKnown = true;
  ++this->Builds;
  this->Seconds += watch.Lap();
  return this->Bounds;
}
