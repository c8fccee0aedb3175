#include "vtkRayTracedMapper.h"

#include "Stopwatch.h"
#include "TriangleMesh.h"
#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedArrays.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// The largest length of the glyphs, or of the mesh that they are copies of.
double LargestSize(const rtg::GlyphInstances& glyphs)
{
  const auto lengthOf = [](const auto& size)
  {
    const glm::dvec3 lengths(glm::abs(glm::dvec3(size)));
    return std::max({ lengths.x, lengths.y, lengths.z });
  };
  const auto largestOf = [&](const auto& sizes)
  {
    return vtkRayTracedParallel::Largest(
      static_cast<vtkIdType>(sizes.size()), [&](vtkIdType i) { return lengthOf(sizes[i]); });
  };
  double largest = std::max(largestOf(glyphs.sizes1), largestOf(glyphs.sizes3));
  if (glyphs.sizes1.empty() && glyphs.sizes3.empty() && glyphs.Count() > 0)
  {
    largest = std::abs(glyphs.uniformSize);
  }
  return glyphs.mesh ? largest * largestOf(glyphs.mesh->positions) : largest;
}

vtkMTimeType TimeOf(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

vtkUnsignedIntArray* BlocksOf(vtkPolyData* points)
{
  return vtkUnsignedIntArray::SafeDownCast(points->GetPointData()->GetArray(vtkRayTracedArrays::CompositeIndex));
}
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::vtkRayTracedMapper()
{
  vtkMath::UninitializeBounds(this->Bounds);
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::~vtkRayTracedMapper() = default;

//----------------------------------------------------------------------------
void vtkRayTracedMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Number of glyphs: " << this->GetNumberOfGlyphs() << endl;
  os << indent << "Skipped glyphs: " << this->Skipped << endl;
}

//----------------------------------------------------------------------------
int vtkRayTracedMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetPoints(vtkPolyData* points)
{
  this->Points = points;
}

//----------------------------------------------------------------------------
vtkPolyData* vtkRayTracedMapper::GetPoints() const
{
  return this->Points;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetBlocks(const vtkGlyphBlockAttributes& blocks)
{
  if (this->Blocks.GetVersion() != blocks.GetVersion())
  {
    this->Blocks = blocks;
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetKnownBounds(const double bounds[6])
{
  std::copy_n(bounds, 6, this->Bounds);
}

//----------------------------------------------------------------------------
std::uint64_t vtkRayTracedMapper::NewVersion()
{
  static std::uint64_t last = 0;
  return ++last;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetSelectionColor(const std::array<double, 3>& color)
{
  this->SelectionColor = Pack({ color[0], color[1], color[2], 0.0 });
}

//----------------------------------------------------------------------------
vtkUnsignedCharArray* vtkRayTracedMapper::Selected(vtkDataSetAttributes* data)
{
  return vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkRayTracedArrays::Selected));
}

//----------------------------------------------------------------------------
std::uint32_t vtkRayTracedMapper::Pack(const std::array<double, 4>& rgba)
{
  std::uint32_t packed = 0;
  for (int c = 0; c < 4; ++c)
  {
    packed |= static_cast<std::uint32_t>(std::lround(vtkMath::ClampValue(rgba[c], 0.0, 1.0) * 255.0)) << (8 * c);
  }
  return packed;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::ReadColor(vtkUnsignedCharArray* colors, vtkIdType tuple, std::array<double, 4>& rgba)
{
  const int components = colors->GetNumberOfComponents();
  for (int c = 0; c < std::min(components, 4); ++c)
  {
    rgba[c] = colors->GetValue(tuple * components + c) / 255.0;
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedMapper::HasBlockColors(vtkPolyData* points) const
{
  return BlocksOf(points) &&
    std::any_of(this->BlockTable.begin(), this->BlockTable.end(),
      [](const auto& item) { return item.second.HasColor || item.second.Opacity < 1.0; });
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::BlockColor(
  vtkPolyData* points, vtkIdType point, std::array<double, 4>& rgba, bool colors) const
{
  const auto block = this->BlockTable.find(BlocksOf(points)->GetValue(point));
  if (block != this->BlockTable.end())
  {
    if (block->second.HasColor && colors)
    {
      std::copy(block->second.Color.begin(), block->second.Color.end(), rgba.begin());
    }
    rgba[3] *= block->second.Opacity;
  }
}

//----------------------------------------------------------------------------
vtkRayTracedArrayUnion::Holes vtkRayTracedMapper::HolesOf(vtkPolyData* data)
{
  int ofCells = 0;
  return vtkRayTracedArrayUnion::Holes(
    GetAbstractScalars(data, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, ofCells));
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::MappedColors vtkRayTracedMapper::MapColors(
  vtkPolyData* data, bool interpolateValues, const char* what, std::vector<std::string>& messages)
{
  MappedColors mapped;
  mapped.Blocks = this->HasBlockColors(data);
  if (!this->ScalarVisibility || this->Sources.empty())
  {
    return mapped;
  }
  // Colors of blocks are mixed in point by point.
  this->SetInterpolateScalarsBeforeMapping(interpolateValues && !mapped.Blocks);
  // vtkMapper asks its input, which it has at no other time, when its texture was made.
  this->SetInputDataObject(data);
  int ofCells = 0;
  mapped.Colors = this->MapScalars(data, 1.0, ofCells);
  mapped.OfCells = ofCells != 0;
  mapped.Holes = this->HolesOf(data);
  const bool values = !mapped.Colors && this->TakeValues(mapped, data->GetNumberOfPoints());
  this->SetInputDataObject(nullptr);
  const vtkIdType wanted = mapped.OfCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (!values && (!mapped.Colors || mapped.Colors->GetNumberOfTuples() != wanted))
  {
    mapped.Colors = nullptr;
    messages.push_back("There is no array '" + std::string(this->ArrayName) +
      "' that has a value for each point or cell of the " + what +
      ", so it has one color. Choose a point or cell array as ColorArrayName.");
  }
  return mapped;
}

//----------------------------------------------------------------------------
// vtkMapper's texture of colors and the points' places in it; false: it has made none.
bool vtkRayTracedMapper::TakeValues(MappedColors& mapped, vtkIdType points)
{
  vtkFloatArray* places = this->GetColorCoordinates();
  vtkImageData* texture = this->GetColorTextureMap();
  auto* texels = texture ? vtkUnsignedCharArray::SafeDownCast(texture->GetPointData()->GetScalars()) : nullptr;
  if (!places || !texels || places->GetNumberOfTuples() != points)
  {
    return false;
  }
  const vtkIdType width = texture->GetDimensions()[0];
  const auto texel = [texels](vtkIdType i)
  {
    std::array<double, 4> rgba{ { 0.0, 0.0, 0.0, 1.0 } };
    ReadColor(texels, i, rgba);
    return Pack(rgba);
  };
  mapped.Table.resize(width + 2);
  for (vtkIdType i = 0; i <= width; ++i)
  {
    mapped.Table[i] = texel(i); // the last of the second row, which is that of NaN
  }
  mapped.Table[width + 1] = Pack({ this->SolidColor[0], this->SolidColor[1], this->SolidColor[2], 1.0 });
  mapped.Values.resize(points);
  vtkRayTracedParallel::ForChunks(points,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const bool isNumber = places->GetTypedComponent(i, 1) < 0.5f;
        mapped.Values[i] = isNumber ? std::clamp(places->GetTypedComponent(i, 0), -1000.0f, 1000.0f)
          : mapped.Holes(i)         ? rtg::noValue
                                    : rtg::notANumber;
      }
    });
  return true;
}

//----------------------------------------------------------------------------
std::uint32_t
vtkRayTracedMapper::ColorOf(const MappedColors& mapped, vtkPolyData* data, vtkIdType value, vtkIdType point) const
{
  std::array<double, 4> rgba{ { this->SolidColor[0], this->SolidColor[1], this->SolidColor[2], 1.0 } };
  if (mapped.Colors && !mapped.Holes(value))
  {
    ReadColor(mapped.Colors, value, rgba);
  }
  if (mapped.Blocks)
  {
    this->BlockColor(data, point, rgba);
  }
  return Pack(rgba);
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::Origin vtkRayTracedMapper::OriginOfPoint(vtkPolyData* points, vtkIdType point) const
{
  Origin origin;
  vtkDataArray* processes = points->GetPointData()->GetArray(vtkRayTracedArrays::ProcessId);
  vtkUnsignedIntArray* blocks = BlocksOf(points);
  origin.CompositeIndex = blocks ? blocks->GetValue(point) : 0;
  origin.Process = processes ? static_cast<int>(processes->GetComponent(point, 0)) : -1;
  return origin;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::ReportInstances(std::vector<std::string> messages, const std::string& unfinished)
{
  this->Unfinished = unfinished;
  if (!unfinished.empty() && !this->InWindow)
  {
    messages.push_back(unfinished);
  }
  this->Report(messages, this->ReportedInstances);
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Report(const std::vector<std::string>& messages, std::vector<std::string>& reported)
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
// The kernels' numbers have single precision, and squares of lengths must be among them.
void vtkRayTracedMapper::ReportSizes()
{
  constexpr double least = 1e-16, most = 1e18;
  const rtg::GlyphInstances* built = this->GetInstances();
  const double size = built ? LargestSize(*built) : 0.0;
  std::vector<std::string> messages;
  if (size > most || (size > 0.0 && size < least))
  {
    std::ostringstream message;
    message << "The largest size is " << size << ", of which little or nothing can be shown: sizes may be from "
            << least << " to " << most
            << ". Change the unit of the data, for example with the scale of a Transform filter.";
    messages.push_back(message.str());
  }
  this->Report(messages, this->ReportedSizes);
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Update(vtkActor* actor)
{
  vtkPolyData* points = this->GetPoints();
  if (!points)
  {
    this->Sources = vtkRayTracedSources();
    this->Skipped = 0;
    this->Built.Forget();
    return;
  }

  this->BlockTable = this->Blocks.Resolve(points);
  InstanceKey key;
  for (vtkObject* input : this->InstanceInputs(points))
  {
    key.Times.push_back(TimeOf(input));
  }
  key.HiddenBlocks = vtkGlyphBlockAttributes::Hidden(this->BlockTable);
  std::copy_n(&actor->GetMatrix()->Element[0][0], 16, key.Matrix.begin());
  if (this->HaveSettingsChanged())
  {
    this->Built.Forget();
  }
  this->Built.Update(std::move(key),
    [&]
    {
      rtg::Stopwatch watch;
      this->BuildInstances(points, actor);
      ++this->InstanceBuilds;
      this->InstanceSeconds += watch.Lap();
      this->ReportSizes();
    });

  ColorKey color;
  color.Sources = this->SourcesVersion;
  color.Blocks = this->BlockTable;
  color.Visible = this->ScalarVisibility != 0;
  color.State = this->ColorState();
  vtkUnsignedCharArray* selected = Selected(points->GetPointData());
  if (selected)
  {
    color.Selected = selected->GetMTime();
    color.SelectionColor = this->SelectionColor;
  }
  if (!color.Blocks.empty() || selected)
  {
    actor->GetProperty()->GetDiffuseColor(color.SolidColor.data());
  }
  if (color.Visible)
  {
    int cellFlag = 0;
    vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
      points, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
    color.Array = this->ArrayName;
    color.ScalarMode = this->ScalarMode;
    color.ColorMode = this->ColorMode;
    color.Times = { TimeOf(scalars), TimeOf(this->LookupTable) };
  }
  this->Colored.Update(std::move(color),
    [&, solid = color.SolidColor]
    {
      this->SolidColor = solid;
      rtg::Stopwatch watch;
      this->BuildColors(points);
      ++this->ColorBuilds;
      this->ColorSeconds += watch.Lap();
    });
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetSelector())
  {
    this->InvokeEvent(vtkCommand::RenderEvent, actor);
  }
}
