// Superquadric |x/A|^r + |y/B|^s + |z/C|^t = 1, each axis with an exponent of its own, and its affine images.
//
// In the frame where the half-lengths are 1, f(s) = sum |o_i + s d_i|^e_i - 1 is to be zero. Along a ray a term with
// e >= 1 is convex; one with e < 1 is concave on either side of its coordinate plane, where it has a cusp. So the
// chord through the box is cut at the planes of the axes with e < 1: at most four pieces, on each of which f = convex +
// concave. Its crossings are found one after the other, from the left.
//
// Isolation. Outside the glyph f > 0, and on a window [a, b] without cusps
//   f(s) >= tangent of the convex terms at a (or at b) + chord of the concave terms =: a straight line through f(a) (or
//   f(b)).
// Where both lines are below zero is all that is left of the window; if they are nowhere, nothing is in it: that is
// proven, nothing is sampled. For a convex glyph the line at a is Newton's, which by convexity never passes the first
// crossing. Inside the glyph the same holds for -f, with the roles of convex and concave terms exchanged.
// When the signs at a and b differ and f is monotone between, or purely convex or concave, the crossing is unique.
// Otherwise the window is cut where the lines leave the most doubt, so every step at least halves it.
//
// Solution. Newton's method inside a bracket of certain signs, with bisection where it leaves the bracket or
// dawdles. The last step is done on f in double words (WordFunctions.glsl): f is then known to about 1e-13, so that the
// quadratic through it, with plain derivatives, gives a grazing crossing with the digits that t needs, and tells
// whether there is one.
//
// Why it cannot loop: every turn evaluates f once and the turns are counted; after RTG_STEPS the answer is a miss.
// Testing/Kernels/ SuperquadricTest.cxx counts them: 4 to 5 on average, and only rays that touch the surface to within
// rounding use them up. Why it cannot invent hits: a crossing needs a certain change of sign, or the last step must
// find its root in double words.
#ifndef RTG_SUPERQUADRIC
#define RTG_SUPERQUADRIC

#include "Estimate.glsl"
#include "Box.glsl"
#include "Disc.glsl"
#include "Span.glsl"
#include "Sphere.glsl"
#include "WordFunctions.glsl"

#define RTG_STEPS 256
// The slope of a concave term at its cusp.
#define RTG_CUSP 1.0e30

// The ray in the frame of the half-lengths; coordinate i at s is (s - zero_i) direction_i + base_i.
struct SuperquadricRay
{
  real3 zero;
  real3 base;
  real3 direction;
  real3 exponents;
  real sIn; // its chord through the box, slightly longer
  real sOut;
  real accuracy; // of s, after the last step
  real noise;    // rounding of f where its terms are of the order of one
};

// f and its terms at one point of the ray.
struct Probe
{
  real s;
  real f;
  real3 term;
  real3 slope; // of the terms along the ray; RTG_CUSP at a cusp
  real third;  // how large the third derivative of f is
  real reach;  // a parabola serves for f at most this far
};

// How well a parabola follows the term (p + s d)^e: its third derivative, and how far that tells the truth. For
// e >= 3 it stays below its value at 0.1 up to there.
RTG_FN void ParabolaAxis(real a, real d, real e, real slope, real rate, RTG_OUT(real) third, RTG_OUT(real) reach)
{
  bool tame = e == real(2.0) || e >= real(3.0);
  reach = tame || d == real(0.0) ? real(RTG_NEVER) : real(0.5) * a / abs(d);
  third = abs((e - real(1.0)) * (e - real(2.0)) * slope * rate * rate);
  if (e >= real(3.0) && a < real(0.1))
  {
    third = real(8.0) * abs(d * d * d);
  }
}

