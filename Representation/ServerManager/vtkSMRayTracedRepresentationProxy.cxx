#include "vtkSMRayTracedRepresentationProxy.h"

#include "vtkCommand.h"
#include "vtkGlyphTensors.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkPVXMLParser.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkRayTracedSelectionEncoder.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMRayTracedDoubleVectorProperty.h"
#include "vtkSMRayTracedLocationProperty.h"
#include "vtkSMRayTracedStringVectorProperty.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstring>

vtkStandardNewMacro(vtkSMRayTracedRepresentationProxy);

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

// The representation that a display shows, when it is ray traced.
vtkSMProxy* ShownBy(vtkSMProxy* display)
{
  vtkSMProperty* type = display->GetProperty("Representation");
  const std::string name = type ? vtkSMPropertyHelper(type).GetAsString() : "";
  return name == "Ray Traced Glyphs" ? Display::Representation(display, "RayTracedGlyphRepresentation")
    : name == "Ray Traced Surface"   ? Display::Representation(display, "RayTracedSurfaceRepresentation")
    : name == "Ray Traced Tubes"     ? Display::Representation(display, "RayTracedTubeRepresentation")
                                     : nullptr;
}

// Properties whose default the data choose (vtkSMRayTracedArrayListDomain): our own, and those of 3D Glyphs.
const char* const arrays[] = { "GlyphTensorArray", "GlyphHarmonicsArray", "VelocityArray" };
const char* const sharedArrays[] = { "SelectScaleArray", "SelectOrientationVectors" };

// Of the properties that 3D Glyphs has, those that ray-traced glyphs have another default of.
const std::set<std::string> defaultedAnew = { "GlyphType", "Orient", "ScaleFactor", "Scaling", "SelectScaleArray",
  "SelectOrientationVectors" };

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

// The panel shows 3D Glyphs' properties at once, and path tracing's material not with Interpolation PBR alone.
void ShowInPanel(vtkSMProxy* display)
{
  display->GetProperty("GlyphType")->SetPanelVisibility("default");
  for (const char* name :
    { "Orient", "ScaleFactor", "ScaleMode", "Scaling", "SelectOrientationVectors", "SelectScaleArray" })
  {
    display->GetProperty(name)->SetPanelVisibilityDefaultForRepresentation("ray traced glyphs");
  }
  const auto where = [](const std::string& property, const std::string& value)
  {
    return "<PropertyWidgetDecorator type='GenericDecorator' mode='visibility' property='" + property + "' value='" +
      value + "'/>";
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
}

bool IsNone(vtkSMProxy* display, const char* array)
{
  const char* value = vtkSMPropertyHelper(display, array).GetAsString();
  return !value || !value[0] || strcmp(value, "None") == 0;
}

// While one display's value is copied to the others, their changes are not copied on.
bool sharing = false;
}

// A number that the data suggest while FromData is on, and Switch where there is one; a second element of Guess is
// Limit's.
struct vtkSMRayTracedRepresentationProxy::Suggested
{
  const char *Number, *FromData, *Guess, *Limit, *Switch;
};

namespace
{
const std::array<vtkSMRayTracedRepresentationProxy::Suggested, 2> suggestions = { {
  { "ScaleFactor", "ScaleFactorFromData", "ScaleFactorGuess", "GlyphSizeLimit", nullptr },
  { "ShutterTime", "ShutterTimeFromData", "ShutterTimeGuess", nullptr, "MotionBlur" },
} };
}

