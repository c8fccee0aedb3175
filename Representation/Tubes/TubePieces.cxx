#include "TubePieces.h"

#include "Finite.h"
#include "Parallel.h"
#include "RayTracedParallel.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using Ball = rtglyphs::TubePieces::Ball;
using Balls = rtglyphs::TubePieces::Balls;

bool IsBad(const Ball& ball)
{
  return ball.Radius < 0.0;
}

// Whether the balls between two are those of the tube between these, none of which is bad.
bool IsStraight(const Ball* first, const Ball* last)
{
  constexpr double longest = 0.25, tolerance = 1e-3; // in radii
  const glm::dvec3 way = last->Place - first->Place;
  const double from = first->Radius, to = last->Radius, length = glm::length(way), least = std::min(from, to);
  return length > 0.0 && length < longest * least && !IsBad(*first) && !IsBad(*last) &&
    std::all_of(first + 1, last,
      [&](const Ball& ball)
      {
        const glm::dvec3 apart = ball.Place - first->Place;
        const double along = glm::dot(apart, way) / (length * length);
        return !IsBad(ball) && along >= 0.0 && along <= 1.0 && glm::length(apart - along * way) <= tolerance * least &&
          std::abs(ball.Radius - (from + along * (to - from))) <= tolerance * least;
      });
}

// Leaves out balls of which the tube through their neighbors shows nothing: a ray meets all balls of a tube whose
// pieces are much shorter than its radius. Steps that double while they fit, and are halved then, look at each ball a
// few times, however many there are.
void Thin(Balls& balls)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < balls.size();)
  {
    std::size_t next = i + 1;
    bool grows = true;
    for (std::size_t step = 1; step > 0;)
    {
      const bool fits = next + step < balls.size() && IsStraight(&balls[i], &balls[next + step]);
      next += fits ? step : 0;
      grows &= fits;
      step = grows ? 2 * step : step / 2;
    }
    balls[kept++] = balls[i];
    i = next;
  }
  balls.resize(kept);
}

// Leaves out the balls that would stick out of a flat end of what lies between bad ones.
void StraightenEnds(Balls& balls)
{
  Balls trimmed, run;
  const auto finish = [&]
  {
    if (run.size() > 2)
    {
      const auto sticksOut = [](const Ball& ball, const Ball& end)
      { return glm::distance(ball.Place, end.Place) < ball.Radius; };
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
    }
    trimmed.insert(trimmed.end(), run.begin(), run.end());
    run.clear();
  };
  for (const Ball& ball : balls)
  {
    if (IsBad(ball))
    {
      finish();
      trimmed.push_back(ball);
    }
    else
    {
      run.push_back(ball);
    }
  }
  finish();
  balls = std::move(trimmed);
}
}

//----------------------------------------------------------------------------
rtglyphs::TubePieces::TubePieces(vtkMatrix4x4* modelToWorld, bool flatEnds, bool joined)
  : Placement(modelToWorld)
  , FlatEnds(flatEnds)
  , Joined(joined)
{
  this->Instances.shape = rtg::Shape::RoundCone;
}

//----------------------------------------------------------------------------
double rtglyphs::TubePieces::Factor() const
{
  return this->Placement.Uniform ? std::abs(this->Placement.Scale)
                                 : std::cbrt(std::abs(glm::determinant(this->Placement.Linear)));
}

//----------------------------------------------------------------------------
void rtglyphs::TubePieces::Build(vtkIdType lines)
{
  constexpr vtkIdType linesOfChunk = 32; // may be long
  rtg::GlyphInstances& all = this->Instances;
  const auto chunks = static_cast<std::size_t>((lines + linesOfChunk - 1) / linesOfChunk);
  const auto forLines = [&](const Use& use)
  {
    rtg::ParallelFor(chunks,
      [&](std::size_t chunk)
      {
        const vtkIdType begin = static_cast<vtkIdType>(chunk) * linesOfChunk;
        this->ForLines(begin, std::min(lines, begin + linesOfChunk), use);
      });
  };
  std::vector<rtg::DoubleBox> boxes(chunks);
  forLines(
    [&](vtkIdType line, const Balls& balls)
    {
      rtg::DoubleBox own;
      for (const Ball& ball : balls)
      {
        if (rtg::IsFiniteInFloat(ball.Place))
        {
          own.Include({ ball.Place, ball.Place });
        }
      }
      boxes[line / linesOfChunk].Include(own);
    });
  rtg::DoubleBox box;
  std::for_each(boxes.begin(), boxes.end(), [&box](const rtg::DoubleBox& own) { box.Include(own); });
  all.origin = box.Empty() ? glm::dvec3(0.0) : 0.5 * (box.lower + box.upper);

  std::vector<std::size_t> starts(lines + 1);
  forLines(
    [&](vtkIdType line, Balls& balls)
    {
      std::size_t count = 0;
      this->Cut(line, balls, [&count](const Piece&) { ++count; });
      starts[line + 1] = count;
    });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  this->Bad = this->Empty = 0; // are counted again
  this->Allocate(starts.back());
  all.centersLow.resize(starts.back());
  forLines(
    [&](vtkIdType line, Balls& balls)
    {
      std::size_t i = starts[line];
      this->Cut(line, balls,
        [&](const Piece& piece)
        {
          this->Place(i, piece);
          all.centersLow[i] = glm::vec3(0.5 * (piece.First->Place + piece.Last->Place) - glm::dvec3(all.centers[i]));
          ++i;
        });
    });
  // Where a float is right to 1e-6 of the thinnest tube's diameter.
  const double extent = box.Empty() ? 0.0 : glm::length(box.upper - all.origin);
  const float thinnest = rtglyphs::RayTracedParallel::Reduce(
    static_cast<vtkIdType>(all.Count()), HUGE_VALF,
    [&](vtkIdType begin, vtkIdType end, float& own)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        own = std::min(own, std::max(all.sizes3[i].y, all.sizes3[i].z));
      }
    },
    [](float& least, float own) { least = std::min(least, own); });
  if (!(std::ldexp(extent, -24) > 1e-6 * thinnest))
  {
    all.centersLow = std::vector<glm::vec3>(); // = {} would keep the memory
  }
}

