#include "GlyphTrails.h"

#include "Finite.h"
#include "GlyphBounds.h"
#include "GlyphSizes.h"
#include "GlyphTuples.h"
#include "RayTracedTubeBuilder.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr const char* radiusName = "radius";

// The trails of points as lines, each point of which is one step earlier.
class Lines
{
public:
  Lines()
  {
    this->Places->SetDataTypeToDouble();
    this->Radii->SetName(radiusName);
    this->Data->SetPoints(this->Places);
    this->Data->SetLines(this->Cells);
    this->Data->GetPointData()->AddArray(this->Radii);
  }

  // Of a point at x with the positions of a tuple of RayTracedArrays::Trail.
  void Add(vtkIdType point, const double* x, const double* trail, int size, double radius, int steps)
  {
    const vtkIdType first = this->Places->InsertNextPoint(x);
    this->Radii->InsertNextValue(radius);
    for (int step = 1; step <= std::min(size / 3, steps) && rtg::IsFinite(trail + 3 * (step - 1)); ++step)
    {
      this->Places->InsertNextPoint(trail + 3 * (step - 1));
      this->Radii->InsertNextValue(radius * (steps - step) / steps);
    }
    const auto count = static_cast<int>(this->Places->GetNumberOfPoints() - first);
    this->Cells->InsertNextCell(count);
    for (int i = 0; i < count; ++i)
    {
      this->Cells->InsertCellPoint(first + i);
    }
    this->Points.push_back(point);
    this->Firsts.push_back(first);
  }

  vtkNew<vtkPolyData> Data;
  std::vector<vtkIdType> Points, Firsts; // of each line

private:
  vtkNew<vtkPoints> Places;
  vtkNew<vtkDoubleArray> Radii;
  vtkNew<vtkCellArray> Cells;
};

double MiddleOf(const glm::dvec3& v)
{
  return std::max(std::min(v.x, v.y), std::min(std::max(v.x, v.y), v.z));
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTrails::Result rtglyphs::GlyphTrails::Build(vtkPolyData* points, const rtglyphs::GlyphSettings& settings,
  const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld)
{
  Result result;
  result.Instances.shape = rtg::Shape::RoundCone;
  rtglyphs::GlyphTuples trails(rtglyphs::GlyphArrays::Trail(points, settings));
  const std::vector<vtkIdType> candidates = rtglyphs::GlyphArrays::Candidates(points, settings, hidden);
  const rtglyphs::GlyphSizes sizes(points, settings, candidates);
  if (!trails || !sizes.GetProblem().empty())
  {
    return result;
  }

  Lines lines;
  const rtglyphs::GlyphUnturnedBox boxOf(settings, sizes);
  rtglyphs::GlyphSizes::Tuples tuples(sizes);
  rtglyphs::GlyphTuples positions(points->GetPoints()->GetData());
  for (const vtkIdType point : candidates)
  {
    const double* x = positions.Get(point);
    if (rtg::IsFinite(x) && trails.Has(point) && !sizes.Lacks(point, tuples))
    {
      const rtg::DoubleBox box = boxOf(point, tuples);
      const double radius = 0.25 * MiddleOf(box.upper - box.lower);
      if (rtg::IsPositive(radius))
      {
        lines.Add(point, x, trails.Get(point), trails.Size(), radius, settings.TrailSteps);
      }
    }
  }

  rtglyphs::RayTracedTubeBuilder::Settings tubes;
  tubes.RadiusArray = radiusName;
  tubes.Joined = settings.TrailJoined;
  rtglyphs::RayTracedTubeBuilder::Result built =
    rtglyphs::RayTracedTubeBuilder::Build(lines.Data, {}, modelToWorld, tubes);
  result.Instances = std::move(built.Instances);
  rtglyphs::GlyphTuples opacities(rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::OPACITY, points, settings));
  result.Instances.opacities.resize(opacities ? built.Cells.size() : 0);
  result.Points.resize(built.Cells.size());
  result.Steps.resize(built.Cells.size());
  for (std::size_t i = 0; i < built.Cells.size(); ++i)
  {
    const vtkIdType line = built.Cells[i];
    result.Points[i] = lines.Points[line];
    if (opacities)
    {
      result.Instances.opacities[i] = rtglyphs::GlyphArrays::Opacity(opacities, result.Points[i]);
    }
    for (int end = 0; end < 2; ++end)
    {
      result.Steps[i][end] = static_cast<std::uint16_t>(built.Ends[i][end] - lines.Firsts[line]);
    }
  }
  return result;
}
