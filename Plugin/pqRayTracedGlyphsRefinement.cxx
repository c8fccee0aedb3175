#include "pqRayTracedGlyphsRefinement.h"

#include "pqAnimationScene.h"
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
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMComparativeViewProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMViewProxy.h"

#include <QApplication>
#include <QKeyEvent>
#include <QProgressDialog>
#include <QSignalBlocker>
#include <QToolButton>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace
{
// Between two renders, in milliseconds: enough for the window to take its events.
constexpr int pauseBetween = 5;
// Milliseconds of a render after which its user is listened to, and without one after which a view rests.
constexpr int quietTime = 300;

bool IsEscape(QEvent* event)
{
  return (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
    static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
}

// Events of the user, and renders.
bool MayInterfere(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Timer: // comes again
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::ShortcutOverride:
    case QEvent::Shortcut:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::NonClientAreaMouseButtonPress:
    case QEvent::Wheel:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::ContextMenu:
    case QEvent::DragEnter:
    case QEvent::Drop:
    case QEvent::Close:
      return true;
    default:
      return false;
  }
}

QPointer<pqRayTracedGlyphsRefinement> onlyOne;

bool IsWithin(QObject* object, const QWidget* widget)
{
  const auto* asWidget = qobject_cast<QWidget*>(object);
  return widget && asWidget && (asWidget == widget || widget->isAncestorOf(asWidget));
}
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
  this->Rest.setSingleShot(true);
  QObject::connect(&this->Rest, &QTimer::timeout, this, &pqRayTracedGlyphsRefinement::rest);
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
  this->Rest.stop();
  this->AtRest.stop();
  this->Waiting.clear();
  this->Turned.clear();
  this->Observers->Disconnect();
  this->Observed.clear();
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
    QObject::connect(view, &pqView::beginRender, this, &pqRayTracedGlyphsRefinement::renderStarted);
    QObject::connect(view, &pqView::endRender, this, &pqRayTracedGlyphsRefinement::rendered);
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
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::proxyAdded(pqProxy* proxy)
{
  if (auto* scene = qobject_cast<pqAnimationScene*>(proxy))
  {
    using Played = void (pqAnimationScene::*)(vtkObject*, unsigned long, void*, void*);
    QObject::connect(
      scene, static_cast<Played>(&pqAnimationScene::beginPlay), this, &pqRayTracedGlyphsRefinement::playStarted);
    QObject::connect(
      scene, static_cast<Played>(&pqAnimationScene::endPlay), this, &pqRayTracedGlyphsRefinement::playEnded);
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
    image.Refined |= refined;
    if (!image.Display || scene->GetProgress() < image.Progress)
    {
      image.Progress = scene->GetProgress();
      image.Words = pqRayTracedGlyphsWords::Of(scene, refined);
      image.Scene = scene;
    }
    image.Display = image.Display ? image.Display : scene->GetShownDisplay();
  }
  return image;
}

//----------------------------------------------------------------------------
// Parts of a comparative view come and go, and other views may have no window at first.
void pqRayTracedGlyphsRefinement::Attach(const Part& part)
{
  vtkRenderWindow* window = part.Proxy->GetRenderWindow();
  if (std::find(this->Observed.begin(), this->Observed.end(), window) != this->Observed.end())
  {
    return;
  }
  this->Observers->Connect(window, vtkCommand::AbortCheckEvent, this, SLOT(abortChecked(vtkObject*)));
  if (vtkObject* interactor = window->GetInteractor())
  {
    for (const auto pressed :
      { vtkCommand::LeftButtonPressEvent, vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent })
    {
      this->Observers->Connect(interactor, pressed, this, SLOT(mousePressed()), nullptr, 1.0f);
    }
    for (const auto released :
      { vtkCommand::LeftButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
    {
      this->Observers->Connect(interactor, released, this, SLOT(mouseReleased()), nullptr, 1.0f);
    }
  }
  this->Observed.erase(std::remove(this->Observed.begin(), this->Observed.end(), nullptr), this->Observed.end());
  this->Observed.emplace_back(window);
}

//****************************************************************************
// Refinement
//****************************************************************************

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::renderStarted()
{
  this->SinceStart.start();
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::rendered()
{
  auto* view = qobject_cast<pqView*>(this->sender());
  for (const Part& part : view ? PartsOf(view) : std::vector<Part>())
  {
    this->Look(part);
  }
}

//----------------------------------------------------------------------------
// How far an image is, after a render.
void pqRayTracedGlyphsRefinement::Look(Part part)
{
  vtkRenderWindow* window = part.Proxy ? part.Proxy->GetRenderWindow() : nullptr;
  // A picture that is captured says nothing of the image in the window.
  if (!window || !window->GetSwapBuffers())
  {
    return;
  }
  // Selecting and hovering render too, without a start event of the interactor.
  this->SinceStart.invalidate();
  vtkSMRayTracedViewProxy* scene = SceneOf(part);
  if (scene)
  {
    this->Attach(part);
  }
  const auto found = std::find_if(
    this->Waiting.begin(), this->Waiting.end(), [&part](const Part& other) { return other.Proxy == part.Proxy; });
  if (found != this->Waiting.end())
  {
    this->Waiting.erase(found);
  }
  // While the camera is turned ParaView renders for speed, and once more when it comes to rest. But where the style of
  // the interactor is exchanged meanwhile, as after a zoom to a box beside a selection, there is no such render.
  std::erase_if(this->Turned, [&part](const Part& other) { return other.Proxy == part.Proxy; });
  if (scene && scene->IsInteractive())
  {
    this->Turned.push_back(part);
    this->AtRest.start();
  }
  if (!scene || !scene->IsInteractive())
  {
    if (scene && scene->GetProgress() < 1.0)
    {
      this->Waiting.push_back(part);
    }
    Q_EMIT this->looked(part.View);
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
  this->Waiting.erase(std::remove_if(this->Waiting.begin(), this->Waiting.end(),
                        [](const Part& part) { return !part.View || !SceneOf(part); }),
    this->Waiting.end());
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
void pqRayTracedGlyphsRefinement::mousePressed()
{
  this->MouseDown = true;
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::mouseReleased()
{
  this->MouseDown = false;
}

//----------------------------------------------------------------------------
// No view was turned of late.
void pqRayTracedGlyphsRefinement::rested()
{
  if (this->MouseDown)
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
  this->renderStarted();
  part.Proxy->StillRender();
  this->Look(part);
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::playStarted()
{
  this->Playing = true;
}

//----------------------------------------------------------------------------
// Each step of the animation has shown what there was time for; the last one is finished.
void pqRayTracedGlyphsRefinement::playEnded()
{
  this->Playing = false;
  if (!this->Waiting.empty())
  {
    this->Timer.start();
  }
}

//****************************************************************************
// Progress and its end
//****************************************************************************

//----------------------------------------------------------------------------
pqProgressWidget* pqRayTracedGlyphsRefinement::ProgressBar()
{
  QWidget* window = pqCoreUtilities::mainWidget();
  if (!this->Bar && window)
  {
    this->Bar = window->findChild<pqProgressWidget*>();
    if (this->Bar)
    {
      QObject::connect(this->Bar, &pqProgressWidget::abortPressed, this, &pqRayTracedGlyphsRefinement::abortPressed);
    }
  }
  return this->Bar;
}

//----------------------------------------------------------------------------
// The event goes to the widget itself: while pqProgressManager has progress to show it lets no input through.
void pqRayTracedGlyphsRefinement::ShowProgress()
{
  pqProgressWidget* bar = this->ProgressBar();
  if (this->Waiting.empty() && this->Showing)
  {
    this->Showing = false;
    qApp->removeEventFilter(this);
    if (bar)
    {
      bar->enableAbort(false);
      bar->enableProgress(false);
    }
  }
  else if (!this->Waiting.empty())
  {
    if (!this->Showing)
    {
      qApp->installEventFilter(this);
    }
    this->Showing = true;
    if (bar)
    {
      vtkSMRayTracedViewProxy* least = nullptr;
      for (const Part& part : this->Waiting)
      {
        vtkSMRayTracedViewProxy* scene = SceneOf(part);
        least = scene && (!least || scene->GetProgress() < least->GetProgress()) ? scene : least;
      }
      bar->enableProgress(true);
      if (least)
      {
        bar->setProgress(pqRayTracedGlyphsWords::Of(least, true), static_cast<int>(100.0 * least->GetProgress()));
      }
      bar->enableAbort(true);
    }
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsRefinement::abortPressed()
{
  if (this->Listening)
  {
    this->Aborted = true;
  }
  else
  {
    this->stop(nullptr);
  }
}

//----------------------------------------------------------------------------
// Null: all views.
void pqRayTracedGlyphsRefinement::stop(const pqView* view)
{
  std::vector<Part> stopped, others;
  for (const Part& part : this->Waiting)
  {
    (!view || part.View == view ? stopped : others).push_back(part);
  }
  this->Waiting = std::move(others);
  for (const Part& part : stopped)
  {
    if (vtkSMRayTracedViewProxy* scene = SceneOf(part))
    {
      scene->InvokeCommand("StopRefinement");
    }
    Q_EMIT this->looked(part.View);
  }
  this->ShowProgress();
}

//----------------------------------------------------------------------------
// Within a render that takes long. Those in the window do not: pictures that are captured have all their samples. VTK's
// mappers check, too, each before it draws.
void pqRayTracedGlyphsRefinement::abortChecked(vtkObject* caller)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(caller);
  if (!window || window->GetSwapBuffers() || this->Listening)
  {
    return;
  }
  if (!this->Aborted && this->SinceStart.isValid() && this->SinceStart.elapsed() > quietTime)
  {
    this->Listening = true;
    pqProgressWidget* bar = this->ProgressBar();
    if (bar)
    {
      bar->enableAbort(true);
    }
    qApp->removeEventFilter(this);
    qApp->installEventFilter(this);
    pqProgressManager* manager = pqApplicationCore::instance()->getProgressManager();
    const bool before = manager->unblockEvents(true);
    // Widgets that paint make OpenGL contexts of their own current, and bind their framebuffers in the window's.
    window->GetState()->Push();
    QApplication::processEvents();
    window->MakeCurrent();
    window->GetState()->Pop();
    manager->unblockEvents(before);
    if (!this->Showing)
    {
      qApp->removeEventFilter(this);
    }
    this->Listening = false;
    // Tiles of one picture and frames of an animation that follow are not wanted either. At rest all is as before.
    auto* dialog = qobject_cast<QProgressDialog*>(QApplication::activeModalWidget());
    if (dialog && (this->Aborted || dialog->wasCanceled()))
    {
      this->Aborted = true;
      if (!dialog->wasCanceled())
      {
        Q_EMIT dialog->canceled();
      }
    }
    this->Rest.start();
  }
  if (this->Aborted)
  {
    window->SetAbortRender(1);
  }
}

//----------------------------------------------------------------------------
// No render is going on.
void pqRayTracedGlyphsRefinement::rest()
{
  this->Aborted = false;
  if (this->Bar && !this->Showing)
  {
    this->Bar->enableAbort(false);
  }
}

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsRefinement::eventFilter(QObject* object, QEvent* event)
{
  if (this->Listening)
  {
    if (IsEscape(event))
    {
      this->Aborted = true;
      event->accept();
      return true;
    }
    if (!MayInterfere(event))
    {
      return false;
    }
    // A window hands what the mouse does on to its widgets: that is where it is looked at.
    const bool mouse = dynamic_cast<QMouseEvent*>(event) != nullptr;
    const bool wanted = object->isWindowType() ? mouse
                                               : IsWithin(object, this->Bar ? this->Bar->abortButton() : nullptr) ||
        IsWithin(object, qobject_cast<QProgressDialog*>(QApplication::activeModalWidget()));
    if (!wanted && event->type() == QEvent::Close)
    {
      event->ignore();
    }
    return !wanted;
  }
  if (event->type() == QEvent::KeyPress && IsEscape(event))
  {
    for (const Part& part : this->Waiting)
    {
      if (part.View && IsWithin(object, part.View->widget()))
      {
        this->stop(part.View);
        break;
      }
    }
  }
  return QObject::eventFilter(object, event);
}
