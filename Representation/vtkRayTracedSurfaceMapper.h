/**
 * @class   vtkRayTracedSurfaceMapper
 * @brief   shows triangles as a surface among ray-traced glyphs
 *
 * Input is the vtkPolyData of vtkRayTracedSurfaceGatherer. To the scene the surface is one glyph in the form of a mesh;
 * what the superclass calls glyphs are here the triangles shown, and Points their cells. Colours are a part of the
 * mesh, of its positions or of its triangles.
 *
 * With motion (vtkGlyphMotion) each point of the surface goes its own way while the shutter is open; angular velocities mean
 * nothing here.
 *
 * Triangles that have a corner without finite coordinates or motion are left out, counted and reported once.
 *
 * @sa vtkRayTracedSurfaceRepresentation
 */
#ifndef vtkRayTracedSurfaceMapper_h
#define vtkRayTracedSurfaceMapper_h

#include "vtkRayTracedGlyphMapper.h"

class vtkRayTracedSurfaceMapper : public vtkRayTracedGlyphMapper
{
public:
  static vtkRayTracedSurfaceMapper* New();
  vtkTypeMacro(vtkRayTracedSurfaceMapper, vtkRayTracedGlyphMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the points' normals, where they have some, are interpolated over the triangles. Default is on.
   */
  vtkSetMacro(Smooth, bool);
  vtkGetMacro(Smooth, bool);
  ///@}

  // vtkRayTracedGlyphMapper
  rtg::GlyphInstances TakeInstances(vtkActor* actor) override;
  Origin OriginOf(vtkIdType triangle) override;
  bool PicksCells() const override { return true; }

protected:
  vtkRayTracedSurfaceMapper();
  ~vtkRayTracedSurfaceMapper() override;

  void BuildInstances(vtkPolyData* surface, vtkActor* actor) override;
  void BuildColors(vtkPolyData* surface) override;
  std::vector<vtkMTimeType> FurtherTimes(vtkPolyData* surface) const override;

private:
  vtkRayTracedSurfaceMapper(const vtkRayTracedSurfaceMapper&) = delete;
  void operator=(const vtkRayTracedSurfaceMapper&) = delete;

  bool Smooth = true;
  bool ShapeChanged = false; // since the last BuildColors()
};

#endif
