/**
 * @class   vtkRayTracedTubeMapper
 * @brief   shows lines and poly-lines as tubes among ray-traced glyphs
 *
 * Input is the vtkPolyData of lines of RayTracedSurfaceGatherer. To the scene each piece of a line is a glyph
 * (RayTracedTubeBuilder). Values of points become colors that change linearly from end to end of a piece.
 *
 * @sa TubeContent
 */
#ifndef vtkRayTracedTubeMapper_h
#define vtkRayTracedTubeMapper_h

#include "DirectionColors.h"
#include "GlyphPlacement.h"
#include "RayTracedTubeBuilder.h"
#include "vtkRayTracedMapper.h"

class vtkRayTracedTubeMapper : public vtkRayTracedMapper
{
public:
  static vtkRayTracedTubeMapper* New();
  vtkTypeMacro(vtkRayTracedTubeMapper, vtkRayTracedMapper);

  void SetSettings(const rtglyphs::RayTracedTubeBuilder::Settings& settings) { this->Settings = settings; }

  /**
   * A kind of rtglyphs::DirectionColors, which replaces all other colors. Default is none.
   */
  void SetDirectionColoring(int kind) { this->DirectionColoring = kind; }

  // vtkRayTracedMapper
  int GetNaturalAssociation() const override { return vtkDataObject::FIELD_ASSOCIATION_CELLS; }

protected:
  vtkRayTracedTubeMapper() = default;
  ~vtkRayTracedTubeMapper() override = default;

  bool HaveSettingsChanged() const override { return !(this->Settings == this->BuiltSettings); }
  std::vector<vtkObject*> InstanceInputs(vtkPolyData* lines) const override;
  void BuildInstances(vtkPolyData* lines, vtkActor* actor) override;
  void BuildColors(vtkPolyData* lines) override;
  Origin FindOrigin(vtkIdType piece, int association, const double position[3]) override;
  std::vector<vtkMTimeType> ColorState() const override
  {
    return { static_cast<vtkMTimeType>(this->DirectionColoring) };
  }

private:
  glm::dvec3 DirectionOf(vtkPolyData* lines, vtkIdType piece, int end) const;

  rtglyphs::RayTracedTubeBuilder::Settings Settings, BuiltSettings;
  int DirectionColoring = rtglyphs::DirectionColors::NONE;
  std::vector<std::array<vtkIdType, 2>> Ends;    // points of each piece
  rtglyphs::GlyphPlacement Placement{ nullptr }; // the actor's
};

#endif
