#include "pqRayTracedGlyphsRefinement.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqRenderView.h"
#include "pqRepresentation.h"
#include "pqServerManagerModel.h"
#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"

#include <QMainWindow>
#include <QStatusBar>

#include <algorithm>

namespace
{
// Between two renders, in milliseconds: enough for the window to take its events.
constexpr int pauseBetween = 5;

QStatusBar* StatusBar()
{
  auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  return window ? window->statusBar() : nullptr;
}

// Null unless the representation is shown and ray traced.
vtkSMProxy* RayTraced(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation ? representation->getProxy() : nullptr;
  if (!proxy || !representation->isVisible() || !proxy->GetProperty("RefinementProgress") ||
    !proxy->GetProperty("Representation"))
  {
    return nullptr;
  }
  const QString type = vtkSMPropertyHelper(proxy, "Representation").GetAsString();
  return type == "Ray Traced Glyphs" || type == "Ray Traced Surface" ? proxy : nullptr;
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::pqRayTracedGlyphsRefinement(QObject* parent)
  : QObject(parent)
{
  this->Timer.setSingleShot(true);
  this->Timer.setInterval(pauseBetween);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqRayTracedGlyphsRefinement::step);
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::~pqRayTracedGlyphsRefinement() = default;

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::viewAdded, this, &pqRayTracedGlyphsRefinement::viewAdded);
  QObject::connect(model, &pqServerManagerModel::representationAdded, this,
    &pqRayTracedGlyphsRefinement::representationAdded);
  // The plugin may be loaded late.
  for (pqView* view : model->findItems<pqView*>())
  {
    this->viewAdded(view);
  }
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    this->representationAdded(representation);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::shutdown()
{
  this->Timer.stop();
  this->Waiting.clear();
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    QObject::disconnect(core->getServerManagerModel(), nullptr, this, nullptr);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::viewAdded(pqView* view)
{
  auto* renderView = qobject_cast<pqRenderView*>(view);
  if (!renderView)
  {
    return;
  }
  QObject::connect(view, &pqView::endRender, this, &pqRayTracedGlyphsRefinement::rendered);
  auto* proxy = vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  if (vtkRenderWindowInteractor* interactor = proxy ? proxy->GetInteractor() : nullptr)
  {
    interactor->AddObserver(vtkCommand::StartInteractionEvent, this,
      &pqRayTracedGlyphsRefinement::interactionStarted);
    interactor->AddObserver(
      vtkCommand::EndInteractionEvent, this, &pqRayTracedGlyphsRefinement::interactionEnded);
    QObject::connect(view, &QObject::destroyed, this,
      [this, interactor]() { this->Interacting.remove(interactor); });
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::representationAdded(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  if (proxy && proxy->GetProperty("StepwiseRendering"))
  {
    vtkSMPropertyHelper(proxy, "StepwiseRendering").Set(1);
    proxy->UpdateProperty("StepwiseRendering");
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::interactionStarted(vtkObject* interactor, unsigned long, void*)
{
  this->Interacting.insert(interactor);
}

//----------------------------------------------------------------------------
// ParaView renders at rest by itself now, and with that the image begins to be refined.
void pqRayTracedGlyphsRefinement::interactionEnded(vtkObject* interactor, unsigned long, void*)
{
  this->Interacting.remove(interactor);
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::Progress pqRayTracedGlyphsRefinement::ProgressOf(pqView* view)
{
  // One scene a view: what one of its displays says holds for all.
  for (pqRepresentation* representation : view->getRepresentations())
  {
    if (vtkSMProxy* proxy = RayTraced(representation))
    {
      vtkSMProperty* done = proxy->GetProperty("RefinementProgress");
      done->GetParent()->UpdatePropertyInformation(done);
      return { vtkSMPropertyHelper(done).GetAsDouble() };
    }
  }
  return {};
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::rendered()
{
  auto* view = qobject_cast<pqView*>(this->sender());
  auto* proxy = view ? vtkSMRenderViewProxy::SafeDownCast(view->getProxy()) : nullptr;
  if (!proxy || this->Interacting.contains(proxy->GetInteractor()))
  {
    return;
  }
  const Progress progress = ProgressOf(view);
  const auto found = std::find(this->Waiting.begin(), this->Waiting.end(), view);
  if (!progress.Finished() && found == this->Waiting.end())
  {
    this->Waiting.emplace_back(view);
  }
  else if (progress.Finished() && found != this->Waiting.end())
  {
    this->Waiting.erase(found);
  }

  QStatusBar* bar = StatusBar();
  if (bar && !progress.Finished())
  {
    bar->showMessage(tr("Ray tracing: %1 %").arg(static_cast<int>(100.0 * progress.Done)));
    this->Showing = true;
  }
  else if (bar && this->Showing && this->Waiting.empty())
  {
    bar->clearMessage();
    this->Showing = false;
  }
  if (!this->Waiting.empty())
  {
    this->Timer.start();
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::step()
{
  // Each view in turn; those that are finished leave when they have been rendered.
  std::vector<QPointer<pqView>> waiting;
  waiting.swap(this->Waiting);
  for (const QPointer<pqView>& view : waiting)
  {
    auto* proxy = view ? vtkSMRenderViewProxy::SafeDownCast(view->getProxy()) : nullptr;
    if (proxy && !this->Interacting.contains(proxy->GetInteractor()))
    {
      view->forceRender();
    }
  }
}
