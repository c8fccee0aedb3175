#include "vtkGlyphTuples.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"
#include "vtkRayTracedBlocks.h"
#include "vtkRayTracedParallel.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <sstream>

namespace
{
using Settings = vtkGlyphSettings;

// Of the lengths of orientation tuples, the first that a mode takes.
int ModeFrom(int mode)
{
  return mode == Settings::DIRECTION ? 0 : mode == Settings::ROTATION ? 1 : mode == Settings::QUATERNION ? 2 : 3;
}

// A row of the table of arrays.
struct Description
{
  std::string Settings::*Name;
  bool (*IsWanted)(const Settings&);
  std::vector<int> (*Lengths)(const Settings&); // of tuples that make sense; none: any
  const char* Property;
  const char* Without; // what happens without the array
};

// In the order of vtkGlyphArrays::Id.
const std::array<Description, vtkGlyphArrays::NUMBER_OF_IDS> table = { {
  { &Settings::ScaleArray, [](const Settings& settings) { return settings.Scaling; },
    [](const Settings& settings) {
      return settings.ScaleMode == Settings::COMPONENTS ? std::vector<int>{ 1, 3 } : std::vector<int>{};
    },
    "SelectScaleArray", "all glyphs get the same size" },
  { &Settings::OrientationArray, [](const Settings& settings) { return settings.Orient; },
    [](const Settings& settings)
    {
      const std::vector<int> all = { 2, 3, 4, 9 }; // longer tuples say by themselves what they are
      return std::vector<int>(all.begin() + ModeFrom(settings.OrientationMode), all.end());
    },
    "SelectOrientationVectors", "the glyphs are not turned" },
  { &Settings::TableIndexArray, [](const Settings& settings) { return settings.HasTable(); },
    [](const Settings&) { return std::vector<int>{}; }, "GlyphTableIndexArray",
    "all points have the table's first form" },
  { &Settings::ExponentArray, [](const Settings& settings) { return settings.HasOwnExponents(); },
    [](const Settings&) {
      return std::vector<int>{ 1, 2, 3 };
    },
    "GlyphExponentArray", "GlyphExponents count" },
  { &Settings::OpacityArray, [](const Settings&) { return true; },
    [](const Settings&) { return std::vector<int>{ 1 }; }, "GlyphOpacityArray", "all glyphs have the same opacity" },
  { &Settings::RadiusArray, [](const Settings& settings) { return !settings.Tensors.On; },
    [](const Settings&) { return std::vector<int>{ 1 }; }, "GlyphRadiusArray",
    "glyphs are as wide as their scale says" },
} };
}

//----------------------------------------------------------------------------
vtkDataArray*
vtkGlyphArrays::Find(Id id, vtkPolyData* points, const vtkGlyphSettings& settings, std::vector<std::string>* messages)
{
  const Description& how = table[id];
  const std::string& name = settings.*how.Name;
  if (!how.IsWanted(settings) || vtkRayTracedArrays::IsNone(name))
  {
    return nullptr;
  }
  vtkDataArray* array = points->GetPointData()->GetArray(name.c_str());
  const std::vector<int> lengths = how.Lengths(settings);
  const bool fits = array &&
    (lengths.empty() || std::find(lengths.begin(), lengths.end(), array->GetNumberOfComponents()) != lengths.end());
  if (!array && messages && !vtkRayTracedBlocks::IsOfRanks(points))
  {
    messages->push_back("There is no point array '" + name + "', which " + how.Property + " names; " + how.Without +
      ". Choose one that exists, or None.");
  }
  else if (array && !fits && messages)
  {
    std::ostringstream text;
    text << "The point array '" << name << "', which " << how.Property << " names, has "
         << array->GetNumberOfComponents() << " components where " << lengths.front();
    for (std::size_t i = 1; i < lengths.size(); ++i)
    {
      text << (i + 1 < lengths.size() ? ", " : " or ") << lengths[i];
    }
    text << " are needed; " << how.Without << ". Choose another array or mode.";
    messages->push_back(text.str());
  }
  return fits ? array : nullptr;
}

//----------------------------------------------------------------------------
int vtkGlyphArrays::OrientationMode(vtkDataArray* orientations, const vtkGlyphSettings& settings)
{
  const int components = orientations ? orientations->GetNumberOfComponents() : 0;
  if (components == 4)
  {
    return Settings::QUATERNION;
  }
  return components == 9 ? Settings::MATRIX : settings.OrientationMode;
}

//----------------------------------------------------------------------------
std::vector<vtkDataArray*> vtkGlyphArrays::All(vtkPolyData* points, const vtkGlyphSettings& settings)
{
  const std::array<vtkDataArray*, 3> motion = vtkGlyphMotion::Arrays(points, settings.Motion);
  std::vector<vtkDataArray*> all = { points->GetPoints() ? points->GetPoints()->GetData() : nullptr,
    points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex),
    vtkGlyphTensors::Array(points, settings.Tensors), vtkGlyphForms::Array(points, settings.Forms), motion[0],
    motion[1], motion[2] };
  for (int id = 0; id < NUMBER_OF_IDS; ++id)
  {
    all.push_back(Find(static_cast<Id>(id), points, settings));
  }
  return all;
}

//----------------------------------------------------------------------------
vtkGlyphArrays::Key vtkGlyphArrays::KeyOf(
  vtkPolyData* points, std::vector<vtkGlyphSettings> settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  Key key{ std::move(settings), {}, vtkGlyphBlockAttributes::Hidden(blocks) };
  for (vtkGlyphSettings& each : key.Settings)
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
std::vector<vtkIdType> vtkGlyphArrays::Candidates(
  vtkPolyData* points, const vtkGlyphScaling& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  auto* blockIds =
    vtkUnsignedIntArray::SafeDownCast(points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex));
  const auto isVisible = [&](vtkIdType i)
  {
    if (!blockIds || blocks.empty())
    {
      return true;
    }
    const auto block = blocks.find(blockIds->GetValue(i));
    return block == blocks.end() || block->second.Visible;
  };
  return settings.Mask.Choose(points, vtkRayTracedParallel::Select(points->GetNumberOfPoints(), isVisible));
}