RTG_FN void
ProbeAxis(real p, real d, real e, RTG_OUT(real) term, RTG_OUT(real) slope, RTG_OUT(real) third, RTG_OUT(real) reach)
{
  real a = abs(p);
  term = a > real(0.0) ? pow(a, e) : real(0.0);
  real rate = a > real(1e-30) ? d / p : real(0.0);
  slope = e * term * rate;
  ParabolaAxis(a, d, e, slope, rate, third, reach);
  if (a == real(0.0) && e < real(1.0) && d != real(0.0))
  {
    slope = real(RTG_CUSP);
  }
}

RTG_FN real SumOf(real3 v)
{
  return v.x + v.y + v.z;
}

RTG_FN real LeastOf(real3 v)
{
  return min(v.x, min(v.y, v.z));
}

RTG_FN Probe ProbeAt(SuperquadricRay ray, real s)
{
  Probe probe;
  probe.s = s;
  real3 p = (real3(s) - ray.zero) * ray.direction + ray.base;
  real3 third;
  real3 reach;
  ProbeAxis(p.x, ray.direction.x, ray.exponents.x, probe.term.x, probe.slope.x, third.x, reach.x);
  ProbeAxis(p.y, ray.direction.y, ray.exponents.y, probe.term.y, probe.slope.y, third.y, reach.y);
  ProbeAxis(p.z, ray.direction.z, ray.exponents.z, probe.term.z, probe.slope.z, third.z, reach.z);
  probe.f = SumOf(probe.term) - real(1.0);
  probe.third = SumOf(third);
  probe.reach = LeastOf(reach);
  return probe;
}

RTG_FN void ZeroOfAxis(real o, real d, real reach, RTG_OUT(real) zero, RTG_OUT(real) base)
{
  // Near its plane a coordinate is known to full relative precision as a multiple of the way from there.
  bool crosses = abs(o) <= reach * abs(d);
  zero = crosses && d != real(0.0) ? -o / d : real(0.0);
  base = crosses && d != real(0.0) ? real(0.0) : o;
}

RTG_FN SuperquadricRay MakeSuperquadricRay(LocalRay local, real3 exponents)
{
  SuperquadricRay ray;
  ray.direction = local.direction.hi;
  ray.exponents = exponents;

  // The chord through the box, padded by more than the rounding of the coordinates.
  real3 o = local.origin.hi;
  real3 d = local.direction.hi;
  real least = real(RTG_ROUNDOFF * RTG_ROUNDOFF) * (abs(d.x) + abs(d.y) + abs(d.z));
  real3 e = real3(abs(d.x) > least ? d.x : least, abs(d.y) > least ? d.y : least, abs(d.z) > least ? d.z : least);
  real3 padded = real3(real(1.0 + 32.0 * RTG_ROUNDOFF));
  real3 a = (-padded - o) / e;
  real3 b = (padded - o) / e;
  real3 sNear = min(a, b);
  real3 sFar = max(a, b);
  ray.sIn = max(sNear.x, max(sNear.y, sNear.z));
  ray.sOut = min(sFar.x, min(sFar.y, sFar.z));
  ray.accuracy = real(0.5 * RTG_ROUNDOFF) * (ray.sOut - ray.sIn);
  // Vulkan allows log2 an absolute error of 2^-21 next to 1; pow multiplies it by the exponent.
  ray.noise = real(RTG_ROUNDOFF) * (real(4.0) + real(4.0) * max(exponents.x, max(exponents.y, exponents.z)));

  real reach = real(4.0) * max(abs(ray.sIn), abs(ray.sOut));
  ZeroOfAxis(o.x, d.x, reach, ray.zero.x, ray.base.x);
  ZeroOfAxis(o.y, d.y, reach, ray.zero.y, ray.base.y);
  ZeroOfAxis(o.z, d.z, reach, ray.zero.z, ray.base.z);
  return ray;
}

// The next cusp after s, or the end of the chord.
RTG_FN real NextCusp(SuperquadricRay ray, real s)
{
  real next = ray.sOut;
  next = ray.exponents.x < real(1.0) && ray.base.x == real(0.0) && ray.zero.x > s ? min(next, ray.zero.x) : next;
  next = ray.exponents.y < real(1.0) && ray.base.y == real(0.0) && ray.zero.y > s ? min(next, ray.zero.y) : next;
  next = ray.exponents.z < real(1.0) && ray.base.z == real(0.0) && ray.zero.z > s ? min(next, ray.zero.z) : next;
  return next;
}

