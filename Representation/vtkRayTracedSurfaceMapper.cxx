#include "vtkRayTracedSurfaceMapper.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGlyphMotion.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRayTracedSurfaceGatherer.h"
#include "vtkRayTracedTriangleBuilder.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkRayTracedSurfaceMapper);

namespace
{
vtkUnsignedIntArray* BlocksOf(vtkPolyData* surface)
{
  return vtkUnsignedIntArray::SafeDownCast(
    surface->GetPointData()->GetArray(vtkGlyphPointGatherer::CompositeIndexName()));
}

std::uint32_t Pack(const std::array<double, 4>& rgba)
{
  std::uint32_t packed = 0;
  for (int c = 0; c < 4; ++c)
  {
    packed |=
      static_cast<std::uint32_t>(std::lround(vtkMath::ClampValue(rgba[c], 0.0, 1.0) * 255.0))
      << (8 * c);
  }
  return packed;
}
}

//----------------------------------------------------------------------------
vtkRayTracedSurfaceMapper::vtkRayTracedSurfaceMapper()
{
  // The superclass's bounds are those of glyphs at the points: of no size they are the surface's.
  this->Glyphs.ScaleFactor = 0.0;
}

//----------------------------------------------------------------------------
vtkRayTracedSurfaceMapper::~vtkRayTracedSurfaceMapper() = default;

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Smooth: " << this->Smooth << endl;
}

