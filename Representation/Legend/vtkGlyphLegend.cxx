#include "vtkGlyphLegend.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
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
using Outline = std::vector<glm::dvec2>;

constexpr int arcPoints = 96;      // of a whole circle
constexpr double leastWidth = 1.5; // pixels; triangles that are thinner may cover no pixel's middle, lines do

// An arc about `center` from angle `first` to `last`.
void AddArc(Outline& outline, glm::dvec2 center, double radius, double first, double last)
{
  const int pieces =
    std::max(1, static_cast<int>(std::ceil(arcPoints * std::abs(last - first) / (2.0 * vtkMath::Pi()))));
  for (int i = 0; i <= pieces; ++i)
  {
    const double angle = first + (last - first) * i / pieces;
    outline.push_back(center + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
}

// Of the head of Kernels/Shapes/ArrowForm.glsl, its tip at `tip` on the x axis: the hull of its base and a circle that
// touches the tip.
Outline HeadProfile(double tip, double length, double radius, double rounding)
{
  const double a = rounding * rounding * radius * length / (radius + std::hypot(radius, length));
  const glm::dvec2 center(tip - a, 0.0);
  const glm::dvec2 corner = glm::dvec2(tip - length, radius) - center;
  const double angle = std::atan2(corner.y, corner.x) - std::acos(std::clamp(a / glm::length(corner), 0.0, 1.0));
  Outline outline{ { tip - length, -radius } };
  AddArc(outline, center, a, -angle, angle);
  outline.emplace_back(tip - length, radius);
  return outline;
}

std::vector<Outline> ArrowProfile(const rtg::ArrowForm& form, double length, double unit)
{
  // Shorter than its head an arrow is the head alone; see ScaleOfArrow() in Kernels/Shapes/ArrowForm.glsl.
  const double head = form.tipLength * unit;
  const double scale = !form.fixedHeads ? length : length > head ? unit : length / form.tipLength;
  const double base = length - form.tipLength * scale;
  std::vector<Outline> outlines;
  if (form.shaftRadius > 0.0f && base > 0.0)
  {
    const double radius = form.shaftRadius * scale;
    outlines.push_back({ { 0.0, -radius }, { base, -radius }, { base, radius }, { 0.0, radius } });
  }
  if (form.tipRadius > 0.0f)
  {
    outlines.push_back(HeadProfile(length, form.tipLength * scale, form.tipRadius * scale, form.tipRounding));
  }
  return outlines;
}

// Four arrows from the middle.
std::vector<Outline> CrossProfile(const rtg::ArrowForm& form, double length)
{
  std::vector<Outline> outlines = ArrowProfile(form, length, length);
  const std::size_t count = outlines.size();
  for (std::size_t i = 0; i < 3 * count; ++i)
  {
    Outline turned = outlines[outlines.size() - count];
    for (glm::dvec2& corner : turned)
    {
      corner = { -corner.y, corner.x };
    }
    outlines.push_back(std::move(turned));
  }
  return outlines;
}

// |x|^r + |y|^s = 1, on rays from the middle, right to a ten-millionth of `half`.
Outline SuperquadricProfile(double r, double s, double half)
{
  Outline outline;
  for (int i = 0; i < 4 * arcPoints; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / (4 * arcPoints);
    const glm::dvec2 direction(std::cos(angle), std::sin(angle));
    double low = 0.0, high = 1.5; // the profile lies in the square [-1, 1]^2
    for (int step = 0; step < 24; ++step)
    {
      const double middle = 0.5 * (low + high);
      const glm::dvec2 p = glm::abs(middle * direction);
      (std::pow(p.x, r) + std::pow(p.y, s) < 1.0 ? low : high) = middle;
    }
    outline.push_back(half * low * direction);
  }
  return outline;
}

Outline Rectangle(glm::dvec2 lower, glm::dvec2 upper)
{
  return { lower, { upper.x, lower.y }, upper, { lower.x, upper.y } };
}

// Seen along z, of the glyph whose unit glyph is `size` large.
std::vector<Outline> ProfileOf(const vtkGlyphSettings& settings, double size, double unit)
{
  const double half = 0.5 * size;
  Outline outline;
  switch (settings.Shape)
  {
    case rtg::Shape::Arrow:
      return settings.Tensors.On ? CrossProfile(settings.Arrow, half) : ArrowProfile(settings.Arrow, size, unit);
    case rtg::Shape::Box:
    case rtg::Shape::Cylinder:
      return { Rectangle(glm::dvec2(-half), glm::dvec2(half)) };
    case rtg::Shape::Cone:
      return { { { -half, -half }, { half, 0.0 }, { -half, half } } };
    case rtg::Shape::Capsule:
      AddArc(outline, { half, 0.0 }, half, -0.5 * vtkMath::Pi(), 0.5 * vtkMath::Pi());
      AddArc(outline, { -half, 0.0 }, half, 0.5 * vtkMath::Pi(), 1.5 * vtkMath::Pi());
      return { outline };
    case rtg::Shape::Mesh:
      if (settings.Mesh && !settings.Mesh->positions.empty())
      {
        return { Rectangle(
          size * glm::dvec2(settings.Mesh->positions.front()), size * glm::dvec2(settings.Mesh->positions.back())) };
      }
      return {};
    case rtg::Shape::Superquadric:
      return { SuperquadricProfile(settings.Exponents[0], settings.Exponents[1], half) };
    case rtg::Shape::NestedSuperquadric:
      if (!settings.Tensors.On)
      {
        // Its cross-section: both exponents are e2 there.
        return { SuperquadricProfile(settings.Exponents[1], settings.Exponents[1], half) };
      }
      [[fallthrough]]; // equal eigenvalues make a ball
    default:
      AddArc(outline, glm::dvec2(0.0), half, 0.0, 2.0 * vtkMath::Pi());
      return { outline };
  }
}
}

//----------------------------------------------------------------------------
vtkGlyphLegend::vtkGlyphLegend()
{
  this->Mapper->SetInputData(this->Profile);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Text->GetTextProperty()->SetFontSize(16);
  this->Text->GetTextProperty()->SetJustificationToLeft();
  this->Text->GetTextProperty()->SetVerticalJustificationToBottom();
  this->PickableOff();
}

//----------------------------------------------------------------------------
vtkGlyphLegend::~vtkGlyphLegend() = default;

//----------------------------------------------------------------------------
void vtkGlyphLegend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "On: " << this->Look.On << endl;
  os << indent << "Value: " << this->Look.Value << endl;
}

