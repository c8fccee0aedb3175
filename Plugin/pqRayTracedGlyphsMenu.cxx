#include "pqRayTracedGlyphsMenu.h"

#include "RayTracedChoices.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMUndoElement.h"
#include "vtkWeakPointer.h"

#include <QMenu>
#include <QPointer>
#include <QWidget>

#include <cmath>

namespace
{
// A lens of a twentieth of its distance in focus blurs what is far by a tenth of the view's height.
constexpr double opening = 0.05;

// How deep in a view lies what is seen at a place of its widget; 0: nothing ray-traced is there.
double DepthAt(pqView* view, const QPoint& place)
{
  auto* proxy = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  vtkSMRayTracedViewProxy* traced = proxy ? vtkSMRayTracedViewProxy::Of(proxy) : nullptr;
  const QWidget* widget = view->widget();
  const double scale = widget->devicePixelRatioF();
  const auto x = static_cast<int>(std::floor(scale * place.x()));
  const auto y = static_cast<int>(std::floor(scale * (widget->height() - 1 - place.y())));
  double seen[3];
  if (!traced || !traced->GetShownDisplay() || !traced->FindPlace(x, y, seen))
  {
    return 0.0;
  }
  vtkCamera* camera = proxy->GetActiveCamera();
  vtkMath::Subtract(seen, camera->GetPosition(), seen);
  return vtkMath::Dot(seen, camera->GetDirectionOfProjection());
}

// ParaView's own undo leaves cameras out.
class vtkLensChange : public vtkSMUndoElement
{
public:
  static vtkLensChange* New() { VTK_STANDARD_NEW_BODY(vtkLensChange); }
  vtkTypeMacro(vtkLensChange, vtkSMUndoElement);

  struct Lens
  {
    double Distance, Disk;
  };
  vtkWeakPointer<vtkSMProxy> View;
  Lens Before{}, After{};

  int Undo() override { return this->Put(this->Before); }
  int Redo() override { return this->Put(this->After); }

private:
  int Put(const Lens& lens)
  {
    if (this->View)
    {
      vtkSMPropertyHelper(this->View, "CameraFocalDistance").Set(lens.Distance);
      vtkSMPropertyHelper(this->View, "CameraFocalDisk").Set(lens.Disk);
      this->View->UpdateVTKObjects();
    }
    return 1;
  }
};

// 0: there is no lens. One that was not there gets an opening.
void FocusLens(pqView* view, double depth)
{
  vtkNew<vtkLensChange> change;
  change->View = view->getProxy();
  change->SetSession(view->getProxy()->GetSession());
  change->Before = { vtkSMPropertyHelper(change->View, "CameraFocalDistance").GetAsDouble(),
    vtkSMPropertyHelper(change->View, "CameraFocalDisk").GetAsDouble() };
  change->After = { depth, change->Before.Distance > 0.0 ? change->Before.Disk : opening * depth };
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", view->getProxy());
  BEGIN_UNDO_SET(depth > 0.0 ? QObject::tr("Focus Lens") : QObject::tr("Lens Off"));
  change->Redo();
  ADD_UNDO_ELEM(change);
  END_UNDO_SET();
  view->render();
}

void AddLens(QMenu* menu, pqView* view, const char* name, const QString& text, double depth)
{
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  QObject::connect(action, &QAction::triggered, view, [view, depth]() { FocusLens(view, depth); });
}

// Extract Surface takes data sets.
bool MayHaveSurface(pqOutputPort* port)
{
  const vtkPVDataInformation* data = port->getDataInformation();
  return data && data->GetNumberOfCells() > 0 && !data->DataSetTypeIsA(VTK_MOLECULE) &&
    !data->DataSetTypeIsA(VTK_HYPER_TREE_GRID);
}

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
bool pqRayTracedGlyphsMenu::contextMenu(
  QMenu* menu, pqView* view, const QPoint& place, pqRepresentation* display, const QList<unsigned int>&) const
{
  auto* data = qobject_cast<pqDataRepresentation*>(display);
  const QPointer<pqOutputPort> port(data ? data->getOutputPortFromInput() : nullptr);
  if (view && port && rtglyphs::RayTracedChoices::ShowsGlyphs(data->getProxy()) && MayHaveSurface(port))
  {
    QAction* action = menu->addAction(tr("Add Surface"));
    action->setObjectName("AddSurface");
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
  const double depth = view ? DepthAt(view, place) : 0.0;
  if (depth > 0.0)
  {
    AddLens(menu, view, "FocusLens", tr("Focus Lens Here"), depth);
    if (vtkSMPropertyHelper(view->getProxy(), "CameraFocalDistance").GetAsDouble() > 0.0)
    {
      AddLens(menu, view, "LensOff", tr("Lens Off"), 0.0);
    }
  }
  return false;
}
