#include "RayTracedRendering.h"

#include "Tracer.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#endif

#include <algorithm>
#include <utility>

namespace
{
// ParaView says so to subclasses of its views only.
struct ScreenshotState : vtkPVRenderView
{
  static bool Of(vtkPVView* view) { return (view->*(&ScreenshotState::GetInCaptureScreenshot))(); }
};
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedRendering::RayTracedRendering(vtkRayTracedRepresentation* owner, RayTracedCommon& common)
  : Owner(owner)
  , Common(common)
  , All(common.Blocks)
  , Reduced(common.Reduced)
{
}

//----------------------------------------------------------------------------
vtkPVRenderView* rtglyphs::RayTracedRendering::GetView() const
{
  return vtkPVRenderView::SafeDownCast(this->Owner->GetView());
}

//----------------------------------------------------------------------------
vtkRayTracedScene* rtglyphs::RayTracedRendering::GetScene() const
{
  vtkPVRenderView* view = this->GetView();
  return view ? vtkRayTracedScene::Find(view->GetRenderer()) : nullptr;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedRendering::IsCollective(vtkInformation* inInfo) const
{
  vtkPVRenderView* view = this->GetView();
  return view &&
    (inInfo->Has(vtkPVRenderView::USE_LOD()) ? view->GetUseDistributedRenderingForLODRender()
                                             : view->GetUseDistributedRenderingForRender());
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRendering::Show(vtkDataObject* data, Shown& shown)
{
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (!shown.Data || data != shown.Data || time != shown.Time)
  {
    this->Owner->PopulateBlockAttributes(shown.Attributes, data);
    shown.Attributes->Modified();
    shown.Data = data;
    shown.Time = time;
  }
  vtkMapper* mapper = this->Owner->Mapper;
  RayTracedBlocks::Attributes common;
  RayTracedBlocks::Coloring& scalars = common.Scalars;
  scalars.On = mapper->GetScalarVisibility() != 0;
  if (scalars.On)
  {
    scalars.Array = mapper->GetArrayName() ? mapper->GetArrayName() : "";
    scalars.Table = mapper->GetLookupTable(); // a mapper without one makes one
  }
  scalars.ScalarMode = mapper->GetScalarMode();
  scalars.ColorMode = mapper->GetColorMode();
  scalars.InterpolatesScalars = mapper->GetInterpolateScalarsBeforeMapping();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  auto* composite = vtkCompositePolyDataMapper::SafeDownCast(mapper);
  scalars.MissingIsNan = composite && composite->GetColorMissingArraysWithNanColor();
#endif
  shown.Blocks.Update(data, shown.Attributes, common);
}

//----------------------------------------------------------------------------
// Bounds of everything that is shown of gathered or delivered points.
const double* rtglyphs::RayTracedRendering::BoundsOf(RayTracedContent& content, vtkPolyData* points, Shown& shown)
{
  return shown.Bounds.Get(points, content.GetAllSizes(points), shown.Blocks.GetHidden());
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRendering::SetBounds(RayTracedContent& content, const double bounds[6])
{
  this->Common.Parts.Mapper->SetKnownBounds(bounds);
  content.SetLayerBounds(bounds);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRendering::UpdateBounds(RayTracedContent& content, vtkInformation* inInfo, vtkDataObject* piece)
{
  vtkPolyData* points = this->Common.Blocks.GetPolyData();
  double bounds[6];
  std::copy_n(BoundsOf(content, points, this->All), 6, bounds);
  ExtendBounds(this->MakeImages(points, piece, /*together=*/true), bounds);
  RayTracedParts& parts = this->Common.Parts;
  parts.UpdateActor(this->Owner->Actor);
  vtkPVRenderView::SetGeometryBounds(inInfo, this->Owner, bounds, parts.Actor->GetMatrix());
  if (parts.Mapper)
  {
    // The clipping range takes those of actors, too: old ones that were larger would hold until the next update.
    this->SetBounds(content, bounds);
  }
}

//----------------------------------------------------------------------------
// Reports a problem with properties, unless there is none or it was reported last.
void rtglyphs::RayTracedRendering::ReportAnew(const std::string& problem, std::string& reported) const
{
  if (problem != std::exchange(reported, problem) && !problem.empty())
  {
    vtkErrorWithObjectMacro(this->Owner, << problem);
  }
}

//----------------------------------------------------------------------------
rtg::PeriodicImages rtglyphs::RayTracedRendering::MakeImages(vtkDataObject* points, vtkDataObject* data, bool together)
{
  std::string problem;
  const rtg::PeriodicImages images = this->Periodic.Make(points, data, together, problem);
  if (this->Periodic.Boundary)
  {
    this->ReportAnew(problem, this->PeriodicProblem);
  }
  return images;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRendering::Remove(RayTracedContent& content)
{
  RayTracedParts& parts = this->Common.Parts;
  if (parts.Mapper)
  {
    content.RemoveLayers(this->Owner, this->GetView());
    parts.Remove(this->Owner, this->GetView(), parts.Actor, parts.Mapper);
    parts.Mapper = nullptr;
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRendering::Render(
  RayTracedContent& content, vtkInformation* inInfo, vtkDataObject* piece, bool translucent)
{
  vtkPVDataRepresentation* owner = this->Owner;
  vtkPVRenderView* view = this->GetView();
  RayTracedParts& parts = this->Common.Parts;
  if (!parts.Mapper)
  {
    parts.Mapper = content.MakeMapper();
    parts.Add(owner, view, parts.Actor, parts.Mapper);
  }
  parts.UpdateActor(this->Owner->Actor);
  std::string problem;
  *parts.Section = this->Section.Make(problem);
  this->ReportAnew(problem, this->SectionProblem);
  const bool lod = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  vtkDataObject* delivered =
    lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, owner) : vtkPVView::GetDeliveredPiece(inInfo, owner);
  vtkRayTracedScene* scene = this->GetScene();
  const bool stepwise = scene->GetSettings().IsStepwise(), capture = ScreenshotState::Of(view);
  // A selection may come before new points have been delivered: it finds what is shown.
  if (delivered || !piece)
  {
    this->Show(delivered, this->All);
    parts.Mapper->SetBlocks(this->Common.Blocks);
  }
  vtkPolyData* points = parts.Mapper->GetPolyData();
  const bool collective = this->IsCollective(inInfo);
  parts.Mapper->SetInWindow(stepwise);
  const RayTracedContent::Frame frame{ inInfo, owner, view, points, lod, collective, translucent };
  content.Configure(frame);
  // In a window fewer glyphs come first where many must be built.
  const bool first = stepwise && !lod && !capture && !(this->ReducedFirst && scene->HasPicture()) && delivered &&
    static_cast<double>(delivered->GetActualMemorySize()) > 1024.0 * view->GetLODRenderingThreshold() &&
    parts.Mapper->NeedsBuild(parts.Actor);
  this->PieceLOD = points && delivered && (lod || first)
    ? content.Reduce(delivered, BoundsOf(content, points, this->All), view->GetLODResolution())
    : nullptr;
  const bool reduced = this->PieceLOD != nullptr;
  Shown& shown = reduced ? this->Reduced : this->All;
  this->ReducedFirst = reduced && first;
  if (reduced)
  {
    delivered = this->PieceLOD;
    this->Show(delivered, shown);
    points = shown.Blocks.GetPolyData();
  }
  if (this->ReducedFirst)
  {
    scene->ExpectAnother();
  }
  content.ShowReduced(frame, reduced);
  vtkNew<vtkPolyData> nothing;
  double bounds[6];
  std::copy_n(BoundsOf(content, points ? points : nothing.Get(), shown), 6, bounds);
  rtg::PeriodicImages images = this->MakeImages(points, delivered, collective);
  ExtendBounds(images, bounds);
  // In an unbounded domain no sky is visible: light from any distance meets only what is shown.
  const RayTracedImageSettings& light = scene->GetSettings();
  if (light.ShadingMode != static_cast<int>(rtg::Shading::AmbientOcclusion) || light.AmbientOcclusionRadius <= 0.0)
  {
    images.lit = images.shown;
  }
  this->SetBounds(content, bounds);
  *parts.Images = Moved(images, parts.Actor->GetMatrix());
  scene->SetFrameKind(capture, collective, view->GetUseOrderedCompositing());
}
