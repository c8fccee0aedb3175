/**
 * @class   pqRayTracedGlyphsToolBar
 * @brief   quality, progress and end of the active view's ray-traced images
 *
 * The buttons set RenderingQuality of the view, as the properties panel does, and say how long its image will take as
 * soon as that is measured. All are disabled while the active view shows nothing ray-traced.
 */
#ifndef pqRayTracedGlyphsToolBar_h
#define pqRayTracedGlyphsToolBar_h

#include "pqRayTracedGlyphsRefinement.h"

#include <QToolBar>

#include <vector>

class QAction;
class QProgressBar;
class pqView;

class pqRayTracedGlyphsToolBar : public QToolBar
{
  Q_OBJECT

public:
  pqRayTracedGlyphsToolBar(QWidget* parent = nullptr);

private Q_SLOTS:
  void follow(const pqView* view);
  void chooseQuality(QAction* quality);
  void stop();

private:
  QAction* AddButton(const QString& name, const QString& toolTip);
  void TellTime(const pqRayTracedGlyphsRefinement::Image& image);

  std::vector<QAction*> Qualities; // their data: RenderingQuality
  QAction* Untold = nullptr;       // the quality that was chosen, while its time is not known
  QAction* Stop = nullptr;
  QProgressBar* Samples = nullptr;
};

#endif
