/**
 * @class   vtkRayTracedSurfaceGatherer
 * @brief   gathers the outer surface of any data object, or its lines, into one vtkPolyData
 *
 * Input may be any data set, hyper tree grid or composite of them. The surface is that of ParaView's ordinary surface
 * representation (vtkPVGeometryFilter), cut into triangles; lines and vertices are left out. Or the lines and
 * poly-lines are left, and the rest is left out.
 *
 * The output has the union of all blocks' arrays (NaN where a block lacks one), and:
 * - what picking asks for (vtkRayTracedArrays.h): ids of points and cells, flat indices of blocks, ranks. No point is
 *   shared by two blocks.
 *
 * Its field data has, for composite input, the hierarchy that block selectors speak about (see
 * vtkGlyphBlockAttributes).
 */
#ifndef vtkRayTracedSurfaceGatherer_h
#define vtkRayTracedSurfaceGatherer_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

class vtkRayTracedSurfaceGatherer
{
public:
  struct Settings
  {
    /// Lines instead of triangles; where there are none, points alone.
    bool Lines = false;
    /// Points without normals get some; edges sharper than this angle, in degrees, stay sharp.
    bool ComputesNormals = true;
    double FeatureAngle = 30.0;
    /// How often faces of nonlinear cells are divided into four, or their edges in two; 0: not at all.
    int NonlinearSubdivisionLevel = 1;
    /// This process's rank among those whose surfaces are put together for rendering.
    int Process = 0, Processes = 1;
    /// That of the structured data set of which the input is this process's piece; null when there is none.
    const int* WholeExtent = nullptr;
  };
  static vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* input, const Settings& settings);

  /**
   * Triangles of one poly data, with normals as the settings say; arrays are kept.
   */
  static vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* polygons, const Settings& settings);

  /**
   * Lines of one poly data with their points and arrays.
   */
  static vtkSmartPointer<vtkPolyData> ExtractLines(vtkPolyData* data);
};

#endif
