/**
 * @class   GlyphLayers
 * @brief   what a representation of glyphs draws besides its main actor, each with an actor and a mapper of its own
 *
 * Layers show the points, blocks, placement and appearance of the main actor with other settings.
 */
#ifndef GlyphLayers_h
#define GlyphLayers_h

#include "vtkRayTracedActors.h"
#include "vtkRayTracedGlyphMapper.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkPVDataRepresentation;
class vtkPVRenderView;

namespace rtglyphs
{
class RayTracedParts;

class GlyphLayers
{
public:
  struct Layer
  {
    vtkNew<vtkRayTracedActor> Actor;
    vtkNew<vtkRayTracedGlyphMapper> Mapper;

    /// Takes over blocks, and the main actor's appearance.
    void Update(const RayTracedBlocks& blocks, vtkActor* main, const std::array<double, 3>& selectionColor);
  };

  /**
   * Makes or drops layers of the view.
   */
  void Resize(std::size_t size, RayTracedParts& parts, vtkPVDataRepresentation* owner, vtkPVRenderView* view);

  Layer& operator[](std::size_t i) { return *this->Layers[i]; }
  auto begin() const { return this->Layers.begin(); }
  auto end() const { return this->Layers.end(); }

private:
  std::vector<std::unique_ptr<Layer>> Layers;
};

} // namespace rtglyphs

#endif
