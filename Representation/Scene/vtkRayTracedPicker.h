/**
 * What the camera sees in a pixel: numbers for a renderer's hardware selector, and places. An image that is shown knows
 * that; without one, one ray a pixel finds it.
 */
#ifndef vtkRayTracedPicker_h
#define vtkRayTracedPicker_h

#include "vtkRayTracedImageQuad.h"

#include <functional>
#include <vector>

namespace rtg
{
class ProgressiveImage;
struct Image;
}
class vtkActor;
class vtkRayTracedContent;
class vtkRayTracedMapper;
class vtkRenderer;
class vtkWindow;

class vtkRayTracedPicker
{
public:
  using Failed = std::function<void(const rtg::ProgressiveImage&)>;

  /**
   * Draws a number in the place of each of the actor's pixels, 24 bits of it, as the renderer's selector asks for.
   */
  void DrawIds(vtkRayTracedContent& content, vtkRenderer* renderer, vtkActor* actor, vtkRayTracedMapper* mapper,
    const Failed& failed);

  /**
   * The point of the nearest ray-traced surface, of any display, that the camera sees in a pixel of the renderer;
   * false: none.
   */
  static bool
  PlaceAt(vtkRayTracedContent& content, vtkRenderer* renderer, int x, int y, double place[3], const Failed& failed);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static std::vector<const rtg::Image*>
  ImagesWithIds(vtkRayTracedContent& content, vtkRenderer* renderer, int width, int height, const Failed& failed);

  vtkRayTracedImageQuad Quad;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedPicker.h
