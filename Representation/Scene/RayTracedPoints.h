/**
 * What is shown as points, drawn by OpenGL while the first program is compiled and there is no picture yet.
 */
#ifndef RayTracedPoints_h
#define RayTracedPoints_h

#include "RayTracedNeighbors.h"
#include "vtkActor.h"
#include "vtkNew.h"

#include <cstdint>

class vtkRenderer;
class vtkWindow;
namespace rtglyphs
{
class RayTracedDisplays;
class RayTracedImages;

class RayTracedPoints
{
public:
  RayTracedPoints();

  /**
   * Of many glyphs some. `as`: the actor in whose place they are drawn.
   */
  void Draw(const RayTracedDisplays& displays, RayTracedImages& images, vtkRenderer* renderer, vtkActor* as);

  void ReleaseGraphicsResources(vtkWindow* window) { this->Actor->ReleaseGraphicsResources(window); }

private:
  vtkNew<vtkActor> Actor;
  std::uint64_t Version = 0; // of the displays that the points are of
};

} // namespace rtglyphs

#endif
