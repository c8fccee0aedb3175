#include "vtkRayTracedRepresentation.h"

#include "GlyphJoinedArrays.h"
#include "Glyphs.h"
#include "Tracer.h"
#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "RayTracedTree.h"
#include "Stopwatch.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#endif

#include <algorithm>
#include <new>
#include <utility>

vtkStandardNewMacro(vtkRayTracedRepresentation);

namespace
{
enum Ports
{
  GLYPH_TYPE_PORT = 1,
  SELECTION_PORT = 2,
  PORTS
};

// ParaView says so to subclasses of its views only.
struct ScreenshotState : vtkPVRenderView
{
  static bool Of(vtkPVView* view) { return (view->*(&ScreenshotState::GetInCaptureScreenshot))(); }
};
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::Shown::Shown(rtglyphs::RayTracedBlocks& blocks)
  : Blocks(blocks)
{
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::vtkRayTracedRepresentation()
  : Glyphs(this->Common)
  , Surface(this->Common)
  , Tubes(this->Common)
  , Content(&this->Glyphs)
  , All(this->Common.Blocks)
  , Reduced(this->Common.Reduced)
{
  this->SetNumberOfInputPorts(PORTS);
  this->RequestGhostCellsIfNeeded = false;
  this->Common.Parts.Progress = this->ProgressOf("Building glyphs");
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::~vtkRayTracedRepresentation() = default;

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetRepresentation(const char* name)
{
  const std::string subtype = OrEmpty(name);
  rtglyphs::RayTracedContent* content = &this->Glyphs;
  if (subtype == "Surface")
  {
    content = &this->Surface;
  }
  else if (subtype == "Tubes")
  {
    content = &this->Tubes;
  }
  if (content != this->Content)
  {
    this->RemoveParts();
    this->Content->Show(false);
    this->Content = content;
    this->Content->Show(this->GetVisibility());
    this->RequestGhostCellsIfNeeded = content->NeedsGhostCells();
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
vtkPVLODActor* vtkRayTracedRepresentation::GetRenderedProp()
{
  return this->Common.Parts.Actor;
}

//****************************************************************************
// The data side
//****************************************************************************

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == GLYPH_TYPE_PORT)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input =
    inputVector[0]->GetNumberOfInformationObjects() == 1 ? vtkDataObject::GetData(inputVector[0], 0) : nullptr;
  vtkDataObject* source = inputVector[GLYPH_TYPE_PORT]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[GLYPH_TYPE_PORT], 0)
    : nullptr;
  this->Glyphs.GatherMeshes(source, source ? this->GetInputAlgorithm(GLYPH_TYPE_PORT, 0) : nullptr);
  this->Selected.Take(this, SELECTION_PORT, vtkDataObject::GetData(inputVector[SELECTION_PORT], 0));
  vtkInformation* info = input ? inputVector[0]->GetInformationObject(0) : nullptr;
  const int* wholeExtent = info && info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    ? info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    : nullptr;
  rtg::Stopwatch watch;
  vtkSmartPointer<vtkDataObject> gathered = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(this->EmptyType()));
  bool again = false;
  const bool good = this->WithinMemory(
    [&]
    {
      if (input)
      {
        const vtkSmartPointer<vtkDataObject> made = this->Gather(input, wholeExtent);
        again = this->Content->HasTrails() &&
          this->Common.Time.AddTrails(made, input, this->GetUpdateTime(), info, this->GetInputAlgorithm(),
            [&] { return this->MakeImages(made, input, /*together=*/true); });
        if (again)
        {
          return;
        }
        this->Common.Time.AddVelocities(made, input, this->GetInputAlgorithm());
        rtglyphs::RayTracedTree::ForEach(made, [this](vtkPolyData* points) { this->Complete(points); });
        gathered = made;
      }
      rtglyphs::RayTracedTree::AddPartialArrays(gathered);
    },
    /*together=*/true);
  if (again && good)
  {
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  if (!good)
  {
    this->Common.Time.GiveUp();
  }
  else if (const std::string message = this->Common.Time.TakeMessage(); !message.empty())
  {
    vtkWarningMacro(<< message);
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  this->MultiBlockMaker->SetInputDataObject(gathered);
  this->MultiBlockMaker->Update();
  ++this->Gathers;
  this->GatherSeconds += watch.Lap();
  return this->vtkPVDataRepresentation::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> vtkRayTracedRepresentation::Gather(vtkDataObject* input, const int* wholeExtent)
{
  const int colors = std::max(1, this->GetBlockColorsDistinctValues());
  const auto gather = [&]
  {
    const bool blocks = input->IsA("vtkCompositeDataSet");
    const rtglyphs::RayTracedParallel::Progress progress = this->ProgressOf("Gathering points");
    const double all = std::max(1.0, static_cast<double>(input->GetNumberOfElements(vtkDataObject::POINT)));
    double done = 0.0;
    return rtglyphs::RayTracedTree::Make(input, colors,
      [&](vtkDataObject* data)
      {
        const double first = done;
        done += data ? static_cast<double>(data->GetNumberOfElements(vtkDataObject::POINT)) / all : 0.0;
        return this->Content->Gather(
          data, wholeExtent, blocks, rtglyphs::RayTracedParallel::Part(progress, first, std::min(done, 1.0)));
      });
  };
  this->Surface.NonlinearSubdivisionLevel =
    vtkPVGeometryFilter::SafeDownCast(this->GeometryFilter)->GetNonlinearSubdivisionLevel();
  const auto [content, first, second] = this->Content->GatherOptions();
  return this->Selected.Gather(input, { content, first, second, colors }, this->Content->MarksSelection(), gather);
}

//----------------------------------------------------------------------------
// Placeholder on processes without data: of the type that is received.
int vtkRayTracedRepresentation::EmptyType() const
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return this->PlaceHolderDataType;
#else
  return VTK_MULTIBLOCK_DATA_SET;
#endif
}

//----------------------------------------------------------------------------
// Arrays that are named as parts of one; and ParaView offers all arrays as colors but for those that are marked so.
void vtkRayTracedRepresentation::Complete(vtkPolyData* points)
{
  const rtglyphs::GlyphMotion::Settings& motion = this->Common.Time.Motion;
  std::vector<std::string> names = this->Content->Arrays();
  names.insert(names.end(), { motion.Velocity, motion.Acceleration, motion.AngularVelocity });
  for (const std::string& name : names)
  {
    rtglyphs::GlyphJoinedArrays::Add(points, name);
  }
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(points->GetPointData()),
         static_cast<vtkFieldData*>(points->GetCellData()), points->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (array->GetName() && rtglyphs::RayTracedArrays::IsOwn(array->GetName()))
      {
        array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
      }
    }
  }
}

//----------------------------------------------------------------------------
// Those of everything shown of gathered or delivered points, before the actor's transform.
const double* vtkRayTracedRepresentation::GetBounds(vtkPolyData* points, Shown& shown)
{
  return shown.Bounds.Get(points, this->Content->GetAllSizes(points), shown.Blocks.GetHidden());
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedParallel::Progress vtkRayTracedRepresentation::ProgressOf(const char* what)
{
  return [this, what](double share)
  {
    this->SetProgressText(what);
    this->UpdateProgress(share);
  };
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestUpdateTime(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int good = this->Superclass::RequestUpdateTime(request, inputVector, outputVector);
  this->Common.Time.AskForMissingStep(inputVector, this->GetNumberOfInputPorts());
  return good;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int good = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  this->Common.Time.AskForMissingStep(inputVector, this->GetNumberOfInputPorts());
  // The mesh of mesh glyphs is the same on all processes.
  for (int i = 0; i < inputVector[GLYPH_TYPE_PORT]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputVector[GLYPH_TYPE_PORT]->GetInformationObject(i);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::EXACT_EXTENT(), 1);
  }
  return good;
}

//----------------------------------------------------------------------------
vtkDataObject* vtkRayTracedRepresentation::GetRenderedDataObject(int port)
{
  return port == 0 ? this->Piece : this->PieceLOD;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // The superclass would fill attributes of blocks for its mapper and for bounds, neither of which is used.
  if (std::exchange(this->BlockAttrChanged, false))
  {
    this->All.Data = this->Reduced.Data = nullptr;
  }
  this->BlockAttributeTime.Modified();
  this->VisibleDataBoundsTime.Modified();
  const bool together =
    request == vtkPVView::REQUEST_UPDATE() || (request == vtkPVView::REQUEST_RENDER() && this->IsCollective(inInfo));
  bool visible = false;
  const bool good = this->WithinMemory(
    [&]
    {
      // The superclass has another LOD.
      visible = request == vtkPVView::REQUEST_UPDATE_LOD()
        ? this->vtkPVDataRepresentation::ProcessViewRequest(request, inInfo, outInfo)
        : this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
      if (visible)
      {
        this->ProcessRequest(request, inInfo);
      }
    },
    together);
  return good && visible ? 1 : 0;
}

//----------------------------------------------------------------------------
// Whether memory suffices; if not, the rank that lacks it says so, once for all that it was needed for.
bool vtkRayTracedRepresentation::WithinMemory(const std::function<void()>& work, bool together)
{
  const bool outermost = !this->Guarded;
  this->Guarded = true;
  bool good = true;
  try
  {
    together ? rtglyphs::RayTracedRanks::Together(work) : work();
  }
  catch (const rtglyphs::RayTracedRanks::FailedElsewhere&)
  {
    good = false;
  }
  catch (const std::bad_alloc&)
  {
    good = false;
    this->LacksMemory = true;
  }
  if (outermost)
  {
    this->Guarded = false;
    if (std::exchange(this->LacksMemory, false))
    {
      vtkErrorMacro(<< "Ray Traced Glyphs: the computer's memory does not suffice to gather these data. Show fewer of "
                       "them, for example with Mask Points or Threshold, or hide other data.");
    }
  }
  return good;
}

//----------------------------------------------------------------------------
// Whether all ranks render together.
bool vtkRayTracedRepresentation::IsCollective(vtkInformation* inInfo)
{
  vtkPVRenderView* view = this->GetRenderView();
  return view &&
    (inInfo->Has(vtkPVRenderView::USE_LOD()) ? view->GetUseDistributedRenderingForLODRender()
                                             : view->GetUseDistributedRenderingForRender());
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::ProcessRequest(vtkInformationRequestKey* request, vtkInformation* inInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Common.HasData = this->GetNumberOfInputConnections(0) > 0;
    // Where the view has kept this step of an animation nothing has been gathered, and that piece is what it shows.
    this->Piece = vtkPVView::GetPiece(inInfo, this);
    vtkNew<vtkPolyData> nothing; // of an input that has failed, as a source of a state file may
    this->Show(this->Piece ? this->Piece.Get() : nothing.Get(), this->All);
    this->Content->Deliver(inInfo, this, /*lod=*/false);
    vtkPolyData* points = this->Common.Blocks.GetPoints();
    if (this->Common.HasData)
    {
      this->Common.Time.UpdateShutterTime(
        points, [&](double& unitSize) { return this->Content->GetSizes(points, unitSize); }, this->GetUpdateTime());
    }
    double bounds[6];
    std::copy_n(this->GetBounds(points, this->All), 6, bounds);
    rtglyphs::ExtendBounds(this->MakeImages(points, this->Piece, /*together=*/true), bounds);
    rtglyphs::RayTracedParts& parts = this->Common.Parts;
    parts.Follow(this->Actor);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, parts.Actor->GetMatrix());
    if (parts.Mapper)
    {
      // The clipping range takes those of actors, too: old ones that were larger would hold until the next update.
      this->SetPartBounds(bounds);
    }
    vtkRayTracedScene* scene = this->GetScene();
    const bool replicated = scene && scene->GetSettings().IsReplicated();
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, replicated);
    if (replicated)
    {
      vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
    }
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    // Reduced where it is rendered: ParaView delivers a piece again only when the data have changed.
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->Piece);
    this->Content->Deliver(inInfo, this, /*lod=*/true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    if (vtkPVRenderView* view = this->GetRenderView())
    {
      this->Render(view, inInfo);
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::Show(vtkDataObject* data, Shown& shown)
{
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (!shown.Data || data != shown.Data || time != shown.Time)
  {
    this->PopulateBlockAttributes(shown.Attributes, data);
    shown.Attributes->Modified();
    shown.Data = data;
    shown.Time = time;
  }
  rtglyphs::RayTracedBlocks::Attributes common;
  rtglyphs::RayTracedBlocks::Coloring& scalars = common.Scalars;
  scalars.On = this->Mapper->GetScalarVisibility() != 0;
  if (scalars.On)
  {
    scalars.Array = OrEmpty(this->Mapper->GetArrayName());
    scalars.Table = this->Mapper->GetLookupTable(); // a mapper without one makes one
  }
  scalars.ScalarMode = this->Mapper->GetScalarMode();
  scalars.ColorMode = this->Mapper->GetColorMode();
  scalars.InterpolatesScalars = this->Mapper->GetInterpolateScalarsBeforeMapping();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  auto* composite = vtkCompositePolyDataMapper::SafeDownCast(this->Mapper);
  scalars.MissingIsNan = composite && composite->GetColorMissingArraysWithNanColor();
#endif
  shown.Blocks.Update(data, shown.Attributes, common);
}

//----------------------------------------------------------------------------
// A problem with properties, or none, unless it is the one that was last reported.
void vtkRayTracedRepresentation::ReportAnew(const std::string& problem, std::string& reported)
{
  if (problem != std::exchange(reported, problem) && !problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
}

//----------------------------------------------------------------------------
rtg::PeriodicImages vtkRayTracedRepresentation::MakeImages(vtkDataObject* points, vtkDataObject* data, bool together)
{
  std::string problem;
  const rtg::PeriodicImages images = this->Periodic.Make(points, data, together, problem);
  if (this->Periodic.Boundary)
  {
    this->ReportAnew(problem, this->PeriodicProblem);
  }
  return images;
}

//****************************************************************************
// The render side
//****************************************************************************

//----------------------------------------------------------------------------
vtkPVRenderView* vtkRayTracedRepresentation::GetRenderView()
{
  return vtkPVRenderView::SafeDownCast(this->GetView());
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::NeedsOrderedCompositing()
{
  return this->Content->IsTranslucent() || this->Superclass::NeedsOrderedCompositing();
}

//----------------------------------------------------------------------------
// Without the superclass's actor.
bool vtkRayTracedRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->Common.Key->AddTo(renderView);
    this->Glyphs.GetLegend()->AddTo(renderView);
  }
  return this->vtkPVDataRepresentation::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  this->RemoveParts();
  this->Common.Key->RemoveFrom(renderView);
  this->Glyphs.GetLegend()->RemoveFrom(renderView);
  return this->vtkPVDataRepresentation::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::RemoveParts()
{
  rtglyphs::RayTracedParts& parts = this->Common.Parts;
  if (parts.Mapper)
  {
    this->Content->RemoveLayers(this, this->GetRenderView());
    parts.Remove(this, this->GetRenderView(), parts.Actor, parts.Mapper);
    parts.Mapper = nullptr;
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetVisibility(bool visible)
{
  this->Common.Parts.Actor->SetVisibility(visible);
  this->Content->Show(visible);
  this->Superclass::SetVisibility(visible);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::Render(vtkPVRenderView* view, vtkInformation* inInfo)
{
  rtglyphs::RayTracedParts& parts = this->Common.Parts;
  if (!parts.Mapper)
  {
    parts.Mapper = this->Content->MakeMapper();
    parts.Add(this, view, parts.Actor, parts.Mapper);
  }
  parts.Follow(this->Actor);
  std::string problem;
  *parts.Section = this->Section.Make(this->Common.Time.Motion.On, problem);
  this->ReportAnew(problem, this->SectionProblem);
  const bool lod = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  vtkDataObject* delivered =
    lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, this) : vtkPVView::GetDeliveredPiece(inInfo, this);
  vtkRayTracedScene* scene = this->GetScene();
  const bool stepwise = scene->GetSettings().IsStepwise(), capture = ScreenshotState::Of(view);
  // A selection may come before new points have been delivered: it finds what is shown.
  if (delivered || !this->Piece)
  {
    this->Show(delivered, this->All);
    parts.Mapper->SetBlocks(this->Common.Blocks);
  }
  vtkPolyData* points = parts.Mapper->GetPoints();
  const bool collective = this->IsCollective(inInfo);
  parts.Mapper->SetInWindow(stepwise);
  const rtglyphs::RayTracedContent::Frame frame{ inInfo, this, view, points, lod, collective,
    this->NeedsOrderedCompositing() };
  this->Content->Configure(frame);
  // In a window fewer glyphs come first where many must be built.
  const bool first = stepwise && !lod && !capture && !(this->ReducedFirst && scene->HasPicture()) && delivered &&
    static_cast<double>(delivered->GetActualMemorySize()) > 1024.0 * view->GetLODRenderingThreshold() &&
    parts.Mapper->NeedsBuild(parts.Actor);
  this->PieceLOD = points && delivered && (lod || first)
    ? this->Content->Reduce(delivered, this->GetBounds(points, this->All), view->GetLODResolution())
    : nullptr;
  const bool reduced = this->PieceLOD != nullptr;
  Shown& shown = reduced ? this->Reduced : this->All;
  this->ReducedFirst = reduced && first;
  if (reduced)
  {
    delivered = this->PieceLOD;
    this->Show(delivered, shown);
    points = shown.Blocks.GetPoints();
  }
  if (this->ReducedFirst)
  {
    scene->ExpectAnother();
  }
  this->Content->ShowReduced(frame, reduced);
  vtkNew<vtkPolyData> nothing;
  double bounds[6];
  std::copy_n(this->GetBounds(points ? points : nothing.Get(), shown), 6, bounds);
  rtg::PeriodicImages images = this->MakeImages(points, delivered, collective);
  rtglyphs::ExtendBounds(images, bounds);
  // In an unbounded domain no sky is visible: light from any distance meets only what is shown.
  const rtglyphs::RayTracedImageSettings& light = scene->GetSettings();
  if (light.ShadingMode != static_cast<int>(rtg::Shading::AmbientOcclusion) || light.AmbientOcclusionRadius <= 0.0)
  {
    images.lit = images.shown;
  }
  this->SetPartBounds(bounds);
  *parts.Images = rtglyphs::Moved(images, parts.Actor->GetMatrix());
  scene->SetFrameKind(capture, collective, view->GetUseOrderedCompositing());
  parts.Mapper->SetDataStatistics({ this->GetUniqueIdentifier(), this->Gathers, this->All.Bounds.GetBuilds(),
    this->GatherSeconds, this->All.Bounds.GetSeconds() });
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPartBounds(const double bounds[6])
{
  this->Common.Parts.Mapper->SetKnownBounds(bounds);
  this->Content->SetLayerBounds(bounds);
}

//----------------------------------------------------------------------------
// Null while it is in no view, and until the view has something ray traced.
vtkRayTracedScene* vtkRayTracedRepresentation::GetScene()
{
  vtkPVRenderView* view = this->GetRenderView();
  return view ? vtkRayTracedScene::Find(view->GetRenderer()) : nullptr;
}

//****************************************************************************
// Properties
//****************************************************************************

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::GatherIf(bool changed)
{
  if (changed)
  {
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
// Trails, too, use the box of the data.
void vtkRayTracedRepresentation::SetPeriodicBoundary(bool on)
{
  this->GatherIf(std::exchange(this->Periodic.Boundary, on) != on && this->Content->HasTrails());
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPeriodicVectors(int index, double value)
{
  this->GatherIf(std::exchange(this->Periodic.Vectors.at(index), value) != value && this->Content->HasTrails());
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetArray(std::string& held, const char* name)
{
  if (held != OrEmpty(name))
  {
    held = OrEmpty(name);
    if (held.find(',') != std::string::npos)
    {
      this->MarkModified(); // steps that the view has kept lack it
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetGlyphShape(int shape)
{
  if (!rtglyphs::GlyphShapes::IsKnown(shape))
  {
    vtkErrorMacro("GlyphShape is " << shape << "; it must be one of " << rtglyphs::GlyphShapes::Known << ".");
    return;
  }
  this->Glyphs.GlyphShape = shape;
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetGlyphLocation(int location)
{
  this->GatherIf(std::exchange(this->Glyphs.Cells, location > 0) != (location > 0));
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetInterpolation(int interpolation)
{
  const bool smooth = interpolation != VTK_FLAT;
  this->Superclass::SetInterpolation(interpolation);
  const bool changed = std::exchange(this->Surface.Smooth, smooth) != smooth;
  this->GatherIf(changed && this->Content == &this->Surface); // normals may be missing
}

//----------------------------------------------------------------------------
double* vtkRayTracedRepresentation::GetDataSummary()
{
  this->Common.Summary[rtglyphs::DataSummary::SHUTTER_TIME] = this->Common.Time.GetShutterTimeGuess();
  return this->Common.Summary.data();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetDataSummary(const double numbers[11])
{
  static_assert(rtglyphs::DataSummary::SIZE == 11);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    std::copy_n(numbers, this->Common.Summary.size(), this->Common.Summary.begin());
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetGlyphSizeRange(double least, double most)
{
  rtglyphs::GlyphSizing& sizing = this->Glyphs.Settings.Sizing;
  sizing.Least = std::max(rtglyphs::RayTracedNumbers::NumberOr(least, 0.0), 0.0);
  sizing.Most = std::max(rtglyphs::RayTracedNumbers::NumberOr(most, 0.0), 0.0);
  if (sizing.Most > 0.0 && sizing.Most < sizing.Least)
  {
    vtkErrorMacro("GlyphSizeRange is " << least << ", " << most
                                       << "; the second must not be less than the first. All glyphs get the size "
                                       << most << ".");
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetTable(bool sourceIndexing, bool useSourceTableTree)
{
  const bool changed = std::exchange(this->Glyphs.SourceIndexing, sourceIndexing) != sourceIndexing;
  const bool other = std::exchange(this->Glyphs.UseSourceTableTree, useSourceTableTree) != useSourceTableTree;
  this->GatherIf(changed || other); // the meshes
}