// What is known of a window.
#define RTG_EMPTY 0
#define RTG_UNIQUE 1
#define RTG_DOUBTFUL 2

// One term's slopes for the lines below `outward` f at both ends of a window, and the largest slope in it.
RTG_FN void WindowAxis(real e, real outward, real termA, real termB, real slopeA, real slopeB, real width,
  RTG_OUT(real) lineA, RTG_OUT(real) lineB, RTG_OUT(real) steepest)
{
  // A cusp at the window's end falls towards it.
  real atA = outward * slopeA;
  real atB = outward * (slopeB >= real(RTG_CUSP) ? -slopeB : slopeB);
  bool convex = (e >= real(1.0)) == (outward > real(0.0));
  real chord = outward * (termB - termA) / width;
  lineA = convex ? atA : chord;
  lineB = convex ? atB : chord;
  steepest = max(atA, atB);
}

// `outward` is 1 when a is outside the glyph, -1 inside; left: no crossing is before it; next: where to look next.
RTG_FN int Look(SuperquadricRay ray, Probe a, Probe b, real outward, RTG_OUT(real) left, RTG_OUT(real) next)
{
  real3 lineA;
  real3 lineB;
  real3 steepest;
  real3 e = ray.exponents;
  real width = b.s - a.s;
  left = a.s;
  next = real(0.5) * (a.s + b.s);
  bool changes = outward * b.f < real(0.0);
  if (!(width > real(4.0) * ray.accuracy))
  {
    return changes ? RTG_UNIQUE : RTG_EMPTY;
  }
  WindowAxis(e.x, outward, a.term.x, b.term.x, a.slope.x, b.slope.x, width, lineA.x, lineB.x, steepest.x);
  WindowAxis(e.y, outward, a.term.y, b.term.y, a.slope.y, b.slope.y, width, lineA.y, lineB.y, steepest.y);
  WindowAxis(e.z, outward, a.term.z, b.term.z, a.slope.z, b.slope.z, width, lineA.z, lineB.z, steepest.z);

  real slopeA = SumOf(lineA);
  real slopeB = SumOf(lineB);
  // Lowered by the rounding of f: what is empty is certain to be.
  real above = max(outward * a.f - ray.noise, real(0.0));
  left = slopeA < real(0.0) ? a.s - above / slopeA : a.s;
  if (changes)
  {
    bool allConvex = min(e.x, min(e.y, e.z)) >= real(1.0);
    bool allConcave = max(e.x, max(e.y, e.z)) < real(1.0);
    real middle = real(0.5) * (left + b.s);
    bool apart = middle > a.s && middle < b.s; // else the window is as narrow as rounding allows
    bool unique = allConvex || allConcave || SumOf(steepest) < real(0.0) || !apart;
    if (unique)
    {
      // Newton's point from the end where that is certain not to pass the crossing, else the secant's.
      bool convex = outward > real(0.0) ? allConvex : allConcave;
      bool concave = outward > real(0.0) ? allConcave : allConvex;
      real secant = a.s + width * clamp(a.f / (a.f - b.f), real(0.0625), real(0.9375));
      next = concave ? b.s - b.f / SumOf(b.slope) : secant;
      next = convex && slopeA < real(0.0) ? a.s - outward * a.f / slopeA : next;
      next = next > a.s && next < b.s ? next : secant;
      return RTG_UNIQUE;
    }
    next = middle;
    return RTG_DOUBTFUL;
  }
  real right = b.s - max(outward * b.f - ray.noise, real(0.0)) / slopeB;
  if (!(slopeA < real(0.0)) || !(slopeB > real(0.0)))
  {
    return RTG_EMPTY;
  }
  next = real(0.5) * (left + right);
  return left < right ? RTG_DOUBTFUL : RTG_EMPTY;
}

