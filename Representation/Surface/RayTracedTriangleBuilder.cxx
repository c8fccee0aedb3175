#include "RayTracedTriangleBuilder.h"

#include "Finite.h"
#include "GlyphMotion.h"
#include "GlyphPlacement.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <utility>

namespace
{
glm::dvec3 PointOf(vtkDataArray* array, vtkIdType i)
{
  return { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
}

// The middle of the data, from which the positions lose the least when they become float.
glm::dvec3 Middle(vtkDataArray* points, const rtglyphs::GlyphPlacement& placement)
{
  const rtg::DoubleBox box = rtglyphs::RayTracedParallel::BoxOf(points->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end, rtg::DoubleBox& own)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const glm::dvec3 x = placement(PointOf(points, i));
        if (rtg::IsFinite(x))
        {
          own.Include({ x, x });
        }
      }
    });
  return box.Empty() ? glm::dvec3(0.0) : 0.5 * (box.lower + box.upper);
}

// Normals transform with the inverse transpose, here times the determinant. What is no direction becomes zero, for
// which the kernels take the triangle's own.
std::vector<glm::vec3> Turn(vtkDataArray* array, const rtglyphs::GlyphPlacement& placement)
{
  const glm::dmat3& m = placement.Linear;
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  std::vector<glm::vec3> normals(array->GetNumberOfTuples(), glm::vec3(0.0f));
  rtglyphs::RayTracedParallel::ForEach(array->GetNumberOfTuples(),
    [&](vtkIdType i)
    {
      const glm::dvec3 normal = cofactors * PointOf(array, i);
      const double length = glm::length(normal);
      if (rtg::IsPositive(length))
      {
        normals[i] = normal / length;
      }
    });
  return normals;
}

// Polygons as fans: they are triangles, unless a filter has cut them.
void AddTriangles(vtkPolyData* polygons, const rtglyphs::RayTracedRanges& hidden, bool mirrored,
  rtglyphs::RayTracedTriangleBuilder::Result& result)
{
  const std::vector<glm::vec3>& positions = result.Mesh.positions;
  vtkIdType cell = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
  auto iterator = vtk::TakeSmartPointer(polygons->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    iterator->GetCurrentCell(size, corners);
    for (vtkIdType i = 2; i < size && !hidden.Has(corners[0]); ++i)
    {
      glm::uvec3 triangle(corners[0], corners[i - 1], corners[i]);
      if (!rtg::IsFinite(positions[triangle.x]) || !rtg::IsFinite(positions[triangle.y]) ||
        !rtg::IsFinite(positions[triangle.z]))
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
void AddMotion(const rtglyphs::GlyphMotion& motion, const rtglyphs::GlyphPlacement& placement, rtg::TriangleMesh& mesh)
{
  motion.Allocate(mesh.motion, mesh.positions.size());
  rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(mesh.positions.size()),
    [&](vtkIdType i)
    {
      if (motion.IsFinite(i))
      {
        motion.Store(mesh.motion, i, i, placement.Linear, glm::dmat3(1.0));
      }
      else
      {
        mesh.positions[i] = glm::vec3(NAN); // of no triangle, and so without motion
      }
    });
  motion.Finish(mesh.motion);
}
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedTriangleBuilder::Result rtglyphs::RayTracedTriangleBuilder::Build(vtkPolyData* polygons,
  const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, bool smooth, const rtglyphs::GlyphMotion* motion)
{
  Result result;
  if (!polygons->GetPoints() || polygons->GetNumberOfPoints() == 0)
  {
    return result;
  }
  const rtglyphs::GlyphPlacement placement(modelToWorld);
  rtg::TriangleMesh& mesh = result.Mesh;
  vtkDataArray* points = polygons->GetPoints()->GetData();
  if (motion)
  {
    result.Origin = Middle(points, placement);
  }
  mesh.positions.resize(points->GetNumberOfTuples());
  rtglyphs::RayTracedParallel::ForEach(points->GetNumberOfTuples(),
    [&](vtkIdType i) { mesh.positions[i] = placement(PointOf(points, i)) - result.Origin; });
  if (motion && motion->On())
  {
    AddMotion(*motion, placement, mesh);
  }
  AddTriangles(polygons, hidden, glm::determinant(placement.Linear) < 0.0, result);
  for (glm::vec3& position : mesh.positions)
  {
    position = rtg::IsFinite(position) ? position : glm::vec3(0.0f); // of no triangle
  }
  vtkDataArray* normals = smooth ? polygons->GetPointData()->GetArray(rtglyphs::RayTracedArrays::Normals) : nullptr;
  if (normals && normals->GetNumberOfComponents() == 3)
  {
    mesh.normals = Turn(normals, placement);
  }
  return result;
}
