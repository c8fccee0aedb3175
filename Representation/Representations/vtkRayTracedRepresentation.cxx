#include "vtkRayTracedRepresentation.h"

#include "Glyphs.h"
#include "Stopwatch.h"
#include "Vulkan/Device.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkGlyphSample.h"
#include "vtkGlyphShutterGuess.h"
#include "vtkGlyphStepVelocity.h"
#include "vtkGlyphJoinedArrays.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedMapper.h"
#include "vtkRayTracedNumbers.h"
#include "vtkRayTracedPythonClass.h"
#include "vtkRayTracedFrameStatus.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <new>

using namespace vtkRayTracedNumbers;

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
  : Points(vtkSmartPointer<vtkPolyData>::New())
  , StepVelocity(std::make_unique<vtkGlyphStepVelocity>())
{
  this->Actor->SetProperty(this->Property);
  vtkRayTracedPythonClass::GetActor = [](vtkObjectBase* object) -> vtkObjectBase*
  {
    auto* representation = vtkRayTracedRepresentation::SafeDownCast(object);
    return representation ? representation->GetActor() : nullptr;
  };
  vtkRayTracedPythonClass::RegisterIfPythonRuns();
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::~vtkRayTracedRepresentation() = default;

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper: " << this->Mapper.Get() << endl;
}

//----------------------------------------------------------------------------
vtkRayTracedMapper* vtkRayTracedRepresentation::GetMapper()
{
  return this->Mapper;
}

//----------------------------------------------------------------------------
vtkRayTracedActor* vtkRayTracedRepresentation::GetActor()
{
  return this->Actor;
}

//----------------------------------------------------------------------------
vtkPolyData* vtkRayTracedRepresentation::GetPoints()
{
  return this->Points;
}

//****************************************************************************
// The data side
//****************************************************************************

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHyperTreeGrid");
  // On processes that only render there is no input.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

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
  try
  {
    this->Points = this->Gather(input, wholeExtent);
    this->AddStepVelocities(input);
  }
  catch (const std::bad_alloc&)
  {
    this->Points = vtkSmartPointer<vtkPolyData>::New();
    this->ReportLackOfMemory();
  }
  ++this->Gathers;
  this->GatherSeconds += watch.Lap();
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
const double*
vtkRayTracedRepresentation::GetBoundsOf(vtkPolyData* points, const std::vector<vtkGlyphSettings>& settings)
{
  return this->Bounds.Get(points, settings, this->Blocks.Resolve(points));
}

//----------------------------------------------------------------------------
vtkRayTracedParallel::Progress vtkRayTracedRepresentation::ProgressOf(const char* what)
{
  return [this, what](double share)
  {
    this->SetProgressText(what);
    this->UpdateProgress(share);
  };
}

//----------------------------------------------------------------------------
// Where the data are, and not where they are rendered: what is delivered may come from ParaView's cache of time steps.
void vtkRayTracedRepresentation::AddStepVelocities(vtkDataObject* input)
{
  if (!this->Motion.FromPreviousStep || !input)
  {
    return;
  }
  this->StepVelocity->AddTo(this->Points, input, this->GetInputAlgorithm());
  const std::string message = this->StepVelocity->TakeMessage();
  if (!message.empty())
  {
    vtkWarningMacro(<< message);
  }
}

