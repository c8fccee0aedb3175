#include "pqRayTracedGlyphsAbort.h"

#include "RayTracedOpenGLState.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqProgressManager.h"
#include "pqProgressWidget.h"
#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QProgressDialog>
#include <QToolBar>
#include <QToolButton>

namespace
{
// Milliseconds of a render after which its user is listened to.
constexpr int quietTime = 300;

// Events of the user, and renders.
bool MayInterfere(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Timer: // comes again
    case QEvent::Shortcut:
    case QEvent::DragEnter:
    case QEvent::Drop:
    case QEvent::Close:
      return true;
    case QEvent::Enter: // an event of input in Qt 6 only
      return false;
    default:
      return dynamic_cast<QInputEvent*>(event) != nullptr;
  }
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsAbort::pqRayTracedGlyphsAbort(QObject* parent)
  : QObject(parent)
{
  this->Rest.setSingleShot(true);
  QObject::connect(&this->Rest, &QTimer::timeout, this,
    [this]()
    {
      this->Aborted = false;
      Q_EMIT this->rested();
    });
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsAbort::~pqRayTracedGlyphsAbort() = default;

//----------------------------------------------------------------------------
void pqRayTracedGlyphsAbort::shutdown()
{
  this->Rest.stop();
  this->Observers->Disconnect();
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsAbort::watch(vtkRenderWindow* window)
{
  this->Observers->Disconnect(window); // it may be watched already
  this->Observers->Connect(window, vtkCommand::AbortCheckEvent, this, SLOT(abortChecked(vtkObject*)));
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsAbort::renderStarted()
{
  this->SinceStart.start();
}

//----------------------------------------------------------------------------
// Selecting and hovering render, too, without a StartEvent: the user cannot abort them.
void pqRayTracedGlyphsAbort::renderEnded()
{
  this->SinceStart.invalidate();
}

//----------------------------------------------------------------------------
pqProgressWidget* pqRayTracedGlyphsAbort::progressBar()
{
  QWidget* window = pqCoreUtilities::mainWidget();
  if (!this->Bar && window)
  {
    this->Bar = window->findChild<pqProgressWidget*>();
    if (this->Bar)
    {
      QObject::connect(this->Bar, &pqProgressWidget::abortPressed, this, &pqRayTracedGlyphsAbort::abortPressed);
    }
  }
  return this->Bar;
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsAbort::abortPressed()
{
  if (!this->abort())
  {
    Q_EMIT this->pressed();
  }
}

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsAbort::abort()
{
  this->Aborted |= this->Listening;
  return this->Listening;
}

//----------------------------------------------------------------------------
// Within a render that takes long. Those in the window do not: pictures that are captured have all their samples. VTK's
// mappers check, too, each before it draws.
void pqRayTracedGlyphsAbort::abortChecked(vtkObject* caller)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(caller);
  if (!window || window->GetSwapBuffers() || this->Listening)
  {
    return;
  }
  if (!this->Aborted && this->SinceStart.isValid() && this->SinceStart.elapsed() > quietTime)
  {
    // Widgets that paint make OpenGL contexts of their own current, and bind their framebuffers in the window's.
    rtglyphs::RayTracedOpenGLState::Save(window);
    this->Listen();
    rtglyphs::RayTracedOpenGLState::Restore(window);
    this->Rest.start();
  }
  if (this->Aborted)
  {
    window->SetAbortRender(1);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsAbort::Listen()
{
  this->Listening = true;
  if (pqProgressWidget* bar = this->progressBar())
  {
    bar->enableAbort(true);
  }
  if (QWidget* window = this->Stop ? nullptr : pqCoreUtilities::mainWidget())
  {
    const auto* toolBar = window->findChild<QToolBar*>("RayTracedGlyphs");
    this->Stop = toolBar ? toolBar->findChild<QToolButton*>("Stop") : nullptr;
  }
  Q_EMIT this->listening();
  qApp->installEventFilter(this);
  pqProgressManager* manager = pqApplicationCore::instance()->getProgressManager();
  const bool before = manager->unblockEvents(true);
  QApplication::processEvents();
  manager->unblockEvents(before);
  qApp->removeEventFilter(this);
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
}

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsAbort::isEscape(QEvent* event)
{
  return (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
    static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
}

//----------------------------------------------------------------------------
bool pqRayTracedGlyphsAbort::isWithin(const QObject* object, const QWidget* outer)
{
  const auto* widget = qobject_cast<const QWidget*>(object);
  return outer && widget && (widget == outer || outer->isAncestorOf(widget));
}

//----------------------------------------------------------------------------
// Within a render.
bool pqRayTracedGlyphsAbort::eventFilter(QObject* object, QEvent* event)
{
  if (isEscape(event))
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
  const bool wanted = object->isWindowType()
    ? mouse
    : isWithin(object, this->Bar ? this->Bar->abortButton() : nullptr) || isWithin(object, this->Stop) ||
      isWithin(object, qobject_cast<QProgressDialog*>(QApplication::activeModalWidget()));
  if (!wanted && event->type() == QEvent::Close)
  {
    event->ignore();
  }
  return !wanted;
}
