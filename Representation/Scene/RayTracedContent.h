/**
 * What frames of a view show, and the kernels' side of it: the view's displays, what other ranks have near them, and
 * the images that are traced of both.
 */
#ifndef RayTracedContent_h
#define RayTracedContent_h

#include "RayTracedDisplays.h"
#include "RayTracedImages.h"
#include "RayTracedNeighbors.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkMultiProcessController;
class vtkRenderer;
namespace rtglyphs
{
struct RayTracedImageSettings;

class RayTracedContent
{
public:
  RayTracedDisplays Displays;
  RayTracedNeighbors Neighbors;
  RayTracedImages Images;
  std::function<void(double share)> Sorting; // is told how far the kernels are with new glyphs

  /**
   * Brings displays up to date and, where the settings want it, asks the ranks that render together (null: none) what
   * they have. Returns whether the frame shows something else than the last one did.
   */
  bool Update(vtkRenderer* renderer, const RayTracedImageSettings& settings, vtkMultiProcessController* ranks,
    const std::function<void(const std::string&)>& report);

  /**
   * Grows with what is shown.
   */
  std::uint64_t GetNumber() const { return this->Number; }

  /**
   * Makes or improves an image, after handing the kernels what has changed since they last had it; null: it failed.
   */
  const rtg::Image* Trace(RayTracedImages::Entry& entry, const rtg::ImageView& view, const rtg::ImageEffort& effort,
    const rtg::Interrupt& interrupt, vtkRenderer* renderer);

private:
  std::uint64_t UpdateNeighbors(const RayTracedDisplays::Content& shown, const RayTracedImageSettings& settings,
    vtkMultiProcessController* ranks, const std::function<void(const std::string&)>& report);

  RayTracedDisplays::Content Shown;         // with the neighbors' version
  RayTracedDisplays::Content ShownToOthers; // what displays showed when neighbors were last asked for
  std::uint64_t Number = 0;
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedContent.h
