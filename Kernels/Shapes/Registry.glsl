// The functions of a shape that the programs call, by the shape's number (List.h).
#ifndef RTG_REGISTRY
#define RTG_REGISTRY

#ifndef RTG_HOST
#include "Dialect.glsl"
#endif

#include "List.h"

// A new shape: its file, which defines Intersect<Name>, <Name>Enclosure, <Name>Normal and <Name>Bounds, and its entry
// in List.h.
#include "Arrow.glsl"
#include "Box.glsl"
#include "Capsule.glsl"
#include "Cone.glsl"
#include "Cylinder.glsl"
#include "NestedSuperquadric.glsl"
#include "Polynomial.glsl"
#include "RoundCone.glsl"
#include "Sphere.glsl"
#include "Superquadric.glsl"

// Nearest t in [tMin, tMax] where the ray crosses the glyph's surface; from inside, where it leaves.
RTG_FN bool IntersectGlyph(
  const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(real) t)
{
  bool found = false;
  t = tMin;
#define RTG_INTERSECT(number, Name)                                                                                    \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    found = Intersect##Name(ray, glyph, tMin, tMax, t);                                                                \
  }
  RTG_SHAPES(RTG_INTERSECT)
#undef RTG_INTERSECT
  return found;
}

// What the glyph lies in.
RTG_FN Enclosure GlyphEnclosure(const RTG_SHAPE shape, const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
#define RTG_ENCLOSE(number, Name)                                                                                      \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    outer = Name##Enclosure(glyph);                                                                                    \
  }
  RTG_SHAPES(RTG_ENCLOSE)
#undef RTG_ENCLOSE
  return outer;
}

// Says in plain arithmetic what is certain of IntersectGlyph's answer: one of Estimate.glsl's three.
RTG_FN int EstimateGlyph(const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(real) low, RTG_OUT(real) high)
{
  Enclosure outer = GlyphEnclosure(shape, glyph);
  EnclosureRay local = outer.inWorld ? ToSphere(ray, glyph, outer.radius) : ToEnclosure(ray, glyph, outer);
  return Estimate(local, outer, tMin, tMax, low, high);
}

// Outward unit normal in the world frame at a t that IntersectGlyph returned for this ray.
RTG_FN real3 GlyphNormal(const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real t)
{
  real3 normal = -ray.direction;
#define RTG_NORMAL(number, Name)                                                                                       \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    normal = Name##Normal(ray, glyph, t);                                                                              \
  }
  RTG_SHAPES(RTG_NORMAL)
#undef RTG_NORMAL
  return normal;
}

// Axis-aligned bounds in the frame of the centres, tight but for rounding: pad them before use.
RTG_FN void GlyphBounds(const RTG_SHAPE shape, const Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  lower = glyph.centre;
  upper = glyph.centre;
#define RTG_BOUNDS(number, Name)                                                                                       \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    Name##Bounds(glyph, lower, upper);                                                                                 \
  }
  RTG_SHAPES(RTG_BOUNDS)
#undef RTG_BOUNDS
}

#endif
