/**
 * @class   GlyphContent
 * @brief   the points or cells of any data set as glyphs
 *
 * @sa vtkGlyph3DRepresentation, whose scale and orientation arrays have the same meaning here.
 */
#ifndef GlyphContent_h
#define GlyphContent_h

#include "GlyphMeshes.h"
#include "GlyphReduction.h"
#include "GlyphKeptGuess.h"
#include "GlyphSettings.h"
#include "GlyphShapes.h"
#include "GlyphTensorRange.h"
#include "RayTracedContent.h"
#include "vtkGlyphLegend.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkScalarsToColors.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace rtglyphs
{

class GlyphContent final : public RayTracedContent
{
public:
  using RayTracedContent::RayTracedContent;

  ///@{
  /**
   * As the properties say; Settings but for what MakeSettings() adds.
   */
  GlyphSettings Settings;
  int GlyphShape = GlyphShapes::GLYPH_TYPE;
  bool Cells = false; // glyphs stand at their centers, not at points
  bool Scaling = false;
  int ScaleMode = 0;
  bool SourceIndexing = false, UseSourceTableTree = false;
  bool FixedHeads = false;
  std::string HarmonicsArray, ShellArray;
  double TrailFading = 0.0;
  bool TensorAxis = false;
  vtkSmartPointer<vtkScalarsToColors> TensorTable;
  ///@}

  /**
   * As the property GlyphMode has it, of which 0 is none.
   */
  void SetMode(int mode);

  void SetScaleFactorFromData(bool on);

  /**
   * The mesh, or table of meshes, of GLYPH_TYPE, which that filter has made; may be null.
   */
  void GatherMeshes(vtkDataObject* source, vtkAlgorithm* from);

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const RayTracedParallel::Progress& progress) const override;
  std::array<int, 3> GatherOptions() const override { return { 0, this->Cells, 0 }; }
  bool HasTrails() const override { return this->Common.Time.Steps.GetTrailSteps() > 0; }
  std::vector<std::string> Arrays() const override;
  GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) override;
  std::vector<GlyphSettings> GetAllSizes(vtkPolyData* points) override;
  void Deliver(vtkInformation* info, vtkPVDataRepresentation* representation, bool lod) override;
  bool IsTranslucent() const override;
  vtkDataObject* Reduce(vtkDataObject* data, const double bounds[6], double resolution) override;

  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() const override
  {
    return vtkSmartPointer<vtkRayTracedGlyphMapper>::New();
  }
  void Configure(const Frame& frame) override;
  void ShowReduced(const Frame& frame, bool reduced) override;
  void Show(bool visible) override;
  void SetLayerBounds(const double bounds[6]) override
  {
    for (const auto* layers : { &this->Layers, &this->Reduced })
    {
      for (const auto& layer : *layers)
      {
        layer->Mapper->SetKnownBounds(bounds);
      }
    }
  }
  void RemoveLayers(vtkPVDataRepresentation* representation, vtkPVRenderView* view) override
  {
    this->Resize(this->Layers, 0, representation, view);
    this->Resize(this->Reduced, 0, representation, view);
  }
  vtkGlyphLegend* GetLegend() { return this->Legend; }

private:
  // What is drawn besides the main actor: its points, blocks, placement and appearance with other settings.
  struct Layer
  {
    vtkNew<vtkRayTracedActor> Actor;
    vtkNew<vtkRayTracedGlyphMapper> Mapper;
  };
  using LayerList = std::vector<std::unique_ptr<Layer>>;

  GlyphSettings MakeSettings() const;
  std::vector<GlyphSettings> MakeLayers(vtkPolyData* points) const;
  double ScalePercentile(vtkPolyData* points, const GlyphSettings& settings);
  std::array<double, 2> GetTensorRange() const
  {
    const double* range = &this->Common.Summary[DataSummary::LEAST_OF_TENSORS];
    return { range[0], range[1] };
  }
  void UpdateTensorRange(vtkPolyData* points);
  void UpdateScaleGuess(vtkPolyData* points, double time);
  void UpdateDataSizes(vtkPolyData* points);
  void UpdateLegend(const GlyphSettings& settings);
  void Resize(LayerList& layers, std::size_t size, vtkPVDataRepresentation* owner, vtkPVRenderView* view);
  void Update(Layer& layer, const RayTracedBlocks& blocks) const;

  vtkNew<vtkGlyphLegend> Legend;
  bool ScaleFactorFromData = false;
  GlyphKeptGuess Guess;
  RayTracedCache<GlyphArrays::Key> KnownScales; // of ScalePercentile()
  GlyphTensorRange NumberRange;
  GlyphMeshes Meshes;
  LayerList Layers; // of MakeLayers() all but the first
  GlyphReduction Reduction;
  LayerList Reduced; // at most one, instead of all others
};

} // namespace rtglyphs

#endif
