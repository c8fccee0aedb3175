#include "GlyphMotion.h"

#include "Finite.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedBlocks.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
enum Kinds
{
  LINEAR,
  ACCELERATION,
  ANGULAR,
  MASK,
  KINDS
};

// In that order.
const struct
{
  const char* Property;
  std::vector<int> Lengths; // of tuples; two components lie in a plane
  std::string rtglyphs::GlyphMotion::Settings::*Name;
  std::vector<glm::vec3> rtg::GlyphMotion::*Values; // of glyphs
} kinds[KINDS] = {
  { "VelocityArray", { 2, 3 }, &rtglyphs::GlyphMotion::Settings::Velocity, &rtg::GlyphMotion::velocities },
  { "AccelerationArray", { 2, 3 }, &rtglyphs::GlyphMotion::Settings::Acceleration, &rtg::GlyphMotion::accelerations },
  { "AngularVelocityArray", { 3 }, &rtglyphs::GlyphMotion::Settings::AngularVelocity,
    &rtg::GlyphMotion::angularVelocities },
  { "MotionBlurMask", { 1 }, &rtglyphs::GlyphMotion::Settings::Mask, nullptr },
};

const std::string& NameOf(const rtglyphs::GlyphMotion::Settings& settings, int kind)
{
  return settings.*kinds[kind].Name;
}

bool IsNamed(const rtglyphs::GlyphMotion::Settings& settings, int kind)
{
  return !rtglyphs::RayTracedArrays::IsNone(NameOf(settings, kind));
}
}

//----------------------------------------------------------------------------
std::array<vtkDataArray*, 4> rtglyphs::GlyphMotion::Arrays(vtkPolyData* points, const Settings& settings)
{
  std::array<vtkDataArray*, 4> arrays{};
  for (int kind = 0; kind < KINDS; ++kind)
  {
    if (settings.On && IsNamed(settings, kind))
    {
      arrays[kind] = points->GetPointData()->GetArray(NameOf(settings, kind).c_str());
    }
  }
  return arrays;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphMotion::GlyphMotion(vtkPolyData* points, const Settings& settings)
{
  if (!settings.On)
  {
    return;
  }
  if (!(settings.ShutterTime > 0.0) || !std::isfinite(float(settings.ShutterTime)))
  {
    std::ostringstream text;
    text << "ShutterTime is " << settings.ShutterTime
         << ", so there is no motion blur. Set it to a positive number, in the "
            "data's unit of time, or to 0, which the data choose, or switch MotionBlur off.";
    this->Messages_.push_back(text.str());
    return;
  }
  this->Open = settings.Opening == FORWARD ? 0.0
    : settings.Opening == BACKWARD         ? -settings.ShutterTime
                                           : -0.5 * settings.ShutterTime;
  this->Close = this->Open + settings.ShutterTime;
  for (int kind = 0; kind < KINDS; ++kind)
  {
    this->Found[kind] = rtglyphs::GlyphArrays::Find(points, NameOf(settings, kind), kinds[kind].Property,
      kinds[kind].Lengths, "motion blur goes without", &this->Messages_);
  }
  if (!this->Found[MASK] && rtglyphs::RayTracedBlocks::IsOnOtherRanks(points, settings.Mask))
  {
    this->Found = {};
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMotion::ReportMissing(vtkPolyData* points, const Settings& settings,
  const rtglyphs::RayTracedRanges& hidden, std::vector<std::string>& messages)
{
  for (int kind = 0; kind < KINDS; ++kind)
  {
    if (settings.On && IsNamed(settings, kind))
    {
      rtglyphs::RayTracedBlocks::ReportMissing(
        points, NameOf(settings, kind), hidden, kinds[kind].Property, "do not move", messages);
    }
  }
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphMotion::MissingInput(const Settings& settings)
{
  const bool any = IsNamed(settings, LINEAR) || IsNamed(settings, ACCELERATION) || IsNamed(settings, ANGULAR);
  return !settings.On || any
    ? std::string()
    : "MotionBlur needs velocities. Choose a point array of 2 or 3 components as VelocityArray, "
      "set that to From Previous Step, or switch MotionBlur off.";
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphMotion::Tuple(int kind, vtkIdType point) const
{
  double tuple[3] = { 0.0, 0.0, 0.0 };
  if (!this->Found[MASK] || std::abs(this->Found[MASK]->GetComponent(point, 0)) > 0.0)
  {
    this->Found[kind]->GetTuple(point, tuple);
  }
  return { tuple[0], tuple[1], tuple[2] };
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphMotion::IsFinite(vtkIdType point) const
{
  for (int kind = 0; kind < MASK; ++kind)
  {
    if (this->Found[kind] && !rtg::IsFiniteInFloat(this->Tuple(kind, point)))
    {
      return false;
    }
  }
  if (this->On())
  {
    // Nor may the path leave the range.
    const rtg::DoubleBox range = this->Range(point);
    return rtg::IsFiniteInFloat(range.lower) && rtg::IsFiniteInFloat(range.upper);
  }
  return true;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMotion::Allocate(rtg::GlyphMotion& motion, std::size_t count) const
{
  for (int kind = 0; kind < MASK; ++kind)
  {
    (motion.*kinds[kind].Values).resize(this->Found[kind] ? count : 0);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMotion::Store(rtg::GlyphMotion& motion, std::size_t glyph, vtkIdType point,
  const glm::dmat3& linear, const glm::dmat3& rotation) const
{
  for (int kind = 0; kind < MASK; ++kind)
  {
    if (this->Found[kind])
    {
      (motion.*kinds[kind].Values)[glyph] = (kind == ANGULAR ? rotation : linear) * this->Tuple(kind, point);
    }
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMotion::Finish(rtg::GlyphMotion& motion) const
{
  if (!this->On())
  {
    return;
  }
  motion.shutterOpen = static_cast<float>(this->Open);
  motion.shutterClose = static_cast<float>(this->Close);
  for (int kind = 0; kind < MASK; ++kind)
  {
    std::vector<glm::vec3>& values = motion.*kinds[kind].Values;
    if (std::all_of(values.begin(), values.end(), [](const glm::vec3& v) { return v == glm::vec3(0.0f); }))
    {
      values = std::vector<glm::vec3>();
    }
  }
}

//----------------------------------------------------------------------------
rtg::DoubleBox rtglyphs::GlyphMotion::Range(vtkIdType point) const
{
  rtg::GlyphMotion one;
  for (const int kind : { LINEAR, ACCELERATION })
  {
    if (this->Found[kind])
    {
      (one.*kinds[kind].Values).emplace_back(this->Tuple(kind, point));
    }
  }
  return rtg::RangeOfDisplacements(one, 0, this->Open, this->Close);
}
