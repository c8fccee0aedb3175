/**
 * @class   vtkRayTracedSurfaceRepresentation
 * @brief   representation that shows the outer surface of any data set among the ray-traced glyphs of the view
 *
 * The surface is that of ParaView's ordinary surface representation: its triangles, colors, opacity and material.
 * Lines and vertices are not shown.
 *
 * @sa RayTracedSurfaceGatherer vtkRayTracedSurfaceMapper
 */
#ifndef vtkRayTracedSurfaceRepresentation_h
#define vtkRayTracedSurfaceRepresentation_h

#include "vtkRayTracedRepresentation.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedSurfaceRepresentation : public vtkRayTracedRepresentation
{
public:
  static vtkRayTracedSurfaceRepresentation* New();
  vtkTypeMacro(vtkRayTracedSurfaceRepresentation, vtkRayTracedRepresentation);

  /**
   * 0, VTK_FLAT: each triangle has its own normal. Any other: the points' normals are interpolated, which are
   * computed where the data have none. Default is 1, VTK_GOURAUD.
   */
  void SetInterpolation(int interpolation) override;

protected:
  vtkRayTracedSurfaceRepresentation();
  ~vtkRayTracedSurfaceRepresentation() override = default;

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const rtglyphs::RayTracedParallel::Progress& progress) override;
  const double* GetDataBounds(vtkPolyData* surface) override;
  rtglyphs::GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) override;
  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() override;
  void Configure(vtkInformation* inInfo, vtkPolyData* surface, bool lod, bool collective) override;

private:
  bool Smooth = true;
};

#endif
