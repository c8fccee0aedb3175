// Superquadric |x/A|^r + |y/B|^s + |z/C|^t = 1, each axis with an exponent of its own, and its affine images.
//
// In the frame where the half-lengths are 1, f(s) = sum |o_i + s d_i|^e_i - 1 is to be zero: README.md, Superquadrics.
// Along a ray a term with e >= 1 is convex; one with e < 1 is concave on either side of its coordinate plane, where it
// has a cusp. Where f > 0, a straight line below it is the tangent of the convex terms at a (or at b) plus the chord of
// the concave ones; for -f these exchange their roles.

// The slope of a concave term at its cusp.
#define RTG_CUSP 1.0e30

// f along a ray; coordinate i at s is (s - zero_i) direction_i + base_i.
struct SuperquadricField
{
  real3 exponents;
  real3 zero;
  real3 base;
  real3 direction;
  real sOut;
  DoubleWord3 cusps; // where the ray passes planes that have them
  real accuracy;     // of s, after the last steps
  real error;        // rounding of f where its terms are of the order of one
  real convexWidth;  // windows shorter than this are convex
};

// f and its terms at one point of the ray.
struct SuperquadricProbe
{
  DoubleWord where;
  int axis;
  bool outside;
  real f;
  real slope;
  real error;
  TaylorError taylor;
  real3 terms;
  real3 slopes; // of the terms along the ray; RTG_CUSP at a cusp
};

// How well a parabola follows the term (p + s d)^e: its third derivative, and the radius in which that holds. For
// e >= 3 it stays below its value at 0.1 up to there.
RTG_FN void ParabolaAxis(const real a, const real d, const real e, const real slope, const real rate,
  RTG_OUT(real) third, RTG_OUT(real) radius)
{
  bool tame = e == real(2.0) || e >= real(3.0);
  radius = tame || d == real(0.0) ? real(RTG_NEVER) : real(0.5) * a / abs(d);
  third = e >= real(3.0) && a < real(0.1) ? real(8.0) * abs(d * d * d)
                                          : abs((e - real(1.0)) * (e - real(2.0)) * slope * rate * rate);
}

RTG_FN void ProbeAxis(const real p, const real d, const real e, RTG_OUT(real) term, RTG_OUT(real) slope,
  RTG_OUT(real) third, RTG_OUT(real) radius)
{
  real a = abs(p);
  term = a > real(0.0) ? pow(a, e) : real(0.0);
  real rate = a > real(1e-30) ? d / p : real(0.0);
  slope = e * term * rate;
  ParabolaAxis(a, d, e, slope, rate, third, radius);
  slope = a == real(0.0) && e < real(1.0) && d != real(0.0) ? real(RTG_CUSP) : slope;
}

RTG_FN SuperquadricProbe ProbeAt(const SuperquadricField field, const DoubleWord where, const int axis)
{
  SuperquadricProbe probe;
  probe.where = where;
  probe.axis = axis;
  real3 p = OffPlane(axis) * ((real3(where.hi) - field.zero) * field.direction + field.base);
  real3 d = field.direction;
  real3 e = field.exponents;
  real3 third, radius;
  ProbeAxis(p.x, d.x, e.x, probe.terms.x, probe.slopes.x, third.x, radius.x);
  ProbeAxis(p.y, d.y, e.y, probe.terms.y, probe.slopes.y, third.y, radius.y);
  ProbeAxis(p.z, d.z, e.z, probe.terms.z, probe.slopes.z, third.z, radius.z);
  probe.f = SumOf(probe.terms) - real(1.0);
  probe.slope = SumOf(probe.slopes);
  probe.taylor.third = SumOf(third);
  probe.taylor.radius = LeastOf(radius);
  probe.outside = probe.f > real(0.0);
  // A plane is where double words say: rounded, that moves the other terms, even to where they have cusps, too.
  real moved = axis < 0 ? real(0.0) : real(8.0 * RTG_ROUNDOFF) * max(abs(where.hi), real(RTG_ROUNDOFF));
  probe.error = field.error + moved * SumOf(OffPlane(axis) * abs(probe.slopes));
  return probe;
}

