// Superquadric |x/A|^r + |y/B|^s + |z/C|^t = 1, each axis with an exponent of its own.
#ifndef RTG_SUPERQUADRIC
#define RTG_SUPERQUADRIC

#include "Disc.glsl"
#include "Box.glsl"
#include "Span.glsl"

// For now: sign changes between 64 samples of the chord through the box, then bisection.
RTG_FN real SuperquadricValue(real3 p, real3 e)
{
  real3 a = abs(p);
  real x = a.x > real(0.0) ? pow(a.x, e.x) : real(0.0);
  real y = a.y > real(0.0) ? pow(a.y, e.y) : real(0.0);
  real z = a.z > real(0.0) ? pow(a.z, e.z) : real(0.0);
  return ((x + y) + z) - real(1.0);
}

RTG_FN bool SuperquadricCrossing(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(LocalRay) local,
  RTG_OUT(Crossing) crossing)
{
  if (!ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local))
  {
    return NoCrossing(local, crossing);
  }
  Span box = BoxSpan(local, real3(real(1.0)));
  crossing.face = 0;
  crossing.s = Word(real(0.0));
  crossing.t = real(RTG_NEVER);
  if (IsEmpty(box))
  {
    return false;
  }
  real3 o = local.origin.hi;
  real3 d = local.direction.hi;
  real step = (box.sOut.hi - box.sIn.hi) / real(64.0);
  bool inside = false;
  for (int i = 1; i <= 65; ++i)
  {
    real s = box.sIn.hi + real(i) * step;
    bool insideNow = i < 65 && SuperquadricValue(o + s * d, glyph.exponents) < real(0.0);
    if (insideNow != inside)
    {
      real below = s - step;
      real above = s;
      for (int k = 0; k < 30; ++k)
      {
        real middle = real(0.5) * (below + above);
        bool insideMiddle = SuperquadricValue(o + middle * d, glyph.exponents) < real(0.0);
        below = insideMiddle == inside ? middle : below;
        above = insideMiddle == inside ? above : middle;
      }
      crossing.s = Word(above);
      crossing.t = RayParameter(local, crossing.s).hi;
      if (crossing.t >= tMin && crossing.t <= tMax)
      {
        return true;
      }
    }
    inside = insideNow;
  }
  return false;
}

RTG_FN bool IntersectSuperquadric(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) t)
{
  LocalRay local;
  Crossing crossing;
  bool found = SuperquadricCrossing(ray, glyph, tMin, tMax, local, crossing);
  t = crossing.t;
  return found;
}

RTG_FN real SuperquadricSlope(real x, real e)
{
  real a = max(abs(x), real(1e-20));
  return (x < real(0.0) ? -e : e) * pow(a, e - real(1.0));
}

RTG_FN real3 SuperquadricNormal(GlyphRay ray, Glyph glyph, real t)
{
  LocalRay local;
  Crossing crossing;
  SuperquadricCrossing(ray, glyph, Before(ray, glyph, t), real(RTG_NEVER), local, crossing);
  real3 p = PointAt(local, crossing.s);
  real3 e = glyph.exponents;
  real3 gradient =
    real3(SuperquadricSlope(p.x, e.x), SuperquadricSlope(p.y, e.y), SuperquadricSlope(p.z, e.z)) / glyph.size;
  real largest = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
  return normalize(RotateToWorld(glyph, gradient / largest));
}

RTG_FN void SuperquadricBounds(Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  BoxBounds(glyph, lower, upper);
}

#endif
