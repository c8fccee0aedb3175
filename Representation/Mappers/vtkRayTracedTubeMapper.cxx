#include "vtkRayTracedTubeMapper.h"

#include "RayTracedParallel.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <utility>

vtkStandardNewMacro(vtkRayTracedTubeMapper);

//----------------------------------------------------------------------------
std::vector<vtkObject*> vtkRayTracedTubeMapper::InstanceInputs(vtkPolyData* lines) const
{
  const std::array<vtkDataArray*, 4> motion = rtglyphs::GlyphMotion::Arrays(lines, this->Settings.Motion);
  bool ofCells = false;
  return { lines->GetPoints() ? lines->GetPoints()->GetData() : nullptr, lines->GetLines(),
    rtglyphs::RayTracedTubeBuilder::RadiusArray(lines, this->Settings, ofCells), motion[0], motion[1], motion[3] };
}

//----------------------------------------------------------------------------
void vtkRayTracedTubeMapper::BuildInstances(vtkPolyData* lines, vtkActor* actor)
{
  rtglyphs::RayTracedTubeBuilder::Result result =
    rtglyphs::RayTracedTubeBuilder::Build(lines, this->Hidden, actor->GetMatrix(), this->Settings);
  this->BuiltSettings = this->Settings;
  this->OriginalIds = std::move(result.Cells);
  this->Ends = std::move(result.Ends);
  this->Instances = std::move(result.Instances);
  this->Placement = rtglyphs::GlyphPlacement(actor->GetMatrix());
  this->Skipped = result.Bad + result.Empty;
  this->ReportInstances(std::move(result.Messages), rtglyphs::GlyphMotion::MissingInput(this->Settings.Motion));
}

//----------------------------------------------------------------------------
void vtkRayTracedTubeMapper::BuildColors(vtkPolyData* lines)
{
  std::vector<std::string> messages;
  const bool directions = this->DirectionColoring != rtglyphs::DirectionColors::NONE;
  MappedColors mapped;
  if (!directions)
  {
    mapped = this->MapColors(true, "point or cell of the lines", messages);
  }
  vtkUnsignedCharArray* points = Selected(lines->GetPointData());
  vtkUnsignedCharArray* cells = Selected(lines->GetCellData());
  const auto isSelected = [&](vtkIdType piece)
  {
    const auto [first, last] = this->Ends[piece];
    return (cells && cells->GetValue(this->OriginalIds[piece])) ||
      (points && (points->GetValue(first) || points->GetValue(last)));
  };
  rtg::GlyphColors colors;
  colors.table = mapped.Table;
  const bool ends = directions || !mapped.Values.empty() || (mapped.Any && !mapped.OfCells);
  const bool each = points || (!ends && (mapped.Any || this->HasBlockColors()));
  colors.each.resize(each ? this->OriginalIds.size() : 0);
  colors.ends.resize(ends ? this->OriginalIds.size() : 0);
  const auto atEnd = [&](vtkIdType piece, int end)
  {
    const vtkIdType point = this->Ends[piece][end];
    std::uint32_t bits = 0;
    if (mapped.Values.empty())
    {
      std::array<double, 4> rgba = this->ColorOf(mapped, point, -1);
      if (directions && !this->Blocks[this->BlockOf(point)].Color)
      {
        const glm::dvec3 direction = glm::normalize(this->Placement.Linear * this->DirectionOf(lines, piece, end));
        const auto rgb = rtglyphs::DirectionColors::Of(direction, this->DirectionColoring);
        std::copy(rgb.begin(), rgb.end(), rgba.begin());
      }
      bits = Pack(rgba);
    }
    else
    {
      std::memcpy(&bits, &mapped.Values[point], sizeof(bits));
    }
    return bits;
  };
  rtglyphs::RayTracedParallel::ForEach(this->OriginalIds.size(),
    [&](vtkIdType i)
    {
      const auto [first, last] = this->Ends[i];
      if (each)
      {
        const std::uint32_t color =
          ends ? 0xffffffffu : Pack(this->ColorOf(mapped, first, this->OriginalIds[i])); // white leaves the ends theirs
        colors.each[i] = points && isSelected(i) ? this->Tinted(color) : color;
      }
      if (ends)
      {
        colors.ends[i] = { atEnd(i, 0), atEnd(i, 1) };
      }
    });
  this->SetColors(std::move(colors), messages);
}

//----------------------------------------------------------------------------
// A unit vector; between two pieces the mean of both.
glm::dvec3 vtkRayTracedTubeMapper::DirectionOf(vtkPolyData* lines, vtkIdType piece, int end) const
{
  const auto along = [&](vtkIdType of)
  {
    glm::dvec3 from, to;
    lines->GetPoint(this->Ends[of][0], &from[0]);
    lines->GetPoint(this->Ends[of][1], &to[0]);
    return glm::normalize(to - from);
  };
  const vtkIdType next = end == 0 ? piece - 1 : piece + 1;
  const bool joined = next >= 0 && next < static_cast<vtkIdType>(this->Ends.size()) &&
    this->OriginalIds[next] == this->OriginalIds[piece] && this->Ends[next][1 - end] == this->Ends[piece][end];
  const glm::dvec3 own = along(piece), mean = joined ? own + along(next) : own;
  return glm::length(mean) > 1e-6 ? glm::normalize(mean) : own;
}

//----------------------------------------------------------------------------
// A point is that end of the piece that lies nearer.
vtkRayTracedMapper::Origin
vtkRayTracedTubeMapper::FindOrigin(vtkIdType piece, int association, const double position[3])
{
  const glm::dvec3 place(position[0], position[1], position[2]);
  const auto distance = [&](vtkIdType point)
  {
    glm::dvec3 x;
    this->GetPolyData()->GetPoint(point, &x[0]);
    return glm::distance(place, this->Placement(x));
  };
  const auto [first, last] = this->Ends[piece];
  const vtkIdType nearest = distance(last) < distance(first) ? last : first;
  return this->OriginOfPoint(nearest, this->OriginalIds[piece], association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
}
