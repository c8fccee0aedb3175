// The functions of a shape that the programs call, by the shape's number (List.h).

#include "List.h"

// Each file after those that it uses. A new shape: its file, which defines Intersect<Name>, <Name>Enclosure and
// <Name>Bounds, and its entry in List.h; if it is convex, its bit there.
#include "DoubleWord.glsl"
#include "WordFunctions.glsl"
#include "LocalRay.glsl"
#include "Estimate.glsl"
#include "Span.glsl"
#include "Disc.glsl"
#include "Sphere.glsl"
#include "Box.glsl"
#include "Cylinder.glsl"
#include "Cone.glsl"
#include "ArrowForm.glsl"
#include "Arrow.glsl"
#include "RoundCone.glsl"
#include "Capsule.glsl"
#include "ImplicitSurface.glsl"
#include "Superquadric.glsl"
#include "NestedField.glsl"
#include "NestedSuperquadric.glsl"
#include "PolynomialForm.glsl"
#include "Polynomial.glsl"
#include "SweptEllipsoid.glsl"

// The nearest crossing of the glyph's surface at t in [tMin, tMax].
RTG_FN GlyphHit IntersectGlyph(const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real tMin,
  const real tMax, const bool wantsNormal)
{
  GlyphHit hit = GlyphHit(false, false, tMin, -ray.direction);
#define RTG_INTERSECT(number, Name)                                                                                    \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    hit = Intersect##Name(ray, glyph, tMin, tMax, wantsNormal);                                                        \
  }
  RTG_SHAPES(RTG_INTERSECT)
#undef RTG_INTERSECT
  return hit;
}

RTG_FN bool IntersectGlyph(
  const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(real) t)
{
  GlyphHit hit = IntersectGlyph(shape, ray, glyph, tMin, tMax, false);
  t = hit.t;
  return hit.found;
}

// A ball and a box round the glyph.
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

// What plain arithmetic proves of IntersectGlyph's result: one of Estimate.glsl's three.
RTG_FN int EstimateGlyph(const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(real) low, RTG_OUT(real) high)
{
  Enclosure outer = GlyphEnclosure(shape, glyph);
  EnclosureRay local = outer.inWorld ? ToSphere(ray, glyph, outer.radius) : ToEnclosure(ray, glyph, outer);
  int verdict = Estimate(local, outer, tMin, tMax, low, high);
  if ((RTG_IS(shape, RTG_OWN_ESTIMATE) || RTG_IS(shape, RTG_SWEPT)) && verdict == RTG_UNKNOWN)
  {
    real lower;
    verdict = RTG_IS(shape, RTG_SWEPT) ? EstimateSweptEllipsoid(ray, glyph, tMin, tMax, lower, high)
                                       : EstimateRoundCone(ray, glyph, tMin, tMax, lower, high);
    low = verdict == RTG_HIT ? lower : max(low, lower);
  }
  return verdict;
}

// Outward unit normal in the world frame at a t that IntersectGlyph returned for this ray: the crossing is found anew,
// from a little before, because another compilation of the same formula may have rounded t differently.
RTG_FN real3 GlyphNormal(const RTG_SHAPE shape, const GlyphRay ray, const Glyph glyph, const real t)
{
  real largest = max(glyph.size.x, max(glyph.size.y, glyph.size.z));
  real before = t - real(8.0) * real(RTG_ROUNDOFF) * (abs(t) + largest / length(ray.direction));
  GlyphHit hit = IntersectGlyph(shape, ray, glyph, before, real(RTG_NEVER), true);
  return hit.found ? hit.normal : -normalize(ray.direction);
}

// Axis-aligned bounds in the frame of the centers, tight but for rounding: pad them before use.
RTG_FN void GlyphBounds(const RTG_SHAPE shape, const Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  Bounds bounds = SymmetricBounds(real3(real(0.0)));
#define RTG_BOUNDS(number, Name)                                                                                       \
  if (RTG_IS(shape, number))                                                                                           \
  {                                                                                                                    \
    bounds = Name##Bounds(glyph);                                                                                      \
  }
  RTG_SHAPES(RTG_BOUNDS)
#undef RTG_BOUNDS
  lower = glyph.center + (glyph.centerLow + bounds.lower);
  upper = glyph.center + (glyph.centerLow + bounds.upper);
}
