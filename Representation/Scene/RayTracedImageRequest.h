/**
 * A renderer's request to the kernels: the image of its camera with the view's settings, and how much of it.
 */
#ifndef RayTracedImageRequest_h
#define RayTracedImageRequest_h

#include "ProgressiveImage.h"
#include "RayTracedImageSettings.h"
#include "RayTracedRendererState.h"
#include "ScreenEffects.h"

class vtkBoundingBox;
class vtkRenderer;

namespace rtglyphs::RayTracedImageRequest
{
/**
 * The view of a pass. `shown`: the bounds of what a ground is to lie below; invalid: there is none. `environment`: the
 * last one, which is kept up to date. Throws rtg::Error for a camera that sees nothing.
 */
rtg::ImageView ViewOf(const RayTracedImageSettings& settings, vtkRenderer* renderer, rtg::Pass pass,
  std::uint32_t width, std::uint32_t height, const vtkBoundingBox& shown,
  RayTracedRendererState::Environment& environment);

/**
 * Screen effects for an image of that view, which may have fewer than were requested.
 */
rtg::ScreenEffects
EffectsOf(const RayTracedImageSettings& settings, const rtg::ImageView& view, const rtg::Image& image);

/**
 * The frame that the image is for.
 */
struct Frame
{
  bool Capture = false;     // is shown only once
  bool Interactive = false; // the camera moves
  bool Features = false;    // features of the finished image are wanted
  int Images = 1;           // divide the frame's time
};
rtg::ImageEffort EffortOf(const RayTracedImageSettings& settings, const Frame& frame);
}

#endif
