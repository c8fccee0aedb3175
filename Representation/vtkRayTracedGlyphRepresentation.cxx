#include "vtkRayTracedGlyphRepresentation.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkGlyphStepVelocity.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedGlyphCompanion.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkRayTracedSurfaceGatherer.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>

vtkStandardNewMacro(vtkRayTracedGlyphRepresentation);

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::vtkRayTracedGlyphRepresentation()
  : vtkRayTracedGlyphRepresentation(vtkSmartPointer<vtkRayTracedGlyphMapper>::New())
{
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::vtkRayTracedGlyphRepresentation(
  vtkSmartPointer<vtkRayTracedGlyphMapper> mapper)
  : Mapper(std::move(mapper))
  , Axes(std::make_unique<vtkRayTracedGlyphCompanion>())
  , Points(vtkSmartPointer<vtkPolyData>::New())
  , StepVelocity(std::make_unique<vtkGlyphStepVelocity>())
{
  this->SetNumberOfInputPorts(2);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetProperty(this->Property);
  // Render passes tell the mapper through these keys what they want of its shader.
  vtkNew<vtkInformation> keys;
  this->Actor->SetPropertyKeys(keys);
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::~vtkRayTracedGlyphRepresentation() = default;

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper* vtkRayTracedGlyphRepresentation::GetMapper()
{
  return this->Mapper;
}

//----------------------------------------------------------------------------
vtkProperty* vtkRayTracedGlyphRepresentation::GetProperty()
{
  return this->Property;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:" << endl;
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHyperTreeGrid");
  // On processes that only render there is no input.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  vtkInformation* info = input ? inputVector[0]->GetInformationObject(0) : nullptr;
  const int* wholeExtent = info && info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    ? info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    : nullptr;
  this->Points = this->Gather(input, wholeExtent);
  this->AddStepVelocities(input);
  if (this->GetNumberOfInputPorts() > 1)
  {
    this->GatherMesh(inputVector[1]->GetNumberOfInformationObjects() == 1 ? vtkDataObject::GetData(inputVector[1], 0)
                                                                           : nullptr);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
// The form of mesh glyphs, or those of a table.
void vtkRayTracedGlyphRepresentation::GatherMesh(vtkDataObject* mesh)
{
  // 3D Glyphs shade meshes by the normals they have, and compute none.
  vtkRayTracedSurfaceGatherer::Settings settings;
  settings.ComputesNormals = false;
  auto* blocks = vtkDataObjectTree::SafeDownCast(mesh);
  if (this->GlyphMeshTable && blocks)
  {
    vtkNew<vtkMultiBlockDataSet> table;
    auto block = vtk::TakeSmartPointer(blocks->NewTreeIterator());
    block->SetSkipEmptyNodes(false);
    block->SetVisitOnlyLeaves(false);
    block->SetTraverseSubTree(false);
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      table->SetBlock(table->GetNumberOfBlocks(), vtkRayTracedSurfaceGatherer::Gather(block->GetCurrentDataObject(), settings));
    }
    this->Mesh->SetBlock(0, table);
  }
  else
  {
    this->Mesh->SetBlock(0, vtkRayTracedSurfaceGatherer::Gather(mesh, settings));
  }
  this->Mesh->Modified();
}

//----------------------------------------------------------------------------
// Where the data are, and not where they are rendered: what is delivered may come from ParaView's cache of time steps.
void vtkRayTracedGlyphRepresentation::AddStepVelocities(vtkDataObject* input)
{
  if (!this->Mapper->Glyphs.Motion.FromPreviousStep || !input)
  {
    return;
  }
  vtkAlgorithm* source = this->GetInputAlgorithm();
  if (this->StepVelocitySource != source)
  {
    this->StepVelocity->Reset();
    this->StepVelocitySource = source;
  }
  vtkInformation* info = input->GetInformation();
  const double time = info->Has(vtkDataObject::DATA_TIME_STEP())
    ? info->Get(vtkDataObject::DATA_TIME_STEP())
    : vtkMath::Nan();
  this->StepVelocity->AddTo(this->Points, this->PointIds(), time);
  const std::string message = this->StepVelocity->TakeMessage();
  if (!message.empty())
  {
    vtkWarningMacro(<< message);
  }
}

//----------------------------------------------------------------------------
// Of the gathered points; null: there are none.
vtkDataArray* vtkRayTracedGlyphRepresentation::PointIds()
{
  vtkPointData* data = this->Points->GetPointData();
  const bool named = !this->PointIdArray.empty() && this->PointIdArray != "None";
  vtkDataArray* ids = named ? data->GetArray(this->PointIdArray.c_str()) : data->GetGlobalIds();
  return ids && ids->GetNumberOfComponents() == 1 ? ids : nullptr;
}

//----------------------------------------------------------------------------
// The form of mesh glyphs is the same on all processes.
int vtkRayTracedGlyphRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  for (int i = 0;
       this->GetNumberOfInputPorts() > 1 && i < inputVector[1]->GetNumberOfInformationObjects();
       ++i)
  {
    vtkInformation* info = inputVector[1]->GetInformationObject(i);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::EXACT_EXTENT(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData>
vtkRayTracedGlyphRepresentation::Gather(vtkDataObject* input, const int* wholeExtent)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return vtkGlyphPointGatherer::Gather(input, controller ? controller->GetLocalProcessId() : 0,
    controller ? controller->GetNumberOfProcesses() : 1, wholeExtent);
}

//----------------------------------------------------------------------------
vtkDataObject* vtkRayTracedGlyphRepresentation::GetRenderedDataObject(int)
{
  return this->Points;
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // not visible
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->ShareMeanScale();
    vtkPVView::SetPiece(inInfo, this, this->Points);
    if (this->GetNumberOfInputPorts() > 1)
    {
      // In a composite, because data of several ranks that are put together do not stay apart otherwise.
      vtkPVView::SetPiece(inInfo, this, this->Mesh, 0, 1);
      this->UpdateTable(this->Mesh->GetBlock(0));
    }
    double bounds[6];
    vtkBoundingBox all;
    const auto add = [&](const vtkGlyphInstanceBuilder::Settings& glyphs)
    {
      vtkGlyphInstanceBuilder::ComputeBounds(
        this->Points, glyphs, this->Mapper->Blocks.Resolve(this->Points), bounds);
      all.AddBounds(bounds);
    };
    add(this->Mapper->Glyphs);
    for (const auto& form : this->Table)
    {
      add(form->GetMapper().Glyphs);
    }
    if (this->ShowsAxes(this->Points))
    {
      add(vtkGlyphInstanceBuilder::AxesOf(this->Mapper->Glyphs));
    }
    all.GetBounds(bounds);
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, this->ReplicateGlyphs);
    vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
      this->ReplicateGlyphs
        ? vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION
        : vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
    outInfo->Set(
      vtkPVRenderView::NEED_ORDERED_COMPOSITING(), this->NeedsOrderedCompositing() ? 1 : 0);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    auto* points = vtkPolyData::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this));
    if (points != this->Mapper->GetInputDataObject(0, 0))
    {
      this->Mapper->SetInputDataObject(points);
    }
    if (this->GetNumberOfInputPorts() > 1)
    {
      auto* mesh =
        vtkMultiBlockDataSet::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this, 1));
      this->UpdateTable(mesh && mesh->GetNumberOfBlocks() > 0 ? mesh->GetBlock(0) : nullptr);
    }
    this->UpdateColoring(points);
    for (const auto& form : this->Table)
    {
      form->Follow(points, this->Mapper, this->Actor);
      form->FollowColors(this->Mapper);
    }
    this->UpdateAxes(points);
  }
  return 1;
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::ShowsAxes(vtkPolyData* points) const
{
  vtkDataArray* tensors = this->TensorAxis && points
    ? vtkGlyphTensors::Array(points, this->Mapper->Glyphs.Tensors)
    : nullptr;
  return tensors && tensors->GetNumberOfComponents() == 9;
}

