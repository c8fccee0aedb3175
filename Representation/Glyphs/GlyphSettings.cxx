#include "GlyphSettings.h"

#include "GlyphBoxes.h"
#include "RayTracedNumbers.h"

#include <algorithm>
#include <cmath>

using namespace rtglyphs::RayTracedNumbers;

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::InRange() const
{
  const rtglyphs::GlyphSettings standard;
  rtglyphs::GlyphSettings s = *this;
  PutInRange(s.Arrow.shaftRadius, 0.0, 0.5, standard.Arrow.shaftRadius);
  PutInRange(s.Arrow.tipRadius, 0.0, 0.5, standard.Arrow.tipRadius);
  PutInRange(s.Arrow.tipLength, 0.001, 1.0, standard.Arrow.tipLength);
  PutInRange(s.Tensors.Sharpness, 0.0, 10.0, standard.Tensors.Sharpness);
  PutInRange(s.Tensors.Confidence, 0.01, 0.9999, standard.Tensors.Confidence);
  return s;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::Effective() const
{
  const rtglyphs::GlyphSettings none;
  rtglyphs::GlyphSettings settings = *this;
  if (settings.Shape != rtg::Shape::Arrow && !settings.Sizing.Split)
  {
    settings.Arrow = none.Arrow;
  }
  if (settings.Shape != rtg::Shape::Arrow || !settings.Scaling)
  {
    settings.ArrowReference = none.ArrowReference;
  }
  if (!settings.NeedsScalePercentile())
  {
    settings.ScalePercentile = none.ScalePercentile;
  }
  if (!settings.Scaling)
  {
    settings.ScaleArray.clear();
    settings.ScaleMode = none.ScaleMode;
  }
  if (!settings.Orient || (settings.Tensors.On && !settings.Tensors.AtTips))
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
    // Nested Superquadric does not use the third.
    settings.Exponents[2] =
      settings.Shape == rtg::Shape::NestedSuperquadric ? none.Exponents[2] : settings.Exponents[2];
  }
  else
  {
    std::copy_n(none.Exponents, 3, settings.Exponents);
    settings.ExponentArray.clear();
  }
  settings.Tensors = settings.Tensors.Effective();
  settings.Forms = settings.Forms.Effective();
  settings.Motion = settings.Motion.Effective();
  settings.Mask = settings.Mask.Effective();
  if (settings.Tensors.On)
  {
    settings.RadiusArray.clear();
  }
  settings.Anchor = settings.Tensors.On ? none.Anchor : settings.Anchor;
  // Of polynomials each point of the surface has a direction.
  settings.DirectionColoring = settings.Forms.On ? settings.DirectionColoring : none.DirectionColoring;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphScaling rtglyphs::GlyphSettings::OfMagnitudes() const
{
  rtglyphs::GlyphScaling scaling = this->Effective();
  scaling.Tensors = rtglyphs::GlyphTensors::Settings{ rtglyphs::GlyphTensors::Source(scaling.Tensors) };
  scaling.Forms.Coloring = rtglyphs::GlyphTensors::NONE;
  scaling.Sizing.Least = scaling.Sizing.Most = 0.0;
  return scaling;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSettings::ReferenceScale() const
{
  const bool scaled = this->Scaling && !rtglyphs::RayTracedArrays::IsNone(this->ScaleArray);
  const double reference = this->NeedsScalePercentile() ? this->ScalePercentile
    : scaled                                            ? this->Sizing(this->ArrowReference)
                                                        : 1.0;
  return rtg::IsPositive(reference) ? reference : 1.0;
}

//----------------------------------------------------------------------------
rtg::GlyphInstances::SurfaceColors rtglyphs::GlyphSettings::SurfaceColors() const
{
  using SurfaceColors = rtg::GlyphInstances::SurfaceColors;
  if (this->Tensors.ColorsBySign() || (this->Forms.On && this->Forms.Coloring == rtglyphs::GlyphTensors::SIGN))
  {
    return SurfaceColors::Sign;
  }
  const bool direction = this->Forms.On && this->DirectionColoring != rtglyphs::DirectionColors::NONE;
  return direction ? SurfaceColors::Direction : SurfaceColors::None;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSettings::Width(double radius) const
{
  const double arrow = this->Arrow.shaftRadius > 0.0f ? this->Arrow.shaftRadius : this->Arrow.tipRadius;
  const double unit = this->Shape == rtg::Shape::Arrow && arrow > 0.0 ? arrow : 0.5;
  return std::abs(radius) / unit;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSettings::AnchorShift() const
{
  if (this->Anchor == ORIGIN || this->Tensors.On) // tensors' axes have no heads
  {
    return 0.0;
  }
  double lower = 0.0, upper = 0.0;
  if (this->Shape != rtg::Shape::Mesh)
  {
    const rtg::DoubleBox box = rtg::GlyphExtent(this->Shape, rtg::ArrowForm(), glm::dvec3(1.0));
    lower = box.lower.x;
    upper = box.upper.x;
  }
  else if (this->Mesh && !this->Mesh->positions.empty())
  {
    const auto [least, most] = std::minmax_element(this->Mesh->positions.begin(), this->Mesh->positions.end(),
      [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; });
    lower = least->x;
    upper = most->x;
  }
  switch (this->Anchor)
  {
    case TAIL:
      return -lower;
    case CENTER:
      return -0.5 * (lower + upper);
    case TIP:
      return -upper;
    default:
      return 0.0;
  }
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::AxesOfTensors() const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.Shape = rtg::Shape::Arrow;
  settings.Tensors.Axes = true;
  settings.Tensors.Cross = false;
  settings.Anchor = ORIGIN;
  settings.RadiusArray.clear();
  settings.Scaling &= settings.ScaleMode != COMPONENTS;
  settings.ScaleFactor = std::abs(settings.ScaleFactor);
  // Thin, so as to hide little, and of constant proportions: short ones are small.
  settings.Arrow.shaftRadius = 0.015f;
  settings.Arrow.tipRadius = 0.05f;
  settings.Arrow.tipLength = 0.15f;
  settings.Arrow.tipRounding = 0.0f;
  settings.Arrow.fixedHeads = false;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::Trails(int steps, bool translucent) const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.TrailSteps = steps;
  settings.TrailJoined = translucent;
  settings.Motion = rtglyphs::GlyphMotion::Settings();
  settings.TableSize = 1;
  if (settings.SurfaceColors() != rtg::GlyphInstances::SurfaceColors::None || settings.Forms.ColorsByRadius())
  {
    settings.Tensors.Coloring = settings.Forms.Coloring = rtglyphs::GlyphTensors::NONE;
  }
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::Shells(const std::string& array) const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.Shell = true;
  (settings.Tensors.On ? settings.Tensors.Array : settings.ScaleArray) = array;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::PrincipalAxes() const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.Shape = rtg::Shape::Arrow;
  settings.Tensors.On = true;
  settings.Tensors.Cross = true;
  settings.Tensors.Kind = rtg::TensorGlyphKind::Ellipsoid;
  settings.ScaleFactor = std::abs(settings.ScaleFactor);
  settings.Arrow.fixedHeads = false;
  settings.Motion.AngularVelocity.clear();
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings::Cylinder rtglyphs::GlyphSettings::CylinderOf(double magnitude, int part) const
{
  const rtglyphs::SplitNumber number(magnitude);
  const double power = 0.1 * number.Power, front = std::max(power, 0.0);
  return part == 0 ? Cylinder{ front, front + 0.1 * number.Digit, this->Arrow.shaftRadius }
                   : Cylinder{ std::min(power, 0.0), front, this->Arrow.tipRadius };
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::Vectors() const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.Shape = rtg::Shape::Arrow;
  settings.Sizing = {};
  settings.Orient = settings.Scaling = settings.OfVectors = true;
  settings.OrientationMode = DIRECTION;
  settings.ScaleMode = MAGNITUDE;
  settings.ScaleArray = settings.OrientationArray;
  settings.RadiusArray.clear();
  settings.Anchor = ORIGIN;
  settings.Motion.AngularVelocity.clear();
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::SplitVectors() const
{
  rtglyphs::GlyphSettings settings = this->Vectors();
  settings.Shape = rtg::Shape::Cylinder;
  settings.Sizing.Split = true;
  settings.ArrowReference = 0.0;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::ConfidenceEllipsoids() const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.Shape = rtg::Shape::Sphere;
  settings.Sizing = {};
  settings.Tensors.On = settings.Tensors.Covariances = true;
  settings.Tensors.Kind = rtg::TensorGlyphKind::Ellipsoid;
  settings.Tensors.Thickness = rtg::thinnestTensorGlyph;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::ConfidenceAtTips(bool cones) const
{
  rtglyphs::GlyphSettings settings = this->ConfidenceEllipsoids();
  settings.Shape = cones ? rtg::Shape::Cone : settings.Shape;
  settings.Tensors.Cones = cones;
  settings.Scaling = settings.OfVectors = false;
  settings.Tensors.AtTips = true;
  settings.Tensors.Coloring = rtglyphs::GlyphTensors::NONE;
  return settings;
}
