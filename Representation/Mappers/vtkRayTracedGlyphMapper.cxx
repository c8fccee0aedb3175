#include "vtkRayTracedGlyphMapper.h"

#include "GlyphArrays.h"
#include "GlyphInstanceBuilder.h"
#include "GlyphPlacement.h"
#include "GlyphTrails.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTriangleBuilder.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <regex>
#include <utility>

vtkStandardNewMacro(vtkRayTracedGlyphMapper);

namespace
{
// Messages that name the shells' array, with its property; the glyphs inside have the others.
void KeepOfShells(const rtglyphs::GlyphSettings& settings, std::vector<std::string>& messages)
{
  const std::string array = "'" + (settings.Tensors.On ? settings.Tensors.Array : settings.ScaleArray) + "'";
  std::erase_if(messages, [&](const std::string& message) { return message.find(array) == std::string::npos; });
  for (std::string& message : messages)
  {
    message = std::regex_replace(message, std::regex("GlyphTensorArray|SelectScaleArray"), "GlyphShellArray");
  }
}
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::SetSettings(const rtglyphs::GlyphSettings& settings, vtkPolyData* mesh)
{
  std::shared_ptr<const rtg::TriangleMesh> triangles = this->Settings.Mesh;
  const vtkMTimeType time = mesh ? mesh->GetMTime() : 0;
  if (settings.Shape != rtg::Shape::Mesh)
  {
    triangles.reset();
  }
  else if (!triangles || time != this->MeshTime)
  {
    auto built = std::make_shared<rtg::TriangleMesh>();
    if (mesh)
    {
      *built = rtglyphs::RayTracedTriangleBuilder::Build(mesh, {}, nullptr, /*smooth=*/true, nullptr).Mesh;
    }
    // A mesh that was made again and came out the same is the same.
    if (!triangles || !rtg::SameShape(*triangles, *built))
    {
      triangles = std::move(built);
    }
  }
  this->MeshTime = time;
  this->Settings = settings;
  this->Settings.Mesh = std::move(triangles);
}

//----------------------------------------------------------------------------
std::vector<vtkObject*> vtkRayTracedGlyphMapper::InstanceInputs(vtkPolyData* points) const
{
  const std::vector<vtkDataArray*> arrays = rtglyphs::GlyphArrays::All(points, this->Settings.Effective());
  return { arrays.begin(), arrays.end() };
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::BuildInstances(vtkPolyData* points, vtkActor* actor)
{
  this->BuiltSettings = this->Settings.Effective();
  this->Placed = rtglyphs::GlyphPlacement(actor->GetMatrix()).Linear;
  const bool trails = this->BuiltSettings.TrailSteps > 0;
  rtglyphs::GlyphInstanceBuilder::Result result;
  if (trails)
  {
    rtglyphs::GlyphTrails::Result built =
      rtglyphs::GlyphTrails::Build(points, this->BuiltSettings, this->Hidden, actor->GetMatrix());
    result.Instances = std::move(built.Instances);
    result.Points = std::move(built.Points);
    this->TrailEnds = std::move(built.Steps);
  }
  else if (points->GetNumberOfPoints() > 0)
  {
    result = rtglyphs::GlyphInstanceBuilder::Build(
      points, this->BuiltSettings, this->Hidden, actor->GetMatrix(), this->BuildProgress);
  }
  this->Instances = std::move(result.Instances);
  this->TranslucentInstances = rtg::IsTranslucent(this->Instances);
  this->OriginalIds = std::move(result.Points);
  this->Radii = std::move(result.Radii);
  this->Skipped = result.Skipped;
  if (this->Settings.Shell)
  {
    KeepOfShells(this->Settings, result.Messages);
  }
  // Axes and trails go with glyphs, which have reported bad points.
  if (!this->Settings.Tensors.Axes && !trails)
  {
    this->ReportInstances(std::move(result.Messages), result.MissingInput);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::AddToMaterial(rtg::Material& material) const
{
  const rtglyphs::GlyphTensors::Settings& tensors = this->Settings.Tensors;
  const bool bySign = this->Settings.SurfaceColors() == rtg::GlyphInstances::SurfaceColors::Sign;
  for (int c = 0; c < 3 && bySign; ++c)
  {
    material.positiveColor[c] = static_cast<float>(tensors.PositiveColor[c]);
    material.negativeColor[c] = static_cast<float>(tensors.NegativeColor[c]);
  }
}

//----------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkRayTracedGlyphMapper::ColorState() const
{
  const rtglyphs::GlyphTensors::Settings& tensors = this->Settings.Tensors;
  const bool byRadius = this->Settings.Forms.ColorsByRadius();
  const int coloring = tensors.On || byRadius ? tensors.Coloring : static_cast<int>(this->Settings.SurfaceColors());
  const bool usesTable = byRadius || (tensors.On && rtglyphs::GlyphTensors::IsNumber(coloring));
  std::vector<vtkMTimeType> state{ static_cast<vtkMTimeType>(coloring),
    usesTable && this->TensorTable ? this->TensorTable->GetMTime() : 0,
    static_cast<vtkMTimeType>(this->Settings.DirectionColoring) };
  // g++ 10 has no std::bit_cast.
  const auto add = [&state](double number)
  {
    state.emplace_back();
    std::memcpy(&state.back(), &number, sizeof(number));
  };
  if (this->Settings.HasNumberRange())
  {
    std::for_each(this->TensorRange.begin(), this->TensorRange.end(), add);
  }
  if (this->Settings.TrailSteps > 0)
  {
    add(this->Settings.TrailFading);
  }
  return state;
}

//----------------------------------------------------------------------------
// The table of |f| on a surface has enough entries for a part of it to be spread over all colors. Its last two belong
// to what is no number and what has none, which do not come.
void vtkRayTracedGlyphMapper::AddRadiusColors(rtg::GlyphColors& colors)
{
  constexpr int entries = 4096;
  this->TensorTable->Build();
  const double high = this->TensorTable->GetRange()[1] * (1.0 + 2.0 / entries); // the last ones lie above the range
  const double largest = *std::max_element(this->Radii.begin(), this->Radii.end());
  const double top = high > 0.0 ? std::min(largest, high) : largest;
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < entries; ++i)
  {
    values->InsertNextValue(top * (i + 0.5) / entries);
  }
  const vtkSmartPointer<vtkUnsignedCharArray> mapped = this->TableColors(values);
  colors.table.resize(entries + 2);
  for (int i = 0; i < entries; ++i)
  {
    std::array<double, 4> rgba{ { 1.0, 1.0, 1.0, 1.0 } };
    ReadColor(mapped, i, rgba);
    colors.table[i] = Pack(rgba);
  }
  std::fill_n(colors.table.end() - 2, 2, colors.table.front());
  colors.ends.resize(this->Radii.size());
  std::transform(this->Radii.begin(), this->Radii.end(), colors.ends.begin(),
    [top](float radius) { return glm::uvec2(0u, glm::floatBitsToUint(static_cast<float>(radius / top))); });
}

//----------------------------------------------------------------------------
// Magnitudes of the eigenvalues over the largest.
void vtkRayTracedGlyphMapper::EigenvaluesAsColor(
  const rtglyphs::GlyphTensors& tensors, vtkIdType point, double rgb[3]) const
{
  const double range = std::max(std::abs(this->TensorRange[0]), std::abs(this->TensorRange[1]));
  rtg::Eigensystem eigen;
  const bool known = tensors.Decompose(point, eigen);
  for (int i = 0; i < 3 && known; ++i)
  {
    rgb[i] = range > 0.0 ? std::min(std::abs(eigen.values[i]) / range, 1.0) : 0.0;
  }
}

//----------------------------------------------------------------------------
// RGBA of each number, as the table gives it to arrays.
vtkSmartPointer<vtkUnsignedCharArray> vtkRayTracedGlyphMapper::TableColors(vtkDoubleArray* numbers)
{
  this->TensorTable->Build();
  return vtk::TakeSmartPointer(this->TensorTable->MapScalars(numbers, VTK_COLOR_MODE_MAP_SCALARS, 0, VTK_RGBA));
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> vtkRayTracedGlyphMapper::NumbersOf(const rtglyphs::GlyphTensors& tensors)
{
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  numbers->SetNumberOfTuples(this->OriginalIds.size());
  numbers->Fill(vtkMath::Nan());
  rtglyphs::RayTracedParallel::ForEach(numbers->GetNumberOfTuples(),
    [&](vtkIdType glyph) { tensors.Number(this->OriginalIds[glyph], *numbers->GetPointer(glyph)); });
  return numbers;
}

//----------------------------------------------------------------------------
// In the world: of tensors the axis of the eigenvalue with the largest magnitude, else that along which the glyph's own
// x axis lies, and arrows and cones point. White: there is none.
std::vector<std::array<double, 3>> vtkRayTracedGlyphMapper::DirectionsAsColors(
  vtkPolyData* points, const rtglyphs::GlyphTensors* tensors, std::vector<std::string>& messages) const
{
  namespace Arrays = rtglyphs::GlyphArrays;
  const rtglyphs::GlyphSettings& how = this->Settings;
  vtkDataArray* orientations = tensors ? nullptr : Arrays::Find(Arrays::ORIENTATION, points, how);
  if (!tensors && !orientations && !this->OriginalIds.empty())
  {
    messages.push_back(
      "GlyphDirectionColoring shows the glyphs' directions as colors, but they have none, so all are white. "
      "Switch Orient on and choose an array as SelectOrientationVectors.");
  }
  const int mode = Arrays::OrientationMode(orientations, how);
  const bool pointed = how.Shape == rtg::Shape::Arrow || how.Shape == rtg::Shape::Cone;
  const bool turnedAround = how.Scaling && how.ScaleMode == rtglyphs::GlyphSettings::COMPONENTS;
  vtkDataArray* scales = pointed && turnedAround ? Arrays::Find(Arrays::SCALE, points, how) : nullptr;
  std::vector<std::array<double, 3>> colors(this->OriginalIds.size(), { { 1.0, 1.0, 1.0 } });
  rtglyphs::RayTracedParallel::ForChunks(static_cast<vtkIdType>(colors.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      rtglyphs::GlyphTuples turns(orientations), sizes(scales);
      for (vtkIdType glyph = begin; glyph < end; ++glyph)
      {
        const vtkIdType point = this->OriginalIds[glyph];
        glm::dquat turn;
        glm::dvec3 direction(0.0);
        if (tensors)
        {
          direction = tensors->PrincipalDirection(point);
        }
        else if (turns.Has(point) && rtglyphs::GlyphPlacement::RotationFromTuple(turns.Get(point), mode, turn))
        {
          const double sign = sizes.Has(point) && sizes.Get(point)[0] < 0.0 ? -1.0 : 1.0;
          direction = turn * glm::dvec3(pointed && how.ScaleFactor < 0.0 ? -sign : sign, 0.0, 0.0);
        }
        direction = this->Placed * direction;
        const double length = glm::length(direction);
        if (rtg::IsPositive(length))
        {
          colors[glyph] = rtglyphs::DirectionColors::Of(direction / length, how.DirectionColoring);
        }
      }
    });
  return colors;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphMapper::BuildColors(vtkPolyData* points)
{
  std::vector<std::string> messages;
  MappedColors mapped;
  std::unique_ptr<rtglyphs::GlyphTensors> tensors;
  const rtglyphs::GlyphTensors::Settings& shown = this->Settings.Tensors;
  const bool byRadius = this->Settings.Forms.ColorsByRadius();
  const bool bySurface = byRadius || this->Settings.SurfaceColors() != rtg::GlyphInstances::SurfaceColors::None;
  const bool byDirection =
    !shown.Axes && !bySurface && this->Settings.DirectionColoring != rtglyphs::DirectionColors::NONE;
  if (shown.On && !shown.Axes && !bySurface && (byDirection || shown.Coloring != rtglyphs::GlyphTensors::NONE) &&
    !this->OriginalIds.empty())
  {
    tensors = std::make_unique<rtglyphs::GlyphTensors>(
      rtglyphs::GlyphTensors::Array(points, shown), shown, this->OriginalIds.ToVector());
  }
  else if (!shown.Axes && !bySurface && !byDirection)
  {
    mapped = this->MapColors(false, "glyph", messages);
  }
  vtkUnsignedCharArray* selected = Selected(points->GetPointData());
  vtkSmartPointer<vtkUnsignedCharArray> table;
  if (tensors && this->TensorTable && rtglyphs::GlyphTensors::IsNumber(shown.Coloring))
  {
    table = this->TableColors(this->NumbersOf(*tensors));
  }
  std::vector<std::array<double, 3>> directions;
  if (byDirection)
  {
    directions = this->DirectionsAsColors(points, tensors.get(), messages);
  }

  rtg::GlyphColors colors;
  if (byRadius && this->TensorTable && !this->Radii.empty())
  {
    this->AddRadiusColors(colors);
  }
  if (mapped.Any || tensors || byDirection || this->HasBlockColors() || selected)
  {
    colors.each.resize(this->OriginalIds.size());
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(colors.each.size()),
      [&](vtkIdType glyph)
      {
        const vtkIdType point = this->OriginalIds[glyph];
        const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[this->BlockOf(point)];
        // Of a block with cells each point is one, others have none.
        std::array<double, 4> rgba = this->ColorOf(mapped, point, block.FirstCell + (point - block.FirstPoint));
        if (byDirection && !block.Color)
        {
          std::copy_n(directions[glyph].begin(), 3, rgba.begin());
        }
        else if (shown.Axes || (tensors && !block.Color))
        {
          rgba = { { this->SolidColor[0], this->SolidColor[1], this->SolidColor[2], 1.0 } };
          if (table)
          {
            ReadColor(table, glyph, rgba);
          }
          else if (tensors && shown.Coloring == rtglyphs::GlyphTensors::EIGENVALUES)
          {
            this->EigenvaluesAsColor(*tensors, point, rgba.data());
          }
          rgba[3] *= block.Opacity;
        }
        if (bySurface)
        {
          rgba = { { 1.0, 1.0, 1.0, rgba[3] } }; // white leaves glyphs the colors of their surfaces
        }
        colors.each[glyph] = selected && selected->GetValue(point) ? this->Tinted(Pack(rgba)) : Pack(rgba);
      });
  }
  if (this->NeedsSolidColor())
  {
    this->AddFading(colors);
  }
  this->SetColors(std::move(colors), messages);
}

//----------------------------------------------------------------------------
// The opacity falls with each step by the same amount.
void vtkRayTracedGlyphMapper::AddFading(rtg::GlyphColors& colors) const
{
  const auto at = [&](std::uint16_t step)
  {
    const double opacity = 1.0 - this->Settings.TrailFading * step / this->BuiltSettings.TrailSteps;
    return colors.each.empty() ? Pack({ this->SolidColor[0], this->SolidColor[1], this->SolidColor[2], opacity })
                               : Pack({ 1.0, 1.0, 1.0, opacity });
  };
  colors.ends.resize(this->TrailEnds.size());
  std::transform(this->TrailEnds.begin(), this->TrailEnds.end(), colors.ends.begin(),
    [&at](const std::array<std::uint16_t, 2>& ends) { return glm::uvec2(at(ends[0]), at(ends[1])); });
}

//----------------------------------------------------------------------------
// A glyph stands for its point, and for a cell where the gatherer has found one.
vtkRayTracedMapper::Origin vtkRayTracedGlyphMapper::FindOrigin(vtkIdType glyph, int association, const double*)
{
  const vtkIdType point = this->OriginalIds[glyph];
  Origin origin = this->OriginOfPoint(point, -1, false);
  if (association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    const rtglyphs::RayTracedBlocks::Block& block = this->Blocks[this->BlockOf(point)];
    vtkDataArray* cells = block.Data->GetPointData()->GetArray(rtglyphs::RayTracedArrays::CellIds);
    origin.Id = cells ? static_cast<vtkIdType>(cells->GetComponent(point - block.FirstPoint, 0))
                      : rtglyphs::RayTracedArrays::EncodeCellId(origin.Id);
  }
  return origin;
}
