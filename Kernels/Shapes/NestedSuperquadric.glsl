// Superquadric with two profiles, its axis along z: in the frame of the half-lengths, for |z| <= 1,
//
//   |x / Rx(z)|^p + |y / Ry(z)|^p = 1,   Rx(z) = (1 - |z|^q)^(1/q),   Ry(z) = (1 - |z|^r)^(1/r),
//   p = 2 / alpha,  q = 2 / beta,  r = 2 / c.
//
// This is the base form of Schultz and Kindlmann: Superquadric Glyphs for Symmetric Second-Order Tensors, IEEE TVCG
// 16(6), 2010, written implicitly; c = beta is the nested superquadric (|x|^p + |y|^p)^(q/p) + |z|^q = 1 of
// Kindlmann 2004 and of granular matter codes. alpha = 0 is the square cross-section, beta = c = 0 the cylinder.
// Glyph.exponents holds alpha, beta, c; those below 1e-6 count as that.
//
// Crossings are found in plain arithmetic, by Newton's method on a norm where the glyph is convex (NestedConvex.glsl),
// else in windows of the ray that hold one crossing or none (NestedPieces.glsl). The last steps are Newton's on the
// norm's logarithm, in double words (NestedWords.glsl), until what a tangent leaves is below rounding: the plain
// solution knows the surface to 1e-6 only, and a grazing ray wants 1e-11. Where the terms of the slope cancel they are
// double words too, inside a bracket (NestedSettle). No hit is invented: each one is a change of sign.
#ifndef RTG_NESTED_SUPERQUADRIC
#define RTG_NESTED_SUPERQUADRIC

#include "Estimate.glsl"
#include "Box.glsl"
#include "Disc.glsl"
#include "NestedConvex.glsl"
#include "NestedPieces.glsl"
#include "Span.glsl"

RTG_FN NestedCrossing NestedSuperquadricCrossing(GlyphRay ray, Glyph glyph, real tMin, real tMax)
{
  LocalRay local;
  if (!ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local))
  {
    return NoCrossing(local);
  }

  // The origin next to the centre, a copy with a direction of about length one, the chord through the box
  NestedForm form = MakeNestedForm(glyph.exponents);
  real speed = length(local.direction.hi);
  local = Advance(local, -dot(local.origin.hi, local.direction.hi) / (speed * speed));
  real scale = ldexp(real(1.0), -int(floor(log2(speed))));
  LocalRay unit = local;
  unit.start = Word(real(0.0));
  unit.direction.hi = scale * local.direction.hi;
  unit.direction.lo = scale * local.direction.lo;
  real3 o = local.origin.hi;
  real3 d = unit.direction.hi;
  real reach = real(1.0) + real(8.0 * RTG_ROUNDOFF);
  real least = real(RTG_ROUNDOFF * RTG_ROUNDOFF);
  real3 e = real3(abs(d.x) > least ? d.x : least, abs(d.y) > least ? d.y : least, abs(d.z) > least ? d.z : least);
  real3 a = (-real3(reach) - o) / e;
  real3 b = (real3(reach) - o) / e;
  real3 sNear = min(a, b);
  real3 sFar = max(a, b);
  real sIn = max(sNear.x, max(sNear.y, sNear.z));
  real sOut = min(sFar.x, min(sFar.y, sFar.z));
  if (!(sIn <= sOut))
  {
    return NoCrossing(local);
  }
  if (form.convex)
  {
    return NestedConvex(form, local, unit, scale, sIn, sOut, tMin, tMax);
  }
  return NestedPieces(form, local, unit, scale, sIn, sOut, tMin, tMax);
}

RTG_FN bool IntersectNestedSuperquadric(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) t)
{
  NestedCrossing crossing = NestedSuperquadricCrossing(ray, glyph, tMin, tMax);
  t = crossing.t;
  return crossing.found;
}

RTG_FN Enclosure NestedSuperquadricEnclosure(Glyph glyph)
{
  return BoxedEnclosure(glyph);
}

RTG_FN real3 NestedSuperquadricNormal(GlyphRay ray, Glyph glyph, real t)
{
  NestedCrossing crossing = NestedSuperquadricCrossing(ray, glyph, Before(ray, glyph, t), real(RTG_NEVER));
  NestedForm form = MakeNestedForm(glyph.exponents);
  real3 p = crossing.at.origin.hi;
  real3 gradient =
    form.convex ? NestedConvexAt(form, crossing.at.origin).gradient : NestedProfileAt(form, crossing.at).gradient;
  gradient = gradient / max(gradient.x, max(gradient.y, max(gradient.z, real(RTG_NESTED_TINY))));
  // On the axis of a thorn nothing points anywhere but along it.
  if (!(gradient.x + gradient.y + gradient.z > real(0.0)))
  {
    gradient = real3(real(0.0), real(0.0), real(1.0));
  }
  real3 outward = real3(p.x < real(0.0) ? -gradient.x : gradient.x, p.y < real(0.0) ? -gradient.y : gradient.y,
    p.z < real(0.0) ? -gradient.z : gradient.z);
  real smallest = min(glyph.size.x, min(glyph.size.y, glyph.size.z));
  return normalize(RotateToWorld(glyph, outward * (real3(smallest) / glyph.size)));
}

// The norm dual to the p-norm, p = 2 / exponent, of non-negative a, b: the reach of the p-norm's unit ball. Not
// convex (exponent > 2) it reaches as far as its convex hull, the octahedron's.
RTG_FN real DualNorm(real a, real b, real exponent)
{
  real high = max(a, b);
  if (exponent >= real(2.0) || high == real(0.0))
  {
    return high;
  }
  real dual = real(1.0) / (real(1.0) - real(0.5) * exponent);
  return high * pow(real(1.0) + pow(min(a, b) / high, dual), real(1.0) / dual);
}

// Half the extent along each world axis is the glyph's support function there: of the dual norms, one in the other. A
// profile that is convex towards the axis (beta > 2) reaches as far as its hull. Of two profiles the fuller one counts,
// which is exact when both are straight or convex towards the axis.
RTG_FN void NestedSuperquadricBounds(Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  real3 reach = real(0.5) * glyph.size;
  if (glyph.turned)
  {
    real3 x = abs(RotateToWorld(glyph, real3(reach.x, real(0.0), real(0.0))));
    real3 y = abs(RotateToWorld(glyph, real3(real(0.0), reach.y, real(0.0))));
    real3 z = abs(RotateToWorld(glyph, real3(real(0.0), real(0.0), reach.z)));
    real3 e = max(glyph.exponents, real3(real(RTG_NESTED_LEAST)));
    real profile = min(e.y, e.z);
    reach = real3(DualNorm(DualNorm(x.x, y.x, e.x), z.x, profile), DualNorm(DualNorm(x.y, y.y, e.x), z.y, profile),
      DualNorm(DualNorm(x.z, y.z, e.x), z.z, profile));
  }
  lower = glyph.centre + (glyph.centreLow - reach);
  upper = glyph.centre + (glyph.centreLow + reach);
}

#endif
