#include "vtkRayTracedGlyphRepresentation.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkGlyphJoinedArrays.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkGlyphTuples.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkRayTracedParallel.h"
#include "vtkRayTracedSurfaceGatherer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

vtkStandardNewMacro(vtkRayTracedGlyphRepresentation);

//----------------------------------------------------------------------------
struct vtkRayTracedGlyphRepresentation::Layer
{
  vtkNew<vtkRayTracedActor> Actor;
  vtkNew<vtkRayTracedGlyphMapper> Mapper;

  // Input, blocks and appearance of the main actor and mapper.
  void Follow(vtkPolyData* points, vtkRayTracedActor* actor, const vtkGlyphBlockAttributes& blocks,
    const std::array<double, 3>& selectionColor)
  {
    this->Mapper->SetSelectionColor(selectionColor);
    this->Mapper->SetPoints(points);
    this->Mapper->SetBlocks(blocks);
    this->Actor->GetProperty()->DeepCopy(actor->GetProperty());
    vtkNew<vtkMatrix4x4> matrix;
    actor->GetMatrix(matrix);
    this->Actor->SetUserMatrix(matrix);
    this->Actor->SetPickable(actor->GetPickable());
    this->Actor->SetVisibility(actor->GetVisibility());
  }

  void FollowColors(vtkRayTracedMapper* main)
  {
    this->Mapper->SetScalarVisibility(main->GetScalarVisibility());
    this->Mapper->SelectColorArray(main->GetArrayName());
    this->Mapper->SetUseLookupTableScalarRange(main->GetUseLookupTableScalarRange());
    this->Mapper->SetScalarMode(main->GetScalarMode());
    this->Mapper->SetColorMode(main->GetColorMode());
    // Asked for its table, a mapper without one makes one.
    if (main->GetScalarVisibility())
    {
      this->Mapper->SetLookupTable(main->GetLookupTable());
    }
  }
};

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::vtkRayTracedGlyphRepresentation()
  : vtkRayTracedSelectableRepresentation(3)
{
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::~vtkRayTracedGlyphRepresentation() = default;

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GlyphShape: " << this->GlyphShape << endl;
  os << indent << "GlyphLocation: " << this->GlyphLocation << endl;
}

//****************************************************************************
// The data side
//****************************************************************************

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
  return this->Superclass::FillInputPortInformation(port, info); // 0, and 2: what is selected of it
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->GatherMesh(
    inputVector[1]->GetNumberOfInformationObjects() == 1 ? vtkDataObject::GetData(inputVector[1], 0) : nullptr);
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
// The mesh of mesh glyphs, or those of a table.
void vtkRayTracedGlyphRepresentation::GatherMesh(vtkDataObject* mesh)
{
  // 3D Glyphs shade meshes by the normals they have, and compute none.
  vtkRayTracedSurfaceGatherer::Settings settings;
  settings.ComputesNormals = false;
  const auto gather = [&](vtkDataObject* data) { return vtkRayTracedSurfaceGatherer::Gather(data, settings); };
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
      table->SetBlock(table->GetNumberOfBlocks(), gather(block->GetCurrentDataObject()));
    }
    this->Mesh->SetBlock(0, table);
  }
  else
  {
    this->Mesh->SetBlock(0, gather(mesh));
  }
  this->Mesh->Modified();
  this->UpdateMeshExtents(this->Mesh->GetBlock(0));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateMeshExtents(vtkDataObject* forms)
{
  std::vector<vtkPolyData*> meshes;
  if (auto* table = vtkMultiBlockDataSet::SafeDownCast(forms))
  {
    for (unsigned int i = 0; i < table->GetNumberOfBlocks(); ++i)
    {
      meshes.push_back(vtkPolyData::SafeDownCast(table->GetBlock(i)));
    }
  }
  else
  {
    meshes.push_back(vtkPolyData::SafeDownCast(forms));
  }
  std::vector<vtkMTimeType> times;
  for (vtkPolyData* mesh : meshes)
  {
    times.push_back(mesh && mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0);
  }
  if (times == this->MeshExtentsTimes)
  {
    return;
  }
  this->MeshExtentsTimes = times;
  this->MeshExtents.clear();
  for (vtkPolyData* mesh : meshes)
  {
    auto corners = std::make_shared<rtg::TriangleMesh>();
    if (mesh && mesh->GetNumberOfPoints() > 0)
    {
      double b[6];
      mesh->GetBounds(b);
      corners->positions = { glm::vec3(b[0], b[2], b[4]), glm::vec3(b[1], b[3], b[5]) };
    }
    this->MeshExtents.push_back(std::move(corners));
  }
}

