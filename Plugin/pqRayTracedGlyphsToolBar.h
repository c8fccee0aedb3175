/**
 * @class   pqRayTracedGlyphsToolBar
 * @brief   quality, progress and end of the active view's ray-traced images
 *
 * The buttons set RenderingQuality of the view, as the properties panel does, and say beforehand how long its image
 * will take where that is known. All are disabled while the active view shows nothing ray-traced.
 */
#ifndef pqRayTracedGlyphsToolBar_h
#define pqRayTracedGlyphsToolBar_h

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
  ~pqRayTracedGlyphsToolBar() override;

private Q_SLOTS:
  void follow(const pqView* view);
  void chooseQuality(QAction* quality);
  void stop();

private:
  Q_DISABLE_COPY(pqRayTracedGlyphsToolBar)

  QAction* AddButton(const QString& name, const QString& toolTip);

  std::vector<QAction*> Qualities; // their data: RenderingQuality
  QAction* Stop = nullptr;
  QProgressBar* Samples = nullptr;
};

#endif
