#include "vtkRayTracedRepresentation.h"

#include "GlyphJoinedArrays.h"
#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "RayTracedSelection.h"
#include "RayTracedTree.h"
#include "Stopwatch.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include <new>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRayTracedRepresentation);

namespace
{
enum Ports
{
  GLYPH_TYPE_PORT = 1,
  SELECTION_PORT = 2,
  PORTS
};
}

//----------------------------------------------------------------------------
vtkRayTracedRepresentation::vtkRayTracedRepresentation()
  : Glyphs(this->Common)
  , Surface(this->Common)
  , Tubes(this->Common)
  , Content(&this->Glyphs)
  , Rendering(this, this->Common)
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
    this->Rendering.Remove(*this->Content);
    this->Content->Show(false);
    this->Content = content;
    this->Content->Show(this->GetVisibility());
    this->RequestGhostCellsIfNeeded = content->NeedsGhostCells();
    this->MarkModified();
  }
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
  const bool marks = this->Content->MarksSelection() && rtglyphs::RayTracedSelection::Exists(this, SELECTION_PORT);
  vtkDataObject* selected = marks ? vtkDataObject::GetData(inputVector[SELECTION_PORT], 0) : nullptr;
  vtkInformation* info = input ? inputVector[0]->GetInformationObject(0) : nullptr;
  rtg::Stopwatch watch;
  // Placeholder on processes without data: of the type that is received.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  const int emptyType = this->PlaceHolderDataType;
#else
  const int emptyType = VTK_MULTIBLOCK_DATA_SET;
#endif
  vtkSmartPointer<vtkDataObject> gathered = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(emptyType));
  rtglyphs::GlyphSteps& steps = this->Common.Time.Steps;
  const bool trails = this->Content->HasTrails();
  // Of another time the input is updated from here: VTK's own way, CONTINUE_EXECUTING, never ends where a step cannot
  // be read. All ranks have the step, or none.
  const auto gather = [&](vtkInformation* time, const std::function<void()>& next)
  {
    return this->WithinMemory(
      [&]
      {
        if (time)
        {
          vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()->ShallowCopy(time, info);
          vtkInformationExecutivePortKey* producer = vtkExecutive::PRODUCER();
          const bool read = producer->GetExecutive(info)->Update(producer->GetPort(info)) != 0;
          input = rtglyphs::RayTracedRanks::Largest(read ? 0.0 : 1.0) > 0.0 ? nullptr : vtkDataObject::GetData(info);
        }
        if (input)
        {
          const bool has = info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
          this->Gather(input, has ? info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()) : nullptr);
        }
        next();
      },
      /*together=*/true);
  };
  std::vector<double> earlier;
  bool good = gather(nullptr,
    [&]
    {
      if (input)
      {
        earlier = steps.Show(this->Gathered, input, this->GetUpdateTime(), info, this->GetInputAlgorithm(), trails);
      }
    });
  vtkNew<vtkInformation> time, own;
  if (!earlier.empty())
  {
    vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()->ShallowCopy(info, own);
  }
  for (std::size_t i = 0; i < earlier.size() && good; ++i)
  {
    time->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), earlier[i]);
    good = gather(time, [&] { steps.Keep(earlier[i], input ? this->Gathered.Get() : nullptr); });
  }
  good = good &&
    gather(earlier.empty() ? nullptr : own.Get(),
      [&]
      {
        if (input)
        {
          if (!earlier.empty())
          {
            steps.Replace(this->Gathered);
          }
          const vtkSmartPointer<vtkDataObject> made =
            selected ? rtglyphs::RayTracedSelection::Mark(this->Gathered, selected) : this->Gathered;
          steps.AddTo(made, trails, [&] { return this->Rendering.MakeImages(made, input, /*together=*/true); });
          for (vtkPolyData* points : vtkCompositeDataSet::GetDataSets<vtkPolyData>(made))
          {
            this->Complete(points);
          }
          gathered = made;
        }
        rtglyphs::RayTracedTree::AddPartialArrays(gathered);
      });
  if (const std::string message = good ? steps.TakeMessage() : std::string(); !message.empty())
  {
    vtkWarningMacro(<< message);
  }
  this->MultiBlockMaker->SetInputDataObject(gathered);
  this->MultiBlockMaker->Update();
  ++this->Gathers;
  this->GatherSeconds += watch.Lap();
  return this->vtkPVDataRepresentation::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