//----------------------------------------------------------------------------
// The mesh of mesh glyphs is the same on all processes.
int vtkRayTracedGlyphRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  for (int i = 0; i < inputVector[1]->GetNumberOfInformationObjects(); ++i)
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
vtkSmartPointer<vtkPolyData> vtkRayTracedGlyphRepresentation::GatherAnew(vtkDataObject* input, const int* wholeExtent)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkGlyphPointGatherer::Options options;
  options.CellCenters = this->GlyphLocation == CELLS;
  if (controller)
  {
    options.ProcessId = controller->GetLocalProcessId();
    options.Processes = controller->GetNumberOfProcesses();
  }
  options.WholeExtent = wholeExtent;
  options.Progress = this->ProgressOf("Gathering points");
  return vtkGlyphPointGatherer::Gather(input, options);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::AddArrays(vtkPolyData* points)
{
  const vtkGlyphSettings settings = this->MakeSettings();
  for (const std::string& name :
    { settings.ScaleArray, settings.OrientationArray, settings.ExponentArray, settings.Tensors.Array,
      settings.Forms.Array, settings.Motion.Velocity, settings.Motion.Acceleration, settings.Motion.AngularVelocity })
  {
    vtkGlyphJoinedArrays::Add(points, name);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::Deliver(vtkInformation* inInfo, bool lod)
{
  // In a composite, because data of several ranks that are put together do not stay apart otherwise.
  if (lod)
  {
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->Mesh, 0, 1);
  }
  else
  {
    vtkPVView::SetPiece(inInfo, this, this->Mesh, 0, 1);
    this->UpdateTensorRange(this->GetPoints());
    this->UpdateScaleGuess(this->GetPoints());
    this->CountPointsOfAllRanks(this->GetPoints());
  }
}

//----------------------------------------------------------------------------
// On all ranks that have data.
void vtkRayTracedGlyphRepresentation::CountPointsOfAllRanks(vtkPolyData* points)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  if (this->Glyphs.Mask.On && controller && controller->GetNumberOfProcesses() > 1)
  {
    const vtkIdType own = count;
    controller->AllReduce(&own, &count, 1, vtkCommunicator::SUM_OP);
  }
  this->Glyphs.Mask.PointsOfAllRanks = count;
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::MayBeTranslucent()
{
  return !vtkRayTracedArrays::IsNone(this->Glyphs.OpacityArray) || this->Superclass::MayBeTranslucent();
}

//----------------------------------------------------------------------------
const double* vtkRayTracedGlyphRepresentation::GetDataBounds(vtkPolyData* points)
{
  const vtkGlyphSettings settings = this->MakeSettings();
  std::vector<vtkGlyphSettings> all{ settings };
  if (settings.Shape == rtg::Shape::Mesh)
  {
    all.clear();
    for (const auto& corners : this->MeshExtents)
    {
      all.push_back(settings);
      all.back().Mesh = corners;
    }
  }
  else if (this->ShowsAxes(points, settings))
  {
    all.push_back(settings.AxesOfTensors());
  }
  return this->GetBoundsOf(points, all);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateTensorRange(vtkPolyData* points)
{
  const vtkGlyphSettings settings = this->MakeSettings();
  if (settings.HasNumberRange())
  {
    const std::array<double, 2> range = this->NumberRange.Get(points, settings, true);
    std::copy(range.begin(), range.end(), this->TensorRange);
  }
}

//----------------------------------------------------------------------------
// On all ranks that have data; before anything asks for the glyphs' size.
void vtkRayTracedGlyphRepresentation::UpdateScaleGuess(vtkPolyData* points)
{
  if (!this->ScaleFactorFromData || this->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  const vtkGlyphSettings settings = this->MakeSettings();
  double unitSize = settings.Shape == rtg::Shape::Capsule ? 2.0 : 1.0;
  if (settings.Shape == rtg::Shape::Mesh)
  {
    unitSize = 0.0;
    for (const auto& corners : this->MeshExtents)
    {
      const glm::vec3 sides =
        corners->positions.empty() ? glm::vec3(0.0f) : corners->positions.back() - corners->positions.front();
      unitSize = std::max<double>(unitSize, std::max({ sides.x, sides.y, sides.z }));
    }
  }
  const vtkGlyphScaleGuess::Result& found = this->Guess.Get(points, settings, unitSize, this->GetUpdateTime());
  this->ScaleGuess[0] = found.Factor;
  this->ScaleGuess[1] = found.Limit;
}

//****************************************************************************
// The render side
//****************************************************************************

//----------------------------------------------------------------------------
vtkSmartPointer<vtkRayTracedMapper> vtkRayTracedGlyphRepresentation::MakeMapper()
{
  return vtkSmartPointer<vtkRayTracedGlyphMapper>::New();
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::ShowsAxes(vtkPolyData* points, const vtkGlyphSettings& settings) const
{
  vtkDataArray* tensors = this->TensorAxis && points ? vtkGlyphTensors::Array(points, settings.Tensors) : nullptr;
  return tensors && tensors->GetNumberOfComponents() == 9;
}

//----------------------------------------------------------------------------
// Form 0 of a table of meshes is drawn by the main mapper, form i by layer i - 1. The arrows of antisymmetric parts are
// a layer, too.
void vtkRayTracedGlyphRepresentation::Configure(vtkInformation* inInfo, vtkPolyData* points, bool lod, bool collective)
{
  auto* mesh = vtkMultiBlockDataSet::SafeDownCast(
    lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, this, 1) : vtkPVView::GetDeliveredPiece(inInfo, this, 1));
  vtkDataObject* forms = mesh && mesh->GetNumberOfBlocks() > 0 ? mesh->GetBlock(0) : nullptr;
  this->UpdateMeshExtents(forms);
  auto* table = vtkMultiBlockDataSet::SafeDownCast(forms);
  const auto form = [&](int entry) {
    return vtkPolyData::SafeDownCast(table ? table->GetBlock(entry) : entry == 0 ? forms : nullptr);
  };

  vtkGlyphSettings settings = this->MakeSettings();
  const bool usesTable = table && table->GetNumberOfBlocks() > 1 && settings.Shape == rtg::Shape::Mesh;
  settings.TableSize = usesTable ? static_cast<int>(table->GetNumberOfBlocks()) : 1;
  const vtkGlyphBlockAttributes::Table noBlocks;
  const vtkGlyphBlockAttributes::Table& blocks = points ? this->Blocks.Resolve(points) : noBlocks;
  settings.HighScale = this->HighScale.Get(points, settings, blocks, collective);
  auto* main = static_cast<vtkRayTracedGlyphMapper*>(this->GetMapper());
  main->SetInWindow(this->IsInWindow());
  main->SetSettings(settings, table && table->GetNumberOfBlocks() == 0 ? nullptr : form(0));
  main->SetTensorTable(this->TensorTable);
  if (settings.HasNumberRange() && (!this->TensorTable || settings.Tensors.Coloring == vtkGlyphTensors::EIGENVALUES))
  {
    main->SetTensorRange(this->ShownRange.Get(points, settings, collective));
  }
  main->SetSelectionColor(this->GetSelectionColor());
  this->UpdateLegend(points, settings);

  const bool axes = this->ShowsAxes(points, settings);
  const std::size_t wanted = settings.TableSize - 1 + (axes ? 1 : 0);
  while (this->Layers.size() > wanted)
  {
    this->RemovePart(this->GetRenderView(), this->Layers.back()->Actor, this->Layers.back()->Mapper);
    this->Layers.pop_back();
  }
  while (this->Layers.size() < wanted)
  {
    this->Layers.push_back(std::make_unique<Layer>());
    this->AddPart(this->GetRenderView(), this->Layers.back()->Actor, this->Layers.back()->Mapper);
  }
  for (int entry = 1; entry < settings.TableSize; ++entry)
  {
    Layer& layer = *this->Layers[entry - 1];
    layer.Follow(points, this->GetActor(), this->Blocks, this->GetSelectionColor());
    layer.FollowColors(main);
    settings.TableEntry = entry;
    layer.Mapper->SetSettings(settings, form(entry));
  }
  if (axes)
  {
    Layer& layer = *this->Layers.back();
    layer.Follow(points, this->GetActor(), this->Blocks, this->GetSelectionColor());
    layer.Mapper->ScalarVisibilityOff();
    layer.Mapper->SetSettings(settings.AxesOfTensors(), nullptr);
    layer.Actor->GetProperty()->SetAmbientColor(this->TensorAxisColor.data());
    layer.Actor->GetProperty()->SetDiffuseColor(this->TensorAxisColor.data());
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateLegend(vtkPolyData* points, vtkGlyphSettings settings)
{
  this->Legend->SetStyle(this->LegendStyle);
  if (!this->LegendStyle.On)
  {
    return;
  }
  const std::string scales =
    settings.Scaling && !vtkRayTracedArrays::IsNone(settings.ScaleArray) ? settings.ScaleArray : std::string();
  const std::string name = settings.Tensors.On  ? settings.Tensors.Array
    : settings.Forms.On && !settings.Forms.Each ? settings.Forms.Array
                                                : scales;
  if (settings.Shape == rtg::Shape::Mesh && !this->MeshExtents.empty())
  {
    settings.Mesh = this->MeshExtents.front();
  }
  vtkNew<vtkPolyData> nothing;
  vtkPolyData* known = points ? points : nothing.Get();
  vtkNew<vtkMatrix4x4> matrix;
  this->GetActor()->GetMatrix(matrix);
  const double scale = std::hypot(matrix->GetElement(0, 0), matrix->GetElement(1, 0), matrix->GetElement(2, 0));
  const double reference =
    scales.empty() ? 1.0 : vtkGlyphHighScale::Reference(known, settings, this->Blocks.Resolve(known));
  this->Legend->SetGlyphs(settings, scale, name, reference);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPartBounds(const double bounds[6])
{
  this->Superclass::SetPartBounds(bounds);
  for (const auto& layer : this->Layers)
  {
    layer->Mapper->SetKnownBounds(bounds);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::ShowLayers(bool visible)
{
  this->Legend->SetVisibility(visible);
  for (const auto& layer : this->Layers)
  {
    layer->Actor->SetVisibility(visible);
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->Legend->AddTo(renderView);
  }
  return this->Superclass::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->Legend->RemoveFrom(renderView);
  }
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::RemoveLayers(vtkPVRenderView* view)
{
  for (const auto& layer : this->Layers)
  {
    this->RemovePart(view, layer->Actor, layer->Mapper);
  }
  this->Layers.clear();
}

//****************************************************************************
// Properties
//****************************************************************************

//----------------------------------------------------------------------------
// Properties that determine each other are put together here, whatever the order in which they were set.
vtkGlyphSettings vtkRayTracedGlyphRepresentation::MakeSettings() const
{
  vtkGlyphSettings settings = this->Glyphs.InRange();
  settings.Motion = this->Motion;
  if (this->ScaleFactorFromData)
  {
    const bool own = this->ScaleGuess[0] > 0.0; // else this process only renders, or there are no glyphs
    settings.ScaleFactor = own ? this->ScaleGuess[0] : settings.ScaleFactor;
    const double limit = own ? this->ScaleGuess[1] : this->SizeLimit;
    double& most = settings.Sizing.Most;
    most = limit > 0.0 && (most == 0.0 || most > limit) ? limit : most;
  }
  settings.Tensors.On = this->GlyphShape >= TENSOR_ELLIPSOID && this->GlyphShape <= SIGNED_TENSOR_SUPERQUADRIC;
  const bool polynomial = this->GlyphShape >= SPHERICAL_HARMONICS && this->GlyphShape <= FOURTH_ORDER_TENSOR;
  if (!polynomial && settings.Tensors.Coloring == vtkGlyphTensors::RADIUS)
  {
    settings.Tensors.Coloring = vtkGlyphTensors::NONE;
  }
  if (this->GlyphShape == PRINCIPAL_AXES)
  {
    return settings.PrincipalAxes();
  }
  if (settings.Tensors.On)
  {
    settings.Tensors.Kind = static_cast<rtg::TensorGlyphKind>(this->GlyphShape - TENSOR_ELLIPSOID);
    settings.Shape = this->GlyphShape == TENSOR_ELLIPSOID ? rtg::Shape::Sphere : rtg::Shape::NestedSuperquadric;
  }
  else if (polynomial)
  {
    settings.Shape = rtg::Shape::Polynomial;
    settings.Forms.On = true;
    settings.Forms.Kind = this->GlyphShape - SPHERICAL_HARMONICS;
    settings.Forms.Array = this->GlyphShape == SPHERICAL_HARMONICS ? this->HarmonicsArray : settings.Tensors.Array;
    settings.Forms.Layout = settings.Tensors.Layout;
    settings.Forms.Coloring = settings.Tensors.Coloring;
  }
  else
  {
    settings.Shape = this->GlyphShape == MESH ? rtg::Shape::Mesh : static_cast<rtg::Shape>(this->GlyphShape);
    if (settings.Shape == rtg::Shape::Superquadric && this->NestedExponents)
    {
      settings.Shape = rtg::Shape::NestedSuperquadric;
    }
  }
  return settings;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphLocation(int location)
{
  location = std::clamp<int>(location, POINTS, CELLS);
  if (this->GlyphLocation != location)
  {
    this->GlyphLocation = location;
    this->ForgetGathered();
    this->MarkModified(); // other points must be gathered
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphShape(int shape)
{
  // The first entry of a number counts.
#define RTG_SHAPE_NAME(number, Name) { number, #Name },
  static const std::map<int, std::string> names = { { TENSOR_ELLIPSOID, "Tensor Ellipsoid" },
    { TENSOR_SUPERQUADRIC, "Tensor Superquadric" }, { SIGNED_TENSOR_SUPERQUADRIC, "Signed Tensor Superquadric" },
    { MESH, "Mesh" }, { SPHERICAL_HARMONICS, "Spherical Harmonics" }, { REYNOLDS, "Reynolds" },
    { FOURTH_ORDER_TENSOR, "Fourth-Order Tensor" }, { PRINCIPAL_AXES, "Principal Axes" }, RTG_SHAPES(RTG_SHAPE_NAME) };
#undef RTG_SHAPE_NAME
  if (!names.count(shape))
  {
    std::string known;
    for (const auto& [number, name] : names)
    {
      known += (known.empty() ? "" : ", ") + std::to_string(number) + " (" + name + ")";
    }
    vtkErrorMacro("GlyphShape is " << shape << "; it must be one of " << known << ".");
    return;
  }
  this->GlyphShape = shape;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaleFactorFromData(bool on)
{
  this->ScaleFactorFromData = on;
  this->Guess.Forget();
  this->ScaleGuess[0] = this->ScaleGuess[1] = 0.0;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaleReference(double reference)
{
  if (!(reference > 0.0 && std::isfinite(reference)))
  {
    vtkErrorMacro(
      "GlyphScaleReference is " << reference << "; it must be positive, in units of the scale array. 1 is taken.");
    reference = 1.0;
  }
  this->Glyphs.Sizing.Reference = reference;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphSizeRange(double least, double most)
{
  vtkGlyphSizing& sizing = this->Glyphs.Sizing;
  sizing.Least = std::max(vtkRayTracedNumbers::NumberOr(least, 0.0), 0.0);
  sizing.Most = std::max(vtkRayTracedNumbers::NumberOr(most, 0.0), 0.0);
  if (sizing.Most > 0.0 && sizing.Most < sizing.Least)
  {
    vtkErrorMacro("GlyphSizeRange is " << least << ", " << most
                                       << "; the second must not be less than the first. All glyphs get the size "
                                       << most << ".");
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphExponents(double r, double s, double t)
{
  // What is no number makes no glyph, as zero does.
  this->Glyphs.Exponents[0] = vtkRayTracedNumbers::NumberOr(r, 0.0);
  this->Glyphs.Exponents[1] = vtkRayTracedNumbers::NumberOr(s, 0.0);
  this->Glyphs.Exponents[2] = vtkRayTracedNumbers::NumberOr(t, 0.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorLookupTable(vtkScalarsToColors* table)
{
  this->TensorTable = table;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphMeshTable(bool use)
{
  if (this->GlyphMeshTable != use)
  {
    this->GlyphMeshTable = use;
    this->MarkModified(); // the meshes must be gathered again
  }
}
