/**
 * @class   vtkRayTracedGlyphMapper
 * @brief   makes glyphs of points and arrays, and their colors
 *
 * Input is the vtkPolyData of GlyphPointGatherer.
 *
 * @sa GlyphInstanceBuilder
 */
#ifndef vtkRayTracedGlyphMapper_h
#define vtkRayTracedGlyphMapper_h

#include "GlyphSettings.h"
#include "vtkRayTracedMapper.h"
#include "vtkSmartPointer.h"

class vtkDoubleArray;

class vtkRayTracedGlyphMapper : public vtkRayTracedMapper
{
public:
  static vtkRayTracedGlyphMapper* New();
  vtkTypeMacro(vtkRayTracedGlyphMapper, vtkRayTracedMapper);

  /**
   * How arrays become glyphs, but for Mesh, which is made of the triangles of a RayTracedSurfaceGatherer; null:
   * there are none.
   */
  void SetSettings(const rtglyphs::GlyphSettings& settings, vtkPolyData* mesh);

  ///@{
  /**
   * The table that numbers of tensors (GlyphTensors::IsNumber) and radii of polynomials are colored by, which
   * RayTracedTensorTable chooses; and of GlyphTensors::EIGENVALUES the range.
   */
  void SetTensorTable(vtkScalarsToColors* table) { this->TensorTable = table; }
  void SetTensorRange(const std::array<double, 2>& range) { this->TensorRange = range; }
  const std::array<double, 2>& GetTensorRange() const { return this->TensorRange; }
  ///@}

  // vtkRayTracedMapper
  void AddToMaterial(rtg::Material& material) const override;
  int GetNaturalAssociation() const override { return vtkDataObject::FIELD_ASSOCIATION_POINTS; }

protected:
  vtkRayTracedGlyphMapper() = default;
  ~vtkRayTracedGlyphMapper() override = default;

  bool HaveSettingsChanged() const override { return !(this->Settings.Effective() == this->BuiltSettings); }
  std::vector<vtkObject*> InstanceInputs(vtkPolyData* points) const override;
  void BuildInstances(vtkPolyData* points, vtkActor* actor) override;
  void BuildColors(vtkPolyData* points) override;
  std::vector<vtkMTimeType> ColorState() const override;
  Origin FindOrigin(vtkIdType glyph, int association, const double position[3]) override;
  bool NeedsSolidColor() const override { return !this->TrailEnds.empty() && this->Settings.TrailFading > 0.0; }

private:
  void EigenvaluesAsColor(const rtglyphs::GlyphTensors& tensors, vtkIdType point, double rgb[3]) const;
  std::vector<std::array<double, 3>> DirectionsAsColors(
    vtkPolyData* points, const rtglyphs::GlyphTensors* tensors, std::vector<std::string>& messages) const;
  vtkSmartPointer<vtkDoubleArray> NumbersOf(const rtglyphs::GlyphTensors& tensors);
  vtkSmartPointer<vtkUnsignedCharArray> TableColors(vtkDoubleArray* numbers);
  void AddRadiusColors(rtg::GlyphColors& colors);
  void AddFading(rtg::GlyphColors& colors) const;

  rtglyphs::GlyphSettings Settings;
  rtglyphs::GlyphSettings BuiltSettings; // the effective ones
  glm::dmat3 Placed{ 1.0 };              // by the actor's matrix
  vtkMTimeType MeshTime = 0;             // of what Settings.Mesh was made of; no two are alike
  vtkSmartPointer<vtkScalarsToColors> TensorTable;
  std::array<double, 2> TensorRange{ { 1.0, -1.0 } };
  std::vector<float> Radii;                            // as GlyphInstanceBuilder has them
  std::vector<std::array<std::uint16_t, 2>> TrailEnds; // as GlyphTrails has them
};

#endif
