#include "RayTracedExplanation.h"

#include "DataSummary.h"
#include "GlyphShapes.h"
#include "GlyphTensors.h"
#include "RayTracedChoices.h"
#include "RayTracedPeriodic.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMRayTracedRepresentationProxy.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{
using List = vtkSMRayTracedArrayListDomain;

std::string Percent(double fraction)
{
  return std::to_string(std::max(1, static_cast<int>(std::lround(100.0 * fraction)))) + " %";
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
  const auto array = List::Of(glyphs, "GlyphTensorArray")->Find(List::Named(glyphs, "GlyphTensorArray"));
  const char* layout = vtkSMPropertyHelper(glyphs, "GlyphTensorLayout").GetAsString();
  // null: a number that is none of the enumeration's
  if (tensors && array && array.Components == 6 && !array.HasTensorNames && layout)
  {
    sentences.push_back("Components of " + array.Name + " by GlyphTensorLayout: " + layout);
  }
}

// Azimuths, from north or from x, are not taken for directions, nor is V_theta beside V_r.
void ExplainAngles(vtkSMProxy* glyphs, std::vector<std::string>& sentences)
{
  const auto arrays = List::Of(glyphs, "SelectScaleArray")->Listed();
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
    sentences.push_back("Not used as directions: " + angles +
      " (angles or cylindrical components); the filter Calculator makes vectors of them");
  }
}

// What the number of components alone says nothing sure of is not shown at once.
void ExplainShapes(vtkSMProxy* glyphs, std::vector<std::string>& sentences)
{
  const auto tensors = List::Of(glyphs, "GlyphTensorArray")->Choose();
  if (tensors && (!tensors.IsEvident || tensors.Components > 9) && tensors.Name.find(", ") == std::string::npos)
  {
    const bool either = List::Of(glyphs, "GlyphHarmonicsArray")->Choose().Name == tensors.Name;
    sentences.push_back("GlyphShape can show " + tensors.Name +
      (tensors.Components > 9 ? " as Fourth-Order Tensor" : " as tensors") + (either ? " or Spherical Harmonics" : ""));
  }
}

// The shutter time that 0 means.
void ExplainShutter(vtkSMProxy* display, std::vector<std::string>& sentences)
{
  const auto number = [display](const char* name) { return vtkSMPropertyHelper(display, name).GetAsDouble(); };
  const double found = vtkSMPropertyHelper(rtglyphs::RayTracedChoices::GlyphsOf(display), "DataSummary")
                         .GetAsDouble(rtglyphs::DataSummary::SHUTTER_TIME);
  if (number("MotionBlur") != 0.0 && number("ShutterTime") == 0.0 && found > 0.0)
  {
    std::ostringstream text;
    text.precision(3);
    text << "ShutterTime " << found << ": chosen from the data";
    sentences.push_back(text.str());
  }
}

// What Surface has and Ray Traced Surface lacks.
void ExplainSurface(vtkSMProxy* display, std::vector<std::string>& sentences)
{
  constexpr int followFrontface = 400;
  if (!rtglyphs::RayTracedChoices::ShowsSurface(display))
  {
    return;
  }
  const vtkSMPropertyHelper back(display, "BackfaceRepresentation", /*quiet=*/true);
  if (back.GetNumberOfElements() > 0 && back.GetAsInt() != followFrontface)
  {
    sentences.emplace_back("BackfaceRepresentation has no effect: both sides of ray-traced surfaces look alike");
  }
  if (vtkSMPropertyHelper(display, "Texture", /*quiet=*/true).GetAsProxy())
  {
    sentences.emplace_back("Texture has no effect: ray-traced surfaces have none");
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
    sentences.emplace_back(
      "The periodic box is that of the points' bounds, as the data have none; PeriodicVectors sets another");
  }
}
}

