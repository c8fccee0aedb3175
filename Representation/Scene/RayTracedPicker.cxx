#include "RayTracedPicker.h"

#include "RayTracedContent.h"
#include "RayTracedIdBuffer.h"
#include "RayTracedOpenGL.h"
#include "RayTracedRendererState.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRayTracedMapper.h"
#include "vtkRenderer.h"

#include <algorithm>

//----------------------------------------------------------------------------
// Images of both passes; none where the camera sees nothing.
std::vector<const rtg::Image*> rtglyphs::RayTracedPicker::ImagesWithIds(
  rtglyphs::RayTracedContent& content, vtkRenderer* renderer, int width, int height, const Failed& failed)
{
  std::vector<const rtg::Image*> images;
  rtg::ImageView view;
  try
  {
    view.camera =
      rtglyphs::RayTracedRendererState::CameraOf(renderer, rtglyphs::RayTracedRendererState::WorldToClip(renderer));
  }
  catch (const rtg::Error&)
  {
    return images;
  }
  view.content = content.GetNumber();
  view.settings.width = static_cast<std::uint32_t>(width);
  view.settings.height = static_cast<std::uint32_t>(height);
  for (int pass = 0; pass < rtglyphs::RayTracedImages::Passes; ++pass)
  {
    if (!content.Displays.Shows(pass))
    {
      continue;
    }
    view.pass = static_cast<rtg::Pass>(pass);
    if (rtglyphs::RayTracedImages::Entry* shown = content.Images.FindSame(view))
    {
      images.push_back(&shown->Image.GetImage());
      continue;
    }
    rtglyphs::RayTracedImages::Entry& own =
      content.Images.Get({ pass, view.settings.width, view.settings.height, 0, {}, /*OnlyIds=*/true });
    if (const rtg::Image* image = content.Trace(own, view, rtg::ImageEffort(), {}, renderer))
    {
      images.push_back(image);
    }
    else
    {
      failed(own.Image);
    }
  }
  return images;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedPicker::PlaceAt(
  rtglyphs::RayTracedContent& content, vtkRenderer* renderer, int x, int y, double place[3], const Failed& failed)
{
  const int* size = renderer ? renderer->GetSize() : nullptr;
  if (!size || x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return false;
  }
  const auto width = static_cast<std::uint32_t>(size[0]), height = static_cast<std::uint32_t>(size[1]);
  const std::size_t pixel = std::size_t(y) * width + x;
  float depth = 1.0f;
  for (const rtg::Image* image : ImagesWithIds(content, renderer, size[0], size[1], failed))
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
void rtglyphs::RayTracedPicker::DrawIds(rtglyphs::RayTracedContent& content, vtkRenderer* renderer, vtkActor* actor,
  vtkRayTracedMapper* mapper, const Failed& failed)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const rtglyphs::RayTracedDisplays::Display* display = content.Displays.Find(mapper);
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (!window || !display || !display->Shown || viewport[2] < 1 || viewport[3] < 1)
  {
    return;
  }
  selector->BeginRenderProp();
  const std::vector<const rtg::Image*> images = ImagesWithIds(content, renderer, viewport[2], viewport[3], failed);
  if (!images.empty() && content.Images.GetScene())
  {
    rtglyphs::RayTracedIdBuffer buffer;
    buffer.Fill(images, *content.Images.GetScene(), display->Set,
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
      window, images.front()->width, images.front()->height, buffer.Values.data(), buffer.Depths.data(), 0);
    this->Quad.Draw(renderer, actor, mapper, rtglyphs::RayTracedImageQuad::IDS);
  }
  selector->EndRenderProp();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPicker::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.ReleaseGraphicsResources(window);
}
