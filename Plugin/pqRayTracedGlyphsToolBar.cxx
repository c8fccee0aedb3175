#include "pqRayTracedGlyphsToolBar.h"

#include "pqActiveObjects.h"
#include "pqRayTracedGlyphsReference.h"
#include "pqRayTracedGlyphsRefinement.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QAction>
#include <QFontMetrics>
#include <QProgressBar>
#include <QStyle>

#include <algorithm>

namespace
{
pqRayTracedGlyphsRefinement::Image ImageOf(pqView* view)
{
  const auto* refinement = pqRayTracedGlyphsRefinement::instance();
  return view && refinement ? refinement->imageOf(view) : pqRayTracedGlyphsRefinement::Image();
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsToolBar::pqRayTracedGlyphsToolBar(QWidget* parent)
  : QToolBar(tr("Ray Traced Glyphs"), parent)
{
  this->setObjectName("RayTracedGlyphs");
  const QString view = tr(" Holds for all ray-traced displays of the active view.");
  this->Qualities = { this->AddButton("Fast", tr("Quick pictures: plain light, few samples a pixel.") + view),
    this->AddButton("Balanced", tr("Glyphs shade each other; enough samples a pixel for daily work.") + view),
    this->AddButton("Publication",
      tr("Glyphs shade each other; many samples a pixel and nothing smoothed, for final pictures.") + view) };
  for (QAction* quality : this->Qualities)
  {
    quality->setCheckable(true);
    QObject::connect(quality, &QAction::triggered, this, [this, quality]() { this->chooseQuality(quality); });
  }
  this->addSeparator();
  this->Stop = this->AddButton("Stop",
    tr("Stop: leaves the picture of the active view with the samples that it has, until something changes. So does Esc "
       "in the "
       "view."));
  this->Stop->setIcon(this->style()->standardIcon(QStyle::SP_MediaStop));
  QObject::connect(this->Stop, &QAction::triggered, this, &pqRayTracedGlyphsToolBar::stop);

  this->Samples = new QProgressBar(this);
  this->Samples->setObjectName("Samples");
  this->Samples->setToolTip(
    tr("Samples a pixel that the picture of the active view has, of those that it will have (SamplesPerPixel)."));
  // No wider than it must be: what does not fit into a narrow window is hidden.
  const QFontMetrics font = this->Samples->fontMetrics();
  this->Samples->setFixedWidth(font.horizontalAdvance(tr("%1 of %1").arg(65536)) + 2 * font.averageCharWidth());
  this->Samples->setAlignment(Qt::AlignCenter);
  this->addWidget(this->Samples);

  QAction* reference = this->AddButton("?", tr("What the display properties of ray-traced glyphs and surfaces mean"));
  QObject::connect(
    reference, &QAction::triggered, this, [this]() { (new pqRayTracedGlyphsReference(this->window()))->show(); });

  QObject::connect(
    &pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this, &pqRayTracedGlyphsToolBar::follow);
  if (auto* refinement = pqRayTracedGlyphsRefinement::instance())
  {
    QObject::connect(refinement, &pqRayTracedGlyphsRefinement::looked, this, &pqRayTracedGlyphsToolBar::follow);
  }
  this->follow(pqActiveObjects::instance().activeView());
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsToolBar::~pqRayTracedGlyphsToolBar() = default;

//----------------------------------------------------------------------------
QAction* pqRayTracedGlyphsToolBar::AddButton(const QString& name, const QString& toolTip)
{
  QAction* action = this->addAction(name);
  action->setObjectName("action" + name);
  action->setToolTip(toolTip);
  this->widgetForAction(action)->setObjectName(name);
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
  }
  this->Stop->setEnabled(image.Refined);
  this->Samples->setEnabled(image.Display != nullptr);
  this->Samples->setRange(0, std::max(image.Wanted, 1));
  this->Samples->setValue(std::min(image.Samples, image.Wanted));
  const bool fits = this->Samples->fontMetrics().horizontalAdvance(image.Step) < this->Samples->width();
  const QString step = fits ? image.Step : image.Step.section(' ', 0, 0);
  this->Samples->setFormat(!image.Display ? QString() : image.Samples > 0 || !image.Refined ? tr("%v of %m") : step);
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsToolBar::chooseQuality(QAction* quality)
{
  pqView* view = pqActiveObjects::instance().activeView();
  if (vtkSMProxy* display = ImageOf(view).Display)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", display);
    BEGIN_UNDO_SET(tr("Quality %1").arg(quality->text()));
    vtkSMPropertyHelper(display, "RenderingQuality").Set(quality->text().toUtf8().constData());
    display->UpdateVTKObjects();
    END_UNDO_SET();
    view->render();
  }
  this->follow(view);
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsToolBar::stop()
{
  if (auto* refinement = pqRayTracedGlyphsRefinement::instance())
  {
    refinement->stop(pqActiveObjects::instance().activeView());
  }
}
