/**
 * Builds the triangles that the kernels trace from polygons.
 *
 * Normals of the points become those of the triangles' corners, with an actor's transform as vtk does it; normals of
 * zero length, or not finite, leave a triangle its own.
 *
 * Triangles with a corner that is not finite, or whose motion is not, are left out and counted.
 */
#ifndef RayTracedTriangleBuilder_h
#define RayTracedTriangleBuilder_h

#include "RayTracedRanges.h"
#include "TriangleMesh.h"
#include "vtkType.h"

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
namespace rtglyphs
{
class GlyphMotion;
}

namespace rtglyphs::RayTracedTriangleBuilder
{
struct Result
{
  rtg::TriangleMesh Mesh;       // without colors; positions are those of the points, in their order
  glm::dvec3 Origin{ 0.0 };     // that positions are relative to
  std::vector<vtkIdType> Cells; // of each triangle
  vtkIdType Skipped = 0;        // triangles
};

/**
 * Points that are `hidden` (RayTracedBlocks::GetHidden()) are left out. `modelToWorld` may be null. Without `smooth`,
 * normals are left out. The motion of the points becomes that of the positions, which are relative to the middle of
 * the data; without it (null) they are relative to the origin.
 */
Result Build(vtkPolyData* polygons, const RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, bool smooth,
  const GlyphMotion* motion);
}

#endif
