#include "GlyphTrails.h"

#include "Finite.h"
#include "GlyphBounds.h"
#include "GlyphSizes.h"
#include "GlyphTuples.h"
#include "RayTracedParallel.h"
#include "TubePieces.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
double MiddleOf(const glm::dvec3& v)
{
  return std::max(std::min(v.x, v.y), std::min(std::max(v.x, v.y), v.z));
}

class Trails : private rtglyphs::TubePieces
{
public:
  Trails(vtkPolyData* points, const rtglyphs::GlyphSettings& settings, vtkMatrix4x4* modelToWorld)
    : TubePieces(modelToWorld, false, settings.TrailJoined)
    , Points(points)
    , How(settings)
    , Earlier(rtglyphs::GlyphArrays::Trail(points, settings))
    , Opacities(rtglyphs::GlyphArrays::Find(rtglyphs::GlyphArrays::OPACITY, points, settings))
  {
  }

  rtglyphs::GlyphTrails::Result Make(const rtglyphs::RayTracedRanges& hidden)
  {
    this->Shown = rtglyphs::GlyphArrays::Candidates(this->Points, this->How, hidden);
    const rtglyphs::GlyphSizes sizes(this->Points, this->How, this->Shown);
    if (this->Earlier && sizes.GetProblem().empty())
    {
      this->FindRadii(sizes);
      this->Build(static_cast<vtkIdType>(this->Shown.size()));
    }
    this->Out.Instances = std::move(this->Instances);
    return std::move(this->Out);
  }

private:
  // Not positive: the point has no trail.
  void FindRadii(const rtglyphs::GlyphSizes& sizes)
  {
    const rtglyphs::GlyphUnturnedBox boxOf(this->How, sizes);
    this->Radii.resize(this->Shown.size());
    rtglyphs::RayTracedParallel::ForChunks(static_cast<vtkIdType>(this->Shown.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphSizes::Tuples tuples(sizes);
        const rtglyphs::GlyphTuples trails(this->Earlier);
        for (vtkIdType line = begin; line < end; ++line)
        {
          const vtkIdType point = this->Shown[line];
          if (trails.Has(point) && !sizes.Lacks(point, tuples))
          {
            const rtg::DoubleBox box = boxOf(point, tuples);
            this->Radii[line] = 0.25 * MiddleOf(box.upper - box.lower) * this->Factor();
          }
        }
      });
  }

  void ForLines(vtkIdType begin, vtkIdType end, const Use& use) const override
  {
    rtglyphs::GlyphTuples positions(this->Points->GetPoints()->GetData()), trails(this->Earlier);
    const int steps = std::min(trails.Size() / 3, this->How.TrailSteps);
    Balls balls;
    const auto add = [&](const double* x, double radius) {
      balls.push_back({ this->Placement({ x[0], x[1], x[2] }), radius, static_cast<vtkIdType>(balls.size()) });
    };
    for (; begin < end; ++begin)
    {
      const double radius = this->Radii[begin];
      const double* x = positions.Get(this->Shown[begin]);
      if (rtg::IsPositive(radius) && rtg::IsFinite(x))
      {
        balls.clear();
        add(x, radius);
        x = trails.Get(this->Shown[begin]);
        for (int step = 1; step <= steps && rtg::IsFinite(x); ++step, x += 3)
        {
          add(x, radius * (this->How.TrailSteps - step) / this->How.TrailSteps);
        }
        use(begin, balls);
      }
    }
  }

  void Allocate(std::size_t count) override
  {
    this->TubePieces::Allocate(count);
    this->Instances.opacities.resize(this->Opacities ? count : 0);
    this->Out.Points.resize(count);
    this->Out.Steps.resize(count);
  }

  void Place(std::size_t i, const Piece& piece) override
  {
    this->TubePieces::Place(i, piece);
    this->Out.Points[i] = this->Shown[piece.Line];
    this->Out.Steps[i] = { static_cast<std::uint16_t>(piece.First->Point),
      static_cast<std::uint16_t>(piece.Last->Point) };
    if (this->Opacities)
    {
      rtglyphs::GlyphTuples opacities(this->Opacities);
      this->Instances.opacities[i] = rtglyphs::GlyphArrays::Opacity(opacities, this->Out.Points[i]);
    }
  }

  vtkPolyData* Points;
  const rtglyphs::GlyphSettings& How;
  vtkDataArray *Earlier, *Opacities;
  std::vector<vtkIdType> Shown;
  std::vector<double> Radii; // at the points shown, in the world
  rtglyphs::GlyphTrails::Result Out;
};
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTrails::Result rtglyphs::GlyphTrails::Build(vtkPolyData* points, const rtglyphs::GlyphSettings& settings,
  const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld)
{
  return Trails(points, settings, modelToWorld).Make(hidden);
}