// Another selection gathers nothing anew.
void vtkRayTracedRepresentation::Gather(vtkDataObject* input, const int* wholeExtent)
{
  this->Surface.NonlinearSubdivisionLevel =
    vtkPVGeometryFilter::SafeDownCast(this->GeometryFilter)->GetNonlinearSubdivisionLevel();
  const int colors = std::max(1, this->GetBlockColorsDistinctValues());
  // Sources that fill the same data object anew differ by the time of its update.
  this->GatherCache.Update({ input, input->GetUpdateTime(), input->GetMTime(), this->Content->GatherOptions(), colors },
    [&]
    {
      this->Gathered = nullptr; // also where the memory does not suffice
      const bool blocks = input->IsA("vtkCompositeDataSet");
      const rtglyphs::RayTracedParallel::Progress progress = this->ProgressOf("Gathering points");
      const double all = std::max(1.0, static_cast<double>(input->GetNumberOfElements(vtkDataObject::POINT)));
      double done = 0.0;
      this->Gathered = rtglyphs::RayTracedTree::Make(input, colors,
        [&](vtkDataObject* data)
        {
          const double first = done;
          done += data ? static_cast<double>(data->GetNumberOfElements(vtkDataObject::POINT)) / all : 0.0;
          return this->Content->Gather(
            data, wholeExtent, blocks, rtglyphs::RayTracedParallel::Part(progress, first, std::min(done, 1.0)));
        });
    });
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
rtglyphs::RayTracedParallel::Progress vtkRayTracedRepresentation::ProgressOf(const char* what)
{
  return [this, what](double share)
  {
    this->SetProgressText(what);
    this->UpdateProgress(share);
  };
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int good = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
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
  return port == 0 ? this->Piece.Get() : this->Rendering.GetReduced();
}

//----------------------------------------------------------------------------
int vtkRayTracedRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // The superclass would fill attributes of blocks for its mapper and for bounds, neither of which is used.
  if (std::exchange(this->BlockAttrChanged, false))
  {
    this->Rendering.ForgetBlocks();
  }
  this->BlockAttributeTime.Modified();
  this->VisibleDataBoundsTime.Modified();
  const bool together = request == vtkPVView::REQUEST_UPDATE() ||
    (request == vtkPVView::REQUEST_RENDER() && this->Rendering.IsCollective(inInfo));
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
void vtkRayTracedRepresentation::ProcessRequest(vtkInformationRequestKey* request, vtkInformation* inInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Common.HasData = this->GetNumberOfInputConnections(0) > 0;
    // Where the view has kept this step of an animation nothing has been gathered, and that piece is what it shows.
    this->Piece = vtkPVView::GetPiece(inInfo, this);
    vtkNew<vtkPolyData> nothing; // of an input that has failed, as a source of a state file may
    this->Rendering.Show(this->Piece ? this->Piece.Get() : nothing.Get());
    this->Content->Deliver(inInfo, this, /*lod=*/false);
    vtkPolyData* points = this->Common.Blocks.GetPolyData();
    if (this->Common.HasData)
    {
      this->Common.Time.UpdateShutterTime(
        points, [&](double& unitSize) { return this->Content->GetSizes(points, unitSize); }, this->GetUpdateTime());
    }
    this->Rendering.UpdateBounds(*this->Content, inInfo, this->Piece);
    vtkRayTracedScene* scene = this->Rendering.GetScene();
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
  else if (request == vtkPVView::REQUEST_RENDER() && this->Rendering.GetView())
  {
    this->Rendering.Render(*this->Content, inInfo, this->Piece, this->NeedsOrderedCompositing());
    const rtglyphs::GlyphBounds& bounds = this->Rendering.GetBounds();
    this->Common.Parts.Mapper->SetDataStatistics(
      { this->GetUniqueIdentifier(), this->Gathers, bounds.GetBuilds(), this->GatherSeconds, bounds.GetSeconds() });
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedRepresentation::NeedsOrderedCompositing()
{
  return this->Content->IsTranslucent() || this->Superclass::NeedsOrderedCompositing();
}

//----------------------------------------------------------------------------
// The superclass would add its actor.
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
  this->Rendering.Remove(*this->Content);
  this->Common.Key->RemoveFrom(renderView);
  this->Glyphs.GetLegend()->RemoveFrom(renderView);
  return this->vtkPVDataRepresentation::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetVisibility(bool visible)
{
  this->Common.Parts.Actor->SetVisibility(visible);
  this->Content->Show(visible);
  this->Superclass::SetVisibility(visible);
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
  this->GatherIf(std::exchange(this->Rendering.Periodic.Boundary, on) != on && this->Content->HasTrails());
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetPeriodicVectors(int index, double value)
{
  this->GatherIf(
    std::exchange(this->Rendering.Periodic.Vectors.at(index), value) != value && this->Content->HasTrails());
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
void vtkRayTracedRepresentation::SetVelocityArray(const char* name)
{
  rtglyphs::RayTracedTime& time = this->Common.Time;
  this->SetArray(time.Motion.Velocity, name);
  this->GatherIf(time.Steps.SetVelocities(time.Motion.Velocity == rtglyphs::RayTracedArrays::StepVelocity));
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
  this->Common.Summary[rtglyphs::DataSummary::SHUTTER_TIME] = this->Common.Time.ShutterGuess;
  return this->Common.Summary.data();
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetDataSummary(const double numbers[11])
{
  static_assert(rtglyphs::DataSummary::SIZE == 11);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    std::copy_n(numbers, this->Common.Summary.size(), this->Common.Summary.begin());
    this->Common.Time.ShutterGuess = this->Common.Summary[rtglyphs::DataSummary::SHUTTER_TIME];
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedRepresentation::SetGlyphSizeRange(double least, double most)
{
  rtglyphs::GlyphSizing& sizing = this->Glyphs.Settings.Sizing;
  sizing.Least = std::max(OrZero(least), 0.0);
  sizing.Most = std::max(OrZero(most), 0.0);
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