//----------------------------------------------------------------------------
vtkSMProxy*
vtkSMRayTracedRepresentationProxy::FindDisplay(vtkSMProxy* view, const std::function<bool(vtkSMProxy*)>& wanted)
{
  const vtkSMPropertyHelper displays(view, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; i < displays.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* display = displays.GetAsProxy(i);
    if (display && wanted(display))
    {
      return display;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedRepresentationProxy::ShowsRayTraced(vtkSMProxy* display)
{
  if (!display->GetProperty("Representation") || !vtkSMPropertyHelper(display, "Visibility", true).GetAsInt())
  {
    return false;
  }
  return ShownBy(display) != nullptr;
}

//----------------------------------------------------------------------------
vtkSMRayTracedRepresentationProxy::vtkSMRayTracedRepresentationProxy()
{
  vtkRayTracedSelectionEncoder::Register();
}

//----------------------------------------------------------------------------
vtkSMRayTracedRepresentationProxy::~vtkSMRayTracedRepresentationProxy() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TensorTableName: " << this->TensorTableName << endl;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->CreateVTKObjects();
  auto* local = vtkRayTracedRepresentation::SafeDownCast(this->GetClientSideObject());
  const vtkTypeUInt32 everywhere = this->Location;
  vtkPVXMLElement* hints = property ? property->GetHints() : nullptr;
  if (everywhere != 0 && hints && hints->FindNestedElementByName("OfData"))
  {
    this->Location = vtkPVSession::DATA_SERVER_ROOT;
  }
  else if (everywhere != 0 && local && local->GetRenderedRemotely())
  {
    this->Location = vtkPVSession::RENDER_SERVER_ROOT;
  }
  this->Superclass::UpdatePropertyInformationInternal(property);
  this->Location = everywhere;
  // What a display shares is that of one of its representations; what it tells is of the one that is shown.
  vtkSMProxy* display = this->GetTrueParentProxy();
  vtkSMProxy* shown = display ? ShownBy(display) : nullptr;
  for (const char* name : { "RenderStatistics", "ShutterTimeGuess" })
  {
    vtkSMProperty* own = this->GetProperty(name);
    if (shown && shown != this && own && (!property || property == own) && this->IsExposed(name))
    {
      vtkSMProperty* told = shown->GetProperty(name);
      shown->UpdatePropertyInformation(told);
      own->Copy(told);
    }
  }
}

//----------------------------------------------------------------------------
// Null while the display is in no view.
vtkSMProxy* vtkSMRayTracedRepresentationProxy::FindView()
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  for (unsigned int i = 0; display && i < display->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* consumer = display->GetConsumerProxy(i);
    if (consumer && consumer->IsA("vtkSMViewProxy"))
    {
      return consumer;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
// Glyphs and surfaces of one display share their properties: those of one of the two are what users see.
bool vtkSMRayTracedRepresentationProxy::IsExposed(const char* name)
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  return display && display->GetProperty(name) && display->GetProperty(name) == this->GetProperty(name);
}

//----------------------------------------------------------------------------
// Of a display's representations one has the property that users see, and the others get its value.
bool vtkSMRayTracedRepresentationProxy::IsFollower(const char* name)
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  return display && display->GetProperty(name) && display->GetProperty(name) != this->GetProperty(name);
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedRepresentationProxy::HoldsForView(const char* name)
{
  vtkSMProperty* property = this->GetProperty(name);
  vtkPVXMLElement* hints = property ? property->GetHints() : nullptr;
  return hints && hints->FindNestedElementByName("OfView") && this->IsExposed(name);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  for (const Suggested& suggested : suggestions)
  {
    vtkSMProperty* fromData = this->GetProperty(suggested.FromData); // none yet while the proxy is made
    if (fromData && flag && name && strcmp(name, suggested.Number) == 0 && !this->TakingGuess &&
      !this->IsFollower(name))
    {
      // Who sets it wants that one. Before the change itself is told, so that undoing both ends with the data's choice.
      vtkSMPropertyHelper(fromData).Set(0);
    }
  }
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  if (flag && name && strcmp(name, "Input") == 0)
  {
    this->TakeSelection();
  }
  if (flag && name)
  {
    // The last word counts: another number asks for its own table, until somebody chooses one.
    const bool table = strcmp(name, "GlyphTensorLookupTable") == 0;
    const bool number = strcmp(name, "GlyphTensorColoring") == 0 || strcmp(name, "GlyphTensorArray") == 0 ||
      strcmp(name, "GlyphHarmonicsArray") == 0;
    this->TensorTableChosen = table || (this->TensorTableChosen && !number);
  }
  if (flag && name && defaultedAnew.count(name))
  {
    this->NoteChoice(name);
  }
  if (flag && name && strcmp(name, "ScaleMode") == 0)
  {
    this->ChooseSharedArrays(vtkSMRayTracedDefault::Where::Missing);
  }
  if (flag && name && strcmp(name, "GlyphLocation") == 0)
  {
    this->ListArraysOfLocation();
    for (const char* array : arrays)
    {
      this->RenewDefault(array, vtkSMRayTracedDefault::Where::Lost);
    }
    this->ChooseSharedArrays(vtkSMRayTracedDefault::Where::Lost);
  }
  if (flag && name && strcmp(name, "TubeRadiusArray") == 0)
  {
    this->RenewDefault("TubeRadius", vtkSMRayTracedDefault::Where::Everywhere);
  }
  if (flag && name && !sharing && !this->ApplyingQuality)
  {
    this->FollowQuality(name);
  }
  if (flag && name && !sharing && this->HoldsForView(name))
  {
    this->ShareWithView(name);
  }
}

//----------------------------------------------------------------------------
// One of the properties shared with 3D Glyphs has changed. While the display is made ParaView changes them.
void vtkSMRayTracedRepresentationProxy::NoteChoice(const std::string& name)
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  vtkSMProperty* shared = display ? display->GetProperty(name.c_str()) : nullptr;
  if (!shared || this->Choosing || !this->FindView())
  {
    return;
  }
  this->Chosen.insert(name);
  if (name == "ScaleFactor")
  {
    const bool reset = vtkSMRayTracedDefault().Has(shared);
    if (reset)
    {
      this->Chosen.erase(name);
    }
    vtkSMPropertyHelper(this, "ScaleFactorFromData").Set(reset && ShownBy(display) == this);
    this->GetProperty("ScaleFactorFromData")->Modified(); // so that the data are asked again
  }
}

//----------------------------------------------------------------------------
// What nobody has chosen gets the defaults of ray-traced glyphs when a display is first shown as such: they are as
// large as the data suggest and turned where the data have directions, and spheres where they have none.
void vtkSMRayTracedRepresentationProxy::ChooseDefaults()
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  vtkSMSessionProxyManager* proxies = this->GetSessionProxyManager();
  if (!display || ShownBy(display) != this || !this->GetProperty("GlyphShape"))
  {
    return;
  }
  if (proxies && proxies->GetInLoadXMLState())
  {
    this->Chosen = defaultedAnew; // states say all
    return;
  }
  this->ListArraysOfLocation();
  this->Choosing = true;
  this->ChooseSharedArrays(vtkSMRayTracedDefault::Where::Everywhere);
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
    vtkSMPropertyHelper(this, "ScaleFactorFromData").Set(1);
  }
  this->Choosing = false;
}

