/**
 * @class   GlyphLayers
 * @brief   what a representation of glyphs draws besides its main actor, each with an actor and a mapper of its own
 *
 * Layers show the points, blocks, placement and appearance of the main actor with other settings: further meshes of a
 * table of meshes, arrows of antisymmetric parts, trails.
 */
#ifndef GlyphLayers_h
#define GlyphLayers_h

#include "vtkRayTracedActors.h"
#include "vtkRayTracedGlyphMapper.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace rtglyphs
{

class GlyphLayers
{
public:
  struct Layer
  {
    vtkNew<vtkRayTracedActor> Actor;
    vtkNew<vtkRayTracedGlyphMapper> Mapper;

    /// Blocks and appearance of the main actor.
    void Follow(const RayTracedBlocks& blocks, vtkActor* main, const std::array<double, 3>& selectionColor);
  };

  /**
   * Makes or drops layers; what comes or goes is added to the view, or removed, by these.
   */
  using Part = std::function<void(vtkRayTracedActor*, vtkRayTracedMapper*)>;
  void Resize(std::size_t size, const Part& add, const Part& remove);

  Layer& operator[](std::size_t i) { return *this->Layers[i]; }

  void SetVisibility(bool visible);
  void SetAside(bool aside);
  void SetKnownBounds(const double bounds[6]);

private:
  std::vector<std::unique_ptr<Layer>> Layers;
};

} // namespace rtglyphs

#endif
