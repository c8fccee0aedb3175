// Other ways to intersect a superquadric, in plain arithmetic: the rivals of Kernels/Shapes/Superquadric.glsl in
// SuperquadricSolvers. Each finds the first crossing at or behind tMin, in the frame of the half-lengths.
#pragma once

#include "Shapes/Shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace benchmark
{

template <class Real>
struct Rivals
{
  using K = rtg::shapes::Kernel<Real>;
  using Vector = glm::vec<3, Real>;
  using GlyphRay = typename K::GlyphRay;
  using Glyph = typename K::Glyph;
  using Probe = typename K::SuperquadricProbe;

  /// What a solver returns; the normal only when it is asked for.
  struct Hit
  {
    bool found = false;
    Real t = 0;
    Vector normal{ 0 };
  };

  /// The ray in the glyph's frame, and the part of it to search.
  struct Frame
  {
    typename K::Chord chord;
    typename K::SuperquadricField field;
    Real low, high;
    Real tolerance; ///< of s
    Probe At(Real s) const { return K::ProbeAt(this->field, K::Word(s), -1); }
    Probe NextCusp(const Probe& after) const
    {
      int axis;
      const auto s = K::NextBreak(this->field, after.where, axis);
      return K::ProbeAt(this->field, s, axis);
    }
  };

  static constexpr Real roundoff = std::numeric_limits<Real>::epsilon() / 2;
  static constexpr Real small = 8 * roundoff; ///< f is zero if it is less

  static bool Enter(const GlyphRay& ray, const Glyph& glyph, Real tMin, Frame& frame)
  {
    if (!K::ToChord(ray, glyph, tMin, Real(1e30), frame.chord))
    {
      return false;
    }
    frame.field = K::MakeSuperquadricField(frame.chord, glyph.exponents);
    frame.low = std::max(frame.chord.sIn, (tMin - frame.chord.ray.start.hi) / frame.chord.scale);
    frame.high = frame.chord.sOut;
    frame.tolerance = roundoff * (frame.chord.sOut - frame.chord.sIn);
    return frame.low < frame.high;
  }

  static Hit At(const Frame& frame, const Glyph& glyph, bool normal, Real s)
  {
    Hit hit;
    hit.found = true;
    hit.t = K::RayParameter(frame.chord.ray, K::Word(frame.chord.scale * s)).hi;
    if (!normal)
    {
      return hit;
    }
    Vector gradient = frame.At(s).slopes / frame.field.direction;
    for (int i = 0; i < 3; ++i)
    {
      gradient[i] = std::isfinite(gradient[i]) ? gradient[i] / glyph.size[i] : 0;
    }
    const Real largest = std::max({ std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z) });
    hit.normal = glm::normalize(K::RotateToWorld(glyph, gradient / largest));
    return hit;
  }

  // ---- a bracket is known ----

  /// Illinois: regula falsi that halves the value of an end that stays.
  static Real Illinois(const Frame& frame, Real a, Real fa, Real b, Real fb)
  {
    for (int i = 0; i < 60 && std::abs(b - a) > frame.tolerance; ++i)
    {
      const Real s = (a * fb - b * fa) / (fb - fa);
      const Real f = frame.At(s).f;
      if (f == 0 || !(std::min(a, b) <= s && s <= std::max(a, b)))
      {
        return s;
      }
      if ((f < 0) != (fb < 0))
      {
        a = b;
        fa = fb;
      }
      else
      {
        fa /= 2;
      }
      b = s;
      fb = f;
    }
    return b;
  }

  /// ITP (Oliveira, Takahashi: An enhancement of the bisection method average performance preserving minmax
  /// optimality, ACM TOMS 47(1), 2021), with kappa1 = 0.2 / (b - a), kappa2 = 2, n0 = 1.
  static Real Itp(const Frame& frame, Real a, Real fa, Real b, Real fb)
  {
    const Real sign = fa < 0 ? Real(1) : Real(-1);
    const Real epsilon = frame.tolerance;
    const Real kappa = Real(0.2) / (b - a);
    const int most = int(std::ceil(std::log2((b - a) / (2 * epsilon)))) + 1;
    for (int i = 0; i < most && b - a > 2 * epsilon; ++i)
    {
      const Real middle = (a + b) / 2;
      const Real radius = std::ldexp(epsilon, most - i) - (b - a) / 2;
      const Real falsi = (fb * a - fa * b) / (fb - fa);
      const Real side = middle < falsi ? Real(-1) : Real(1);
      const Real delta = kappa * (b - a) * (b - a);
      const Real truncated = delta <= std::abs(middle - falsi) ? falsi + side * delta : middle;
      const Real s = std::abs(truncated - middle) <= radius ? truncated : middle - side * radius;
      const Real f = frame.At(s).f;
      if (f == 0)
      {
        return s;
      }
      if (sign * f > 0)
      {
        b = s;
        fb = f;
      }
      else
      {
        a = s;
        fa = f;
      }
    }
    return (a + b) / 2;
  }

  // ---- convex glyphs ----

  static Hit ConvexNewton(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    const bool inside = frame.At(frame.low).f < 0;
    const Real forwards = inside ? Real(-1) : Real(1);
    Real s = inside ? frame.high : frame.low;
    for (int i = 0; i < 64; ++i)
    {
      const Probe probe = frame.At(s);
      const Real slope = probe.slope;
      if (probe.f <= small)
      {
        return At(frame, glyph, normal, s);
      }
      if (!(forwards * slope < 0))
      {
        return {};
      }
      s -= probe.f / slope;
      if (s > frame.high)
      {
        return {};
      }
    }
    return At(frame, glyph, normal, s);
  }

  /// A bracket by halving where f is least, then `solve`.
  template <class Solve>
  static Hit ConvexBracket(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal, Solve solve)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    const Real fLow = frame.At(frame.low).f;
    if (fLow < 0)
    {
      return At(frame, glyph, normal, solve(frame, frame.low, fLow, frame.high, frame.At(frame.high).f));
    }
    Real a = frame.low, b = frame.high;
    for (int i = 0; i < 40 && b - a > frame.tolerance; ++i)
    {
      const Real s = (a + b) / 2;
      const Probe probe = frame.At(s);
      if (probe.f < 0)
      {
        return At(frame, glyph, normal, solve(frame, frame.low, fLow, s, probe.f));
      }
      (probe.slope < 0 ? a : b) = s;
    }
    return {};
  }

  static Hit ConvexIllinois(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    return ConvexBracket(ray, glyph, tMin, normal, Illinois);
  }

  static Hit ConvexItp(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    return ConvexBracket(ray, glyph, tMin, normal, Itp);
  }

  /// Steps of f over a bound of |f'|: what sphere tracing does.
  static Hit ConvexLipschitz(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    const Probe first = frame.At(frame.low), last = frame.At(frame.high);
    const bool inside = first.f < 0;
    const Real bound = std::max(std::abs(first.slope), std::abs(last.slope));
    Real s = frame.low;
    for (int i = 0; i < 4096 && s <= frame.high; ++i)
    {
      const Real f = inside ? -frame.At(s).f : frame.At(s).f;
      if (f <= small)
      {
        return At(frame, glyph, normal, s);
      }
      s += std::max(f / bound, frame.tolerance);
    }
    return {};
  }

  // ---- any glyph ----

  /// Signs at 64 points, then Illinois: misses what is thinner than the spacing.
  static Hit Samples(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    Real a = frame.low, fa = frame.At(a).f;
    for (int i = 1; i <= 64; ++i)
    {
      const Real b = frame.low + (frame.high - frame.low) * Real(i) / 64;
      const Real fb = frame.At(b).f;
      if ((fa < 0) != (fb < 0))
      {
        return At(frame, glyph, normal, Illinois(frame, a, fa, b, fb));
      }
      a = b;
      fa = fb;
    }
    return {};
  }

  /// Interval bisection: between the planes every term and every slope is monotone.
  static Hit Intervals(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    std::vector<Real> ends = { frame.low, frame.high };
    for (int i = 0; i < 3; ++i)
    {
      const Real zero = frame.field.zero[i];
      if (frame.field.base[i] == 0 && zero > frame.low && zero < frame.high)
      {
        ends.push_back(zero);
      }
    }
    std::sort(ends.begin(), ends.end(), std::greater<Real>());
    // Intervals still to look at, the nearest last.
    std::vector<std::pair<Probe, Probe>> stack;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      stack.emplace_back(frame.At(ends[i + 1]), frame.At(ends[i]));
    }
    for (int i = 0; i < 2000 && !stack.empty(); ++i)
    {
      const auto [a, b] = stack.back();
      stack.pop_back();
      Real low = -1, high = -1, slopeLow = 0, slopeHigh = 0;
      for (int k = 0; k < 3; ++k)
      {
        const Real cusp = Real(1e30);
        const Real slopeB = b.slopes[k] >= cusp ? -cusp : b.slopes[k];
        low += std::min(a.terms[k], b.terms[k]);
        high += std::max(a.terms[k], b.terms[k]);
        slopeLow += std::min(a.slopes[k], slopeB);
        slopeHigh += std::max(a.slopes[k], slopeB);
      }
      if (low > 0 || high < 0)
      {
        continue;
      }
      const bool changes = (a.f < 0) != (b.f < 0);
      if (slopeLow >= 0 || slopeHigh <= 0 || !(b.where.hi - a.where.hi > 4 * frame.tolerance))
      {
        if (changes)
        {
          return At(frame, glyph, normal, Illinois(frame, a.where.hi, a.f, b.where.hi, b.f));
        }
        continue;
      }
      const Probe middle = frame.At((a.where.hi + b.where.hi) / 2);
      stack.emplace_back(middle, b);
      stack.emplace_back(a, middle);
    }
    return {};
  }

  /// Steps to where the straight line below f is zero: never passes a crossing, gains on it slowly.
  static Hit LineStepping(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, tMin, frame))
    {
      return {};
    }
    Probe a = frame.At(frame.low);
    const Real outward = a.f < 0 ? Real(-1) : Real(1);
    Probe b = frame.NextCusp(a);
    for (int i = 0; i < 2000; ++i)
    {
      if (outward * a.f <= small)
      {
        return At(frame, glyph, normal, a.where.hi);
      }
      const Real width = b.where.hi - a.where.hi;
      const auto window = K::WindowOf(frame.field, a, b, outward, width);
      const Real left = a.where.hi + (window.slopeA < 0 ? -outward * a.f / window.slopeA : width);
      if (!(left < b.where.hi))
      {
        if (outward * b.f <= 0)
        {
          return At(frame, glyph, normal, b.where.hi);
        }
        if (!(b.where.hi < frame.high))
        {
          return {};
        }
        a = b;
        b = frame.NextCusp(a);
        continue;
      }
      a = frame.At(std::max(left, a.where.hi + frame.tolerance));
    }
    return At(frame, glyph, normal, a.where.hi);
  }

  /// The plugin's solver without its last steps in double words.
  static Hit PluginPlain(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Frame frame;
    if (!Enter(ray, glyph, Real(-1e30), frame))
    {
      return {};
    }
    auto search = K::StartSearch(frame.field, frame.chord);
    while (K::NextRoot(frame.field, frame.chord, search, search))
    {
      const Probe probe = frame.At(search.a.where.hi + search.near);
      const Real step = std::clamp(-probe.f / probe.slope, search.low - search.near, search.high - search.near);
      const Hit hit = At(frame, glyph, normal, probe.where.hi + (std::isnan(step) ? Real(0) : step));
      if (search.a.outside != search.b.outside && hit.t >= tMin)
      {
        return hit;
      }
      search = K::NextWindow(search);
    }
    return {};
  }

  /// The plugin's solver.
  static Hit Plugin(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    Hit hit;
    const auto own = K::IntersectSuperquadric(ray, glyph, tMin, Real(1e30), normal);
    hit.found = own.found;
    hit.t = own.t;
    hit.normal = own.normal;
    return hit;
  }

  // ---- the baseline ----

  /// Newton damped by 0.5 for 50 steps from the proxy's entry, with a stop on one side only. As published, `faithful`:
  /// one exponent in the gradient and no half-lengths; else the right gradient.
  template <bool faithful>
  static Hit Damped(const GlyphRay& ray, const Glyph& glyph, Real tMin, bool normal)
  {
    const Vector halfSize = Real(0.5) * glyph.size;
    const Vector o = K::RotateToLocal(glyph, ray.origin - glyph.center) / halfSize;
    const Vector worldD = K::RotateToLocal(glyph, ray.direction);
    const Vector d = worldD / halfSize;
    Real in = tMin, out = Real(1e30);
    for (int i = 0; i < 3; ++i)
    {
      const Real a = (-1 - o[i]) / d[i], b = (1 - o[i]) / d[i];
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    if (!(in < out))
    {
      return {};
    }
    const Vector e = glyph.exponents;
    Real t = in;
    Hit hit;
    for (int i = 0; i < 50; ++i)
    {
      const Vector p = o + t * d;
      Real f = -1;
      Vector gradient;
      for (int k = 0; k < 3; ++k)
      {
        const Real a = std::max(std::abs(p[k]), Real(1e-20));
        const Real g = faithful ? e.x : e[k];
        f += std::pow(a, e[k]);
        gradient[k] = std::copysign(g * std::pow(a, g - 1), p[k]);
      }
      if (f < Real(1e-4))
      {
        hit.found = true;
        hit.t = t;
        hit.normal =
          normal ? glm::normalize(K::RotateToWorld(glyph, faithful ? gradient : gradient / halfSize)) : Vector(0);
        return hit;
      }
      t -= Real(0.5) * f / glm::dot(gradient, faithful ? worldD : d);
      if (!(t >= in && t <= out))
      {
        return hit;
      }
    }
    return hit;
  }
};

} // namespace benchmark
