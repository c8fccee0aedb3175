/**
 * @class   vtkRayTracedGlyphRepresentation
 * @brief   representation that shows the points of any data set as ray-traced glyphs
 *
 * The points are gathered where the data are (vtkGlyphPointGatherer), delivered by the view to where it renders, and
 * shown there by a vtkRayTracedGlyphMapper.
 *
 * @sa vtkGlyph3DRepresentation, whose meaning of scale and orientation arrays this one shares.
 */
#ifndef vtkRayTracedGlyphRepresentation_h
#define vtkRayTracedGlyphRepresentation_h

#include "vtkNew.h"
#include "vtkPVDataRepresentation.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkGlyphStepVelocity;
class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkProperty;
class vtkRayTracedGlyphCompanion;
class vtkRayTracedGlyphMapper;
class vtkScalarsToColors;

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedGlyphRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkRayTracedGlyphRepresentation* New();
  vtkTypeMacro(vtkRayTracedGlyphRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Shape of the glyphs: a number of rtg::Shape, or MESH for the polygons of the second input. Default is 0 (sphere).
   */
  enum
  {
    MESH = 9
  };
  void SetGlyphShape(int shape);
  int GetGlyphShape();
  ///@}

  ///@{
  /**
   * Size: a factor, and an array when scaling is on; "None" or empty is no array. Modes are those of
   * vtkGlyphInstanceBuilder::ScaleModes. Default is off, factor 1, magnitude.
   */
  void SetGlyphScaling(bool on);
  void SetGlyphScaleArray(const char* name);
  void SetGlyphScaleMode(int mode);
  void SetGlyphScaleFactor(double factor);
  ///@}

  ///@{
  /**
   * Orientation. Modes are those of vtkGlyphInstanceBuilder::OrientationModes. Default is on, no array, direction.
   */
  void SetGlyphOrient(bool on);
  void SetGlyphOrientationArray(const char* name);
  void SetGlyphOrientationMode(int mode);
  ///@}

  ///@{
  /**
   * The arrow's form, in fractions of the unit arrow's length. Default is fixed heads, vtkArrowSource's
   * proportions and a rounding of 0.5. Fixed heads have these proportions on an arrow of the reference magnitude; it
   * is the mean of the scale array when not positive, the default.
   */
  void SetArrowHeads(int heads);
  void SetArrowReferenceMagnitude(double magnitude);
  void SetArrowShaftRadius(double radius);
  void SetArrowTipRadius(double radius);
  void SetArrowTipLength(double length);
  void SetArrowTipRounding(double rounding);
  ///@}

  ///@{
  /**
   * Exponents of superquadrics, each in [0.1, 100], default 2 2 2, an array that overrides them, default none, and the form:
   * 0 (default) an exponent for each axis, 1 nested. See vtkGlyphInstanceBuilder.
   */
  void SetGlyphExponents(double r, double s, double t);
  void SetGlyphExponentArray(const char* name);
  void SetGlyphExponentForm(int form);
  ///@}

  /**
   * Values of GlyphShape beyond those of rtg::Shape.
   */
  enum TensorShapes
  {
    TENSOR_ELLIPSOID = 6,
    TENSOR_SUPERQUADRIC = 7,
    SIGNED_TENSOR_SUPERQUADRIC = 8
  };

  ///@{
  /**
   * The tensors of tensor glyphs, the order of their components (rtg::TensorLayout; default is 0, VTK's), the sharpness of
   * superquadrics (in [0, 10], default 3), and what colours the glyphs (vtkGlyphTensors::Colorings, default 0, an array).
   */
  void SetGlyphTensorArray(const char* name);
  void SetGlyphTensorLayout(int layout);
  void SetGlyphTensorSharpness(double sharpness);
  void SetGlyphTensorColoring(int coloring);
  ///@}

  ///@{
  /**
   * Colours in [0, 1] of vtkGlyphTensors::SIGN: where x^T D x is zero or more, and where it is less. Default is a red and a blue.
   */
  void SetGlyphTensorPositiveColor(double red, double green, double blue);
  void SetGlyphTensorNegativeColor(double red, double green, double blue);
  ///@}

  ///@{
  /**
   * Whether points choose their form among the blocks of GlyphMesh by the magnitude of a point array, cut to a whole number and clamped to
   * the table; without the array all have the first. For Mesh glyphs. Default is off, none.
   */
  void SetGlyphMeshTable(bool use);
  void SetGlyphMeshIndexArray(const char* name);
  ///@}

  ///@{
  /**
   * Whether arrows show the antisymmetric parts of tensors of nine components (vtkGlyphInstanceBuilder::AxesOf), and their
   * colour. Default is off, yellow.
   */
  void SetGlyphTensorAxis(bool on);
  void SetGlyphTensorAxisColor(double red, double green, double blue);
  ///@}

  ///@{
  /**
   * Motion blur, of glyphs and of surfaces: names of point arrays of three components ("None" or empty: none), the time that the shutter is open, and
   * when that is, of vtkGlyphMotion::Openings. Default is off, no arrays, 1, centred. Velocities may instead be those of
   * vtkGlyphStepVelocity, default off, where an array of one component, by default the global ids, tells which point is
   * which.
   */
  void SetMotionBlur(bool on);
  void SetVelocityArray(const char* name);
  void SetVelocityFromPreviousStep(bool on);
  void SetPointIdArray(const char* name);
  void SetAccelerationArray(const char* name);
  void SetAngularVelocityArray(const char* name);
  void SetShutterTime(double time);
  void SetShutterOpening(int opening);
  ///@}

  ///@{
  /**
   * Shows at most so many of the glyphs, chosen at random but the same at each time step. Default is off, 5000, 1.
   */
  void SetGlyphMask(bool on);
  void SetMaximumNumberOfGlyphs(int number);
  void SetGlyphSeed(int seed);
  ///@}

  /**
   * With several ranks that render: each gets the points of all. Default is off.
   */
  void SetReplicateGlyphs(bool on);

  ///@{
  /**
   * Forwarded to the mapper. Values out of range become the nearest in it, NaN the default.
   */
  void SetShadingMode(int mode);
  void SetAmbientOcclusionRadius(double radius);
  void SetAmbientOcclusionRays(int rays);
  void SetPathsPerSample(int paths);
  void SetMaximumBounces(int bounces);
  void SetLightIntensity(double intensity);
  void SetEnvironmentColor(double red, double green, double blue);
  void SetToneMapping(int kind);
  void SetExposure(double stops);
  void SetDenoising(int when);
  void SetFeatureImageFile(const char* name);
  void SetSamplesPerPixel(int samples);
  void SetSamplesPerRender(int samples);
  void SetInteractiveReduction(int step);
  void SetStepwiseRendering(bool stepwise);
  ///@}

  ///@{
  /**
   * Information: the device that traces, the samples a pixel of the last image, and what was done (JSON).
   */
  const char* GetDeviceName();
  int GetAccumulatedSamples();
  const char* GetRenderStatistics();
  ///@}

  /**
   * Whether the last render of the view was a server's, so that this process, the client, has no image of its own.
   */
  bool GetRenderedRemotely();

  ///@{
  /**
   * Appearance, forwarded to mapper, property and actor.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(int map);
  void SetOpacity(double opacity);
  void SetAmbientColor(double r, double g, double b);
  void SetDiffuseColor(double r, double g, double b);
  void SetSpecularColor(double r, double g, double b);
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  void SetMetallic(double metallic);
  void SetRoughness(double roughness);
  void SetCoatStrength(double strength);
  void SetCoatIOR(double ior);
  void SetCoatRoughness(double roughness);
  void SetCoatColor(double red, double green, double blue);
  void SetPosition(double x, double y, double z);
  void SetTranslation(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetUserTransform(const double matrix[16]);
  void SetPickable(int pickable);
  ///@}

  ///@{
  /**
   * Blocks of a composite data set, by selectors in its hierarchy. Default is the selector "/".
   */
  void AddBlockSelector(const char* selector);
  void RemoveAllBlockSelectors();
  void SetBlockColor(const char* selector, double r, double g, double b);
  void RemoveAllBlockColors();
  void SetBlockOpacity(const char* selector, double opacity);
  void RemoveAllBlockOpacities();
  ///@}

  // vtkPVDataRepresentation
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  vtkDataObject* GetRenderedDataObject(int port) override;

protected:
  vtkRayTracedGlyphRepresentation();
  explicit vtkRayTracedGlyphRepresentation(vtkSmartPointer<vtkRayTracedGlyphMapper> mapper);
  ~vtkRayTracedGlyphRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /**
   * What is delivered to the mapper. `wholeExtent` is null unless `input` is a piece of a structured data set.
   */
  virtual vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* input, const int* wholeExtent);

  vtkRayTracedGlyphMapper* GetMapper();
  vtkProperty* GetProperty();

