#include "vtkRayTracedLegend.h"

#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <glm/glm.hpp>

namespace
{
// Extent of ParaView's orientation axes up from the view's lower edge between two of its columns; all in parts of
// the view. 0: none are there.
double TopOfAxes(vtkRenderer* renderer, double left, double right)
{
  double top = 0.0;
  vtkRendererCollection* renderers = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  const double* whole = renderer->GetViewport();
  while (vtkRenderer* other = renderers->GetNextRenderer(at))
  {
    bool hasAxes = false;
    vtkPropCollection* props = other->GetViewProps();
    vtkCollectionSimpleIterator prop;
    props->InitTraversal(prop);
    while (vtkProp* one = props->GetNextProp(prop))
    {
      hasAxes = hasAxes || (one->IsA("vtkPVAxesActor") && one->GetVisibility());
    }
    const double* box = other->GetViewport();
    const auto across = [&](int side) { return (box[side] - whole[0]) / (whole[2] - whole[0]); };
    const auto up = [&](int side) { return (box[side] - whole[1]) / (whole[3] - whole[1]); };
    if (hasAxes && across(0) < right && across(2) > left && up(1) < 0.5)
    {
      top = std::max(top, up(3));
    }
  }
  return top;
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
vtkRayTracedLegend::~vtkRayTracedLegend() = default;

//----------------------------------------------------------------------------
void vtkRayTracedLegend::AddTo(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->AddViewProp(this);
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::RemoveFrom(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->RemoveViewProp(this);
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::SetWords(const char* words, const std::array<double, 3>& color)
{
  this->Text->SetInput(words);
  this->Text->GetTextProperty()->SetColor(color[0], color[1], color[2]);
}

//----------------------------------------------------------------------------
void vtkRayTracedLegend::Arrange(vtkViewport* viewport)
{
  vtkBoundingBox box;
  this->Shows = this->Draw(viewport, box) && box.GetMaxLength() > 0.0;
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
  const bool right = this->Corner == LOWER_RIGHT || this->Corner == UPPER_RIGHT;
  const bool top = this->Corner == UPPER_LEFT || this->Corner == UPPER_RIGHT;
  const double textX = right ? view[0] - margin - words.x : margin;
  const double glyphX = right ? view[0] - margin - glyph.x : margin;
  const double width = std::max(words.x, glyph.x), left = std::min(textX, glyphX);
  const double bottom = top
    ? view[1] - margin - words.y - gap - glyph.y
    : margin + TopOfAxes(vtkRenderer::SafeDownCast(viewport), left / view[0], (left + width) / view[0]) * view[1];
  this->Text->SetPosition(textX, bottom);
  this->Actor->SetPosition(glyphX - lower.x, bottom + words.y + gap - lower.y);
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
