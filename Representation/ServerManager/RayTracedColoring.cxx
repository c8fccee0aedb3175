#include "RayTracedColoring.h"

#include "DataSummary.h"
#include "DirectionColors.h"
#include "GlyphJoinedArrays.h"
#include "GlyphShapes.h"
#include "GlyphTensors.h"
#include "RayTracedDefault.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace
{
using namespace rtglyphs::GlyphArrayRoles;
using Shapes = rtglyphs::GlyphShapes;
using rtglyphs::GlyphJoinedArrays::vanDerWaals;

constexpr double fewNegative = 0.1; // fraction of the tensors, as noise makes it

std::string ValueOf(vtkSMProxy* proxy, const char* name)
{
  const char* value = vtkSMPropertyHelper(proxy, name).GetAsString();
  return value && strcmp(value, "None") != 0 ? value : "";
}

// The last two of five strings are association and name.
std::string ColorArrayOf(vtkSMProxy* proxy, unsigned int string = 4)
{
  const char* value = vtkSMPropertyHelper(proxy, "ColorArrayName").GetAsString(string);
  return value ? value : "";
}

vtkSMRayTracedArrayListDomain* ScaleArrays(vtkSMProxy* glyphs)
{
  return glyphs->GetProperty("SelectScaleArray")->FindDomain<vtkSMRayTracedArrayListDomain>();
}

// Shapes whose surfaces GlyphTensorColoring colors; empty: none, or no array.
std::string TensorsOf(vtkSMProxy* glyphs, int shape)
{
  return !Shapes::IsColored(shape)
    ? std::string()
    : ValueOf(glyphs, shape == Shapes::SPHERICAL_HARMONICS ? "GlyphHarmonicsArray" : "GlyphTensorArray");
}

// NONE: directions do.
int TensorColoring(vtkSMProxy* glyphs, int shape)
{
  if (shape == Shapes::SPHERICAL_HARMONICS || shape == Shapes::FOURTH_ORDER_TENSOR)
  {
    return rtglyphs::GlyphTensors::NONE;
  }
  const vtkSMPropertyHelper summary(glyphs, "DataSummary");
  const bool positive = summary.GetAsDouble(rtglyphs::DataSummary::NEGATIVE_TENSORS) <= fewNegative;
  return !positive              ? rtglyphs::GlyphTensors::SIGN
    : shape == Shapes::REYNOLDS ? rtglyphs::GlyphTensors::NONE
                                : rtglyphs::GlyphTensors::FRACTIONAL_ANISOTROPY;
}

// Where ParaView's settings say so; scripts do it themselves.
void UpdateBars(vtkSMProxy* glyphs, vtkSMProxy* view)
{
  vtkSMProxy* settings = glyphs->GetSessionProxyManager()->GetProxy("settings", "GeneralSettings");
  vtkSMProperty* mode = settings ? settings->GetProperty("ScalarBarMode") : nullptr;
  if (mode && vtkSMPropertyHelper(mode).GetAsInt() == 0) // Automatically show and hide color bars
  {
    vtkNew<vtkSMTransferFunctionManager> tables;
    tables->UpdateScalarBars(view,
      vtkSMTransferFunctionManager::SHOW_USED_SCALAR_BARS | vtkSMTransferFunctionManager::HIDE_UNUSED_SCALAR_BARS);
  }
}

// By an array of the data.
bool AreOriented(vtkSMProxy* glyphs)
{
  const std::string direction = ValueOf(glyphs, "SelectOrientationVectors");
  const std::vector<Array> arrays =
    glyphs->GetProperty("SelectOrientationVectors")->FindDomain<vtkSMRayTracedArrayListDomain>()->Listed();
  return vtkSMPropertyHelper(glyphs, "Orient").GetAsInt() &&
    std::any_of(arrays.begin(), arrays.end(), [&](const Array& array) { return array.Name == direction; });
}

// Vectors without a magnitude to show.
bool IsUnit(const Array& array)
{
  return array.Components > 1 && std::abs(array.Least - 1.0) < 1e-3 && std::abs(array.Largest - 1.0) < 1e-3;
}

// Three bytes or more are a color, not a magnitude that a table maps.
bool AreColors(const Array& array)
{
  return array.IsColor && array.IsWhole && array.Components > 2;
}

// Whether an array, if there is one, has a range of colors, unlike a load that is still zero.
bool HasRange(vtkSMProxy* glyphs, const std::string& name)
{
  const std::vector<Array> arrays = ScaleArrays(glyphs)->Listed();
  return std::none_of(arrays.begin(), arrays.end(),
    [&](const Array& array) { return array.Name == name && array.IsKnown() && array.Least == array.Largest; });
}

// The glyphs' direction, else the size, else colors, else the array with the best score. Empty: none, or the direction
// is several arrays, or has unit length.
std::string ArrayToColorBy(vtkSMProxy* glyphs, int shape)
{
  vtkSMRayTracedArrayListDomain* domain = ScaleArrays(glyphs);
  std::vector<Array> arrays = domain->Listed();
  const auto isJoined = [](const Array& array) { return !array.Columns.empty(); }; // which ColorArrayName does not take
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isJoined), arrays.end());
  const auto isListed = [&arrays](const std::string& name, bool varies)
  {
    return std::any_of(arrays.begin(), arrays.end(),
      [&](const Array& array)
      {
        return array.Name == name && array.Components <= 3 &&
          !(varies && array.IsKnown() && array.Least == array.Largest);
      });
  };
  vtkSMProxy* source = vtkSMPropertyHelper(glyphs, "GlyphType").GetAsProxy();
  const bool arrows = shape == 0 && source &&
    (strcmp(source->GetXMLName(), "ArrowSource") == 0 || strcmp(source->GetXMLName(), "ConeSource") == 0);
  const bool directed = shape == Shapes::SPLIT_VECTOR || Shapes::IsUncertain(shape) ||
    (arrows && vtkSMPropertyHelper(glyphs, "Orient").GetAsInt());
  const std::string direction = directed ? ValueOf(glyphs, "SelectOrientationVectors") : "";
  std::string size =
    vtkSMPropertyHelper(glyphs, "ScaleMode").GetAsInt() != 0 ? ValueOf(glyphs, "SelectScaleArray") : "";
  size = size.starts_with(vanDerWaals) ? size.substr(vanDerWaals.size()) : size; // elements, which have colors
  const bool unit = std::any_of(
    arrays.begin(), arrays.end(), [&](const Array& array) { return array.Name == direction && IsUnit(array); });
  if (unit || (direction.find(", ") != std::string::npos && !isListed(direction, false)))
  {
    return {};
  }
  const auto colors = std::find_if(arrays.begin(), arrays.end(), AreColors);
  return isListed(direction, false) ? direction
    : isListed(size, true)          ? size
    : colors != arrays.end()        ? colors->Name
                                    : domain->ChooseFor(LENGTH, arrays).Name;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedColoring::Begin(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  this->Begun = true;
  const std::string setting =
    std::string(".") + display->GetXMLGroup() + "." + display->GetXMLName() + ".ColorArrayName";
  const std::string found = ColorArrayOf(display);
  std::vector<Array> arrays = ScaleArrays(glyphs)->Listed();
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), [&](const Array& array) { return array.Name != found; }),
    arrays.end());
  const bool isQuantity = !arrays.empty() && !IsUnit(arrays.front()) &&
    (arrays.front().IsColor || ScaleArrays(glyphs)->ChooseFor(SIZE, arrays));
  if (!isQuantity && !vtkSMSettings::GetInstance()->HasSetting(setting.c_str()))
  {
    this->Wanted = true;
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedColoring::Enter(vtkSMProxy* glyphs)
{
  this->Chosen = ColorArrayOf(glyphs, 3) + ColorArrayOf(glyphs);
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedColoring::Follow(vtkSMProxy* glyphs, const std::string& name)
{
  if (name != "ColorArrayName" && name != "GlyphTensorColoring" && name != "GlyphDirectionColoring")
  {
    return false;
  }
  const std::string before = this->Chosen;
  this->Enter(glyphs);
  const bool chosen = !this->Choosing && (name != "ColorArrayName" || this->Chosen != before);
  if (chosen)
  {
    this->Wanted = false;
    vtkSMPropertyHelper(glyphs, "ColorFromData").Set(0);
    this->TakeBack(glyphs, name);
  }
  return chosen;
}

//----------------------------------------------------------------------------
// Directions and arrays do not color the same glyphs.
void rtglyphs::RayTracedColoring::TakeBack(vtkSMProxy* glyphs, const std::string& chosen)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const bool array = !ColorArrayOf(display).empty();
  const bool directions = vtkSMPropertyHelper(display, "GlyphDirectionColoring").GetAsInt() != 0;
  this->Choosing = true;
  if (array && directions && chosen == "GlyphDirectionColoring")
  {
    vtkSMPropertyHelper(display, "ColorArrayName").SetInputArrayToProcess(vtkDataObject::POINT, "");
    this->Replaced = true;
  }
  else if (array && directions && chosen == "ColorArrayName")
  {
    vtkSMPropertyHelper(display, "GlyphDirectionColoring").Set(rtglyphs::DirectionColors::NONE);
  }
  this->Choosing = false;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedColoring::FollowBytes(vtkSMProxy* glyphs, bool window)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const std::string shown = ColorArrayOf(display);
  const std::vector<Array> arrays = ScaleArrays(glyphs)->Listed();
  const bool bytes = std::any_of(
    arrays.begin(), arrays.end(), [&](const Array& array) { return array.Name == shown && AreColors(array); });
  if (window && this->Begun && std::exchange(this->Bytes, bytes) != bytes)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(display, "MapScalars").Set(bytes ? 0 : 1);
    display->UpdateVTKObjects();
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedColoring::Update(vtkSMProxy* glyphs, vtkSMProxy* view)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  auto* colored = vtkSMPVRepresentationProxy::SafeDownCast(display);
  // Scripts of 3D Glyphs, which say nothing of colors, have the same picture with ray-traced glyphs.
  const bool window = rtglyphs::RayTracedDefault::IsInWindow(display);
  if (this->Wanted && window)
  {
    vtkSMPropertyHelper(glyphs, "ColorFromData").Set(1);
    this->Wanted = false;
  }
  this->FollowBytes(glyphs, window);
  if (window && std::exchange(this->Replaced, false))
  {
    UpdateBars(glyphs, view);
  }
  if (!colored || !vtkSMPropertyHelper(glyphs, "ColorFromData").GetAsInt())
  {
    return;
  }
  const int shape = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt();
  const std::string tensors = TensorsOf(glyphs, shape);
  const int coloring = tensors.empty() ? rtglyphs::GlyphTensors::NONE : TensorColoring(glyphs, shape);
  const std::string array = tensors.empty() ? ArrayToColorBy(glyphs, shape) : std::string();
  const bool directions =
    tensors.empty() ? array.empty() && AreOriented(glyphs) : coloring == rtglyphs::GlyphTensors::NONE;
  const std::string shown = !tensors.empty() ? tensors + ' ' + std::to_string(coloring) : directions ? " " : array;
  const bool ranged = HasRange(glyphs, array), again = shown == this->Shown;
  if (shown.empty() || (again && (this->Ranged || !ranged)))
  {
    return; // a time step that has nothing to color by changes nothing
  }
  this->Shown = shown;
  this->Ranged = ranged;
  this->Choosing = true;
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(glyphs, "GlyphTensorColoring").Set(coloring);
    vtkSMPropertyHelper(display, "GlyphDirectionColoring")
      .Set(directions ? rtglyphs::DirectionColors::AXES : rtglyphs::DirectionColors::NONE);
    display->UpdateVTKObjects();
  }
  if (array.empty() && !ColorArrayOf(display).empty())
  {
    colored->SetScalarColoring(nullptr, vtkDataObject::POINT); // no scalar bar of an invisible array
  }
  if (!array.empty() && (again || ColorArrayOf(display) != array)) // as in a state that is loaded, with its own table
  {
    auto* input = vtkSMInputArrayDomain::SafeDownCast(glyphs->GetProperty("Input")->GetDomain("scale_array"));
    const bool cells = input && input->GetAttributeType() == vtkSMInputArrayDomain::CELL;
    const int association = cells ? vtkDataObject::CELL : vtkDataObject::POINT;
    SM_SCOPED_TRACE(SetScalarColoring)
      .arg("display", display)
      .arg("arrayname", array.c_str())
      .arg("attribute_type", association);
    colored->SetScalarColoring(array.c_str(), association);
    colored->RescaleTransferFunctionToDataRange(/*extend=*/false, /*force=*/false);
    const std::vector<Array> arrays = ScaleArrays(glyphs)->Listed();
    vtkSMProxy* table = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
    if (table && !vtkSMPropertyHelper(table, "UseLogScale").GetAsInt() && // else another display has mapped its points
      std::any_of(
        arrays.begin(), arrays.end(), [&](const Array& one) { return one.Name == array && IsOverDecades(one); }))
    {
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", table);
      vtkSMTransferFunctionProxy::MapControlPointsToLogSpace(table);
      vtkSMPropertyHelper(table, "UseLogScale").Set(1);
      table->UpdateVTKObjects();
    }
  }
  display->UpdateVTKObjects();
  this->Choosing = false;
  this->FollowBytes(glyphs, window);
  if (window && !this->Bytes) // a bar would show what no table maps
  {
    UpdateBars(glyphs, view);
  }
}
