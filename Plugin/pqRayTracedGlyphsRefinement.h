/**
 * @class   pqRayTracedGlyphsRefinement
 * @brief   finishes ray-traced images while ParaView's window rests, and stops tracing on the user's request
 *
 * A render in the window traces only what takes some hundredths of a second. After each, this object renders the view
 * again until all samples are there: between two renders the window answers to its user, and none happens while the
 * camera is turned or an animation plays. ParaView's progress bar says how far the images are. Its Abort button, or Esc
 * in a view, leaves them as they are. When all views are finished no timer runs.
 */
#ifndef pqRayTracedGlyphsRefinement_h
#define pqRayTracedGlyphsRefinement_h

#include "pqRayTracedGlyphsAbort.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <vector>

class pqProxy;
class pqRepresentation;
class pqView;
class vtkEventQtSlotConnect;
class vtkObject;
class vtkSMProxy;
class vtkSMRayTracedViewProxy;
class vtkSMViewProxy;

class pqRayTracedGlyphsRefinement : public QObject
{
  Q_OBJECT

public:
  pqRayTracedGlyphsRefinement(QObject* parent = nullptr);
  ~pqRayTracedGlyphsRefinement() override;

  void startup();
  void shutdown();

  /**
   * The plugin's only one; null after it was unloaded.
   */
  static pqRayTracedGlyphsRefinement* instance();

  struct Image
  {
    vtkSMProxy* Display = nullptr;            ///< one of its visible ray-traced displays; null: there is none
    bool Refined = false;                     ///< more are being traced, or a screenshot is
    QString Words;                            ///< how far it is, or what it waits for
    double Progress = 1.0;                    ///< in [0, 1]
    vtkSMRayTracedViewProxy* Scene = nullptr; ///< of what is meant
  };
  /**
   * The image of a view; of a comparative view's parts the one that lacks most.
   */
  Image imageOf(pqView* view) const;

  /**
   * Leaves the images of a view, or of all (null), as they are until something else changes them.
   */
  void stop(const pqView* view);

Q_SIGNALS:
  /**
   * The image of a view may be another one, or further.
   */
  void progressed(pqView* view);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private Q_SLOTS:
  void viewAdded(pqView* view);
  void representationAdded(pqRepresentation* representation);
  void proxyAdded(pqProxy* proxy);
  void showChoice(vtkObject* number);
  void step();
  void rested();

private:
  // A view of its own, or one of a comparative view's.
  struct Part
  {
    QPointer<pqView> View;
    vtkWeakPointer<vtkSMViewProxy> Proxy;
  };
  static std::vector<Part> PartsOf(pqView* view);
  static vtkSMRayTracedViewProxy* SceneOf(const Part& part);
  void CheckProgress(Part part);
  void Render(const Part& part);
  void ShowProgress();

  std::vector<Part> Waiting; ///< to be rendered again, the next one first
  std::vector<Part> Turned;  ///< last rendered for speed
  pqRayTracedGlyphsAbort Abort;
  vtkNew<vtkEventQtSlotConnect> Factors; ///< of the displays
  QTimer Timer;                          ///< of the next step
  QTimer AtRest;                         ///< runs out when no view was turned of late
  bool Showing = false;                  ///< something in the progress bar
  bool Playing = false;
};

#endif
