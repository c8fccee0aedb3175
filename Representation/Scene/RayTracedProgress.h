/**
 * Reports a frame's work to ParaView's progress bar, once that has taken a while, and gives
 * a frame its OpenGL context back when the bar was painted: a user interface paints with a context of its own.
 */
#ifndef RayTracedProgress_h
#define RayTracedProgress_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <chrono>

class vtkAlgorithm;
class vtkCallbackCommand;
class vtkOpenGLRenderWindow;
class vtkPVProgressHandler;
class vtkRenderWindow;

namespace rtglyphs
{

class RayTracedProgress
{
public:
  RayTracedProgress();
  ~RayTracedProgress();
  RayTracedProgress(const RayTracedProgress&) = delete;
  RayTracedProgress& operator=(const RayTracedProgress&) = delete;

  /**
   * A frame of this window begins: its context and OpenGL state survive what is painted for progress, of this process
   * or of a server that renders for it, until the frame ends.
   */
  void StartFrame(vtkRenderWindow* window);
  void EndFrame();

  /**
   * Work begins, without progress yet.
   */
  void Start() { this->Begin = std::chrono::steady_clock::now(); }

  /**
   * The fraction `share` in [0, 1] of the work that `text` names is done.
   */
  void Report(const char* text, double share);

private:
  vtkNew<vtkAlgorithm> Reporter; // the bar takes algorithms only
  bool IsKnown = false;
  vtkNew<vtkCallbackCommand> Before, After; // what listens to progress
  vtkWeakPointer<vtkPVProgressHandler> Handler;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::chrono::steady_clock::time_point Begin;
};

} // namespace rtglyphs

#endif
