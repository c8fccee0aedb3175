/**
 * @class   RayTracedRendering
 * @brief   the render side of a representation: actors of its content, from what is delivered to the view
 *
 * Appearance, placement, colors and attributes of blocks are those of ParaView's representation, whose actor and mapper
 * are not rendered. A cut and periodic images change what is rendered, not the data.
 */
#ifndef RayTracedRendering_h
#define RayTracedRendering_h

#include "GlyphBounds.h"
#include "RayTracedContent.h"
#include "RayTracedPeriodic.h"
#include "RayTracedSection.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkInformation;
class vtkPVRenderView;
class vtkRayTracedRepresentation;
class vtkRayTracedScene;

namespace rtglyphs
{

class RayTracedRendering
{
public:
  RayTracedRendering(vtkRayTracedRepresentation* owner, RayTracedCommon& common);

  ///@{
  /**
   * As the properties say.
   */
  RayTracedPeriodic Periodic;
  RayTracedSection Section;
  ///@}

  /**
   * Where the owner is shown: null while it is in no view, the scene until that has something ray traced. Collective:
   * all ranks render together.
   */
  vtkPVRenderView* GetView() const;
  vtkRayTracedScene* GetScene() const;
  bool IsCollective(vtkInformation* inInfo) const;

  ///@{
  /**
   * REQUEST_UPDATE: the blocks of a piece, which may be null, with their attributes, unless they are the same; then its
   * bounds, before the actor's transform, for the view.
   */
  void Show(vtkDataObject* piece) { this->Show(piece, this->All); }
  void UpdateBounds(RayTracedContent& content, vtkInformation* inInfo, vtkDataObject* piece);
  ///@}

  /**
   * Attributes of blocks have changed.
   */
  void ForgetBlocks() { this->All.Data = this->Reduced.Data = nullptr; }

  /**
   * Images of points, for which `data` may have the box. `Together`: all ranks ask at once.
   */
  rtg::PeriodicImages MakeImages(vtkDataObject* points, vtkDataObject* data, bool together);

  ///@{
  /**
   * REQUEST_RENDER: of what was delivered, or of `piece` where nothing was. GetReduced() is what the last frame showed
   * instead, or null.
   */
  void Render(RayTracedContent& content, vtkInformation* inInfo, vtkDataObject* piece, bool translucent);
  vtkDataObject* GetReduced() const { return this->PieceLOD; }
  const GlyphBounds& GetBounds() const { return this->All.Bounds; }
  ///@}

  /**
   * Takes all actors out of the view.
   */
  void Remove(RayTracedContent& content);

private:
  struct Shown
  {
    explicit Shown(RayTracedBlocks& blocks)
      : Blocks(blocks)
    {
    }
    RayTracedBlocks& Blocks;
    GlyphBounds Bounds;
    vtkNew<vtkCompositeDataDisplayAttributes> Attributes; // of Data's blocks, as they were at Time
    vtkDataObject* Data = nullptr;                        // only to be compared
    vtkMTimeType Time = 0;
  };

  void Show(vtkDataObject* data, Shown& shown);
  static const double* BoundsOf(RayTracedContent& content, vtkPolyData* points, Shown& shown);
  void SetBounds(RayTracedContent& content, const double bounds[6]);
  void ReportAnew(const std::string& problem, std::string& reported) const;

  vtkRayTracedRepresentation* const Owner;
  RayTracedCommon& Common;
  Shown All;
  Shown Reduced; // what the content makes of it for frames that must come at once
  vtkSmartPointer<vtkDataObject> PieceLOD;
  bool ReducedFirst = false;                   // whether the last frame at rest has shown it
  std::string PeriodicProblem, SectionProblem; // that have been reported
};

} // namespace rtglyphs

#endif
