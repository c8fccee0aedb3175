/**
 * @class   vtkRayTracedRepresentation
 * @brief   what ray-traced glyphs, surfaces and tubes have in common: delivery and motion
 *
 * Appearance, placement, colors and blocks are those of ParaView's ordinary surface. Of the superclass neither the
 * geometry filter is run nor the actor rendered: its MultiBlockMaker delivers what is gathered, and actors of ours
 * follow its actor.
 *
 * Points or triangles are gathered where the data are, in RequestData(). REQUEST_UPDATE hands them to the view with
 * their bounds and touches nothing of the render side. Mappers, actors and the renderer's vtkRayTracedScene are made
 * when something is first rendered, and configured from the properties at each REQUEST_RENDER. Which work a change of a
 * property causes is found out there by comparing; only what needs a new gather or delivery calls MarkModified().
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
#include "GlyphBounds.h"
#include "RayTracedBlocks.h"
#include "RayTracedNumbers.h"
#include "RayTracedParallel.h"
#include "RayTracedPeriodic.h"
#include "RayTracedSection.h"
#include "RayTracedTime.h"
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkPVRenderView;
class vtkRayTracedActor;
class vtkRayTracedMapper;
class vtkRayTracedScene;

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedRepresentation : public vtkGeometryRepresentation
{
public:
  vtkTypeMacro(vtkRayTracedRepresentation, vtkGeometryRepresentation);

  ///@{
  /**
   * Motion blur: names of point arrays of two or three components ("None" or empty: none), the time that the shutter is
   * open, and when that is, of GlyphMotion::Openings. Velocities may instead be those of GlyphStepVelocity, where
   * an array of one component, by default the global ids, identifies points. See GlyphMotion::Settings for
   * defaults.
   */
  void SetMotionBlur(bool on) { this->Time.Motion.On = on; }
  void SetVelocityArray(const char* name) { this->SetArray(this->Time.Motion.Velocity, name); }
  void SetVelocityFromPreviousStep(bool on) { this->GatherIf(this->Time.SetVelocityFromPreviousStep(on)); }
  void SetPointIdArray(const char* name) { this->GatherIf(this->Time.SetPointIdArray(OrEmpty(name))); }
  void SetAccelerationArray(const char* name) { this->SetArray(this->Time.Motion.Acceleration, name); }
  void SetAngularVelocityArray(const char* name) { this->SetArray(this->Time.Motion.AngularVelocity, name); }
  void SetMotionBlurMask(const char* name) { this->Time.Motion.Mask = OrEmpty(name); }
  void SetShutterTimeFromData(bool on) { this->Time.SetShutterTimeFromData(on); }
  void SetShutterTime(double time) { this->Time.Motion.ShutterTime = rtglyphs::RayTracedNumbers::NumberOr(time, 0.0); }
  void SetShutterOpening(int opening) { this->Time.Motion.Opening = std::clamp(opening, 0, 2); }
  ///@}

  /**
   * In how many earlier time steps the points are sought (GlyphStepTrail), for representations that show their trails.
   * Default is 0.
   */
  void SetTrailSteps(int steps) { this->GatherIf(this->Time.SetTrailSteps(steps)); }

  /**
   * The shutter time that the data suggest while ShutterTimeFromData is on (default): GlyphShutterGuess's, or with
   * velocities from the previous step the time between the two. 0: none yet. Processes that have data use it by
   * themselves; those that only render get it by SetShutterTime().
   */
  double GetShutterTimeGuess() { return this->Time.GetShutterTimeGuess(); }

  ///@{
  /**
   * A periodic box of the data, as RayTracedPeriodic has it.
   */
  void SetPeriodicBoundary(bool on);
  void SetPeriodicVectors(int index, double value);
  void SetPeriodicImages(int a, int b, int c) { this->Periodic.Images = { a, b, c }; }
  ///@}

  ///@{
  /**
   * A cut: kinds and faces are those of RayTracedSection. Of a plane what lies on the side of its normal is cut off, of
   * a box, or of the slab of that thickness about the plane, what is outside; not inverted the opposite. All in world
   * coordinates. With `moves` glyphs take their cut along.
   */
  void SetSection(int kind) { this->Section.Kind = kind; }
  void SetSectionInvert(bool invert) { this->Section.Invert = invert; }
  void SetSectionMoves(bool moves) { this->Section.Moves = moves; }
  void SetSectionOrigin(double x, double y, double z) { this->Section.Origin = { x, y, z }; }
  void SetSectionNormal(double x, double y, double z) { this->Section.Normal = { x, y, z }; }
  void SetSectionThickness(double thickness) { this->Section.Thickness = thickness; }
  void SetSectionPosition(double x, double y, double z) { this->Section.Position = { x, y, z }; }
  void SetSectionRotation(double x, double y, double z) { this->Section.Rotation = { x, y, z }; }
  void SetSectionLength(double x, double y, double z) { this->Section.Length = { x, y, z }; }
  void SetSectionCaps(int faces) { this->Section.Face = faces; }
  void SetSectionCapColor(double red, double green, double blue)
  {
    this->Section.CapColor = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
  }
  ///@}

  // vtkPVDataRepresentation
  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  vtkDataObject* GetRenderedDataObject(int port) override;