// f at s in double words, what else the last step needs in plain numbers. The axes are a loop so that
// the programs hold the long arithmetic once.
struct ExactProbe
{
  DoubleWord f;
  real slope;
  real3 second; // second derivatives of the terms along the ray
  real3 rate;   // of the coordinates' logarithms
  real third;
  real reach;
  real3 gradient;
};

RTG_FN DoubleWord WordOf(DoubleWord3 a, int axis)
{
  DoubleWord word;
  word.hi = axis == 0 ? a.hi.x : axis == 1 ? a.hi.y : a.hi.z;
  word.lo = axis == 0 ? a.lo.x : axis == 1 ? a.lo.y : a.lo.z;
  return word;
}

// plane: the axis whose coordinate is known to be zero, or -1; then the others count as at least `least`.
RTG_FN ExactProbe ExactlyAt(LocalRay local, real3 exponents, DoubleWord s, int plane, real least)
{
  DoubleWord3 along;
  along.hi = real3(s.hi);
  along.lo = real3(s.lo);
  DoubleWord3 p = Add(local.origin, Multiply(local.direction, along));
  ExactProbe probe;
  probe.f = Word(real(-1.0));
  probe.slope = real(0.0);
  DoubleWord exactSlope = Word(real(0.0));
  real steepness = real(0.0);
  DoubleWord3 term3;
  probe.third = real(0.0);
  probe.reach = real(RTG_NEVER);
  for (int axis = 0; axis < 3; ++axis)
  {
    DoubleWord x = WordOf(p, axis);
    DoubleWord d = WordOf(local.direction, axis);
    real e = exponents[axis];
    real sign = x.hi < real(0.0) ? real(-1.0) : real(1.0);
    x.hi = sign * x.hi;
    x.lo = sign * x.lo;
    d.hi = sign * d.hi;
    d.lo = sign * d.lo;
    if (x.hi < least && d.hi != real(0.0))
    {
      x = Word(least);
    }
    if (axis == plane)
    {
      x = Word(real(0.0));
    }
    DoubleWord term = Power(x, e);
    term3.hi[axis] = term.hi;
    term3.lo[axis] = term.lo;
    real inverse = x.hi > real(1e-30) ? real(1.0) / x.hi : real(0.0);
    real gradient = e * term.hi * inverse;
    real slope = gradient * d.hi;
    real rate = d.hi * inverse;
    real third;
    real reach;
    ParabolaAxis(x.hi, d.hi, e, slope, rate, third, reach);
    probe.f = Add(probe.f, term);
    probe.slope += slope;
    steepness += abs(slope);
    probe.second[axis] = (e - real(1.0)) * slope * rate;
    probe.rate[axis] = rate;
    probe.gradient[axis] = sign * gradient;
    probe.third += third;
    probe.reach = min(probe.reach, reach);
  }
  if (abs(probe.slope) < real(0.001) * steepness && least == real(0.0))
  {
    // The slopes cancel, as on a face that the ray hardly rises from.
    for (int axis = 0; axis < 3; ++axis)
    {
      DoubleWord x = WordOf(p, axis);
      if (abs(x.hi) > real(1e-30))
      {
        DoubleWord slope = Multiply(Divide(WordOf(term3, axis), x), WordOf(local.direction, axis));
        exactSlope = Add(exactSlope, Multiply(slope, exponents[axis]));
      }
    }
    probe.slope = exactSlope.hi;
  }
  return probe;
}

