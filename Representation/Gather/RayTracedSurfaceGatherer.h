/**
 * The outer surface of a data set, or its lines, as poly data.
 *
 * Input may be any data set or hyper tree grid, one leaf of RayTracedTree. The surface is that of ParaView's
 * ordinary surface representation (vtkPVGeometryFilter), cut into triangles; lines and vertices are left out. Or the
 * lines and poly-lines are left, and the rest is left out.
 *
 * The output has the input's arrays, and the arrays for picking (RayTracedArrays.h): ids of points and cells, ranks.
 */
#ifndef RayTracedSurfaceGatherer_h
#define RayTracedSurfaceGatherer_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

namespace rtglyphs::RayTracedSurfaceGatherer
{
struct Settings
{
  /// Lines instead of triangles; where there are none, points alone.
  bool Lines = false;
  /// Points without normals get some; edges sharper than 30 degrees stay sharp.
  bool ComputesNormals = true;
  /// How often faces of nonlinear cells are divided into four, or their edges in two; 0: not at all.
  int NonlinearSubdivisionLevel = 1;
  /// That of the structured data set of which the input is this process's piece; null when there is none.
  const int* WholeExtent = nullptr;
};
vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const Settings& settings);
}

#endif
