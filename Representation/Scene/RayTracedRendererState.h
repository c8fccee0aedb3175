/**
 * Converts a renderer's camera, lights, environment and an actor's property to what the kernels take.
 */
#ifndef RayTracedRendererState_h
#define RayTracedRendererState_h

#include "Camera.h"
#include "Environment.h"
#include "Glyphs.h"

#include <memory>
#include <vector>

class vtkProperty;
class vtkRenderer;

namespace rtglyphs::RayTracedRendererState
{
/**
 * World to OpenGL clip space, in double and with all that a tile, stereo or an off-axis frustum adds.
 */
glm::dmat4 WorldToClip(vtkRenderer* renderer);

/**
 * The point in space at the center of a pixel of an image, row by row from the lowest, and at a depth in [0, 1].
 */
glm::dvec3
PlaceOf(std::size_t pixel, std::uint32_t width, std::uint32_t height, float depth, const glm::dmat4& clipToWorld);

/**
 * The rays of the renderer's camera. Throws rtg::Error for a camera that sees nothing.
 */
rtg::Camera CameraOf(vtkRenderer* renderer, const glm::dmat4& worldToClip);

/**
 * The lights that are on, as vtkOpenGLRenderer::UpdateLights() counts them: a headlight that is alone is shaded
 * as such, several lights as directional and positional ones. `placedOnly` leaves out those that move with the camera
 * and have no place: headlight and light kit.
 */
std::vector<rtg::Light> LightsOf(vtkRenderer* renderer, double softness, bool placedOnly = false);

/**
 * The renderer's environment image (vtkRenderer::UseImageBasedLighting), with 8-bit colors
 * as sRGB and others as linear; null: it has none, or none of two dimensions. `last` is given back when it is still
 * that image. Images of more than 4096 x 2048 texels are made smaller by means over blocks.
 */
struct Environment
{
  unsigned long Time = 0; // of the input
  std::shared_ptr<const rtg::EnvironmentImage> Image;
};
Environment EnvironmentOf(vtkRenderer* renderer, const Environment& last);

/**
 * The property's material; unlit, as VTK draws surfaces then, when the renderer has no light on and makes none.
 */
rtg::Material MaterialOf(vtkProperty* property, vtkRenderer* renderer);
}

#endif
