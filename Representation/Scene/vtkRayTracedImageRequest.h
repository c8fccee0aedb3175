/**
 * What a renderer asks of the kernels: the image of its camera in the light of the view's settings, and how much of it.
 */
#ifndef vtkRayTracedImageRequest_h
#define vtkRayTracedImageRequest_h

#include "ProgressiveImage.h"
#include "vtkRayTracedImageSettings.h"
#include "vtkRayTracedRendererState.h"

class vtkRenderer;

namespace vtkRayTracedImageRequest
{
/**
 * The view of a pass. `environment`: the last one, which is kept up to date. Throws rtg::Error for a camera that sees
 * nothing.
 */
rtg::ImageView ViewOf(const vtkRayTracedImageSettings& settings, vtkRenderer* renderer, rtg::Pass pass,
  std::uint32_t width, std::uint32_t height, vtkRayTracedRendererState::Environment& environment);

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
rtg::ImageEffort EffortOf(const vtkRayTracedImageSettings& settings, const Frame& frame);
}

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedImageRequest.h
