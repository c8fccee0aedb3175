#include "RayTracedColoring.h"

#include "DataSummary.h"
#include "DirectionColors.h"
#include "GlyphJoinedArrays.h"
#include "GlyphShapes.h"
#include "GlyphTensors.h"
#include "RayTracedChoices.h"
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
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
using namespace rtglyphs::GlyphArrayRoles;
using Shapes = rtglyphs::GlyphShapes;
using List = vtkSMRayTracedArrayListDomain;
using rtglyphs::GlyphJoinedArrays::vanDerWaals;

constexpr double fewNegative = 0.1; // fraction of the tensors, as noise makes it

// The last two of five strings are association and name.
std::string ColorArrayOf(vtkSMProxy* proxy, unsigned int string = 4)
{
  const char* value = vtkSMPropertyHelper(proxy, "ColorArrayName").GetAsString(string);
  return value ? value : "";
}

// Shapes whose surfaces GlyphTensorColoring colors; empty: none, or no array.
std::string TensorsOf(vtkSMProxy* glyphs, int shape)
{
  return !Shapes::IsColored(shape)
    ? std::string()
    : List::Named(glyphs, shape == Shapes::SPHERICAL_HARMONICS ? "GlyphHarmonicsArray" : "GlyphTensorArray");
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

// Where ParaView's settings say so; scripts do it themselves. `before`: the table of the last colors, whose bar may be
// of no use; others may be of glyphs colored by tensors, which ParaView does not ask.
void UpdateBars(vtkSMProxy* view, vtkSMProxy* before)
{
  vtkSMProxy* settings = view->GetSessionProxyManager()->GetProxy("settings", "GeneralSettings");
  vtkSMProperty* mode = settings ? settings->GetProperty("ScalarBarMode") : nullptr;
  if (mode && vtkSMPropertyHelper(mode).GetAsInt() == 0) // Automatically show and hide color bars
  {
    vtkNew<vtkSMTransferFunctionManager> tables;
    tables->UpdateScalarBars(view, vtkSMTransferFunctionManager::SHOW_USED_SCALAR_BARS);
    if (before)
    {
      tables->HideScalarBarIfNotNeeded(before, view);
    }
  }
}

// Whether an array of the data orients the glyphs.
bool AreOriented(vtkSMProxy* glyphs)
{
  auto* list = List::Of(glyphs, "SelectOrientationVectors");
  return vtkSMPropertyHelper(glyphs, "Orient").GetAsInt() &&
    list->Find(List::Named(glyphs, "SelectOrientationVectors"));
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

// The glyphs' direction, else the size, else colors, else the array with the best score; none of joined arrays, which
// ColorArrayName does not take. Empty: none, or the direction is several arrays, or has unit length.
std::string ArrayToColorBy(vtkSMProxy* glyphs, int shape)
{
  List* list = List::Of(glyphs, "SelectScaleArray");
  const auto has = [](const Array& array) { return array && array.Columns.empty() && array.Components <= 3; };
  const bool directed =
    Shapes::IsVector(shape) || (List::AreArrows(glyphs) && vtkSMPropertyHelper(glyphs, "Orient").GetAsInt());
  const std::string direction = directed ? List::Named(glyphs, "SelectOrientationVectors") : "";
  const Array vector = list->Find(direction);
  if (IsUnit(vector) || (!has(vector) && direction.find(", ") != std::string::npos))
  {
    return {};
  }
  std::string sizes =
    vtkSMPropertyHelper(glyphs, "ScaleMode").GetAsInt() != 0 ? List::Named(glyphs, "SelectScaleArray") : "";
  const Array size = list->Find(
    sizes.starts_with(vanDerWaals) ? sizes.substr(vanDerWaals.size()) : sizes); // elements, which have colors
  std::vector<Array> arrays = list->Listed();
  std::erase_if(arrays, [](const Array& array) { return !array.Columns.empty(); });
  const auto colors = std::find_if(arrays.begin(), arrays.end(), AreColors);
  return has(vector)                  ? vector.Name
    : has(size) && !size.IsConstant() ? size.Name
    : colors != arrays.end()          ? colors->Name
                                      : list->ChooseFor(LENGTH, arrays).Name;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedColoring::Begin(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const std::string setting =
    std::string(".") + display->GetXMLGroup() + "." + display->GetXMLName() + ".ColorArrayName";
  const Array found = List::Of(glyphs, "SelectScaleArray")->Find(ColorArrayOf(display));
  const bool isQuantity =
    found && !IsUnit(found) && (found.IsColor || List::Of(glyphs, "SelectScaleArray")->ChooseFor(SIZE, { found }));
  this->Begun = true;
  this->Wanted |= !isQuantity && !vtkSMSettings::GetInstance()->HasSetting(setting.c_str());
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedColoring::UpdateColorArray(vtkSMProxy* glyphs)
{
  const std::string array = ColorArrayOf(glyphs, 3) + ColorArrayOf(glyphs);
  return std::exchange(this->ColoredBy, array) != array;
}

//----------------------------------------------------------------------------
// Directions and arrays do not color the same glyphs.
void rtglyphs::RayTracedColoring::ClearOther(vtkSMProxy* glyphs, const std::string& chosen)
{
  this->Wanted &= chosen != "ColorArrayName" && chosen != "GlyphTensorColoring" && chosen != "GlyphDirectionColoring";
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const bool array = !ColorArrayOf(display).empty();
  const bool directions = vtkSMPropertyHelper(display, "GlyphDirectionColoring").GetAsInt() != 0;
  const RayTracedChoices::Scope scope;
  if (array && directions && chosen == "GlyphDirectionColoring")
  {
    vtkSMPropertyHelper(display, "ColorArrayName").SetInputArrayToProcess(vtkDataObject::POINT, "");
    this->Replaced = true;
  }
  else if (array && directions && chosen == "ColorArrayName")
  {
    vtkSMPropertyHelper(display, "GlyphDirectionColoring").Set(rtglyphs::DirectionColors::NONE);
  }
}

//----------------------------------------------------------------------------
// Scripts of 3D Glyphs, which say nothing of colors, have the same picture with ray-traced glyphs.
void rtglyphs::RayTracedColoring::Update(vtkSMProxy* glyphs, vtkSMProxy* view)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const bool window = rtglyphs::RayTracedChoices::IsInWindow(display);
  if (window && std::exchange(this->Wanted, false))
  {
    vtkSMPropertyHelper(glyphs, "ColorFromData").Set(1);
  }
  const vtkSmartPointer<vtkSMProxy> table = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
  const bool chosen = vtkSMPropertyHelper(glyphs, "ColorFromData").GetAsInt() && this->Choose(glyphs);
  const bool bytes = AreColors(List::Of(glyphs, "SelectScaleArray")->Find(ColorArrayOf(display)));
  if (window && this->Begun && std::exchange(this->Bytes, bytes) != bytes)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(display, "MapScalars").Set(bytes ? 0 : 1);
    display->UpdateVTKObjects();
  }
  if (window && (std::exchange(this->Replaced, false) || chosen) && !this->Bytes) // a bar would show what no table maps
  {
    const bool same =
      table == vtkSMPropertyHelper(display, "LookupTable").GetAsProxy() && !ColorArrayOf(display).empty();
    UpdateBars(view, same ? nullptr : table.Get());
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedColoring::Choose(vtkSMProxy* glyphs)
{
  auto* display = vtkSMPVRepresentationProxy::SafeDownCast(glyphs->GetTrueParentProxy());
  const int shape = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt();
  const std::string tensors = TensorsOf(glyphs, shape);
  const int coloring = tensors.empty() ? rtglyphs::GlyphTensors::NONE : TensorColoring(glyphs, shape);
  const std::string name = tensors.empty() ? ArrayToColorBy(glyphs, shape) : std::string();
  const Array array = List::Of(glyphs, "SelectScaleArray")->Find(name);
  const bool directions =
    tensors.empty() ? name.empty() && AreOriented(glyphs) : coloring == rtglyphs::GlyphTensors::NONE;
  const std::string shown = !tensors.empty() ? tensors + ' ' + std::to_string(coloring) : directions ? " " : name;
  const bool ranged = !array.IsConstant(); // unlike a load that is still zero
  const bool again = shown == this->Shown;
  if (!display || shown.empty() || (again && (this->Ranged || !ranged)))
  {
    return false; // a time step that has nothing to color by changes nothing
  }
  this->Shown = shown;
  this->Ranged = ranged;
  const RayTracedChoices::Scope scope;
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(glyphs, "GlyphTensorColoring").Set(coloring);
    vtkSMPropertyHelper(display, "GlyphDirectionColoring")
      .Set(directions ? rtglyphs::DirectionColors::AXES : rtglyphs::DirectionColors::NONE);
    display->UpdateVTKObjects();
  }
  if (name.empty() && !ColorArrayOf(display).empty())
  {
    display->SetScalarColoring(nullptr, vtkDataObject::POINT); // no scalar bar of an invisible array
  }
  if (!name.empty() && (again || ColorArrayOf(display) != name)) // as in a state that is loaded, with its own table
  {
    auto* input = vtkSMInputArrayDomain::SafeDownCast(glyphs->GetProperty("Input")->GetDomain("scale_array"));
    const bool cells = input && input->GetAttributeType() == vtkSMInputArrayDomain::CELL;
    const int association = cells ? vtkDataObject::CELL : vtkDataObject::POINT;
    SM_SCOPED_TRACE(SetScalarColoring)
      .arg("display", display)
      .arg("arrayname", name.c_str())
      .arg("attribute_type", association);
    display->SetScalarColoring(name.c_str(), association);
    display->RescaleTransferFunctionToDataRange(/*extend=*/false, /*force=*/false);
    vtkSMProxy* table = vtkSMPropertyHelper(display, "LookupTable").GetAsProxy();
    if (table && IsOverDecades(array) &&
      !vtkSMPropertyHelper(table, "UseLogScale").GetAsInt()) // else another display has mapped its points
    {
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", table);
      vtkSMTransferFunctionProxy::MapControlPointsToLogSpace(table);
      vtkSMPropertyHelper(table, "UseLogScale").Set(1);
      table->UpdateVTKObjects();
    }
  }
  display->UpdateVTKObjects();
  return true;
}