RTG_FN void ZeroOfAxis(const real o, const real d, const real reach, RTG_OUT(real) zero, RTG_OUT(real) base)
{
  // Near its plane a coordinate is known to full relative precision as a multiple of the distance from there.
  bool crosses = abs(o) <= reach * abs(d);
  zero = crosses && d != real(0.0) ? -o / d : real(0.0);
  base = crosses && d != real(0.0) ? real(0.0) : o;
}

RTG_FN SuperquadricField MakeSuperquadricField(const Chord chord, const real3 exponents)
{
  SuperquadricField field;
  LocalRay unit = chord.unit;
  real3 o = unit.origin.hi;
  real3 d = unit.direction.hi;
  real reach = real(4.0) * max(abs(chord.sIn), abs(chord.sOut));
  ZeroOfAxis(o.x, d.x, reach, field.zero.x, field.base.x);
  ZeroOfAxis(o.y, d.y, reach, field.zero.y, field.base.y);
  ZeroOfAxis(o.z, d.z, reach, field.zero.z, field.base.z);
  field.exponents = exponents;
  field.direction = d;
  field.sOut = chord.sOut;
  field.cusps = PlanesOf(unit, exponents);
  field.accuracy = real(0.5 * RTG_ROUNDOFF) * (chord.sOut - chord.sIn);
  // Vulkan allows log2 an absolute error of 2^-21 next to 1; pow multiplies it by the exponent.
  field.error = real(RTG_ROUNDOFF) * (real(4.0) + real(4.0) * MostOf(exponents));
  field.convexWidth = LeastOf(exponents) >= real(1.0) ? real(RTG_NEVER) : real(0.0);
  return field;
}

RTG_FN DoubleWord NextBreak(const SuperquadricField field, const DoubleWord after, RTG_OUT(int) axis)
{
  return NextPlane(field.cusps, after, NextMiddle(after, field.sOut), axis);
}

// One term's slopes for the lines below `outward` f at both ends of a window, and the largest slope in it.
RTG_FN void WindowAxis(const real e, const real outward, const real termA, const real termB, const real slopeA,
  const real slopeB, const real width, RTG_OUT(real) lineA, RTG_OUT(real) lineB, RTG_OUT(real) steepest)
{
  // A cusp at the window's end falls toward it.
  real atA = outward * slopeA;
  real atB = outward * (slopeB >= real(RTG_CUSP) ? -slopeB : slopeB);
  bool convex = (e >= real(1.0)) == (outward > real(0.0));
  real chord = outward * (termB - termA) / width;
  lineA = convex ? atA : chord;
  lineB = convex ? atB : chord;
  steepest = max(atA, atB);
}

RTG_FN Window WindowOf(const SuperquadricField field, const SuperquadricProbe a, const SuperquadricProbe b,
  const real sign, const real width)
{
  real3 lineA, lineB, steepest;
  real3 e = field.exponents;
  WindowAxis(e.x, sign, a.terms.x, b.terms.x, a.slopes.x, b.slopes.x, width, lineA.x, lineB.x, steepest.x);
  WindowAxis(e.y, sign, a.terms.y, b.terms.y, a.slopes.y, b.slopes.y, width, lineA.y, lineB.y, steepest.y);
  WindowAxis(e.z, sign, a.terms.z, b.terms.z, a.slopes.z, b.slopes.z, width, lineA.z, lineB.z, steepest.z);
  bool allConvex = LeastOf(e) >= real(1.0);
  bool allConcave = MostOf(e) < real(1.0);
  // How much the coordinates of the concave terms change
  real3 pa = abs((real3(a.where.hi) - field.zero) * field.direction + field.base);
  real3 pb = abs((real3(b.where.hi) - field.zero) * field.direction + field.base);
  real3 change = abs(pb - pa) / max(max(pa, pb), real3(real(RTG_TINY)));
  real3 concave = real3(e.x < real(1.0) ? change.x : real(0.0), e.y < real(1.0) ? change.y : real(0.0),
    e.z < real(1.0) ? change.z : real(0.0));

  bool unique = allConvex || allConcave || SumOf(steepest) < real(0.0);
  bool convex = sign > real(0.0) ? allConvex : allConcave;
  return Window(false, unique, MostOf(concave) < real(0.02), convex, SumOf(lineA), SumOf(lineB));
}

