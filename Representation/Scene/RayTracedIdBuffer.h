/**
 * What a hardware selector reads in the place of colors: one number a pixel of one mapper, in one of its passes.
 */
#ifndef RayTracedIdBuffer_h
#define RayTracedIdBuffer_h

#include "Scene.h"
#include "Tracer.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkHardwareSelector;
class vtkRayTracedMapper;

namespace rtglyphs
{

struct RayTracedIdBuffer
{
  std::vector<std::uint32_t> Values; // RGBA8; 0: the pixel shows something else
  std::vector<float> Depths;         // window depths
  vtkIdType LargestId = 0;

  /**
   * `images` show the same view; the nearest surface counts. Where a glyph or triangle has nothing to select the number
   * is opaque black: it hides what lies behind it.
   */
  void Fill(const std::vector<const rtg::Image*>& images, const rtg::Scene& scene, rtg::Scene::SetId set,
    const glm::dmat4& worldToClip, vtkRayTracedMapper* mapper, vtkHardwareSelector* selector);
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedIdBuffer.h