//----------------------------------------------------------------------------
// Where there is none, or one that the glyphs' location does not have (Lost). Returns whether others were. One that
// scales is chosen when a mode takes it, for the form that the glyphs have then; ParaView's active scalars stay. Its
// active vectors may be normals: directions are chosen Everywhere.
bool vtkSMRayTracedRepresentationProxy::ChooseSharedArrays(vtkSMRayTracedDefault::Where where)
{
  using Where = vtkSMRayTracedDefault::Where;
  vtkSMProxy* display = this->GetTrueParentProxy();
  bool changed = false;
  for (const char* name : sharedArrays)
  {
    const bool scales = strcmp(name, "SelectScaleArray") == 0;
    vtkSMProperty* own = this->GetProperty(name);
    auto* list = own ? own->FindDomain<vtkSMRayTracedArrayListDomain>() : nullptr;
    if (!list || !display || !this->IsFollower(name) || this->Chosen.count(name) ||
      (scales && vtkSMPropertyHelper(this, "ScaleMode").GetAsInt() == 0))
    {
      continue;
    }
    const std::string before = vtkSMPropertyHelper(display, name).GetAsString();
    unsigned int index = 0;
    if (IsNone(display, name) || (where == Where::Everywhere && !scales) ||
      (where != Where::Missing && !list->IsInDomain(before.c_str(), index)))
    {
      const bool choosing = this->Choosing;
      this->Choosing = true;
      list->SetDefaultValues(display->GetProperty(name), /*useUncheckedValues=*/false);
      own->Copy(display->GetProperty(name)); // links pass nothing on while they pass on ScaleMode
      this->Choosing = choosing;
      changed |= before != vtkSMPropertyHelper(display, name).GetAsString();
    }
  }
  return changed;
}