// The second derivative of a term, unless its plane is too near for it to mean anything.
RTG_FN real UsefulSecond(const real f, const real slope, const real second, const real rate, const real e)
{
  real step = real(2.0) * abs(f) / (abs(slope) + sqrt(slope * slope + real(2.0) * abs(second * f)));
  return e >= real(2.0) || step * abs(rate) <= real(0.5) ? second : real(0.0);
}

// f in double words. The axes are a loop so that the programs hold the long arithmetic once. Coordinates other than
// that of `plane` count as at least `least`.
RTG_FN ImplicitPoint PointAt(const SuperquadricField field, const LocalRay at, const int plane, const real least)
{
  ImplicitPoint point;
  point.value = Word(real(-1.0));
  point.slope = real(0.0);
  point.taylor.third = real(0.0);
  point.taylor.radius = real(RTG_NEVER);
  real steepness = real(0.0);
  DoubleWord3 term3;
  real3 second = real3(real(0.0));
  real3 rate = real3(real(0.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    DoubleWord x = WordOf(at.origin, axis);
    DoubleWord d = WordOf(at.direction, axis);
    real e = field.exponents[axis];
    real sign = x.hi < real(0.0) ? real(-1.0) : real(1.0);
    x.hi = sign * x.hi;
    x.lo = sign * x.lo;
    d.hi = sign * d.hi;
    x = axis != plane && x.hi < least && d.hi != real(0.0) ? Word(least) : x;
    DoubleWord term = Power(x, e);
    term3.hi[axis] = term.hi;
    term3.lo[axis] = term.lo;
    real inverse = x.hi > real(1e-30) ? real(1.0) / x.hi : real(0.0);
    real gradient = e * term.hi * inverse;
    real slope = gradient * d.hi;
    real third, radius;
    rate[axis] = d.hi * inverse;
    ParabolaAxis(x.hi, d.hi, e, slope, rate[axis], third, radius);
    point.value = Add(point.value, term);
    point.slope += slope;
    steepness += abs(slope);
    second[axis] = (e - real(1.0)) * slope * rate[axis];
    point.gradient[axis] = gradient;
    point.taylor.third += third;
    point.taylor.radius = min(point.taylor.radius, radius);
  }
  if (abs(point.slope) < real(0.001) * steepness && least == real(0.0))
  {
    // The slopes cancel, as on a face that the ray hardly rises from.
    DoubleWord exact = Word(real(0.0));
    for (int axis = 0; axis < 3; ++axis)
    {
      DoubleWord x = WordOf(at.origin, axis);
      if (abs(x.hi) > real(1e-30))
      {
        DoubleWord slope = Multiply(Divide(WordOf(term3, axis), x), WordOf(at.direction, axis));
        exact = Add(exact, Multiply(slope, field.exponents[axis]));
      }
    }
    point.slope = exact.hi;
  }
  real f = point.value.hi;
  point.second = UsefulSecond(f, point.slope, second.x, rate.x, field.exponents.x) +
    UsefulSecond(f, point.slope, second.y, rate.y, field.exponents.y) +
    UsefulSecond(f, point.slope, second.z, rate.z, field.exponents.z);
  point.accuracy = min(field.accuracy, real(16.0 * RTG_ROUNDOFF) * point.taylor.radius);
  return point;
}

RTG_FN ImplicitPoint PointAt(const SuperquadricField field, const LocalRay at)
{
  return PointAt(field, at, -1, real(0.0));
}

// At a cusp another plane may be closer than double words can resolve: then the glyph may be less than it seems.
RTG_FN SuperquadricProbe WithSign(const SuperquadricField field, const LocalRay unit, const SuperquadricProbe probe)
{
  SuperquadricProbe certain = probe;
  real least = probe.axis < 0 ? real(0.0) : real(8.0 * RTG_ROUNDOFF * RTG_ROUNDOFF);
  certain.f = PointAt(field, RayFrom(unit, probe.where, probe.axis), probe.axis, least).value.hi;
  certain.outside = certain.f > real(0.0);
  certain.error = field.error;
  return certain;
}

#define RTG_FIELD SuperquadricField
#define RTG_PROBE SuperquadricProbe
#define RTG_SEARCH SuperquadricSearch
#define RTG_MAKE_FIELD MakeSuperquadricField
#define RTG_CROSSING SuperquadricCrossing
#include "ImplicitSearch.glsl"

RTG_FN bool IsEllipsoid(const Glyph glyph)
{
  return glyph.exponents.x == real(2.0) && glyph.exponents.y == real(2.0) && glyph.exponents.z == real(2.0);
}

// Programs without spheres lack IntersectSphere() (Vulkan/Specialize).
RTG_INTERSECT_BY_SPANS(Ellipsoid, Sphere)

RTG_FN GlyphHit IntersectSuperquadric(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsNormal)
{
  if (IsEllipsoid(glyph))
  {
    return IntersectEllipsoid(ray, glyph, tMin, tMax, wantsNormal);
  }
  return HitAt(SuperquadricCrossing(ray, glyph, tMin, tMax, wantsNormal), ray, glyph, wantsNormal);
}

RTG_FN Enclosure SuperquadricEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  // Where the largest exponent m is at least 2, |x|_2 <= 3^(1/2 - 1/m) |x|_m.
  real m = max(glyph.exponents.x, max(glyph.exponents.y, glyph.exponents.z));
  outer.radius = m <= real(2.0) ? real(1.0) : m <= real(4.0) ? real(1.3160741) : outer.radius;
  outer.fills = IsEllipsoid(glyph);
  return outer;
}

