#include "pqRayTracedGlyphsMenu.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <QMenu>
#include <QPointer>

namespace
{
void AddSurface(pqOutputPort* port, pqView* view)
{
  BEGIN_UNDO_SET(QObject::tr("Add Surface"));
  pqPipelineSource* surface = pqApplicationCore::instance()->getObjectBuilder()->createFilter(
    "filters", "DataSetSurfaceFilter", port->getSource(), port->getPortNumber());
  surface->updatePipeline();
  surface->setModifiedState(pqProxy::UNMODIFIED);
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  auto* display =
    vtkSMRepresentationProxy::SafeDownCast(controller->Show(surface->getSourceProxy(), 0, view->getViewProxy()));
  if (display)
  {
    display->SetRepresentationType("Ray Traced Surface");
  }
  END_UNDO_SET();
  view->render();
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsMenu::pqRayTracedGlyphsMenu(QObject* parent)
  : QObject(parent)
{
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsMenu::~pqRayTracedGlyphsMenu() = default;

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsMenu::contextMenu(
  QMenu* menu, pqView* view, const QPoint&, pqRepresentation* display, const QList<unsigned int>&) const
{
  auto* data = qobject_cast<pqDataRepresentation*>(display);
  vtkSMProperty* kind = data ? data->getProxy()->GetProperty("Representation") : nullptr;
  if (view && kind && QString(vtkSMPropertyHelper(kind).GetAsString()) == "Ray Traced Glyphs")
  {
    QAction* action = menu->addAction(tr("Add Surface"));
    action->setObjectName("AddSurface");
    const QPointer<pqOutputPort> port(data->getOutputPortFromInput());
    const QPointer<pqView> shown(view);
    QObject::connect(action, &QAction::triggered, view,
      [port, shown]()
      {
        if (port && shown)
        {
          AddSurface(port, shown);
        }
      });
  }
  return false;
}
