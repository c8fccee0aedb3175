#include "GlyphContent.h"

#include "Finite.h"
#include "GlyphPointGatherer.h"
#include "GlyphSample.h"
#include "RayTracedNumbers.h"
#include "RayTracedRanks.h"
#include "GlyphScaleGuess.h"
#include "GlyphSource.h"
#include "GlyphTuples.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedGlyphMapper.h"

#include <algorithm>
#include <cmath>
#include <string>

using rtglyphs::GlyphShapes;

namespace
{
constexpr double besideOpacity = 0.4; // of what surrounds glyphs, which are seen through it
}

//****************************************************************************
// The data side
//****************************************************************************

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::GatherMeshes(vtkDataObject* source, vtkAlgorithm* from)
{
  this->Meshes.Gather(source, this->SourceIndexing && this->UseSourceTableTree);
  if (source && this->Meshes.GetMesh(0))
  {
    rtglyphs::GlyphSource(from).StoreIn(this->Meshes.GetMesh(0));
  }
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> rtglyphs::GlyphContent::Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
  const rtglyphs::RayTracedParallel::Progress& progress) const
{
  rtglyphs::GlyphPointGatherer::Options options;
  options.CellCenters = this->Cells;
  options.IsBlock = isBlock;
  options.WholeExtent = wholeExtent;
  options.Progress = progress;
  return rtglyphs::GlyphPointGatherer::Gather(data, options);
}

