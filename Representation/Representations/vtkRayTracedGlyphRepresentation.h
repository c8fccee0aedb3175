/**
 * @class   vtkRayTracedGlyphRepresentation
 * @brief   representation that shows the points of any data set as ray-traced glyphs
 *
 * @sa vtkGlyph3DRepresentation, whose scale and orientation arrays have the same meaning here.
 */
#ifndef vtkRayTracedGlyphRepresentation_h
#define vtkRayTracedGlyphRepresentation_h

#include "vtkRayTracedSelectableRepresentation.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "GlyphHighScale.h"
#include "GlyphMeshes.h"
#include "GlyphSettings.h"
#include "GlyphTensorRange.h"
#include "vtkGlyphLegend.h"
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rtglyphs
{
class GlyphLayers;
}

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedGlyphRepresentation : public vtkRayTracedSelectableRepresentation
{
public:
  static vtkRayTracedGlyphRepresentation* New();
  vtkTypeMacro(vtkRayTracedGlyphRepresentation, vtkRayTracedSelectableRepresentation);

  /**
   * Values of GlyphShape. GLYPH_TYPE: what the second input is, exactly where a shape of the kernels is that
   * (GlyphSource), else its polygons.
   */
  enum GlyphShapes
  {
    GLYPH_TYPE = 0,
    SUPERQUADRIC = 5,
    TENSOR_ELLIPSOID = 6,
    TENSOR_SUPERQUADRIC = 7,
    SIGNED_TENSOR_SUPERQUADRIC = 8,
    CAPSULE = 10,
    NESTED_SUPERQUADRIC = 11,
    SPHERICAL_HARMONICS = 12,
    REYNOLDS = 13,
    FOURTH_ORDER_TENSOR = 14,
    PRINCIPAL_AXES = 15, // of tensors
    SPLIT_VECTOR = 16,
    UNCERTAIN_VECTOR = 17,    // with tensors as covariances
    CONFIDENCE_ELLIPSOID = 18 // of tensors as covariances
  };
  void SetGlyphShape(int shape);

  /**
   * Location of the glyphs: each point of the input, or each cell's center.
   */
  enum Locations
  {
    POINTS = 0,
    CELLS = 1
  };
  void SetGlyphLocation(int location);

  ///@{
  /**
   * As vtkGlyph3DRepresentation's, with vtkGlyph3DMapper's modes. Orientation arrays of four components are quaternions
   * and those of nine rotation matrices in every mode.
   */
  void SetScaling(bool on) { this->Scaling = on; }
  void SetScaleArray(const char* name) { this->SetArray(this->Glyphs.ScaleArray, name); }
  void SetScaleMode(int mode) { this->ScaleMode = mode; }
  void SetScaleFactor(double factor) { this->Glyphs.ScaleFactor = rtglyphs::RayTracedNumbers::NumberOr(factor, 0.0); }
  void SetOrient(bool on) { this->Glyphs.Orient = on; }
  void SetOrientationArray(const char* name) { this->SetArray(this->Glyphs.OrientationArray, name); }
  void SetOrientationMode(int mode) { this->Glyphs.OrientationMode = mode; }
  void SetSourceIndexing(bool on) { this->SetTable(on, this->UseSourceTableTree); }
  void SetSourceIndexArray(const char* name) { this->Glyphs.TableIndexArray = OrEmpty(name); }
  void SetUseSourceTableTree(bool on) { this->SetTable(this->SourceIndexing, on); }
  ///@}

  ///@{
  /**
   * Size and place; see GlyphSettings for modes and defaults.
   */
  void SetScaleFactorFromData(bool on);
  void SetGlyphScaleFunction(int function) { this->Glyphs.Sizing.Function = function; }
  void SetGlyphSizeRange(double least, double most);
  void SetGlyphRadiusArray(const char* name) { this->Glyphs.RadiusArray = OrEmpty(name); }
  void SetGlyphRadiusFactor(double factor)
  {
    this->Glyphs.RadiusFactor = rtglyphs::RayTracedNumbers::NumberOr(factor, 0.0);
  }
  void SetGlyphAnchor(int anchor) { this->Glyphs.Anchor = anchor; }
  ///@}

  ///@{
  /**
   * The result of GlyphScaleGuess, where ScaleFactorFromData is on: factor, limit, fraction of the glyphs that have the
   * limit. Processes that have data use it by themselves; those that only render get it by SetScaleFactor() and
   * SetGlyphSizeLimit(), the client being between them.
   */
  double* GetScaleFactorGuess() VTK_SIZEHINT(3) { return this->ScaleGuess.data(); }
  void SetGlyphSizeLimit(double limit) { this->SizeLimit = rtglyphs::RayTracedNumbers::NumberOr(limit, 0.0); }
  ///@}

  ///@{
  /**
   * Values of the data for processes that only render: GlyphHighScale, and width and height of the mesh of mesh
   * glyphs; numbers are 0 where there is none. The client carries them there.
   */
  double* GetGlyphDataSizesInfo() VTK_SIZEHINT(4) { return this->DataSizes.data(); }
  void SetGlyphDataSizes(double highScale, double meshWidth, double meshHeight, double largest);
  ///@}

  ///@{
  /**
   * A glyph of a stated number in a corner of the view, from which sizes can be read; see vtkGlyphLegend. 0: none, else
   * its corner and 1. Default is none, a number that fits, white.
   */
  void SetGlyphLegend(int place);
  void SetGlyphLegendValue(double value) { this->LegendStyle.Value = rtglyphs::RayTracedNumbers::NumberOr(value, 0.0); }
  void SetGlyphLegendColor(double red, double green, double blue)
  {
    this->LegendStyle.Color = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
  }
  ///@}

  ///@{
  /**
   * Whether arrows have heads of one size (0) or scaled ones (1, default), as vtkArrowSource's. Fixed heads are
   * slightly rounded and have the source's proportions on an arrow of the reference magnitude: the 95th percentile of
   * the scale array unless it is positive.
   */
  void SetArrowHeads(int heads) { this->FixedHeads = heads == 0; }
  void SetArrowReferenceMagnitude(double magnitude)
  {
    this->Glyphs.ArrowReference = rtglyphs::RayTracedNumbers::NumberOr(magnitude, 0.0);
  }
  ///@}

  ///@{
  /**
   * Exponents of superquadrics, each in [0.1, 100], default 2 2 2, and an array that overrides them, default none. See
   * GlyphInstanceBuilder.
   */
  void SetGlyphExponents(double r, double s, double t);
  void SetGlyphExponentArray(const char* name) { this->SetArray(this->Glyphs.ExponentArray, name); }
  ///@}

  /**
   * Opacities of the glyphs, in [0, 1], times that of the representation and of colors; default none.
   */
  void SetGlyphOpacityArray(const char* name) { this->Glyphs.OpacityArray = OrEmpty(name); }

  ///@{
  /**
   * The tensors of tensor glyphs, the order of their components (GlyphTensors::TensorLayouts; default is 0, VTK's), the
   * fraction of a Gaussian that the ellipsoid of a covariance holds (in [0.01, 0.9999], default 0.95), the sharpness of
   * superquadrics (in [0, 10], default 3), the least thickness as a fraction of the longest axis (in [0.001, 1],
   * default 0.02), what colors the glyphs (GlyphTensors::Colorings, default 0, an array), and the table that numbers of
   * tensors are colored by, and by its ends GlyphTensors::SIGN.
   */
  void SetGlyphTensorArray(const char* name) { this->SetArray(this->Glyphs.Tensors.Array, name); }
  void SetGlyphTensorLayout(int layout)
  {
    this->Glyphs.Tensors.Layout = static_cast<rtglyphs::GlyphTensors::TensorLayouts>(layout);
  }
  void SetGlyphConfidence(double share) { this->Glyphs.Tensors.Confidence = share; }
  void SetGlyphTensorSharpness(double sharpness) { this->Glyphs.Tensors.Sharpness = sharpness; }
  void SetGlyphTensorThickness(double share) { this->Glyphs.Tensors.Thickness = share; }
  void SetGlyphTensorColoring(int coloring) { this->Glyphs.Tensors.Coloring = coloring; }
  void SetGlyphTensorLookupTable(vtkScalarsToColors* table);
  ///@}

  ///@{
  /**
   * The coefficients of spherical harmonics, their basis (rtg::HarmonicsBasis, default 0, MRtrix3's), and whether each
   * glyph of a polynomial has the same size (1) or all have one scale (0, default).
   */
  void SetGlyphHarmonicsArray(const char* name) { this->SetArray(this->HarmonicsArray, name); }
  void SetGlyphHarmonicsBasis(int basis) { this->Glyphs.Forms.Basis = static_cast<rtg::HarmonicsBasis>(basis); }
  void SetGlyphHarmonicsScaling(int scaling) { this->Glyphs.Forms.Each = scaling == 1; }
  ///@}

  /**
   * Information: least and largest number that GlyphTensorColoring gives; an empty interval (1, -1) where it gives
   * none.
   */
  double* GetGlyphTensorRange() VTK_SIZEHINT(2) { return this->TensorRange; }

  /**
   * Information: the fraction of the tensors shown that have a negative eigenvalue.
   */
  double GetGlyphNegativeTensors() const { return this->NegativeTensors; }

  ///@{
  /**
   * Whether arrows show the antisymmetric parts of tensors of nine components (GlyphSettings::AxesOfTensors), and
   * their color. Default is off, yellow.
   */
  void SetGlyphTensorAxis(bool on) { this->TensorAxis = on; }
  void SetGlyphTensorAxisColor(double red, double green, double blue)
  {
    this->TensorAxisColor = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
  }
  ///@}

  ///@{
  /**
   * Shows only some of the glyphs; see GlyphMask for modes and defaults. 0: all, else its mode and 1.
   */
  void SetGlyphMode(int mode);
  void SetMaximumNumberOfGlyphs(int number) { this->Glyphs.Mask.MaximumNumberOfGlyphs = number; }
  void SetGlyphStride(int stride) { this->Glyphs.Mask.Stride = stride; }
  ///@}

  /**
   * How much of their opacity trails lose to their last step, in [0, 1]. Default is 0.
   */
  void SetTrailFading(double fading)
  {
    this->TrailFading = std::clamp(rtglyphs::RayTracedNumbers::NumberOr(fading, 0.0), 0.0, 1.0);
  }

protected:
  vtkRayTracedGlyphRepresentation();
  ~vtkRayTracedGlyphRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const rtglyphs::RayTracedParallel::Progress& progress) override;
  std::vector<std::string> Arrays() const override;
  const double* GetDataBounds(vtkPolyData* points) override;
  rtglyphs::GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) override;
  void Deliver(vtkInformation* inInfo, bool lod) override;
  bool NeedsOrderedCompositing() override;

  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() override;
  void Configure(vtkInformation* inInfo, vtkPolyData* points, bool lod, bool collective) override;
  void SetPartBounds(const double bounds[6]) override;
  void ShowLayers(bool visible) override;
  void RemoveLayers(vtkPVRenderView* view) override;
  std::vector<vtkRayTracedLegend*> GetLegends() override { return { this->Legend, this->Key }; }

