#include "vtkGlyphLegend.h"

#include "GlyphMaker.h"
#include "GlyphTessellatedSet.h"
#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkGlyphLegend);

namespace
{
constexpr double leastWidth = 1.5; // pixels; triangles that are thinner may cover no pixel's middle, lines do

// Copies of meshes, seen along z.
void AddSilhouette(const rtglyphs::GlyphTessellatedPart& part, vtkPoints* points, vtkCellArray* triangles,
  vtkCellArray* lines, vtkBoundingBox& box)
{
  for (std::size_t copy = 0; copy < part.Positions.size(); ++copy)
  {
    const glm::vec4& turn = part.Orientations[copy];
    const vtkIdType first = points->GetNumberOfPoints();
    vtkBoundingBox own;
    for (const glm::vec3& corner : part.Mesh->positions)
    {
      const glm::dvec3 p = glm::dquat(turn.w, turn.x, turn.y, turn.z) * glm::dvec3(part.Scales[copy] * corner) +
        glm::dvec3(part.Positions[copy]);
      points->InsertNextPoint(p.x, p.y, 0.0);
      own.AddPoint(p.x, p.y, 0.0);
    }
    const bool thin = std::min(own.GetLength(0), own.GetLength(1)) < leastWidth;
    for (const glm::uvec3& triangle : part.Mesh->triangles)
    {
      const vtkIdType a = first + triangle.x, b = first + triangle.y, c = first + triangle.z;
      triangles->InsertNextCell({ a, b, c });
      if (thin)
      {
        lines->InsertNextCell({ a, b, c, a });
      }
    }
    box.AddBox(own);
  }
}

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
vtkGlyphLegend::vtkGlyphLegend()
{
  this->Mapper->SetInputData(this->Silhouette);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetTextProperty()->SetFontSize(16);
  this->Text->GetTextProperty()->SetJustificationToLeft();
  this->Text->GetTextProperty()->SetVerticalJustificationToBottom();
  this->PickableOff();
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::SetGlyphs(const rtglyphs::GlyphSettings& settings, double scale, const std::string& name,
  const std::array<double, 2>& mesh, double largest)
{
  this->Largest = largest;
  this->Settings = settings;
  this->Scale = scale;
  this->Name = name;
  this->Mesh = mesh;
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::SetStyle(const Style& style)
{
  this->Look = style;
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::AddTo(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->AddViewProp(this);
  vtkActorCollection* actors = view->GetRenderer()->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    if (actor->IsA("vtkPVCenterAxesActor"))
    {
      this->Center = actor;
    }
  }
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::RemoveFrom(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->RemoveViewProp(this);
  this->Center = nullptr;
}

//----------------------------------------------------------------------------
double vtkGlyphLegend::Extent(double number) const
{
  const bool scaled = !this->Name.empty();
  const double magnitude = scaled ? this->Settings.Sizing(number) : number, extent = this->Settings.Length(magnitude);
  return scaled && extent != std::abs(this->Settings.ScaleFactor) * magnitude ? -extent : extent;
}

//----------------------------------------------------------------------------
// One upright glyph whose unit glyph is `size` large, in pixels, or of crosses four arrows; tensors and polynomials of
// equal values are balls.
rtg::GlyphInstances vtkGlyphLegend::MakeGlyphs(double size, double unit) const
{
  const rtglyphs::GlyphSettings& settings = this->Settings;
  rtg::GlyphInstances glyphs;
  glyphs.shape = settings.Shape;
  glyphs.arrow = settings.Arrow;
  glyphs.arrow.unitLength = static_cast<float>(unit);
  glyphs.uniformSize = static_cast<float>(size);
  glyphs.centres.resize(1);
  if (settings.Shape == rtg::Shape::Mesh)
  {
    glyphs.shape = rtg::Shape::Box;
    glyphs.sizes3 = { glm::vec3(size * this->Mesh[0], size * this->Mesh[1], size) };
  }
  else if (settings.Tensors.Parts() > 1)
  {
    const auto half = static_cast<float>(std::sqrt(0.5));
    glyphs.uniformSize *= 0.5f;
    glyphs.rotations = { { 0, 0, 0, 1 }, { 0, 0, half, half }, { 0, 0, 1, 0 }, { 0, 0, -half, half } };
    glyphs.centres.resize(glyphs.rotations.size());
  }
  else if (settings.Tensors.On || settings.Forms.On)
  {
    glyphs.shape = rtg::Shape::Sphere;
  }
  else if (settings.HasOwnExponents() &&
    !rtglyphs::GlyphMaker::MakeExponents(settings.Shape, settings.Exponents, 3, glyphs.uniformExponents))
  {
    glyphs.centres.clear();
  }
  return glyphs;
}

//----------------------------------------------------------------------------
double vtkGlyphLegend::PixelsPerLength(vtkViewport* viewport) const
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  vtkCamera* camera = renderer ? renderer->GetActiveCamera() : nullptr;
  if (!camera)
  {
    return 0.0;
  }
  // Of a picture larger than the window each tile has the window's size and a camera for it alone
  // (vtkWindowToImageFilter).
  const int* whole = viewport->GetSize();
  const int* tiles = viewport->GetVTKWindow()->GetTileScale();
  const glm::dvec2 size = glm::dvec2(whole[0], whole[1]) / glm::dvec2(tiles[0], tiles[1]);
  if (camera->GetParallelProjection())
  {
    return 0.5 * size.y / camera->GetParallelScale();
  }
  glm::dvec3 eye, axis, center;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&axis.x);
  camera->GetFocalPoint(&center.x);
  if (this->Center)
  {
    this->Center->GetPosition(&center.x);
  }
  const double depth = glm::dot(center - eye, axis);
  const double halfAngle = 0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  const double side = camera->GetUseHorizontalViewAngle() ? size.x : size.y;
  return depth > 0.0 ? 0.5 * side / (depth * std::tan(halfAngle)) : 0.0;
}

//----------------------------------------------------------------------------
// 0: none fits.
double vtkGlyphLegend::ChooseNumber(double pixelsPerLength, double most) const
{
  for (int exponent = 30; exponent >= -30; --exponent)
  {
    for (const double digit : { 5.0, 2.0, 1.0 })
    {
      const double number = digit * std::pow(10.0, exponent);
      const double pixels = this->Extent(number) * this->Scale * pixelsPerLength;
      const bool reached = !(this->Largest > 0.0) || this->Settings.Sizing(number) <= (1.0 + 1e-6) * this->Largest;
      if (pixels > 0.0 && pixels <= most && reached)
      {
        return number;
      }
    }
  }
  return 0.0;
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::Arrange(vtkViewport* viewport)
{
  this->Shows = false;
  if (!this->Look.On)
  {
    return;
  }
  const int* view = viewport->GetSize();
  const double perLength = this->PixelsPerLength(viewport);
  const double shorter = std::min(view[0], view[1]);
  // All glyphs are alike where nothing scales them; the number is their size.
  const bool alike = this->Name.empty() || this->Settings.Sizing.Function == rtglyphs::GlyphSizing::UNIT;
  const bool chosen = this->Look.Value > 0.0 && !alike;
  const double number = alike ? 1.0 : chosen ? this->Look.Value : this->ChooseNumber(perLength, 0.2 * shorter);
  const double extent = std::abs(this->Extent(number)) * this->Scale;
  const double pixels = extent * perLength;
  if (!(pixels > 0.0) || !std::isfinite(pixels) || pixels > 1e6)
  {
    return;
  }
  const double unit = std::abs(this->Settings.ScaleFactor) * this->Settings.ReferenceScale() * this->Scale * perLength;
  std::vector<std::string> unused;
  const rtglyphs::GlyphTessellatedSet set =
    rtglyphs::GlyphTessellatedSet::Make("", this->MakeGlyphs(pixels, unit), {}, {}, unused);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles, lines;
  vtkBoundingBox box;
  for (const rtglyphs::GlyphTessellatedPart& part : set.Parts)
  {
    AddSilhouette(part, points, triangles, lines, box);
  }
  if (!(box.GetMaxLength() > 0.0))
  {
    return;
  }
  this->Silhouette->SetPoints(points);
  this->Silhouette->SetPolys(triangles);
  this->Silhouette->SetLines(lines);

  char text[64];
  std::snprintf(text, sizeof(text), "%.6g", alike ? extent : number);
  this->Text->SetInput((alike ? text : this->Name + " " + text).c_str());
  this->Text->GetTextProperty()->SetColor(this->Look.Color.data());
  this->Actor->GetProperty()->SetColor(this->Look.Color.data());

  // In a picture of tiles words grow as all else does.
  const int* tiles = viewport->GetVTKWindow()->GetTileScale();
  double words[2];
  this->Text->GetSize(viewport, words);
  words[0] *= tiles[0];
  words[1] *= tiles[1];
  const glm::dvec2 lower(box.GetBound(0), box.GetBound(2)), glyph(box.GetLength(0), box.GetLength(1));
  const double margin = 0.02 * shorter, gap = 0.5 * margin;
  const bool right = this->Look.Corner == LOWER_RIGHT || this->Look.Corner == UPPER_RIGHT;
  const bool top = this->Look.Corner == UPPER_LEFT || this->Look.Corner == UPPER_RIGHT;
  const double textX = right ? view[0] - margin - words[0] : margin;
  const double glyphX = right ? view[0] - margin - glyph.x : margin;
  const double width = std::max(words[0], glyph.x), left = std::min(textX, glyphX);
  const double bottom = top
    ? view[1] - margin - words[1] - gap - glyph.y
    : margin + TopOfAxes(vtkRenderer::SafeDownCast(viewport), left / view[0], (left + width) / view[0]) * view[1];
  this->Text->SetPosition(textX, bottom);
  this->Actor->SetPosition(glyphX - lower.x, bottom + words[1] + gap - lower.y);
  this->Shows = true;
}

//----------------------------------------------------------------------------
int vtkGlyphLegend::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->Arrange(viewport);
  return this->Shows ? this->Text->RenderOpaqueGeometry(viewport) + this->Actor->RenderOpaqueGeometry(viewport) : 0;
}

//----------------------------------------------------------------------------
int vtkGlyphLegend::RenderOverlay(vtkViewport* viewport)
{
  return this->Shows ? this->Actor->RenderOverlay(viewport) + this->Text->RenderOverlay(viewport) : 0;
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Actor->ReleaseGraphicsResources(window);
  this->Text->ReleaseGraphicsResources(window);
}
