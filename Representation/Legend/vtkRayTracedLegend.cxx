#include "vtkRayTracedLegend.h"

#include "vtkBorderRepresentation.h"
#include "vtkBoundingBox.h"
#include "vtkCollectionRange.h"
#include "vtkContext2DScalarBarActor.h"
#include "vtkCoordinate.h"
#include "vtkPVRenderView.h"
#include "vtkPropCollection.h"
#include "vtkProperty2D.h"
#include "vtkRect.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkScalarBarRepresentation.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>

namespace
{
template <typename F>
void ForEachVisibleProp(vtkRenderer* renderer, F&& visit)
{
  for (vtkObject* item : vtk::Range(renderer->GetViewProps()))
  {
    if (auto* prop = static_cast<vtkProp*>(item); prop->GetVisibility())
    {
      visit(prop);
    }
  }
}

// Where vtkPVScalarBarRepresentation will draw it.
vtkRayTracedLegend::Box BoxOf(vtkScalarBarRepresentation* bar, vtkContext2DScalarBarActor* actor, vtkRenderer* renderer)
{
  constexpr double margin = 4.0;
  actor->RenderOpaqueGeometry(renderer); // tells it the viewport
  const vtkRectf drawn = actor->GetBoundingRect();
  const glm::dvec2 view(renderer->GetSize()[0], renderer->GetSize()[1]), size(drawn.GetWidth(), drawn.GetHeight());
  const glm::dvec2 middle = 0.5 * (view - size), high = view - 1.0 - size - margin;
  glm::dvec2 lower(margin);
  switch (bar->GetWindowLocation())
  {
    case vtkBorderRepresentation::AnyLocation:
    {
      const int* origin = bar->GetPositionCoordinate()->GetComputedViewportValue(renderer);
      lower = glm::dvec2(origin[0] + drawn.GetX(), origin[1] + drawn.GetY());
      break;
    }
    case vtkBorderRepresentation::LowerRightCorner:
      lower.x = high.x;
      break;
    case vtkBorderRepresentation::LowerCenter:
      lower.x = middle.x;
      break;
    case vtkBorderRepresentation::UpperLeftCorner:
      lower.y = high.y;
      break;
    case vtkBorderRepresentation::UpperRightCorner:
      lower = high;
      break;
    case vtkBorderRepresentation::UpperCenter:
      lower = { middle.x, high.y };
      break;
    default:
      break;
  }
  return { lower, lower + size };
}
}

