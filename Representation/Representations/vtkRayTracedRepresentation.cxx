#include "vtkRayTracedRepresentation.h"

#include "GlyphJoinedArrays.h"
#include "Glyphs.h"
#include "Tracer.h"
#include "RayTracedArrays.h"
#include "RayTracedDisplays.h"
#include "RayTracedNumbers.h"
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
#include "vtkMatrix4x4.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedMapper.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#endif

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

using namespace rtglyphs::RayTracedNumbers;

namespace
{
// ParaView says so to subclasses of its views only.
struct ScreenshotState : vtkPVRenderView
{
  static bool Of(vtkPVView* view) { return (view->*(&ScreenshotState::GetInCaptureScreenshot))(); }
};
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::vtkRayTracedRepresentation()
  : MadeImages(std::make_shared<rtg::PeriodicImages>())
  , MadeSection(std::make_shared<rtg::Section>())
{
  this->RequestGhostCellsIfNeeded = false;
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::~vtkRayTracedRepresentation() = default;

//----------------------------------------------------------------------------
vtkRayTracedMapper* vtkRayTracedRepresentation::GetMapper()
{
  return this->MainMapper;
}

//----------------------------------------------------------------------------
vtkPVLODActor* vtkRayTracedRepresentation::GetRenderedProp()
{
  return this->MainActor;
}

//****************************************************************************
// The data side
//****************************************************************************

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input =
    inputVector[0]->GetNumberOfInformationObjects() == 1 ? vtkDataObject::GetData(inputVector[0], 0) : nullptr;
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
        const vtkSmartPointer<vtkDataObject> made = this->GatherTree(input, wholeExtent);
        again = this->Time.AddTrails(made, input, this->GetUpdateTime(), info, this->GetInputAlgorithm(),
          [&] { return this->MakeImages(made, input, /*together=*/true); });
        if (again)
        {
          return;
        }
        this->Time.AddVelocities(made, input, this->GetInputAlgorithm());
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
    this->Time.GiveUp();
  }
  else if (const std::string message = this->Time.TakeMessage(); !message.empty())
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
vtkSmartPointer<vtkDataObject> vtkRayTracedRepresentation::GatherTree(vtkDataObject* input, const int* wholeExtent)
{
  const bool blocks = input->IsA("vtkCompositeDataSet");
  const rtglyphs::RayTracedParallel::Progress progress = this->ProgressOf("Gathering points");
  const double all = std::max(1.0, static_cast<double>(input->GetNumberOfElements(vtkDataObject::POINT)));
  double done = 0.0;
  return rtglyphs::RayTracedTree::Make(input, this->GetBlockColorsDistinctValues(),
    [&](vtkDataObject* data)
    {
      const double first = done;
      done += data ? static_cast<double>(data->GetNumberOfElements(vtkDataObject::POINT)) / all : 0.0;
      return this->Gather(
        data, wholeExtent, blocks, rtglyphs::RayTracedParallel::Part(progress, first, std::min(done, 1.0)));
    });
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
  for (const std::string& name : this->Arrays())
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
const double*
vtkRayTracedRepresentation::GetBoundsOf(vtkPolyData* points, const std::vector<rtglyphs::GlyphSettings>& settings)
{
  return this->Bounds.Get(points, settings, this->Blocks.GetHidden());
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
  this->Time.AskForMissingStep(inputVector, this->GetNumberOfInputPorts());
  return good;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int good = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  this->Time.AskForMissingStep(inputVector, this->GetNumberOfInputPorts());
  return good;
}

//----------------------------------------------------------------------------
vtkDataObject* vtkRayTracedRepresentation::GetRenderedDataObject(int)
{
  return this->Piece;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // The superclass would fill attributes of blocks for its mapper and for bounds, neither of which is used.
  if (std::exchange(this->BlockAttrChanged, false))
  {
    this->AttributedData = nullptr;
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
      vtkErrorMacro(<< "Ray Traced Glyphs: the computer's memory does not suffice to gather these "
                       "data. Show fewer of them, for example "
                       "with Mask Points or Threshold, or hide other data.");
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
    // Where the view has kept this step of an animation nothing has been gathered, and that piece is what it shows.
    this->Piece = vtkPVView::GetPiece(inInfo, this);
    this->UseBlocks(this->Piece);
    this->Deliver(inInfo, /*lod=*/false);
    if (this->GetNumberOfInputConnections(0) > 0)
    {
      this->Time.UpdateShutterTime(
        this->GetPoints(), [this](double& unitSize) { return this->GetSizes(this->GetPoints(), unitSize); },
        this->GetUpdateTime());
    }
    double bounds[6];
    std::copy_n(this->GetDataBounds(this->GetPoints()), 6, bounds);
    rtglyphs::ExtendBounds(this->MakeImages(this->GetPoints(), this->Piece, /*together=*/true), bounds);
    this->UpdateActor();
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, this->MainActor->GetMatrix());
    if (this->MainMapper)
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
    // Glyphs are as quick to trace while the camera moves; they only must not be missing.
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->Piece);
    this->Deliver(inInfo, /*lod=*/true);
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
void vtkRayTracedRepresentation::UseBlocks(vtkDataObject* data)
{
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (!this->AttributedData || data != this->AttributedData || time != this->AttributedTime)
  {
    this->PopulateBlockAttributes(this->BlockAttributes, data);
    this->BlockAttributes->Modified();
    this->AttributedData = data;
    this->AttributedTime = time;
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
  auto* blocks = vtkCompositePolyDataMapper::SafeDownCast(this->Mapper);
  scalars.MissingIsNan = blocks && blocks->GetColorMissingArraysWithNanColor();
#endif
  this->Blocks.Update(data, this->BlockAttributes, common);
}

//----------------------------------------------------------------------------
// The superclass's actor is not rendered, and its numbers may be NaN or infinite.
void vtkRayTracedRepresentation::UpdateActor()
{
  vtkProperty* property = this->MainActor->GetProperty();
  property->DeepCopy(this->Property);
  property->SetOpacity(NumberOr(property->GetOpacity(), 1.0));
  property->SetAmbient(NumberOr(property->GetAmbient(), 0.0));
  property->SetDiffuse(NumberOr(property->GetDiffuse(), 1.0));
  property->SetSpecular(NumberOr(property->GetSpecular(), 0.0));
  property->SetSpecularPower(NumberOr(property->GetSpecularPower(), 100.0));
  property->SetMetallic(NumberOr(property->GetMetallic(), 0.0));
  property->SetRoughness(NumberOr(property->GetRoughness(), 0.5));
  property->SetCoatStrength(NumberOr(property->GetCoatStrength(), 0.0));
  property->SetCoatIOR(NumberOr(property->GetCoatIOR(), 2.0));
  property->SetCoatRoughness(NumberOr(property->GetCoatRoughness(), 0.0));
  const auto inRange = [](const double* color) { return ColorInRange(color[0], color[1], color[2]); };
  // VTK 9.6's copy has the diffuse color for the ambient one.
  property->SetAmbientColor(inRange(this->Property->GetAmbientColor()).data());
  property->SetDiffuseColor(inRange(property->GetDiffuseColor()).data());
  property->SetSpecularColor(inRange(property->GetSpecularColor()).data());
  property->SetCoatColor(inRange(property->GetCoatColor()).data());

  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  const double* elements = matrix->GetData();
  if (!std::all_of(elements, elements + 16, [](double element) { return std::isfinite(element); }))
  {
    matrix->Identity();
  }
  this->MainActor->SetUserMatrix(matrix);
  this->MainActor->SetPickable(this->Actor->GetPickable());
  this->MainActor->SetVisibility(this->GetVisibility());
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
void vtkRayTracedRepresentation::UpdateSection()
{
  std::string problem;
  *this->MadeSection = this->Section.Make(this->Time.Motion.On, problem);
  this->ReportAnew(problem, this->SectionProblem);
}

//----------------------------------------------------------------------------
// In the data's coordinates, of a RayTracedTree of points; null: none. `together`: all ranks ask at once, each of which
// has a part of the data.
rtg::PeriodicImages vtkRayTracedRepresentation::MakeImages(vtkDataObject* points, vtkDataObject* data, bool together)
{
  if (!this->Periodic.Boundary)
  {
    return {};
  }
  vtkBoundingBox box;
  if (points)
  {
    rtglyphs::RayTracedTree::ForEach(points,
      [&box](vtkPolyData* leaf)
      {
        if (leaf->GetNumberOfPoints() > 0)
        {
          box.AddBounds(leaf->GetBounds());
        }
      });
  }
  if (together)
  {
    box = rtglyphs::RayTracedRanks::Union(box);
  }
  std::string problem;
  vtkFieldData* own = points ? points->GetFieldData() : nullptr;
  vtkFieldData* field = own && own->GetNumberOfArrays() > 0 ? own : data ? data->GetFieldData() : nullptr;
  const rtg::PeriodicImages images = this->Periodic.Make(field, box, problem);
  this->ReportAnew(problem, this->PeriodicProblem);
  return images;
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
std::vector<std::string> vtkRayTracedRepresentation::Arrays() const
{
  const rtglyphs::GlyphMotion::Settings& motion = this->Time.Motion;
  return { motion.Velocity, motion.Acceleration, motion.AngularVelocity };
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
void vtkRayTracedRepresentation::AddPart(vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
{
  actor->SetMapper(mapper);
  view->GetRenderer()->AddActor(actor);
  view->RegisterPropForHardwareSelection(this, actor);
  mapper->SetBuildProgress(this->ProgressOf("Building glyphs"));
  mapper->SetSection(this->MadeSection);
  mapper->SetImages(this->MadeImages);
  vtkRayTracedScene::Of(view->GetRenderer())->Add(actor, mapper);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::RemovePart(vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
{
  vtkRayTracedScene::Of(view->GetRenderer())->Remove(mapper);
  view->UnRegisterPropForHardwareSelection(this, actor);
  view->GetRenderer()->RemoveActor(actor);
}

//----------------------------------------------------------------------------
// Without the superclass's actor.
bool vtkRayTracedRepresentation::AddToView(vtkView* view)
{
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
  if (this->MainMapper)
  {
    this->RemoveLayers(renderView);
    this->RemovePart(renderView, this->MainActor, this->MainMapper);
    this->MainMapper = nullptr;
  }
  return this->vtkPVDataRepresentation::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetVisibility(bool visible)
{
  this->MainActor->SetVisibility(visible);
  this->ShowLayers(visible);
  this->Superclass::SetVisibility(visible);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::Render(vtkPVRenderView* view, vtkInformation* inInfo)
{
  if (!this->MainMapper)
  {
    this->MainMapper = this->MakeMapper();
    this->AddPart(view, this->MainActor, this->MainMapper);
  }
  this->UpdateActor();
  this->UpdateSection();
  const bool lod = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  vtkDataObject* delivered =
    lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, this) : vtkPVView::GetDeliveredPiece(inInfo, this);
  // A selection may come before new points have been delivered: it finds what is shown.
  if (delivered || !this->Piece)
  {
    this->UseBlocks(delivered);
    this->MainMapper->SetBlocks(this->Blocks);
  }
  vtkPolyData* points = this->MainMapper->GetPoints();
  const bool collective = this->IsCollective(inInfo);
  vtkRayTracedScene* scene = this->GetScene();
  this->MainMapper->SetInWindow(scene->GetSettings().IsStepwise());
  this->Configure(inInfo, points, lod, collective);
  vtkNew<vtkPolyData> nothing;
  double bounds[6];
  std::copy_n(this->GetDataBounds(points ? points : nothing.Get()), 6, bounds);
  rtg::PeriodicImages images = this->MakeImages(points, delivered, collective);
  rtglyphs::ExtendBounds(images, bounds);
  // In an unbounded domain no sky is visible: light from any distance meets only what is shown.
  const rtglyphs::RayTracedImageSettings& light = scene->GetSettings();
  if (light.ShadingMode != static_cast<int>(rtg::Shading::AmbientOcclusion) || light.AmbientOcclusionRadius <= 0.0)
  {
    images.lit = images.shown;
  }
  this->SetPartBounds(bounds);
  *this->MadeImages = rtglyphs::Moved(images, this->MainActor->GetMatrix());
  scene->SetFrameKind(ScreenshotState::Of(view), collective, view->GetUseOrderedCompositing());
  scene->SetStatistics(this->MainMapper,
    { this->GetUniqueIdentifier(), this->Gathers, this->Bounds.GetBuilds(), this->GatherSeconds,
      this->Bounds.GetSeconds() });
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPartBounds(const double bounds[6])
{
  this->MainMapper->SetKnownBounds(bounds);
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
  this->GatherIf(std::exchange(this->Periodic.Boundary, on) != on && this->HasTrails());
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPeriodicVectors(int index, double value)
{
  this->GatherIf(std::exchange(this->Periodic.Vectors.at(index), value) != value && this->HasTrails());
}
