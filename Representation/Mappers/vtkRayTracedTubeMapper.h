/**
 * @class   vtkRayTracedTubeMapper
 * @brief   shows lines and poly-lines as tubes among ray-traced glyphs
 *
 * Input is the vtkPolyData of lines of RayTracedSurfaceGatherer. To the scene each piece of a line is a glyph
 * (RayTracedTubeBuilder). Values of points become colors that change linearly from end to end of a piece.
 *
 * @sa vtkRayTracedTubeRepresentation
 */
#ifndef vtkRayTracedTubeMapper_h
#define vtkRayTracedTubeMapper_h

#include "GlyphPlacement.h"
#include "RayTracedTubeBuilder.h"
#include "vtkRayTracedMapper.h"

class vtkRayTracedTubeMapper : public vtkRayTracedMapper
{
public:
  static vtkRayTracedTubeMapper* New();
  vtkTypeMacro(vtkRayTracedTubeMapper, vtkRayTracedMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetSettings(const rtglyphs::RayTracedTubeBuilder::Settings& settings);

  // vtkRayTracedMapper
  rtg::GlyphInstances TakeInstances(vtkActor* actor) override;
  const rtg::GlyphInstances* GetInstances() const override { return this->Taken ? nullptr : &this->Instances; }
  Origin OriginOf(vtkIdType piece, int association, const double position[3]) override;
  int GetNaturalAssociation() const override;

protected:
  vtkRayTracedTubeMapper();
  ~vtkRayTracedTubeMapper() override;

  bool HaveSettingsChanged() const override { return !(this->Settings.Effective() == this->BuiltSettings.Effective()); }
  std::vector<vtkObject*> InstanceInputs(vtkPolyData* lines) const override;
  void BuildInstances(vtkPolyData* lines, vtkActor* actor) override;
  void BuildColors(vtkPolyData* lines) override;

private:
  vtkRayTracedTubeMapper(const vtkRayTracedTubeMapper&) = delete;
  void operator=(const vtkRayTracedTubeMapper&) = delete;

  rtglyphs::RayTracedTubeBuilder::Settings Settings, BuiltSettings;
  rtg::GlyphInstances Instances; // until they are taken
  bool Taken = false;
  std::vector<std::array<vtkIdType, 2>> Ends;    // points of each piece
  rtglyphs::GlyphPlacement Placement{ nullptr }; // the actor's
};

#endif
