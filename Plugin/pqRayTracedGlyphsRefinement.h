/**
 * @class   pqRayTracedGlyphsRefinement
 * @brief   finishes ray-traced images while ParaView's window rests
 *
 * A render in the window traces only what takes a tenth of a second or so. After each, this object renders the view
 * again until all samples are there: between two renders the window answers to its user, and none happens while the
 * camera is turned. The status bar says how far an image is. When all views are finished no timer runs.
 */
#ifndef pqRayTracedGlyphsRefinement_h
#define pqRayTracedGlyphsRefinement_h

#include <QObject>
#include <QPointer>
#include <QSet>
#include <QTimer>

#include <vector>

class pqRepresentation;
class pqView;
class vtkObject;

class pqRayTracedGlyphsRefinement : public QObject
{
  Q_OBJECT

public:
  pqRayTracedGlyphsRefinement(QObject* parent = nullptr);
  ~pqRayTracedGlyphsRefinement() override;

  void startup();
  void shutdown();

private Q_SLOTS:
  void viewAdded(pqView* view);
  void representationAdded(pqRepresentation* representation);
  void rendered();
  void step();

private:
  Q_DISABLE_COPY(pqRayTracedGlyphsRefinement)

  struct Progress
  {
    double Done = 1.0; ///< in [0, 1]
    bool Finished() const { return this->Done >= 1.0; }
  };
  static Progress ProgressOf(pqView* view);
  void interactionStarted(vtkObject* interactor, unsigned long, void*);
  void interactionEnded(vtkObject* interactor, unsigned long, void*);

  std::vector<QPointer<pqView>> Waiting; ///< views to be rendered again
  QSet<vtkObject*> Interacting;          ///< interactors whose camera is being turned
  QTimer Timer;
  bool Showing = false; ///< a message in the status bar
};

#endif