//----------------------------------------------------------------------------
vtkRayTracedLegend::vtkRayTracedLegend()
{
  this->Mapper->SetInputData(this->Drawing);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetTextProperty()->SetFontSize(16);
  this->Text->GetTextProperty()->SetJustificationToLeft();
  this->Text->GetTextProperty()->SetVerticalJustificationToBottom();
  this->PickableOff();
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::AddTo(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->AddViewProp(this);
  this->Scene = view->GetRenderer();
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::RemoveFrom(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->RemoveViewProp(this);
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::SetWords(const char* words)
{
  const bool top = this->Place == UPPER_LEFT || this->Place == UPPER_RIGHT;
  const double* behind =
    top && this->Scene->GetGradientBackground() ? this->Scene->GetBackground2() : this->Scene->GetBackground();
  const double ink = 0.3 * behind[0] + 0.6 * behind[1] + 0.1 * behind[2] > 0.5 ? 0.0 : 1.0;
  this->Text->SetInput(words);
  this->Text->GetTextProperty()->SetColor(ink, ink, ink);
  this->Actor->GetProperty()->SetColor(ink, ink, ink);
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::Arrange(vtkViewport* viewport)
{
  vtkBoundingBox box;
  this->Shows = this->IsOn() && this->Draw(viewport, box) && box.GetMaxLength() > 0.0;
  if (!this->Shows)
  {
    return;
  }
  const int* view = viewport->GetSize();
  // In a picture of tiles words grow as all else does.
  const int* tiles = viewport->GetVTKWindow()->GetTileScale();
  int extent[4] = { 0, -1, 0, -1 };
  if (this->Text->GetInput() && this->Text->GetInput()[0])
  {
    // vtkTextActor returns the size of what it has drawn last.
    vtkTextRenderer::GetInstance()->GetBoundingBox(
      this->Text->GetTextProperty(), this->Text->GetInput(), extent, viewport->GetVTKWindow()->GetDPI());
  }
  const glm::dvec2 words((extent[1] - extent[0] + 1) * tiles[0], (extent[3] - extent[2] + 1) * tiles[1]);
  const glm::dvec2 lower(box.GetBound(0), box.GetBound(2)), glyph(box.GetLength(0), box.GetLength(1));
  const double margin = 0.02 * std::min(view[0], view[1]), gap = 0.5 * margin;
  const bool right = this->Place == LOWER_RIGHT || this->Place == UPPER_RIGHT;
  const bool top = this->Place == UPPER_LEFT || this->Place == UPPER_RIGHT;
  const glm::dvec2 size(std::max(words.x, glyph.x), words.y + gap + glyph.y);
  const glm::dvec2 corner(right ? view[0] - margin - size.x : margin, top ? view[1] - margin - size.y : margin);
  const glm::dvec2 place = this->FindPlace(vtkRenderer::SafeDownCast(viewport), { corner, corner + size }, margin);
  this->Covered = { place, place + size };
  this->Text->SetPosition(place.x + (right ? size.x - words.x : 0.0), place.y);
  this->Actor->SetPosition(place.x + (right ? size.x - glyph.x : 0.0) - lower.x, place.y + words.y + gap - lower.y);
}

//----------------------------------------------------------------------------
// Orientation axes and the like have renderers of their own, which cover a part of the view.
std::vector<vtkRayTracedLegend::Box> vtkRayTracedLegend::Obstacles(vtkRenderer* renderer) const
{
  std::vector<Box> boxes;
  const glm::dvec2 view(renderer->GetSize()[0], renderer->GetSize()[1]);
  const glm::dvec4 whole = glm::make_vec4(renderer->GetViewport());
  for (vtkRenderer* other : vtk::Range(renderer->GetRenderWindow()->GetRenderers()))
  {
    const glm::dvec4 part = glm::make_vec4(other->GetViewport());
    bool shows = false;
    ForEachVisibleProp(other, [&](vtkProp*) { shows = true; });
    if (shows && part != whole)
    {
      const glm::dvec2 origin(whole), scale = view / (glm::dvec2(whole.z, whole.w) - origin);
      boxes.push_back({ scale * (glm::dvec2(part) - origin), scale * (glm::dvec2(part.z, part.w) - origin) });
    }
  }
  // Legends are arranged in this order.
  bool before = true;
  ForEachVisibleProp(renderer,
    [&](vtkProp* prop)
    {
      before = before && prop != this;
      auto* legend = before ? dynamic_cast<vtkRayTracedLegend*>(prop) : nullptr;
      auto* bar = vtkScalarBarRepresentation::SafeDownCast(prop);
      auto* drawn = bar ? vtkContext2DScalarBarActor::SafeDownCast(bar->GetScalarBarActor()) : nullptr;
      if (legend && legend->Shows)
      {
        boxes.push_back(legend->Covered);
      }
      else if (drawn)
      {
        boxes.push_back(BoxOf(bar, drawn, renderer));
      }
    });
  return boxes;
}

//----------------------------------------------------------------------------
// The nearest place in the view that covers nothing, first in the same column; without any the wanted one.
glm::dvec2 vtkRayTracedLegend::FindPlace(vtkRenderer* renderer, const Box& wanted, double margin) const
{
  const std::vector<Box> obstacles = this->Obstacles(renderer);
  const glm::dvec2 view(renderer->GetSize()[0], renderer->GetSize()[1]), size = wanted[1] - wanted[0];
  std::vector<glm::dvec2> places{ wanted[0] };
  for (const Box& across : obstacles)
  {
    for (const Box& along : obstacles)
    {
      for (const double x : { wanted[0].x, across[1].x + margin, across[0].x - margin - size.x })
      {
        for (const double y : { wanted[0].y, along[1].y + margin, along[0].y - margin - size.y })
        {
          places.emplace_back(std::round(x), std::round(y));
        }
      }
    }
  }
  const auto isFree = [&](const glm::dvec2& place)
  {
    return glm::all(glm::greaterThanEqual(place, glm::dvec2(0.0))) &&
      glm::all(glm::lessThanEqual(place + size, view)) &&
      std::none_of(obstacles.begin(), obstacles.end(),
        [&](const Box& box)
        { return glm::all(glm::lessThan(place, box[1])) && glm::all(glm::lessThan(box[0], place + size)); });
  };
  std::erase_if(places, [&](const glm::dvec2& place) { return !isFree(place); });
  const auto isNearer = [&](const glm::dvec2& a, const glm::dvec2& b)
  {
    const glm::dvec2 toA = glm::abs(a - wanted[0]), toB = glm::abs(b - wanted[0]);
    return std::tie(toA.x, toA.y) < std::tie(toB.x, toB.y);
  };
  return places.empty() ? wanted[0] : *std::min_element(places.begin(), places.end(), isNearer);
}

//----------------------------------------------------------------------------
int vtkRayTracedLegend::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->Arrange(viewport);
  return this->Shows ? this->Text->RenderOpaqueGeometry(viewport) + this->Actor->RenderOpaqueGeometry(viewport) : 0;
}

//----------------------------------------------------------------------------
int vtkRayTracedLegend::RenderOverlay(vtkViewport* viewport)
{
  return this->Shows ? this->Actor->RenderOverlay(viewport) + this->Text->RenderOverlay(viewport) : 0;
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Actor->ReleaseGraphicsResources(window);
  this->Text->ReleaseGraphicsResources(window);
}
