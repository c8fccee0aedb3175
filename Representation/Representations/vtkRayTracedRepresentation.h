/**
 * @class   vtkRayTracedRepresentation
 * @brief   glyphs, the surface or tubes of a data set, ray traced
 *
 * What is shown is a RayTracedContent, which ParaView names as subtype of the representation (SetRepresentation());
 * this class delivers and places it. Appearance, placement, colors and blocks are those of ParaView's ordinary surface.
 * The superclass's geometry filter is not run, and its actor not rendered: its MultiBlockMaker delivers what is
 * gathered, and RayTracedParts copies the actor's appearance.
 *
 * Points, triangles or lines are gathered where the data are, in RequestData(). REQUEST_UPDATE hands them to the view
 * with their bounds and touches nothing of the render side. Mappers, actors and the renderer's vtkRayTracedScene are
 * made when something is first rendered, and configured from the properties at each REQUEST_RENDER. Which work a change
 * of a property causes is found out there by comparing; only what needs a new gather or delivery calls MarkModified().
 *
 * @sa vtkRayTracedScene vtkRayTracedMapper
 */
#ifndef vtkRayTracedRepresentation_h
#define vtkRayTracedRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSmartPointer.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "GlyphContent.h"
#include "RayTracedCache.h"
#include "RayTracedNumbers.h"
#include "RayTracedRendering.h"
#include "SurfaceContent.h"
#include "TubeContent.h"
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedRepresentation : public vtkGeometryRepresentation
{
public:
  static vtkRayTracedRepresentation* New();
  vtkTypeMacro(vtkRayTracedRepresentation, vtkGeometryRepresentation);

  /**
   * What is shown: Glyphs (default), Surface or Tubes.
   */
  void SetRepresentation(const char* content) override;
  using vtkGeometryRepresentation::SetRepresentation;

  ///@{
  /**
   * Colors: of what is selected (default is ParaView's, magenta); how directions become colors
   * (rtglyphs::DirectionColors), and where in the view their key is. Default is not at all, and the upper right corner.
   */
  void SetSelectionColor(double red, double green, double blue)
  {
    this->Common.SelectionColor = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
  }
  void SetGlyphDirectionColoring(int kind) { this->Common.DirectionColoring = kind; }
  void SetGlyphDirectionKey(int place) { this->Common.Key->SetPlace(place); }
  ///@}

  ///@{
  /**
   * Numbers that are found in the data (rtglyphs::DataSummary). Processes that have data use theirs by themselves;
   * those that only render get them from the client.
   */
  double* GetDataSummary() VTK_SIZEHINT(11);
  void SetDataSummary(const double numbers[11]);
  ///@}

  ///@{
  /**
   * Motion blur: names of point arrays of two or three components ("None" or empty: none), the time that the shutter is
   * open (0: by the data), and when that is, of GlyphMotion::Openings. Velocities may be those of GlyphSteps
   * (RayTracedArrays::StepVelocity), where an array of one component, by default the global ids, identifies points.
   */
  void SetMotionBlur(bool on) { this->Common.Time.Motion.On = on; }
  void SetVelocityArray(const char* name);
  void SetPointIdArray(const char* name) { this->GatherIf(this->Common.Time.Steps.SetPointIdArray(OrEmpty(name))); }
  void SetAccelerationArray(const char* name) { this->SetArray(this->Common.Time.Motion.Acceleration, name); }
  void SetAngularVelocityArray(const char* name) { this->SetArray(this->Common.Time.Motion.AngularVelocity, name); }
  void SetMotionBlurMask(const char* name) { this->Common.Time.Motion.Mask = OrEmpty(name); }
  void SetShutterTime(double time) { this->Common.Time.SetShutterTime(OrZero(time)); }
  void SetShutterOpening(int opening) { this->Common.Time.Motion.Opening = std::clamp(opening, 0, 2); }
  ///@}

  /**
   * In how many earlier time steps the points are sought (GlyphSteps), for representations that show their trails.
   * Default is 0.
   */
  void SetTrailSteps(int steps) { this->GatherIf(this->Common.Time.Steps.SetTrailSteps(steps)); }

  ///@{
  /**
   * A periodic box of the data, as RayTracedPeriodic has it.
   */
  void SetPeriodicBoundary(bool on);
  void SetPeriodicVectors(int index, double value);
  void SetPeriodicImages(int a, int b, int c) { this->Rendering.Periodic.Images = { a, b, c }; }
  ///@}

  ///@{
  /**
   * A cut: kinds and faces are those of RayTracedSection. Of a plane what lies on the side of its normal is cut off, of
   * a box, or of the slab of that thickness about the plane, what is outside; not inverted the opposite. All in world
   * coordinates.
   */
  void SetSection(int kind) { this->Rendering.Section.Kind = kind; }
  void SetSectionInvert(bool invert) { this->Rendering.Section.Invert = invert; }
  void SetSectionOrigin(double x, double y, double z) { this->Rendering.Section.Origin = { x, y, z }; }
  void SetSectionNormal(double x, double y, double z) { this->Rendering.Section.Normal = { x, y, z }; }
  void SetSectionThickness(double thickness) { this->Rendering.Section.Thickness = thickness; }
  void SetSectionPosition(double x, double y, double z) { this->Rendering.Section.Position = { x, y, z }; }
  void SetSectionRotation(double x, double y, double z) { this->Rendering.Section.Rotation = { x, y, z }; }
  void SetSectionLength(double x, double y, double z) { this->Rendering.Section.Length = { x, y, z }; }
  void SetSectionCaps(int faces) { this->Rendering.Section.Face = faces; }
  void SetSectionCapColor(double red, double green, double blue)
  {
    this->Rendering.Section.CapColor = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
  }
  ///@}

  ///@{
  /**
   * Shape of the glyphs (rtglyphs::GlyphShapes), and whether they stand at the points of the input or at its cells'
   * centers (1).
   */
  void SetGlyphShape(int shape);
  void SetGlyphLocation(int location);
  ///@}

  ///@{
  /**
   * As vtkGlyph3DRepresentation's, with vtkGlyph3DMapper's modes. Orientation arrays of four components are quaternions
   * and those of nine rotation matrices in every mode.
   */
  void SetScaling(bool on) { this->Glyphs.Scaling = on; }
  void SetScaleArray(const char* name) { this->SetArray(this->Glyphs.Settings.ScaleArray, name); }
  void SetScaleMode(int mode) { this->Glyphs.ScaleMode = mode; }
  void SetScaleFactor(double factor) { this->Glyphs.Settings.ScaleFactor = OrZero(factor); }
  void SetOrient(bool on) { this->Glyphs.Settings.Orient = on; }
  void SetOrientationArray(const char* name) { this->SetArray(this->Glyphs.Settings.OrientationArray, name); }
  void SetOrientationMode(int mode) { this->Glyphs.Settings.OrientationMode = mode; }
  void SetSourceIndexing(bool on) { this->SetTable(on, this->Glyphs.UseSourceTableTree); }
  void SetSourceIndexArray(const char* name) { this->Glyphs.Settings.TableIndexArray = OrEmpty(name); }
  void SetUseSourceTableTree(bool on) { this->SetTable(this->Glyphs.SourceIndexing, on); }
  ///@}

  ///@{
  /**
   * Size and place; see GlyphSettings for modes and defaults.
   */
  void SetScaleFactorFromData(bool on) { this->Glyphs.SetScaleFactorFromData(on); }
  void SetGlyphScaleFunction(int function) { this->Glyphs.Settings.Sizing.Function = function; }
  void SetGlyphSizeRange(double least, double most);
  void SetGlyphRadiusArray(const char* name) { this->Glyphs.Settings.RadiusArray = OrEmpty(name); }
  void SetGlyphAnchor(int anchor) { this->Glyphs.Settings.Anchor = anchor; }
  ///@}

  ///@{
  /**
   * A glyph of a stated number in a corner of the view, from which sizes can be read; see vtkGlyphLegend for places and
   * defaults.
   */
  void SetGlyphLegend(int place) { this->Glyphs.GetLegend()->SetPlace(place); }
  void SetGlyphLegendValue(double value) { this->Glyphs.GetLegend()->SetValue(OrZero(value)); }
  ///@}

  ///@{
  /**
   * Whether arrows have heads of one size (0) or scaled ones (1, default), as vtkArrowSource's. Fixed heads are
   * slightly rounded and have the source's proportions on an arrow of the reference magnitude: the 95th percentile of
   * the scale array unless it is positive.
   */
  void SetArrowHeads(int heads) { this->Glyphs.FixedHeads = heads == 0; }
  void SetArrowReferenceMagnitude(double magnitude) { this->Glyphs.Settings.ArrowReference = OrZero(magnitude); }
  ///@}

  ///@{
  /**
   * Exponents of superquadrics, each in [0.1, 100], default 2 2 2, and an array that overrides them, default none. See
   * GlyphInstanceBuilder.
   */
  void SetGlyphExponents(double r, double s, double t)
  {
    const double exponents[] = { OrZero(r), OrZero(s), OrZero(t) }; // zero makes no glyph
    std::copy_n(exponents, 3, this->Glyphs.Settings.Exponents);
  }
  void SetGlyphExponentArray(const char* name) { this->SetArray(this->Glyphs.Settings.ExponentArray, name); }
  ///@}

  /**
   * Tensors, of shapes that show some, else sizes of translucent shells around the glyphs; default none.
   */
  void SetGlyphShellArray(const char* name) { this->SetArray(this->Glyphs.ShellArray, name); }

  /**
   * Opacities of the glyphs, in [0, 1], times that of the representation and of colors; default none.
   */
  void SetGlyphOpacityArray(const char* name) { this->Glyphs.Settings.OpacityArray = OrEmpty(name); }

  ///@{
  /**
   * The tensors of tensor glyphs, the order of their components (GlyphTensors::TensorLayouts; default is 0, VTK's), the
   * fraction of a Gaussian that the ellipsoid of a covariance holds (in [0.01, 0.9999], default 0.95), the sharpness of
   * superquadrics (in [0, 10], default 3), what colors the glyphs (GlyphTensors::Colorings, default 0, an array), and
   * the table that numbers of tensors are colored by, and by its ends GlyphTensors::SIGN.
   */
  void SetGlyphTensorArray(const char* name) { this->SetArray(this->Glyphs.Settings.Tensors.Array, name); }
  void SetGlyphTensorLayout(int layout) { this->Glyphs.Settings.Tensors.Layout = layout; }
  void SetGlyphConfidence(double share) { this->Glyphs.Settings.Tensors.Confidence = share; }
  void SetGlyphTensorSharpness(double sharpness) { this->Glyphs.Settings.Tensors.Sharpness = sharpness; }
  void SetGlyphTensorColoring(int coloring) { this->Glyphs.Settings.Tensors.Coloring = coloring; }
  void SetGlyphTensorLookupTable(vtkScalarsToColors* table) { this->Glyphs.TensorTable = table; }
  ///@}

  ///@{
  /**
   * The coefficients of spherical harmonics, and their basis (rtg::HarmonicsBasis, default 0, MRtrix3's).
   */
  void SetGlyphHarmonicsArray(const char* name) { this->SetArray(this->Glyphs.HarmonicsArray, name); }
  void SetGlyphHarmonicsBasis(int basis) { this->Glyphs.Settings.Forms.Basis = basis; }
  ///@}

  /**
   * Whether arrows show the antisymmetric parts of tensors of nine components (GlyphFrame::Axis). Default
   * is off.
   */
  void SetGlyphTensorAxis(bool on) { this->Glyphs.TensorAxis = on; }

  ///@{
  /**
   * Shows only some of the glyphs; see GlyphMask for modes and defaults. 0: all, else its mode and 1.
   */
  void SetGlyphMode(int mode) { this->Glyphs.SetMode(mode); }
  void SetMaximumNumberOfGlyphs(int number) { this->Glyphs.Settings.Mask.MaximumNumberOfGlyphs = number; }
  void SetGlyphStride(int stride) { this->Glyphs.Settings.Mask.Stride = stride; }
  ///@}

  /**
   * How much of their opacity trails lose to their last step, in [0, 1]. Default is 0.
   */
  void SetTrailFading(double fading) { this->Glyphs.TrailFading = std::clamp(OrZero(fading), 0.0, 1.0); }

  ///@{
  /**
   * Tubes: radius in world units, times the values of an array of points or cells ("None" or empty: none), default is
   * 1, None; lines end in half balls (0, default) or discs (1).
   */
  void SetTubeRadius(double radius) { this->Tubes.Settings.Radius = OrZero(radius); }
  void SetTubeRadiusArray(const char* name) { this->Tubes.Settings.RadiusArray = OrEmpty(name); }
  void SetTubeEnds(int ends) { this->Tubes.Settings.FlatEnds = ends == 1; }
  ///@}

  /**
   * Surfaces, 0 (VTK_FLAT): each triangle has its own normal. Any other: the points' normals are interpolated, which
   * are computed where the data have none. Default is 1, VTK_GOURAUD.
   */
  void SetInterpolation(int interpolation) override;

  // vtkPVDataRepresentation
  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  vtkDataObject* GetRenderedDataObject(int port) override; // 1: what the last frame showed instead, or null

protected:
  vtkRayTracedRepresentation();
  ~vtkRayTracedRepresentation() override;

  /// The main actor, which GetActor() returns, too.
  vtkPVLODActor* GetRenderedProp() override { return this->Common.Parts.Actor; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  bool NeedsOrderedCompositing() override;

private:
#ifndef __VTK_WRAP__
  friend class rtglyphs::RayTracedRendering; // takes over what the superclass keeps of appearance, colors and blocks
#endif

  /// Strings of the server manager may be null, which means no array.
  static std::string OrEmpty(const char* name)
  {
    return name ? name : "";
  }
  /// Numbers may be NaN, which counts as 0.
  static double OrZero(double number)
  {
    return rtglyphs::RayTracedNumbers::NumberOr(number, 0.0);
  }

  // Properties
  void SetArray(std::string& held, const char* name);
  void SetTable(bool sourceIndexing, bool useSourceTableTree);
  void GatherIf(bool changed);

  // The data side
  rtglyphs::RayTracedParallel::Progress ProgressOf(const char* what); // to ParaView's progress bar
  void ProcessRequest(vtkInformationRequestKey* request, vtkInformation* inInfo);
  void Gather(vtkDataObject* input, const int* wholeExtent);
  void Complete(vtkPolyData* points);
  bool WithinMemory(const std::function<void()>& work, bool together);

  rtglyphs::RayTracedCommon Common;
  rtglyphs::GlyphContent Glyphs;
  rtglyphs::SurfaceContent Surface;
  rtglyphs::TubeContent Tubes;
  rtglyphs::RayTracedContent* Content; // one of these
  rtglyphs::RayTracedRendering Rendering;
  vtkSmartPointer<vtkDataObject> Gathered;
  rtglyphs::RayTracedCache<std::tuple<vtkDataObject*, vtkMTimeType, vtkMTimeType, std::array<int, 3>, int>> GatherCache;
  std::uint64_t Gathers = 0;
  double GatherSeconds = 0.0;
  vtkSmartPointer<vtkDataObject> Piece;      // gathered, not yet delivered
  bool Guarded = false, LacksMemory = false; // see WithinMemory()
};

#endif