private:
  rtglyphs::GlyphSettings MakeSettings() const;
  bool FadesTrails() const { return this->HasTrails() && this->TrailFading > 0.0; }
  std::optional<rtglyphs::GlyphSettings> Beside(vtkPolyData* points, const rtglyphs::GlyphSettings& settings) const;
  void UpdateTensorRange(vtkPolyData* points);
  void UpdateScaleGuess(vtkPolyData* points);
  void UpdateDataSizes(vtkPolyData* points);
  void CountPointsOfAllRanks(vtkPolyData* points);
  void UpdateLegend(const rtglyphs::GlyphSettings& settings);
  void ResizeLayers(vtkPVRenderView* view, std::size_t size);
  void SetTable(bool sourceIndexing, bool useSourceTableTree);

  rtglyphs::GlyphSettings Glyphs; // but for what MakeSettings() adds
  int GlyphShape = GLYPH_TYPE;
  bool Scaling = false;
  int ScaleMode = 0;
  bool FixedHeads = false;
  int GlyphLocation = POINTS;
  vtkNew<vtkGlyphLegend> Legend;
  vtkGlyphLegend::Style LegendStyle;
  bool ScaleFactorFromData = false;
  rtglyphs::GlyphKeptGuess Guess;
  rtglyphs::GlyphHighScale HighScale;
  std::array<double, 3> ScaleGuess{};
  double SizeLimit = 0.0;
  std::array<double, 4> DataSizes{};
  std::string HarmonicsArray;
  bool SourceIndexing = false, UseSourceTableTree = false;
  double TrailFading = 0.0;
  bool TensorAxis = false;
  std::array<double, 3> TensorAxisColor{ { 0.95, 0.8, 0.2 } };
  vtkSmartPointer<vtkScalarsToColors> TensorTable;
  double TensorRange[2] = { 1.0, -1.0 };
  double NegativeTensors = 0.0;
  rtglyphs::GlyphTensorRange NumberRange; // of the data
  rtglyphs::GlyphTensorRange ShownRange;  // of what is delivered to be rendered

  rtglyphs::GlyphMeshes Meshes;
  std::unique_ptr<rtglyphs::GlyphLayers> Layers; // what stands beside the glyphs, further meshes of a table
};

#endif
