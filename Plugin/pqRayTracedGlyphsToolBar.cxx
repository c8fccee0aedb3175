#include "pqRayTracedGlyphsToolBar.h"

#include "pqActiveObjects.h"
#include "pqCoreUtilities.h"
#include "pqRayTracedGlyphsReference.h"
#include "pqRayTracedGlyphsWords.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMTrace.h"

#include <QAction>
#include <QFontMetrics>
#include <QMainWindow>
#include <QProgressBar>
#include <QStatusBar>
#include <QStringList>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

namespace
{
pqRayTracedGlyphsRefinement::Image ImageOf(pqView* view)
{
  const auto* refinement = pqRayTracedGlyphsRefinement::instance();
  return view && refinement ? refinement->imageOf(view) : pqRayTracedGlyphsRefinement::Image();
}

constexpr double longTime = 60.0; // seconds

// Seconds that an image of that quality takes; negative: unknown.
double SecondsOf(const pqRayTracedGlyphsRefinement::Image& image, const QAction* quality)
{
  return image.Scene ? image.Scene->GetSecondsOfQuality(quality->data().toInt()) : -1.0;
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsToolBar::pqRayTracedGlyphsToolBar(QWidget* parent)
  : QToolBar(tr("Ray Traced Glyphs"), parent)
{
  this->setObjectName("RayTracedGlyphs");
  const QString view = tr(" Applies to all ray-traced displays of the active view.");
  this->Qualities = { this->AddButton("Fast", tr("Quick pictures: local shading, few samples per pixel.") + view),
    this->AddButton("Balanced", tr("Ambient occlusion with enough samples per pixel for daily work.") + view),
    this->AddButton("Publication",
      tr("Ambient occlusion, shadows, also on the ground, outlines and many samples per pixel, for final pictures.") +
        view),
    this->AddButton(
      "Path Tracing", tr("Path tracing: light is scattered from glyph to glyph, with soft shadows.") + view),
    this->AddButton("Custom", tr("The values of the properties panel match none of these.")) };
  int value = 0; // Custom is the last one's, and 0
  for (QAction* quality : this->Qualities)
  {
    quality->setCheckable(true);
    quality->setData(value = (value + 1) % static_cast<int>(this->Qualities.size()));
    quality->setWhatsThis(quality->toolTip());
    QObject::connect(quality, &QAction::triggered, this, [this, quality]() { this->chooseQuality(quality); });
  }
  this->addSeparator();
  this->Stop = this->AddButton("Stop",
    tr("Stop: ends the refinement of the active view's picture until something changes. So does Esc "
       "in the "
       "view."));
  this->Stop->setIcon(this->style()->standardIcon(QStyle::SP_MediaStop));
  QObject::connect(this->Stop, &QAction::triggered, this, &pqRayTracedGlyphsToolBar::stop);

  this->Samples = new QProgressBar(this);
  this->Samples->setObjectName("Samples");
  this->Samples->setToolTip(tr("Samples per pixel of the active view's picture, out of SamplesPerPixel."));
  // No wider than it must be: what does not fit into a narrow window is hidden.
  const QFontMetrics font = this->Samples->fontMetrics();
  this->Samples->setFixedWidth(
    font.horizontalAdvance(tr("%1 of %1, about 55 min left").arg(256)) + 2 * font.averageCharWidth());
  this->Samples->setAlignment(Qt::AlignCenter);
  this->addWidget(this->Samples);

  QAction* reference = this->AddButton("?", tr("All shapes, and the meaning of all properties of ray-traced displays"));
  QObject::connect(reference, &QAction::triggered, this,
    []()
    {
      QWidget* window = pqCoreUtilities::mainWidget();
      auto* page = window->findChild<pqRayTracedGlyphsReference*>();
      page = page ? page : new pqRayTracedGlyphsReference(window);
      page->show();
      page->raise();
    });

  QObject::connect(
    &pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this, &pqRayTracedGlyphsToolBar::follow);
  if (auto* refinement = pqRayTracedGlyphsRefinement::instance())
  {
    QObject::connect(refinement, &pqRayTracedGlyphsRefinement::progressed, this, &pqRayTracedGlyphsToolBar::follow);
  }
  this->follow(pqActiveObjects::instance().activeView());

  // ParaView's last row has room, but is not there yet when plugins are loaded at the start. What the user has arranged
  // is restored after that.
  QTimer::singleShot(0, this,
    [this]()
    {
      if (auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
      {
        window->addToolBar(this);
      }
    });
}

//----------------------------------------------------------------------------
QAction* pqRayTracedGlyphsToolBar::AddButton(const QString& name, const QString& toolTip)
{
  QAction* action = this->addAction(name);
  const QString objectName = QString(name).remove(' ');
  action->setObjectName("action" + objectName);
  action->setToolTip(toolTip);
  auto* button = qobject_cast<QToolButton*>(this->widgetForAction(action));
  button->setObjectName(objectName);
  button->setAutoRaise(false);
  button->setStyleSheet("QToolButton:checked { background: palette(highlight); color: palette(highlighted-text); }");
  return action;
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsToolBar::follow(const pqView* view)
{
  pqView* active = pqActiveObjects::instance().activeView();
  if (view != active)
  {
    return;
  }
  const pqRayTracedGlyphsRefinement::Image image = ImageOf(active);
  const QString chosen =
    image.Display ? vtkSMPropertyHelper(image.Display, "RenderingQuality").GetAsString() : QString();
  for (QAction* quality : this->Qualities)
  {
    quality->setEnabled(image.Display != nullptr);
    quality->setChecked(quality->text() == chosen);
    const double seconds = SecondsOf(image, quality);
    const bool sets = image.Display && quality->data().toInt() != 0;
    quality->setToolTip(quality->whatsThis() +
      (seconds >= 0.0 ? tr(" Takes about %1 here.").arg(pqRayTracedGlyphsWords::ForTime(seconds))
          : sets      ? tr(" How long it takes here is not measured yet.")
                      : QString()));
  }
  this->TellTime(image);
  this->Stop->setEnabled(image.Refined);
  this->Samples->setEnabled(image.Display != nullptr);
  this->Samples->setRange(0, 1000);
  this->Samples->setValue(image.Display ? static_cast<int>(1000.0 * image.Progress) : 0);
  const bool fits = this->Samples->fontMetrics().horizontalAdvance(image.Words) < this->Samples->width();
  this->Samples->setFormat(fits ? image.Words : image.Words.section(',', 0, 0));
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsToolBar::chooseQuality(QAction* quality)
{
  pqView* view = pqActiveObjects::instance().activeView();
  const pqRayTracedGlyphsRefinement::Image image = ImageOf(view);
  if (vtkSMProxy* display = image.Display)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    BEGIN_UNDO_SET(tr("Quality %1").arg(quality->text()));
    vtkSMPropertyHelper(display, "RenderingQuality").Set(quality->text().toUtf8().constData());
    display->UpdateVTKObjects();
    END_UNDO_SET();
    view->render();
    this->Untold = quality;
  }
  this->follow(view);
}

//----------------------------------------------------------------------------
// The status bar shows that the chosen quality takes long, as soon as that is known, and how long others take.
void pqRayTracedGlyphsToolBar::TellTime(const pqRayTracedGlyphsRefinement::Image& image)
{
  const bool holds = this->Untold && this->Untold->isChecked();
  const double seconds = holds ? SecondsOf(image, this->Untold) : 0.0;
  auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  if (seconds < 0.0)
  {
    return;
  }
  if (window && seconds > longTime)
  {
    // In the order of importance: narrow windows cut the end off.
    QStringList times(tr("%1 takes about %2").arg(this->Untold->text(), pqRayTracedGlyphsWords::ForTime(seconds)));
    for (int less = this->Untold->data().toInt() - 1; less > 0; --less)
    {
      const QAction* one = this->Qualities[less - 1];
      const double its = SecondsOf(image, one);
      if (its >= 0.0)
      {
        times += tr("%1 %2").arg(one->text(), pqRayTracedGlyphsWords::ForTime(its));
      }
    }
    window->statusBar()->showMessage(times.join(", ") + tr(". Stop keeps the samples so far."), 10000);
  }
  this->Untold = nullptr;
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsToolBar::stop()
{
  if (auto* refinement = pqRayTracedGlyphsRefinement::instance())
  {
    refinement->stop(pqActiveObjects::instance().activeView());
  }
}