//----------------------------------------------------------------------------
void vtkGlyphLegend::SetGlyphs(
  const vtkGlyphSettings& settings, double scale, const std::string& name, double reference)
{
  this->Settings = settings;
  this->Scale = scale;
  this->Name = name;
  this->Reference = reference;
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
  const double extent = std::abs(this->Settings.ScaleFactor) * (scaled ? this->Settings.Sizing(number) : number);
  const double limited = this->Settings.Sizing.Limited(glm::dvec3(extent)).x;
  return scaled && limited != extent ? -limited : limited;
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
      if (pixels > 0.0 && pixels <= most)
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
  const bool alike = this->Name.empty() || this->Settings.Sizing.Function == vtkGlyphSizing::UNIT;
  const bool chosen = this->Look.Value > 0.0 && !alike;
  const double number = alike ? 1.0 : chosen ? this->Look.Value : this->ChooseNumber(perLength, 0.2 * shorter);
  const double extent = std::abs(this->Extent(number)) * this->Scale;
  const double pixels = extent * perLength;
  if (!(pixels > 0.0) || !std::isfinite(pixels) || pixels > 1e6)
  {
    return;
  }
  const double unit = std::abs(this->Settings.ScaleFactor) * this->Scale * this->Reference * perLength;
  const std::vector<Outline> outlines = ProfileOf(this->Settings, pixels, unit);

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles, lines;
  glm::dvec2 lower(HUGE_VAL), upper(-HUGE_VAL);
  for (const Outline& outline : outlines)
  {
    glm::dvec2 middle(0.0);
    glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
    for (const glm::dvec2& p : outline)
    {
      middle += p / static_cast<double>(outline.size());
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    lower = glm::min(lower, low);
    upper = glm::max(upper, high);
    const bool thin = std::min(high.x - low.x, high.y - low.y) < leastWidth;
    const vtkIdType first = points->InsertNextPoint(middle.x, middle.y, 0.0) + 1;
    const auto count = static_cast<vtkIdType>(outline.size());
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->InsertNextPoint(outline[i].x, outline[i].y, 0.0);
      triangles->InsertNextCell({ first - 1, first + i, first + (i + 1) % count });
      if (thin)
      {
        lines->InsertNextCell({ first + i, first + (i + 1) % count });
      }
    }
  }
  if (!(lower.x <= upper.x))
  {
    return;
  }
  this->Profile->SetPoints(points);
  this->Profile->SetPolys(triangles);
  this->Profile->SetLines(lines);

  char text[64];
  std::snprintf(text, sizeof(text), "%.6g", alike ? extent : number);
  std::string label = alike ? text : this->Name + " " + text;
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer->GetActiveCamera()->GetParallelProjection())
  {
    label += "\nat the center of rotation";
  }
  this->Text->SetInput(label.c_str());
  this->Text->GetTextProperty()->SetColor(this->Look.Color.data());
  this->Actor->GetProperty()->SetColor(this->Look.Color.data());

  double words[2];
  this->Text->GetSize(viewport, words);
  const glm::dvec2 glyph = upper - lower;
  const double margin = 0.02 * shorter, gap = 0.5 * margin;
  const bool right = this->Look.Corner == LOWER_RIGHT || this->Look.Corner == UPPER_RIGHT;
  const bool top = this->Look.Corner == UPPER_LEFT || this->Look.Corner == UPPER_RIGHT;
  const double textX = right ? view[0] - margin - words[0] : margin;
  const double glyphX = right ? view[0] - margin - glyph.x : margin;
  const double bottom = top ? view[1] - margin - words[1] - gap - glyph.y : margin;
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
