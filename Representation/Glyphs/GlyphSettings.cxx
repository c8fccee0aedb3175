#include "GlyphSettings.h"

#include "GlyphBoxes.h"
#include "GlyphShapes.h"
#include "RayTracedNumbers.h"

#include <algorithm>

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
  if (settings.Shape != rtg::Shape::Arrow && settings.Frame != GlyphFrame::Split)
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
  if (!settings.Orient || (settings.Tensors.On && !settings.IsAroundVectors()))
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
  settings.Opacity = none.Opacity;
  settings.TrailFading = none.TrailFading;
  // Each point of a polynomial's surface has its own direction.
  settings.DirectionColoring = settings.Forms.On ? settings.DirectionColoring : none.DirectionColoring;
  return settings;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphScaling rtglyphs::GlyphSettings::OfMagnitudes() const
{
  rtglyphs::GlyphScaling scaling = this->Effective();
  scaling.Tensors = rtglyphs::GlyphTensors::Settings{ rtglyphs::GlyphTensors::Source(scaling.Tensors) };
  scaling.Frame = scaling.IsOfVectors() ? scaling.Frame : GlyphFrame::Arrays;
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
std::vector<rtglyphs::GlyphLayer> rtglyphs::GlyphLayer::Of(int glyphShape)
{
  using rtg::Shape;
  const struct
  {
    int Value;
    GlyphLayer Layer;
  } shapes[] = {
    { GlyphShapes::GLYPH_TYPE, { Shape::Sphere, GlyphFrame::Arrays } },
    { GlyphShapes::SUPERQUADRIC, { Shape::Superquadric, GlyphFrame::Arrays } },
    { GlyphShapes::NESTED_SUPERQUADRIC, { Shape::NestedSuperquadric, GlyphFrame::Arrays } },
    { GlyphShapes::CAPSULE, { Shape::Capsule, GlyphFrame::Arrays } },
    { GlyphShapes::SPHERICAL_HARMONICS, { Shape::Polynomial, GlyphFrame::Arrays } },
    { GlyphShapes::REYNOLDS, { Shape::Polynomial, GlyphFrame::Arrays } },
    { GlyphShapes::FOURTH_ORDER_TENSOR, { Shape::Polynomial, GlyphFrame::Arrays } },
    { GlyphShapes::TENSOR_ELLIPSOID, { Shape::Sphere, GlyphFrame::Tensor } },
    { GlyphShapes::TENSOR_SUPERQUADRIC, { Shape::NestedSuperquadric, GlyphFrame::Tensor } },
    { GlyphShapes::SIGNED_TENSOR_SUPERQUADRIC, { Shape::NestedSuperquadric, GlyphFrame::Tensor } },
    { GlyphShapes::CONFIDENCE_ELLIPSOID, { Shape::Sphere, GlyphFrame::Covariance } },
    { GlyphShapes::PRINCIPAL_AXES, { Shape::Arrow, GlyphFrame::Cross } },
    { GlyphShapes::SPLIT_VECTOR, { Shape::Cylinder, GlyphFrame::Split } },
    { GlyphShapes::UNCERTAIN_VECTOR, { Shape::Arrow, GlyphFrame::Vector } },
    { GlyphShapes::UNCERTAIN_VECTOR, { Shape::Sphere, GlyphFrame::Tip, around } },
    { GlyphShapes::UNCERTAIN_DIRECTION, { Shape::Arrow, GlyphFrame::Vector } },
    { GlyphShapes::UNCERTAIN_DIRECTION, { Shape::Cone, GlyphFrame::Cones, around } },
  };
  std::vector<GlyphLayer> layers;
  for (const auto& shape : shapes)
  {
    if (shape.Value == glyphShape)
    {
      layers.push_back(shape.Layer);
    }
  }
  return layers;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::In(const GlyphLayer& layer) const
{
  rtglyphs::GlyphSettings s = *this;
  s.Shape = layer.Shape;
  s.Frame = layer.Frame;
  s.Opacity = layer.Opacity;
  s.Tensors.On = layer.Frame >= GlyphFrame::Tensor;
  s.Tensors.Axes = layer.Frame == GlyphFrame::Axis;
  s.Tensors.Covariances = layer.Frame == GlyphFrame::Covariance || s.IsAroundVectors();
  switch (layer.Frame)
  {
    case GlyphFrame::Arrays:
    case GlyphFrame::Tensor:
      break;
    case GlyphFrame::Covariance:
      s.Sizing = {};
      break;
    case GlyphFrame::Vector:
    case GlyphFrame::Split:
    case GlyphFrame::Tip:
    case GlyphFrame::Cones:
      s.Orient = true;
      s.OrientationMode = DIRECTION;
      s.Scaling = s.IsOfVectors();
      s.ScaleMode = MAGNITUDE;
      s.ScaleArray = s.OrientationArray;
      s.ArrowReference = layer.Frame == GlyphFrame::Split ? 0.0 : s.ArrowReference;
      s.Sizing = {};
      s.Anchor = ORIGIN;
      s.RadiusArray.clear();
      s.Motion.AngularVelocity.clear();
      s.Tensors.Coloring = s.IsAroundVectors() ? GlyphTensors::NONE : s.Tensors.Coloring;
      break;
    case GlyphFrame::Cross:
      s.ScaleFactor = std::abs(s.ScaleFactor);
      s.Arrow.fixedHeads = false;
      s.Motion.AngularVelocity.clear();
      break;
    case GlyphFrame::Axis:
      s.ScaleFactor = std::abs(s.ScaleFactor);
      s.Scaling &= s.ScaleMode != COMPONENTS;
      s.Anchor = ORIGIN;
      s.RadiusArray.clear();
      // Thin, so as to hide little, and of constant proportions: short ones are small.
      s.Arrow.shaftRadius = 0.015f;
      s.Arrow.tipRadius = 0.05f;
      s.Arrow.tipLength = 0.15f;
      s.Arrow.tipRounding = 0.0f;
      s.Arrow.fixedHeads = false;
      break;
  }
  return s;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphSettings::Trails(int steps, double fading) const
{
  rtglyphs::GlyphSettings settings = *this;
  settings.TrailSteps = steps;
  settings.TrailFading = fading;
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
  settings.Opacity = GlyphLayer::around;
  (settings.Tensors.On ? settings.Tensors.Array : settings.ScaleArray) = array;
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
