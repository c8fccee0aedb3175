#include "vtkGlyphLegend.h"

#include "GlyphMaker.h"
#include "GlyphTessellatedSet.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCollectionRange.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
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
double vtkGlyphLegend::Extent(double number) const
{
  const bool scaled = !this->Name.empty();
  const double magnitude = scaled ? this->Settings.MagnitudeOf(number) : number,
               extent = this->Settings.Length(magnitude);
  return scaled && extent != std::abs(this->Settings.ScaleFactor) * magnitude ? -extent : extent;
}

//----------------------------------------------------------------------------
// One upright glyph that is `size` large, in pixels, or of crosses four arrows, of split vectors the number's cylinders
// along x; tensors and polynomials of equal values are balls.
rtg::GlyphInstances vtkGlyphLegend::MakeGlyphs(double number, double size, double unit) const
{
  const rtglyphs::GlyphSettings& settings = this->Settings;
  rtg::GlyphInstances glyphs;
  glyphs.shape = settings.Shape;
  glyphs.arrow = settings.Arrow;
  glyphs.arrow.unitLength = static_cast<float>(unit);
  glyphs.uniformSize = static_cast<float>(size);
  glyphs.centers.resize(1);
  if (settings.Shape == rtg::Shape::Mesh)
  {
    glyphs.shape = rtg::Shape::Box;
    glyphs.sizes3 = { glm::vec3(size * this->Mesh[0], size * this->Mesh[1], size) };
  }
  else if (settings.Frame == rtglyphs::GlyphFrame::Split)
  {
    const auto half = static_cast<float>(std::sqrt(0.5));
    glyphs.centers.clear();
    for (int part = 0; part < settings.Parts(); ++part)
    {
      const rtglyphs::GlyphSettings::Cylinder cylinder = settings.CylinderOf(number, part);
      if (cylinder.Length() > 0.0)
      {
        glyphs.centers.emplace_back(0.5 * (cylinder.Begin + cylinder.End) * unit, 0.0, 0.0);
        glyphs.sizes3.emplace_back(unit * glm::dvec3(2.0 * cylinder.Radius, cylinder.Length(), 2.0 * cylinder.Radius));
        glyphs.rotations.emplace_back(0.0f, 0.0f, -half, half);
      }
    }
  }
  else if (settings.Frame == rtglyphs::GlyphFrame::Cross)
  {
    const auto half = static_cast<float>(std::sqrt(0.5));
    glyphs.uniformSize *= 0.5f;
    glyphs.rotations = { { 0, 0, 0, 1 }, { 0, 0, half, half }, { 0, 0, 1, 0 }, { 0, 0, -half, half } };
    glyphs.centers.resize(glyphs.rotations.size());
  }
  else if (settings.Tensors.On || settings.Forms.On)
  {
    glyphs.shape = rtg::Shape::Sphere;
  }
  else if (settings.HasOwnExponents() &&
    !rtglyphs::GlyphMaker::MakeExponents(settings.Shape, settings.Exponents, 3, glyphs.uniformExponents))
  {
    glyphs.centers.clear();
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
  for (vtkObject* actor : vtk::Range(this->Scene->GetActors()))
  {
    if (actor->IsA("vtkPVCenterAxesActor")) // what ParaView shows at the center of rotation
    {
      static_cast<vtkActor*>(actor)->GetPosition(&center.x);
    }
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
      const double reach =
        this->Settings.Frame == rtglyphs::GlyphFrame::Split ? number : this->Settings.MagnitudeOf(number);
      const bool reached = !(this->Largest > 0.0) || reach <= (1.0 + 1e-6) * this->Largest;
      if (pixels > 0.0 && pixels <= most && reached)
      {
        return number;
      }
    }
  }
  return 0.0;
}

//----------------------------------------------------------------------------
bool vtkGlyphLegend::Draw(vtkViewport* viewport, vtkBoundingBox& box)
{
  const int* view = viewport->GetSize();
  const double perLength = this->PixelsPerLength(viewport);
  const double shorter = std::min(view[0], view[1]);
  // All glyphs are alike where nothing scales them; the number is their size.
  const bool alike = this->Name.empty() || this->Settings.Sizing.Function == rtglyphs::GlyphSizing::UNIT;
  const bool chosen = this->Value > 0.0 && !alike;
  const double number = alike ? 1.0 : chosen ? this->Value : this->ChooseNumber(perLength, 0.2 * shorter);
  const double extent = std::abs(this->Extent(number)) * this->Scale;
  const double pixels = extent * perLength;
  if (!(pixels > 0.0) || !std::isfinite(pixels) || pixels > 1e6)
  {
    return false;
  }
  const double unit = std::abs(this->Settings.ScaleFactor) * this->Settings.ReferenceScale() * this->Scale * perLength;
  std::vector<std::string> unused;
  const rtglyphs::GlyphTessellatedSet set =
    rtglyphs::GlyphTessellatedSet::Make("", this->MakeGlyphs(number, pixels, unit), {}, {}, unused);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles, lines;
  for (const rtglyphs::GlyphTessellatedPart& part : set.Parts)
  {
    AddSilhouette(part, points, triangles, lines, box);
  }
  this->Drawing->SetPoints(points);
  this->Drawing->SetPolys(triangles);
  this->Drawing->SetLines(lines);

  char text[64];
  const rtglyphs::SplitNumber split(number);
  if (this->Settings.Frame == rtglyphs::GlyphFrame::Split)
  {
    std::snprintf(text, sizeof(text), "%.6ge%d", split.Digit, split.Power);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.6g", alike ? extent : number);
  }
  this->SetWords((alike ? text : this->Name + " " + text).c_str());
  return true;
}
