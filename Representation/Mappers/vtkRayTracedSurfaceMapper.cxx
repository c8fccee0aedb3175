#include "vtkRayTracedSurfaceMapper.h"

#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTriangleBuilder.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkRayTracedSurfaceMapper);

//----------------------------------------------------------------------------
std::vector<vtkObject*> vtkRayTracedSurfaceMapper::InstanceInputs(vtkPolyData* surface) const
{
  const std::array<vtkDataArray*, 4> motion = rtglyphs::GlyphMotion::Arrays(surface, this->Settings.Motion);
  return { surface->GetPoints() ? surface->GetPoints()->GetData() : nullptr, surface->GetPolys(),
    this->Settings.Smooth ? surface->GetPointData()->GetArray(rtglyphs::RayTracedArrays::Normals) : nullptr, motion[0],
    motion[1], motion[3] };
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceMapper::BuildInstances(vtkPolyData* surface, vtkActor* actor)
{
  const rtglyphs::GlyphMotion motion(surface, this->Settings.Motion);
  rtglyphs::RayTracedTriangleBuilder::Result result = rtglyphs::RayTracedTriangleBuilder::Build(
    surface, this->Hidden, actor->GetMatrix(), this->Settings.Smooth, &motion);
  this->BuiltSettings = this->Settings;
  rtg::GlyphMotion shutter;
  motion.Finish(shutter);
  this->OriginalIds = std::move(result.Cells);
  this->Skipped = result.Skipped;
  const bool same = this->Instances.mesh && result.Origin == this->Instances.origin &&
    rtg::SameShape(result.Mesh, *this->Instances.mesh) && shutter.shutterOpen == this->Instances.motion.shutterOpen &&
    shutter.shutterClose == this->Instances.motion.shutterClose;
  if (!same)
  {
    this->Instances = rtg::GlyphInstances();
    this->Instances.shape = rtg::Shape::Mesh;
    this->Instances.identifyTriangles = true;
    this->Instances.centers = { glm::vec3(0.0f) };
    this->Instances.origin = result.Origin;
    this->Instances.motion = shutter;
    this->Instances.mesh = std::make_shared<rtg::TriangleMesh>(std::move(result.Mesh));
  }

  std::vector<std::string> messages = motion.Messages();
  rtglyphs::GlyphMotion::ReportMissing(surface, this->Settings.Motion, this->Hidden, messages);
  if (result.Skipped > 0)
  {
    messages.push_back(std::to_string(result.Skipped) + " of " +
      std::to_string(result.Skipped + this->GetNumberOfGlyphs()) +
      " triangles are not shown: a corner's position, or its motion, is not finite. Make an array of "
      "inputs[0].Points with Python Calculator, and remove these points with Threshold.");
  }
  else if (surface->GetNumberOfPolys() == 0 && surface->GetNumberOfPoints() > 0)
  {
    messages.emplace_back(
      "The data have no polygons and so no surface to show; lines and vertices are left out. Choose "
      "another representation, or make polygons with a filter such as Extract Surface, Tube or "
      "Contour.");
  }
  this->ReportInstances(std::move(messages), rtglyphs::GlyphMotion::MissingInput(this->Settings.Motion));
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceMapper::BuildColors(vtkPolyData*)
{
  std::vector<std::string> messages;
  const rtg::TriangleMesh& mesh = *this->Instances.mesh;
  // The scene may still hold the old mesh; the kernels see that only the colors are new.
  auto colored = std::make_shared<rtg::TriangleMesh>(mesh);
  colored->positionColors.clear();
  colored->triangleColors.clear();
  const MappedColors mapped = this->MapColors(true, "point or cell of the surface", messages);
  colored->positionValues = mapped.Values;
  colored->valueColors = mapped.Table;
  if (mapped.OfCells)
  {
    colored->triangleColors.resize(mesh.triangles.size());
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(mesh.triangles.size()),
      [&](vtkIdType i)
      { colored->triangleColors[i] = Pack(this->ColorOf(mapped, mesh.triangles[i].x, this->OriginalIds[i])); });
  }
  else if (mapped.Any || this->HasBlockColors())
  {
    colored->positionColors.resize(mesh.positions.size());
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(mesh.positions.size()),
      [&](vtkIdType i) { colored->positionColors[i] = Pack(this->ColorOf(mapped, i, -1)); });
  }

  this->Translucent = rtg::IsTranslucent(*colored);
  if (colored->positionColors != mesh.positionColors || colored->triangleColors != mesh.triangleColors ||
    colored->positionValues != mesh.positionValues || colored->valueColors != mesh.valueColors)
  {
    this->Instances.mesh = std::move(colored);
    this->InstanceVersion = NewVersion();
  }
  this->Report(messages, this->ReportedColors);
}

//----------------------------------------------------------------------------
// A point is that corner of the triangle that lies nearest.
vtkRayTracedMapper::Origin
vtkRayTracedSurfaceMapper::FindOrigin(vtkIdType triangle, int association, const double position[3])
{
  const rtg::TriangleMesh& mesh = *this->Instances.mesh;
  const glm::uvec3 corners = mesh.triangles[triangle];
  vtkIdType nearest = corners.x;
  const glm::dvec3 place = glm::dvec3(position[0], position[1], position[2]) - this->Instances.origin;
  for (unsigned int corner : { corners.y, corners.z })
  {
    if (glm::distance(place, glm::dvec3(mesh.positions[corner])) <
      glm::distance(place, glm::dvec3(mesh.positions[nearest])))
    {
      nearest = corner;
    }
  }
  return this->OriginOfPoint(
    nearest, this->OriginalIds[triangle], association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
}