//----------------------------------------------------------------------------
std::vector<std::string> rtglyphs::RayTracedExplanation::Explain(vtkSMProxy* display)
{
  std::vector<std::string> sentences;
  ExplainPeriods(display, sentences);
  ExplainShutter(display, sentences);
  ExplainSurface(display, sentences);
  auto* glyphs = rtglyphs::RayTracedChoices::ShowsGlyphs(display)
    ? vtkSMRayTracedRepresentationProxy::SafeDownCast(rtglyphs::RayTracedChoices::GlyphsOf(display))
    : nullptr;
  if (!glyphs)
  {
    return sentences;
  }
  const vtkSMPropertyHelper summary(glyphs, "DataSummary");
  const auto number = [glyphs](const char* name) { return vtkSMPropertyHelper(glyphs, name).GetAsDouble(); };
  const auto explain = [&](const char* what, const char* name)
  {
    if (const std::string array = List::Named(glyphs, name); !array.empty())
    {
      const auto choice = List::Of(glyphs, name)->Choose();
      sentences.push_back(what + (" by " + array) + (choice.Name == array ? ": " + choice.Why : ""));
    }
  };
  using Shapes = rtglyphs::GlyphShapes;
  const int shape = static_cast<int>(number("GlyphShape"));
  const bool tensors = Shapes::IsColored(shape) && shape != Shapes::SPHERICAL_HARMONICS;
  const bool formed = tensors || Shapes::IsUncertain(shape);
  const vtkSMPropertyHelper coloring(glyphs, "GlyphTensorColoring");
  if (formed || shape == Shapes::SPHERICAL_HARMONICS)
  {
    explain("Shape", formed ? "GlyphTensorArray" : "GlyphHarmonicsArray");
    ExplainOrder(glyphs, formed, sentences);
  }
  else if (List::Named(glyphs, "SelectOrientationVectors").empty())
  {
    ExplainAngles(glyphs, sentences);
    ExplainShapes(glyphs, sentences);
  }
  if (number("Scaling") != 0.0 && number("ScaleMode") != 0.0)
  {
    explain("Size", "SelectScaleArray");
    if (List::Named(glyphs, "SelectScaleArray").empty())
    {
      sentences.emplace_back("ScaleMode has no effect: choose a SelectScaleArray");
    }
  }
  const double limited = summary.GetAsDouble(rtglyphs::DataSummary::LIMITED_FRACTION);
  if (number("ScaleFactorFromData") != 0.0 && limited > 0.0)
  {
    sentences.push_back("About " + Percent(limited) + " of the glyphs would be too large and are drawn in one size");
  }
  if (shape == 0 && number("UseGlyphTable") != 0.0 && List::Named(glyphs, "GlyphTableIndexArray").empty())
  {
    sentences.emplace_back("UseGlyphTable has no effect: choose a GlyphTableIndexArray");
  }
  if (tensors && coloring.GetAsInt() == rtglyphs::GlyphTensors::RADIUS && !Shapes::IsPolynomial(shape))
  {
    sentences.emplace_back(
      "GlyphTensorColoring Radius has no effect: it is for Spherical Harmonics, Normal Stress and Fourth-Order Tensor");
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
  const bool own = coloring.GetAsInt() != 0 && Shapes::IsColored(shape);
  const bool directions = number("GlyphDirectionColoring") != 0.0;
  const char* color = own ? coloring.GetAsString() : directions ? "direction" : array;
  if (color && color[0]) // null: a number that is none of the enumeration's
  {
    const bool ofParaView = !own && !directions && !glyphs->GetChoices().IsUsers("ColorArrayName");
    const std::string why = number("ColorFromData") != 0.0 ? ": what the glyphs show"
      : ofParaView                                         ? ": the array that ParaView chose"
                                                           : "";
    sentences.push_back(std::string("Color by ") + color + why);
  }
  const double negative = summary.GetAsDouble(rtglyphs::DataSummary::NEGATIVE_TENSORS);
  if (tensors && negative > 0.0)
  {
    const bool anisotropy = coloring.GetAsInt() == rtglyphs::GlyphTensors::FRACTIONAL_ANISOTROPY;
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
