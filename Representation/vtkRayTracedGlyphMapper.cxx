#include "vtkRayTracedGlyphMapper.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedGlyphScene.h"
#include "vtkRayTracedTriangleBuilder.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <tuple>

vtkStandardNewMacro(vtkRayTracedGlyphMapper);

namespace
{
vtkMTimeType TimeOf(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

template <typename Value>
void Mix(std::array<std::uint64_t, 2>& sum, const Value* values, std::size_t count)
{
  const auto* words = reinterpret_cast<const unsigned char*>(values);
  std::size_t bytes = count * sizeof(Value);
  sum[0] ^= bytes;
  while (bytes > 0)
  {
    std::uint64_t word = 0;
    const std::size_t part = std::min(bytes, sizeof(word));
    std::memcpy(&word, words, part);
    words += part;
    bytes -= part;
    sum[0] = (sum[0] ^ word) * 0x9e3779b97f4a7c15ull;
    sum[0] ^= sum[0] >> 32;
    sum[1] = (sum[1] + word) * 0xd1342543de82ef95ull + 1;
    sum[1] ^= sum[1] >> 29;
  }
}

// Of everything in the instances: data that are read or computed again and come out the same are not sent again.
std::array<std::uint64_t, 2> DigestOf(const rtg::GlyphInstances& instances)
{
  std::array<std::uint64_t, 2> sum{ { 1, 2 } };
  const rtg::ArrowForm& arrow = instances.arrow;
  const float numbers[] = { arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding,
    arrow.fixedHeads ? 1.0f : 0.0f, arrow.unitLength, instances.uniformSize,
    static_cast<float>(instances.shape) };
  Mix(sum, numbers, sizeof(numbers) / sizeof(numbers[0]));
  Mix(sum, &instances.origin, 1);
  Mix(sum, &instances.uniformExponents, 1);
  if (const rtg::TriangleMesh* mesh = instances.mesh.get())
  {
    Mix(sum, mesh->positions.data(), mesh->positions.size());
    Mix(sum, mesh->triangles.data(), mesh->triangles.size());
    Mix(sum, mesh->normals.data(), mesh->normals.size());
  }
  Mix(sum, instances.centres.data(), instances.centres.size());
  Mix(sum, instances.sizes3.data(), instances.sizes3.size());
  Mix(sum, instances.sizes1.data(), instances.sizes1.size());
  Mix(sum, instances.rotations.data(), instances.rotations.size());
  Mix(sum, instances.exponents3.data(), instances.exponents3.size());
  Mix(sum, instances.forms.data(), instances.forms.size());
  const rtg::GlyphMotion& motion = instances.motion;
  const float shutter[] = { motion.shutterOpen, motion.shutterClose };
  Mix(sum, shutter, 2);
  Mix(sum, motion.velocities.data(), motion.velocities.size());
  Mix(sum, motion.accelerations.data(), motion.accelerations.size());
  Mix(sum, motion.angularVelocities.data(), motion.angularVelocities.size());
  return sum;
}

bool SameSettings(
  const vtkGlyphInstanceBuilder::Settings& a, const vtkGlyphInstanceBuilder::Settings& b)
{
  const auto all = [](const vtkGlyphInstanceBuilder::Settings& s)
  {
    return std::tie(s.Shape, s.Scaling, s.ScaleArray, s.ScaleMode, s.ScaleFactor, s.Orient,
      s.OrientationArray, s.OrientationMode, s.Arrow.shaftRadius, s.Arrow.tipRadius,
      s.Arrow.tipLength, s.Arrow.tipRounding, s.Arrow.fixedHeads, s.ArrowReference, s.Tensors.On, s.Tensors.Kind,
      s.Tensors.Array, s.Tensors.Layout, s.Tensors.Sharpness, s.Tensors.Axes, s.Exponents[0], s.Exponents[1],
      s.Exponents[2], s.ExponentArray, s.Motion.On, s.Motion.Velocity, s.Motion.FromPreviousStep,
      s.Motion.Acceleration,
      s.Motion.AngularVelocity, s.Motion.ShutterTime, s.Motion.Opening, s.Mask,
      s.MaximumNumberOfGlyphs, s.Seed, s.Mesh, s.TableSize, s.TableEntry, s.TableIndexArray);
  };
  return all(a) == all(b) && a.Tensors.ColorsBySign() == b.Tensors.ColorsBySign();
}
}

//----------------------------------------------------------------------------
// Everything that instances depend on. Arrays are known by their time stamps, of which no two are alike: so data
// that come again in a new vtkPolyData are seen to be the same.
struct vtkRayTracedGlyphMapper::InstanceKey
{
  vtkGlyphInstanceBuilder::Settings Settings;
  std::array<vtkMTimeType, 11> Times{};
  std::vector<vtkMTimeType> FurtherTimes;
  std::vector<unsigned int> HiddenBlocks;
  std::array<double, 16> Matrix{};
  double SharedMeanScale = 0.0; // of all processes, where it matters

