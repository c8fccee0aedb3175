/**
 * @class   vtkRayTracedGlyphMapper
 * @brief   shows points as ray-traced glyphs
 *
 * Input is the vtkPolyData of vtkGlyphPointGatherer. The mapper turns points and arrays into glyph instances and
 * colours, each only when something they depend on has changed; the vtkRayTracedGlyphScene of the renderer, which all
 * mappers in it share, traces and draws them.
 *
 * @sa vtkGlyphInstanceBuilder vtkRayTracedGlyphScene
 */
#ifndef vtkRayTracedGlyphMapper_h
#define vtkRayTracedGlyphMapper_h

#include "vtkGlyphBlockAttributes.h"
#include "vtkRayTracedGlyphLight.h"
#include "vtkGlyphInstanceBuilder.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRayTracedGlyphScene;
class vtkRenderer;

class vtkRayTracedGlyphMapper : public vtkMapper
{
public:
  static vtkRayTracedGlyphMapper* New();
  vtkTypeMacro(vtkRayTracedGlyphMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How arrays become glyphs. May be changed at any time; what a change touches is found out at the next render.
   */
  vtkGlyphInstanceBuilder::Settings Glyphs;

  /**
   * The form of glyphs of shape Mesh, in its own frame and size: the triangles of a vtkRayTracedSurfaceGatherer.
   */
  void SetGlyphMesh(vtkPolyData* mesh);

  ///@{
  /**
   * Visibility, colour and opacity of blocks. Call BlocksModified() after a change.
   */
  vtkGlyphBlockAttributes Blocks;
  void BlocksModified() { this->BlocksTime.Modified(); }
  ///@}

  /**
   * The light that the view is asked for.
   */
  vtkRayTracedGlyphLight Light;

  /**
   * Where the view's finished images leave what they show besides colours (vtkRayTracedGlyphScene); empty: nowhere. The first of
   * a view's mappers that names a file counts.
   */
  std::string FeatureImageFile;

  ///@{
  /**
   * Samples of a finished image. In [1, 65536]; the largest of a view's mappers counts. Default is 16.
   */
  vtkSetClampMacro(SamplesPerPixel, int, 1, 65536);
  vtkGetMacro(SamplesPerPixel, int);
  ///@}

  ///@{
  /**
   * Samples that one render adds while the image is not finished; 0: all of them. Default is 0.
   */
  vtkSetClampMacro(SamplesPerRender, int, 0, 65536);
  vtkGetMacro(SamplesPerRender, int);
  ///@}

  ///@{
  /**
   * While the camera moves, only every n-th pixel in x and y is traced. In [1, 16]. Default is 2.
   */
  vtkSetClampMacro(InteractiveReduction, int, 1, 16);
  vtkGetMacro(InteractiveReduction, int);
  ///@}

  ///@{
  /**
   * Whoever renders goes on until the image is finished: with SamplesPerRender 0, one render adds what fits into a
   * tenth of a second instead of all. Default is off.
   */
  vtkSetMacro(StepwiseRendering, bool);
  vtkGetMacro(StepwiseRendering, bool);
  ///@}

  ///@{
  /**
   * Joins or leaves the scene of a renderer. A mapper that is rendered without joining does so then.
   */
  void Join(vtkRenderer* renderer);
  void Leave(vtkRenderer* renderer);
  ///@}

  /**
   * What the renderers of this mapper have done, as JSON; "{}" before the first render.
   */
  std::string GetStatistics();
  std::string GetDeviceName();
  int GetAccumulatedSamples();

  // vtkMapper
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  double* GetBounds() override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  bool HasOpaqueGeometry() override { return !this->Translucent; }
  bool HasTranslucentPolygonalGeometry() override { return this->Translucent; }
  bool GetSupportsSelection() override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * For vtkRayTracedGlyphScene. Update() brings instances and colours up to date; their versions grow with
   * each change. TakeInstances() hands the instances over (they are built again for a second taker).
   */
  void Update(vtkActor* actor);
  std::uint64_t GetInstanceVersion() const { return this->InstanceVersion; }
  std::uint64_t GetColorVersion() const { return this->ColorVersion; }
  virtual rtg::GlyphInstances TakeInstances(vtkActor* actor);
  rtg::GlyphColours GetColors() const { return this->Colors8; }
  vtkIdType GetNumberOfGlyphs() const { return static_cast<vtkIdType>(this->Points.size()); }
  vtkIdType GetSkippedGlyphs() const { return this->Skipped; }
  ///@}

  ///@{
  /**
   * What picking says about a glyph: its point, or the cell of a mapper that PicksCells().
   */
  struct Origin
  {
    vtkIdType Id = 0;
    unsigned int CompositeIndex = 0;
    int Process = -1; // -1: this one
  };
  virtual Origin OriginOf(vtkIdType glyph);
  virtual bool PicksCells() const { return false; }
  ///@}

protected:
  vtkRayTracedGlyphMapper();
  ~vtkRayTracedGlyphMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  ///@{
  /**
   * For mappers that make something else of their input than glyphs at its points. Both fill in what follows; a new
   * version of instances or colours makes the scene take them.
   */
  virtual void BuildInstances(vtkPolyData* points, vtkActor* actor);
  virtual void BuildColors(vtkPolyData* points);
  void TensorColor(const vtkGlyphTensors& tensors, vtkIdType point, double rgb[3]);
  ///@}

  /**
   * Time stamps of what else the instances depend on.
   */
  virtual std::vector<vtkMTimeType> FurtherTimes(vtkPolyData* points) const;

  /**
   * A number that no mapper of this process has had as a version.
   */
  static std::uint64_t NewVersion();

  vtkPolyData* GetPoints();
  void Report(const std::vector<std::string>& messages, std::vector<std::string>& reported);

  vtkGlyphBlockAttributes::Table BlockTable;
  rtg::GlyphInstances Instances;
  std::vector<vtkIdType> Points; // of each glyph
  vtkIdType Skipped = 0;
  bool Translucent = false;
  std::array<double, 3> SolidColor{ { 1.0, 1.0,
    1.0 } }; // of blocks without their own, where some have one
  std::uint64_t InstanceVersion = 0, ColorVersion = 0, PointsVersion = 0;
  std::vector<std::string> ReportedInstances, ReportedColors;

private:
  vtkRayTracedGlyphMapper(const vtkRayTracedGlyphMapper&) = delete;
  void operator=(const vtkRayTracedGlyphMapper&) = delete;

  struct InstanceKey;
  struct ColorKey;

  void UpdateBlocks(vtkPolyData* points);
  InstanceKey MakeInstanceKey(vtkPolyData* points) const;
  ColorKey MakeColorKey(vtkPolyData* points, vtkActor* actor);

  int SamplesPerPixel = 16;
  int SamplesPerRender = 0;
  int InteractiveReduction = 2;
  bool StepwiseRendering = false;

  vtkTimeStamp BlocksTime, BlockTableTime;

  vtkWeakPointer<vtkPolyData> GlyphMesh; // that Glyphs.Mesh was made of
  vtkMTimeType GlyphMeshTime = 0;

  std::unique_ptr<InstanceKey> Built, Bounded;
  std::unique_ptr<ColorKey> Colored;
  bool InstancesTaken = false;
  rtg::GlyphColours Colors8;
  std::array<std::uint64_t, 2> Digest{}; // of the instances of InstanceVersion

  std::vector<vtkSmartPointer<vtkRayTracedGlyphScene>> Scenes;
};

#endif
