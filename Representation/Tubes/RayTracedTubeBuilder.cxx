#include "RayTracedTubeBuilder.h"

#include "Finite.h"
#include "GlyphPlacement.h"
#include "GlyphTensors.h"
#include "RayTracedArrays.h"
#include "RayTracedBlocks.h"
#include "RayTracedParallel.h"
#include "SweptEllipsoid.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace
{
using Settings = rtglyphs::RayTracedTubeBuilder::Settings;

constexpr vtkIdType freeEnd = -1;

// A piece of a line between two of its points, and the points before and after it on the line.
struct Piece
{
  vtkIdType Cell;
  std::array<vtkIdType, 2> Ends;
  std::array<vtkIdType, 2> Beyond; // or freeEnd
};

class Builder
{
public:
  Builder(
    vtkPolyData* lines, const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, const Settings& settings)
    : Lines(lines)
    , Hidden(hidden)
    , How(settings)
    , Placement(modelToWorld)
    , Motion(lines, WithoutTurns(settings.Motion))
    , Positions(lines->GetPoints()->GetData())
    , Radii(rtglyphs::RayTracedTubeBuilder::RadiusArray(lines, settings, this->RadiiOfCells))
    , LackingRadii(rtglyphs::RayTracedBlocks::Lacking(this->Radii))
    , RankLacksRadii(!this->Radii && rtglyphs::RayTracedBlocks::IsElsewhere(lines, settings.RadiusArray))
  {
    const double determinant = std::abs(glm::determinant(this->Placement.Linear));
    this->Factor =
      std::abs(settings.Radius) * (this->Placement.Uniform ? std::abs(this->Placement.Scale) : std::cbrt(determinant));
  }

  rtglyphs::RayTracedTubeBuilder::Result Build()
  {
    this->FindPlaces();
    if (this->Radii && this->Radii->GetNumberOfComponents() > 3)
    {
      this->FindEllipsoids();
    }
    this->FindPieces();
    this->Place();
    this->ReportMessages();
    return std::move(this->Out);
  }

private:
  static rtglyphs::GlyphMotion::Settings WithoutTurns(rtglyphs::GlyphMotion::Settings settings)
  {
    settings.AngularVelocity.clear(); // points do not rotate
    return settings;
  }

  // Of the points in the world, relative to the middle.
  void FindPlaces()
  {
    const vtkIdType count = this->Positions->GetNumberOfTuples();
    this->Places.resize(count);
    const rtg::DoubleBox box = rtglyphs::RayTracedParallel::BoxOf(count,
      [&](vtkIdType begin, vtkIdType end, rtg::DoubleBox& own)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Places[i] = this->Placement({ this->Positions->GetComponent(i, 0), this->Positions->GetComponent(i, 1),
            this->Positions->GetComponent(i, 2) });
          if (rtg::IsFiniteInFloat(this->Places[i]))
          {
            own.Include({ this->Places[i], this->Places[i] });
          }
        }
      });
    const glm::dvec3 middle = box.Empty() ? glm::dvec3(0.0) : 0.5 * (box.lower + box.upper);
    this->Out.Instances.origin = middle;
    this->Extent = box.Empty() ? 0.0 : glm::length(box.upper - middle);
    rtglyphs::RayTracedParallel::ForEach(count, [&](vtkIdType i) { this->Places[i] -= middle; });
  }

  // Of the covariances in the world, and their largest half-axes: negative if a matrix has no root.
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

  double Radius(vtkIdType point, vtkIdType cell) const
  {
    const vtkIdType tuple = this->RadiiOfCells ? cell : point;
    if (!this->Ellipsoids.empty())
    {
      return this->Ellipsoids[tuple].second;
    }
    double value[3] = { 1.0, 0.0, 0.0 };
    if (this->Radii)
    {
      this->Radii->GetTuple(tuple, value);
    }
    return this->Factor *
      (this->Radii && this->Radii->GetNumberOfComponents() > 1
          ? vtkMath::Norm(value, this->Radii->GetNumberOfComponents())
          : value[0]);
  }

  bool IsGood(vtkIdType point, vtkIdType cell) const
  {
    const double radius = this->Radius(point, cell);
    return rtg::IsFiniteInFloat(this->Places[point]) && std::isfinite(static_cast<float>(radius)) && radius >= 0.0 &&
      this->Motion.IsFinite(point);
  }

  void FindPieces()
  {
    vtkIdType cell = this->Lines->GetNumberOfVerts();
    auto iterator = vtk::TakeSmartPointer(this->Lines->GetLines()->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      iterator->GetCurrentCell(size, points);
      if (size > 0 && !this->Hidden.Has(points[0]) && !this->RankLacksRadii &&
        !this->LackingRadii.Has(this->RadiiOfCells ? cell : points[0]))
      {
        this->AddLine(cell, size, points);
      }
    }
  }

  // Points that lie on the one before add nothing; where one is bad the line is interrupted.
  void AddLine(vtkIdType cell, vtkIdType size, const vtkIdType* points)
  {
    this->Line.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      const bool good = this->IsGood(points[i], cell);
      if (!good || this->Line.empty() || this->Line.back() < 0 ||
        glm::vec3(this->Places[points[i]] - this->Places[this->Line.back()]) != glm::vec3(0.0f))
      {
        this->Line.push_back(good ? points[i] : freeEnd);
      }
    }
    if (this->Line.size() < 2)
    {
      ++this->Out.Bad;
      return;
    }
    const bool closed = this->Line.size() > 2 && this->Line.front() >= 0 && this->Line.back() >= 0 &&
      this->Places[this->Line.front()] == this->Places[this->Line.back()];
    if (this->How.FlatEnds && this->Ellipsoids.empty())
    {
      this->StraightenEnds(cell, closed);
    }
    if (!this->Motion.On() && this->Ellipsoids.empty())
    {
      this->Thin(cell);
    }
    const std::size_t count = this->Line.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
    {
      const std::array<vtkIdType, 2> ends{ this->Line[i], this->Line[i + 1] };
      if (ends[0] < 0 || ends[1] < 0)
      {
        ++this->Out.Bad;
      }
      else if (!(this->Radius(ends[0], cell) > 0.0) && !(this->Radius(ends[1], cell) > 0.0))
      {
        ++this->Out.Empty;
      }
      else
      {
        const vtkIdType before = i > 0 ? this->Line[i - 1] : closed ? this->Line[count - 2] : freeEnd;
        const vtkIdType after = i + 2 < count ? this->Line[i + 2] : closed ? this->Line[1] : freeEnd;
        this->Pieces.push_back({ cell, ends, { before, after } });
      }
    }
  }

  // Leaves out points of which the tube through their neighbors shows nothing: a ray meets all balls of a tube whose
  // pieces are much shorter than its radius.
  void Thin(vtkIdType cell)
  {
    constexpr double longest = 0.25, tolerance = 1e-3; // in radii
    std::vector<vtkIdType> kept;
    for (std::size_t i = 0; i < this->Line.size();)
    {
      kept.push_back(this->Line[i]);
      std::size_t next = i + 1;
      while (
        next + 1 < this->Line.size() && this->Line[i] >= 0 && this->IsStraight(cell, i, next + 1, longest, tolerance))
      {
        ++next;
      }
      i = next;
    }
    this->Line = std::move(kept);
  }

  // Whether the points of the line between two are those of the tube between these.
  bool IsStraight(vtkIdType cell, std::size_t first, std::size_t last, double longest, double tolerance) const
  {
    if (this->Line[last] < 0)
    {
      return false;
    }
    const glm::dvec3 begin = this->Places[this->Line[first]], way = this->Places[this->Line[last]] - begin;
    const double from = this->Radius(this->Line[first], cell), to = this->Radius(this->Line[last], cell);
    const double length = glm::length(way), least = std::min(from, to);
    if (!(length > 0.0) || !(length < longest * least))
    {
      return false;
    }
    for (std::size_t i = first + 1; i < last; ++i)
    {
      const vtkIdType point = this->Line[i];
      if (point < 0)
      {
        return false;
      }
      const glm::dvec3 apart = this->Places[point] - begin;
      const double along = glm::dot(apart, way) / (length * length);
      if (along < 0.0 || along > 1.0 || glm::length(apart - along * way) > tolerance * least ||
        std::abs(this->Radius(point, cell) - (from + along * (to - from))) > tolerance * least)
      {
        return false;
      }
    }
    return true;
  }

  // Leaves out the points whose balls would stick out of a flat end.
  void StraightenEnds(vtkIdType cell, bool closed)
  {
    const auto trim = [&](std::vector<vtkIdType>& run)
    {
      const auto sticksOut = [&](vtkIdType point, vtkIdType end)
      { return glm::distance(this->Places[point], this->Places[end]) < this->Radius(point, cell); };
      std::size_t first = 1, last = run.size() - 1;
      while (first < last && sticksOut(run[first], run.front()))
      {
        ++first;
      }
      while (last > first && sticksOut(run[last - 1], run.back()))
      {
        --last;
      }
      run.erase(run.begin() + last, run.end() - 1);
      run.erase(run.begin() + 1, run.begin() + first);
    };
    std::vector<vtkIdType> trimmed, run;
    const auto finish = [&]
    {
      if (run.size() > 2 && !closed)
      {
        trim(run);
      }
      trimmed.insert(trimmed.end(), run.begin(), run.end());
      run.clear();
    };
    for (vtkIdType point : this->Line)
    {
      if (point < 0)
      {
        finish();
        trimmed.push_back(point);
      }
      else
      {
        run.push_back(point);
      }
    }
    finish();
    this->Line = std::move(trimmed);
  }

  void Place()
  {
    rtg::GlyphInstances& all = this->Out.Instances;
    const std::size_t count = this->Pieces.size();
    const bool swept = !this->Ellipsoids.empty();
    all.shape = swept ? rtg::Shape::SweptEllipsoid : rtg::Shape::RoundCone;
    all.centers.resize(count);
    all.sizes3.resize(count);
    all.rotations.resize(count);
    const bool ends = swept || this->How.FlatEnds || this->How.Joined;
    all.before.resize(ends ? count : 0);
    all.after.resize(ends ? count : 0);
    all.exponents3.resize(swept ? count : 0);
    all.polynomials.width = swept && this->How.Joined ? rtg::valuesOfNextSweeps : 0;
    all.polynomials.values.resize(count * all.polynomials.width);
    this->Out.Cells.resize(count);
    this->Out.Ends.resize(count);
    rtg::GlyphMotion ofPoints;
    this->StoreMotion(ofPoints);
    all.motion.velocities.resize(ofPoints.velocities.empty() ? 0 : count);
    all.motion.angularVelocities.resize(ofPoints.velocities.empty() ? 0 : count);
    all.motion.accelerations.resize(ofPoints.accelerations.empty() ? 0 : count);
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(count),
      [&](vtkIdType i)
      {
        this->Ellipsoids.empty() ? this->PlacePiece(i) : this->PlaceSweep(i);
        this->MovePiece(i, ofPoints);
      });
    this->Motion.Finish(all.motion);
    this->StoreLowParts();
  }

  void PlacePiece(vtkIdType i)
  {
    const Piece& piece = this->Pieces[i];
    rtg::GlyphInstances& all = this->Out.Instances;
    const glm::dvec3 first = this->Places[piece.Ends[0]], last = this->Places[piece.Ends[1]];
    const glm::dvec3 center = 0.5 * (first + last), way = last - first;
    const double length = glm::length(way);
    const glm::dvec3 axis = way / length;
    // The shortest rotation from x to the axis.
    glm::dquat turn(1.0 + axis.x, 0.0, -axis.z, axis.y);
    turn = axis.x > -1.0 + 1e-12 ? glm::normalize(turn) : glm::dquat(0.0, 0.0, 1.0, 0.0);
    all.centers[i] = glm::vec3(center);
    all.sizes3[i] =
      glm::vec3(length, 2.0 * this->Radius(piece.Ends[0], piece.Cell), 2.0 * this->Radius(piece.Ends[1], piece.Cell));
    all.rotations[i] = glm::vec4(turn.x, turn.y, turn.z, turn.w);
    if (!all.before.empty())
    {
      const glm::dquat back = glm::conjugate(turn);
      const auto joint = [&](vtkIdType beyond)
      {
        const double radius = beyond < 0 ? 0.0 : this->Radius(beyond, piece.Cell);
        if (beyond < 0)
        {
          return glm::vec4(0.0f, 0.0f, 0.0f, this->How.FlatEnds ? -1.0f : 0.0f);
        }
        return this->How.Joined ? glm::vec4(glm::vec3(back * (this->Places[beyond] - center)), float(radius))
                                : glm::vec4(0.0f);
      };
      all.before[i] = joint(piece.Beyond[0]);
      all.after[i] = joint(piece.Beyond[1]);
    }
    this->Out.Cells[i] = piece.Cell;
    this->Out.Ends[i] = piece.Ends;
  }

  void PlaceSweep(vtkIdType i)
  {
    const Piece& piece = this->Pieces[i];
    const auto end = [&](vtkIdType point)
    {
      return point < 0
        ? std::optional<rtg::SweepEnd>()
        : rtg::SweepEnd{ this->Places[point], this->Ellipsoids[this->RadiiOfCells ? piece.Cell : point].first };
    };
    rtg::StoreSweep(
      *end(piece.Ends[0]), *end(piece.Ends[1]), i, this->Out.Instances, end(piece.Beyond[0]), end(piece.Beyond[1]));
    this->Out.Cells[i] = piece.Cell;
    this->Out.Ends[i] = piece.Ends;
  }

  void StoreMotion(rtg::GlyphMotion& motion) const
  {
    if (!this->Motion.On())
    {
      return;
    }
    this->Motion.Allocate(motion, this->Places.size());
    rtglyphs::RayTracedParallel::ForChunks(static_cast<vtkIdType>(this->Places.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          if (this->Motion.IsFinite(i))
          {
            this->Motion.Store(motion, i, i, this->Placement.Linear, glm::dmat3(1.0));
          }
        }
      });
  }

  // A piece moves as the mean of its ends, and rotates with their difference across it.
  void MovePiece(vtkIdType i, const rtg::GlyphMotion& ofPoints)
  {
    const auto [first, last] = this->Pieces[i].Ends;
    rtg::GlyphMotion& motion = this->Out.Instances.motion;
    if (!ofPoints.velocities.empty())
    {
      const glm::dvec3 a(ofPoints.velocities[first]), b(ofPoints.velocities[last]);
      const glm::dvec3 way = this->Places[last] - this->Places[first];
      motion.velocities[i] = glm::vec3(0.5 * (a + b));
      motion.angularVelocities[i] = glm::vec3(glm::cross(way, b - a) / glm::dot(way, way));
    }
    if (!ofPoints.accelerations.empty())
    {
      motion.accelerations[i] = 0.5f * (ofPoints.accelerations[first] + ofPoints.accelerations[last]);
    }
  }

  // Where a float is not right to 1e-6 of the thinnest tube's diameter.
  void StoreLowParts()
  {
    rtg::GlyphInstances& all = this->Out.Instances;
    float thinnest = HUGE_VALF;
    for (const glm::vec3& size : all.sizes3)
    {
      thinnest = std::min(thinnest, std::max(size.y, size.z));
    }
    if (!(std::ldexp(this->Extent, -24) > 1e-6 * thinnest))
    {
      return;
    }
    all.centersLow.resize(all.centers.size());
    for (std::size_t i = 0; i < all.centers.size(); ++i)
    {
      const auto [first, last] = this->Pieces[i].Ends;
      all.centersLow[i] = glm::vec3(0.5 * (this->Places[first] + this->Places[last]) - glm::dvec3(all.centers[i]));
    }
  }

  void ReportMessages()
  {
    this->Out.Messages = this->Motion.Messages();
    rtglyphs::RayTracedBlocks::ReportLacking(
      this->Lines, this->How.RadiusArray, this->Hidden, "TubeRadiusArray", "have no tubes", this->Out.Messages);
    rtglyphs::GlyphMotion::ReportLacking(this->Lines, WithoutTurns(this->How.Motion), this->Hidden, this->Out.Messages);
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
    const std::size_t shown = this->Pieces.size();
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
  const rtglyphs::GlyphPlacement Placement;
  const rtglyphs::GlyphMotion Motion;
  vtkDataArray* Positions;
  bool RadiiOfCells = false;
  vtkDataArray* Radii;
  const rtglyphs::RayTracedRanges& LackingRadii; // points, or cells
  const bool RankLacksRadii;
  double Factor = 1.0; // of radii
  double Extent = 0.0; // of places
  std::vector<glm::dvec3> Places;
  std::vector<std::pair<rtg::SymmetricTensor, double>> Ellipsoids; // of points, or cells; none: tubes are round
  std::vector<vtkIdType> Line;                                     // points of the current line; freeEnd: a bad one
  std::vector<Piece> Pieces;
  rtglyphs::RayTracedTubeBuilder::Result Out;
};
}

//----------------------------------------------------------------------------
Settings rtglyphs::RayTracedTubeBuilder::Settings::Effective() const
{
  Settings effective = *this;
  effective.Motion = this->Motion.Effective();
  effective.Motion.AngularVelocity.clear();
  if (rtglyphs::RayTracedArrays::IsNone(this->RadiusArray))
  {
    effective.RadiusArray.clear();
  }
  return effective;
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
  return Builder(lines, hidden, modelToWorld, settings).Build();
}
