/**
 * The glyph in a pixel: numbers for a renderer's hardware selector, and places. An image on the screen has
 * that; without one, one ray a pixel finds it.
 */
#ifndef RayTracedPicker_h
#define RayTracedPicker_h

#include "RayTracedImageQuad.h"

#include <functional>
#include <vector>

namespace rtg
{
class ProgressiveImage;
struct Image;
}
class vtkActor;
class vtkRayTracedMapper;
class vtkRenderer;
class vtkWindow;
namespace rtglyphs
{
class RayTracedDisplays;
class RayTracedImages;

class RayTracedPicker
{
public:
  using Failed = std::function<void(const rtg::ProgressiveImage&)>;

  /**
   * Draws a number in the place of each of the actor's pixels, 24 bits of it, as the renderer's selector needs.
   */
  void DrawIds(const RayTracedDisplays& displays, RayTracedImages& images, vtkRenderer* renderer, vtkActor* actor,
    vtkRayTracedMapper* mapper, const Failed& failed);

  /**
   * The point of the nearest ray-traced surface, of any display, that the camera sees in a pixel of the renderer;
   * false: none.
   */
  static bool PlaceAt(const RayTracedDisplays& displays, RayTracedImages& images, vtkRenderer* renderer, int x, int y,
    double place[3], const Failed& failed);

  void ReleaseGraphicsResources(vtkWindow* window) { this->Quad.ReleaseGraphicsResources(window); }

private:
  static std::vector<const rtg::Image*> ImagesWithIds(const RayTracedDisplays& displays, RayTracedImages& images,
    vtkRenderer* renderer, int width, int height, const Failed& failed);

  RayTracedImageQuad Quad;
};

} // namespace rtglyphs

#endif
