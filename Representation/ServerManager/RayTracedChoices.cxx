#include "RayTracedChoices.h"

#include "DataSummary.h"
#include "DirectionColors.h"
#include "GlyphArrayRoles.h"
#include "GlyphKeptGuess.h"
#include "GlyphShapes.h"
#include "vtkCommand.h"
#include "vtkGlyph3DMapper.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMRayTracedRepresentationProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

namespace
{
using rtglyphs::RayTracedChoices;
using Shapes = rtglyphs::GlyphShapes;
using List = vtkSMRayTracedArrayListDomain;

int choosing = 0; // scopes

// What follows the data while the second property is on.
struct FromData
{
  const char *Property, *Switch;
};
constexpr FromData fromData[] = {
  { "ScaleFactor", "ScaleFactorFromData" },
  { "ColorArrayName", "ColorFromData" },
  { "GlyphTensorColoring", "ColorFromData" },
  { "GlyphDirectionColoring", "ColorFromData" },
};

// The choice of arrays depends on these: arrows and bodies have different arrays for orientation and scale.
const std::set<std::string> decisive = { "GlyphShape", "GlyphType", "ScaleMode", "SelectOrientationVectors" };

// With these the user has decided what glyphs look like.
const std::set<std::string> forms = { "GlyphShape", "GlyphType", "ScaleMode", "Scaling", "SelectScaleArray", "Orient",
  "SelectOrientationVectors", "GlyphTensorArray", "GlyphHarmonicsArray" };

// What is chosen when glyphs are shown first, besides properties with domains that choose.
const char* const chosenFirst[] = { "GlyphShape", "GlyphType", "Orient", "ScaleFactor", "ScaleMode", "Scaling",
  "SelectScaleArray", "SelectOrientationVectors", "ColorArrayName", "GlyphTensorLookupTable" };

bool Shows(vtkSMProxy* display, const char* representation)
{
  vtkSMProperty* type = display->GetProperty("Representation");
  const char* name = type ? vtkSMPropertyHelper(type).GetAsString() : nullptr;
  return name && strncmp(name, representation, strlen(representation)) == 0;
}

bool IsLoadingState(vtkSMProxy* glyphs)
{
  vtkSMSessionProxyManager* proxies = glyphs->GetSessionProxyManager();
  return proxies && proxies->GetInLoadXMLState();
}

// The number that a domain of bounds would set; NaN: none.
double Suggested(vtkSMProperty* property)
{
  auto suggested = vtk::TakeSmartPointer(property->NewInstance());
  suggested->Copy(property);
  auto* domain = property->FindDomain<vtkSMBoundsDomain>();
  return domain && domain->SetDefaultValues(suggested, /*use_unchecked_values=*/false)
    ? vtkSMPropertyHelper(suggested).GetAsDouble()
    : std::nan("");
}

// Which chooses the value of a property of a display; null: none does.
vtkSMDomain* DomainOf(vtkSMProxy* glyphs, const std::string& name)
{
  vtkSMProperty* own = glyphs->GetProperty(name.c_str());
  if (auto* list = own->FindDomain<List>())
  {
    return list;
  }
  if (name == "GlyphLocation")
  {
    return own->FindDomain<vtkSMEnumerationDomain>();
  }
  const bool exposed = glyphs->GetTrueParentProxy()->GetProperty(name.c_str()) == own;
  return exposed && name != "ShutterTime" ? own->FindDomain<vtkSMBoundsDomain>() : nullptr;
}
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedChoices::Scope::Scope()
{
  ++choosing;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedChoices::Scope::~Scope()
{
  --choosing;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::IsChoosing()
{
  return choosing > 0;
}

//----------------------------------------------------------------------------
vtkSMProxy* rtglyphs::RayTracedChoices::GlyphsOf(vtkSMProxy* display)
{
  vtkSMProperty* exposed = display->GetProperty("GlyphShape");
  return exposed ? exposed->GetParent() : nullptr;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::ShowsGlyphs(vtkSMProxy* display)
{
  return Shows(display, "Ray Traced Glyphs");
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::ShowsSurface(vtkSMProxy* display)
{
  return Shows(display, "Ray Traced Surface");
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::ShowsRayTraced(vtkSMProxy* display)
{
  return Shows(display, "Ray Traced");
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::IsInWindow(vtkSMProxy* display)
{
  return vtkSMPropertyHelper(display, "SamplesPerRender").GetAsInt() < 0;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedChoices* rtglyphs::RayTracedChoices::Of(vtkSMProperty* property)
{
  auto* glyphs = vtkSMRayTracedRepresentationProxy::SafeDownCast(property->GetParent());
  return glyphs ? &glyphs->GetChoices() : nullptr;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::Is(const std::string& name, By by) const
{
  const auto found = this->Chosen.find(name);
  return (found != this->Chosen.end() ? found->second : NOBODY) == by;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::IsDefault(vtkSMProperty* property)
{
  RayTracedChoices* choices = Of(property);
  return choices && choices->Is(property->GetXMLName(), PLUGIN) &&
    (vtkSMDoubleVectorProperty::SafeDownCast(property) || !ShowsRayTraced(property->GetParent()->GetTrueParentProxy()));
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedChoices::Reset(vtkSMProperty* property, bool found)
{
  if (RayTracedChoices* choices = Of(property))
  {
    choices->Chosen[property->GetXMLName()] = found ? PLUGIN : NOBODY;
  }
}

//----------------------------------------------------------------------------
// While the display is made ParaView sets its properties. What another client sets comes with its FromData; those that
// 3D Glyphs has, too, that client may have chosen from the data.
bool rtglyphs::RayTracedChoices::PropertyChanging(vtkSMProxy* glyphs, const std::string& name)
{
  const bool other = name != "ColorArrayName" || (this->InView && this->Coloring.UpdateColorArray(glyphs));
  if (IsChoosing())
  {
    this->Chosen[name] = PLUGIN;
    return false;
  }
  if (!other || !this->InView)
  {
    return false;
  }
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const bool remote = glyphs->GetSession()->IsProcessingRemoteNotification();
  if (!remote || display->GetProperty(name.c_str()) == glyphs->GetProperty(name.c_str()))
  {
    this->Chosen[name] = USER;
  }
  if (remote)
  {
    return false;
  }
  for (const FromData& one : fromData)
  {
    if (name == one.Property)
    {
      vtkSMPropertyHelper(glyphs, one.Switch).Set(0);
    }
  }
  if (name == "ScaleFactor")
  {
    vtkSMProperty* factor = display->GetProperty("ScaleFactor");
    if (vtkSMPropertyHelper(factor).GetAsDouble() == Suggested(factor)) // a reset
    {
      this->Chosen.erase(name);
      vtkSMPropertyHelper(glyphs, "ScaleFactorFromData").Set(ShowsGlyphs(display));
      glyphs->GetProperty("ScaleFactorFromData")->Modified(); // so that the value is computed again
    }
  }
  return true;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedChoices::PropertyChanged(vtkSMProxy* glyphs, const std::string& name, bool byUser)
{
  if (name == "GlyphLocation")
  {
    // The lists of arrays are those of the input that the glyphs stand on.
    glyphs->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
  }
  if (!this->InView)
  {
    return;
  }
  if (name == "GlyphLocation")
  {
    this->RenewAll(glyphs, Renewed::Invalid);
  }
  if (name == "GlyphShape")
  {
    this->Renew(glyphs, "GlyphLocation", Renewed::All);
  }
  if (name == "GlyphTensorColoring" || name == "GlyphTensorArray" || name == "GlyphHarmonicsArray")
  {
    this->Chosen.erase("GlyphTensorLookupTable"); // another number gets its own
  }
  if (name == "TubeRadiusArray")
  {
    this->Renew(glyphs, "TubeRadius", Renewed::All);
  }
  if (!byUser)
  {
    return;
  }
  this->WaitsForForm &= forms.count(name) == 0;
  this->Coloring.ClearOther(glyphs, name);
  if (decisive.count(name) && ShowsGlyphs(glyphs->GetTrueParentProxy()))
  {
    if (name == "GlyphShape")
    {
      this->ChooseScaleMode(glyphs);
    }
    this->ChooseArrays(glyphs);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedChoices::Choose(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  const bool loading = IsLoadingState(glyphs);
  if (!std::exchange(this->InView, true))
  {
    this->Coloring.UpdateColorArray(glyphs); // what colors it now ParaView has chosen
    // What is neither chosen nor the default of the XML comes from a state or the user's settings.
    auto properties = vtk::TakeSmartPointer(glyphs->NewPropertyIterator());
    for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
    {
      const char* name = properties->GetKey();
      auto* property = vtkSMVectorProperty::SafeDownCast(properties->GetProperty());
      if (property && property == display->GetProperty(name) && this->Is(name, NOBODY) && !property->IsValueDefault())
      {
        this->Chosen[name] = USER;
      }
    }
  }
  if (!this->TubesShown && Shows(display, "Ray Traced Tubes"))
  {
    this->TubesShown = true;
    this->TubesWanted = !loading;
  }
  const Scope scope;
  if (!ShowsGlyphs(display))
  {
    // Capsules and superquadrics are turned by matrices and quaternions, which 3D Glyphs does not take beside
    // directions.
    const bool own =
      std::exchange(this->Shown, false) && vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() != Shapes::GLYPH_TYPE;
    for (const char* name : { "SelectOrientationVectors", "SelectScaleArray" })
    {
      if (own && !this->IsUsers(name))
      {
        display->GetProperty(name)->ResetToDomainDefaults();
      }
    }
    return;
  }
  this->Shown = true;
  if (loading)
  {
    for (const char* name : chosenFirst)
    {
      this->Chosen[name] = USER; // states say all
    }
    return;
  }
  glyphs->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
  this->ChooseArrays(glyphs);
  for (const char* name : { "Orient", "Scaling" })
  {
    if (!this->IsUsers(name))
    {
      vtkSMPropertyHelper(display, name).Set(1);
    }
  }
  this->ChooseForm(glyphs);
  if (!this->IsUsers("ScaleFactor"))
  {
    vtkSMPropertyHelper(glyphs, "ScaleFactorFromData").Set(1);
  }
  if (!this->IsUsers("ColorArrayName") && !this->IsUsers("GlyphTensorColoring") &&
    !this->IsUsers("GlyphDirectionColoring"))
  {
    this->Coloring.Begin(glyphs);
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::Renew(vtkSMProxy* glyphs, bool otherTime)
{
  const bool renewed = this->RenewAll(glyphs, otherTime ? Renewed::Unset : Renewed::Invalid);
  const bool formed = ShowsGlyphs(glyphs->GetTrueParentProxy()) && this->ChooseForm(glyphs);
  return (otherTime && this->RenewRadius(glyphs)) || renewed || formed;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedChoices::RenewAll(vtkSMProxy* glyphs, Renewed which)
{
  bool renewed = false;
  auto properties = vtk::TakeSmartPointer(glyphs->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    renewed |= this->Renew(glyphs, properties->GetKey(), which);
  }
  return renewed;
}

//----------------------------------------------------------------------------
// Arrays that 3D Glyphs has, too, are the display's; one that scales is chosen when a mode takes it.
bool rtglyphs::RayTracedChoices::Renew(vtkSMProxy* glyphs, const std::string& name, Renewed which)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  vtkSMProperty* own = glyphs->GetProperty(name.c_str());
  vtkSMProperty* shared = display->GetProperty(name.c_str());
  vtkSMDomain* domain = DomainOf(glyphs, name);
  if (!domain || !shared || this->IsUsers(name) || (shared != own && !ShowsGlyphs(display)) ||
    (name == "SelectScaleArray" && vtkSMPropertyHelper(glyphs, "ScaleMode").GetAsInt() == 0))
  {
    return false;
  }
  auto* list = List::SafeDownCast(domain);
  const bool points = name == "GlyphLocation" && vtkSMPropertyHelper(shared).GetAsInt() == 0; // also of no arrays
  const bool none = list ? List::Named(display, name.c_str()).empty() : points || this->Is(name, NOBODY);
  const auto isLost = [&]
  {
    const char* array = vtkSMPropertyHelper(shared).GetAsString();
    unsigned int index = 0;
    return list && (!list->IsInDomain(array, index) || list->HasBetterThan(array));
  };
  if (which != Renewed::All && !none && (which == Renewed::Unset || !isLost()))
  {
    return false;
  }
  const Scope scope;
  const vtkMTimeType before = shared->GetMTime();
  if (shared == own)
  {
    own->ResetToDomainDefaults(/*use_unchecked_values=*/false);
  }
  else
  {
    domain->SetDefaultValues(shared, /*use_unchecked_values=*/false);
    own->Copy(shared); // links pass nothing on while they pass on ScaleMode
  }
  return shared->GetMTime() != before;
}

//----------------------------------------------------------------------------
// Over time tubes keep their radius, unless the lines, or the values that scale it, become that much larger.
bool rtglyphs::RayTracedChoices::RenewRadius(vtkSMProxy* glyphs)
{
  constexpr double mostExcess = rtglyphs::GlyphKeptGuess::mostExcess;
  vtkSMProperty* radius = glyphs->GetProperty("TubeRadius");
  const double ratio = Suggested(radius) / vtkSMPropertyHelper(radius).GetAsDouble();
  const bool scaled = !List::Named(glyphs, "TubeRadiusArray").empty();
  return (scaled ? mostExcess * ratio < 1.0 : ratio > mostExcess) && this->Renew(glyphs, "TubeRadius", Renewed::All);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedChoices::ChooseArrays(vtkSMProxy* glyphs)
{
  this->Renew(glyphs, "SelectOrientationVectors", Renewed::All);
  this->Renew(glyphs, "SelectScaleArray", Renewed::All);
}

//----------------------------------------------------------------------------
// Arrows where the data have directions, else spheres, or what tensors and sizes are shown by. Spheres of data that
// have none of these wait for some. Returns whether it has found any.
bool rtglyphs::RayTracedChoices::ChooseForm(vtkSMProxy* glyphs)
{
  if (!this->WaitsForForm || this->IsUsers("GlyphType"))
  {
    return false;
  }
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  vtkSMProperty* type = display->GetProperty("GlyphType");
  auto* list = type->FindDomain<vtkSMProxyListDomain>();
  const bool directions = !List::Named(display, "SelectOrientationVectors").empty();
  vtkSMProxy* form = list ? list->FindProxy("sources", directions ? "ArrowSource" : "SphereSource") : nullptr;
  if (!form)
  {
    return false;
  }
  const Scope scope;
  // Arrows in place of spheres that were chosen here; another form is a default of the user's.
  if (vtkSMPropertyHelper(type).GetAsProxy() != form && (!directions || this->Is("GlyphType", PLUGIN)))
  {
    vtkSMPropertyHelper(type).Set(form);
    this->ChooseArrays(glyphs);
  }
  bool sizes = false;
  if (!directions)
  {
    this->ChooseShape(glyphs);
    this->ChooseScaleMode(glyphs);
    auto* scales = List::Of(glyphs, "SelectScaleArray");
    sizes =
      rtglyphs::GlyphArrayRoles::IsSize(scales->ChooseFor(rtglyphs::GlyphArrayRoles::SIZE, scales->Listed()).Name);
  }
  this->WaitsForForm =
    !directions && !sizes && vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() == Shapes::GLYPH_TYPE;
  return !this->WaitsForForm;
}

//----------------------------------------------------------------------------
// In the window data that have neither directions nor sizes show their tensors, else their spherical harmonics.
void rtglyphs::RayTracedChoices::ChooseShape(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  auto* scales = List::Of(glyphs, "SelectScaleArray");
  const auto tensors = List::Of(glyphs, "GlyphTensorArray")->Choose();
  const auto shown = tensors ? tensors : List::Of(glyphs, "GlyphHarmonicsArray")->Choose();
  const int shape = !shown.IsEvident || tensors.Components > 9 ? Shapes::GLYPH_TYPE
    : !tensors                                                 ? Shapes::SPHERICAL_HARMONICS
    : tensors.IsNegative                                       ? Shapes::SIGNED_TENSOR_SUPERQUADRIC
                                                               : Shapes::TENSOR_ELLIPSOID;
  if (shape != Shapes::GLYPH_TYPE && !this->IsUsers("GlyphShape") && IsInWindow(display) &&
    vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() == Shapes::GLYPH_TYPE &&
    !rtglyphs::GlyphArrayRoles::IsSize(scales->ChooseFor(rtglyphs::GlyphArrayRoles::SIZE, scales->Listed()).Name))
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(display, "GlyphShape").Set(shape);
    this->ChooseArrays(glyphs);
    display->UpdateVTKObjects();
  }
}

//----------------------------------------------------------------------------
// In the window bodies, and default spheres, take their sizes from the data.
void rtglyphs::RayTracedChoices::ChooseScaleMode(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  if (this->IsUsers("ScaleMode") || !IsInWindow(display))
  {
    return;
  }
  const auto size = List::Of(glyphs, "SelectScaleArray")->Choose();
  const bool turned = List::IsBody(glyphs);
  const bool sphere = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() == Shapes::GLYPH_TYPE &&
    !this->IsUsers("GlyphType") && List::Named(glyphs, "SelectOrientationVectors").empty();
  const bool sized = (turned || sphere) && rtglyphs::GlyphArrayRoles::IsSize(size.Name);
  const int mode = !sized  ? vtkGlyph3DMapper::NO_DATA_SCALING
    : size.Components == 1 ? vtkGlyph3DMapper::SCALE_BY_MAGNITUDE
                           : vtkGlyph3DMapper::SCALE_BY_COMPONENTS;
  const Scope scope;
  vtkSMProperty* shared = display->GetProperty("ScaleMode");
  vtkSMPropertyHelper(shared).Set(mode);
  glyphs->GetProperty("ScaleMode")->Copy(shared);
  this->ChooseArrays(glyphs);
}

//----------------------------------------------------------------------------
// In the window, once: the colors of their directions, where nothing colors them, and the radius of the only array of
// that name.
void rtglyphs::RayTracedChoices::ChooseTubes(vtkSMProxy* display)
{
  if (!Shows(display, "Ray Traced Tubes") || !std::exchange(this->TubesWanted, false) || !IsInWindow(display))
  {
    return;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
  const Scope scope;
  const char* color = vtkSMPropertyHelper(display, "ColorArrayName").GetAsString(4);
  if (!(color && color[0]))
  {
    vtkSMPropertyHelper(display, "GlyphDirectionColoring").Set(rtglyphs::DirectionColors::AXES);
  }
  vtkSMProperty* radius = display->GetProperty("TubeRadiusArray");
  auto* list = radius->FindDomain<vtkSMStringListDomain>();
  std::vector<std::string> radii;
  for (unsigned int i = 0; i < list->GetNumberOfStrings(); ++i)
  {
    if (rtglyphs::GlyphArrayRoles::DiametersOf(list->GetString(i)) > 0.0)
    {
      radii.emplace_back(list->GetString(i));
    }
  }
  if (radii.size() == 1 && List::Named(display, "TubeRadiusArray").empty())
  {
    vtkSMPropertyHelper(radius).Set(radii.front().c_str());
  }
  display->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
// Processes that have the data have found the numbers of what is shown, and those that render get them.
void rtglyphs::RayTracedChoices::PullNumbers(vtkSMProxy* glyphs)
{
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  vtkSMProperty* summary = glyphs->GetProperty("DataSummary");
  glyphs->UpdatePropertyInformation(summary);
  {
    const Scope scope;
    const double found = vtkSMPropertyHelper(summary).GetAsDouble(rtglyphs::DataSummary::SCALE_FACTOR);
    if (found > 0.0 && vtkSMPropertyHelper(display, "ScaleFactorFromData").GetAsInt())
    {
      vtkSMPropertyHelper(display, "ScaleFactor").Set(found);
    }
    display->UpdateVTKObjects();
  }
  glyphs->GetProperty("DataSummaryOfServer")->Copy(summary);
  glyphs->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedChoices::Update(vtkSMProxy* glyphs, vtkSMProxy* view, bool visible)
{
  const bool shown = visible && ShowsGlyphs(glyphs->GetTrueParentProxy());
  if (visible)
  {
    this->PullNumbers(glyphs);
    this->ChooseTubes(glyphs->GetTrueParentProxy());
  }
  if (shown)
  {
    this->Coloring.Update(glyphs, view);
  }
  this->TensorTable.Update(glyphs, view, shown, this->IsUsers("GlyphTensorLookupTable"));
}
