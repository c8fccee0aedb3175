// Box of side 1, centerd.
#ifndef RTG_BOX
#define RTG_BOX

#include "Estimate.glsl"
#include "Span.glsl"

RTG_FN bool
BoxCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(Crossing) crossing)
{
  real3 halfSize = real(0.5) * glyph.size;
  LocalRay local;
  if (!ToLocal(ray, glyph, real3(real(0.0)), halfSize, local))
  {
    return NoCrossing(local, crossing);
  }
  return FirstCrossing(local, BoxSpan(local, halfSize), tMin, tMax, crossing);
}

#define BoxEnclosure BoxedEnclosure

RTG_FN real3 BoxNormal(const Glyph glyph, const Crossing crossing)
{
  int axis = crossing.face / 2;
  real outward = crossing.face == 2 * axis ? real(-1.0) : real(1.0);
  real3 normal =
    real3(axis == 0 ? outward : real(0.0), axis == 1 ? outward : real(0.0), axis == 2 ? outward : real(0.0));
  return normalize(RotateToWorld(glyph, normal));
}

RTG_FN bool IntersectBox(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  const bool wantsNormal, RTG_OUT(real) t, RTG_OUT(real3) normal)
{
  Crossing crossing;
  bool found = BoxCrossing(ray, glyph, tMin, tMax, crossing);
  t = crossing.t;
  normal = found && wantsNormal ? BoxNormal(glyph, crossing) : -ray.direction;
  return found;
}

RTG_FN void BoxBounds(const Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  real3 reach = real(0.5) * glyph.size;
  if (glyph.turned)
  {
    real3 x = RotateToWorld(glyph, real3(reach.x, real(0.0), real(0.0)));
    real3 y = RotateToWorld(glyph, real3(real(0.0), reach.y, real(0.0)));
    real3 z = RotateToWorld(glyph, real3(real(0.0), real(0.0), reach.z));
    reach = abs(x) + abs(y) + abs(z);
  }
  lower = glyph.center + (glyph.centerLow - reach);
  upper = glyph.center + (glyph.centerLow + reach);
}

#endif