//----------------------------------------------------------------------------
// The arrows of antisymmetric parts are a second set of glyphs of the same points, of one colour.
void vtkRayTracedGlyphRepresentation::UpdateAxes(vtkPolyData* points)
{
  if (!this->ShowsAxes(points))
  {
    this->Axes->Hide();
    return;
  }
  this->Axes->GetMapper().Glyphs = vtkGlyphInstanceBuilder::AxesOf(this->Mapper->Glyphs);
  this->Axes->Follow(points, this->Mapper, this->Actor);
  this->Axes->GetProperty()->SetAmbientColor(this->TensorAxisColor.data());
  this->Axes->GetProperty()->SetDiffuseColor(this->TensorAxisColor.data());
}

//----------------------------------------------------------------------------
// The mapper takes the first form, or the only one; each further one has a companion.
void vtkRayTracedGlyphRepresentation::UpdateTable(vtkDataObject* forms)
{
  auto* table = vtkMultiBlockDataSet::SafeDownCast(forms);
  vtkGlyphInstanceBuilder::Settings& glyphs = this->Mapper->Glyphs;
  const bool used = table && table->GetNumberOfBlocks() > 1 && glyphs.Shape == rtg::Shape::Mesh;
  glyphs.TableSize = used ? static_cast<int>(table->GetNumberOfBlocks()) : 1;
  vtkDataObject* first = table && table->GetNumberOfBlocks() > 0 ? table->GetBlock(0) : forms;
  this->Mapper->SetGlyphMesh(vtkPolyData::SafeDownCast(first));

  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  const auto further = static_cast<std::size_t>(glyphs.TableSize - 1);
  while (this->Table.size() > further)
  {
    if (view)
    {
      this->Table.back()->RemoveFrom(view, this);
    }
    this->Table.pop_back();
  }
  while (this->Table.size() < further)
  {
    this->Table.push_back(std::make_unique<vtkRayTracedGlyphCompanion>());
    if (view)
    {
      this->Table.back()->AddTo(view, this);
    }
  }
  for (int entry = 1; entry < glyphs.TableSize; ++entry)
  {
    vtkRayTracedGlyphMapper& mapper = this->Table[entry - 1]->GetMapper();
    const auto mesh = mapper.Glyphs.Mesh;
    mapper.Glyphs = glyphs;
    mapper.Glyphs.TableEntry = entry;
    mapper.Glyphs.Mesh = mesh;
    mapper.SetGlyphMesh(vtkPolyData::SafeDownCast(table->GetBlock(entry)));
  }
}

