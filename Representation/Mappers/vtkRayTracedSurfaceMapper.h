/**
 * @class   vtkRayTracedSurfaceMapper
 * @brief   shows triangles as a surface among ray-traced glyphs
 *
 * Input is the vtkPolyData of RayTracedSurfaceGatherer. To the scene the surface is one mesh glyph.
 * Colors are a part of the mesh, of its positions or of its triangles.
 *
 * With motion (GlyphMotion) each point of the surface moves by itself while the shutter is open; angular velocities
 * mean nothing here.
 *
 * Triangles that have a corner without finite coordinates or motion are left out, counted and reported once.
 *
 * @sa SurfaceContent
 */
#ifndef vtkRayTracedSurfaceMapper_h
#define vtkRayTracedSurfaceMapper_h

#include "GlyphMotion.h"
#include "vtkRayTracedMapper.h"

class vtkRayTracedSurfaceMapper : public vtkRayTracedMapper
{
public:
  static vtkRayTracedSurfaceMapper* New();
  vtkTypeMacro(vtkRayTracedSurfaceMapper, vtkRayTracedMapper);

  struct SurfaceSettings
  {
    bool Smooth = true; // the points' normals, where they have some, are interpolated over the triangles
    rtglyphs::GlyphMotion::Settings Motion;

    bool operator==(const SurfaceSettings&) const = default;
  };
  void SetSettings(const SurfaceSettings& settings) { this->Settings = settings; }

  // vtkRayTracedMapper
  rtg::GlyphInstances TakeInstances(vtkActor*) override { return this->Instances; }
  int GetNaturalAssociation() const override { return vtkDataObject::FIELD_ASSOCIATION_CELLS; }

protected:
  vtkRayTracedSurfaceMapper() = default;
  ~vtkRayTracedSurfaceMapper() override = default;

  bool HaveSettingsChanged() const override { return !(this->Settings == this->BuiltSettings); }
  std::vector<vtkObject*> InstanceInputs(vtkPolyData* surface) const override;
  void BuildInstances(vtkPolyData* surface, vtkActor* actor) override;
  void BuildColors(vtkPolyData* surface) override;
  Origin FindOrigin(vtkIdType triangle, int association, const double position[3]) override;

private:
  SurfaceSettings Settings, BuiltSettings;
};

#endif
