/**
 * The anti-aliasing in screen space (FXAA) of a view, but for ray-traced images: their edges are smooth already, and
 * FXAA would blur them and, in transparent screenshots, which are made of a picture before white and one before black,
 * leave gaps.
 */
#ifndef RayTracedFXAA_h
#define RayTracedFXAA_h

#include "vtkNew.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkTextureObject.h"

#include <functional>

class vtkRenderer;

namespace rtglyphs
{

class RayTracedFXAA
{
public:
  ///@{
  /**
   * Before a frame is drawn: switches the renderer's FXAA off. After it: on again where it was on.
   */
  void Disable(vtkRenderer* renderer);
  void Restore(vtkRenderer* renderer);
  ///@}

  /**
   * When all is drawn: FXAA where it was on, and then `drawKept` with the pixels as they were before.
   */
  void Apply(vtkRenderer* renderer, const std::function<void(vtkTextureObject*)>& drawKept);

  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLFXAAFilter> Filter;
  vtkNew<vtkTextureObject> Pixels;
  bool WasOn = false;
};

} // namespace rtglyphs

#endif
