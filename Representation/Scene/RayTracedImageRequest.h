/**
 * What a renderer asks of the kernels: the image of its camera in the light of the view's settings, and how much of it.
 */
#ifndef RayTracedImageRequest_h
#define RayTracedImageRequest_h

#include "ProgressiveImage.h"
#include "RayTracedImageSettings.h"
#include "RayTracedRendererState.h"

class vtkRenderer;

namespace rtglyphs::RayTracedImageRequest
{
/**
 * The view of a pass. `environment`: the last one, which is kept up to date. Throws rtg::Error for a camera that sees
 * nothing.
 */
rtg::ImageView ViewOf(const RayTracedImageSettings& settings, vtkRenderer* renderer, rtg::Pass pass,
  std::uint32_t width, std::uint32_t height, RayTracedRendererState::Environment& environment);

/**
 * The frame that the image is for.
 */
struct Frame
{
  bool Capture = false;     // is shown only once
  bool Interactive = false; // the camera moves
  bool Features = false;    // features of the finished image are wanted
  int Images = 1;           // share the frame's time
};
rtg::ImageEffort EffortOf(const RayTracedImageSettings& settings, const Frame& frame);
}

#endif
// VTK-HeaderTest-Exclude: RayTracedImageRequest.h
