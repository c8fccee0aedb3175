#include "vtkRayTracedTriangleBuilder.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkGlyphMotion.h"
#include "vtkRayTracedArrays.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <cmath>
#include <utility>

namespace
{
bool IsFinite(const glm::dvec3& x)
{
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

glm::dvec3 PointOf(vtkDataArray* array, vtkIdType i)
{
  return { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
}

// The map from the data to the world.
struct Placement
{
  glm::dmat3 Linear{ 1.0 };
  glm::dvec3 Offset{ 0.0 };
  explicit Placement(vtkMatrix4x4* matrix)
  {
    for (int row = 0; matrix && row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        this->Linear[column][row] = matrix->GetElement(row, column);
      }
      this->Offset[row] = matrix->GetElement(row, 3);
    }
  }
  glm::dvec3 operator()(const glm::dvec3& x) const { return this->Linear * x + this->Offset; }
};

// The middle of the data, from which the positions lose the least when they become float.
glm::dvec3 Middle(vtkPoints* points, const Placement& placement)
{
  vtkDataArray* array = points->GetData();
  const vtkIdType count = points->GetNumberOfPoints();
  glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const glm::dvec3 x = placement(PointOf(array, i));
    if (IsFinite(x))
    {
      lower = glm::min(lower, x);
      upper = glm::max(upper, x);
    }
  }
  return lower.x <= upper.x ? 0.5 * (lower + upper) : glm::dvec3(0.0);
}

// Normals turn with the inverse transpose, here times the determinant. What is no direction becomes zero, for which
// the kernels take the triangle's own.
std::vector<glm::vec3> Turn(vtkDataArray* array, const Placement& placement)
{
  const glm::dmat3& m = placement.Linear;
  const glm::dmat3 cofactors(
    glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  std::vector<glm::vec3> normals(array->GetNumberOfTuples(), glm::vec3(0.0f));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const glm::dvec3 normal = cofactors * PointOf(array, static_cast<vtkIdType>(i));
    const double length = glm::length(normal);
    if (length > 0.0 && std::isfinite(length))
    {
      normals[i] = normal / length;
    }
  }
  return normals;
}

// Polygons as fans: they are triangles, unless something on the way here has cut them.
void AddTriangles(vtkPolyData* polygons, const vtkGlyphBlockAttributes::Table& table, bool mirrored,
  vtkRayTracedTriangleBuilder::Result& result)
{
  const std::vector<glm::vec3>& positions = result.Mesh.positions;
  auto* blocks = vtkUnsignedIntArray::SafeDownCast(
    polygons->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex));
  vtkIdType cell = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
  auto iterator = vtk::TakeSmartPointer(polygons->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
       iterator->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    iterator->GetCurrentCell(size, corners);
    const auto block = blocks && size > 0 ? table.find(blocks->GetValue(corners[0])) : table.end();
    if (block != table.end() && !block->second.Visible)
    {
      continue;
    }
    for (vtkIdType i = 2; i < size; ++i)
    {
      glm::uvec3 triangle(corners[0], corners[i - 1], corners[i]);
      if (!IsFinite(positions[triangle.x]) || !IsFinite(positions[triangle.y]) ||
        !IsFinite(positions[triangle.z]))
      {
        ++result.Skipped;
        continue;
      }
      if (mirrored)
      {
        std::swap(triangle.y, triangle.z);
      }
      result.Mesh.triangles.push_back(triangle);
      result.Cells.push_back(cell);
    }
  }
}

// Positions whose motion is not finite become so themselves.
void AddMotion(const vtkGlyphMotion& motion, const Placement& placement, rtg::TriangleMesh& mesh)
{
  const vtkIdType count = static_cast<vtkIdType>(mesh.positions.size());
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool finite = motion.IsFinite(i);
    motion.AppendTo(mesh.motion, i, placement.Linear, glm::dmat3(1.0));
    if (!finite)
    {
      mesh.positions[i] = glm::vec3(NAN);
      // Of no triangle.
      for (std::vector<glm::vec3>* values : { &mesh.motion.velocities, &mesh.motion.accelerations })
      {
        if (!values->empty())
        {
          values->back() = glm::vec3(0.0f);
        }
      }
    }
  }
  motion.Finish(mesh.motion);
}

vtkRayTracedTriangleBuilder::Result Build(vtkPolyData* polygons,
  const vtkGlyphBlockAttributes::Table& blocks, const Placement& placement, bool smooth,
  bool relative, const vtkGlyphMotion* motion)
{
  vtkRayTracedTriangleBuilder::Result result;
  if (!polygons->GetPoints() || polygons->GetNumberOfPoints() == 0)
  {
    return result;
  }
  rtg::TriangleMesh& mesh = result.Mesh;
  if (relative)
  {
    result.Origin = Middle(polygons->GetPoints(), placement);
  }
  vtkDataArray* points = polygons->GetPoints()->GetData();
  mesh.positions.reserve(points->GetNumberOfTuples());
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    mesh.positions.emplace_back(placement(PointOf(points, i)) - result.Origin);
  }
  if (motion && motion->On())
  {
    AddMotion(*motion, placement, mesh);
  }
  AddTriangles(polygons, blocks, glm::determinant(placement.Linear) < 0.0, result);
  for (glm::vec3& position : mesh.positions)
  {
    position = IsFinite(position) ? position : glm::vec3(0.0f); // of no triangle
  }
  vtkDataArray* normals = smooth ? polygons->GetPointData()->GetNormals() : nullptr;
  if (normals && normals->GetNumberOfComponents() == 3)
  {
    mesh.normals = Turn(normals, placement);
  }
  return result;
}
}

//----------------------------------------------------------------------------
vtkRayTracedTriangleBuilder::Result
vtkRayTracedTriangleBuilder::BuildRelative(vtkPolyData* polygons,
  const vtkGlyphBlockAttributes::Table& blocks, vtkMatrix4x4* modelToWorld, bool smooth,
  const vtkGlyphMotion& motion)
{
  return Build(polygons, blocks, Placement(modelToWorld), smooth, /*relative=*/true, &motion);
}

//----------------------------------------------------------------------------
vtkRayTracedTriangleBuilder::Result vtkRayTracedTriangleBuilder::BuildInPlace(vtkPolyData* polygons)
{
  return Build(polygons, {}, Placement(nullptr), /*smooth=*/true, /*relative=*/false, nullptr);
}
