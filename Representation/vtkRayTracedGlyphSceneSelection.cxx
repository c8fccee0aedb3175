// How glyphs are picked: see vtkHardwareSelector for the passes and their order.
#include "vtkRayTracedGlyphScene.h"

#include "vtkRayTracedGlyphSceneInternals.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkRenderer.h"

using namespace vtkRayTracedGlyphSceneDetail;

//----------------------------------------------------------------------------
// Draws a number in the place of each of the actor's pixels, 24 bits of it, as a hardware selector asks for.
void vtkRayTracedGlyphScene::DrawIds(vtkActor* actor, vtkRayTracedGlyphMapper* mapper)
{
  Internals& self = *this->Self;
  vtkHardwareSelector* selector = this->Renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  const auto member = self.Members.find(mapper);
  // A glyph stands for a point and has no cell to select; a surface is selected by cells.
  const int association = mapper->PicksCells() ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                               : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  if (!window || member == self.Members.end() || selector->GetFieldAssociation() != association)
  {
    return;
  }
  selector->BeginRenderProp();
  std::array<const rtg::Image*, passes> images{};
  std::size_t pixels = 0;
  for (int pass = 0; pass < passes; ++pass)
  {
    if (this->UpdateImage(pass, /*forIds=*/true))
    {
      images[pass] = &self.Images[pass].Image;
      pixels = std::size_t(images[pass]->width) * images[pass]->height;
    }
  }

  std::vector<std::uint32_t> values(pixels, 0);
  std::vector<float> depths(pixels, 1.0f);
  vtkIdType maximum = 0;
  const int currentPass = selector->GetCurrentPass();
  std::uint32_t propValue = 0;
  for (int c = 0; c < 3; ++c)
  {
    propValue |= static_cast<std::uint32_t>(selector->GetPropColorValue()[c] * 255.0f + 0.5f)
      << (8 * c);
  }
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const rtg::Image* nearest = nullptr;
    for (const rtg::Image* image : images)
    {
      if (image && image->glyphIds[i] != rtg::Image::noGlyph &&
        (!nearest || image->depth[i] < nearest->depth[i]))
      {
        nearest = image;
      }
    }
    if (!nearest || nearest->setIds[i] != member->second.Set)
    {
      continue;
    }
    const vtkRayTracedGlyphMapper::Origin origin =
      mapper->OriginOf(self.Scene->OriginalGlyph(member->second.Set, nearest->glyphIds[i]));
    maximum = std::max(maximum, origin.Id);
    std::uint32_t value = 0;
    switch (currentPass)
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
    values[i] = (value & 0xffffff) | 0xff000000u;
    depths[i] = nearest->depth[i];
  }
  if (mapper->PicksCells())
  {
    selector->UpdateMaximumCellId(maximum);
  }
  else
  {
    selector->UpdateMaximumPointId(maximum);
  }
  if (pixels > 0)
  {
    const rtg::Image* any = images[0] ? images[0] : images[1];
    self.IdQuad.SetImage(window, any->width, any->height, values.data(), depths.data());
    self.IdQuad.Draw(this->Renderer, actor, mapper, vtkRayTracedImageQuad::IDS);
  }
  selector->EndRenderProp();
}
