#include "GlyphContent.h"

#include "Finite.h"
#include "GlyphPointGatherer.h"
#include "GlyphSample.h"
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

#include <algorithm>
#include <cmath>
#include <string>

using rtglyphs::GlyphShapes;

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
  return rtglyphs::GlyphPointGatherer::Gather(data, this->Cells, isBlock, wholeExtent, progress);
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
    vtkPolyData* points = this->Common.Blocks.GetPolyData();
    this->UpdateTensorRange(points);
    this->UpdateScaleGuess(points, representation->GetUpdateTime());
    std::vector<double> count{ points ? static_cast<double>(points->GetNumberOfPoints()) : 0.0 };
    if (this->Settings.Mask.On)
    {
      rtglyphs::RayTracedRanks::Reduce(count, vtkCommunicator::SUM_OP);
    }
    this->Settings.Mask.PointsOfAllRanks = static_cast<vtkIdType>(count[0]);
    this->UpdateDataSizes(points);
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphContent::IsTranslucent() const
{
  const std::vector<rtglyphs::GlyphSettings> layers = this->MakeLayers(nullptr);
  const bool table = this->TensorTable && layers.front().HasNumberRange() && !this->TensorTable->IsOpaque();
  return table || !rtglyphs::RayTracedArrays::IsNone(this->Settings.OpacityArray) ||
    std::any_of(layers.begin(), layers.end(),
      [](const rtglyphs::GlyphSettings& layer) { return layer.Opacity < 1.0 || layer.TrailFading > 0.0; });
}

//----------------------------------------------------------------------------
std::vector<rtglyphs::GlyphSettings> rtglyphs::GlyphContent::GetAllSizes(vtkPolyData* points)
{
  std::vector<rtglyphs::GlyphSettings> layers = this->MakeLayers(points);
  const auto& extents = this->Meshes.GetExtents();
  if (layers.front().Shape == rtg::Shape::Mesh && extents.empty())
  {
    return {};
  }
  for (rtglyphs::GlyphSettings& layer : layers)
  {
    if (layer.Shape == rtg::Shape::Mesh)
    {
      layer.Mesh = extents[layer.TableEntry];
      layer.TableSize = 1; // all points count
    }
  }
  return layers;
}

