/**
 * @class   RayTracedImageQuad
 * @brief   draws an image with depth over the whole viewport
 *
 * The image's pixels compete with everything else in the view by depth. Partly covered pixels (edges) are blended, or,
 * where the frame buffer is multisampled, cover as many samples, which does not depend on the order of drawing.
 */
#ifndef RayTracedImageQuad_h
#define RayTracedImageQuad_h

#include "vtkNew.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkTextureObject.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>

class vtkActor;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

namespace rtglyphs
{

class RayTracedImageQuad
{
public:
  enum Uses
  {
    BLEND, // color, blended by alpha
    IDS    // exact values in place of color
  };

  /**
   * Sends an image: RGBA8 and window depths, bottom row first. Its version, if not 0, identifies the image that the
   * quad shows.
   */
  bool Shows(std::uint64_t version) const { return this->Sent && version != 0 && version == this->Version; }
  void SetImage(vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height, const std::uint32_t* color,
    const float* depth, std::uint64_t version);

  ///@{
  /**
   * The camera of the image, and of the frame in which it is to be drawn again. False: that one sees something else.
   * Another clipping range is no other view: depths are drawn for it.
   */
  void SetCamera(const glm::dmat4& worldToClip);
  bool MoveTo(const glm::dmat4& worldToClip);
  ///@}

  /**
   * Draws it. `actor`, with `mapper`, carries the render passes that have a say in the shader: depth peeling, and the
   * view's ambient occlusion in screen space, which wants the place and the normal of what each pixel shows.
   */
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, Uses use);

  /**
   * Draws pixels of the viewport again where the image is visible: where nothing that has depth lies before it.
   */
  void DrawKept(vtkRenderer* renderer, vtkTextureObject* pixels);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  bool Sent = false;
  std::uint64_t Version = 0; // of what was sent
  glm::dmat4 WorldToClip{ 1.0 };
  float DepthMap[2] = { 1.0f, 0.0f }; // scale and offset of its depths
  // By fragment shader: each stage of depth peeling has its own.
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads;

  vtkOpenGLQuadHelper* Ready(vtkOpenGLRenderWindow* window, const std::string& fragment);
};

} // namespace rtglyphs

#endif
