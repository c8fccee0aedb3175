#include "RayTracedGlyphDefaults.h"

#include "DataSummary.h"
#include "DirectionColors.h"
#include "GlyphShapes.h"
#include "GlyphTensors.h"
#include "RayTracedPeriodic.h"
#include "RayTracedSuggestion.h"
#include "vtkCommand.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkPVXMLParser.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMTrace.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <utility>
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

const char* const sharedArrays[] = { "SelectOrientationVectors", "SelectScaleArray" };

// The choice of arrays depends on these: arrows and bodies have different arrays for orientation and scale.
const std::set<std::string> decisive = { "GlyphShape", "GlyphType", "ScaleMode", "SelectOrientationVectors" };

// Those that ray-traced glyphs have another default of.
const std::set<std::string> defaultedAnew = { "GlyphShape", "GlyphType", "Orient", "ScaleFactor", "ScaleMode",
  "Scaling", "SelectScaleArray", "SelectOrientationVectors" };

bool Shows(vtkSMProxy* display, const char* representation)
{
  vtkSMProperty* type = display->GetProperty("Representation");
  return type && strcmp(vtkSMPropertyHelper(type).GetAsString(), representation) == 0;
}

std::string Percent(double fraction)
{
  return std::to_string(std::max(1, static_cast<int>(std::lround(100.0 * fraction)))) + " %";
}

bool IsNone(vtkSMProxy* display, const char* array)
{
  const char* value = vtkSMPropertyHelper(display, array).GetAsString();
  return !value || !value[0] || strcmp(value, "None") == 0;
}

vtkSMRayTracedArrayListDomain* ListOf(vtkSMProxy* glyphs, const char* property)
{
  return glyphs->GetProperty(property)->FindDomain<vtkSMRayTracedArrayListDomain>();
}

bool HasPeriodicBox(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  auto* field = source ? source->GetDataInformation(input.GetOutputPort())->GetFieldDataInformation() : nullptr;
  for (int i = 0; field && i < field->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = field->GetArrayInformation(i);
    if (rtglyphs::RayTracedPeriodic::AreEdges(
          array->GetName(), array->GetNumberOfComponents() * array->GetNumberOfTuples()))
    {
      return true;
    }
  }
  return false;
}

// Six numbers without names may have another order.
void ExplainOrder(vtkSMProxy* glyphs, bool tensors, std::vector<std::string>& sentences)
{
  const std::string name = vtkSMPropertyHelper(glyphs, "GlyphTensorArray").GetAsString();
  for (const auto& array : ListOf(glyphs, "GlyphTensorArray")->Listed())
  {
    if (tensors && array.Name == name && array.Components == 6 && !array.HasTensorNames)
    {
      sentences.push_back("Components of " + name +
        " by GlyphTensorLayout: " + vtkSMPropertyHelper(glyphs, "GlyphTensorLayout").GetAsString());
    }
  }
}

// Azimuths, from north or from x, are not taken for directions, nor is V_theta beside V_r.
void ExplainAngles(vtkSMProxy* glyphs, std::vector<std::string>& sentences)
{
  const auto arrays = ListOf(glyphs, "SelectScaleArray")->Listed();
  const auto isAround = [&arrays](const std::string& name)
  {
    const std::size_t coordinate = name.ends_with("theta") ? 5 : name.ends_with("phi") ? 3 : 0;
    return coordinate > 0 &&
      std::any_of(arrays.begin(), arrays.end(),
        [&](const auto& array) { return array.Name == name.substr(0, name.size() - coordinate) + 'r'; });
  };
  std::string angles;
  for (const auto& array : arrays)
  {
    const bool found = rtglyphs::GlyphArrayRoles::IsAngle(array) || isAround(array.Name);
    angles += found ? (angles.empty() ? "" : ", ") + array.Name : "";
  }
  if (!angles.empty())
  {
    sentences.push_back(
      "Angles and components along circles are no directions: a Calculator makes vectors of " + angles);
  }
}

// What the number of components alone says nothing sure of is not shown at once.
void ExplainShapes(vtkSMProxy* glyphs, std::vector<std::string>& sentences)
{
  const auto tensors = ListOf(glyphs, "GlyphTensorArray")->Choose();
  if (tensors && (!tensors.IsEvident || tensors.Components > 9) && tensors.Name.find(", ") == std::string::npos)
  {
    const bool either = ListOf(glyphs, "GlyphHarmonicsArray")->Choose().Name == tensors.Name;
    sentences.push_back("GlyphShape can show " + tensors.Name +
      (tensors.Components > 9 ? " as Fourth-Order Tensor" : " as tensors") + (either ? " or Spherical Harmonics" : ""));
  }
}

