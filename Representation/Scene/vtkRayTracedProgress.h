/**
 * Tells ParaView's progress bar what a frame is doing, once that has taken so long that somebody may wonder.
 */
#ifndef vtkRayTracedProgress_h
#define vtkRayTracedProgress_h

#include "vtkNew.h"

#include <chrono>

class vtkAlgorithm;

class vtkRayTracedProgress
{
public:
  vtkRayTracedProgress();
  ~vtkRayTracedProgress();
  vtkRayTracedProgress(const vtkRayTracedProgress&) = delete;
  vtkRayTracedProgress& operator=(const vtkRayTracedProgress&) = delete;

  /**
   * Work begins, of which there is nothing to tell yet.
   */
  void Start();

  /**
   * `share` in [0, 1] of what `text` names is done. Whoever listens may paint, and leave another OpenGL context
   * current.
   */
  void Tell(const char* text, double share);

private:
  vtkNew<vtkAlgorithm> Teller; // the bar knows algorithms only
  bool IsKnown = false;
  std::chrono::steady_clock::time_point Begin;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedProgress.h