// A probe that may be at a cusp. Whether the glyph reaches as far as the ray is decided at cusps, so there the sign
// must be right even where the other terms are steep, or at another cusp that is too close for s to tell.
RTG_FN Probe ProbeCusp(LocalRay local, SuperquadricRay ray, real s)
{
  Probe probe = ProbeAt(ray, s);
  real3 steepness = abs(probe.slope);
  bool onX = steepness.x >= real(RTG_CUSP);
  bool onY = steepness.y >= real(RTG_CUSP);
  bool onZ = steepness.z >= real(RTG_CUSP);
  real steep = (onX ? real(0.0) : steepness.x) + (onY ? real(0.0) : steepness.y) + (onZ ? real(0.0) : steepness.z);
  real noise = real(8.0 * RTG_ROUNDOFF) * (real(2.0) + steep * (ray.sOut - ray.sIn));
  bool several = (onX && onY) || (onY && onZ) || (onZ && onX);
  if ((onX || onY || onZ) && (several || abs(probe.f) < noise))
  {
    // Another plane may be closer than double words can tell: then the glyph may be less than it seems.
    real least = real(8.0 * RTG_ROUNDOFF * RTG_ROUNDOFF);
    real f = real(RTG_NEVER);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (axis == 0 ? onX : axis == 1 ? onY : onZ)
      {
        DoubleWord exact = Divide(Minus(WordOf(local.origin, axis)), WordOf(local.direction, axis));
        f = min(f, ExactlyAt(local, ray.exponents, exact, axis, least).f.hi);
      }
    }
    probe.f = f;
  }
  return probe;
}

// Where the search along a ray stands.
struct Search
{
  Probe a;      // no crossing is left before it
  Probe b;      // end of the window
  Probe end;    // end of the piece
  real outward; // 1: a is outside the glyph; -1: inside
  int steps;
  Probe found; // close to a crossing
  bool steep;  // it needs no last step: f jumps within the accuracy of s
  bool touch;  // f is next to zero there without a change of sign: only the last step can tell
};

RTG_FN Search StartSearch(SuperquadricRay ray)
{
  Search search;
  search.a = ProbeAt(ray, ray.sIn);
  search.end = search.a;
  search.b = search.a;
  search.outward = real(1.0);
  search.steps = 0;
  search.found = search.a;
  search.steep = false;
  search.touch = false;
  return search;
}

// The search goes on behind a crossing, on the other side of the surface, or behind what was none.
RTG_FN Search Continue(SuperquadricRay ray, Search search, bool crossed, real resume)
{
  search.a = search.b;
  if (search.touch)
  {
    search.a = ProbeAt(ray, clamp(resume, search.b.s, search.end.s));
  }
  search.b = search.end;
  search.outward = crossed ? -search.outward : search.outward;
  return search;
}

// Walks to the next crossing. Each turn evaluates f once.
RTG_FN bool NextCrossing(LocalRay local, SuperquadricRay ray, Search search, RTG_OUT(Search) after)
{
  bool solving = false;
  int dawdling = 0;
  real noise = ray.noise;
  real touchWidth = real(16.0) * sqrt(noise) * (ray.sOut - ray.sIn);
  search.touch = false;
  real next = search.a.s;
  real left = search.a.s;
  bool found = false;
  bool more = true;
  while (more && search.steps < RTG_STEPS)
  {
    bool newPiece = false;
    if (!solving)
    {
      int verdict = RTG_EMPTY;
      if (search.a.s < search.b.s)
      {
        verdict = Look(ray, search.a, search.b, search.outward, left, next);
        search.touch = verdict == RTG_DOUBTFUL && abs(search.b.f) <= noise && search.b.s < search.end.s &&
          search.b.s - left <= touchWidth;
      }
      if (search.touch)
      {
        // From the left, so that the first of several crossings is found.
        search.found = search.b;
        search.found.s = left;
        search.steep = false;
        found = true;
        more = false;
      }
      solving = verdict == RTG_UNIQUE;
      if (verdict == RTG_EMPTY)
      {
        // On to a window twice as wide, as far as the piece goes, or to the next piece.
        real width = search.b.s - search.a.s;
        search.a = search.b;
        search.b = search.end;
        newPiece = !(search.a.s < search.end.s);
        more = !newPiece || search.end.s < ray.sOut;
        next = newPiece ? NextCusp(ray, search.end.s) : search.a.s + real(2.0) * width;
        if (!newPiece && !(next < search.end.s))
        {
          continue;
        }
      }
    }
    if (more)
    {
      Probe probe = ProbeCusp(local, ray, next);
      ++search.steps;
      if (!solving)
      {
        search.b = probe;
        if (newPiece)
        {
          search.end = probe;
        }
      }
      else
      {
        real side = search.outward * probe.f;
        if (side > real(0.0))
        {
          search.a = probe;
        }
        else
        {
          search.b = probe;
        }
        real slope = SumOf(probe.slope);
        real step = probe.f / slope;
        // What the quadratic of the last step will leave.
        bool close = abs(step) <= probe.reach && search.outward * slope < real(0.0) &&
          step * step * abs(step) * probe.third <= real(6.0) * ray.accuracy * abs(slope);
        real width = search.b.s - search.a.s;
        bool narrow = !(width > real(4.0) * ray.accuracy);
        search.steep = narrow && abs(search.a.f - search.b.f) > noise;
        found = close || narrow || (abs(probe.f) <= noise && search.outward * slope < real(0.0));
        search.found = probe;
        more = !found;
        ++dawdling;
        next = probe.s - step;
        bool inside = next > search.a.s && next < search.b.s && (dawdling < 8 || (dawdling & 1) == 0);
        next = inside ? next : real(0.5) * (search.a.s + search.b.s);
      }
    }
  }
  after = search;
  return found;
}

