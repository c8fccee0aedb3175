#include "GlyphTuples.h"

#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

namespace
{
using Settings = rtglyphs::GlyphSettings;

// A row of the table of arrays.
struct Description
{
  std::string Settings::*Name;
  bool (*IsWanted)(const Settings&);
  std::vector<int> (*Lengths)(const Settings&); // of tuples that make sense; none: any
  const char* Property;
  const char* Without; // what happens without the array
  const char* OfBlock; // what then becomes of a block's points
};

// In the order of GlyphArrays::Id.
const std::array<Description, rtglyphs::GlyphArrays::NUMBER_OF_IDS> table = { {
  { &Settings::ScaleArray, [](const Settings& settings) { return settings.Scaling; },
    [](const Settings& settings) {
      return settings.ScaleMode == Settings::COMPONENTS ? std::vector<int>{ 1, 2, 3 } : std::vector<int>{};
    },
    "SelectScaleArray", "all glyphs get the same size", "have no glyph" },
  { &Settings::OrientationArray, [](const Settings& settings) { return settings.Orient; },
    [](const Settings& settings)
    {
      const std::vector<int> all = { 2, 3, 4, 9 }; // longer tuples need no mode
      if (settings.IsAroundVectors())
      {
        return std::vector<int>{ 2, 3 };
      }
      const int first = settings.OrientationMode; // that it takes
      return std::vector<int>(all.begin() + first, all.end());
    },
    "SelectOrientationVectors", "the glyphs are not rotated", "have glyphs that are not rotated" },
  { &Settings::TableIndexArray, [](const Settings& settings) { return settings.HasTable(); },
    [](const Settings&) { return std::vector<int>{}; }, "GlyphTableIndexArray",
    "all points have the table's first mesh", "have the table's first mesh" },
  { &Settings::ExponentArray, [](const Settings& settings) { return settings.HasOwnExponents(); },
    [](const Settings&) {
      return std::vector<int>{ 1, 2, 3 };
    },
    "GlyphExponentArray", "GlyphExponents count", "have GlyphExponents" },
  { &Settings::OpacityArray, [](const Settings&) { return true; },
    [](const Settings&) { return std::vector<int>{ 1 }; }, "GlyphOpacityArray", "all glyphs have the same opacity",
    "have glyphs without an opacity of their own" },
  { &Settings::RadiusArray, [](const Settings& settings) { return !settings.Tensors.On; },
    [](const Settings&) { return std::vector<int>{ 1 }; }, "GlyphRadiusArray", "the scale sets the width of glyphs",
    "have glyphs of the width that the scale sets" },
} };
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphArrays::Find(
  Id id, vtkPolyData* points, const rtglyphs::GlyphSettings& settings, std::vector<std::string>* messages)
{
  const Description& how = table[id];
  return how.IsWanted(settings)
    ? Find(points, settings.*how.Name, how.Property, how.Lengths(settings), how.Without, messages)
    : nullptr;
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphArrays::Find(vtkPolyData* points, const std::string& name, const char* property,
  const std::vector<int>& lengths, const char* without, std::vector<std::string>* messages)
{
  if (rtglyphs::RayTracedArrays::IsNone(name))
  {
    return nullptr;
  }
  vtkDataArray* array = points->GetPointData()->GetArray(name.c_str());
  const bool fits = array &&
    (lengths.empty() || std::find(lengths.begin(), lengths.end(), array->GetNumberOfComponents()) != lengths.end());
  if (!array && messages && !rtglyphs::RayTracedBlocks::IsOnOtherRanks(points, name))
  {
    const bool exists = points->GetPointData()->HasArray(name.c_str()) != 0;
    const std::string what = " point array '" + name + "', which " + property + " names";
    messages->push_back((exists ? "The" + what + ", has no numbers; " : "There is no" + what + "; ") + without +
      ". Choose " + (exists ? "another one" : "one that exists") + ", or None.");
  }
  else if (array && !fits && messages)
  {
    std::ostringstream text;
    text << "The point array '" << name << "', which " << property << " names, has " << array->GetNumberOfComponents()
         << " components where " << lengths.front();
    for (std::size_t i = 1; i < lengths.size(); ++i)
    {
      text << (i + 1 < lengths.size() ? ", " : " or ") << lengths[i];
    }
    text << " are needed; " << without << ". Choose another array or mode.";
    messages->push_back(text.str());
  }
  return fits ? array : nullptr;
}

//----------------------------------------------------------------------------
float rtglyphs::GlyphArrays::Opacity(rtglyphs::GlyphTuples& opacities, vtkIdType point)
{
  const double opacity = opacities.Has(point) ? *opacities.Get(point) : 1.0;
  return std::isnan(opacity) ? 1.0f : static_cast<float>(std::clamp(opacity, 0.0, 1.0));
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphArrays::Problem(const std::string& name, vtkDataArray* array, bool fits,
  const std::string& need, const std::string& property, const std::string& counts)
{
  if (rtglyphs::RayTracedArrays::IsNone(name))
  {
    return need + ". Choose a point array of " + counts + " components as " + property + ".";
  }
  const std::string named = "point array '" + name + "', which " + property + " names,";
  if (!array)
  {
    return "There is no " + named + " so there are no glyphs. Choose one of " + counts + " components.";
  }
  return fits ? ""
              : "The " + named + " has " + std::to_string(array->GetNumberOfComponents()) + " components where " +
      counts + " are needed, so there are no glyphs. Choose another array.";
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphArrays::ReportMissing(vtkPolyData* points, const rtglyphs::GlyphSettings& settings,
  const rtglyphs::RayTracedRanges& hidden, std::vector<std::string>& messages)
{
  const auto report = [&](const std::string& name, const char* property, const char* consequence)
  { rtglyphs::RayTracedBlocks::ReportMissing(points, name, hidden, property, consequence, messages); };
  // Arrays without which there is no glyph come first: of an array that has several uses one message speaks.
  const char* none = table[SCALE].OfBlock;
  if (settings.Tensors.On)
  {
    report(settings.Tensors.Array, "GlyphTensorArray", none);
  }
  if (settings.Forms.On)
  {
    report(settings.Forms.Array,
      settings.Forms.Kind == rtglyphs::GlyphForms::HARMONICS ? "GlyphHarmonicsArray" : "GlyphTensorArray", none);
  }
  for (const Description& how : table)
  {
    if (how.IsWanted(settings) && !settings.IsAroundVectors()) // else the arrows have reported it
    {
      report(settings.*how.Name, how.Property, how.OfBlock);
    }
  }
  rtglyphs::GlyphMotion::ReportMissing(points, settings.Motion, hidden, messages);
}

//----------------------------------------------------------------------------
int rtglyphs::GlyphArrays::OrientationMode(vtkDataArray* orientations, const rtglyphs::GlyphSettings& settings)
{
  const int components = orientations ? orientations->GetNumberOfComponents() : 0;
  if (components == 4)
  {
    return Settings::QUATERNION;
  }
  return components == 9 ? Settings::MATRIX : settings.OrientationMode;
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphArrays::Trail(vtkPolyData* points, const rtglyphs::GlyphSettings& settings)
{
  return settings.TrailSteps > 0 ? points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::Trail) : nullptr;
}

//----------------------------------------------------------------------------
std::vector<vtkDataArray*> rtglyphs::GlyphArrays::All(vtkPolyData* points, const rtglyphs::GlyphSettings& settings)
{
  const std::array<vtkDataArray*, 4> motion = rtglyphs::GlyphMotion::Arrays(points, settings.Motion);
  std::vector<vtkDataArray*> all = { points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
    points->GetPointData()->GetArray(rtglyphs::RayTracedArrays::CompositeIndex),
    rtglyphs::GlyphTensors::Array(points, settings.Tensors), rtglyphs::GlyphForms::Array(points, settings.Forms),
    Trail(points, settings), motion[0], motion[1], motion[2], motion[3] };
  for (int id = 0; id < NUMBER_OF_IDS; ++id)
  {
    all.push_back(Find(static_cast<Id>(id), points, settings));
  }
  return all;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphArrays::Key rtglyphs::GlyphArrays::KeyOf(
  vtkPolyData* points, std::vector<rtglyphs::GlyphSettings> settings, const rtglyphs::RayTracedRanges& hidden)
{
  Key key{ std::move(settings), {}, hidden };
  for (rtglyphs::GlyphSettings& each : key.Settings)
  {
    each = each.Effective();
    for (vtkDataArray* array : All(points, each))
    {
      key.Times.push_back(array ? array->GetMTime() : 0);
    }
  }
  return key;
}

//----------------------------------------------------------------------------
std::vector<vtkIdType> rtglyphs::GlyphArrays::Candidates(
  vtkPolyData* points, const rtglyphs::GlyphScaling& settings, const rtglyphs::RayTracedRanges& hidden)
{
  return settings.Mask.Choose(points,
    rtglyphs::RayTracedParallel::Select(
      points->GetNumberOfPoints(), [&hidden](vtkIdType i) { return !hidden.Has(i); }));
}