protected:
  vtkRayTracedRepresentation();
  ~vtkRayTracedRepresentation() override;

  /// The actor of the glyphs or the surface, which GetActor() returns, too.
  vtkPVLODActor* GetRenderedProp() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestUpdateTime(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  ///@{
  /**
   * The data side. Gather() makes what is delivered to the mapper of one data set, a block of composite data or all,
   * and reports to `progress`; `wholeExtent` is null unless it is a piece of a structured data set; Arrays() are names
   * of those that are to be made of several. GetDataBounds() are those of everything shown of gathered or delivered
   * points, before the actor's transform. Deliver() may hand further pieces to the view.
   */
  virtual vtkSmartPointer<vtkDataObject> GatherTree(vtkDataObject* input, const int* wholeExtent);
  virtual vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const rtglyphs::RayTracedParallel::Progress& progress) = 0;
  virtual std::vector<std::string> Arrays() const;
  virtual const double* GetDataBounds(vtkPolyData* points) = 0;
  virtual void Deliver(vtkInformation*, bool /*lod*/) {}
  ///@}

  /**
   * Glyphs at the points that are as large as what is shown, of a unit glyph of that length.
   */
  virtual rtglyphs::GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) = 0;

  int GetTrailSteps() const { return this->Time.GetTrailSteps(); }
  bool HasTrails() const { return this->GetTrailSteps() > 0; }

  rtglyphs::GlyphMotion::Settings GetMotion() const { return this->Time.GetMotion(); }

  ///@{
  /**
   * The render side. MakeMapper() is called once; Configure() at each render, with the delivered points (may be null).
   * `collective`: all ranks render together. Hide() is called when the representation is hidden. SetPartBounds(), once
   * there is a mapper: of its actors and layers.
   */
  virtual vtkSmartPointer<vtkRayTracedMapper> MakeMapper() = 0;
  virtual void Configure(vtkInformation* inInfo, vtkPolyData* points, bool lod, bool collective) = 0;
  virtual void SetPartBounds(const double bounds[6]);
  virtual void ShowLayers(bool /*visible*/) {}
  virtual void RemoveLayers(vtkPVRenderView*) {}
  ///@}

  ///@{
  /**
   * Adds an actor to the view's renderer and scene as part of this representation, or takes it out.
   */
  void AddPart(vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper);
  void RemovePart(vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper);
  ///@}

  /**
   * For GetDataBounds(): a box around glyphs of all these settings.
   */
  const double* GetBoundsOf(vtkPolyData* points, const std::vector<rtglyphs::GlyphSettings>& settings);

  /**
   * Reports to ParaView's progress bar.
   */
  rtglyphs::RayTracedParallel::Progress ProgressOf(const char* what);

  vtkRayTracedMapper* GetMapper();
  vtkPolyData* GetPoints() { return this->Blocks.GetPoints(); }
  vtkPVRenderView* GetRenderView();

  /**
   * Strings of the server manager may be null, which means no array.
   */
  static std::string OrEmpty(const char* name) { return name ? name : ""; }

  /**
   * For properties that name an array which AddArrays() may have to make of several.
   */
  void SetArray(std::string& held, const char* name);

  rtglyphs::RayTracedTime Time;
  rtglyphs::RayTracedBlocks Blocks; // of what was last delivered or rendered

private:
  void ProcessRequest(vtkInformationRequestKey* request, vtkInformation* inInfo);
  void GatherIf(bool changed);
  int EmptyType() const;
  void Complete(vtkPolyData* points);
  bool WithinMemory(const std::function<void()>& work, bool together);
  bool IsCollective(vtkInformation* inInfo);
  void UseBlocks(vtkDataObject* data);
  void UpdateActor();
  void ReportAnew(const std::string& problem, std::string& reported);
  void UpdateSection();
  rtg::PeriodicImages MakeImages(vtkDataObject* points, vtkDataObject* data, bool together);
  void Render(vtkPVRenderView* view, vtkInformation* inInfo);
  vtkRayTracedScene* GetScene();

  rtglyphs::GlyphBounds Bounds;
  std::uint64_t Gathers = 0;
  double GatherSeconds = 0.0;
  vtkNew<vtkRayTracedActor> MainActor;                       // in no renderer until it is shown
  vtkSmartPointer<vtkRayTracedMapper> MainMapper;            // null until something is rendered
  vtkSmartPointer<vtkDataObject> Piece;                      // gathered, not yet delivered
  vtkNew<vtkCompositeDataDisplayAttributes> BlockAttributes; // of the data, as they were at that time
  vtkDataObject* AttributedData = nullptr;                   // only to be compared
  vtkMTimeType AttributedTime = 0;
  bool Guarded = false, LacksMemory = false; // see WithinMemory()
  rtglyphs::RayTracedPeriodic Periodic;
  std::shared_ptr<rtg::PeriodicImages> MadeImages; // of all mappers
  std::string PeriodicProblem;                     // that has been reported
  rtglyphs::RayTracedSection Section;
  std::shared_ptr<rtg::Section> MadeSection; // of all mappers
  std::string SectionProblem;                // that has been reported
};

#endif