//----------------------------------------------------------------------------
std::vector<std::string> rtglyphs::GlyphContent::Arrays() const
{
  const rtglyphs::GlyphSettings settings = this->MakeSettings();
  return { settings.ScaleArray, settings.OrientationArray, settings.ExponentArray, settings.Tensors.Array,
    settings.Forms.Array, this->ShellArray };
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::Deliver(vtkInformation* info, vtkPVDataRepresentation* representation, bool lod)
{
  if (lod)
  {
    vtkPVRenderView::SetPieceLOD(info, representation, this->Meshes.GetPiece(), 0, 1);
  }
  else
  {
    vtkPVView::SetPiece(info, representation, this->Meshes.GetPiece(), 0, 1);
    // Cut by the plane between two ranks, points that lie in it would go to neither.
    vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(info, representation);
    vtkPolyData* points = this->Common.Blocks.GetPoints();
    this->UpdateTensorRange(points);
    this->UpdateScaleGuess(points, representation->GetUpdateTime());
    this->CountPointsOfAllRanks(points);
    this->UpdateDataSizes(points);
  }
}

//----------------------------------------------------------------------------
// On all ranks that have data.
void rtglyphs::GlyphContent::CountPointsOfAllRanks(vtkPolyData* points)
{
  std::vector<double> count{ points ? static_cast<double>(points->GetNumberOfPoints()) : 0.0 };
  if (this->Settings.Mask.On)
  {
    rtglyphs::RayTracedRanks::Reduce(count, vtkCommunicator::SUM_OP);
  }
  this->Settings.Mask.PointsOfAllRanks = static_cast<vtkIdType>(count[0]);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphContent::IsTranslucent() const
{
  const bool table = this->TensorTable && this->Settings.HasNumberRange() && !this->TensorTable->IsOpaque();
  return table || this->FadesTrails() || GlyphShapes::IsUncertain(this->GlyphShape) ||
    this->HasShells(this->MakeSettings()) || !rtglyphs::RayTracedArrays::IsNone(this->Settings.OpacityArray);
}

//----------------------------------------------------------------------------
std::vector<rtglyphs::GlyphSettings> rtglyphs::GlyphContent::GetAllSizes(vtkPolyData* points)
{
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  settings.TrailSteps = this->Common.Time.GetTrailSteps();
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
  else
  {
    const std::vector<rtglyphs::GlyphSettings> beside = this->Beside(points, settings);
    all.insert(all.end(), beside.begin(), beside.end());
  }
  return all;
}

//----------------------------------------------------------------------------
// Not where points have more than one glyph, or are chosen anyway.
vtkDataObject* rtglyphs::GlyphContent::Reduce(vtkDataObject* data, const double bounds[6], double resolution)
{
  constexpr double most = 256.0; // cells along the longest side
  vtkPolyData* points = this->Common.Blocks.GetPoints();
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  const double longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  if (!points || !rtg::IsPositive(longest) || this->HasTrails() || settings.Mask.On || settings.OfVectors ||
    settings.Parts() > 1 || this->Meshes.GetNumberOfMeshes() > 1 || !this->Beside(points, settings).empty())
  {
    return nullptr;
  }
  if (settings.Shape == rtg::Shape::Mesh && this->Meshes.GetMesh(0))
  {
    settings.Mesh = this->Meshes.GetExtents().front();
  }
  return this->Reduction.Get(data, this->Common.Blocks, settings, longest / std::max(most * resolution, 8.0));
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::UpdateTensorRange(vtkPolyData* points)
{
  using namespace rtglyphs::DataSummary;
  const rtglyphs::GlyphSettings settings = this->MakeSettings();
  if (settings.HasNumberRange())
  {
    const std::array<double, 2> range = this->NumberRange.Get(points, settings, true);
    std::copy(range.begin(), range.end(), &this->Common.Summary[LEAST_OF_TENSORS]);
  }
  this->Common.Summary[NEGATIVE_TENSORS] = this->NumberRange.NegativeFraction(points, settings);
}

//----------------------------------------------------------------------------
// On all ranks that have data; before the first use of the glyphs' size.
void rtglyphs::GlyphContent::UpdateScaleGuess(vtkPolyData* points, double time)
{
  using namespace rtglyphs::DataSummary;
  if (!this->ScaleFactorFromData || !this->Common.HasData)
  {
    return;
  }
  double unitSize = 1.0;
  const rtglyphs::GlyphSettings settings = this->GetSizes(points, unitSize);
  const rtglyphs::GlyphKeptGuess::Result& found =
    rtglyphs::GlyphScaleGuess::Update(this->Guess, points, settings, unitSize, time);
  Values& summary = this->Common.Summary;
  summary[SCALE_FACTOR] = found.Value;
  summary[SIZE_LIMIT] = found.Limit;
  summary[LIMITED_FRACTION] = found.Limited;
}

//----------------------------------------------------------------------------
// On all ranks that have data; when their glyphs have been chosen.
void rtglyphs::GlyphContent::UpdateDataSizes(vtkPolyData* points)
{
  using namespace rtglyphs::DataSummary;
  if (!this->Common.HasData)
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
  const double scalePercentile = this->ScalePercentile.Get(points, settings, this->Common.Blocks.GetHidden());
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
  Values& summary = this->Common.Summary;
  summary[SCALE_PERCENTILE] = scalePercentile;
  summary[MESH_WIDTH] = sides.x;
  summary[MESH_HEIGHT] = sides.y;
  summary[LARGEST_MAGNITUDE] = largest;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphContent::GetSizes(vtkPolyData*, double& unitSize)
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
vtkSmartPointer<vtkRayTracedMapper> rtglyphs::GlyphContent::MakeMapper() const
{
  return vtkSmartPointer<vtkRayTracedGlyphMapper>::New();
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphContent::HasShells(const rtglyphs::GlyphSettings& settings) const
{
  return !rtglyphs::RayTracedArrays::IsNone(this->ShellArray) && (settings.Tensors.On || settings.Scaling) &&
    settings.Parts() == 1 && !settings.OfVectors && settings.Shape != rtg::Shape::Mesh;
}

//----------------------------------------------------------------------------
// Glyphs that go with others: what surrounds them, arrows of the antisymmetric parts of tensors.
std::vector<rtglyphs::GlyphSettings>
rtglyphs::GlyphContent::Beside(vtkPolyData* points, const rtglyphs::GlyphSettings& settings) const
{
  std::vector<rtglyphs::GlyphSettings> beside;
  if (GlyphShapes::IsUncertain(this->GlyphShape))
  {
    beside.push_back(settings.ConfidenceAtTips(this->GlyphShape == GlyphShapes::UNCERTAIN_DIRECTION));
  }
  if (this->HasShells(settings))
  {
    beside.push_back(settings.Shells(this->ShellArray));
  }
  vtkDataArray* tensors =
    this->TensorAxis && points ? rtglyphs::GlyphTensors::Array(points, settings.Tensors) : nullptr;
  if (tensors && tensors->GetNumberOfComponents() == 9 && !settings.Tensors.Covariances)
  {
    beside.push_back(settings.AxesOfTensors());
  }
  return beside;
}

//----------------------------------------------------------------------------
// Mesh 0 of a table is drawn by the main mapper, mesh i by layer i - 1. What stands beside the glyphs and
// trails are layers, too.
void rtglyphs::GlyphContent::Configure(const Frame& frame)
{
  // A selection may come between an update and the delivery.
  if (vtkDataObject* form = frame.LOD ? vtkPVView::GetDeliveredPieceLOD(frame.Info, frame.Representation, 1)
                                      : vtkPVView::GetDeliveredPiece(frame.Info, frame.Representation, 1))
  {
    this->Meshes.Take(form);
  }
  rtglyphs::GlyphSettings settings = this->MakeSettings();
  const bool usesTable = this->Meshes.GetNumberOfMeshes() > 1 && settings.Shape == rtg::Shape::Mesh;
  settings.TableSize = usesTable ? static_cast<int>(this->Meshes.GetNumberOfMeshes()) : 1;
  auto* main = static_cast<vtkRayTracedGlyphMapper*>(this->Common.Parts.Mapper.Get());
  main->SetSettings(settings, this->Meshes.GetMesh(0));
  main->SetTensorTable(this->TensorTable);
  if (settings.HasNumberRange() && settings.Tensors.Coloring == rtglyphs::GlyphTensors::EIGENVALUES)
  {
    main->SetTensorRange(this->ShownRange.Get(frame.Points, settings, frame.Collective));
  }
  main->SetSelectionColor(this->Common.SelectionColor);
  this->UpdateLegend(settings);
  this->Common.Key->SetColoring(settings.DirectionColoring);

  const std::vector<rtglyphs::GlyphSettings> beside = this->Beside(frame.Points, settings);
  const bool trails = this->HasTrails();
  const int tableLayers = settings.TableSize - 1,
            layers = tableLayers + static_cast<int>(beside.size()) + (trails ? 1 : 0);
  this->ResizeLayers(this->Layers, frame.Representation, frame.View, layers);
  for (int i = 0; i < layers; ++i)
  {
    this->Layers[i].Follow(this->Common.Blocks, this->Common.Parts.Actor, this->Common.SelectionColor);
  }
  if (trails)
  {
    vtkRayTracedGlyphMapper* mapper = this->Layers[layers - 1].Mapper;
    mapper->SetSettings(settings.Trails(this->Common.Time.GetTrailSteps(), frame.Translucent), this->Meshes.GetMesh(0));
    mapper->SetTrailFading(this->TrailFading);
    mapper->SetTensorTable(this->TensorTable);
    mapper->SetTensorRange(main->GetTensorRange());
  }
  for (int entry = 1; entry < settings.TableSize; ++entry)
  {
    settings.TableEntry = entry;
    this->Layers[entry - 1].Mapper->SetSettings(settings, this->Meshes.GetMesh(entry));
  }
  for (std::size_t i = 0; i < beside.size(); ++i)
  {
    rtglyphs::GlyphLayers::Layer& layer = this->Layers[tableLayers + i];
    layer.Mapper->SetSettings(beside[i], nullptr);
    vtkProperty* property = layer.Actor->GetProperty();
    if (beside[i].Tensors.Axes)
    {
      property->SetColor(0.95, 0.8, 0.2); // TensorAxis
    }
    else
    {
      layer.Mapper->SetTensorTable(this->TensorTable);
      layer.Mapper->SetTensorRange(main->GetTensorRange());
      property->SetOpacity(besideOpacity * property->GetOpacity());
    }
  }
}

//----------------------------------------------------------------------------
// Colors have the range of all data.
void rtglyphs::GlyphContent::ShowReduced(const Frame& frame, bool reduced)
{
  this->Common.Parts.Mapper->SetAside(reduced);
  this->Layers.SetAside(reduced);
  if (reduced || frame.Collective) // ranks have the same layers, whichever have enough points
  {
    this->ResizeLayers(this->Reduced, frame.Representation, frame.View, 1);
  }
  this->Reduced.SetAside(!reduced);
  if (!reduced)
  {
    return;
  }
  rtglyphs::GlyphLayers::Layer& layer = this->Reduced[0];
  layer.Follow(this->Common.Reduced, this->Common.Parts.Actor, this->Common.SelectionColor);
  layer.Mapper->SetSettings(rtglyphs::GlyphReduction::SettingsFor(this->MakeSettings()), this->Meshes.GetMesh(0));
  layer.Mapper->SetTensorTable(this->TensorTable);
  const double* range = &this->Common.Summary[rtglyphs::DataSummary::LEAST_OF_TENSORS];
  layer.Mapper->SetTensorRange({ range[0], range[1] });
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::UpdateLegend(const rtglyphs::GlyphSettings& settings)
{
  using namespace rtglyphs::DataSummary;
  this->Legend->SetStyle(this->LegendStyle);
  if (!this->LegendStyle.On)
  {
    return;
  }
  const std::string scales =
    settings.Scaling && !rtglyphs::RayTracedArrays::IsNone(settings.ScaleArray) ? settings.ScaleArray : std::string();
  const std::string name = settings.Tensors.On ? settings.Tensors.Array
    : settings.Forms.On                        ? settings.Forms.Array
                                               : scales;
  const Values& summary = this->Common.Summary;
  vtkNew<vtkMatrix4x4> matrix;
  this->Common.Parts.Actor->GetMatrix(matrix);
  const double scale = std::hypot(matrix->GetElement(0, 0), matrix->GetElement(1, 0), matrix->GetElement(2, 0));
  this->Legend->SetGlyphs(
    settings, scale, name, { summary[MESH_WIDTH], summary[MESH_HEIGHT] }, summary[LARGEST_MAGNITUDE]);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::Show(bool visible)
{
  this->RayTracedContent::Show(visible);
  this->Legend->SetVisibility(visible);
  this->Layers.SetVisibility(visible);
  this->Reduced.SetVisibility(visible);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::ResizeLayers(
  rtglyphs::GlyphLayers& layers, vtkPVDataRepresentation* representation, vtkPVRenderView* view, std::size_t size)
{
  rtglyphs::RayTracedParts& parts = this->Common.Parts;
  layers.Resize(
    size,
    [=, &parts](vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
    { parts.Add(representation, view, actor, mapper); },
    [=, &parts](vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
    { parts.Remove(representation, view, actor, mapper); });
}

//****************************************************************************
// Properties
//****************************************************************************

//----------------------------------------------------------------------------
// Properties that determine each other are combined here, in any order in which they were set.
rtglyphs::GlyphSettings rtglyphs::GlyphContent::MakeSettings() const
{
  using namespace rtglyphs::DataSummary;
  rtglyphs::GlyphSettings settings = this->Settings.InRange();
  settings.Motion = this->Common.Time.GetMotion();
  const Values& summary = this->Common.Summary;
  settings.ScalePercentile = summary[SCALE_PERCENTILE];
  settings.Scaling = this->Scaling && this->ScaleMode != vtkGlyph3DMapper::NO_DATA_SCALING;
  settings.ScaleMode = this->ScaleMode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS ? rtglyphs::GlyphSettings::COMPONENTS
                                                                                : rtglyphs::GlyphSettings::MAGNITUDE;
  if (!this->Scaling)
  {
    settings.ScaleFactor = 1.0; // 3D Glyphs then have their source's own size
  }
  else if (this->ScaleFactorFromData)
  {
    settings.ScaleFactor = summary[SCALE_FACTOR] > 0.0 ? summary[SCALE_FACTOR] : settings.ScaleFactor;
    const double limit = summary[SIZE_LIMIT];
    double& most = settings.Sizing.Most;
    most = limit > 0.0 && (most == 0.0 || most > limit) ? limit : most;
  }
  // Between the process that has the source and one that renders it is part of what is delivered.
  const rtglyphs::GlyphSource source(this->Meshes.GetMesh(0));
  settings.Arrow = source.Arrow;
  settings.Arrow.fixedHeads = this->FixedHeads;
  settings.Arrow.tipRounding = this->FixedHeads ? settings.Arrow.tipRounding : 0.0f;
  settings.Tensors.On = GlyphShapes::IsTensor(this->GlyphShape);
  const bool polynomial = GlyphShapes::IsPolynomial(this->GlyphShape);
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
  settings.DirectionColoring = this->Common.DirectionColoring;
  if (this->Common.DirectionColoring != rtglyphs::DirectionColors::NONE)
  {
    settings.Tensors.Coloring = rtglyphs::GlyphTensors::NONE;
    if (GlyphShapes::IsColored(this->GlyphShape))
    {
      settings.DirectionColoring = rtglyphs::DirectionColors::AXES;
    }
  }
  if (this->GlyphShape == GlyphShapes::SPLIT_VECTOR)
  {
    return settings.SplitVectors();
  }
  if (GlyphShapes::IsUncertain(this->GlyphShape))
  {
    return settings.Vectors();
  }
  if (this->GlyphShape == GlyphShapes::CONFIDENCE_ELLIPSOID)
  {
    return settings.ConfidenceEllipsoids();
  }
  if (this->GlyphShape == GlyphShapes::PRINCIPAL_AXES)
  {
    return settings.PrincipalAxes();
  }
  if (settings.Tensors.On)
  {
    settings.Tensors.Kind = static_cast<rtg::TensorGlyphKind>(this->GlyphShape - GlyphShapes::TENSOR_ELLIPSOID);
    settings.Shape =
      this->GlyphShape == GlyphShapes::TENSOR_ELLIPSOID ? rtg::Shape::Sphere : rtg::Shape::NestedSuperquadric;
  }
  else if (polynomial)
  {
    settings.Shape = rtg::Shape::Polynomial;
    settings.Forms.On = true;
    settings.Forms.Kind = this->GlyphShape - GlyphShapes::SPHERICAL_HARMONICS;
    settings.Forms.Array =
      this->GlyphShape == GlyphShapes::SPHERICAL_HARMONICS ? this->HarmonicsArray : settings.Tensors.Array;
    settings.Forms.Layout = settings.Tensors.Layout;
    settings.Forms.Coloring = settings.Tensors.Coloring;
  }
  else
  {
    settings.Shape = this->GlyphShape == GlyphShapes::CAPSULE ? rtg::Shape::Capsule
      : this->GlyphShape == GlyphShapes::SUPERQUADRIC         ? rtg::Shape::Superquadric
      : this->GlyphShape == GlyphShapes::NESTED_SUPERQUADRIC  ? rtg::Shape::NestedSuperquadric
      : this->Meshes.GetNumberOfMeshes() > 1                  ? rtg::Shape::Mesh
                                                              : source.Shape;
    settings.UnitSize = this->GlyphShape == GlyphShapes::GLYPH_TYPE ? source.UnitSize : settings.UnitSize;
  }
  return settings;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::SetMode(int mode)
{
  this->Settings.Mask.On = mode > 0;
  this->Settings.Mask.Mode = std::max(mode - 1, 0);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::SetLegend(int place)
{
  this->LegendStyle.On = place > 0;
  this->LegendStyle.Corner = std::clamp<int>(place - 1, vtkGlyphLegend::LOWER_LEFT, vtkGlyphLegend::UPPER_RIGHT);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::SetExponents(const std::array<double, 3>& exponents)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Settings.Exponents[i] =
      rtglyphs::RayTracedNumbers::NumberOr(exponents[i], 0.0); // NaN makes no glyph, as zero does
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::SetScaleFactorFromData(bool on)
{
  using namespace rtglyphs::DataSummary;
  this->ScaleFactorFromData = on;
  this->Guess.Forget();
  if (this->Common.HasData) // else the client would not send the same again
  {
    std::fill_n(&this->Common.Summary[SCALE_FACTOR], LIMITED_FRACTION + 1, 0.0);
  }
}