//----------------------------------------------------------------------------
// The lists of arrays are those of the input that the glyphs stand on, also in 3D Glyphs' properties.
void vtkSMRayTracedRepresentationProxy::ListArraysOfLocation()
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  vtkSMProxy* glyphs = display ? Display::Representation(display, "Glyph3DRepresentation") : nullptr;
  if (glyphs && this->FindView()) // else the display is being made
  {
    const bool cells = vtkSMPropertyHelper(this, "GlyphLocation").GetAsInt() != 0;
    vtkSMProperty* input = glyphs->GetProperty("Input");
    const int type = cells ? vtkSMInputArrayDomain::CELL : vtkSMInputArrayDomain::POINT;
    InputArrays::List(input->GetDomain("scale_array"), type, {});
    InputArrays::List(input->GetDomain("vector_array"), type, { 2, 3, 4, 9 });
    input->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
  }
  this->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
}

//----------------------------------------------------------------------------
// ParaView's filter that extracts what is selected of the input; with it as an input a display is brought up to date,
// on all processes, when the selection changes.
void vtkSMRayTracedRepresentationProxy::TakeSelection()
{
  vtkSMProperty* selected = this->GetProperty("SelectedData");
  const vtkSMPropertyHelper input(this, "Input");
  auto* source = selected ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  if (source)
  {
    source->CreateSelectionProxies();
    vtkSMPropertyHelper(selected).Set(source->GetSelectionOutput(input.GetOutputPort()));
  }
}

//----------------------------------------------------------------------------
// A quality gives other properties the values that its hints name; one of these that gets another value ends it.
void vtkSMRayTracedRepresentationProxy::FollowQuality(const std::string& name)
{
  vtkSMProperty* quality = this->GetProperty("RenderingQuality");
  vtkPVXMLElement* hints = quality ? quality->GetHints() : nullptr;
  const bool made = quality && vtkSMPropertyHelper(quality).GetNumberOfElements() > 0; // has its default by now
  const int chosen = made ? vtkSMPropertyHelper(quality).GetAsInt() : 0;
  vtkPVXMLElement* values = nullptr;
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    int of = 0;
    vtkPVXMLElement* candidate = hints->GetNestedElement(i);
    values = candidate->GetScalarAttribute("of", &of) && of == chosen ? candidate : values;
  }
  if (!values)
  {
    return;
  }
  this->ApplyingQuality = true;
  for (const char* property : { "ShadingMode", "SamplesPerPixel", "Denoising" })
  {
    int value = 0;
    values->GetScalarAttribute(property, &value);
    vtkSMPropertyHelper helper(this, property);
    if (name == "RenderingQuality" && helper.GetAsInt() != value)
    {
      helper.Set(value);
    }
    else if (name == property && helper.GetAsInt() != value)
    {
      vtkSMPropertyHelper(quality).Set(0);
    }
  }
  this->ApplyingQuality = false;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedRepresentationProxy::RenewDefault(const char* name, vtkSMRayTracedDefault::Where where)
{
  vtkSMProperty* property = this->GetProperty(name);
  auto* strings = vtkSMRayTracedStringVectorProperty::SafeDownCast(property);
  auto* numbers = vtkSMRayTracedDoubleVectorProperty::SafeDownCast(property);
  auto* location = vtkSMRayTracedLocationProperty::SafeDownCast(property);
  return location ? location->RenewDefault(where)
    : strings     ? strings->RenewDefault(where)
                  : numbers && numbers->RenewDefault(where);
}

