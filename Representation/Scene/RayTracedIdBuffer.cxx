#include "RayTracedIdBuffer.h"

#include "RayTracedRendererState.h"
#include "vtkHardwareSelector.h"
#include "vtkRayTracedMapper.h"

#include <algorithm>

//----------------------------------------------------------------------------
// See vtkHardwareSelector for the passes and their order.
void rtglyphs::RayTracedIdBuffer::Fill(const std::vector<const rtg::Image*>& images, const rtg::Scene& scene,
  rtg::Scene::SetId set, const glm::dmat4& worldToClip, vtkRayTracedMapper* mapper, vtkHardwareSelector* selector)
{
  const std::size_t width = images.front()->width, height = images.front()->height;
  this->Values.assign(width * height, 0);
  this->Depths.assign(width * height, 1.0f);
  this->LargestId = 0;
  std::uint32_t propValue = 0;
  for (int c = 0; c < 3; ++c)
  {
    propValue |= static_cast<std::uint32_t>(selector->GetPropColorValue()[c] * 255.0f + 0.5f) << (8 * c);
  }
  const int pass = selector->GetCurrentPass();
  const int association = selector->GetFieldAssociation();
  const glm::dmat4 clipToWorld = glm::inverse(worldToClip);
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const rtg::Image* nearest = nullptr;
    for (const rtg::Image* image : images)
    {
      if (image->glyphIds[i] != rtg::Image::noGlyph && (!nearest || image->depth[i] < nearest->depth[i]))
      {
        nearest = image;
      }
    }
    if (!nearest || nearest->setIds[i] != set)
    {
      continue;
    }
    const glm::dvec3 position =
      rtglyphs::RayTracedRendererState::PlaceOf(i, nearest->width, nearest->height, nearest->depth[i], clipToWorld);
    const vtkRayTracedMapper::Origin origin =
      mapper->OriginOf(scene.OriginalGlyph(set, nearest->glyphIds[i]), association, &position[0]);
    std::uint32_t value = 0;
    if (origin.Id >= 0)
    {
      this->LargestId = std::max(this->LargestId, origin.Id);
      switch (pass)
      {
        case vtkHardwareSelector::ACTOR_PASS:
          value = propValue;
          break;
        case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
          value = origin.CompositeIndex;
          break;
        case vtkHardwareSelector::POINT_ID_LOW24:
        case vtkHardwareSelector::CELL_ID_LOW24:
          value = static_cast<std::uint32_t>(origin.Id & 0xffffff);
          break;
        case vtkHardwareSelector::POINT_ID_HIGH24:
        case vtkHardwareSelector::CELL_ID_HIGH24:
          value = static_cast<std::uint32_t>((origin.Id >> 24) & 0xffffff);
          break;
        case vtkHardwareSelector::PROCESS_PASS:
          // One more than the rank: zero means that nothing was hit.
          value = static_cast<std::uint32_t>(
            (origin.Process >= 0 ? origin.Process : std::max(selector->GetProcessID(), 0)) + 1);
          break;
        default:
          break;
      }
    }
    this->Values[i] = (value & 0xffffff) | 0xff000000u;
    this->Depths[i] = nearest->depth[i];
  }
}
