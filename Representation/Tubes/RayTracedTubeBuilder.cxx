#include "RayTracedTubeBuilder.h"

#include "Finite.h"
#include "GlyphTensors.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedBlocks.h"
#include "RayTracedParallel.h"
#include "SweptEllipsoid.h"
#include "TubePieces.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace
{
using Settings = rtglyphs::RayTracedTubeBuilder::Settings;

class Builder : private rtglyphs::TubePieces
{
public:
  Builder(
    vtkPolyData* lines, const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, const Settings& settings)
    : TubePieces(modelToWorld, settings.FlatEnds, settings.Joined)
    , Lines(lines)
    , Hidden(hidden)
    , How(settings)
    , Motion(lines, settings.Motion)
    , Radii(rtglyphs::RayTracedTubeBuilder::RadiusArray(lines, settings, this->RadiiOfCells))
    , MissingRadii(rtglyphs::RayTracedBlocks::MissingTuples(this->Radii))
    , RankLacksRadii(!this->Radii && rtglyphs::RayTracedBlocks::IsOnOtherRanks(lines, settings.RadiusArray))
  {
    this->Moves = this->Motion.On();
  }

  rtglyphs::RayTracedTubeBuilder::Result Make()
  {
    if (this->Radii && this->Radii->GetNumberOfComponents() > 3)
    {
      this->Instances.shape = rtg::Shape::SweptEllipsoid;
      this->FindEllipsoids();
    }
    this->StoreMotion();
    this->Build(this->Lines->GetNumberOfLines());
    this->Motion.Finish(this->Instances.motion);
    this->Out.Bad = this->Bad;
    this->Out.Empty = this->Empty;
    this->ReportMessages();
    this->Out.Instances = std::move(this->Instances);
    return std::move(this->Out);
  }

private:
  // Covariances in the world, and their largest half-axes: negative if a matrix has no root.
  void FindEllipsoids()
  {
    constexpr double rounding = 1e-6;
    const rtglyphs::GlyphTensors::Order order(this->Radii, rtglyphs::GlyphTensors::VTK_ORDER);
    const glm::dmat3 linear = this->How.Radius * this->Placement.Linear;
    this->Ellipsoids.resize(this->Radii->GetNumberOfTuples());
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(this->Ellipsoids.size()),
      [&](vtkIdType i)
      {
        double tuple[9];
        this->Radii->GetTuple(i, tuple);
        const auto matrix = rtg::SymmetricTensor::Of(linear * order(tuple).Matrix() * glm::transpose(linear));
        double radius = HUGE_VAL;
        if (matrix.IsFinite())
        {
          const glm::dvec3 values = rtg::Decompose(matrix).values;
          radius = values[2] < -rounding * std::abs(values[0]) ? -1.0 : std::sqrt(std::max(values[0], 0.0));
        }
        this->Ellipsoids[i] = { matrix, radius };
      });
  }

  double Radius(vtkIdType tuple, double factor) const
  {
    if (!this->Ellipsoids.empty())
    {
      return this->Ellipsoids[tuple].second;
    }
    double value[3] = { 1.0, 0.0, 0.0 };
    if (this->Radii)
    {
      this->Radii->GetTuple(tuple, value);
    }
    return factor *
      (this->Radii && this->Radii->GetNumberOfComponents() > 1
          ? vtkMath::Norm(value, this->Radii->GetNumberOfComponents())
          : value[0]);
  }

  vtkIdType CellOf(vtkIdType line) const { return this->Lines->GetNumberOfVerts() + line; }

  void ForLines(vtkIdType begin, vtkIdType end, const Use& use) const override
  {
    const double factor = std::abs(this->How.Radius) * this->Factor();
    rtglyphs::GlyphTuples positions(this->Lines->GetPoints()->GetData());
    auto iterator = vtk::TakeSmartPointer(this->Lines->GetLines()->NewIterator());
    Balls balls;
    for (iterator->GoToCell(begin); begin < end; iterator->GoToNextCell(), ++begin)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      iterator->GetCurrentCell(size, points);
      const vtkIdType cell = this->CellOf(begin);
      if (size > 0 && !this->Hidden.Has(points[0]) && !this->RankLacksRadii &&
        !this->MissingRadii.Has(this->RadiiOfCells ? cell : points[0]))
      {
        balls.clear();
        for (vtkIdType i = 0; i < size; ++i)
        {
          const double* x = positions.Get(points[i]);
          balls.push_back({ this->Placement({ x[0], x[1], x[2] }),
            this->Motion.IsFinite(points[i]) ? this->Radius(this->RadiiOfCells ? cell : points[i], factor) : -1.0,
            points[i] });
        }
        use(begin, balls);
      }
    }
  }

  void Allocate(std::size_t count) override
  {
    this->TubePieces::Allocate(count);
    rtg::GlyphInstances& all = this->Instances;
    const bool swept = all.shape == rtg::Shape::SweptEllipsoid;
    all.exponents3.resize(swept ? count : 0);
    all.polynomials.width = swept && this->Joined ? rtg::valuesOfNextSweeps : 0;
    all.polynomials.values.resize(count * all.polynomials.width);
    this->Out.Cells.resize(count);
    this->Out.Ends.resize(count);
    all.motion.velocities.resize(this->OfPoints.velocities.empty() ? 0 : count);
    all.motion.angularVelocities.resize(this->OfPoints.velocities.empty() ? 0 : count);
    all.motion.accelerations.resize(this->OfPoints.accelerations.empty() ? 0 : count);
  }

  void Place(std::size_t i, const Piece& piece) override
  {
    this->Out.Cells[i] = this->CellOf(piece.Line);
    this->Out.Ends[i] = { piece.First->Point, piece.Last->Point };
    this->MovePiece(i, piece);
    if (this->Ellipsoids.empty())
    {
      this->TubePieces::Place(i, piece);
      return;
    }
    const auto end = [&](const Ball* ball)
    {
      return ball
        ? rtg::SweepEnd{ ball->Place, this->Ellipsoids[this->RadiiOfCells ? this->Out.Cells[i] : ball->Point].first }
        : std::optional<rtg::SweepEnd>();
    };
    rtg::StoreSweep(*end(piece.First), *end(piece.Last), i, this->Instances, end(piece.Before), end(piece.After));
  }

  void StoreMotion()
  {
    if (!this->Motion.On())
    {
      return;
    }
    this->Motion.Allocate(this->OfPoints, this->Lines->GetNumberOfPoints());
    rtglyphs::RayTracedParallel::ForEach(this->Lines->GetNumberOfPoints(),
      [&](vtkIdType i)
      {
        if (this->Motion.IsFinite(i))
        {
          this->Motion.Store(this->OfPoints, i, i, this->Placement.Linear, glm::dmat3(1.0));
        }
      });
  }

  // A piece moves as the mean of its ends, and rotates with their difference across it.
  void MovePiece(std::size_t i, const Piece& piece)
  {
    const vtkIdType first = piece.First->Point, last = piece.Last->Point;
    rtg::GlyphMotion& motion = this->Instances.motion;
    if (!this->OfPoints.velocities.empty())
    {
      const glm::dvec3 a(this->OfPoints.velocities[first]), b(this->OfPoints.velocities[last]);
      const glm::dvec3 way = piece.Last->Place - piece.First->Place;
      motion.velocities[i] = glm::vec3(0.5 * (a + b));
      motion.angularVelocities[i] = glm::vec3(glm::cross(way, b - a) / glm::dot(way, way));
    }
    if (!this->OfPoints.accelerations.empty())
    {
      motion.accelerations[i] = 0.5f * (this->OfPoints.accelerations[first] + this->OfPoints.accelerations[last]);
    }
  }

  void ReportMessages()
  {
    this->Out.Messages = this->Motion.Messages();
    rtglyphs::RayTracedBlocks::ReportMissing(
      this->Lines, this->How.RadiusArray, this->Hidden, "TubeRadiusArray", "have no tubes", this->Out.Messages);
    rtglyphs::GlyphMotion::ReportMissing(this->Lines, this->How.Motion, this->Hidden, this->Out.Messages);
    if (!rtglyphs::RayTracedArrays::IsNone(this->How.RadiusArray) && !this->Radii && !this->RankLacksRadii)
    {
      this->Out.Messages.push_back("There is no array '" + this->How.RadiusArray +
        "' of one to three, six or nine components that has a value for each point or cell of the lines, so all tubes "
        "have the "
        "radius "
        "TubeRadius. Choose a point or cell array as TubeRadiusArray.");
    }
    if (!this->Placement.Uniform && this->Ellipsoids.empty())
    {
      this->Out.Messages.emplace_back("The display is scaled differently along its axes, which tubes can follow only "
                                      "approximately: they stay round. Transform the data instead, or use one scale.");
    }
    const std::size_t shown = this->Instances.Count();
    if (this->Out.Bad > 0)
    {
      this->Out.Messages.push_back(std::to_string(this->Out.Bad) + " of " +
        std::to_string(this->Out.Bad + this->Out.Empty + shown) +
        " pieces of lines are not shown: an end's position, motion or radius is not finite, a radius or an eigenvalue "
        "of a covariance is negative, or the line has no two different points. Remove these points or cells, for "
        "example with Threshold.");
    }
    else if (shown == 0 && this->Out.Empty > 0)
    {
      this->Out.Messages.push_back(
        "No tube is shown: all radii are zero. Choose another TubeRadius or TubeRadiusArray.");
    }
    else if (this->Lines->GetNumberOfLines() == 0 && this->Lines->GetNumberOfPoints() > 0)
    {
      this->Out.Messages.emplace_back("The data have no lines to show as tubes; vertices and polygons are left out. "
                                      "Choose another representation, or make lines with a filter such as Stream "
                                      "Tracer, Feature Edges or Contour.");
    }
  }

  vtkPolyData* Lines;
  const rtglyphs::RayTracedRanges& Hidden;
  const Settings& How;
  const rtglyphs::GlyphMotion Motion;
  rtg::GlyphMotion OfPoints;
  bool RadiiOfCells = false;
  vtkDataArray* Radii;
  const rtglyphs::RayTracedRanges& MissingRadii; // points, or cells
  const bool RankLacksRadii;
  std::vector<std::pair<rtg::SymmetricTensor, double>> Ellipsoids; // of points, or cells; none: tubes are round
  rtglyphs::RayTracedTubeBuilder::Result Out;
};
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::RayTracedTubeBuilder::RadiusArray(vtkPolyData* lines, const Settings& settings, bool& ofCells)
{
  ofCells = false;
  if (rtglyphs::RayTracedArrays::IsNone(settings.RadiusArray))
  {
    return nullptr;
  }
  const auto fits = [](vtkDataArray* array, vtkIdType count)
  {
    const int components = array ? array->GetNumberOfComponents() : 0;
    const bool known = (components >= 1 && components <= 3) || components == 6 || components == 9;
    return known && array->GetNumberOfTuples() == count ? array : nullptr;
  };
  vtkDataArray* found = fits(lines->GetPointData()->GetArray(settings.RadiusArray.c_str()), lines->GetNumberOfPoints());
  if (!found)
  {
    found = fits(lines->GetCellData()->GetArray(settings.RadiusArray.c_str()), lines->GetNumberOfCells());
    ofCells = found != nullptr;
  }
  return found;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedTubeBuilder::Result rtglyphs::RayTracedTubeBuilder::Build(
  vtkPolyData* lines, const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, const Settings& settings)
{
  if (!lines->GetPoints() || lines->GetNumberOfPoints() == 0)
  {
    Result nothing;
    nothing.Instances.shape = rtg::Shape::RoundCone;
    return nothing;
  }
  return Builder(lines, hidden, modelToWorld, settings).Make();
}