// The second derivative of a term, unless its plane is too near for it to mean anything.
RTG_FN real UsefulSecond(real f, real slope, real second, real rate, real e)
{
  real step = real(2.0) * abs(f) / (abs(slope) + sqrt(slope * slope + real(2.0) * abs(second * f)));
  return e >= real(2.0) || step * abs(rate) <= real(0.5) ? second : real(0.0);
}

// The last step: s where f is zero, falling when `outward` is 1. False: f has no zero here.
// resume: after a touch, where f is least or, when that is not zero, clearly above it again.
RTG_FN bool Polish(LocalRay local, SuperquadricRay ray, Search search, RTG_OUT(DoubleWord) s, RTG_OUT(real) resume)
{
  s = Word(search.found.s);
  resume = search.found.s;
  bool settled = search.steep && !(search.found.reach > real(8.0) * ray.accuracy);
  bool exists = true;
  for (int i = 0; i < 6 && !settled; ++i)
  {
    ExactProbe probe = ExactlyAt(local, ray.exponents, s, -1, real(0.0));
    real f = search.outward * probe.f.hi;
    real slope = search.outward * probe.slope;
    real3 kept;
    kept.x = UsefulSecond(f, slope, probe.second.x, probe.rate.x, ray.exponents.x);
    kept.y = UsefulSecond(f, slope, probe.second.y, probe.rate.y, ray.exponents.y);
    kept.z = UsefulSecond(f, slope, probe.second.z, probe.rate.z, ray.exponents.z);
    real second = search.outward * SumOf(kept);

    // The root of f + slope x + second x^2 / 2 where that falls.
    real discriminant = slope * slope - real(2.0) * second * f;
    exists = discriminant >= real(0.0) && (slope < real(0.0) || second > real(0.0));
    if (discriminant < real(0.0) && second > real(0.0) && i < 3)
    {
      // Least at a place too far for the parabola to be trusted? Then look from there. The true one may be twice as
      // far.
      real toLeast = -slope / second;
      real least = f + real(0.5) * slope * toLeast;
      if (least < real(2.0) * abs(toLeast * toLeast * toLeast) * probe.third)
      {
        s = Add(s, toLeast);
        continue;
      }
    }
    real root = sqrt(max(discriminant, real(0.0)));
    real step = slope < real(0.0) ? real(2.0) * f / (root - slope) : -(slope + root) / second;
    if (i < 4 && second > real(0.0) && search.touch)
    {
      resume = s.hi - slope / second + (exists ? real(0.0) : sqrt(real(4.0) * ray.noise / second));
    }
    step = exists ? step : real(0.0);
    s = Add(s, step);

    // What the third derivative leaves.
    real width = abs(step);
    real left = width * width * width * probe.third * real(1.0 / 6.0);
    real accuracy = min(ray.accuracy, real(16.0 * RTG_ROUNDOFF) * probe.reach);
    settled = !exists || (width <= probe.reach && left <= accuracy * root);
  }
  if (!exists && search.steep)
  {
    // f changes its sign for certain within the accuracy of s, at a cusp that the derivatives know nothing of.
    s = Word(search.found.s);
    exists = true;
  }
  return exists;
}

