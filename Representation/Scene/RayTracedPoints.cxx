#include "RayTracedPoints.h"

#include "RayTracedDisplays.h"
#include "RayTracedImages.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/packing.hpp>

#include <vector>

namespace
{
constexpr std::size_t mostPoints = 200000; // of a display
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedPoints::RayTracedPoints()
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->EmissiveOff();
  mapper->SetScaleFactor(0.0); // plain points
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->LightingOff();
  this->Actor->GetProperty()->SetPointSize(3.0f);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPoints::Draw(
  const rtglyphs::RayTracedDisplays& displays, rtglyphs::RayTracedImages& images, vtkRenderer* renderer, vtkActor* as)
{
  if (this->Version != displays.GetVersion())
  {
    this->Version = displays.GetVersion();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    std::vector<rtg::GlyphInstances> built;
    for (const rtglyphs::RayTracedNeighbors::Shown& shown : displays.GetShown(images, built))
    {
      const rtg::GlyphInstances& glyphs = *shown.Instances;
      const std::vector<std::uint32_t>& each = shown.Colors->each;
      const std::uint32_t plain = glm::packUnorm4x8(glm::vec4(displays.GetAll()[shown.Display].Material.color, 1.0f));
      const bool surface = glyphs.identifyTriangles && glyphs.mesh && glyphs.Count() == 1;
      const std::vector<glm::vec3>& places = surface ? glyphs.mesh->positions : glyphs.centers;
      const glm::dvec3 from = glyphs.origin + (surface ? glm::dvec3(glyphs.centers[0]) : glm::dvec3(0.0));
      for (std::size_t i = 0; i < places.size(); i += 1 + places.size() / mostPoints)
      {
        const glm::dvec3 place = from + glm::dvec3(places[i]);
        points->InsertNextPoint(&place[0]);
        const std::uint32_t color = each.size() == places.size() ? each[i] : plain;
        for (int shift : { 0, 8, 16 })
        {
          colors->InsertNextValue(static_cast<unsigned char>(color >> shift));
        }
      }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colors);
    static_cast<vtkPointGaussianMapper*>(this->Actor->GetMapper())->SetInputData(data);
  }
  this->Actor->SetPropertyKeys(as->GetPropertyKeys());
  this->Actor->RenderOpaqueGeometry(renderer);
}
