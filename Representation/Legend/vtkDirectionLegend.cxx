#include "vtkDirectionLegend.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkViewport.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkDirectionLegend);

namespace
{
constexpr int rings = 30, spokes = 120; // 3 degrees apart: colors between them are linear to half a level
constexpr double diameter = 0.12;       // of the view's shorter side
}

//----------------------------------------------------------------------------
bool vtkDirectionLegend::Draw(vtkViewport* viewport, vtkBoundingBox& box)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  vtkCamera* camera = renderer ? renderer->GetActiveCamera() : nullptr;
  if (this->Coloring == rtglyphs::DirectionColors::NONE || !camera)
  {
    return false;
  }
  const bool signs = this->Coloring == rtglyphs::DirectionColors::SPHERE;
  const int* view = viewport->GetSize();
  const double radius = 0.5 * diameter * std::min(view[0], view[1]);
  const vtkMatrix4x4* toView = camera->GetViewTransformMatrix();
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> quads;
  for (int side = 0; side < (signs ? 2 : 1); ++side)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int i = 0; i <= rings * spokes + spokes - 1; ++i)
    {
      const double fromAxis = 0.5 * 3.141592653589793 * (i / spokes) / rings;
      const double around = 2.0 * 3.141592653589793 * (i % spokes) / spokes;
      const double seen[] = { std::sin(fromAxis) * std::cos(around), std::sin(fromAxis) * std::sin(around),
        side == 0 ? std::cos(fromAxis) : -std::cos(fromAxis) };
      glm::dvec3 direction(0.0);
      for (int k = 0; k < 3; ++k)
      {
        direction += seen[k] * glm::dvec3(toView->GetElement(k, 0), toView->GetElement(k, 1), toView->GetElement(k, 2));
      }
      points->InsertNextPoint(radius * (seen[0] + 2.2 * side), radius * seen[1], 0.0);
      for (const double level : rtglyphs::DirectionColors::Of(direction, this->Coloring))
      {
        colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * level)));
      }
    }
    for (int i = 0; i < rings * spokes; ++i)
    {
      const vtkIdType a = first + i, b = (i + 1) % spokes == 0 ? a + 1 - spokes : a + 1;
      quads->InsertNextCell({ a, b, b + spokes, a + spokes });
    }
  }
  this->Drawing->SetPoints(points);
  this->Drawing->SetPolys(quads);
  this->Drawing->GetPointData()->SetScalars(colors);
  box.AddPoint(-radius, -radius, 0.0);
  box.AddPoint((signs ? 3.2 : 1.0) * radius, radius, 0.0);

  this->SetWords(signs ? "front, back" : "");
  return true;
}