private:
  vtkRayTracedGlyphRepresentation(const vtkRayTracedGlyphRepresentation&) = delete;
  void operator=(const vtkRayTracedGlyphRepresentation&) = delete;

  void UpdateColoring(vtkPolyData* points);
  void UpdateAxes(vtkPolyData* points);
  void UpdateTable(vtkDataObject* forms);
  std::vector<vtkRayTracedGlyphCompanion*> Companions();
  bool ShowsAxes(vtkPolyData* points) const;
  void GatherMesh(vtkDataObject* mesh);
  void AddStepVelocities(vtkDataObject* input);
  vtkDataArray* PointIds();
  void ShareMeanScale();
  bool NeedsOrderedCompositing();
  void Place();
  void NoteBlocks(bool changed);

  vtkSmartPointer<vtkRayTracedGlyphMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkProperty> Property;
  std::unique_ptr<vtkRayTracedGlyphCompanion> Axes;
  std::vector<std::unique_ptr<vtkRayTracedGlyphCompanion>> Table; // of mesh glyphs, all forms but the first
  vtkSmartPointer<vtkPolyData> Points; // gathered, not yet delivered
  vtkNew<vtkMultiBlockDataSet> Mesh;   // likewise; its only block is the form of mesh glyphs, or those of a table
  std::array<double, 3> Position{}, Translation{};
  int GlyphShape = 0;
  bool GlyphMeshTable = false;
  bool NestedExponents = false;
  bool TensorAxis = false;
  std::array<double, 3> TensorAxisColor{ { 0.95, 0.8, 0.2 } };
  std::unique_ptr<vtkGlyphStepVelocity> StepVelocity;
  std::string PointIdArray;
  vtkWeakPointer<vtkAlgorithm> StepVelocitySource; // whose steps they are
  bool ReplicateGlyphs = false;
  std::string DeviceName, Statistics;
};

#endif
