#include "RayTracedPicker.h"

#include "RayTracedDisplays.h"
#include "RayTracedImages.h"
#include "RayTracedOpenGL.h"
#include "RayTracedRendererState.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRayTracedMapper.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
// Values that a hardware selector reads in place of colors: one number a pixel of one mapper, in one of its passes.
struct IdBuffer
{
  std::vector<std::uint32_t> Values; // RGBA8; 0: the pixel shows something else
  std::vector<float> Depths;         // window depths
  vtkIdType LargestId = 0;
};

// `images` show the same view; the nearest surface counts. Where a glyph or triangle has nothing to select the number
// is opaque black: it hides what lies behind it. See vtkHardwareSelector for the passes and their order.
IdBuffer MakeIds(const std::vector<const rtg::Image*>& images, const rtg::Scene& scene, rtg::Scene::SetId set,
  const glm::dmat4& worldToClip, vtkRayTracedMapper* mapper, vtkHardwareSelector* selector)
{
  const std::size_t width = images.front()->width, height = images.front()->height;
  IdBuffer buffer{ std::vector<std::uint32_t>(width * height, 0), std::vector<float>(width * height, 1.0f) };
  std::uint32_t propValue = 0;
  for (int c = 0; c < 3; ++c)
  {
    propValue |= static_cast<std::uint32_t>(selector->GetPropColorValue()[c] * 255.0f + 0.5f) << (8 * c);
  }
  const int pass = selector->GetCurrentPass();
  const int association = selector->GetFieldAssociation();
  const glm::dmat4 clipToWorld = glm::inverse(worldToClip);
  for (std::size_t i = 0; i < buffer.Values.size(); ++i)
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
      buffer.LargestId = std::max(buffer.LargestId, origin.Id);
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
    buffer.Values[i] = (value & 0xffffff) | 0xff000000u;
    buffer.Depths[i] = nearest->depth[i];
  }
  return buffer;
}
}

//----------------------------------------------------------------------------
// Images of both passes; none where the camera sees nothing.
std::vector<const rtg::Image*> rtglyphs::RayTracedPicker::ImagesWithIds(const rtglyphs::RayTracedDisplays& displays,
  rtglyphs::RayTracedImages& images, vtkRenderer* renderer, int width, int height, const Failed& failed)
{
  std::vector<const rtg::Image*> found;
  rtg::ImageView view;
  try
  {
    view.camera =
      rtglyphs::RayTracedRendererState::CameraOf(renderer, rtglyphs::RayTracedRendererState::WorldToClip(renderer));
  }
  catch (const rtg::Error&)
  {
    return found;
  }
  view.sceneVersion = displays.GetVersion();
  view.settings.width = static_cast<std::uint32_t>(width);
  view.settings.height = static_cast<std::uint32_t>(height);
  for (int pass = 0; pass < rtglyphs::RayTracedImages::Passes; ++pass)
  {
    if (!displays.Shows(pass))
    {
      continue;
    }
    view.pass = static_cast<rtg::Pass>(pass);
    if (rtglyphs::RayTracedImages::Entry* shown = images.FindSame(view))
    {
      found.push_back(&shown->Image.GetImage());
      continue;
    }
    rtglyphs::RayTracedImages::Entry& own =
      images.Get({ pass, view.settings.width, view.settings.height, 0, {}, /*OnlyIds=*/true });
    if (const rtg::Image* image = images.Update(own, view, rtg::ImageEffort(), {}))
    {
      found.push_back(image);
    }
    else
    {
      failed(own.Image);
    }
  }
  return found;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedPicker::PlaceAt(const rtglyphs::RayTracedDisplays& displays, rtglyphs::RayTracedImages& images,
  vtkRenderer* renderer, int x, int y, double place[3], const Failed& failed)
{
  const int* size = renderer ? renderer->GetSize() : nullptr;
  if (!size || x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return false;
  }
  const auto width = static_cast<std::uint32_t>(size[0]), height = static_cast<std::uint32_t>(size[1]);
  const std::size_t pixel = std::size_t(y) * width + x;
  float depth = 1.0f;
  for (const rtg::Image* image : ImagesWithIds(displays, images, renderer, size[0], size[1], failed))
  {
    depth = std::min(depth, image->depth[pixel]);
  }
  if (!(depth < 1.0f))
  {
    return false;
  }
  const glm::dmat4 clipToWorld = glm::inverse(rtglyphs::RayTracedRendererState::WorldToClip(renderer));
  const glm::dvec3 at = rtglyphs::RayTracedRendererState::PlaceOf(pixel, width, height, depth, clipToWorld);
  std::copy_n(&at[0], 3, place);
  return true;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPicker::DrawIds(const rtglyphs::RayTracedDisplays& displays, rtglyphs::RayTracedImages& images,
  vtkRenderer* renderer, vtkActor* actor, vtkRayTracedMapper* mapper, const Failed& failed)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const rtglyphs::RayTracedDisplays::Display* display = displays.Find(mapper);
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (!window || !display || !display->Shown || viewport[2] < 1 || viewport[3] < 1)
  {
    return;
  }
  selector->BeginRenderProp();
  const std::vector<const rtg::Image*> found =
    ImagesWithIds(displays, images, renderer, viewport[2], viewport[3], failed);
  if (!found.empty() && images.GetScene())
  {
    const IdBuffer buffer = MakeIds(found, *images.GetScene(), display->Set,
      rtglyphs::RayTracedRendererState::WorldToClip(renderer), mapper, selector);
    if (selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      selector->UpdateMaximumCellId(buffer.LargestId);
    }
    else
    {
      selector->UpdateMaximumPointId(buffer.LargestId);
    }
    this->Quad.SetImage(
      window, found.front()->width, found.front()->height, buffer.Values.data(), buffer.Depths.data(), 0);
    this->Quad.Draw(renderer, actor, mapper, rtglyphs::RayTracedImageQuad::IDS);
  }
  selector->EndRenderProp();
}