//----------------------------------------------------------------------------
// On all ranks that have data; after their sizes are known, and before their bounds.
void vtkRayTracedRepresentation::UpdateShutterTime(vtkPolyData* points)
{
  if (!this->ShutterTimeFromData || !this->Motion.On || this->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  if (this->Motion.FromPreviousStep)
  {
    this->ShutterTime = vtkGlyphSample::Largest(this->StepVelocity->GetStepLength());
    return;
  }
  double unitSize = 1.0;
  const vtkGlyphSettings sizes = this->GetSizes(points, unitSize);
  this->ShutterTime = vtkGlyphShutterGuess::Update(this->ShutterGuess, points, sizes, unitSize, this->GetUpdateTime());
}

//----------------------------------------------------------------------------
vtkGlyphMotion::Settings vtkRayTracedRepresentation::GetMotion() const
{
  vtkGlyphMotion::Settings motion = this->Motion;
  if (this->ShutterTimeFromData)
  {
    // While nothing moves any will do.
    const double known = this->ShutterTime > 0.0 ? this->ShutterTime : motion.ShutterTime;
    motion.ShutterTime = known > 0.0 ? known : 1.0;
  }
  return motion;
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetShutterTimeFromData(bool on)
{
  this->ShutterTimeFromData = on;
  this->ShutterGuess.Forget();
  this->ShutterTime = 0.0;
}

//----------------------------------------------------------------------------
vtkDataObject* vtkRayTracedRepresentation::GetRenderedDataObject(int)
{
  return this->Points;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // not visible
  }
  try
  {
    this->Answer(request, inInfo, outInfo);
  }
  catch (const std::bad_alloc&)
  {
    this->ReportLackOfMemory();
    return 0;
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::Answer(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    if (this->Points)
    {
      this->AddArrays(this->Points);
    }
    vtkPVView::SetPiece(inInfo, this, this->Points);
    // Where the view has kept this step of an animation nothing has been gathered, and that piece is what it shows.
    if (auto* shown = vtkPolyData::SafeDownCast(vtkPVView::GetPiece(inInfo, this)))
    {
      this->Points = shown;
    }
    this->Deliver(inInfo, /*lod=*/false);
    this->UpdateShutterTime(this->Points);
    double bounds[6];
    std::copy_n(this->GetDataBounds(this->Points), 6, bounds);
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
    if (this->Mapper && this->Points)
    {
      // The clipping range takes those of actors, too: old ones that were larger would hold until the next update.
      this->SetPartBounds(bounds);
    }
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, this->IsReplicated());
    vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
      this->IsReplicated() ? vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION
                           : vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), this->MayBeTranslucent() ? 1 : 0);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    // Glyphs are as quick to trace while the camera moves; they only must not be missing.
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->Points);
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
// Arrays that are named as parts of one.
void vtkRayTracedRepresentation::AddArrays(vtkPolyData* points)
{
  for (const std::string& name : { this->Motion.Velocity, this->Motion.Acceleration, this->Motion.AngularVelocity })
  {
    vtkGlyphJoinedArrays::Add(points, name);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::ReportLackOfMemory()
{
  vtkErrorMacro(<< "Ray Traced Glyphs: the computer's memory does not suffice to gather these "
                   "data. Show fewer of them, for example "
                   "with Mask Points or Threshold, or hide other data.");
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::MayBeTranslucent()
{
  const double opacity = this->Property->GetOpacity();
  if ((opacity > 0.0 && opacity < 1.0) || this->Blocks.HasTranslucent())
  {
    return true;
  }
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME()) ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!name || !name[0])
  {
    return false;
  }
  return !this->MapScalars || (this->LookupTable && this->LookupTable->IsOpaque() == 0);
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
bool vtkRayTracedRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  if (this->Mapper)
  {
    this->RemoveLayers(renderView);
    this->RemovePart(renderView, this->Actor, this->Mapper);
    this->Mapper = nullptr;
  }
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible);
  this->ShowLayers(visible);
  this->Superclass::SetVisibility(visible);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::Render(vtkPVRenderView* view, vtkInformation* inInfo)
{
  if (!this->Mapper)
  {
    this->Mapper = this->MakeMapper();
    this->AddPart(view, this->Actor, this->Mapper);
  }
  const bool lod = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  vtkDataObject* delivered =
    lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, this) : vtkPVView::GetDeliveredPiece(inInfo, this);
  auto* points = vtkPolyData::SafeDownCast(delivered);
  if (!points && this->Points)
  {
    // A selection may come before new points have been delivered: it finds what is shown.
    points = this->Mapper->GetPoints();
  }
  this->Mapper->SetPoints(points);
  this->Mapper->SetBlocks(this->Blocks);
  this->Mapper->SetInWindow(this->Image.StepwiseRendering);
  this->ConfigureColors(points);
  const bool collective =
    lod ? view->GetUseDistributedRenderingForLODRender() : view->GetUseDistributedRenderingForRender();
  this->Configure(inInfo, points, lod, collective);
  vtkNew<vtkPolyData> nothing;
  this->SetPartBounds(this->GetDataBounds(points ? points : nothing.Get()));
  vtkRayTracedScene* scene = this->GetScene();
  scene->SetSettings(this->Image.InRange());
  scene->SetFrameKind(ScreenshotState::Of(view), collective, view->GetUseOrderedCompositing());
  if (!this->FeatureFile.empty())
  {
    scene->SaveFeatureImage(this->FeatureFile);
    this->FeatureFile.clear();
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPartBounds(const double bounds[6])
{
  this->Mapper->SetKnownBounds(bounds);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::ConfigureColors(vtkPolyData* points)
{
  const char* name = nullptr;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (info && info->Has(vtkDataObject::FIELD_ASSOCIATION()) && info->Has(vtkDataObject::FIELD_NAME()))
  {
    name = info->Get(vtkDataObject::FIELD_NAME());
    association = info->Get(vtkDataObject::FIELD_ASSOCIATION());
  }
  this->Mapper->SetColorMode(this->MapScalars ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
  if (this->LookupTable)
  {
    this->Mapper->SetLookupTable(this->LookupTable);
  }
  if (!name || !name[0])
  {
    this->Mapper->ScalarVisibilityOff();
    this->Mapper->SelectColorArray(static_cast<const char*>(nullptr));
    return;
  }
  // Cells of a hyper tree grid have become points on the way, and so have the numbers of blocks, which are field data.
  bool cells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (cells && points && !points->GetCellData()->HasArray(name))
  {
    cells = !points->GetPointData()->HasArray(name);
  }
  this->Mapper->ScalarVisibilityOn();
  this->Mapper->SelectColorArray(name);
  this->Mapper->SetUseLookupTableScalarRange(1);
  this->Mapper->SetScalarMode(cells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
}

//----------------------------------------------------------------------------
// Null until something ray-traced was rendered in the view.
vtkRayTracedScene* vtkRayTracedRepresentation::GetScene()
{
  vtkPVRenderView* view = this->GetRenderView();
  return view ? vtkRayTracedScene::Find(view->GetRenderer()) : nullptr;
}

//----------------------------------------------------------------------------
const char* vtkRayTracedRepresentation::GetDeviceName()
{
  vtkRayTracedScene* scene = this->GetScene();
  this->DeviceName = scene ? scene->GetDeviceName() : std::string();
  return this->DeviceName.c_str();
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::FindDevice(std::string& words)
{
  try
  {
    const rtg::Device::Choice chosen = rtg::Device::Chosen();
    words = "Ray Traced Glyphs: this computer traces with '" + chosen.name + "'" +
      (chosen.cpu ? ", its processor; RTGLYPHS_DEVICE chooses another Vulkan device." : ".");
    return true;
  }
  catch (const rtg::Error& error)
  {
    words = error.what();
    return false;
  }
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::GetAccumulatedSamples()
{
  vtkRayTracedScene* scene = this->GetScene();
  return scene ? scene->GetAccumulatedSamples() : 0;
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::GetRefinementPending()
{
  return this->GetRefinementProgress() < 1.0;
}

//----------------------------------------------------------------------------
double vtkRayTracedRepresentation::GetRefinementProgress()
{
  vtkRayTracedScene* scene = this->GetScene();
  return scene ? scene->GetProgress() : 1.0;
}

//----------------------------------------------------------------------------
const char* vtkRayTracedRepresentation::GetRefinementStep()
{
  vtkRayTracedScene* scene = this->GetScene();
  return scene ? scene->GetStep() : "";
}

//----------------------------------------------------------------------------
const char* vtkRayTracedRepresentation::GetRenderStatistics()
{
  vtkRayTracedScene* scene = this->GetScene();
  const vtkRayTracedDataStatistics data{ this->Gathers, this->Bounds.GetBuilds(), this->GatherSeconds,
    this->Bounds.GetSeconds() };
  this->Statistics = scene ? scene->GetStatistics(this->Mapper, data) : std::string("{}");
  return this->Statistics.c_str();
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::GetRenderedRemotely()
{
  vtkPVRenderView* view = this->GetRenderView();
  return view && view->GetUseDistributedRenderingForRender();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SaveFeatureImage(const char* fileName)
{
  this->FeatureFile = OrEmpty(fileName);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::StopRefinement()
{
  if (vtkRayTracedScene* scene = this->GetScene())
  {
    scene->Stop();
  }
}

//****************************************************************************
// Properties
//****************************************************************************

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetParallelLight(int light)
{
  this->SetParallelLight(light, this->ReplicateGlyphs);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetReplicateGlyphs(bool on)
{
  this->SetParallelLight(this->ParallelLight, on);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetParallelLight(int light, bool replicate)
{
  const bool wasReplicated = this->IsReplicated();
  this->ParallelLight = light;
  this->ReplicateGlyphs = replicate;
  this->Image.ParallelLight = replicate ? vtkRayTracedImageSettings::ReplicatedLight : light;
  if (this->IsReplicated() != wasReplicated)
  {
    this->MarkModified(); // the points must be delivered again
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetVelocityFromPreviousStep(bool on)
{
  if (this->Motion.FromPreviousStep != on)
  {
    this->Motion.FromPreviousStep = on;
    this->StepVelocity->Reset();
    this->MarkModified(); // the points must be gathered again
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPointIdArray(const char* name)
{
  if (this->StepVelocity->SetPointIdArray(OrEmpty(name)) && this->Motion.FromPreviousStep)
  {
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetShutterOpening(int opening)
{
  this->Motion.Opening = std::clamp(opening, 0, 2);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->LookupTable = table;
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPosition(double x, double y, double z)
{
  this->Position = { FiniteOr(x, 0.0), FiniteOr(y, 0.0), FiniteOr(z, 0.0) };
  this->UpdateActorPosition();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetTranslation(double x, double y, double z)
{
  this->Translation = { FiniteOr(x, 0.0), FiniteOr(y, 0.0), FiniteOr(z, 0.0) };
  this->UpdateActorPosition();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::UpdateActorPosition()
{
  this->Actor->SetPosition(this->Position[0] + this->Translation[0], this->Position[1] + this->Translation[1],
    this->Position[2] + this->Translation[2]);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(FiniteOr(x, 1.0), FiniteOr(y, 1.0), FiniteOr(z, 1.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(FiniteOr(x, 0.0), FiniteOr(y, 0.0), FiniteOr(z, 0.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(FiniteOr(x, 0.0), FiniteOr(y, 0.0), FiniteOr(z, 0.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  if (std::all_of(matrix, matrix + 16, [](double element) { return std::isfinite(element); }))
  {
    transform->SetMatrix(matrix);
  }
  this->Actor->SetUserTransform(transform);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPickable(int pickable)
{
  this->Actor->SetPickable(pickable);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetActiveAssembly(const char* name)
{
  this->Blocks.SetAssembly(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::AddBlockSelector(const char* selector)
{
  this->Blocks.AddSelector(selector);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::RemoveAllBlockSelectors()
{
  this->Blocks.RemoveAllSelectors();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetBlockColor(const char* selector, double r, double g, double b)
{
  const std::array<double, 3> color = ColorInRange(r, g, b);
  this->Blocks.SetColor(selector, color[0], color[1], color[2]);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::RemoveAllBlockColors()
{
  this->Blocks.RemoveAllColors();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetBlockOpacity(const char* selector, double opacity)
{
  this->Blocks.SetOpacity(selector, InRange(opacity, 0.0, 1.0, 1.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::RemoveAllBlockOpacities()
{
  this->Blocks.RemoveAllOpacities();
}
