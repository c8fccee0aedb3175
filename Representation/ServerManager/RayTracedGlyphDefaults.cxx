#include "RayTracedGlyphDefaults.h"

#include "RayTracedDefault.h"
#include "RayTracedSuggestion.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkPVXMLParser.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <vector>

namespace
{
// ParaView names a display's representations to subclasses of its proxies only.
struct Display : vtkSMProxy
{
  static vtkSMProxy* Representation(vtkSMProxy* display, const char* name)
  {
    vtkSMProxy* (vtkSMProxy::*representation)(const char*) = &Display::GetSubProxy;
    return (display->*representation)(name);
  }
};

// ParaView lets subclasses choose only.
struct InputArrays : vtkSMInputArrayDomain
{
  static void List(vtkSMDomain* domain, int attributeType, const std::vector<int>& numbersOfComponents)
  {
    void (vtkSMInputArrayDomain::*set)(int) = &InputArrays::SetAttributeType;
    if (auto* arrays = vtkSMInputArrayDomain::SafeDownCast(domain))
    {
      (arrays->*set)(attributeType);
      arrays->*(&InputArrays::AcceptableNumbersOfComponents) = numbersOfComponents;
    }
  }
};

const char* const sharedArrays[] = { "SelectOrientationVectors", "SelectScaleArray" };

// Those that the choice of arrays depends on: what turns and scales arrows differs from what turns and scales bodies.
const std::set<std::string> decisive = { "GlyphShape", "GlyphType", "ScaleMode", "SelectOrientationVectors" };

// Those that ray-traced glyphs have another default of.
const std::set<std::string> defaultedAnew = { "GlyphType", "Orient", "ScaleFactor", "Scaling", "SelectScaleArray",
  "SelectOrientationVectors" };

bool ShowsGlyphs(vtkSMProxy* display)
{
  vtkSMProperty* type = display->GetProperty("Representation");
  return type && strcmp(vtkSMPropertyHelper(type).GetAsString(), "Ray Traced Glyphs") == 0;
}

bool IsNone(vtkSMProxy* display, const char* array)
{
  const char* value = vtkSMPropertyHelper(display, array).GetAsString();
  return !value || !value[0] || strcmp(value, "None") == 0;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::ShowInPanel(vtkSMProxy* display)
{
  display->GetProperty("GlyphType")->SetPanelVisibility("default");
  for (const char* name : { "ScaleFactor", "SelectOrientationVectors", "SelectScaleArray" })
  {
    display->GetProperty(name)->SetPanelVisibilityDefaultForRepresentation("ray traced glyphs");
  }
  for (const char* name : { "SelectOrientationVectors", "SelectScaleArray" })
  {
    display->GetProperty(name)->SetPanelWidget("RayTracedGlyphsArray");
  }
  const auto where = [](const std::string& property, const std::string& value, const std::string& more = "")
  {
    return "<PropertyWidgetDecorator type='GenericDecorator' mode='visibility' property='" + property + "' value='" +
      value + "' " + more + "/>";
  };
  const std::string hints = "<Hints><PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
    where("Interpolation", "3") + "<Expression type='and'>" + where("ShadingMode", "2") + "<Expression type='or'>" +
    where("Representation", "Ray Traced Glyphs") + where("Representation", "Ray Traced Surface") +
    where("Representation", "Ray Traced Tubes") +
    "</Expression></Expression></Expression></PropertyWidgetDecorator></Hints>";
  const vtkSmartPointer<vtkPVXMLElement> element = vtkPVXMLParser::ParseXML(hints.c_str());
  for (const char* name : { "Metallic", "Roughness", "CoatStrength", "CoatIOR", "CoatRoughness", "CoatColor" })
  {
    display->GetProperty(name)->SetHints(element);
  }
  // ParaView's Coloring says nothing true while tensors are colored by themselves.
  const std::string colored = "<Hints><PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
    where("Representation", "Ray Traced Glyphs", "inverse='1'") + where("GlyphTensorColoring", "0") +
    "<PropertyWidgetDecorator type='GenericDecorator' mode='visibility' property='GlyphShape' values='0 5 10 11'/>" +
    "</Expression></PropertyWidgetDecorator></Hints>";
  const vtkSmartPointer<vtkPVXMLElement> coloring = vtkPVXMLParser::ParseXML(colored.c_str());
  for (size_t i = 0; i < display->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = display->GetPropertyGroup(i);
    if (group->GetXMLLabel() && strcmp(group->GetXMLLabel(), "Coloring") == 0)
    {
      group->SetHints(coloring);
    }
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::Follow(vtkSMProxy* glyphs, const std::string& name)
{
  if (name == "GlyphLocation")
  {
    this->ListArrays(glyphs);
    this->ChooseArrays(glyphs, Where::Lost);
  }
  // While the display is made ParaView changes them, and what another client sets comes with its ScaleFactorFromData.
  if (this->Choosing || !this->InView || rtglyphs::RayTracedSuggestion::IsTaking() ||
    glyphs->GetSession()->IsProcessingRemoteNotification())
  {
    return;
  }
  if (defaultedAnew.count(name))
  {
    this->Chosen.insert(name);
  }
  if (decisive.count(name) && ShowsGlyphs(glyphs->GetTrueParentProxy()))
  {
    this->ChooseArrays(glyphs, Where::Everywhere);
  }
  if (name == "ScaleFactor")
  {
    vtkSMProxy* display = glyphs->GetTrueParentProxy();
    const bool reset = rtglyphs::RayTracedDefault::IsOfDomains(display->GetProperty("ScaleFactor"));
    if (reset)
    {
      this->Chosen.erase(name);
    }
    vtkSMPropertyHelper(glyphs, "ScaleFactorFromData").Set(reset && ShowsGlyphs(display));
    glyphs->GetProperty("ScaleFactorFromData")->Modified(); // so that the data are asked again
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::Choose(vtkSMProxy* glyphs)
{
  this->InView = true;
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  vtkSMSessionProxyManager* proxies = glyphs->GetSessionProxyManager();
  if (!ShowsGlyphs(display))
  {
    // Capsules and superquadrics are turned by matrices and quaternions, which 3D Glyphs does not take beside
    // directions.
    const bool own = this->Shown && vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() != 0;
    this->Choosing = true;
    for (const char* name : sharedArrays)
    {
      if (own && !this->Chosen.count(name))
      {
        display->GetProperty(name)->ResetToDomainDefaults();
      }
    }
    this->Choosing = this->Shown = false;
    return;
  }
  this->Shown = true;
  if (proxies && proxies->GetInLoadXMLState())
  {
    this->Chosen = defaultedAnew; // states say all
    return;
  }
  this->ListArrays(glyphs);
  this->Choosing = true;
  this->ChooseArrays(glyphs, Where::Everywhere);
  for (const char* name : { "Orient", "Scaling" })
  {
    if (!this->Chosen.count(name))
    {
      vtkSMPropertyHelper(display, name).Set(1);
    }
  }
  vtkSMProperty* type = display->GetProperty("GlyphType");
  auto* list = type->FindDomain<vtkSMProxyListDomain>();
  vtkSMProxy* sphere = list ? list->FindProxy("sources", "SphereSource") : nullptr;
  if (sphere && !this->Chosen.count("GlyphType") && IsNone(display, "SelectOrientationVectors"))
  {
    vtkSMPropertyHelper(type).Set(sphere);
  }
  if (!this->Chosen.count("ScaleFactor"))
  {
    vtkSMPropertyHelper(glyphs, "ScaleFactorFromData").Set(1);
  }
  this->Choosing = false;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedGlyphDefaults::Renew(vtkSMProxy* glyphs, bool otherTime)
{
  return this->ChooseArrays(glyphs, otherTime ? Where::Missing : Where::Lost);
}

//----------------------------------------------------------------------------
// An array that scales is chosen when a mode takes it.
bool rtglyphs::RayTracedGlyphDefaults::ChooseArrays(vtkSMProxy* glyphs, Where where)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  bool changed = false;
  for (const char* name : sharedArrays)
  {
    const bool scales = strcmp(name, "SelectScaleArray") == 0;
    vtkSMProperty* own = glyphs->GetProperty(name);
    auto* list = own ? own->FindDomain<vtkSMRayTracedArrayListDomain>() : nullptr;
    vtkSMProperty* shared = display->GetProperty(name);
    if (!list || !shared || shared == own || this->Chosen.count(name) ||
      (scales && vtkSMPropertyHelper(glyphs, "ScaleMode").GetAsInt() == 0))
    {
      continue;
    }
    const std::string before = vtkSMPropertyHelper(shared).GetAsString();
    unsigned int index = 0;
    if (IsNone(display, name) || where == Where::Everywhere ||
      (where != Where::Missing && !list->IsInDomain(before.c_str(), index)))
    {
      this->ChooseArray(glyphs, name);
      changed |= before != vtkSMPropertyHelper(shared).GetAsString();
    }
  }
  return changed;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::ChooseArray(vtkSMProxy* glyphs, const char* name)
{
  vtkSMProperty* own = glyphs->GetProperty(name);
  vtkSMProperty* shared = glyphs->GetTrueParentProxy()->GetProperty(name);
  const bool choosing = this->Choosing;
  this->Choosing = true;
  own->FindDomain<vtkSMRayTracedArrayListDomain>()->SetDefaultValues(shared, /*useUncheckedValues=*/false);
  own->Copy(shared); // links pass nothing on while they pass on ScaleMode
  this->Choosing = choosing;
}

//----------------------------------------------------------------------------
// The lists of arrays are those of the input that the glyphs stand on, also in 3D Glyphs' properties.
void rtglyphs::RayTracedGlyphDefaults::ListArrays(vtkSMProxy* glyphs)
{
  vtkSMProxy* other = Display::Representation(glyphs->GetTrueParentProxy(), "Glyph3DRepresentation");
  if (other && this->InView)
  {
    const bool cells = vtkSMPropertyHelper(glyphs, "GlyphLocation").GetAsInt() != 0;
    vtkSMProperty* input = other->GetProperty("Input");
    const int type = cells ? vtkSMInputArrayDomain::CELL : vtkSMInputArrayDomain::POINT;
    InputArrays::List(input->GetDomain("scale_array"), type, {});
    InputArrays::List(input->GetDomain("vector_array"), type, { 2, 3, 4, 9 });
    input->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
  }
  glyphs->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
}