//----------------------------------------------------------------------------
// Points with several glyphs, and those that a mask has chosen, are not reduced.
vtkDataObject* rtglyphs::GlyphContent::Reduce(vtkDataObject* data, const double bounds[6], double resolution)
{
  constexpr double most = 256.0; // cells along the longest side
  vtkPolyData* points = this->Common.Blocks.GetPolyData();
  const std::vector<rtglyphs::GlyphSettings> layers = this->MakeLayers(points);
  rtglyphs::GlyphSettings settings = layers.front();
  const double longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  if (!points || !rtg::IsPositive(longest) || settings.Mask.On || settings.Parts() > 1 || layers.size() > 1)
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
    const std::array<double, 2> range = this->NumberRange.Get(points, settings);
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
// The scale of the arrow whose fixed head has the proportions of the unit arrow: where the settings name no magnitude
// the 95th percentile of all glyphs, so that hardly an arrow has a head that is too large for it. 0: there is none.
double rtglyphs::GlyphContent::ScalePercentile(vtkPolyData* points, const rtglyphs::GlyphSettings& settings)
{
  if (!settings.NeedsScalePercentile())
  {
    this->KnownScales.Forget();
    return 0.0;
  }
  const rtglyphs::GlyphScaling scaling = settings.OfMagnitudes();
  const rtglyphs::RayTracedRanges& hidden = this->Common.Blocks.GetHidden();
  rtglyphs::GlyphArrays::Key key = rtglyphs::GlyphArrays::KeyOf(points, { scaling }, hidden);
  double percentile = this->Common.Summary[rtglyphs::DataSummary::SCALE_PERCENTILE];
  if (rtglyphs::RayTracedRanks::Largest(this->KnownScales.Holds(key) ? 0.0 : 1.0) > 0.0)
  {
    this->KnownScales.Forget();
    this->KnownScales.Update(std::move(key),
      [&]
      {
        using namespace rtglyphs::GlyphSample;
        const std::vector<double> scales = Points(points, scaling, hidden).KeepPositive(ArrowScales(points, scaling));
        percentile = scales.empty() ? 1.0 : Quantile(scales, typicalQuantile);
      });
  }
  return percentile;
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
  Values& summary = this->Common.Summary;
  summary[SCALE_PERCENTILE] = this->ScalePercentile(points, settings);
  double largest = 0.0;
  if (this->Legend->IsOn())
  {
    settings.Frame = settings.Frame == GlyphFrame::Split ? GlyphFrame::Vector : settings.Frame; // magnitudes themselves
    const std::vector<double> magnitudes = rtglyphs::GlyphSample::Magnitudes(points, settings);
    largest = magnitudes.empty() ? 0.0 : *std::max_element(magnitudes.begin(), magnitudes.end());
    largest = rtglyphs::RayTracedRanks::Largest(largest);
  }
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
// The glyphs, and what goes with them: further meshes of a table, layers of the shape, shells, arrows of the
// antisymmetric parts of tensors, trails.
std::vector<rtglyphs::GlyphSettings> rtglyphs::GlyphContent::MakeLayers(vtkPolyData* points) const
{
  std::vector<rtglyphs::GlyphSettings> layers{ this->MakeSettings() };
  const rtglyphs::GlyphSettings glyphs = layers.front();
  for (int entry = 1; entry < glyphs.TableSize; ++entry)
  {
    layers.push_back(glyphs);
    layers.back().TableEntry = entry;
  }
  const std::vector<rtglyphs::GlyphLayer> ofShape = rtglyphs::GlyphLayer::Of(this->GlyphShape);
  for (std::size_t i = 1; i < ofShape.size(); ++i)
  {
    layers.push_back(glyphs.In(ofShape[i]));
  }
  if (!rtglyphs::RayTracedArrays::IsNone(this->ShellArray) && (glyphs.Tensors.On || glyphs.Scaling) &&
    glyphs.Parts() == 1 && !glyphs.IsOfVectors() && glyphs.Shape != rtg::Shape::Mesh)
  {
    layers.push_back(glyphs.Shells(this->ShellArray));
  }
  vtkDataArray* tensors = this->TensorAxis && points ? rtglyphs::GlyphTensors::Array(points, glyphs.Tensors) : nullptr;
  if (tensors && tensors->GetNumberOfComponents() == 9 && !glyphs.Tensors.Covariances)
  {
    layers.push_back(glyphs.In({ rtg::Shape::Arrow, GlyphFrame::Axis }));
  }
  if (this->HasTrails())
  {
    layers.push_back(glyphs.Trails(this->Common.Time.Steps.GetTrailSteps(), this->TrailFading));
  }
  return layers;
}

//----------------------------------------------------------------------------
// Makes or drops layers of the view.
void rtglyphs::GlyphContent::Resize(
  LayerList& layers, std::size_t size, vtkPVDataRepresentation* owner, vtkPVRenderView* view)
{
  for (; layers.size() > size; layers.pop_back())
  {
    this->Common.Parts.Remove(owner, view, layers.back()->Actor, layers.back()->Mapper);
  }
  while (layers.size() < size)
  {
    layers.push_back(std::make_unique<Layer>());
    this->Common.Parts.Add(owner, view, layers.back()->Actor, layers.back()->Mapper);
  }
}

//----------------------------------------------------------------------------
// Takes over blocks, and the main actor's appearance.
void rtglyphs::GlyphContent::Update(Layer& layer, const rtglyphs::RayTracedBlocks& blocks) const
{
  layer.Mapper->SetSelectionColor(this->Common.SelectionColor);
  layer.Mapper->SetBlocks(blocks);
  rtglyphs::RayTracedParts::Copy(this->Common.Parts.Actor, layer.Actor);
}

//----------------------------------------------------------------------------
// The main mapper draws the first layer.
void rtglyphs::GlyphContent::Configure(const Frame& frame)
{
  // A selection may come between an update and the delivery.
  if (vtkDataObject* form = frame.LOD ? vtkPVView::GetDeliveredPieceLOD(frame.Info, frame.Representation, 1)
                                      : vtkPVView::GetDeliveredPiece(frame.Info, frame.Representation, 1))
  {
    this->Meshes.SetDelivered(form);
  }
  std::vector<rtglyphs::GlyphSettings> layers = this->MakeLayers(frame.Points);
  const rtglyphs::GlyphSettings& glyphs = layers.front();
  auto* main = static_cast<vtkRayTracedGlyphMapper*>(this->Common.Parts.Mapper.Get());
  if (glyphs.HasNumberRange() && glyphs.Tensors.Coloring == rtglyphs::GlyphTensors::EIGENVALUES)
  {
    main->SetTensorRange(this->GetTensorRange());
  }
  main->SetSettings(glyphs, this->Meshes.GetMesh(0));
  main->SetTensorTable(this->TensorTable);
  main->SetSelectionColor(this->Common.SelectionColor);
  this->UpdateLegend(glyphs);
  this->Common.Key->SetColoring(glyphs.DirectionColoring);

  this->Resize(this->Layers, layers.size() - 1, frame.Representation, frame.View);
  for (std::size_t i = 1; i < layers.size(); ++i)
  {
    Layer& layer = *this->Layers[i - 1];
    this->Update(layer, this->Common.Blocks);
    layers[i].TrailJoined = layers[i].TrailSteps > 0 && frame.Translucent;
    layer.Mapper->SetSettings(layers[i], this->Meshes.GetMesh(layers[i].TableEntry));
    layer.Mapper->SetTensorTable(this->TensorTable);
    layer.Mapper->SetTensorRange(main->GetTensorRange());
    vtkProperty* property = layer.Actor->GetProperty();
    property->SetOpacity(layers[i].Opacity * property->GetOpacity());
    if (layers[i].Tensors.Axes)
    {
      property->SetColor(0.95, 0.8, 0.2); // TensorAxis
    }
  }
}

//----------------------------------------------------------------------------
// Colors have the range of all data.
void rtglyphs::GlyphContent::ShowReduced(const Frame& frame, bool reduced)
{
  this->Common.Parts.Mapper->SetSuspended(reduced);
  for (const auto& layer : this->Layers)
  {
    layer->Mapper->SetSuspended(reduced);
  }
  if (reduced || frame.Collective) // ranks have the same layers, whichever have enough points
  {
    this->Resize(this->Reduced, 1, frame.Representation, frame.View);
  }
  for (const auto& layer : this->Reduced)
  {
    layer->Mapper->SetSuspended(!reduced);
  }
  if (!reduced)
  {
    return;
  }
  Layer& layer = *this->Reduced[0];
  this->Update(layer, this->Common.Reduced);
  layer.Mapper->SetSettings(rtglyphs::GlyphReduction::SettingsFor(this->MakeSettings()), this->Meshes.GetMesh(0));
  layer.Mapper->SetTensorTable(this->TensorTable);
  layer.Mapper->SetTensorRange(this->GetTensorRange());
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphContent::UpdateLegend(const rtglyphs::GlyphSettings& settings)
{
  using namespace rtglyphs::DataSummary;
  if (!this->Legend->IsOn())
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
  for (const auto* layers : { &this->Layers, &this->Reduced })
  {
    for (const auto& layer : *layers)
    {
      layer->Actor->SetVisibility(visible);
    }
  }
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
  // The source's description is delivered with the mesh to processes that render.
  const rtglyphs::GlyphSource source(this->Meshes.GetMesh(0));
  settings.Arrow = source.Arrow;
  settings.Arrow.fixedHeads = this->FixedHeads;
  settings.Arrow.tipRounding = this->FixedHeads ? settings.Arrow.tipRounding : 0.0f;
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
  settings = settings.In(rtglyphs::GlyphLayer::Of(this->GlyphShape).front());
  if (GlyphShapes::IsTensor(this->GlyphShape))
  {
    settings.Tensors.Kind = static_cast<rtg::TensorGlyphKind>(this->GlyphShape - GlyphShapes::TENSOR_ELLIPSOID);
  }
  else if (polynomial)
  {
    settings.Forms.On = true;
    settings.Forms.Kind = this->GlyphShape - GlyphShapes::SPHERICAL_HARMONICS;
    settings.Forms.Array =
      this->GlyphShape == GlyphShapes::SPHERICAL_HARMONICS ? this->HarmonicsArray : settings.Tensors.Array;
    settings.Forms.Layout = settings.Tensors.Layout;
    settings.Forms.Coloring = settings.Tensors.Coloring;
  }
  else if (this->GlyphShape == GlyphShapes::GLYPH_TYPE)
  {
    const bool table = this->Meshes.GetNumberOfMeshes() > 1;
    settings.Shape = table ? rtg::Shape::Mesh : source.Shape;
    settings.TableSize = table ? static_cast<int>(this->Meshes.GetNumberOfMeshes()) : 1;
    settings.UnitSize = source.UnitSize;
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
