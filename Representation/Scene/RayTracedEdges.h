/**
 * Colors of other ranks behind the anti-aliased edges of this one.
 *
 * Of two ranks' pixels compositing by depth keeps the nearer one. Where that is covered only in part, what lies behind
 * is seen through the rest, and may be another rank's. Before they draw, ranks send each other what they show in such
 * pixels; each rank processes those of its part of the picture, and sends what lies behind an edge to the rank
 * that shows the edge, which draws it first. Layers are put together by their coverage, as if edges within one pixel
 * were independent (Porter and Duff, Compositing Digital Images, SIGGRAPH 1984).
 */
#ifndef RayTracedEdges_h
#define RayTracedEdges_h

#include "RayTracedImageQuad.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;
namespace rtg
{
struct Image;
}

namespace rtglyphs
{
class RayTracedEdges
{
public:
  /**
   * To be called by all ranks at once, with what this rank shows, and its version; null: nothing. When these are what
   * they were at the last call on all ranks, nothing is done. Returns what went wrong on this rank; nothing then lies
   * behind the edges of any.
   */
  std::string Exchange(const rtg::Image* image, std::uint64_t version);

  void Clear();

  /**
   * Draws what lies behind the edges of that image, if it is that of the last exchange.
   */
  void Draw(
    const rtg::Image* image, vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  void ReleaseGraphicsResources(vtkWindow* window) { this->Quad.ReleaseGraphicsResources(window); }

private:
  void Forget();
  void FindBehind(const rtg::Image* image, std::size_t pixels);

  const rtg::Image* Front = nullptr; // of the last exchange; only compared
  std::uint64_t FrontVersion = 0;
  // RGBA8, straight, and window depth of all its pixels; alpha is 0 where nothing lies behind. Empty: nowhere does any.
  std::vector<std::uint32_t> Colors;
  std::vector<float> Depths;
  std::uint64_t Version = 0; // grows with each change of these
  RayTracedImageQuad Quad;
};

} // namespace rtglyphs

#endif
