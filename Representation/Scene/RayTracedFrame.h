/**
 * The images of the frame that a renderer draws. Each is traced once, however often it is drawn.
 */
#ifndef RayTracedFrame_h
#define RayTracedFrame_h

#include "RayTracedImageRequest.h"
#include "RayTracedImages.h"
#include "RayTracedRendererState.h"
#include "vtkBoundingBox.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
namespace rtglyphs
{
class RayTracedProgress;

class RayTracedFrame
{
public:
  struct Drawn
  {
    RayTracedImages::Place Place;
    RayTracedImages::Entry* Entry;
    const rtg::Image* Image; // null: it failed
    double EyeDepth;         // of the camera's position
  };

  struct Kind : RayTracedImageRequest::Frame
  {
    bool Collective = false;   // all ranks render it together
    std::uint64_t Content = 0; // version of what it shows
    vtkBoundingBox Shown;      // bounds of that, below which a ground lies
    int GroundPass = 0;        // whose image shows the ground
  };

  ///@{
  /**
   * The frame's messages: each image that was traced, and why the camera sees nothing, once.
   */
  struct Listener
  {
    std::function<void(const Drawn&)> Traced;
    std::function<void(const std::string&)> Blind;
  };
  RayTracedFrame(RayTracedImages& images, RayTracedProgress& progress, Listener listener);
  ///@}

  void Start(const Kind& kind);

  /**
   * The image of a pass for a viewport of that size. Null: the camera sees nothing.
   */
  const Drawn* Trace(int pass, const RayTracedImageSettings& settings, vtkRenderer* renderer,
    vtkOpenGLRenderWindow* window, std::uint32_t width, std::uint32_t height);

  const std::vector<Drawn>& GetAll() const { return this->All; }
  const Kind& GetKind() const { return this->Own; }

  ///@{
  /**
   * Whether images that are not finished stay as they are until another one or a capture is requested.
   */
  void SetStopped(bool stopped) { this->Stopped = stopped; }
  bool IsStopped() const { return this->Stopped && !this->Own.Capture; }
  ///@}

private:
  RayTracedImages& Images;
  RayTracedProgress& Progress;
  const Listener To;
  Kind Own;
  bool Stopped = false;
  std::vector<Drawn> All;
  RayTracedRendererState::Environment Environment;
  std::string BlindFor; // the last reason, until the camera sees something again
};

} // namespace rtglyphs

#endif