RTG_FN bool IsEllipsoid(Glyph glyph)
{
  return glyph.exponents.x == real(2.0) && glyph.exponents.y == real(2.0) && glyph.exponents.z == real(2.0);
}

RTG_FN bool SuperquadricCrossing(
  GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  if (!ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local))
  {
    return NoCrossing(local, crossing);
  }
  crossing.s = Word(real(0.0));
  crossing.t = real(RTG_NEVER);
  crossing.face = 0;
  // The parameter is scaled by a power of two that makes directions of the order of one: third derivatives of tiny
  // glyphs would overflow. In what follows s = scale * s of `unit` and `scaled`.
  real3 d = abs(local.direction.hi);
  real scale = ldexp(real(1.0), -int(floor(log2(max(d.x, max(d.y, d.z))))));
  LocalRay scaled = local;
  scaled.direction.hi = scale * local.direction.hi;
  scaled.direction.lo = scale * local.direction.lo;
  SuperquadricRay unit = MakeSuperquadricRay(scaled, glyph.exponents);
  real margin = real(64.0 * RTG_ROUNDOFF) * (unit.sOut - unit.sIn);
  if (!(unit.sIn < unit.sOut) || RayParameter(local, Word(scale * (unit.sIn - margin))).hi > tMax ||
    RayParameter(local, Word(scale * (unit.sOut + margin))).hi < tMin)
  {
    return false;
  }

  Search search = StartSearch(unit);
  while (NextCrossing(scaled, unit, search, search))
  {
    // The crossing lies behind a: beyond tMax there is nothing to gain.
    if (RayParameter(local, Word(scale * (search.a.s - margin))).hi > tMax)
    {
      return false;
    }
    real resume;
    DoubleWord s;
    bool crossed = Polish(scaled, unit, search, s, resume);
    if (crossed)
    {
      crossing.s.hi = scale * s.hi;
      crossing.s.lo = scale * s.lo;
      crossing.t = RayParameter(local, crossing.s).hi;
      if (crossing.t >= tMin)
      {
        return crossing.t <= tMax;
      }
    }
    search = Continue(unit, search, crossed, resume);
  }
  return false;
}

RTG_FN bool IntersectSuperquadric(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) t)
{
  if (IsEllipsoid(glyph))
  {
    return IntersectEllipsoid(ray, glyph, tMin, tMax, t);
  }
  LocalRay local;
  Crossing crossing;
  bool found = SuperquadricCrossing(ray, glyph, tMin, tMax, local, crossing);
  t = crossing.t;
  return found;
}