//----------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkRayTracedSurfaceMapper::FurtherTimes(vtkPolyData* surface) const
{
  vtkDataArray* normals = this->Smooth ? surface->GetPointData()->GetNormals() : nullptr;
  return { surface->GetPolys()->GetMTime(), normals ? normals->GetMTime() : 0 };
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceMapper::BuildInstances(vtkPolyData* surface, vtkActor* actor)
{
  vtkGlyphMotion::Settings settings = this->Glyphs.Motion;
  settings.AngularVelocity.clear(); // points do not turn
  const vtkGlyphMotion motion(surface, settings);
  vtkRayTracedTriangleBuilder::Result result = vtkRayTracedTriangleBuilder::BuildRelative(
    surface, this->BlockTable, actor->GetMatrix(), this->Smooth, motion);
  rtg::GlyphMotion shutter;
  motion.Finish(shutter);
  this->Points = std::move(result.Cells);
  this->Skipped = result.Skipped;
  ++this->PointsVersion;
  const bool same = this->Instances.mesh && this->InstanceVersion > 0 &&
    result.Origin == this->Instances.origin && rtg::SameShape(result.Mesh, *this->Instances.mesh) &&
    shutter.shutterOpen == this->Instances.motion.shutterOpen &&
    shutter.shutterClose == this->Instances.motion.shutterClose;
  if (!same)
  {
    this->Instances = rtg::GlyphInstances();
    this->Instances.shape = rtg::Shape::Mesh;
    this->Instances.identifyTriangles = true;
    this->Instances.centres = { glm::vec3(0.0f) };
    this->Instances.origin = result.Origin;
    this->Instances.motion = shutter;
    this->Instances.mesh = std::make_shared<rtg::TriangleMesh>(std::move(result.Mesh));
    this->ShapeChanged = true;
  }

  std::vector<std::string> messages = motion.Messages();
  if (result.Skipped > 0)
  {
    messages.push_back(std::to_string(result.Skipped) + " of " +
      std::to_string(result.Skipped + this->GetNumberOfGlyphs()) +
      " triangles are not shown: a corner's position, or its motion, is not finite. Remove these points, for "
      "example with Threshold or Clean.");
  }
  else if (surface->GetNumberOfPolys() == 0 && surface->GetNumberOfPoints() > 0)
  {
    messages.emplace_back("The data have no polygons and so no surface to show; lines and vertices "
                          "are left out. Choose another representation, or make polygons with a "
                          "filter such as Extract Surface, Tube or Contour.");
  }
  this->Report(messages, this->ReportedInstances);
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceMapper::BuildColors(vtkPolyData* surface)
{
  std::vector<std::string> messages;
  const rtg::TriangleMesh& mesh = *this->Instances.mesh;
  vtkUnsignedCharArray* mapped = nullptr;
  int ofCells = 0;
  if (this->ScalarVisibility && !mesh.triangles.empty())
  {
    mapped = this->MapScalars(surface, 1.0, ofCells);
    const vtkIdType wanted = ofCells ? surface->GetNumberOfCells() : surface->GetNumberOfPoints();
    if (!mapped || mapped->GetNumberOfTuples() != wanted)
    {
      mapped = nullptr;
      messages.push_back("There is no array '" + std::string(this->ArrayName) +
        "' that has a value for each point or cell of the surface, so it has one colour. Choose a "
        "point or cell array as ColorArrayName.");
    }
  }
  vtkUnsignedIntArray* blocks = BlocksOf(surface);
  const bool blockColors = blocks &&
    std::any_of(this->BlockTable.begin(), this->BlockTable.end(),
      [](const auto& item) { return item.second.HasColor || item.second.Opacity < 1.0; });

  // Colour of a point or cell of the data that lies in the block of `point`.
  const int components = mapped ? std::min(mapped->GetNumberOfComponents(), 4) : 0;
  const auto colorOf = [&](vtkIdType value, vtkIdType point)
  {
    std::array<double, 4> rgba{ { this->SolidColor[0], this->SolidColor[1], this->SolidColor[2],
      1.0 } };
    for (int c = 0; c < components; ++c)
    {
      rgba[c] = mapped->GetValue(value * mapped->GetNumberOfComponents() + c) / 255.0;
    }
    const auto block =
      blockColors ? this->BlockTable.find(blocks->GetValue(point)) : this->BlockTable.end();
    if (block != this->BlockTable.end())
    {
      if (block->second.HasColor)
      {
        std::copy(block->second.Color.begin(), block->second.Color.end(), rgba.begin());
      }
      rgba[3] *= block->second.Opacity;
    }
    return Pack(rgba);
  };

  std::vector<std::uint32_t> ofPositions, ofTriangles;
  if (mapped && ofCells)
  {
    ofTriangles.resize(mesh.triangles.size());
    for (std::size_t i = 0; i < ofTriangles.size(); ++i)
    {
      ofTriangles[i] = colorOf(this->Points[i], mesh.triangles[i].x);
    }
  }
  else if (mapped || blockColors)
  {
    ofPositions.resize(mesh.positions.size());
    for (std::size_t i = 0; i < ofPositions.size(); ++i)
    {
      ofPositions[i] = colorOf(static_cast<vtkIdType>(i), static_cast<vtkIdType>(i));
    }
  }

  const auto translucent = [](std::uint32_t color) { return (color >> 24) != 255u; };
  this->Translucent = std::any_of(ofPositions.begin(), ofPositions.end(), translucent) ||
    std::any_of(ofTriangles.begin(), ofTriangles.end(), translucent);
  if (ofPositions != mesh.positionColours || ofTriangles != mesh.triangleColours)
  {
    // The scene may still hold the old mesh; the kernels see that only the colours are new.
    auto colored = std::make_shared<rtg::TriangleMesh>(mesh);
    colored->positionColours = std::move(ofPositions);
    colored->triangleColours = std::move(ofTriangles);
    this->Instances.mesh = std::move(colored);
    this->ShapeChanged = true;
  }
  if (this->ShapeChanged)
  {
    this->ShapeChanged = false;
    this->InstanceVersion = NewVersion();
  }
  this->Report(messages, this->ReportedColors);
}

//----------------------------------------------------------------------------
rtg::GlyphInstances vtkRayTracedSurfaceMapper::TakeInstances(vtkActor*)
{
  return this->Instances;
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::Origin vtkRayTracedSurfaceMapper::OriginOf(vtkIdType triangle)
{
  Origin origin;
  vtkPolyData* surface = this->GetPoints();
  if (!surface || triangle < 0 || triangle >= this->GetNumberOfGlyphs())
  {
    return origin;
  }
  const vtkIdType cell = this->Points[triangle];
  const vtkIdType corner = this->Instances.mesh->triangles[triangle].x;
  vtkPointData* data = surface->GetPointData();
  vtkDataArray* ids = surface->GetCellData()->GetArray(vtkRayTracedSurfaceGatherer::CellIdsName());
  vtkDataArray* blocks = data->GetArray(vtkGlyphPointGatherer::CompositeIndexName());
  vtkDataArray* processes = data->GetArray(vtkGlyphPointGatherer::ProcessIdName());
  origin.Id = ids ? static_cast<vtkIdType>(ids->GetComponent(cell, 0)) : cell;
  origin.CompositeIndex = blocks ? static_cast<unsigned int>(blocks->GetComponent(corner, 0)) : 0;
  origin.Process = processes ? static_cast<int>(processes->GetComponent(corner, 0)) : -1;
  return origin;
}
