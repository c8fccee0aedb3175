// Rays and convex superquadrics with one profile (NestedSuperquadric.glsl).
//
// beta = c <= 2, alpha <= 2: the gauge g = ||(||(x, y)||_p, z)||_q is a norm, so along the ray it is convex, and
// the surface is g = 1. Newton's method on g - 1 from the ray's entry into the box, where g >= 1, follows tangents
// that lie below g: but for rounding it cannot pass the first crossing. When the slope is no longer
// negative while g > 1, the ray is past its closest point and there is no crossing. Steps are counted; each one at
// least halves the distance to a closest point where the ray only just misses. The exit is found the same way from
// behind.
#ifndef RTG_NESTED_CONVEX
#define RTG_NESTED_CONVEX

#include "NestedWords.glsl"

// The gauge at o + s d, and its slope along the ray.
RTG_FN real2 NestedGauge(NestedForm form, real3 o, real3 d, real s)
{
  real3 v = o + s * d;
  real dx = v.x < real(0.0) ? -d.x : d.x;
  real dy = v.y < real(0.0) ? -d.y : d.y;
  real dz = v.z < real(0.0) ? -d.z : d.z;
  real3 a = abs(v);
  bool xHigh = a.x >= a.y;
  NestedNorm inner = PNorm(max(a.x, a.y), min(a.x, a.y), form.p);
  real dRho = inner.byHigh * (xHigh ? dx : dy) + inner.byLow * (xHigh ? dy : dx);
  bool rhoHigh = inner.value >= a.z;
  NestedNorm outer = PNorm(max(inner.value, a.z), min(inner.value, a.z), form.q);
  real slope = outer.byHigh * (rhoHigh ? dRho : dz) + outer.byLow * (rhoHigh ? dz : dRho);
  return real2(outer.value, slope);
}

// Newton from outside: the first s in [from, to] with g = 1. False: none.
RTG_FN bool NestedNewton(NestedForm form, real3 o, real3 d, real from, real to, RTG_OUT(real) s)
{
  s = from;
  for (int i = 0; i < 48; ++i)
  {
    real2 g = NestedGauge(form, o, d, s);
    real above = g.x - real(1.0);
    if (above <= real(4.0 * RTG_ROUNDOFF))
    {
      return true;
    }
    if (!(g.y < real(0.0)))
    {
      return false;
    }
    real step = -above / g.y;
    s += step;
    if (s > to)
    {
      return false;
    }
    if (step < real(4.0 * RTG_ROUNDOFF))
    {
      return true;
    }
  }
  return true;
}

// The crossing near s where a ray enters a convex glyph, in double words: `at` is the ray with its origin there.
// `reach` is more than the length of its chord through the box. False: there is none.
RTG_FN bool NestedPolish(NestedForm form, LocalRay ray, real s, real reach, RTG_OUT(LocalRay) at)
{
  at = Advance(ray, s);
  LocalRay plain = at;
  int backwards = 0;
  bool stepped = false;
  for (int i = 0; i < 24; ++i)
  {
    NestedPoint point = NestedConvexAt(form, at.origin);
    real steepness;
    real slope = NestedSlope(point, at, steepness);
    real value = point.value.hi + point.value.lo;
    if (!(abs(value) < real(0.5)) || !(abs(slope) < real(RTG_NEVER)) || !(abs(at.start.hi - s) < real(4.0)))
    {
      // At a tip, or at a rim closer than rounding: the plain solution is as good as it gets.
      at = plain;
      return true;
    }
    if (abs(slope) < real(1e-3) * steepness)
    {
      // The terms of the slope cancel: plain numbers know too little of it.
      LocalRay last = at;
      return NestedSettle(form, last, -reach, reach, real(1.0), false, at);
    }
    // Grazing: the plain solution may be past the closest point. Start anew from before it.
    bool past = !(slope < real(0.0));
    if (past && stepped && value <= real(0.0))
    {
      // A tangent from outside ends behind the crossing only by rounding: at a rim, where the slope changes at once.
      return true;
    }
    bool grazing = i == 0 && -slope < real(0.02);
    if (past || grazing)
    {
      if (backwards >= 2)
      {
        // Past the closest point twice and on the same side all the time: no crossing.
        at = plain;
        return !(value > real(0.0));
      }
      ++backwards;
      stepped = false;
      at = Advance(at, real(-0.003));
    }
    else
    {
      // From the logarithm to the gauge, which is the convex one of the two.
      real step = -value * (real(1.0) + real(0.5) * value) / ((real(1.0) + value) * slope);
      real bend = step * step * NestedBend(form, point, at);
      // What a tangent leaves is half the second derivative times the square of the step, over the slope.
      bool settled = (bend <= real(0.125 * RTG_ROUNDOFF) * -slope && StaysInOctant(at, step)) ||
        abs(step) < real(1e-4 * RTG_ROUNDOFF);
      at = Advance(at, step);
      stepped = true;
      if (settled)
      {
        return true;
      }
    }
  }
  return true;
}

// Convex glyphs are met from outside, from either end of the ray.
RTG_FN NestedCrossing NestedConvex(
  NestedForm form, LocalRay ray, LocalRay unit, real scale, real sIn, real sOut, real tMin, real tMax)
{
  NestedCrossing crossing = NoCrossing(ray);
  LocalRay towards = unit;
  real way = real(1.0);
  for (int side = 0; side < 2; ++side)
  {
    real s;
    if (!NestedNewton(form, towards.origin.hi, towards.direction.hi, way > real(0.0) ? sIn : -sOut,
          way > real(0.0) ? sOut : -sIn, s) ||
      !NestedPolish(form, towards, s, real(1.01) * (sOut - sIn), crossing.at))
    {
      return crossing;
    }
    DoubleWord exact;
    exact.hi = way * scale * crossing.at.start.hi;
    exact.lo = way * scale * crossing.at.start.lo;
    crossing.t = RayParameter(ray, exact).hi;
    crossing.found = crossing.t >= tMin && crossing.t <= tMax;
    if (crossing.t >= tMin)
    {
      return crossing;
    }
    way = real(-1.0);
    towards.direction = Minus(unit.direction);
  }
  return crossing;
}

#endif
