// A superquadric's crossings in 113-bit arithmetic by interval bisection: between the planes of its frame every term of
// f = |2x|^r + |2y|^s + |2z|^t - 1, and every term of its derivative, is monotone along the line, so their values at
// the ends of an interval bound f and f' in it. An interval is dropped when f cannot be zero, solved when f' cannot,
// else halved.
#include "Reference.h"

#include <algorithm>
#include <array>

namespace rtg::testing
{
namespace
{

using Three = std::array<Quad, 3>;

/// f and its terms at one point of the line.
struct Point
{
  Quad t;
  Three term, slope; ///< of the terms along the line; infinite at a cusp
  Quad f() const { return this->term[0] + this->term[1] + this->term[2] - 1; }
};

class Line
{
public:
  Line(const Three& origin, const Three& direction, const Three& exponents)
    : origin_(origin)
    , direction_(direction)
    , exponents_(exponents)
  {
  }

  /// `from` is -1 or 1 when the point is the lower or upper end of an interval, for the slope's sign at planes.
  Point At(Quad t, int from) const
  {
    Point point{ t, {}, {} };
    for (int i = 0; i < 3; ++i)
    {
      const Quad e = this->exponents_[i], d = 2 * this->direction_[i];
      // On its plane a coordinate is zero to the last bit.
      const bool onPlane = d != 0 && t == this->Plane(i);
      const Quad p = onPlane ? Quad(0) : 2 * (this->origin_[i] + t * this->direction_[i]);
      point.term[i] = p == 0 ? Quad(0) : powq(fabsq(p), e);
      if (p != 0)
      {
        point.slope[i] = e * point.term[i] / p * d;
      }
      else if (d != 0 && e <= 1)
      {
        point.slope[i] = -from * (e < 1 ? Quad(HUGE_VAL) : fabsq(d));
      }
    }
    return point;
  }

  Quad Plane(int axis) const { return -this->origin_[axis] / this->direction_[axis]; }

  void Isolate(const Point& a, const Point& b, Quad least, std::vector<Quad>& roots) const
  {
    Quad low = -1, high = -1, slopeLow = 0, slopeHigh = 0;
    for (int i = 0; i < 3; ++i)
    {
      low += std::min(a.term[i], b.term[i]);
      high += std::max(a.term[i], b.term[i]);
      slopeLow += std::min(a.slope[i], b.slope[i]);
      slopeHigh += std::max(a.slope[i], b.slope[i]);
    }
    if (low > 0 || high < 0)
    {
      return;
    }
    if (slopeLow >= 0 || slopeHigh <= 0)
    {
      if ((a.f() < 0) != (b.f() < 0))
      {
        roots.push_back(this->Solve(a.t, b.t, a.f() < 0));
      }
      return;
    }
    const Quad middle = (a.t + b.t) / 2;
    if (b.t - a.t < least || !(middle > a.t && middle < b.t))
    {
      if ((a.f() < 0) != (b.f() < 0))
      {
        roots.push_back(middle);
      }
      return;
    }
    this->Isolate(a, this->At(middle, 1), least, roots);
    this->Isolate(this->At(middle, -1), b, least, roots);
  }

private:
  /// The only zero between a and b.
  Quad Solve(Quad a, Quad b, bool rises) const
  {
    Quad t = (a + b) / 2;
    Quad before = b - a;
    for (int i = 0; i < 400 && b - a > 0; ++i)
    {
      const Point point = this->At(t, 0);
      const Quad f = point.f();
      if (f == 0)
      {
        return t;
      }
      ((f < 0) == rises ? a : b) = t;
      const Quad step = f / (point.slope[0] + point.slope[1] + point.slope[2]);
      const Quad newton = t - step;
      if (fabsq(step) < Quad(1e-33) * (1 + fabsq(t)) && newton >= a && newton <= b)
      {
        return newton;
      }
      // Bisection where Newton leaves the bracket or does not gain on it.
      const bool good = newton > a && newton < b && fabsq(step) < before / 2;
      before = good ? fabsq(step) : b - a;
      t = good ? newton : (a + b) / 2;
      if (t == a || t == b)
      {
        return t;
      }
    }
    return t;
  }

  Three origin_, direction_, exponents_;
};

} // namespace

void ReferenceGlyph::MeetSuperquadric(const UnitRay& ray, std::vector<ReferenceCrossing>& crossings) const
{
  const Three o = { ray.origin.x, ray.origin.y, ray.origin.z };
  const Three d = { ray.direction.x, ray.direction.y, ray.direction.z };
  const Three e = { this->exponents_.x, this->exponents_.y, this->exponents_.z };
  const Line line(o, d, e);

  // The chord through the box.
  Quad from = -HUGE_VAL, to = HUGE_VAL;
  const Quad half = Quad(0.5) * (1 + Quad(1e-25));
  for (int i = 0; i < 3; ++i)
  {
    if (d[i] == 0)
    {
      if (fabsq(o[i]) > half)
      {
        return;
      }
      continue;
    }
    const Quad a = (-half - o[i]) / d[i], b = (half - o[i]) / d[i];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to))
  {
    return;
  }

  std::vector<Quad> ends = { from, to };
  for (int i = 0; i < 3; ++i)
  {
    if (d[i] != 0 && line.Plane(i) > from && line.Plane(i) < to)
    {
      ends.push_back(line.Plane(i));
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Quad> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    line.Isolate(line.At(ends[i], -1), line.At(ends[i + 1], 1), Quad(1e-30) * (to - from), roots);
  }

  for (const Quad t : roots)
  {
    Quad normal[3], edge = 1;
    const Point point = line.At(t, 0);
    for (int i = 0; i < 3; ++i)
    {
      const Quad p = o[i] + t * d[i];
      normal[i] = p == 0 ? Quad(0) : e[i] * point.term[i] / p;
      // The normal jumps, or turns infinitely fast, where the surface meets the plane of an axis with e < 2.
      edge = e[i] < 2 ? std::min(edge, fabsq(p)) : edge;
    }
    this->Add(t, { normal[0], normal[1], normal[2] }, edge, crossings);
  }
}

} // namespace rtg::testing