//----------------------------------------------------------------------------
std::vector<vtkRayTracedGlyphCompanion*> vtkRayTracedGlyphRepresentation::Companions()
{
  std::vector<vtkRayTracedGlyphCompanion*> all{ this->Axes.get() };
  std::transform(this->Table.begin(), this->Table.end(), std::back_inserter(all), [](const auto& form) { return form.get(); });
  return all;
}

//----------------------------------------------------------------------------
// Heads of arrows are of one size on all ranks: each takes the mean over all of them along with its points.
void vtkRayTracedGlyphRepresentation::ShareMeanScale()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2 ||
    !vtkGlyphInstanceBuilder::NeedsMeanScale(this->Mapper->Glyphs))
  {
    return;
  }
  const vtkGlyphInstanceBuilder::ScaleSum own = vtkGlyphInstanceBuilder::SumScales(
    this->Points, this->Mapper->Glyphs, this->Mapper->Blocks.Resolve(this->Points));
  const double send[2] = { own.Sum, own.Count };
  double sum[2] = { 0.0, 0.0 };
  controller->AllReduce(send, sum, 2, vtkCommunicator::SUM_OP);
  const vtkGlyphInstanceBuilder::ScaleSum all{ sum[0], sum[1] };
  if (vtkGlyphInstanceBuilder::SharedMeanScale(this->Points) != all.Mean())
  {
    vtkNew<vtkDoubleArray> mean;
    mean->SetName(vtkGlyphInstanceBuilder::MeanScaleName());
    mean->InsertNextValue(all.Mean());
    this->Points->GetFieldData()->AddArray(mean);
    this->Points->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateColoring(vtkPolyData* points)
{
  const char* name = nullptr;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (info && info->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    info->Has(vtkDataObject::FIELD_NAME()))
  {
    name = info->Get(vtkDataObject::FIELD_NAME());
    association = info->Get(vtkDataObject::FIELD_ASSOCIATION());
  }
  if (!name || !name[0])
  {
    this->Mapper->ScalarVisibilityOff();
    this->Mapper->SelectColorArray(static_cast<const char*>(nullptr));
    return;
  }
  // Cells of a hyper tree grid have become points on the way.
  bool cells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (cells && points && !points->GetCellData()->HasArray(name))
  {
    cells = !points->GetPointData()->HasArray(name);
  }
  this->Mapper->ScalarVisibilityOn();
  this->Mapper->SelectColorArray(name);
  this->Mapper->SetUseLookupTableScalarRange(1);
  this->Mapper->SetScalarMode(
    cells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::NeedsOrderedCompositing()
{
  // Asked on all ranks before the data are delivered: what may turn out translucent counts.
  const double opacity = this->Property->GetOpacity();
  if ((opacity > 0.0 && opacity < 1.0) || this->Mapper->Blocks.HasTranslucent())
  {
    return true;
  }
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  if (!name || !name[0])
  {
    return false;
  }
  vtkScalarsToColors* table = this->Mapper->GetLookupTable();
  return this->Mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (table && table->IsOpaque() == 0);
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  for (vtkRayTracedGlyphCompanion* companion : this->Companions())
  {
    companion->AddTo(renderView, this);
  }
  this->Mapper->Join(renderView->GetRenderer());
  return this->Superclass::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  this->Mapper->Leave(renderView->GetRenderer());
  for (vtkRayTracedGlyphCompanion* companion : this->Companions())
  {
    companion->RemoveFrom(renderView, this);
  }
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible);
  for (vtkRayTracedGlyphCompanion* companion : this->Companions())
  {
    companion->SetVisibility(visible);
  }
  this->Superclass::SetVisibility(visible);
}

//----------------------------------------------------------------------------
const char* vtkRayTracedGlyphRepresentation::GetDeviceName()
{
  this->DeviceName = this->Mapper->GetDeviceName();
  return this->DeviceName.c_str();
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::GetAccumulatedSamples()
{
  return this->Mapper->GetAccumulatedSamples();
}

//----------------------------------------------------------------------------
const char* vtkRayTracedGlyphRepresentation::GetRenderStatistics()
{
  this->Statistics = this->Mapper->GetStatistics();
  return this->Statistics.c_str();
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::GetRenderedRemotely()
{
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  return view && view->GetUseDistributedRenderingForRender();
}
