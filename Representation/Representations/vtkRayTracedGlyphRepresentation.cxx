#include "vtkRayTracedGlyphRepresentation.h"

#include "Finite.h"
#include "GlyphJoinedArrays.h"
#include "GlyphLayers.h"
#include "GlyphPointGatherer.h"
#include "GlyphSample.h"
#include "RayTracedRanks.h"
#include "GlyphScaleGuess.h"
#include "GlyphSource.h"
#include "GlyphTuples.h"
#include "RayTracedParallel.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkRayTracedGlyphRepresentation);

namespace
{
constexpr double ellipsoidOpacity = 0.4; // of uncertain vectors, whose heads are seen through it
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::vtkRayTracedGlyphRepresentation()
  : vtkRayTracedSelectableRepresentation(3)
  , Layers(std::make_unique<rtglyphs::GlyphLayers>())
{
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphRepresentation::~vtkRayTracedGlyphRepresentation() = default;

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
  const bool hasMesh = inputVector[1]->GetNumberOfInformationObjects() == 1;
  this->Meshes.Gather(
    hasMesh ? vtkDataObject::GetData(inputVector[1], 0) : nullptr, this->SourceIndexing && this->UseSourceTableTree);
  if (hasMesh && this->Meshes.GetMesh(0))
  {
    rtglyphs::GlyphSource(this->GetInputAlgorithm(1, 0)).StoreIn(this->Meshes.GetMesh(0));
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
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
vtkSmartPointer<vtkPolyData> vtkRayTracedGlyphRepresentation::Gather(
  vtkDataObject* data, const int* wholeExtent, bool isBlock, const rtglyphs::RayTracedParallel::Progress& progress)
{
  rtglyphs::GlyphPointGatherer::Options options;
  options.CellCenters = this->GlyphLocation == CELLS;
  options.IsBlock = isBlock;
  options.WholeExtent = wholeExtent;
  options.Progress = progress;
  return rtglyphs::GlyphPointGatherer::Gather(data, options);
}

//----------------------------------------------------------------------------
std::vector<std::string> vtkRayTracedGlyphRepresentation::Arrays() const
{
  const rtglyphs::GlyphSettings settings = this->MakeSettings();
  std::vector<std::string> names = this->Superclass::Arrays();
  for (const std::string* name : { &settings.ScaleArray, &settings.OrientationArray, &settings.ExponentArray,
         &settings.Tensors.Array, &settings.Forms.Array })
  {
    names.push_back(*name);
  }
  return names;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::Deliver(vtkInformation* inInfo, bool lod)
{
  if (lod)
  {
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->Meshes.GetPiece(), 0, 1);
  }
  else
  {
    vtkPVView::SetPiece(inInfo, this, this->Meshes.GetPiece(), 0, 1);
    // Cut by the plane between two ranks, points that lie in it would go to neither.
    vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
    this->UpdateTensorRange(this->GetPoints());
    this->UpdateScaleGuess(this->GetPoints());
    this->CountPointsOfAllRanks(this->GetPoints());
    this->UpdateDataSizes(this->GetPoints());
  }
}

//----------------------------------------------------------------------------
// On all ranks that have data.
void vtkRayTracedGlyphRepresentation::CountPointsOfAllRanks(vtkPolyData* points)
{
  std::vector<double> count{ points ? static_cast<double>(points->GetNumberOfPoints()) : 0.0 };
  if (this->Glyphs.Mask.On)
  {
    rtglyphs::RayTracedRanks::Reduce(count, vtkCommunicator::SUM_OP);
  }
  this->Glyphs.Mask.PointsOfAllRanks = static_cast<vtkIdType>(count[0]);
}

//----------------------------------------------------------------------------
bool vtkRayTracedGlyphRepresentation::NeedsOrderedCompositing()
{
  const bool table = this->TensorTable && this->Glyphs.HasNumberRange() && !this->TensorTable->IsOpaque();
  return table || this->FadesTrails() || this->GlyphShape == UNCERTAIN_VECTOR ||
    !rtglyphs::RayTracedArrays::IsNone(this->Glyphs.OpacityArray) || this->Superclass::NeedsOrderedCompositing();
}

//----------------------------------------------------------------------------
const double* vtkRayTracedGlyphRepresentation::GetDataBounds(vtkPolyData* points)
{
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  settings.TrailSteps = this->GetTrailSteps();
  std::vector<rtglyphs::GlyphSettings> all{ settings };
  if (settings.Shape == rtg::Shape::Mesh)
  {
    all.clear();
    for (const auto& corners : this->Meshes.GetExtents())
    {
      all.push_back(settings);
      all.back().Mesh = corners;
    }
  }
  else if (const std::optional<rtglyphs::GlyphSettings> beside = this->Beside(points, settings))
  {
    all.push_back(*beside);
  }
  return this->GetBoundsOf(points, all);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateTensorRange(vtkPolyData* points)
{
  const rtglyphs::GlyphSettings settings = this->MakeSettings();
  if (settings.HasNumberRange())
  {
    const std::array<double, 2> range = this->NumberRange.Get(points, settings, true);
    std::copy(range.begin(), range.end(), this->TensorRange);
  }
  this->NegativeTensors = this->NumberRange.NegativeFraction(points, settings);
}

//----------------------------------------------------------------------------
// On all ranks that have data; before the first use of the glyphs' size.
void vtkRayTracedGlyphRepresentation::UpdateScaleGuess(vtkPolyData* points)
{
  if (!this->ScaleFactorFromData || this->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  double unitSize = 1.0;
  const rtglyphs::GlyphSettings settings = this->GetSizes(points, unitSize);
  const rtglyphs::GlyphKeptGuess::Result& found =
    rtglyphs::GlyphScaleGuess::Update(this->Guess, points, settings, unitSize, this->GetUpdateTime());
  this->ScaleGuess = { found.Value, found.Limit, found.Limited };
}

//----------------------------------------------------------------------------
// On all ranks that have data; when their glyphs have been chosen.
void vtkRayTracedGlyphRepresentation::UpdateDataSizes(vtkPolyData* points)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  const auto& extents = this->Meshes.GetExtents();
  glm::dvec3 sides(0.0);
  if (!extents.empty() && !extents.front()->positions.empty())
  {
    sides = extents.front()->positions.back() - extents.front()->positions.front();
  }
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  const double highScale = this->HighScale.Get(points, settings, this->Blocks.GetHidden());
  double largest = 0.0;
  if (this->LegendStyle.On)
  {
    settings.Sizing.Split = false; // the magnitudes themselves
    rtglyphs::RayTracedRanks::Together(
      [&]()
      {
        const std::vector<double> magnitudes = rtglyphs::GlyphSample::Magnitudes(points, settings);
        largest = magnitudes.empty() ? 0.0 : *std::max_element(magnitudes.begin(), magnitudes.end());
      });
    largest = rtglyphs::RayTracedRanks::Largest(largest);
  }
  this->DataSizes = { highScale, sides.x, sides.y, largest };
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphDataSizes(
  double highScale, double meshWidth, double meshHeight, double largest)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    this->DataSizes = { highScale, meshWidth, meshHeight, largest };
  }
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings vtkRayTracedGlyphRepresentation::GetSizes(vtkPolyData*, double& unitSize)
{
  const rtglyphs::GlyphSettings settings = this->MakeSettings();
  const glm::dvec3& sides = settings.UnitSize;
  unitSize = settings.Shape == rtg::Shape::Mesh ? this->Meshes.GetLargestSide()
    : settings.Shape == rtg::Shape::Capsule     ? 2.0
                                                : std::max({ sides.x, sides.y, sides.z });
  return settings;
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
// Glyphs that go with others: arrows of the antisymmetric parts of tensors, ellipsoids of uncertain vectors.
std::optional<rtglyphs::GlyphSettings>
vtkRayTracedGlyphRepresentation::Beside(vtkPolyData* points, const rtglyphs::GlyphSettings& settings) const
{
  if (this->GlyphShape == UNCERTAIN_VECTOR)
  {
    return settings.ConfidenceAtTips();
  }
  vtkDataArray* tensors =
    this->TensorAxis && points ? rtglyphs::GlyphTensors::Array(points, settings.Tensors) : nullptr;
  const bool axes = tensors && tensors->GetNumberOfComponents() == 9 && !settings.Tensors.Covariances;
  return axes ? std::optional(settings.AxesOfTensors()) : std::nullopt;
}

//----------------------------------------------------------------------------
// Mesh 0 of a table is drawn by the main mapper, mesh i by layer i - 1. What stands beside the glyphs and
// trails are layers, too.
void vtkRayTracedGlyphRepresentation::Configure(vtkInformation* inInfo, vtkPolyData* points, bool lod, bool collective)
{
  // A selection may come between an update and the delivery.
  if (vtkDataObject* form =
        lod ? vtkPVView::GetDeliveredPieceLOD(inInfo, this, 1) : vtkPVView::GetDeliveredPiece(inInfo, this, 1))
  {
    this->Meshes.Take(form);
  }
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  const bool usesTable = this->Meshes.GetNumberOfMeshes() > 1 && settings.Shape == rtg::Shape::Mesh;
  settings.TableSize = usesTable ? static_cast<int>(this->Meshes.GetNumberOfMeshes()) : 1;
  auto* main = static_cast<vtkRayTracedGlyphMapper*>(this->GetMapper());
  main->SetSettings(settings, this->Meshes.GetMesh(0));
  main->SetTensorTable(this->TensorTable);
  if (settings.HasNumberRange() &&
    (!this->TensorTable || settings.Tensors.Coloring == rtglyphs::GlyphTensors::EIGENVALUES))
  {
    main->SetTensorRange(this->ShownRange.Get(points, settings, collective));
  }
  main->SetSelectionColor(this->GetSelectionColor());
  this->UpdateLegend(settings);
  this->Key->SetColoring(settings.DirectionColoring);

  const std::optional<rtglyphs::GlyphSettings> beside = this->Beside(points, settings);
  const bool trails = this->HasTrails();
  const int tableLayers = settings.TableSize - 1, layers = tableLayers + (beside ? 1 : 0) + (trails ? 1 : 0);
  this->ResizeLayers(this->GetRenderView(), layers);
  for (int i = 0; i < layers; ++i)
  {
    (*this->Layers)[i].Follow(this->Blocks, this->GetActor(), this->GetSelectionColor());
  }
  if (trails)
  {
    vtkRayTracedGlyphMapper* mapper = (*this->Layers)[layers - 1].Mapper;
    mapper->SetSettings(
      settings.Trails(this->GetTrailSteps(), this->NeedsOrderedCompositing()), this->Meshes.GetMesh(0));
    mapper->SetTrailFading(this->TrailFading);
    mapper->SetTensorTable(this->TensorTable);
    mapper->SetTensorRange(main->GetTensorRange());
  }
  for (int entry = 1; entry < settings.TableSize; ++entry)
  {
    settings.TableEntry = entry;
    (*this->Layers)[entry - 1].Mapper->SetSettings(settings, this->Meshes.GetMesh(entry));
  }
  if (beside)
  {
    rtglyphs::GlyphLayers::Layer& layer = (*this->Layers)[tableLayers];
    layer.Mapper->SetSettings(*beside, nullptr);
    vtkProperty* property = layer.Actor->GetProperty();
    if (beside->Tensors.Axes)
    {
      property->SetAmbientColor(this->TensorAxisColor.data());
      property->SetDiffuseColor(this->TensorAxisColor.data());
    }
    else
    {
      property->SetOpacity(ellipsoidOpacity * property->GetOpacity());
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::UpdateLegend(const rtglyphs::GlyphSettings& settings)
{
  this->Legend->SetStyle(this->LegendStyle);
  if (!this->LegendStyle.On)
  {
    return;
  }
  const std::string scales =
    settings.Scaling && !rtglyphs::RayTracedArrays::IsNone(settings.ScaleArray) ? settings.ScaleArray : std::string();
  const std::string name = settings.Tensors.On  ? settings.Tensors.Array
    : settings.Forms.On && !settings.Forms.Each ? settings.Forms.Array
                                                : scales;
  vtkNew<vtkMatrix4x4> matrix;
  this->GetActor()->GetMatrix(matrix);
  const double scale = std::hypot(matrix->GetElement(0, 0), matrix->GetElement(1, 0), matrix->GetElement(2, 0));
  this->Legend->SetGlyphs(settings, scale, name, { this->DataSizes[1], this->DataSizes[2] }, this->DataSizes[3]);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPartBounds(const double bounds[6])
{
  this->Superclass::SetPartBounds(bounds);
  this->Layers->SetKnownBounds(bounds);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::ShowLayers(bool visible)
{
  this->Superclass::ShowLayers(visible);
  this->Layers->SetVisibility(visible);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::ResizeLayers(vtkPVRenderView* view, std::size_t size)
{
  this->Layers->Resize(
    size, [=, this](vtkRayTracedActor* actor, vtkRayTracedMapper* mapper) { this->AddPart(view, actor, mapper); },
    [=, this](vtkRayTracedActor* actor, vtkRayTracedMapper* mapper) { this->RemovePart(view, actor, mapper); });
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::RemoveLayers(vtkPVRenderView* view)
{
  this->ResizeLayers(view, 0);
}

//****************************************************************************
// Properties
//****************************************************************************

//----------------------------------------------------------------------------
// Properties that determine each other are combined here, in any order in which they were set.
rtglyphs::GlyphSettings vtkRayTracedGlyphRepresentation::MakeSettings() const
{
  rtglyphs::GlyphSettings settings = this->Glyphs.InRange();
  settings.Motion = this->GetMotion();
  settings.HighScale = this->DataSizes[0];
  settings.Scaling = this->Scaling && this->ScaleMode != vtkGlyph3DMapper::NO_DATA_SCALING;
  settings.ScaleMode = this->ScaleMode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS ? rtglyphs::GlyphSettings::COMPONENTS
                                                                                : rtglyphs::GlyphSettings::MAGNITUDE;
  if (!this->Scaling)
  {
    settings.ScaleFactor = 1.0; // 3D Glyphs then have their source's own size
  }
  else if (this->ScaleFactorFromData)
  {
    const bool own = this->ScaleGuess[0] > 0.0; // else this process only renders, or there are no glyphs
    settings.ScaleFactor = own ? this->ScaleGuess[0] : settings.ScaleFactor;
    const double limit = own ? this->ScaleGuess[1] : this->SizeLimit;
    double& most = settings.Sizing.Most;
    most = limit > 0.0 && (most == 0.0 || most > limit) ? limit : most;
  }
  // Between the process that has the source and one that renders it is part of what is delivered.
  const rtglyphs::GlyphSource source(this->Meshes.GetMesh(0));
  settings.Arrow = source.Arrow;
  settings.Arrow.fixedHeads = this->FixedHeads;
  settings.Arrow.tipRounding = this->FixedHeads ? settings.Arrow.tipRounding : 0.0f;
  settings.Tensors.On = this->GlyphShape >= TENSOR_ELLIPSOID && this->GlyphShape <= SIGNED_TENSOR_SUPERQUADRIC;
  const bool polynomial = this->GlyphShape >= SPHERICAL_HARMONICS && this->GlyphShape <= FOURTH_ORDER_TENSOR;
  if (!polynomial && settings.Tensors.Coloring == rtglyphs::GlyphTensors::RADIUS)
  {
    settings.Tensors.Coloring = rtglyphs::GlyphTensors::NONE;
  }
  if (this->TensorTable && settings.Tensors.Coloring == rtglyphs::GlyphTensors::SIGN)
  {
    const double* range = this->TensorTable->GetRange();
    this->TensorTable->GetColor(range[1], settings.Tensors.PositiveColor.data());
    this->TensorTable->GetColor(range[0], settings.Tensors.NegativeColor.data());
  }
  settings.DirectionColoring = this->DirectionColoring;
  if (this->DirectionColoring != rtglyphs::DirectionColors::NONE)
  {
    settings.Tensors.Coloring = rtglyphs::GlyphTensors::NONE;
    if (settings.Tensors.On || polynomial || this->GlyphShape == PRINCIPAL_AXES ||
      this->GlyphShape == CONFIDENCE_ELLIPSOID)
    {
      settings.DirectionColoring = rtglyphs::DirectionColors::AXES;
    }
  }
  if (this->GlyphShape == SPLIT_VECTOR)
  {
    return settings.SplitVectors();
  }
  if (this->GlyphShape == UNCERTAIN_VECTOR)
  {
    return settings.Vectors();
  }
  if (this->GlyphShape == CONFIDENCE_ELLIPSOID)
  {
    return settings.ConfidenceEllipsoids();
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
    settings.Shape = this->GlyphShape == CAPSULE ? rtg::Shape::Capsule
      : this->GlyphShape == SUPERQUADRIC         ? rtg::Shape::Superquadric
      : this->GlyphShape == NESTED_SUPERQUADRIC  ? rtg::Shape::NestedSuperquadric
      : this->Meshes.GetNumberOfMeshes() > 1     ? rtg::Shape::Mesh
                                                 : source.Shape;
    settings.UnitSize = this->GlyphShape == GLYPH_TYPE ? source.UnitSize : settings.UnitSize;
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
  const bool known = shape == GLYPH_TYPE || (shape >= SUPERQUADRIC && shape <= SIGNED_TENSOR_SUPERQUADRIC) ||
    (shape >= CAPSULE && shape <= CONFIDENCE_ELLIPSOID);
  if (!known)
  {
    vtkErrorMacro("GlyphShape is " << shape << "; it must be one of 0, 5 to 8 and 10 to 18.");
    return;
  }
  this->GlyphShape = shape;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetScaleFactorFromData(bool on)
{
  this->ScaleFactorFromData = on;
  this->Guess.Forget();
  this->ScaleGuess = {};
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphMode(int mode)
{
  this->Glyphs.Mask.On = mode > 0;
  this->Glyphs.Mask.Mode = std::max(mode - 1, 0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphLegend(int place)
{
  this->LegendStyle.On = place > 0;
  this->LegendStyle.Corner = std::clamp<int>(place - 1, vtkGlyphLegend::LOWER_LEFT, vtkGlyphLegend::UPPER_RIGHT);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphSizeRange(double least, double most)
{
  rtglyphs::GlyphSizing& sizing = this->Glyphs.Sizing;
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
void vtkRayTracedGlyphRepresentation::SetGlyphExponents(double r, double s, double t)
{
  // NaN makes no glyph, as zero does.
  this->Glyphs.Exponents[0] = rtglyphs::RayTracedNumbers::NumberOr(r, 0.0);
  this->Glyphs.Exponents[1] = rtglyphs::RayTracedNumbers::NumberOr(s, 0.0);
  this->Glyphs.Exponents[2] = rtglyphs::RayTracedNumbers::NumberOr(t, 0.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorLookupTable(vtkScalarsToColors* table)
{
  this->TensorTable = table;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetTable(bool sourceIndexing, bool useSourceTableTree)
{
  if (this->SourceIndexing != sourceIndexing || this->UseSourceTableTree != useSourceTableTree)
  {
    this->SourceIndexing = sourceIndexing;
    this->UseSourceTableTree = useSourceTableTree;
    this->MarkModified(); // the meshes must be gathered again
  }
}
