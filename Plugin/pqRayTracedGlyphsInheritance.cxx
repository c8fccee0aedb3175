#include "pqRayTracedGlyphsInheritance.h"

#include "RayTracedChoices.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqPropertiesPanel.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

#include <QApplication>
#include <QTimer>

namespace
{
// Filters by their names in XML that leave a part of their input; Cut is Slice.
bool IsPart(vtkSMProxy* filter)
{
  static const QStringList parts{ "Clip", "Cut", "Threshold", "ExtractSelection", "ExtractGrid", "ExtractBlock",
    "ExtractBlockUsingDataAssembly" };
  return parts.contains(filter->GetXMLName());
}

// Sources of glyphs are each display's own.
void CopyValue(vtkSMProperty* from, vtkSMProperty* to)
{
  auto* list = to->FindDomain<vtkSMProxyListDomain>();
  vtkSMProxy* value = list ? vtkSMPropertyHelper(from).GetAsProxy() : nullptr;
  vtkSMProxy* own = value ? list->FindProxy(value->GetXMLGroup(), value->GetXMLName()) : nullptr;
  if (own)
  {
    own->Copy(value);
    own->UpdateVTKObjects();
    vtkSMPropertyHelper(to).Set(own);
  }
  else
  {
    to->Copy(from);
  }
}

// Properties of the plugin's sections of the panel; those of the image are the view's.
void CopySettings(vtkSMProxy* from, vtkSMProxy* to)
{
  for (size_t i = 0; i < from->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = from->GetPropertyGroup(i);
    const QString label = group->GetXMLLabel();
    for (unsigned int j = 0; j < group->GetNumberOfProperties(); ++j)
    {
      vtkSMProperty* property = group->GetProperty(j);
      const char* name = from->GetPropertyName(property);
      const bool ours =
        label == "Glyph Parameters" || label == "Ray Traced Object" || label == "Motion" || label.startsWith("Cut");
      if (ours && !property->GetInformationOnly() && to->GetProperty(name))
      {
        CopyValue(property, to->GetProperty(name));
      }
    }
  }
  // Setting a number switches off that the data choose it.
  to->GetProperty("ScaleFactorFromData")->Copy(from->GetProperty("ScaleFactorFromData"));
}
}

//----------------------------------------------------------------------------
// ParaView makes displays while a panel says that it was applied.
void pqRayTracedGlyphsInheritance::startup()
{
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(), &pqServerManagerModel::representationAdded,
    this, &pqRayTracedGlyphsInheritance::added);
  for (QWidget* widget : QApplication::allWidgets())
  {
    if (auto* panel = qobject_cast<pqPropertiesPanel*>(widget))
    {
      QObject::connect(panel, QOverload<pqProxy*>::of(&pqPropertiesPanel::applied), this,
        [this](pqProxy* source) { this->Applied.append(source); });
      QObject::connect(panel, QOverload<>::of(&pqPropertiesPanel::applied), this,
        [this]() { QTimer::singleShot(0, this, &pqRayTracedGlyphsInheritance::inherit); });
    }
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsInheritance::added(pqRepresentation* display)
{
  this->Fresh.append(display);
  QTimer::singleShot(0, this,
    [this]()
    {
      if (this->Applied.isEmpty()) // as of a script or a state
      {
        this->Fresh.clear();
      }
    });
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsInheritance::inherit()
{
  for (const QPointer<pqRepresentation>& fresh : this->Fresh)
  {
    auto* display = qobject_cast<pqDataRepresentation*>(fresh.data());
    auto* filter = display ? qobject_cast<pqPipelineFilter*>(display->getInput()) : nullptr;
    const bool wanted = filter && this->Applied.contains(QPointer<pqProxy>(filter)) && IsPart(filter->getProxy());
    pqOutputPort* input = wanted ? filter->getAnyInput() : nullptr;
    pqView* view = wanted ? display->getView() : nullptr;
    pqDataRepresentation* shown = input && view ? input->getRepresentation(view) : nullptr;
    auto* part = display ? vtkSMRepresentationProxy::SafeDownCast(display->getProxy()) : nullptr;
    // Where a filter always replaces its input, ParaView has hidden that already.
    const bool replaced = shown && (shown->isVisible() || filter->replaceInput() == 1);
    if (!part || !replaced || !rtglyphs::RayTracedChoices::ShowsRayTraced(shown->getProxy()))
    {
      continue;
    }
    const pqScopedUndoSet undo(tr("Show the Part as Its Source"));
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", part);
    part->SetRepresentationType(vtkSMPropertyHelper(shown->getProxy(), "Representation").GetAsString());
    CopySettings(shown->getProxy(), part);
    part->UpdateVTKObjects();
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Hide(
      input->getSource()->getSourceProxy(), static_cast<int>(input->getPortNumber()), view->getViewProxy());
    view->render();
  }
  this->Fresh.clear();
  this->Applied.clear();
}
