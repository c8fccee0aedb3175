#include "vtkRayTracedMapper.h"

#include "RayTracedArrays.h"
#include "Stopwatch.h"
#include "TriangleMesh.h"
#include "vtkActor.h"
#include "vtkCellData.h"
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
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <glm/packing.hpp>

#include <cmath>
#include <iterator>
#include <regex>
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
    return rtglyphs::RayTracedParallel::Largest(
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
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::vtkRayTracedMapper()
{
  vtkMath::UninitializeBounds(this->Bounds);
}

//----------------------------------------------------------------------------
int vtkRayTracedMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetBlocks(const rtglyphs::RayTracedBlocks& blocks)
{
  if (this->BlocksVersion != blocks.GetVersion())
  {
    this->BlocksVersion = blocks.GetVersion();
    this->PolyData = blocks.GetPolyData();
    this->Blocks = blocks.GetBlocks();
    this->Hidden = blocks.GetHidden();
  }
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
  return vtkUnsignedCharArray::SafeDownCast(data->GetArray(rtglyphs::RayTracedArrays::Selected));
}

//----------------------------------------------------------------------------
std::uint32_t vtkRayTracedMapper::Pack(const std::array<double, 4>& rgba)
{
  return glm::packUnorm4x8(glm::vec4(rgba[0], rgba[1], rgba[2], rgba[3]));
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
std::size_t vtkRayTracedMapper::BlockOf(vtkIdType point) const
{
  if (this->Blocks.size() == 1)
  {
    return 0;
  }
  const auto next = std::upper_bound(this->Blocks.begin(), this->Blocks.end(), point,
    [](vtkIdType p, const rtglyphs::RayTracedBlocks::Block& block) { return p < block.FirstPoint; });
  return next - this->Blocks.begin() - 1;
}

//----------------------------------------------------------------------------
bool vtkRayTracedMapper::HasBlockColors() const
{
  return std::any_of(this->Blocks.begin(), this->Blocks.end(),
    [](const rtglyphs::RayTracedBlocks::Block& block) { return block.Color || block.Opacity < 1.0; });
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::MappedColors
vtkRayTracedMapper::MapColors(bool interpolateValues, const char* what, std::vector<std::string>& messages)
{
  MappedColors mapped;
  mapped.Blocks.resize(this->Blocks.size());
  const rtglyphs::RayTracedBlocks::Block* missing = nullptr;
  for (const rtglyphs::RayTracedBlocks::Block& block : this->Blocks)
  {
    interpolateValues &= block.Scalars.InterpolatesScalars;
  }
  interpolateValues &= !this->HasBlockColors(); // these are mixed in point by point
  for (std::size_t i = 0; i < this->Blocks.size(); ++i)
  {
    const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[i];
    if (this->OriginalIds.empty() || !block.Visible || !block.Scalars.On || block.Data->GetNumberOfPoints() == 0)
    {
      continue;
    }
    this->MapBlock(i, interpolateValues, mapped);
    missing = &block;
  }
  if (!mapped.Values.empty() && (mapped.Any || !mapped.OneTable))
  {
    return this->MapColors(false, what, messages);
  }
  if (missing && !mapped.Any && mapped.Values.empty() &&
    !rtglyphs::RayTracedBlocks::IsOnOtherRanks(missing->Data, missing->Scalars.Array))
  {
    messages.push_back("There is no array '" + missing->Scalars.Array + "' that has a value for each " + what +
      ", so all have one color. Choose another one as ColorArrayName.");
  }
  return mapped;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::MapBlock(std::size_t number, bool interpolateValues, MappedColors& mapped)
{
  const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[number];
  const rtglyphs::RayTracedBlocks::Coloring& scalars = block.Scalars;
  this->ScalarVisibilityOn();
  this->SetUseLookupTableScalarRange(1);
  this->SetColorMode(scalars.ColorMode);
  this->SetScalarMode(scalars.ScalarMode);
  this->SelectColorArray(scalars.Array.c_str());
  this->SetLookupTable(scalars.Table);
  this->SetInterpolateScalarsBeforeMapping(interpolateValues);
  // Cells of a hyper tree grid are points here.
  if (scalars.ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA &&
    !block.Data->GetCellData()->HasArray(scalars.Array.c_str()))
  {
    this->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  }
  // vtkMapper asks its input, which it has at no other time, when its texture was made.
  this->SetInputDataObject(block.Data);
  this->ClearColorArrays();
  MappedColors::OfBlock& own = mapped.Blocks[number];
  own.Colors = this->MapScalars(block.Data, 1.0, own.Association);
  const bool values = !own.Colors && this->ReadColorTexture(block, mapped);
  const vtkIdType wanted[] = { block.Data->GetNumberOfPoints(), block.Data->GetNumberOfCells(),
    own.Colors ? std::max(own.Colors->GetNumberOfTuples(), scalars.FieldDataTuple + 1) : 0 };
  if (own.Colors && own.Colors->GetNumberOfTuples() != wanted[own.Association])
  {
    own.Colors = nullptr;
  }
  if (!own.Colors && !values && scalars.MissingIsNan && scalars.Table)
  {
    own.Colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    own.Colors->SetNumberOfComponents(3);
    own.Colors->InsertNextTypedTuple(scalars.Table->MapValue(vtkMath::Nan()));
    own.Association = 2;
  }
  this->ClearColorArrays(); // vtkMapper keeps them
  this->SetInputDataObject(nullptr);
  mapped.Any |= own.Colors != nullptr;
  mapped.OfCells |= own.Colors && own.Association == 1;
}

//----------------------------------------------------------------------------
// vtkMapper's texture of colors and the points' places in it; false: it has made none.
bool vtkRayTracedMapper::ReadColorTexture(const rtglyphs::RayTracedBlocks::Block& block, MappedColors& mapped)
{
  vtkFloatArray* places = this->GetColorCoordinates();
  vtkImageData* texture = this->GetColorTextureMap();
  auto* texels = texture ? vtkUnsignedCharArray::SafeDownCast(texture->GetPointData()->GetScalars()) : nullptr;
  const vtkIdType points = block.Data->GetNumberOfPoints();
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
  std::vector<std::uint32_t> table(width + 2);
  for (vtkIdType i = 0; i <= width; ++i)
  {
    table[i] = texel(i); // the last of the second row, which is that of NaN
  }
  table[width + 1] = Pack({ this->SolidColor[0], this->SolidColor[1], this->SolidColor[2], 1.0 });
  if (mapped.Values.empty())
  {
    mapped.Table = table;
    mapped.Values.assign(this->PolyData->GetNumberOfPoints(), rtg::noValue);
  }
  mapped.OneTable &= mapped.Table == table;
  rtglyphs::RayTracedParallel::ForEach(points,
    [&](vtkIdType i)
    {
      const bool isNumber = places->GetTypedComponent(i, 1) < 0.5f;
      mapped.Values[block.FirstPoint + i] =
        isNumber ? std::clamp(places->GetTypedComponent(i, 0), -1000.0f, 1000.0f) : rtg::notANumber;
    });
  return true;
}

//----------------------------------------------------------------------------
std::array<double, 4> vtkRayTracedMapper::ColorOf(const MappedColors& mapped, vtkIdType point, vtkIdType cell) const
{
  const std::size_t number = this->BlockOf(point);
  const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[number];
  const std::array<double, 3>& solid = block.Color ? *block.Color : this->SolidColor;
  std::array<double, 4> rgba{ { solid[0], solid[1], solid[2], 1.0 } };
  if (vtkUnsignedCharArray* colors = mapped.Blocks.empty() ? nullptr : mapped.Blocks[number].Colors.Get())
  {
    const int association = mapped.Blocks[number].Association;
    ReadColor(colors,
      association == 0     ? point - block.FirstPoint
        : association == 1 ? cell - block.FirstCell
                           : std::min(block.Scalars.FieldDataTuple, colors->GetNumberOfTuples() - 1),
      rgba);
  }
  rgba[3] *= block.Opacity;
  return rgba;
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::Origin vtkRayTracedMapper::OriginOfPoint(vtkIdType point, vtkIdType cell, bool ofCells) const
{
  const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[this->BlockOf(point)];
  vtkPointData* data = block.Data->GetPointData();
  const auto number = [](vtkDataArray* ids, vtkIdType i) { return static_cast<vtkIdType>(ids->GetComponent(i, 0)); };
  Origin origin;
  origin.CompositeIndex = block.FlatIndex;
  vtkDataArray* processes = data->GetArray(rtglyphs::RayTracedArrays::ProcessId);
  origin.Process = processes ? static_cast<int>(number(processes, point - block.FirstPoint)) : -1;
  vtkDataArray* ids = ofCells ? block.Data->GetCellData()->GetArray(rtglyphs::RayTracedArrays::CellIds)
                              : data->GetArray(rtglyphs::RayTracedArrays::PointIds);
  const vtkIdType own = ofCells ? cell - block.FirstCell : point - block.FirstPoint;
  origin.Id = ids ? number(ids, own) : own;
  return origin;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::ReportInstances(std::vector<std::string> messages, const std::string& missingInput)
{
  this->MissingInput = missingInput;
  if (!missingInput.empty() && !this->InWindow)
  {
    messages.push_back(missingInput);
  }
  this->Report(messages, this->ReportedInstances);
}

//----------------------------------------------------------------------------
std::string vtkRayTracedMapper::WithoutCounts(const std::string& message)
{
  static const std::regex counts("\\d+ (of \\d+ )?(?=points|cells|triangles|pieces)");
  return std::regex_replace(message, counts, std::string());
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Report(const std::vector<std::string>& messages, std::vector<std::string>& reported)
{
  if (this->PolyData && this->PolyData->GetPointData()->HasArray(rtglyphs::RayTracedArrays::Reduced))
  {
    return; // all points have the same
  }
  std::copy_if(messages.begin(), messages.end(), std::back_inserter(this->NewMessages),
    [&reported](const std::string& message)
    {
      return std::none_of(reported.begin(), reported.end(),
        [&message](const std::string& other) { return WithoutCounts(message) == WithoutCounts(other); });
    });
  reported = messages;
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::SetColors(rtg::GlyphColors colors, const std::vector<std::string>& messages)
{
  this->Translucent = rtg::AnyTranslucent(colors);
  if (this->ColorVersion == 0 || !(this->Colors == colors))
  {
    this->Colors = std::move(colors);
    this->ColorVersion = NewVersion();
  }
  this->Report(messages, this->ReportedColors);
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
    message << "The largest size is " << size << ", too large or too small to be shown: sizes may be from " << least
            << " to " << most << ". Change the unit of the data, for example with the scale of a Transform filter.";
    messages.push_back(message.str());
  }
  this->Report(messages, this->ReportedSizes);
}

//----------------------------------------------------------------------------
vtkRayTracedMapper::InstanceKey vtkRayTracedMapper::KeyOf(vtkActor* actor) const
{
  InstanceKey key;
  for (vtkObject* input : this->InstanceInputs(this->PolyData))
  {
    key.Times.push_back(TimeOf(input));
  }
  key.Hidden = this->Hidden;
  std::copy_n(&actor->GetMatrix()->Element[0][0], 16, key.Matrix.begin());
  return key;
}

//----------------------------------------------------------------------------
bool vtkRayTracedMapper::NeedsBuild(vtkActor* actor) const
{
  return this->PolyData && (this->HaveSettingsChanged() || !this->Built.Holds(this->KeyOf(actor)));
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Update(vtkActor* actor, const rtg::GlyphInstances* sent)
{
  vtkPolyData* points = this->GetPolyData();
  if (!points)
  {
    this->OriginalIds = rtglyphs::RayTracedOriginalIds();
    this->Skipped = 0;
    this->Built.Forget();
    return;
  }

  if (this->HaveSettingsChanged())
  {
    this->Built.Forget();
  }
  this->Built.Update(this->KeyOf(actor),
    [&]
    {
      rtg::Stopwatch watch;
      this->BuildInstances(points, actor);
      this->InstancesTaken = false;
      ++this->InstanceBuilds;
      this->InstanceSeconds += watch.Lap();
      this->ReportSizes();
      if (sent && *sent == this->Instances)
      {
        this->TakeInstances(actor); // one copy is enough
      }
      else
      {
        this->InstanceVersion = NewVersion();
      }
    });

  ColorKey color;
  color.InstanceBuilds = this->InstanceBuilds;
  color.State = this->ColorState();
  for (const rtglyphs::RayTracedBlocks::Block& block : this->Blocks)
  {
    color.Blocks.push_back(block);
    if (block.Scalars.On)
    {
      int association = 0;
      color.Times.push_back(TimeOf(GetAbstractScalars(
        block.Data, block.Scalars.ScalarMode, VTK_GET_ARRAY_BY_NAME, 0, block.Scalars.Array.c_str(), association)));
      color.Times.push_back(TimeOf(block.Scalars.Table));
    }
  }
  vtkUnsignedCharArray* selected = Selected(points->GetPointData());
  if (selected)
  {
    color.Selected = selected->GetMTime();
    color.SelectionColor = this->SelectionColor;
  }
  if (this->Blocks.size() != 1 || this->Blocks.front().FlatIndex != 0 || selected || this->NeedsSolidColor())
  {
    actor->GetProperty()->GetDiffuseColor(color.SolidColor.data());
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
rtg::GlyphInstances vtkRayTracedMapper::TakeInstances(vtkActor* actor)
{
  if (this->InstancesTaken && this->PolyData)
  {
    this->BuildInstances(this->PolyData, actor);
  }
  this->InstancesTaken = true;
  return std::exchange(this->Instances, {});
}

//----------------------------------------------------------------------------
void vtkRayTracedMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetSelector())
  {
    this->InvokeEvent(vtkCommand::RenderEvent, actor);
  }
}