//----------------------------------------------------------------------------
// What the data shown before had nothing for, these may have, as the first time step with particles has arrays. While
// time goes on a default that was found stays; other data may have others.
void vtkSMRayTracedRepresentationProxy::RenewDefaults(vtkSMProxy* view)
{
  using Where = vtkSMRayTracedDefault::Where;
  const double time = vtkSMPropertyHelper(view, "ViewTime", /*quiet=*/true).GetAsDouble();
  const Where where = time == this->Time ? Where::Lost : Where::Missing;
  this->Time = time;
  bool renewed = this->IsExposed("GlyphLocation") && this->RenewDefault("GlyphLocation", Where::Missing);
  for (const char* name : arrays)
  {
    renewed |= this->IsExposed(name) && this->RenewDefault(name, where);
  }
  renewed |= this->ChooseSharedArrays(where);
  renewed |= this->IsExposed("TubeRadius") && this->RenewDefault("TubeRadius", Where::Missing);
  if (renewed)
  {
    this->UpdateVTKObjects();
    vtkSMViewProxy::SafeDownCast(view)->Update();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::ShareWithView(const char* name)
{
  vtkSMProxy* view = this->FindView();
  if (!view)
  {
    return;
  }
  sharing = true;
  FindDisplay(view,
    [this, name](vtkSMProxy* display)
    {
      vtkSMProperty* other = display->GetProperty(name);
      if (other && other != this->GetProperty(name) && display != this->GetTrueParentProxy())
      {
        other->Copy(this->GetProperty(name));
        display->UpdateVTKObjects();
      }
      return false; // all of them
    });
  sharing = false;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  if (!consumer || !consumer->IsA("vtkSMViewProxy"))
  {
    return;
  }
  if (this->ObservedView != consumer)
  {
    this->ObservedView = consumer;
    consumer->AddObserver(vtkCommand::EndEvent, this, &vtkSMRayTracedRepresentationProxy::Rendered);
  }
  this->TakeFromView(consumer);
  vtkSMProxy* display = this->GetTrueParentProxy();
  if (display && this->GetProperty("GlyphShape") && this->ObservedDisplay != display)
  {
    this->ObservedDisplay = display;
    display->GetProperty("Representation")
      ->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMRayTracedRepresentationProxy::ChooseDefaults);
    ShowInPanel(display);
    this->ChooseDefaults();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::TakeFromView(vtkSMProxy* view)
{
  vtkSMProxy* own = this->GetTrueParentProxy();
  vtkSMProxy* example =
    FindDisplay(view, [own](vtkSMProxy* display) { return display != own && display->GetProperty("ShadingMode"); });
  if (!own || !example || sharing)
  {
    return;
  }
  sharing = true;
  bool changed = false;
  auto properties = vtk::TakeSmartPointer(this->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    const char* name = properties->GetKey();
    if (this->HoldsForView(name) && example->GetProperty(name))
    {
      this->GetProperty(name)->Copy(example->GetProperty(name));
      changed = true;
    }
  }
  if (changed)
  {
    own->UpdateVTKObjects();
  }
  sharing = false;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::Rendered(vtkObject*, unsigned long, void* interactive)
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  const bool turning = interactive && *static_cast<int*>(interactive);
  if (!turning && this->IsExposed("RenderStatistics") && vtkSMPropertyHelper(display, "Visibility").GetAsInt() &&
    strncmp(vtkSMPropertyHelper(display, "Representation").GetAsString(), "Ray Traced", 10) == 0)
  {
    this->UpdatePropertyInformation();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  vtkSMProxy* display = this->GetTrueParentProxy();
  vtkSMProxy* shown = display && ShowsRayTraced(display) ? ShownBy(display) : nullptr;
  if (shown)
  {
    this->RenewDefaults(view);
  }
  for (const Suggested& suggested : suggestions)
  {
    if (shown && shown->GetProperty(suggested.Guess) && this->IsExposed(suggested.FromData))
    {
      this->TakeGuess(suggested);
    }
  }
  if (shown && shown->GetProperty("GlyphDataSizesInfo") && this->IsExposed("GlyphDataSizesInfo"))
  {
    this->TakeDataSizes();
  }
  if (this->GetProperty("GlyphTensorLookupTable") && this->IsExposed("GlyphTensorLookupTable"))
  {
    this->UpdateTensorTable(view);
  }
}

//----------------------------------------------------------------------------
// Between the update and the render of a view: processes that have the data have found the number, and those that
// render get it.
void vtkSMRayTracedRepresentationProxy::TakeGuess(const Suggested& suggested)
{
  const bool used = !suggested.Switch || vtkSMPropertyHelper(this, suggested.Switch).GetAsInt();
  if (!used || !vtkSMPropertyHelper(this, suggested.FromData).GetAsInt())
  {
    return;
  }
  vtkSMProperty* guess = this->GetProperty(suggested.Guess);
  this->UpdatePropertyInformation(guess);
  const vtkSMPropertyHelper found(guess);
  if (found.GetAsDouble() > 0.0)
  {
    vtkSMProxy* owner = this->IsFollower(suggested.Number) ? this->GetTrueParentProxy() : this;
    this->TakingGuess = this->Choosing = true;
    vtkSMPropertyHelper(owner, suggested.Number).Set(found.GetAsDouble());
    if (suggested.Limit)
    {
      vtkSMPropertyHelper(this, suggested.Limit).Set(found.GetAsDouble(1));
    }
    owner->UpdateVTKObjects();
    this->TakingGuess = this->Choosing = false;
  }
}

//----------------------------------------------------------------------------
// Then, too.
void vtkSMRayTracedRepresentationProxy::TakeDataSizes()
{
  vtkSMProperty* found = this->GetProperty("GlyphDataSizesInfo");
  this->UpdatePropertyInformation(found);
  const std::vector<double> sizes = vtkSMPropertyHelper(found).GetDoubleArray();
  vtkSMPropertyHelper(this, "GlyphDataSizes").Set(sizes.data(), static_cast<unsigned int>(sizes.size()));
  this->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
// The table of a tensor number has a name of its own, so that nothing of the table of an array is left in it.
void vtkSMRayTracedRepresentationProxy::UpdateTensorTable(vtkSMProxy* view)
{
  auto* local = vtkRayTracedRepresentation::SafeDownCast(this->GetClientSideObject());
  const vtkSMPropertyHelper coloring(this, "GlyphTensorColoring");
  const int shape = vtkSMPropertyHelper(this, "GlyphShape").GetAsInt();
  const bool tensor = (shape >= 6 && shape <= 8) || shape == 15;
  const bool polynomial = shape >= 12 && shape <= 14;
  const bool number = polynomial ? coloring.GetAsInt() == vtkGlyphTensors::RADIUS
                                 : tensor && vtkGlyphTensors::IsNumber(coloring.GetAsInt());
  const char* array = vtkSMPropertyHelper(this, shape == 12 ? "GlyphHarmonicsArray" : "GlyphTensorArray").GetAsString();
  std::string name;
  if (local && local->GetVisibility() && number && array && array[0] && strcmp(array, "None") != 0)
  {
    name = std::string(array) + " " + coloring.GetAsString();
  }
  vtkNew<vtkSMTransferFunctionManager> tables;
  vtkSMSessionProxyManager* proxies = this->GetSessionProxyManager();
  const auto barOf = [&](const std::string& of)
  { return tables->GetScalarBarRepresentation(tables->GetColorTransferFunction(of.c_str(), proxies), view); };
  if (name != this->TensorTableName && !this->TensorTableName.empty())
  {
    if (vtkSMProxy* bar = barOf(this->TensorTableName))
    {
      vtkSMPropertyHelper(bar, "Visibility").Set(0);
      bar->UpdateVTKObjects();
    }
  }
  const bool fresh = name != this->TensorTableName;
  this->TensorTableName = name;
  if (name.empty())
  {
    return;
  }
  vtkSMProxy* table = tables->GetColorTransferFunction(name.c_str(), proxies);
  vtkSMProperty* range = this->GetProperty("GlyphTensorRange");
  this->UpdatePropertyInformation(range);
  double found[2];
  vtkSMPropertyHelper(range).Get(found, 2);
  if (found[0] <= found[1] && (fresh || found[0] != this->TensorRange[0] || found[1] != this->TensorRange[1]))
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(table, found[0], found[1]);
    this->TensorRange[0] = found[0];
    this->TensorRange[1] = found[1];
  }
  if (!this->TensorTableChosen && vtkSMPropertyHelper(this, "GlyphTensorLookupTable").GetAsProxy() != table)
  {
    vtkSMPropertyHelper(this, "GlyphTensorLookupTable").Set(table);
    this->UpdateVTKObjects();
    this->TensorTableChosen = false;
  }
  if (vtkSMProxy* bar = fresh ? barOf(name) : nullptr)
  {
    vtkSMPropertyHelper(bar, "Title").Set(name.c_str());
    vtkSMPropertyHelper(bar, "ComponentTitle").Set("");
    vtkSMPropertyHelper(bar, "Enabled").Set(1);
    vtkSMPropertyHelper(bar, "Visibility").Set(1);
    bar->UpdateVTKObjects();
  }
}