// The largest a.x u + a.y v + a.z w on |u|^e.x + |v|^e.y + |w|^e.z <= 1, a >= 0; with exponents below 1 on the larger
// body where they are 1. By duality it is the least over k > 0 of k + sum max_u (a_i u - k u^e_i), and no k gives less:
// rounding and an unfinished iteration err on the safe side. The best k has sum 2^(q_i (l_i - log2 k)) = 1, l_i =
// log2(a_i / e_i), q_i = e_i / (e_i - 1); the logarithm of that sum is convex in log2 k, and Newton's method goes up
// from the largest l_i without passing the root, which is at most log2(sum) / min q_i away: what the bound has too much
// is less than k (sum - 1) times that. While powers with q_i < 1e6 alone make more than 1, no step is below 1.44e-6.
RTG_FN real SuperquadricReach(const real3 a, const real3 exponents)
{
  real3 e = max(exponents, real3(real(1.0)));
  real3 rest = max(e - real(1.0), real3(real(1e-6)));
  real3 q = e / rest;
  real3 l = log2(max(a / e, real3(real(1e-37))));
  real largest = max(l.x, max(l.y, l.z));
  l = l - largest;
  real x = real(0.0);
  real3 power = real3(real(0.0));
  real enough = real(1.0e-6) * min(q.x, min(q.y, q.z));
  for (int i = 0; i < 16; ++i)
  {
    power = exp2(max(q * (l - x), real3(real(-120.0))));
    real sum = SumOf(power);
    real logarithm = log2(sum);
    real step = logarithm * sum / dot(power, q);
    if (i == 15 || step <= real(5.0e-7) || logarithm * (sum - real(1.0)) <= enough)
    {
      break;
    }
    x += step;
  }
  real k = exp2(largest + x);
  real3 u = exp2(clamp((l - x) / rest, real3(real(-120.0)), real3(real(0.0))));
  return k + SumOf(a * u - k * min(power, real3(real(1.0))));
}

RTG_FN Bounds SuperquadricBounds(const Glyph glyph)
{
  real3 reach = real(0.5) * glyph.size;
  if (glyph.rotated)
  {
    Axes axes = WorldAxes(glyph, reach);
    real3 x = abs(axes.x);
    real3 y = abs(axes.y);
    real3 z = abs(axes.z);
    reach = real3(SuperquadricReach(real3(x.x, y.x, z.x), glyph.exponents),
      SuperquadricReach(real3(x.y, y.y, z.y), glyph.exponents),
      SuperquadricReach(real3(x.z, y.z, z.z), glyph.exponents));
  }
  return SymmetricBounds(reach);
}