// What is to be known of periodic domains.
void ExplainPeriods(vtkSMProxy* display, std::vector<std::string>& sentences)
{
  const auto isSet = [display](const char* name)
  {
    const std::vector<double> values = vtkSMPropertyHelper(display, name).GetDoubleArray();
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
  };
  const bool periodic = isSet("PeriodicBoundary"), images = isSet("PeriodicImages");
  const bool occluded = vtkSMPropertyHelper(display, "ShadingMode").GetAsInt() == 1 && isSet("AmbientOcclusionRadius");
  if (images && !periodic)
  {
    sentences.emplace_back("PeriodicImages has no effect: switch PeriodicBoundary on");
  }
  if (periodic && !images && !occluded && !isSet("TrailSteps"))
  {
    sentences.emplace_back("PeriodicBoundary has no effect: choose a number of PeriodicImages");
  }
  else if (periodic && !isSet("PeriodicVectors") && !HasPeriodicBox(display))
  {
    sentences.emplace_back("Periodic box by the bounds of the points: the data have none; PeriodicVectors sets it");
  }
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
  const auto whereShape = [](const std::string& values, const std::string& more = "")
  {
    return "<PropertyWidgetDecorator type='GenericDecorator' mode='visibility' property='GlyphShape' values='" +
      values + "' " + more + "/>";
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
  const auto decorate = [display](std::initializer_list<const char*> names, const std::string& decorator)
  {
    const vtkSmartPointer<vtkPVXMLElement> element = vtkPVXMLParser::ParseXML(decorator.c_str());
    for (const char* name : names)
    {
      if (vtkSMProperty* property = display->GetProperty(name))
      {
        // Those of ParaView are its definition's, which all displays share.
        vtkNew<vtkPVXMLElement> both;
        both->SetName("Hints");
        vtkPVXMLElement* own = property->GetHints();
        for (unsigned int i = 0; own && i < own->GetNumberOfNestedElements(); ++i)
        {
          both->AddNestedElement(own->GetNestedElement(i), /*setParent=*/0);
        }
        both->AddNestedElement(element, /*setParent=*/0);
        property->SetHints(both);
      }
    }
  };
  // What ParaView has for points, lines, textures and back faces has no effect on what is ray traced.
  decorate({ "PointSize", "LineWidth", "RenderLinesAsTubes", "RenderPointsAsSpheres", "SelectTCoordArray",
             "SelectNormalArray", "SelectTangentArray", "Texture", "RepeatTextures", "InterpolateTextures", "SeamlessU",
             "SeamlessV", "UseMipmapTextures", "ShowTexturesOnBackface", "NormalTexture", "CoatNormalTexture",
             "FlipTextures", "EdgeColor", "BackfaceRepresentation", "BackfaceAmbientColor", "BackfaceDiffuseColor",
             "BackfaceOpacity", "Triangulate", "UseShaderReplacements", "CoordinateShiftScaleMethod" },
    "<PropertyWidgetDecorator type='CompositeDecorator'><Expression type='and'>" +
      where("Representation", "Ray Traced Glyphs", "inverse='1'") +
      where("Representation", "Ray Traced Surface", "inverse='1'") +
      where("Representation", "Ray Traced Tubes", "inverse='1'") + "</Expression></PropertyWidgetDecorator>");
  // Split and uncertain vectors have the lengths and directions of SelectOrientationVectors.
  decorate({ "ScaleMode", "SelectScaleArray", "Orient", "OrientationMode" },
    "<PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
      where("Representation", "Ray Traced Glyphs", "inverse='1'") + whereShape("16 17 19", "inverse='1'") +
      "</Expression></PropertyWidgetDecorator>");
  // ParaView's Coloring says nothing true while tensors are colored by themselves.
  const std::string colored = "<Hints><PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
    where("Representation", "Ray Traced Glyphs", "inverse='1'") + where("GlyphTensorColoring", "0") +
    whereShape("0 5 10 11 16 17 19") + "</Expression></PropertyWidgetDecorator></Hints>";
  const vtkSmartPointer<vtkPVXMLElement> coloring = vtkPVXMLParser::ParseXML(colored.c_str());
  for (size_t i = 0; i < display->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = display->GetPropertyGroup(i);
    if (group->GetXMLLabel() && strcmp(group->GetXMLLabel(), "Coloring") == 0)
    {
      group->SetHints(coloring);
    }
    if (group->GetPanelWidget() && strcmp(group->GetPanelWidget(), "MoleculeParameters") == 0)
    {
      const std::string own = "<Hints>" + where("Representation", "Molecule") + "</Hints>";
      group->SetHints(vtkPVXMLParser::ParseXML(own.c_str()));
    }
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::Follow(vtkSMProxy* glyphs, const std::string& name)
{
  if (name == "GlyphLocation")
  {
    this->ChooseArrays(glyphs, Where::Lost); // of the lists that RayTracedDefault has brought up to date
  }
  // While the display is made ParaView changes them, and what another client sets comes with its ScaleFactorFromData.
  if (this->Choosing || !this->InView || rtglyphs::RayTracedSuggestion::IsTaking() ||
    glyphs->GetSession()->IsProcessingRemoteNotification())
  {
    return;
  }
  if (defaultedAnew.count(name) || this->Coloring.Follow(glyphs, name))
  {
    this->Chosen.insert(name);
  }
  if (decisive.count(name) && ShowsGlyphs(glyphs->GetTrueParentProxy()))
  {
    if (name == "GlyphShape")
    {
      this->ChooseScaleMode(glyphs);
    }
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
    glyphs->GetProperty("ScaleFactorFromData")->Modified(); // so that the value is computed again
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::Choose(vtkSMProxy* glyphs)
{
  if (!this->InView)
  {
    this->Coloring.Enter(glyphs);
  }
  this->InView = true;
  vtkSMProxy* display = glyphs->GetTrueParentProxy();
  vtkSMSessionProxyManager* proxies = glyphs->GetSessionProxyManager();
  if (!this->TubesShown && Shows(display, "Ray Traced Tubes"))
  {
    this->TubesShown = true;
    this->TubesWanted = !(proxies && proxies->GetInLoadXMLState());
  }
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
    this->Chosen.insert("ColorArrayName");
    return;
  }
  glyphs->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
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
    this->ChooseShape(glyphs);
    this->ChooseScaleMode(glyphs);
  }
  if (!this->Chosen.count("ScaleFactor"))
  {
    vtkSMPropertyHelper(glyphs, "ScaleFactorFromData").Set(1);
  }
  const auto chosen = [this](const char* name) { return this->Chosen.count(name) > 0; };
  if (!chosen("ColorArrayName") && !chosen("GlyphTensorColoring") && !chosen("GlyphDirectionColoring"))
  {
    this->Coloring.Begin(glyphs);
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
      (where != Where::Missing && (!list->IsInDomain(before.c_str(), index) || list->HasBetterThan(before.c_str()))))
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
vtkSMProxy* rtglyphs::RayTracedGlyphDefaults::GlyphsOf(vtkSMProxy* display)
{
  return Display::Representation(display, "RayTracedRepresentation");
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedGlyphDefaults::ShowsGlyphs(vtkSMProxy* display)
{
  return Shows(display, "Ray Traced Glyphs");
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedGlyphDefaults::ChooseTubes(vtkSMProxy* display)
{
  if (!Shows(display, "Ray Traced Tubes") || !std::exchange(this->TubesWanted, false) ||
    !rtglyphs::RayTracedDefault::IsInWindow(display))
  {
    return;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
  this->Choosing = true;
  const char* color = vtkSMPropertyHelper(display, "ColorArrayName").GetAsString(4);
  if (!(color && color[0]))
  {
    vtkSMPropertyHelper(display, "GlyphDirectionColoring").Set(rtglyphs::DirectionColors::AXES);
  }
  auto* list = display->GetProperty("TubeRadiusArray")->FindDomain<vtkSMStringListDomain>();
  std::vector<std::string> radii;
  for (unsigned int i = 0; i < list->GetNumberOfStrings(); ++i)
  {
    if (rtglyphs::GlyphArrayRoles::DiametersOf(list->GetString(i)) > 0.0)
    {
      radii.emplace_back(list->GetString(i));
    }
  }
  if (radii.size() == 1 && IsNone(display, "TubeRadiusArray"))
  {
    vtkSMPropertyHelper(display, "TubeRadiusArray").Set(radii.front().c_str());
  }
  this->Choosing = false;
  display->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
std::vector<std::string> rtglyphs::RayTracedGlyphDefaults::Explain(vtkSMProxy* display) const
{
  std::vector<std::string> sentences;
  ExplainPeriods(display, sentences);
  vtkSMProxy* glyphs = ShowsGlyphs(display) ? GlyphsOf(display) : nullptr;
  if (!glyphs)
  {
    return sentences;
  }
  const vtkSMPropertyHelper summary(glyphs, "DataSummary");
  const auto number = [glyphs](const char* name) { return vtkSMPropertyHelper(glyphs, name).GetAsDouble(); };
  const auto explain = [&](const char* what, const char* name)
  {
    auto* domain = ListOf(glyphs, name);
    if (IsNone(glyphs, name) || !domain)
    {
      return;
    }
    const std::string array = vtkSMPropertyHelper(glyphs, name).GetAsString();
    const auto choice = domain->Choose();
    sentences.push_back(what + (" by " + array) + (choice.Name == array ? ": " + choice.Why : ""));
  };
  using Shapes = rtglyphs::GlyphShapes;
  const int shape = static_cast<int>(number("GlyphShape"));
  const bool tensors = Shapes::IsColored(shape) && shape != Shapes::SPHERICAL_HARMONICS;
  const bool formed = tensors || Shapes::IsUncertain(shape);
  if (formed || shape == Shapes::SPHERICAL_HARMONICS)
  {
    explain("Shape", formed ? "GlyphTensorArray" : "GlyphHarmonicsArray");
    ExplainOrder(glyphs, formed, sentences);
  }
  else if (IsNone(glyphs, "SelectOrientationVectors"))
  {
    ExplainAngles(glyphs, sentences);
    ExplainShapes(glyphs, sentences);
  }
  if (number("Scaling") != 0.0 && number("ScaleMode") != 0.0)
  {
    explain("Size", "SelectScaleArray");
    if (IsNone(glyphs, "SelectScaleArray"))
    {
      sentences.emplace_back("ScaleMode has no effect: choose a SelectScaleArray");
    }
  }
  const double limited = summary.GetAsDouble(rtglyphs::DataSummary::LIMITED_FRACTION);
  if (number("ScaleFactorFromData") != 0.0 && limited > 0.0)
  {
    sentences.push_back(
      "About " + Percent(limited) + " of the glyphs are drawn smaller than in proportion, all of one size");
  }
  if (shape == 0 && number("UseGlyphTable") != 0.0 && IsNone(glyphs, "GlyphTableIndexArray"))
  {
    sentences.emplace_back("UseGlyphTable has no effect: choose a GlyphTableIndexArray");
  }
  if (tensors && vtkSMPropertyHelper(glyphs, "GlyphTensorColoring").GetAsInt() == rtglyphs::GlyphTensors::RADIUS &&
    !Shapes::IsPolynomial(shape))
  {
    sentences.emplace_back("GlyphTensorColoring Radius has no effect: it is for glyphs of direction");
  }
  vtkSMProxy* type = vtkSMPropertyHelper(glyphs, "GlyphType").GetAsProxy();
  const bool ball = shape == 0 && type && strcmp(type->GetXMLName(), "SphereSource") == 0 &&
    static_cast<int>(number("ScaleMode")) != vtkGlyph3DMapper::SCALE_BY_COMPONENTS;
  if (number("Orient") != 0.0 && !tensors && !ball)
  {
    explain("Direction", "SelectOrientationVectors");
  }
  if (number("MotionBlur") != 0.0)
  {
    explain("Motion", "VelocityArray");
  }
  const char* array = vtkSMPropertyHelper(display, "ColorArrayName").GetAsString(4);
  const vtkSMPropertyHelper coloring(glyphs, "GlyphTensorColoring");
  const bool own = coloring.GetAsInt() != 0 && Shapes::IsColored(shape);
  const bool directions = number("GlyphDirectionColoring") != 0.0;
  const char* color = own ? coloring.GetAsString() : directions ? "direction" : array;
  if (color && color[0]) // null: a number that is none of the enumeration's
  {
    const bool ofParaView = !own && !directions && !this->Chosen.count("ColorArrayName");
    const std::string why = number("ColorFromData") != 0.0 ? ": what the glyphs show"
      : ofParaView                                         ? ": the array that ParaView chose"
                                                           : "";
    sentences.push_back(std::string("Color by ") + color + why);
  }
  const double negative = summary.GetAsDouble(rtglyphs::DataSummary::NEGATIVE_TENSORS);
  if (tensors && negative > 0.0)
  {
    const int coloring = vtkSMPropertyHelper(glyphs, "GlyphTensorColoring").GetAsInt();
    const bool anisotropy = coloring == rtglyphs::GlyphTensors::FRACTIONAL_ANISOTROPY;
    const bool positive = shape == Shapes::TENSOR_ELLIPSOID || shape == Shapes::TENSOR_SUPERQUADRIC;
    std::string sentence = Percent(negative) + " of the tensors have a negative eigenvalue";
    sentence += positive ? ", drawn as a positive one" : "";
    sentence += anisotropy ? "; their fractional anisotropy may pass 1" : "";
    if (positive || anisotropy)
    {
      sentences.push_back(sentence);
    }
  }
  return sentences;
}

//----------------------------------------------------------------------------
// In the window data that have neither directions nor sizes show their tensors, else their spherical harmonics.
void rtglyphs::RayTracedGlyphDefaults::ChooseShape(vtkSMProxy* glyphs)
{
  using Shapes = rtglyphs::GlyphShapes;
  auto* scales = ListOf(glyphs, "SelectScaleArray");
  const auto tensors = ListOf(glyphs, "GlyphTensorArray")->Choose();
  const auto shown = tensors ? tensors : ListOf(glyphs, "GlyphHarmonicsArray")->Choose();
  const int shape = !shown.IsEvident || tensors.Components > 9 ? Shapes::GLYPH_TYPE
    : !tensors                                                 ? Shapes::SPHERICAL_HARMONICS
    : tensors.IsNegative                                       ? Shapes::SIGNED_TENSOR_SUPERQUADRIC
                                                               : Shapes::TENSOR_ELLIPSOID;
  if (shape != Shapes::GLYPH_TYPE && !this->Chosen.count("GlyphShape") &&
    rtglyphs::RayTracedDefault::IsInWindow(glyphs->GetTrueParentProxy()) &&
    vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() == Shapes::GLYPH_TYPE &&
    !rtglyphs::GlyphArrayRoles::IsSize(scales->ChooseFor(rtglyphs::GlyphArrayRoles::SIZE, scales->Listed()).Name))
  {
    vtkSMProxy* display = glyphs->GetTrueParentProxy();
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    vtkSMPropertyHelper(display, "GlyphShape").Set(shape);
    this->ChooseArrays(glyphs, Where::Everywhere);
    display->UpdateVTKObjects();
  }
}

//----------------------------------------------------------------------------
// In the window bodies, and default spheres, take their sizes from the data.
void rtglyphs::RayTracedGlyphDefaults::ChooseScaleMode(vtkSMProxy* glyphs)
{
  auto* list = ListOf(glyphs, "SelectScaleArray");
  if (this->Chosen.count("ScaleMode") || !list || !rtglyphs::RayTracedDefault::IsInWindow(glyphs->GetTrueParentProxy()))
  {
    return;
  }
  const auto size = list->Choose();
  const bool turned = vtkSMRayTracedArrayListDomain::IsBody(glyphs);
  const bool sphere = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt() == 0 && !this->Chosen.count("GlyphType") &&
    IsNone(glyphs, "SelectOrientationVectors");
  const bool sized = (turned || sphere) && rtglyphs::GlyphArrayRoles::IsSize(size.Name);
  const int mode = !sized  ? vtkGlyph3DMapper::NO_DATA_SCALING
    : size.Components == 1 ? vtkGlyph3DMapper::SCALE_BY_MAGNITUDE
                           : vtkGlyph3DMapper::SCALE_BY_COMPONENTS;
  vtkSMProperty* shared = glyphs->GetTrueParentProxy()->GetProperty("ScaleMode");
  const bool choosing = this->Choosing;
  this->Choosing = true;
  vtkSMPropertyHelper(shared).Set(mode);
  glyphs->GetProperty("ScaleMode")->Copy(shared);
  this->Choosing = choosing;
  this->ChooseArrays(glyphs, Where::Everywhere);
}
