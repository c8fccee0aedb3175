/**
 * What frames of a view show, and the kernels' side of it: the view's displays, what other ranks have near them, and
 * the images that are traced of both.
 */
#ifndef vtkRayTracedContent_h
#define vtkRayTracedContent_h

#include "vtkRayTracedDisplays.h"
#include "vtkRayTracedImages.h"
#include "vtkRayTracedNeighbors.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkMultiProcessController;
class vtkRenderer;
struct vtkRayTracedImageSettings;

class vtkRayTracedContent
{
public:
  vtkRayTracedDisplays Displays;
  vtkRayTracedNeighbors Neighbors;
  vtkRayTracedImages Images;
  std::function<void(double share)> Sorting; // is told how far the kernels are with new glyphs

  /**
   * Brings displays up to date and, where the settings want it, asks the ranks that render together (null: none) what
   * they have. Returns whether the frame shows something else than the last one did.
   */
  bool Update(vtkRenderer* renderer, const vtkRayTracedImageSettings& settings, vtkMultiProcessController* ranks,
    const std::function<void(const std::string&)>& report);

  /**
   * Grows with what is shown.
   */
  std::uint64_t GetNumber() const { return this->Number; }

  /**
   * Makes or improves an image, after handing the kernels what has changed since they last had it; null: it failed.
   */
  const rtg::Image* Trace(vtkRayTracedImages::Entry& entry, const rtg::ImageView& view, const rtg::ImageEffort& effort,
    const rtg::Interrupt& interrupt, vtkRenderer* renderer);

private:
  std::uint64_t UpdateNeighbors(const vtkRayTracedDisplays::Content& shown, const vtkRayTracedImageSettings& settings,
    vtkMultiProcessController* ranks, const std::function<void(const std::string&)>& report);

  vtkRayTracedDisplays::Content Shown;         // with the neighbors' version
  vtkRayTracedDisplays::Content ShownToOthers; // what displays showed when neighbors were last asked for
  std::uint64_t Number = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedContent.h
