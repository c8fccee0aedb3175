#include "pqRayTracedGlyphsRefinement.h"

#include "pqActiveObjects.h"
#include "pqAnimationScene.h"
#include "RayTracedChoices.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqProgressManager.h"
#include "pqProgressWidget.h"
#include "pqRenderView.h"
#include "pqRayTracedGlyphsWords.h"
#include "pqRepresentation.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkRenderWindow.h"
#include "vtkSMComparativeViewProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMViewProxy.h"

#include <QApplication>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QStatusBar>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace
{
// Milliseconds between two renders, enough for the window to process its events.
constexpr int pauseBetween = 5;
// Milliseconds without a render after which a view that was turned rests.
constexpr int quietTime = 300;

QPointer<pqRayTracedGlyphsRefinement> onlyOne;
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::pqRayTracedGlyphsRefinement(QObject* parent)
  : QObject(parent)
{
  this->Timer.setSingleShot(true);
  this->Timer.setInterval(pauseBetween);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqRayTracedGlyphsRefinement::step);
  this->AtRest.setSingleShot(true);
  this->AtRest.setInterval(quietTime);
  QObject::connect(&this->AtRest, &QTimer::timeout, this, &pqRayTracedGlyphsRefinement::rested);
  QObject::connect(&this->Abort, &pqRayTracedGlyphsAbort::pressed, this, [this]() { this->stop(nullptr); });
  const auto notify = [this]() { Q_EMIT this->progressed(pqActiveObjects::instance().activeView()); };
  QObject::connect(&this->Abort, &pqRayTracedGlyphsAbort::listening, this, notify);
  QObject::connect(&this->Abort, &pqRayTracedGlyphsAbort::rested, this,
    [this, notify]()
    {
      if (pqProgressWidget* bar = this->Showing ? nullptr : this->Abort.progressBar())
      {
        bar->enableAbort(false);
      }
      notify();
    });
  onlyOne = this;
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::~pqRayTracedGlyphsRefinement() = default;

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement* pqRayTracedGlyphsRefinement::instance()
{
  return onlyOne;
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &pqRayTracedGlyphsRefinement::viewAdded);
  QObject::connect(
    model, &pqServerManagerModel::representationAdded, this, &pqRayTracedGlyphsRefinement::representationAdded);
  QObject::connect(model, &pqServerManagerModel::proxyAdded, this, &pqRayTracedGlyphsRefinement::proxyAdded);
  // The plugin may be loaded late.
  for (pqView* view : model->findItems<pqView*>())
  {
    this->viewAdded(view);
  }
  for (pqRepresentation* representation : model->findItems<pqRepresentation*>())
  {
    this->representationAdded(representation);
  }
  for (pqAnimationScene* scene : model->findItems<pqAnimationScene*>())
  {
    this->proxyAdded(scene);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::shutdown()
{
  this->Timer.stop();
  this->AtRest.stop();
  this->Abort.shutdown();
  this->Waiting.clear();
  this->Turned.clear();
  this->ShowProgress();
  if (pqApplicationCore* core = pqApplicationCore::instance())
  {
    pqServerManagerModel* model = core->getServerManagerModel();
    QObject::disconnect(model, nullptr, this, nullptr);
    for (pqProxy* proxy : model->findItems<pqProxy*>())
    {
      QObject::disconnect(proxy, nullptr, this, nullptr);
    }
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::viewAdded(pqView* view)
{
  if (qobject_cast<pqRenderView*>(view))
  {
    QObject::connect(view, &pqView::beginRender, this, [this]() { this->Abort.renderStarted(); });
    QObject::connect(view, &pqView::endRender, this,
      [this, view]()
      {
        for (const Part& part : PartsOf(view))
        {
          this->CheckProgress(part);
        }
      });
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::representationAdded(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  if (proxy && proxy->GetProperty("SamplesPerRender"))
  {
    vtkSMPropertyHelper(proxy, "SamplesPerRender").Set(-1);
    proxy->UpdateProperty("SamplesPerRender");
    this->Factors->Connect(
      proxy->GetProperty("ScaleFactor"), vtkCommand::ModifiedEvent, this, SLOT(showChoice(vtkObject*)));
  }
}

//----------------------------------------------------------------------------
// Over time the data may choose another number, which changes the picture.
void pqRayTracedGlyphsRefinement::showChoice(vtkObject* number)
{
  auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  if (window && rtglyphs::RayTracedChoices::IsChoosing())
  {
    auto* property = static_cast<vtkSMProperty*>(number);
    window->statusBar()->showMessage(tr("%1 is now %2, chosen from the data")
                                       .arg(property->GetXMLLabel())
                                       .arg(vtkSMPropertyHelper(property).GetAsDouble(), 0, 'g', 3),
      10000);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::proxyAdded(pqProxy* proxy)
{
  if (auto* scene = qobject_cast<pqAnimationScene*>(proxy))
  {
    using Played = void (pqAnimationScene::*)(vtkObject*, unsigned long, void*, void*);
    // Each step of an animation shows what there is time for; the last one is finished.
    QObject::connect(
      scene, static_cast<Played>(&pqAnimationScene::beginPlay), this, [this]() { this->Playing = true; });
    QObject::connect(scene, static_cast<Played>(&pqAnimationScene::endPlay), this,
      [this]()
      {
        this->Playing = false;
        this->Timer.start();
      });
  }
}

//****************************************************************************
// Views
//****************************************************************************

//----------------------------------------------------------------------------
std::vector<pqRayTracedGlyphsRefinement::Part> pqRayTracedGlyphsRefinement::PartsOf(pqView* view)
{
  std::vector<Part> parts;
  if (auto* comparative = vtkSMComparativeViewProxy::SafeDownCast(view->getProxy()))
  {
    vtkNew<vtkCollection> views;
    comparative->GetViews(views);
    for (int i = 0; i < views->GetNumberOfItems(); ++i)
    {
      parts.push_back({ view, vtkSMViewProxy::SafeDownCast(views->GetItemAsObject(i)) });
    }
  }
  else
  {
    parts.push_back({ view, view->getViewProxy() });
  }
  return parts;
}

//----------------------------------------------------------------------------
// Null: nothing ray traced is shown.
vtkSMRayTracedViewProxy* pqRayTracedGlyphsRefinement::SceneOf(const Part& part)
{
  vtkSMRayTracedViewProxy* scene = part.Proxy ? vtkSMRayTracedViewProxy::Of(part.Proxy) : nullptr;
  return scene && scene->GetShownDisplay() ? scene : nullptr;
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsRefinement::Image pqRayTracedGlyphsRefinement::imageOf(pqView* view) const
{
  Image image;
  for (const Part& part : PartsOf(view))
  {
    vtkSMRayTracedViewProxy* scene = SceneOf(part);
    if (!scene)
    {
      continue;
    }
    const bool refined = std::any_of(
      this->Waiting.begin(), this->Waiting.end(), [&part](const Part& waiting) { return waiting.Proxy == part.Proxy; });
    image.Refined |= refined || this->Abort.isListening();
    // That of an image that was stopped is whole.
    const double samples = scene->GetSamples(), wanted = vtkSMPropertyHelper(scene, "SamplesPerPixel").GetAsInt();
    const double progress = refined ? scene->GetProgress() : std::min(1.0, samples / wanted);
    if (!image.Display || progress < image.Progress)
    {
      image.Progress = progress;
      image.Words = pqRayTracedGlyphsWords::Of(scene, refined);
      image.Scene = scene;
    }
    image.Display = image.Display ? image.Display : scene->GetShownDisplay();
  }
  return image;
}

//****************************************************************************
// Refinement
//****************************************************************************

//----------------------------------------------------------------------------
// How far an image is, after a render.
void pqRayTracedGlyphsRefinement::CheckProgress(Part part)
{
  vtkRenderWindow* window = part.Proxy ? part.Proxy->GetRenderWindow() : nullptr;
  // A picture that is captured says nothing of the image in the window.
  if (!window || !window->GetSwapBuffers())
  {
    return;
  }
  this->Abort.renderEnded();
  vtkSMRayTracedViewProxy* scene = SceneOf(part);
  if (scene)
  {
    this->Abort.watch(window);
  }
  const auto isSame = [&part](const Part& other) { return other.Proxy == part.Proxy; };
  std::erase_if(this->Waiting, isSame);
  // While the camera is turned ParaView renders for speed, and once more when it comes to rest. But where the style of
  // the interactor is exchanged meanwhile, as after a zoom to a box beside a selection, there is no such render.
  std::erase_if(this->Turned, isSame);
  if (scene && scene->IsInteractive())
  {
    this->Turned.push_back(part);
    this->AtRest.start();
  }
  else
  {
    if (scene && scene->GetProgress() < 1.0)
    {
      this->Waiting.push_back(part);
    }
    Q_EMIT this->progressed(part.View);
  }
  this->ShowProgress();
  if (!this->Waiting.empty())
  {
    this->Timer.start();
  }
}

//----------------------------------------------------------------------------
// One image at a time, so that between any two of them the window can take its events.
void pqRayTracedGlyphsRefinement::step()
{
  std::erase_if(this->Waiting, [](const Part& part) { return !part.View || !SceneOf(part); });
  if (!this->Waiting.empty() && !this->Playing)
  {
    const Part part = this->Waiting.front();
    if (part.Proxy->GetSession()->GetPendingProgress() || part.View->getServer()->isProcessingPending())
    {
      this->Timer.start();
      return;
    }
    this->Render(part);
  }
  this->ShowProgress();
}

//----------------------------------------------------------------------------
// No view was turned of late.
void pqRayTracedGlyphsRefinement::rested()
{
  if (QApplication::mouseButtons() != Qt::NoButton)
  {
    this->AtRest.start();
    return;
  }
  for (const Part& part : std::exchange(this->Turned, {}))
  {
    if (part.View && SceneOf(part))
    {
      part.View->render();
    }
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::Render(const Part& part)
{
  // The progress bar goes on to show how far the image is, and not the beginning and end of each step.
  const QSignalBlocker quiet(pqApplicationCore::instance()->getProgressManager());
  if (part.Proxy == part.View->getViewProxy())
  {
    part.View->forceRender();
    return;
  }
  this->Abort.renderStarted();
  part.Proxy->StillRender();
  this->CheckProgress(part);
}

//****************************************************************************
// Progress and its end
//****************************************************************************

//----------------------------------------------------------------------------
// The event goes to the widget itself: while pqProgressManager has progress to show it lets no input through.
void pqRayTracedGlyphsRefinement::ShowProgress()
{
  pqProgressWidget* bar = this->Abort.progressBar();
  const bool shows = !this->Waiting.empty(), showed = std::exchange(this->Showing, shows);
  if (shows && !showed)
  {
    qApp->installEventFilter(this);
  }
  else if (showed && !shows)
  {
    qApp->removeEventFilter(this);
  }
  if (!bar || !(shows || showed))
  {
    return;
  }
  vtkSMRayTracedViewProxy* least = nullptr;
  for (const Part& part : this->Waiting)
  {
    vtkSMRayTracedViewProxy* scene = SceneOf(part);
    least = scene && (!least || scene->GetProgress() < least->GetProgress()) ? scene : least;
  }
  bar->enableProgress(shows);
  if (least)
  {
    bar->setProgress(pqRayTracedGlyphsWords::Of(least, true), static_cast<int>(100.0 * least->GetProgress()));
  }
  bar->enableAbort(shows);
}

//----------------------------------------------------------------------------
// Null: all views.
void pqRayTracedGlyphsRefinement::stop(const pqView* view)
{
  if (this->Abort.abort())
  {
    return;
  }
  std::vector<Part> stopped, others;
  for (const Part& part : this->Waiting)
  {
    (!view || part.View == view ? stopped : others).push_back(part);
  }
  this->Waiting = std::move(others);
  for (const Part& part : stopped)
  {
    vtkSMRayTracedViewProxy* scene = SceneOf(part);
    if (scene && part.View)
    {
      scene->InvokeCommand("StopRefinement");
      part.View->render(); // as a finished picture is: smoothed
    }
    Q_EMIT this->progressed(part.View);
  }
  this->ShowProgress();
}

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsRefinement::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::KeyPress && pqRayTracedGlyphsAbort::isEscape(event))
  {
    for (const Part& part : this->Waiting)
    {
      if (part.View && pqRayTracedGlyphsAbort::isWithin(object, part.View->widget()))
      {
        this->stop(part.View);
        break;
      }
    }
  }
  return QObject::eventFilter(object, event);
}
