#include "RayTracedPanel.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkPVXMLParser.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <initializer_list>
#include <string>

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPanel::Show(vtkSMProxy* display)
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
  const auto where = [](const std::string& property, const std::string& wanted)
  {
    return "<PropertyWidgetDecorator type='GenericDecorator' mode='visibility' property='" + property + "' " + wanted +
      "/>";
  };
  const auto whereRayTraced = [&where](const std::string& more = "")
  {
    return where("Representation", "value='Ray Traced Glyphs' " + more) +
      where("Representation", "value='Ray Traced Surface' " + more) +
      where("Representation", "value='Ray Traced Tubes' " + more);
  };
  const auto decorate = [display](
                          std::initializer_list<const char*> names, const std::string& decorator, bool keepsOwn = true)
  {
    const vtkSmartPointer<vtkPVXMLElement> element = vtkPVXMLParser::ParseXML(decorator.c_str());
    for (const char* name : names)
    {
      if (vtkSMProperty* property = display->GetProperty(name))
      {
        // Those of ParaView are its definition's, which all displays share.
        vtkNew<vtkPVXMLElement> both;
        both->SetName("Hints");
        vtkPVXMLElement* own = keepsOwn ? property->GetHints() : nullptr;
        for (unsigned int i = 0; own && i < own->GetNumberOfNestedElements(); ++i)
        {
          both->AddNestedElement(own->GetNestedElement(i), /*setParent=*/0);
        }
        both->AddNestedElement(element, /*setParent=*/0);
        property->SetHints(both);
      }
    }
  };
  // Path tracing takes the material of any Interpolation.
  decorate({ "Metallic", "Roughness", "CoatStrength", "CoatIOR", "CoatRoughness", "CoatColor" },
    "<PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" + where("Interpolation", "value='3'") +
      "<Expression type='and'>" + where("ShadingMode", "value='2'") + "<Expression type='or'>" + whereRayTraced() +
      "</Expression></Expression></Expression></PropertyWidgetDecorator>",
    false);
  // What ParaView has for points, lines, textures and back faces has no effect on what is ray traced.
  decorate({ "PointSize", "LineWidth", "RenderLinesAsTubes", "RenderPointsAsSpheres", "SelectTCoordArray",
             "SelectNormalArray", "SelectTangentArray", "Texture", "RepeatTextures", "InterpolateTextures", "SeamlessU",
             "SeamlessV", "UseMipmapTextures", "ShowTexturesOnBackface", "NormalTexture", "CoatNormalTexture",
             "FlipTextures", "EdgeColor", "BackfaceRepresentation", "BackfaceAmbientColor", "BackfaceDiffuseColor",
             "BackfaceOpacity", "Triangulate", "UseShaderReplacements", "CoordinateShiftScaleMethod" },
    "<PropertyWidgetDecorator type='CompositeDecorator'><Expression type='and'>" + whereRayTraced("inverse='1'") +
      "</Expression></PropertyWidgetDecorator>");
  // Split and uncertain vectors have the lengths and directions of SelectOrientationVectors.
  decorate({ "ScaleMode", "SelectScaleArray", "Orient", "OrientationMode" },
    "<PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
      where("Representation", "value='Ray Traced Glyphs' inverse='1'") +
      where("GlyphShape", "values='16 17 19' inverse='1'") + "</Expression></PropertyWidgetDecorator>");
  // ParaView's Coloring says nothing true while tensors are colored by themselves.
  const std::string colored = "<Hints><PropertyWidgetDecorator type='CompositeDecorator'><Expression type='or'>" +
    where("Representation", "value='Ray Traced Glyphs' inverse='1'") + where("GlyphTensorColoring", "value='0'") +
    where("GlyphShape", "values='0 5 10 11 16 17 19'") + "</Expression></PropertyWidgetDecorator></Hints>";
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
      const std::string own = "<Hints>" + where("Representation", "value='Molecule'") + "</Hints>";
      group->SetHints(vtkPVXMLParser::ParseXML(own.c_str()));
    }
  }
}
