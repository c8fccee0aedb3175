/**
 * @class   RayTracedContent
 * @brief   what a ray-traced representation shows of its data: glyphs, the surface or tubes
 *
 * @sa vtkRayTracedRepresentation
 */
#ifndef RayTracedContent_h
#define RayTracedContent_h

#include "DataSummary.h"
#include "GlyphSettings.h"
#include "RayTracedBlocks.h"
#include "RayTracedParallel.h"
#include "RayTracedParts.h"
#include "RayTracedTime.h"
#include "vtkDirectionLegend.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkPVDataRepresentation;
class vtkPVRenderView;
class vtkPolyData;

namespace rtglyphs
{

/**
 * The same for all contents of a representation.
 */
struct RayTracedCommon
{
  RayTracedTime Time;
  RayTracedBlocks Blocks;  // of what was last delivered or rendered
  RayTracedBlocks Reduced; // of what Reduce() has made of it
  RayTracedParts Parts;
  bool HasData = false; // a process that only renders has none
  DataSummary::Values Summary = DataSummary::None();
  std::array<double, 3> SelectionColor{ { 1.0, 0.0, 1.0 } };
  RayTracedEnum<DirectionColors::Kinds, DirectionColors::NONE, DirectionColors::SPHERE> DirectionColoring;
  vtkNew<vtkDirectionLegend> Key; // shows what the content does with DirectionColoring
};

class RayTracedContent
{
public:
  explicit RayTracedContent(RayTracedCommon& common)
    : Common(common)
  {
  }
  virtual ~RayTracedContent() = default;
  RayTracedContent(const RayTracedContent&) = delete;
  RayTracedContent& operator=(const RayTracedContent&) = delete;

  ///@{
  /**
   * The data side. Gather() makes what is delivered to the mapper of one data set, a block of composite data or all,
   * and reports to `progress`; `wholeExtent` is null unless it is a piece of a structured data set. It depends on the
   * data and GatherOptions() alone. Arrays() are names of those that are to be made of several. Deliver() may hand
   * further pieces to the view. GetSizes() are of glyphs at the points that are as large as what is shown, of a unit
   * glyph of that length; GetAllSizes() of everything shown, for its bounds.
   */
  virtual vtkSmartPointer<vtkPolyData> Gather(
    vtkDataObject* data, const int* wholeExtent, bool isBlock, const RayTracedParallel::Progress& progress) const = 0;
  virtual std::array<int, 3> GatherOptions() const = 0; // the first is the content's number
  virtual bool NeedsGhostCells() const { return false; }
  virtual bool HasTrails() const { return false; }
  virtual bool MarksSelection() const { return true; }
  virtual std::vector<std::string> Arrays() const { return {}; }
  virtual GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) = 0;
  virtual std::vector<GlyphSettings> GetAllSizes(vtkPolyData* points)
  {
    double unitSize = 1.0;
    return { this->GetSizes(points, unitSize) };
  }
  virtual void Deliver(vtkInformation*, vtkPVDataRepresentation*, bool /*lod*/) {}
  virtual bool IsTranslucent() const { return false; }
  ///@}

  /**
   * A render. `Collective`: all ranks render together.
   */
  struct Frame
  {
    vtkInformation* Info;
    vtkPVDataRepresentation* Representation;
    vtkPVRenderView* View;
    vtkPolyData* Points; // delivered; may be null
    bool LOD, Collective, Translucent;
  };

  ///@{
  /**
   * The render side. MakeMapper() is called when something is first rendered, Configure() at each render. Show() and
   * RemoveLayers() concern what is drawn besides the mapper, in the view and its corners.
   */
  virtual vtkSmartPointer<vtkRayTracedMapper> MakeMapper() const = 0;
  virtual void Configure(const Frame& frame) = 0;
  virtual void Show(bool visible) { this->Common.Key->SetVisibility(visible); }
  virtual void SetLayerBounds(const double /*bounds*/[6]) {}
  virtual void RemoveLayers(vtkPVDataRepresentation*, vtkPVRenderView*) {}
  ///@}

  ///@{
  /**
   * Reduce() returns fewer points that show nearly the same as `data`, whose blocks are Common.Blocks, within these
   * bounds, for frames that must come at once; `resolution` is ParaView's, in [0, 1]. Null: there are none.
   * ShowReduced() says whether Common.Reduced is shown in place of what Configure() has configured.
   */
  virtual vtkDataObject* Reduce(vtkDataObject* /*data*/, const double /*bounds*/[6], double /*resolution*/)
  {
    return nullptr;
  }
  virtual void ShowReduced(const Frame&, bool /*reduced*/) {}
  ///@}

protected:
  RayTracedCommon& Common;
};

} // namespace rtglyphs

#endif
