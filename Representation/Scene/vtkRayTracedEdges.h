/**
 * What other ranks show behind the smooth edges of this one.
 *
 * Of two ranks' pixels compositing by depth keeps the nearer one. Where that is covered only in part, what lies behind
 * is seen through the rest, and may be another rank's. Before they draw, ranks send each other what they show in such
 * pixels; each rank looks through those of its share of the picture, and sends what lies behind an edge to the rank
 * that shows the edge, which draws it first. Layers are put together by their coverage, as if edges within one pixel
 * were independent (Porter and Duff, Compositing Digital Images, SIGGRAPH 1984).
 */
#ifndef vtkRayTracedEdges_h
#define vtkRayTracedEdges_h

#include <cstdint>
#include <string>
#include <vector>

class vtkMultiProcessController;
namespace rtg
{
struct Image;
}

class vtkRayTracedEdges
{
public:
  /**
   * To be called by all ranks at once, with what this rank shows; null: nothing. `changed`: it is not what it was at
   * the last call; when that is so on no rank, nothing is done. Returns what went wrong on this rank, which then has
   * nothing behind its edges.
   */
  std::string Exchange(vtkMultiProcessController* controller, const rtg::Image* image, bool changed);

  void Clear();

  ///@{
  /**
   * What lies behind this rank's edges: RGBA8, straight, and window depth of all pixels of its image; alpha is 0 where
   * nothing does. Empty: that is so everywhere.
   */
  const std::vector<std::uint32_t>& GetColors() const { return this->Colors; }
  const std::vector<float>& GetDepths() const { return this->Depths; }
  ///@}

  /**
   * Grows with each change.
   */
  std::uint64_t GetVersion() const { return this->Version; }

private:
  std::vector<std::uint32_t> Colors;
  std::vector<float> Depths;
  std::uint64_t Version = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedEdges.h
