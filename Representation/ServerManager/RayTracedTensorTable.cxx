#include "RayTracedTensorTable.h"

#include "DataSummary.h"
#include "GlyphShapes.h"
#include "GlyphTensors.h"
#include "RayTracedChoices.h"
#include "vtkNew.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

namespace
{
using Shapes = rtglyphs::GlyphShapes;

// Array and number that glyphs are colored by; empty: none.
std::string NumberOf(vtkSMProxy* glyphs)
{
  const vtkSMPropertyHelper coloring(glyphs, "GlyphTensorColoring");
  const int shape = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt();
  const bool number = Shapes::IsPolynomial(shape)
    ? coloring.GetAsInt() == rtglyphs::GlyphTensors::RADIUS
    : Shapes::IsColored(shape) && rtglyphs::GlyphTensors::IsNumber(coloring.GetAsInt());
  const std::string array = vtkSMRayTracedArrayListDomain::Named(
    glyphs, shape == Shapes::SPHERICAL_HARMONICS ? "GlyphHarmonicsArray" : "GlyphTensorArray");
  const bool directions = vtkSMPropertyHelper(glyphs, "GlyphDirectionColoring").GetAsInt() != 0;
  return number && !directions && !array.empty() ? array + " " + coloring.GetAsString() : std::string();
}

// Whether glyphs in the view are colored by it.
bool IsUsed(const std::string& number, vtkSMProxy* view)
{
  const vtkSMPropertyHelper displays(view, "Representations");
  for (unsigned int i = 0; i < displays.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* display = displays.GetAsProxy(i);
    if (rtglyphs::RayTracedChoices::ShowsGlyphs(display) && vtkSMPropertyHelper(display, "Visibility").GetAsInt() &&
      NumberOf(rtglyphs::RayTracedChoices::GlyphsOf(display)) == number)
    {
      return true;
    }
  }
  return false;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedTensorTable::Update(vtkSMProxy* glyphs, vtkSMProxy* view, bool shown, bool isUsers)
{
  const std::string name = shown ? NumberOf(glyphs) : "";
  vtkNew<vtkSMTransferFunctionManager> tables;
  vtkSMSessionProxyManager* proxies = glyphs->GetSessionProxyManager();
  const auto barOf = [&](const std::string& of)
  { return tables->GetScalarBarRepresentation(tables->GetColorTransferFunction(of.c_str(), proxies), view); };
  if (name != this->Name && !this->Name.empty() && !IsUsed(this->Name, view))
  {
    if (vtkSMProxy* bar = barOf(this->Name))
    {
      vtkSMPropertyHelper(bar, "Visibility").Set(0);
      bar->UpdateVTKObjects();
    }
  }
  const bool fresh = name != this->Name;
  this->Name = name;
  if (name.empty())
  {
    return;
  }
  vtkSMProxy* table = tables->GetColorTransferFunction(name.c_str(), proxies);
  const vtkSMPropertyHelper summary(glyphs, "DataSummary");
  const double found[2] = { summary.GetAsDouble(rtglyphs::DataSummary::LEAST_OF_TENSORS),
    summary.GetAsDouble(rtglyphs::DataSummary::LARGEST_OF_TENSORS) };
  vtkSMProxy* set = vtkSMPropertyHelper(glyphs, "GlyphTensorLookupTable").GetAsProxy();
  // The range stays where the user has locked it, and where the table came with one, as in a state.
  const bool locked =
    vtkSMPropertyHelper(table, "AutomaticRescaleRangeMode").GetAsInt() == vtkSMTransferFunctionManager::NEVER;
  const bool stays =
    vtkSMPropertyHelper(table, "ScalarRangeInitialized").GetAsInt() && (locked || (fresh && isUsers && set == table));
  if (found[0] <= found[1] && (fresh || found[0] != this->Range[0] || found[1] != this->Range[1]))
  {
    if (!stays)
    {
      vtkSMTransferFunctionProxy::RescaleTransferFunction(table, found[0], found[1]);
    }
    this->Range[0] = found[0];
    this->Range[1] = found[1];
  }
  if (set != table && !(set && isUsers))
  {
    const RayTracedChoices::Scope scope;
    vtkSMPropertyHelper(glyphs, "GlyphTensorLookupTable").Set(table);
    glyphs->UpdateVTKObjects();
  }
  // Of what the data have chosen ParaView's window shows bars, scripts do it themselves.
  const bool shows = vtkSMPropertyHelper(glyphs, "ColorFromData").GetAsInt() == 0 ||
    rtglyphs::RayTracedChoices::IsInWindow(glyphs->GetTrueParentProxy());
  if (vtkSMProxy* bar = fresh && shows ? barOf(name) : nullptr)
  {
    vtkSMPropertyHelper(bar, "Title").Set(name.c_str());
    vtkSMPropertyHelper(bar, "ComponentTitle").Set("");
    vtkSMPropertyHelper(bar, "Enabled").Set(1);
    vtkSMPropertyHelper(bar, "Visibility").Set(1);
    bar->UpdateVTKObjects();
  }
}