//----------------------------------------------------------------------------
// Balls that lie on the one before add nothing.
void rtglyphs::TubePieces::Cut(vtkIdType line, Balls& balls, const Found& found)
{
  std::size_t count = 0;
  for (Ball& ball : balls)
  {
    ball.Place -= this->Instances.origin;
    const bool good =
      rtg::IsFiniteInFloat(ball.Place) && std::isfinite(static_cast<float>(ball.Radius)) && ball.Radius >= 0.0;
    ball.Radius = good ? ball.Radius : -1.0;
    if (count == 0 || IsBad(ball) || IsBad(balls[count - 1]) ||
      glm::vec3(ball.Place - balls[count - 1].Place) != glm::vec3(0.0f))
    {
      balls[count++] = ball;
    }
  }
  balls.resize(count);
  if (count < 2)
  {
    ++this->Bad;
    return;
  }
  const bool closed =
    count > 2 && !IsBad(balls.front()) && !IsBad(balls.back()) && balls.front().Place == balls.back().Place;
  const bool swept = this->Instances.shape == rtg::Shape::SweptEllipsoid;
  if (this->FlatEnds && !swept && !closed)
  {
    StraightenEnds(balls);
  }
  if (!this->Moves && !swept)
  {
    Thin(balls);
  }
  count = balls.size();
  const auto good = [&](std::size_t i) { return i < count && !IsBad(balls[i]) ? &balls[i] : nullptr; };
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const Ball *first = good(i), *last = good(i + 1);
    if (!first || !last)
    {
      ++this->Bad;
    }
    else if (!(first->Radius > 0.0) && !(last->Radius > 0.0))
    {
      ++this->Empty;
    }
    else
    {
      const std::size_t before = i > 0 ? i - 1 : closed ? count - 2 : count;
      found({ line, first, last, good(before), good(i + 2 < count || !closed ? i + 2 : 1) });
    }
  }
}

//----------------------------------------------------------------------------
void rtglyphs::TubePieces::Allocate(std::size_t count)
{
  rtg::GlyphInstances& all = this->Instances;
  all.centers.resize(count);
  all.sizes3.resize(count);
  all.rotations.resize(count);
  const bool ends = this->FlatEnds || this->Joined || all.shape == rtg::Shape::SweptEllipsoid;
  all.before.resize(ends ? count : 0);
  all.after.resize(ends ? count : 0);
}

//----------------------------------------------------------------------------
void rtglyphs::TubePieces::Place(std::size_t i, const Piece& piece)
{
  rtg::GlyphInstances& all = this->Instances;
  const glm::dvec3 center = 0.5 * (piece.First->Place + piece.Last->Place),
                   way = piece.Last->Place - piece.First->Place;
  const double length = glm::length(way);
  const glm::dvec3 axis = way / length;
  // The shortest rotation from x to the axis.
  glm::dquat turn(1.0 + axis.x, 0.0, -axis.z, axis.y);
  turn = axis.x > -1.0 + 1e-12 ? glm::normalize(turn) : glm::dquat(0.0, 0.0, 1.0, 0.0);
  all.centers[i] = glm::vec3(center);
  all.sizes3[i] = glm::vec3(length, 2.0 * piece.First->Radius, 2.0 * piece.Last->Radius);
  all.rotations[i] = glm::vec4(turn.x, turn.y, turn.z, turn.w);
  if (!all.before.empty())
  {
    const auto joint = [&](const Ball* beyond)
    {
      if (!beyond)
      {
        return glm::vec4(0.0f, 0.0f, 0.0f, this->FlatEnds ? -1.0f : 0.0f);
      }
      return this->Joined
        ? glm::vec4(glm::vec3(glm::conjugate(turn) * (beyond->Place - center)), static_cast<float>(beyond->Radius))
        : glm::vec4(0.0f);
    };
    all.before[i] = joint(piece.Before);
    all.after[i] = joint(piece.After);
  }
}