// The gradient where the crossing was found whose parameter was rounded to t, by a few of Newton's steps in double
// words. False: the surface may have other crossings within t's rounding, or an edge, and only the search tells which
// one it was.
RTG_FN bool GradientNear(GlyphRay ray, Glyph glyph, real t, RTG_OUT(real3) gradient)
{
  gradient = real3(real(0.0));
  LocalRay local;
  if (!ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local))
  {
    return false;
  }
  real doubt = t - Before(ray, glyph, t);
  DoubleWord s = Add(Word(t), Minus(local.start));
  for (int i = 0; i < 4; ++i)
  {
    ExactProbe probe = ExactlyAt(local, glyph.exponents, s, -1, real(0.0));
    // How fast the slope changes, at most, in twice the doubt: the third derivative holds within `reach`.
    real bend = abs(probe.second.x) + abs(probe.second.y) + abs(probe.second.z) + real(2.0) * doubt * probe.third;
    bool plain = real(4.0) * doubt <= probe.reach && real(4.0) * doubt * bend <= abs(probe.slope);
    real step = -probe.f.hi / probe.slope;
    if (!plain || !(abs(step) <= real(2.0) * doubt))
    {
      return false;
    }
    // As it is one step on; what that leaves out is less than the square of the change.
    gradient = probe.gradient * (real3(real(1.0)) + step * (glyph.exponents - real3(real(1.0))) * probe.rate);
    if (abs(step) * SumOf(abs(probe.rate) * glyph.exponents) <= real(1.0e-4))
    {
      return true;
    }
    s = Add(s, step);
  }
  return true;
}

RTG_FN Enclosure SuperquadricEnclosure(Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  // Where the largest exponent m is at least 2, |x|_2 <= 3^(1/2 - 1/m) |x|_m.
  real m = max(glyph.exponents.x, max(glyph.exponents.y, glyph.exponents.z));
  outer.radius = m <= real(2.0) ? real(1.0) : m <= real(4.0) ? real(1.3160741) : outer.radius;
  outer.fills = IsEllipsoid(glyph);
  return outer;
}

RTG_FN real3 SuperquadricNormal(GlyphRay ray, Glyph glyph, real t)
{
  if (IsEllipsoid(glyph))
  {
    return EllipsoidNormal(ray, glyph, t);
  }
  real3 gradient;
  if (!GradientNear(ray, glyph, t, gradient))
  {
    LocalRay local;
    Crossing crossing;
    SuperquadricCrossing(ray, glyph, Before(ray, glyph, t), real(RTG_NEVER), local, crossing);
    gradient = ExactlyAt(local, glyph.exponents, crossing.s, -1, real(0.0)).gradient;
  }
  real smallest = min(glyph.size.x, min(glyph.size.y, glyph.size.z));
  gradient = gradient * (real3(smallest) / glyph.size);
  real largest = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
  return normalize(RotateToWorld(glyph, gradient / largest));
}

// The largest a.x u + a.y v + a.z w on |u|^e.x + |v|^e.y + |w|^e.z <= 1, a >= 0; with exponents below 1 on the larger
// body where they are 1. By duality it is the least over k > 0 of k + sum max_u (a_i u - k u^e_i), and no k gives less:
// rounding and an unfinished iteration err on the safe side. The best k has sum 2^(q_i (l_i - log2 k)) = 1, l_i =
// log2(a_i / e_i), q_i = e_i / (e_i - 1); the logarithm of that sum is convex in log2 k, and Newton's method goes up
// from the largest l_i without passing the root, which is at most log2(sum) / min q_i away: what the bound has too much
// is less than k (sum - 1) times that. While powers with q_i < 1e6 alone make more than 1, no step is below 1.44e-6.
RTG_FN real SuperquadricReach(real3 a, real3 exponents)
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

RTG_FN void SuperquadricBounds(Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  real3 reach = real(0.5) * glyph.size;
  if (glyph.turned)
  {
    real3 x = abs(RotateToWorld(glyph, real3(reach.x, real(0.0), real(0.0))));
    real3 y = abs(RotateToWorld(glyph, real3(real(0.0), reach.y, real(0.0))));
    real3 z = abs(RotateToWorld(glyph, real3(real(0.0), real(0.0), reach.z)));
    reach = real3(SuperquadricReach(real3(x.x, y.x, z.x), glyph.exponents),
      SuperquadricReach(real3(x.y, y.y, z.y), glyph.exponents),
      SuperquadricReach(real3(x.z, y.z, z.z), glyph.exponents));
  }
  lower = glyph.centre + (glyph.centreLow - reach);
  upper = glyph.centre + (glyph.centreLow + reach);
}

#endif
