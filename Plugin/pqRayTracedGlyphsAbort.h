/**
 * @class   pqRayTracedGlyphsAbort
 * @brief   lets the user end a picture that takes long
 *
 * A screenshot is one render with all samples. While it takes long this object looks for the Abort button of ParaView's
 * progress bar, the toolbar's Stop and the Esc key, and lets nothing else happen in the window.
 */
#ifndef pqRayTracedGlyphsAbort_h
#define pqRayTracedGlyphsAbort_h

#include "vtkNew.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

class QWidget;
class pqProgressWidget;
class vtkEventQtSlotConnect;
class vtkObject;
class vtkRenderWindow;

class pqRayTracedGlyphsAbort : public QObject
{
  Q_OBJECT

public:
  pqRayTracedGlyphsAbort(QObject* parent = nullptr);
  ~pqRayTracedGlyphsAbort() override;

  /**
   * Pictures of that window can be aborted.
   */
  void watch(vtkRenderWindow* window);

  ///@{
  /**
   * A render of a view begins, and ends.
   */
  void renderStarted();
  void renderEnded();
  ///@}

  ///@{
  /**
   * Whether a picture is being made that takes long; and ends it, if so.
   */
  bool isListening() const { return this->Listening; }
  bool abort();
  ///@}

  /**
   * ParaView's; null: there is none.
   */
  pqProgressWidget* progressBar();

  ///@{
  /**
   * Whether an event is the press of Esc, and an object a widget or in it.
   */
  static bool isEscape(QEvent* event);
  static bool isWithin(const QObject* object, const QWidget* outer);
  ///@}

  void shutdown();

Q_SIGNALS:
  /**
   * A picture takes long.
   */
  void listening();

  /**
   * The button was pressed while no picture was being made.
   */
  void pressed();

  /**
   * No picture is being made any more; the button may be enabled.
   */
  void rested();

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private Q_SLOTS:
  void abortChecked(vtkObject* window);
  void abortPressed();

private:
  void Listen();

  vtkNew<vtkEventQtSlotConnect> Observers;
  QPointer<pqProgressWidget> Bar;
  QPointer<QWidget> Stop;   ///< the toolbar's button
  QElapsedTimer SinceStart; ///< of the last render
  QTimer Rest;              ///< runs out when the window is at rest again
  bool Listening = false;   ///< to events, within a render
  bool Aborted = false;     ///< until the window is at rest again
};

#endif
