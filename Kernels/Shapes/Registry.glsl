// The shapes by number (rtg::Shape in Glyphs.h) and the four functions that the programs call.
// RTG_SHAPE is a number that the compiler of programs is given; on the host it is a template parameter.
#ifndef RTG_REGISTRY
#define RTG_REGISTRY

#ifndef RTG_HOST
#include "Dialect.glsl"
#endif

// A new shape: its file, which defines Intersect<Name>, <Name>Normal and <Name>Bounds, and its entry.
#include "Arrow.glsl"
#include "Box.glsl"
#include "Cone.glsl"
#include "Cylinder.glsl"
#include "Estimate.glsl"
#include "Sphere.glsl"
#include "NestedSuperquadric.glsl"
#include "Superquadric.glsl"
#ifdef RTG_HOST
#define RTG_SHAPES(ENTRY)                                                                                              \
  ENTRY(0, Sphere)                                                                                                     \
  ENTRY(1, Box) ENTRY(2, Cylinder) ENTRY(3, Cone) ENTRY(4, Arrow) ENTRY(5, Superquadric) ENTRY(6, NestedSuperquadric)
// A program has one shape only: drivers spend seconds on code that is never run.
#elif RTG_SHAPE == 0
#define RTG_SHAPES(ENTRY) ENTRY(0, Sphere)
#elif RTG_SHAPE == 1
#define RTG_SHAPES(ENTRY) ENTRY(1, Box)
#elif RTG_SHAPE == 2
#define RTG_SHAPES(ENTRY) ENTRY(2, Cylinder)
#elif RTG_SHAPE == 3
#define RTG_SHAPES(ENTRY) ENTRY(3, Cone)
#elif RTG_SHAPE == 4
#define RTG_SHAPES(ENTRY) ENTRY(4, Arrow)
#elif RTG_SHAPE == 5
#define RTG_SHAPES(ENTRY) ENTRY(5, Superquadric)
#elif RTG_SHAPE == 6
#define RTG_SHAPES(ENTRY) ENTRY(6, NestedSuperquadric)
#endif

// Nearest t in [tMin, tMax] where the ray crosses the glyph's surface; from inside, where it leaves.
RTG_FN_SHAPE bool IntersectGlyph(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) t)
{
#define RTG_INTERSECT(number, Name)                                                                                    \
  if (RTG_SHAPE == number)                                                                                             \
  {                                                                                                                    \
    return Intersect##Name(ray, glyph, tMin, tMax, t);                                                                 \
  }
  RTG_SHAPES(RTG_INTERSECT)
#undef RTG_INTERSECT
  t = tMin;
  return false;
}

// What the glyph lies in.
RTG_FN_SHAPE Enclosure GlyphEnclosure(Glyph glyph)
{
  Enclosure outer;
  outer.middle = real3(real(0.0));
  outer.halfSize = real(0.5) * glyph.size;
  outer.fills = RTG_SHAPE == 0;
  outer.boxed = !outer.fills;
  // The corner of the cube; for a superquadric whose largest exponent is m at least 2, |x|_2 <= 3^(1/2 - 1/m) |x|_m.
  outer.radius = outer.fills ? real(1.0) : real(1.7320509);
  if (RTG_SHAPE == 4)
  {
    ArrowBox(glyph, ScaleOfArrow(glyph), outer.middle, outer.halfSize);
  }
  if (RTG_SHAPE == 5)
  {
    real m = max(glyph.exponents.x, max(glyph.exponents.y, glyph.exponents.z));
    outer.radius = m <= real(2.0) ? real(1.0) : m <= real(4.0) ? real(1.3160741) : outer.radius;
    outer.fills = IsEllipsoid(glyph);
  }
  return outer;
}

// Says in plain arithmetic what is certain of IntersectGlyph's answer: one of Estimate.glsl's three.
RTG_FN_SHAPE int EstimateGlyph(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) low, RTG_OUT(real) high)
{
  Enclosure outer = GlyphEnclosure RTG_OF_SHAPE(glyph);
  if (RTG_SHAPE == 0 && glyph.sameSize)
  {
    outer.radius = outer.halfSize.x;
    return Estimate(ToSphere(ray, glyph, outer.radius), outer, tMin, tMax, low, high);
  }
  return Estimate(ToEnclosure(ray, glyph, outer), outer, tMin, tMax, low, high);
}

// Outward unit normal in the world frame at a t that IntersectGlyph returned for this ray.
RTG_FN_SHAPE real3 GlyphNormal(GlyphRay ray, Glyph glyph, real t)
{
#define RTG_NORMAL(number, Name)                                                                                       \
  if (RTG_SHAPE == number)                                                                                             \
  {                                                                                                                    \
    return Name##Normal(ray, glyph, t);                                                                                \
  }
  RTG_SHAPES(RTG_NORMAL)
#undef RTG_NORMAL
  return -ray.direction;
}

// Axis-aligned bounds in the frame of the centres, tight but for rounding: pad them before use.
RTG_FN_SHAPE void GlyphBounds(Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
#define RTG_BOUNDS(number, Name)                                                                                       \
  if (RTG_SHAPE == number)                                                                                             \
  {                                                                                                                    \
    Name##Bounds(glyph, lower, upper);                                                                                 \
    return;                                                                                                            \
  }
  RTG_SHAPES(RTG_BOUNDS)
#undef RTG_BOUNDS
  lower = glyph.centre;
  upper = glyph.centre;
}

#endif