  bool operator==(const InstanceKey& other) const
  {
    return SameSettings(this->Settings, other.Settings) && this->Times == other.Times &&
      this->FurtherTimes == other.FurtherTimes && this->HiddenBlocks == other.HiddenBlocks &&
      this->Matrix == other.Matrix && this->SharedMeanScale == other.SharedMeanScale;
  }
};

//----------------------------------------------------------------------------
struct vtkRayTracedGlyphMapper::ColorKey
{
  bool Visible = false;
  std::string Array;
  int ScalarMode = 0, ColorMode = 0;
  std::array<vtkMTimeType, 2> Times{};
  std::uint64_t Points = 0; // grows with each choice of points
  vtkGlyphBlockAttributes::Table Blocks;
  int TensorColoring = 0;
  std::array<double, 3> SolidColor{}; // where blocks without a colour of their own need it

  bool operator==(const ColorKey& other) const
  {
    return this->Visible == other.Visible && this->Array == other.Array &&
      this->ScalarMode == other.ScalarMode && this->ColorMode == other.ColorMode &&
      this->Times == other.Times && this->Points == other.Points && this->Blocks == other.Blocks &&
      this->TensorColoring == other.TensorColoring && this->SolidColor == other.SolidColor;
  }
};

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::vtkRayTracedGlyphMapper() = default;

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::~vtkRayTracedGlyphMapper()
{
  for (const auto& scene : this->Scenes)
  {
    scene->Remove(this);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << endl;
  os << indent << "SamplesPerRender: " << this->SamplesPerRender << endl;
  os << indent << "InteractiveReduction: " << this->InteractiveReduction << endl;
  os << indent << "StepwiseRendering: " << this->StepwiseRendering << endl;
  os << indent << "Number of glyphs: " << this->GetNumberOfGlyphs() << endl;
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
vtkPolyData* vtkRayTracedGlyphMapper::GetPoints()
{
  return this->GetNumberOfInputConnections(0) > 0
    ? vtkPolyData::SafeDownCast(this->GetExecutive()->GetInputData(0, 0))
    : nullptr;
}

//----------------------------------------------------------------------------
std::uint64_t vtkRayTracedGlyphMapper::NewVersion()
{
  static std::uint64_t last = 0;
  return ++last;
}

//----------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkRayTracedGlyphMapper::FurtherTimes(vtkPolyData*) const
{
  return {};
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::SetGlyphMesh(vtkPolyData* mesh)
{
  if (this->Glyphs.Shape != rtg::Shape::Mesh ||
    (this->Glyphs.Mesh && mesh == this->GlyphMesh && TimeOf(mesh) == this->GlyphMeshTime))
  {
    return;
  }
  this->GlyphMesh = mesh;
  this->GlyphMeshTime = TimeOf(mesh);
  auto triangles = std::make_shared<rtg::TriangleMesh>();
  if (mesh)
  {
    *triangles = vtkRayTracedTriangleBuilder::BuildInPlace(mesh).Mesh;
  }
  this->Glyphs.Mesh = std::move(triangles);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::Report(
  const std::vector<std::string>& messages, std::vector<std::string>& reported)
{
  for (const std::string& message : messages)
  {
    if (std::find(reported.begin(), reported.end(), message) == reported.end())
    {
      vtkWarningMacro(<< message);
    }
  }
  reported = messages;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::UpdateBlocks(vtkPolyData* points)
{
  if (this->BlockTableTime < this->BlocksTime || this->BlockTableTime < points->GetMTime() ||
    this->BlockTableTime < this->GetMTime())
  {
    this->BlockTable = this->Blocks.Resolve(points);
    this->BlockTableTime.Modified();
  }
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::InstanceKey
vtkRayTracedGlyphMapper::MakeInstanceKey(vtkPolyData* points) const
{
  InstanceKey key;
  key.Settings = this->Glyphs;
  const std::array<vtkDataArray*, 3> motion = vtkGlyphMotion::Arrays(points, this->Glyphs.Motion);
  key.Times = { TimeOf(points->GetPoints()),
    points->GetPoints() ? TimeOf(points->GetPoints()->GetData()) : 0,
    TimeOf(vtkGlyphInstanceBuilder::ScaleArray(points, this->Glyphs)),
    TimeOf(vtkGlyphInstanceBuilder::OrientationArray(points, this->Glyphs)),
    TimeOf(points->GetPointData()->GetArray(vtkGlyphPointGatherer::CompositeIndexName())),
    TimeOf(vtkGlyphTensors::Array(points, this->Glyphs.Tensors)),
    TimeOf(vtkGlyphInstanceBuilder::ExponentArray(points, this->Glyphs)), TimeOf(motion[0]),
    TimeOf(motion[1]), TimeOf(motion[2]), TimeOf(vtkGlyphInstanceBuilder::TableIndexArray(points, this->Glyphs)) };
  key.FurtherTimes = this->FurtherTimes(points);
  if (vtkGlyphInstanceBuilder::NeedsMeanScale(this->Glyphs))
  {
    key.SharedMeanScale = vtkGlyphInstanceBuilder::SharedMeanScale(points);
  }
  for (const auto& item : this->BlockTable)
  {
    if (!item.second.Visible)
    {
      key.HiddenBlocks.push_back(item.first);
    }
  }
  std::sort(key.HiddenBlocks.begin(), key.HiddenBlocks.end());
  return key;
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::ColorKey
vtkRayTracedGlyphMapper::MakeColorKey(vtkPolyData* points, vtkActor* actor)
{
  ColorKey key;
  key.Points = this->PointsVersion;
  key.Blocks = this->BlockTable;
  key.Visible = this->ScalarVisibility != 0;
  key.TensorColoring = this->Glyphs.Tensors.On ? this->Glyphs.Tensors.Coloring : 0;
  if (key.TensorColoring != vtkGlyphTensors::NONE)
  {
    key.Times[1] = TimeOf(this->LookupTable);
  }
  if (!key.Blocks.empty())
  {
    actor->GetProperty()->GetDiffuseColor(key.SolidColor.data());
  }
  if (key.Visible)
  {
    int cellFlag = 0;
    vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
      points, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
    key.Array = this->ArrayName;
    key.ScalarMode = this->ScalarMode;
    key.ColorMode = this->ColorMode;
    key.Times = { TimeOf(scalars), TimeOf(this->LookupTable) };
  }
  return key;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::Update(vtkActor* actor)
{
  vtkPolyData* points = this->GetPoints();
  if (!points)
  {
    if (!this->Points.empty())
    {
      this->Instances = rtg::GlyphInstances();
      this->Points.clear();
      this->Skipped = 0;
      this->InstancesTaken = false;
      this->Built.reset();
      this->InstanceVersion = 0;
    }
    return;
  }

  this->UpdateBlocks(points);
  InstanceKey key = this->MakeInstanceKey(points);
  std::copy_n(&actor->GetMatrix()->Element[0][0], 16, key.Matrix.begin());
  if (!this->Built || !(*this->Built == key))
  {
    this->BuildInstances(points, actor);
    this->Built = std::make_unique<InstanceKey>(std::move(key));
  }
  ColorKey colorKey = this->MakeColorKey(points, actor);
  if (!this->Colored || !(*this->Colored == colorKey))
  {
    this->SolidColor = colorKey.SolidColor;
    this->BuildColors(points);
    this->Colored = std::make_unique<ColorKey>(std::move(colorKey));
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::BuildInstances(vtkPolyData* points, vtkActor* actor)
{
  vtkGlyphInstanceBuilder::Result result = points->GetNumberOfPoints() > 0
    ? vtkGlyphInstanceBuilder::Build(points, this->Glyphs, this->BlockTable, actor->GetMatrix())
    : vtkGlyphInstanceBuilder::Result();
  this->Instances = std::move(result.Instances);
  this->InstancesTaken = false;
  this->Points = std::move(result.Points);
  ++this->PointsVersion;
  this->Skipped = result.Skipped;
  const std::array<std::uint64_t, 2> digest = DigestOf(this->Instances);
  if (this->InstanceVersion == 0 || this->Digest != digest)
  {
    this->Digest = digest;
    this->InstanceVersion = NewVersion();
  }
  // Axes go with tensor glyphs, which have told what is wrong with the points.
  if (!this->Glyphs.Tensors.Axes)
  {
    this->Report(result.Messages, this->ReportedInstances);
  }
}

//----------------------------------------------------------------------------
rtg::GlyphInstances vtkRayTracedGlyphMapper::TakeInstances(vtkActor* actor)
{
  if (this->InstancesTaken)
  {
    if (vtkPolyData* points = this->GetPoints())
    {
      this->BuildInstances(points, actor);
    }
  }
  this->InstancesTaken = true;
  return std::move(this->Instances);
}

//----------------------------------------------------------------------------
// Numbers go through the representation's colour map when it has one, else from blue over white to red.
void vtkRayTracedGlyphMapper::TensorColor(
  const vtkGlyphTensors& tensors, vtkIdType point, double rgb[3])
{
  if (this->Glyphs.Tensors.Coloring == vtkGlyphTensors::PRINCIPAL_DIRECTION)
  {
    tensors.DirectionColor(point, rgb);
    return;
  }
  double value = 0.0;
  if (!tensors.Number(point, value))
  {
    return;
  }
  if (vtkScalarsToColors* map = this->LookupTable)
  {
    const unsigned char* color = map->MapValue(value);
    std::transform(color, color + 3, rgb, [](unsigned char c) { return c / 255.0; });
    return;
  }
  const double range = tensors.NumberRange();
  const double share = range > 0.0 ? vtkMath::ClampValue(value / range, -1.0, 1.0) : 0.0;
  const double pale = 1.0 - std::abs(share);
  rgb[0] = share > 0.0 ? 0.7 + 0.25 * pale : 0.23 + 0.72 * pale;
  rgb[1] = share > 0.0 ? 0.02 + 0.93 * pale : 0.3 + 0.65 * pale;
  rgb[2] = share > 0.0 ? 0.15 + 0.8 * pale : 0.75 + 0.2 * pale;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::BuildColors(vtkPolyData* points)
{
  std::vector<std::string> messages;
  vtkUnsignedCharArray* mapped = nullptr;
  std::unique_ptr<vtkGlyphTensors> tensors;
  const vtkGlyphTensors::Settings& shown = this->Glyphs.Tensors;
  const bool bySign = shown.ColorsBySign();
  if (shown.On && !shown.Axes && !bySign && shown.Coloring != vtkGlyphTensors::NONE && !this->Points.empty())
  {
    tensors = std::make_unique<vtkGlyphTensors>(
      vtkGlyphTensors::Array(points, this->Glyphs.Tensors), this->Glyphs.Tensors, this->Points);
    if (this->LookupTable)
    {
      this->LookupTable->Build();
    }
  }
  else if (this->ScalarVisibility && !bySign && !this->Points.empty())
  {
    mapped = this->MapScalars(points, 1.0);
    if (!mapped)
    {
      messages.push_back("There is no array '" + std::string(this->ArrayName) +
        "' that has a value for each glyph, so the glyphs have one colour. Choose a point array, "
        "or cell data of "
        "vertices, as ColorArrayName.");
    }
  }
  auto* blockIds = vtkUnsignedIntArray::SafeDownCast(
    points->GetPointData()->GetArray(vtkGlyphPointGatherer::CompositeIndexName()));
  const bool blockColors = blockIds &&
    std::any_of(this->BlockTable.begin(), this->BlockTable.end(),
      [](const auto& item) { return item.second.HasColor || item.second.Opacity < 1.0; });

  rtg::GlyphColours colors;
  this->Translucent = false;
  if (mapped || tensors || blockColors)
  {
    colors.resize(this->Points.size());
    const int components = mapped ? mapped->GetNumberOfComponents() : 0;
    for (std::size_t glyph = 0; glyph < this->Points.size(); ++glyph)
    {
      const vtkIdType point = this->Points[glyph];
      std::array<double, 4> rgba{ { this->SolidColor[0], this->SolidColor[1], this->SolidColor[2],
        1.0 } };
      for (int c = 0; c < std::min(components, 4); ++c)
      {
        rgba[c] = mapped->GetValue(point * components + c) / 255.0;
      }
      if (tensors)
      {
        this->TensorColor(*tensors, point, rgba.data());
      }
      if (blockColors)
      {
        const auto block = this->BlockTable.find(blockIds->GetValue(point));
        if (block != this->BlockTable.end())
        {
          if (block->second.HasColor && !shown.Axes)
          {
            std::copy(block->second.Color.begin(), block->second.Color.end(), rgba.begin());
          }
          rgba[3] *= block->second.Opacity;
        }
      }
      std::uint32_t packed = 0;
      for (int c = 0; c < 4; ++c)
      {
        packed |=
          static_cast<std::uint32_t>(std::lround(vtkMath::ClampValue(rgba[c], 0.0, 1.0) * 255.0))
          << (8 * c);
      }
      this->Translucent |= (packed >> 24) != 255u;
      colors[glyph] = packed;
    }
  }
  if (this->ColorVersion == 0 || this->Colors8 != colors)
  {
    this->Colors8 = std::move(colors);
    this->ColorVersion = NewVersion();
  }
  this->Report(messages, this->ReportedColors);
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphMapper::Origin vtkRayTracedGlyphMapper::OriginOf(vtkIdType glyph)
{
  Origin origin;
  vtkPolyData* points = this->GetPoints();
  if (!points || glyph < 0 || glyph >= this->GetNumberOfGlyphs())
  {
    return origin;
  }
  const vtkIdType point = this->Points[glyph];
  vtkPointData* data = points->GetPointData();
  vtkDataArray* ids = data->GetArray(vtkGlyphPointGatherer::PointIdsName());
  vtkDataArray* blocks = data->GetArray(vtkGlyphPointGatherer::CompositeIndexName());
  vtkDataArray* processes = data->GetArray(vtkGlyphPointGatherer::ProcessIdName());
  origin.Id = ids ? static_cast<vtkIdType>(ids->GetComponent(point, 0)) : point;
  origin.CompositeIndex = blocks ? static_cast<unsigned int>(blocks->GetComponent(point, 0)) : 0;
  origin.Process = processes ? static_cast<int>(processes->GetComponent(point, 0)) : -1;
  return origin;
}

//----------------------------------------------------------------------------
double* vtkRayTracedGlyphMapper::GetBounds()
{
  vtkPolyData* points = this->GetPoints();
  if (!points || points->GetNumberOfPoints() == 0)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    this->Bounded.reset();
    return this->Bounds;
  }
  this->UpdateBlocks(points);
  InstanceKey key = this->MakeInstanceKey(points);
  if (!this->Bounded || !(*this->Bounded == key))
  {
    vtkGlyphInstanceBuilder::ComputeBounds(points, this->Glyphs, this->BlockTable, this->Bounds);
    this->Bounded = std::make_unique<InstanceKey>(std::move(key));
  }
  return this->Bounds;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::Join(vtkRenderer* renderer)
{
  vtkSmartPointer<vtkRayTracedGlyphScene> scene = vtkRayTracedGlyphScene::Of(renderer);
  if (std::find(this->Scenes.begin(), this->Scenes.end(), scene) == this->Scenes.end())
  {
    this->Scenes.push_back(scene);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::Leave(vtkRenderer* renderer)
{
  const auto left = std::remove_if(this->Scenes.begin(), this->Scenes.end(),
    [this, renderer](const auto& scene)
    {
      if (scene->GetRenderer() && scene->GetRenderer() != renderer)
      {
        return false;
      }
      scene->Remove(this);
      return true;
    });
  this->Scenes.erase(left, this->Scenes.end());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  this->Join(renderer);
  vtkRayTracedGlyphScene::Of(renderer)->Render(actor, this);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& scene : this->Scenes)
  {
    scene->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
std::string vtkRayTracedGlyphMapper::GetStatistics()
{
  return this->Scenes.empty() ? std::string("{}") : this->Scenes.front()->GetStatistics(this);
}

//----------------------------------------------------------------------------
std::string vtkRayTracedGlyphMapper::GetDeviceName()
{
  return this->Scenes.empty() ? std::string() : this->Scenes.front()->GetDeviceName();
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphMapper::GetAccumulatedSamples()
{
  return this->Scenes.empty() ? 0 : this->Scenes.front()->GetAccumulatedSamples();
}
