#include "NestedReference.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rtg::testing
{
namespace
{

template <class Real>
Real Log(Real x)
{
  if constexpr (std::is_same_v<Real, Quad>)
  {
    return logq(x);
  }
  else
  {
    return std::log(x);
  }
}

template <class Real>
Real Exp(Real x)
{
  if constexpr (std::is_same_v<Real, Quad>)
  {
    return expq(x);
  }
  else
  {
    return std::exp(x);
  }
}

/// log R(z) of a profile and the derivative -z d(log R)/dz; z in [0, 1).
template <class Real>
Real LogProfile(Real z, Real exponent, Real& fall)
{
  const Real q = 2 / exponent;
  const Real power = z > 0 ? Exp(q * Log(z)) : Real(0);
  // 1 - z^q without cancellation next to 1.
  Real rest = 1 - power;
  if (power > Real(0.5))
  {
    const Real l = q * Log(z);
    // -expm1(l) by its series where l is small
    if (l > Real(-1e-3))
    {
      Real term = -l;
      rest = 0;
      for (int n = 2; n < 16; ++n)
      {
        rest += term;
        term *= l / n;
      }
    }
  }
  fall = power / rest;
  return Log(rest) / q;
}

} // namespace

NestedReference::NestedReference(double alpha, double beta, double c)
  : alpha_(std::max(alpha, double(1e-6f)))
  , beta_(std::max(beta, double(1e-6f)))
  , c_(std::max(c, double(1e-6f)))
{
}

template <class Real>
Real NestedReference::Value(const Real point[3], Real* gradient) const
{
  const Real huge = 1e9;
  Real a[3];
  for (int i = 0; i < 3; ++i)
  {
    a[i] = point[i] < 0 ? -point[i] : point[i];
  }
  if (gradient)
  {
    gradient[0] = gradient[1] = gradient[2] = 0;
  }
  if (a[2] >= 1)
  {
    // A flat end is as close to 1 as the digits go.
    if (gradient)
    {
      gradient[2] = point[2] < 0 ? -1 : 1;
    }
    return huge;
  }
  const Real p = 2 / Real(this->alpha_);
  Real fallX, fallY;
  const Real rx = LogProfile(a[2], Real(this->beta_), fallX);
  const Real ry = this->c_ == this->beta_ ? (fallY = fallX, rx) : LogProfile(a[2], Real(this->c_), fallY);
  const Real x = a[0] > 0 ? Log(a[0]) - rx : -huge, y = a[1] > 0 ? Log(a[1]) - ry : -huge;
  const Real high = x > y ? x : y, low = x > y ? y : x;
  const Real power = Exp(std::max(p * (low - high), Real(-11000)));
  if (gradient)
  {
    const Real highShare = 1 / (1 + power), lowShare = power / (1 + power);
    const Real shareX = x > y ? highShare : lowShare, shareY = x > y ? lowShare : highShare;
    const Real share[3] = { shareX, shareY, shareX * fallX + shareY * fallY };
    for (int i = 0; i < 3; ++i)
    {
      gradient[i] = a[i] > 0 ? share[i] / point[i] : Real(0);
    }
  }
  return high == -huge ? -huge : high + Log(1 + power) / p;
}

NestedReference::Long NestedReference::Along(Long s, Long* slope) const
{
  const Long point[3] = { this->o_[0] + s * this->d_[0], this->o_[1] + s * this->d_[1], this->o_[2] + s * this->d_[2] };
  Long gradient[3];
  const Long value = this->Value(point, slope ? gradient : nullptr);
  if (slope)
  {
    *slope = gradient[0] * this->d_[0] + gradient[1] * this->d_[1] + gradient[2] * this->d_[2];
  }
  return value;
}

/// The zero between two points of different signs.
NestedReference::Long NestedReference::Bisect(Long from, Long to) const
{
  const bool outside = this->Along(from, nullptr) > 0;
  for (int i = 0; i < 200; ++i)
  {
    const Long middle = (from + to) / 2;
    if (middle == from || middle == to)
    {
      break;
    }
    ((this->Along(middle, nullptr) > 0) == outside ? from : to) = middle;
  }
  return (from + to) / 2;
}

/// Convex bodies: N along the line falls, then rises (its sublevel sets are intervals).
void NestedReference::FindConvex(Long from, Long to, std::vector<Long>& roots) const
{
  const Long begin = from, end = to;
  // Where |z| >= 1 there is no slope; both ends are outside anyway.
  for (int i = 0; i < 200 && this->Along((from + to) / 2, nullptr) > 0; ++i)
  {
    const Long middle = (from + to) / 2;
    if (middle == from || middle == to)
    {
      return;
    }
    Long slope;
    if (this->Along(middle, &slope) > Long(1e8))
    {
      slope = (this->o_[2] + middle * this->d_[2]) * this->d_[2];
    }
    (slope < 0 ? from : to) = middle;
  }
  const Long inside = (from + to) / 2;
  if (this->Along(inside, nullptr) <= 0)
  {
    roots.push_back(this->Bisect(begin, inside));
    roots.push_back(this->Bisect(inside, end));
  }
}

void NestedReference::FindPieces(Long from, Long to, std::vector<Long>& roots) const
{
  std::vector<Long> cuts = { from, to };
  for (int i = 0; i < 3; ++i)
  {
    const Long cut = this->d_[i] != 0 ? -this->o_[i] / this->d_[i] : from;
    if (cut > from && cut < to)
    {
      cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    this->Divide(cuts[i], cuts[i + 1], cuts[i], cuts[i + 1], roots);
  }
}

/// In an octant N grows with every coordinate: the smallest and largest ones of a window bound it.
void NestedReference::Divide(Long from, Long to, Long octantFrom, Long octantTo, std::vector<Long>& roots) const
{
  Long least[3], most[3];
  for (int i = 0; i < 3; ++i)
  {
    const Long a = std::abs(this->o_[i] + from * this->d_[i]);
    const Long b = std::abs(this->o_[i] + to * this->d_[i]);
    least[i] = std::min(a, b);
    most[i] = std::max(a, b);
  }
  if (this->Value<Long>(least, nullptr) > 0 || this->Value<Long>(most, nullptr) < 0)
  {
    return;
  }
  const Long toEnd = std::min(to - octantFrom, octantTo - from);
  // As short beside its distance from the octant's ends as no two extrema are.
  if (to - from <= std::max(Long(1e-9), toEnd / 512))
  {
    this->Finish(from, to, roots);
    return;
  }
  const Long middle = (from + to) / 2;
  this->Divide(from, middle, octantFrom, octantTo, roots);
  this->Divide(middle, to, octantFrom, octantTo, roots);
}

/// A window so short that N has at most one extremum in it.
void NestedReference::Finish(Long from, Long to, std::vector<Long>& roots) const
{
  // The slope at the very end of an octant may be infinite.
  const Long nudge = (to - from) * Long(1e-6);
  Long slopeFrom, slopeTo;
  this->Along(from + nudge, &slopeFrom);
  this->Along(to - nudge, &slopeTo);
  const Long a = this->Along(from, nullptr), b = this->Along(to, nullptr);
  if ((slopeFrom < 0) == (slopeTo < 0) || (a > 0) != (b > 0))
  {
    if ((a > 0) != (b > 0))
    {
      roots.push_back(this->Bisect(from, to));
    }
    return;
  }
  Long low = from + nudge, high = to - nudge;
  for (int i = 0; i < 100; ++i)
  {
    const Long middle = (low + high) / 2;
    Long slope;
    if ((this->Along(middle, &slope) > 0) != (a > 0))
    {
      roots.push_back(this->Bisect(from, middle));
      roots.push_back(this->Bisect(middle, to));
      return;
    }
    if (middle == low || middle == high)
    {
      return;
    }
    ((slope < 0) == (slopeFrom < 0) ? low : high) = middle;
  }
}

std::vector<NestedReference::Crossing> NestedReference::Crossings(const Quad o[3], const Quad d[3], bool precise) const
{
  Quad length = 0;
  for (int i = 0; i < 3; ++i)
  {
    length += d[i] * d[i];
  }
  length = sqrtq(length);
  Long from = -4, to = 4;
  for (int i = 0; i < 3; ++i)
  {
    this->o_[i] = Long(o[i]);
    this->d_[i] = Long(d[i] / length);
    // The body's box, a little larger.
    if (this->d_[i] != 0)
    {
      const Long one = Long(1.0000001);
      const Long a = (-one - this->o_[i]) / this->d_[i], b = (one - this->o_[i]) / this->d_[i];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    else if (std::abs(this->o_[i]) > 1)
    {
      return {};
    }
  }
  std::vector<Long> roots;
  if (from < to)
  {
    const bool convex = this->c_ == this->beta_ && this->beta_ <= 2 && this->alpha_ <= 2;
    convex ? this->FindConvex(from, to, roots) : this->FindPieces(from, to, roots);
  }

  std::vector<Crossing> crossings;
  for (const Long root : roots)
  {
    Crossing crossing;
    Quad s = root;
    for (int i = 0; i < (precise ? 4 : 0); ++i)
    {
      Quad point[3], slope = 0;
      for (int k = 0; k < 3; ++k)
      {
        point[k] = o[k] + s * (d[k] / length);
      }
      const Quad value = this->Value(point, crossing.gradient);
      for (int k = 0; k < 3; ++k)
      {
        slope += crossing.gradient[k] * (d[k] / length);
      }
      // Smooth or not, where the curvature of the profile or of the cross-section is infinite.
      crossing.edgeDistance = 1;
      if (this->beta_ > 1 || this->c_ > 1)
      {
        const Quad z = fabsq(point[2]);
        crossing.edgeDistance = std::min(z, 1 - z);
      }
      if (this->alpha_ > 1)
      {
        crossing.edgeDistance = std::min({ crossing.edgeDistance, fabsq(point[0]), fabsq(point[1]) });
      }
      const Quad step = slope != 0 ? -value / slope : Quad(0);
      // Next to the end of the axis the gauge is a quotient of small numbers, on which Newton's method may need longer;
      // the root is that of the bisection then, good for t but not for a normal.
      if (!(fabsq(step) < 1e-20) && (i == 3 || !(fabsq(step) < 1e-9)))
      {
        crossing.edgeDistance = 0;
      }
      if (i == 3 || !(fabsq(step) < 1e-9))
      {
        break;
      }
      s += step;
      if (fabsq(step) < 1e-25)
      {
        i = std::max(i, 2);
      }
    }
    crossing.s = s / length;
    crossings.push_back(crossing);
  }
  return crossings;
}

} // namespace rtg::testing
