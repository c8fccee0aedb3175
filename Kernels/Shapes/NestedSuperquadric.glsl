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
// Convex glyphs (beta = c <= 2, alpha <= 2). The gauge g = ||(||(x, y)||_p, z)||_q is a norm, so along the ray it is convex, and
// the surface is g = 1. Newton's method on g - 1 from the ray's entry into the box, where g >= 1, follows tangents
// that lie below g: but for rounding it cannot pass the first crossing. When the slope is no longer
// negative while g > 1, the ray is past its closest point and there is no crossing. Steps are counted; each one at least halves
// the distance to a closest point where the ray only just misses. The exit is found the same way from behind.
//
// All others. Inside one octant x / Rx along the ray has at most one extremum, at z^(1-q) = (z x' - x z') / x', and so
// has y / Ry. The chord is cut there and at the three coordinate planes: at most twelve pieces, on each of which both quotients are
// monotone. Where both rise or both fall, so does their p-norm N: its ends tell whether there is a crossing, and there is at most
// one. Where one rises and the other falls, N on [a, b] lies between the p-norms of the smaller and of the larger quotients at
// the ends: when those say that all of it is outside (or inside), there is nothing; else the piece is halved, the
// earlier half first. Nothing is sampled, except that windows below 4e-4 of the half-lengths and away from rim and tip count as
// having one extremum at most, and that rays grazing a rim of beta >= 2 closer than rounding may be decided wrongly: a few
// in 10,000 of the hard cases have t or a normal beyond the bound of the other shapes (ShapeErrorTable tells how far). A crossing is bracketed and found by Chandrupatla's method (Advances in
// Engineering Software 28(3), 1997), which never leaves its bracket. Evaluations are counted; a ray that comes to the end
// of RTG_NESTED_BUDGET touches the surface within rounding, and what is left is decided by the signs at the ends of pieces.
//
// Both: the last steps are Newton's on the logarithm of g, or of N, in double words (WordFunctions.glsl), until what a tangent
// leaves is below rounding: the plain solution knows the surface to 1e-6 only, and a grazing ray wants 1e-11.
// No hit is invented: each one is a change of sign.
#ifndef RTG_NESTED_SUPERQUADRIC
#define RTG_NESTED_SUPERQUADRIC

#include "Box.glsl"
#include "Disc.glsl"
#include "Span.glsl"
#include "WordFunctions.glsl"

#define RTG_NESTED_BUDGET 1024
#define RTG_NESTED_LEAST 1.0e-6 // exponent
#define RTG_NESTED_TINY (RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF)

struct NestedForm
{
  real p;
  real q;
  real r;
  real3 exponents; // alpha, beta, c, which p, q and r are rounded from
  bool convex;
  bool twoProfiles;
};

RTG_FN NestedForm MakeNestedForm(real3 exponents)
{
  real3 e = max(exponents, real3(real(RTG_NESTED_LEAST)));
  NestedForm form;
  form.exponents = e;
  form.p = real(2.0) / e.x;
  form.q = real(2.0) / e.y;
  form.r = real(2.0) / e.z;
  form.twoProfiles = e.y != e.z;
  form.convex = !form.twoProfiles && e.x <= real(2.0) && e.y <= real(2.0);
  return form;
}

// 2^x without underflow.
RTG_FN real SafeExp2(real x)
{
  return x > real(-100.0) ? exp2(min(x, real(100.0))) : real(0.0);
}

// The p-norm of (high, low) with high >= low >= 0, and its derivatives.
struct NestedNorm
{
  real value;
  real byHigh;
  real byLow;
};

RTG_FN NestedNorm PNorm(real high, real low, real p)
{
  NestedNorm norm;
  norm.value = high;
  norm.byHigh = real(1.0);
  norm.byLow = real(0.0);
  real ratio = high > real(0.0) ? low / high : real(0.0);
  if (ratio > real(RTG_NESTED_TINY))
  {
    real power = SafeExp2(p * log2(ratio));
    real root = exp2(log2(real(1.0) + power) / p);
    norm.value = high * root;
    norm.byHigh = root / (real(1.0) + power);
    norm.byLow = norm.byHigh * (power / ratio);
  }
  return norm;
}

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

// Newton from outside: the first s on the way from `from` to `to` with g = 1. False: none.
RTG_FN bool NestedNewton(NestedForm form, real3 o, real3 d, real from, real to, RTG_OUT(real) s)
{
  real way = to >= from ? real(1.0) : real(-1.0);
  s = from;
  for (int i = 0; i < 48; ++i)
  {
    real2 g = NestedGauge(form, o, d, s);
    real above = g.x - real(1.0);
    if (above <= real(4.0 * RTG_ROUNDOFF))
    {
      return true;
    }
    real slope = way * g.y;
    if (!(slope < real(0.0)))
    {
      return false;
    }
    real step = -above / slope;
    s += way * step;
    if (way * (s - to) > real(0.0))
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

// log2 of x / Rx and y / Ry. At s = plane.x the coordinate x is zero whatever rounding makes of o + s d, and so on: next to
// the rim of a concave profile the difference matters.
RTG_FN real2 NestedQuotients(NestedForm form, real3 o, real3 d, real3 plane, real s)
{
  real3 v = o + s * d;
  real3 a = max(real3(s == plane.x ? real(0.0) : abs(v.x), s == plane.y ? real(0.0) : abs(v.y),
                  s == plane.z ? real(0.0) : abs(v.z)),
    real3(real(RTG_NESTED_TINY)));
  real z = log2(a.z);
  real rx = log2(max(real(1.0) - SafeExp2(form.q * z), real(RTG_NESTED_TINY))) / form.q;
  real ry = rx;
  if (form.twoProfiles)
  {
    ry = log2(max(real(1.0) - SafeExp2(form.r * z), real(RTG_NESTED_TINY))) / form.r;
  }
  return real2(log2(a.x) - rx, log2(a.y) - ry);
}

// log2 of the p-norm of two numbers that are given by their logarithms.
RTG_FN real LogNorm(NestedForm form, real2 l)
{
  real high = max(l.x, l.y);
  real low = min(l.x, l.y);
  return high + log2(real(1.0) + SafeExp2(form.p * (low - high))) / form.p;
}

// The sign of the slope of N along the ray.
RTG_FN real NestedRise(NestedForm form, real3 o, real3 d, real s)
{
  real3 v = o + s * d;
  real3 a = max(abs(v), real3(real(RTG_NESTED_TINY)));
  real3 towards = real3(v.x < real(0.0) ? -d.x : d.x, v.y < real(0.0) ? -d.y : d.y, v.z < real(0.0) ? -d.z : d.z) / a;
  real z = log2(a.z);
  real powerX = SafeExp2(form.q * z);
  real restX = max(real(1.0) - powerX, real(RTG_NESTED_TINY));
  real powerY = powerX;
  real restY = restX;
  if (form.twoProfiles)
  {
    powerY = SafeExp2(form.r * z);
    restY = max(real(1.0) - powerY, real(RTG_NESTED_TINY));
  }
  real x = log2(a.x) - log2(restX) / form.q;
  real y = log2(a.y) - log2(restY) / form.r;
  real share = SafeExp2(form.p * (min(x, y) - max(x, y)));
  real riseX = towards.x + powerX / restX * towards.z;
  real riseY = towards.y + powerY / restY * towards.z;
  return x > y ? riseX + share * riseY : share * riseX + riseY;
}

// The extremum of x / R along the ray, R with exponent q: x' z^(1-q) = x' z - x z'. `none` when there is none.
RTG_FN real NestedExtremum(real x, real dx, real z, real dz, real q, real none)
{
  real base = (z * dx - x * dz) / dx;
  if (dx == real(0.0) || dz == real(0.0) || !(base > real(RTG_NESTED_TINY)) || abs(q - real(1.0)) < real(1e-6))
  {
    return none;
  }
  return (exp2(max(min(log2(base) / (real(1.0) - q), real(100.0)), real(-100.0))) - z) / dz;
}

// A zero of LogNorm in [a, b], whose signs at the ends differ.
RTG_FN real NestedBracketed(NestedForm form, real3 o, real3 d, real3 plane, real a, real fa, real b, real fb)
{
  // Chandrupatla's names: the zero is between x1 and x2, x3 is an earlier x1.
  real x1 = b, x2 = a, x3 = b;
  real f1 = fb, f2 = fa, f3 = fb;
  real t = real(0.5);
  for (int i = 0; i < 60; ++i)
  {
    real x = x1 + t * (x2 - x1);
    real f = LogNorm(form, NestedQuotients(form, o, d, plane, x));
    if ((f > real(0.0)) == (f1 > real(0.0)))
    {
      x3 = x1;
      f3 = f1;
    }
    else
    {
      x3 = x2;
      f3 = f2;
      x2 = x1;
      f2 = f1;
    }
    x1 = x;
    f1 = f;
    real best = abs(f2) < abs(f1) ? x2 : x1;
    real width = abs(x2 - x1);
    real least = real(2.0 * RTG_ROUNDOFF) * (abs(best) + real(0.01));
    if (width <= real(2.0) * least || f == real(0.0))
    {
      return best;
    }
    real xi = (x1 - x2) / (x3 - x2);
    real phi = (f1 - f2) / (f3 - f2);
    t = real(0.5);
    if (phi * phi < xi && (real(1.0) - phi) * (real(1.0) - phi) < real(1.0) - xi)
    {
      t = f1 / (f2 - f1) * (f3 / (f2 - f3)) + (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2));
    }
    real margin = least / width;
    t = max(margin, min(real(1.0) - margin, t));
  }
  return x1;
}

// The logarithm of g, or of N, at a point, and its gradient in absolute coordinates.
struct NestedPoint
{
  DoubleWord value;
  real3 gradient;
};

// log (high^p + low^p)^(1/p), p = 2 / exponent, of numbers given by their logarithms, and the share of each in the
// sum of powers. A rounded p would be another surface, as a grazing ray notices.
RTG_FN DoubleWord LogNorm(DoubleWord a, DoubleWord b, real exponent, RTG_OUT(real2) share)
{
  bool aHigh = !IsLess(a, b);
  DoubleWord high = a;
  DoubleWord low = b;
  if (!aHigh)
  {
    high = b;
    low = a;
  }
  DoubleWord p = Divide(Word(real(2.0)), exponent);
  DoubleWord power = Exponential(Multiply(Subtract(low, high), p));
  real highShare = real(1.0) / (real(1.0) + power.hi);
  real lowShare = power.hi * highShare;
  share = aHigh ? real2(highShare, lowShare) : real2(lowShare, highShare);
  if (power.hi == real(0.0))
  {
    return high;
  }
  return Add(high, Multiply(Logarithm(Add(power, real(1.0))), real(0.5) * exponent));
}

// log R of a profile with q = 2 / exponent at log z, and -z d(log R)/dz.
RTG_FN DoubleWord LogProfile(DoubleWord logZ, real exponent, RTG_OUT(real) fall)
{
  DoubleWord power = Exponential(Multiply(logZ, Divide(Word(real(2.0)), exponent)));
  DoubleWord rest = Add(Minus(power), real(1.0));
  fall = power.hi / max(rest.hi, real(RTG_NESTED_TINY));
  return Multiply(Logarithm(rest), real(0.5) * exponent);
}

RTG_FN DoubleWord Magnitude(DoubleWord a)
{
  if (a.hi < real(0.0))
  {
    return Minus(a);
  }
  return a;
}

RTG_FN NestedPoint NestedAt(NestedForm form, DoubleWord3 at)
{
  DoubleWord x = Logarithm(Magnitude(WordX(at)));
  DoubleWord y = Logarithm(Magnitude(WordY(at)));
  DoubleWord z = Logarithm(Magnitude(WordZ(at)));
  NestedPoint point;
  real2 inner;
  real3 share;
  if (form.convex)
  {
    real2 outer;
    DoubleWord rho = LogNorm(x, y, form.exponents.x, inner);
    point.value = LogNorm(rho, z, form.exponents.y, outer);
    share = real3(outer.x * inner.x, outer.x * inner.y, outer.y);
  }
  else
  {
    real fallX;
    DoubleWord rx = LogProfile(z, form.exponents.y, fallX);
    real fallY = fallX;
    DoubleWord ry = rx;
    if (form.twoProfiles)
    {
      ry = LogProfile(z, form.exponents.z, fallY);
    }
    point.value = LogNorm(Subtract(x, rx), Subtract(y, ry), form.exponents.x, inner);
    share = real3(inner.x, inner.y, inner.x * fallX + inner.y * fallY);
  }
  point.gradient = share / max(abs(at.hi), real3(real(RTG_NESTED_TINY)));
  return point;
}

RTG_FN real NestedSlope(NestedPoint point, LocalRay ray)
{
  real3 o = ray.origin.hi;
  real3 d = ray.direction.hi;
  real3 towards = real3(o.x < real(0.0) ? -d.x : d.x, o.y < real(0.0) ? -d.y : d.y, o.z < real(0.0) ? -d.z : d.z);
  return dot(point.gradient, towards);
}

// About the second derivative along the ray; rather too large.
RTG_FN real NestedBend(NestedForm form, NestedPoint point, LocalRay ray)
{
  real3 d = ray.direction.hi;
  real3 bends = point.gradient * (d * d) / max(abs(ray.origin.hi), real3(real(RTG_NESTED_TINY)));
  return (real(1.0) + max(form.p, max(form.q, form.r))) * (bends.x + bends.y + bends.z);
}

// The crossing near s, in double words: `at` is the ray with its origin there. `way` is 1 where the surface is entered
// along the ray and -1 where it is left; `speed` is the length of the ray's direction. False: there is none.
RTG_FN bool NestedPolish(NestedForm form, LocalRay ray, real s, real way, real speed, RTG_OUT(LocalRay) at)
{
  at = Advance(ray, s);
  LocalRay plain = at;
  int backwards = 0;
  bool stepped = false;
  for (int i = 0; i < 24; ++i)
  {
    NestedPoint point = NestedAt(form, at.origin);
    real slope = way * NestedSlope(point, at);
    real value = point.value.hi + point.value.lo;
    if (!(abs(value) < real(0.5)) || !(abs(slope) < real(RTG_NEVER)) ||
      !(abs(at.start.hi - plain.start.hi) * speed <
        (form.convex ? real(4.0) : real(0.01)) + real(4.0 * RTG_ROUNDOFF) * abs(at.start.hi) * speed))
    {
      // At a tip, or at a rim closer than rounding: the plain solution is as good as it gets.
      at = plain;
      return form.convex;
    }
    // Grazing: the plain solution may be past the closest point. Start anew from before it.
    bool past = !(slope < real(0.0));
    if (past && form.convex && stepped && value <= real(0.0))
    {
      // A tangent from outside ends behind the crossing only by rounding: at a rim, where the slope changes at once.
      return true;
    }
    bool grazing = i == 0 && -slope < real(0.02) * speed;
    if (past || grazing)
    {
      if (backwards >= 2)
      {
        // Past the closest point twice and on the same side all the time: no crossing. Convex glyphs are met from
        // outside, from either end of the ray.
        at = plain;
        return !((form.convex ? value : way * value) > real(0.0));
      }
      ++backwards;
      stepped = false;
      at = Advance(at, -way * real(0.003) / speed);
    }
    else
    {
      // From the logarithm to the gauge, which is the convex one of the two.
      real step = value;
      if (form.convex)
      {
        step = value * (real(1.0) + real(0.5) * value) / (real(1.0) + value);
      }
      step = -step / slope;
      real bend = step * step * NestedBend(form, point, at);
      at = Advance(at, way * step);
      stepped = true;
      // What a tangent leaves is half the second derivative times the square of the step, over the slope.
      if (bend * speed <= real(RTG_ROUNDOFF) * -slope || abs(step) * speed < real(0.25 * RTG_ROUNDOFF))
      {
        return true;
      }
    }
  }
  return true;
}

// The ray with its origin where it passes the coordinate plane of the given axis, which is near s.
RTG_FN LocalRay AtPlane(LocalRay ray, real s, int axis)
{
  LocalRay at = Advance(ray, s);
  real3 back = at.origin.hi / at.direction.hi;
  at = Advance(at, axis == 0 ? -back.x : axis == 1 ? -back.y : -back.z);
  real3 keep = real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0),
    axis == 2 ? real(0.0) : real(1.0));
  at.origin.hi = at.origin.hi * keep;
  at.origin.lo = at.origin.lo * keep;
  return at;
}

// What is found: the ray with its origin at the crossing, and t.
struct NestedCrossing
{
  bool found;
  real t;
  LocalRay at;
};

RTG_FN NestedCrossing NestedConvex(NestedForm form, LocalRay ray, real3 o, real3 d, real speed, real sIn, real sOut,
  real tMin, real tMax)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  crossing.at = ray;
  real s;
  if (!NestedNewton(form, o, d, sIn, sOut, s) ||
    !NestedPolish(form, ray, s / speed, real(1.0), speed, crossing.at))
  {
    return crossing;
  }
  crossing.t = crossing.at.start.hi;
  if (crossing.t < tMin && NestedNewton(form, o, d, sOut, sIn, s) &&
    NestedPolish(form, ray, s / speed, real(-1.0), speed, crossing.at))
  {
    crossing.t = crossing.at.start.hi;
  }
  crossing.found = crossing.t >= tMin && crossing.t <= tMax;
  return crossing;
}

RTG_FN NestedCrossing NestedPieces(NestedForm form, LocalRay ray, real3 o, real3 d, real speed, real sIn, real sOut,
  real tMin, real tMax)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  crossing.at = ray;

  // Where the ray passes the coordinate planes, in order
  real3 plane = real3(d.x != real(0.0) ? -o.x / d.x : real(RTG_NEVER),
    d.y != real(0.0) ? -o.y / d.y : real(RTG_NEVER), d.z != real(0.0) ? -o.z / d.z : real(RTG_NEVER));
  real3 cut = max(real3(sIn), min(real3(sOut), plane));
  real first = min(cut.x, min(cut.y, cut.z));
  real last = max(cut.x, max(cut.y, cut.z));
  real second = max(min(cut.x, cut.y), min(max(cut.x, cut.y), cut.z));

  bool inside = false;
  real from = sIn;
  real2 fromLogs = NestedQuotients(form, o, d, plane, sIn);
  int budget = RTG_NESTED_BUDGET;
  for (int octant = 0; octant < 4; ++octant)
  {
    real octantEnd = octant == 0 ? first : octant == 1 ? second : octant == 2 ? last : sOut;
    if (!(octantEnd > from))
    {
      continue;
    }
    // In the octant all coordinates are positive: those of its middle tell the signs.
    real middle = real(0.5) * (from + octantEnd);
    real3 m = o + middle * d;
    real3 signs = real3(m.x < real(0.0) ? real(-1.0) : real(1.0), m.y < real(0.0) ? real(-1.0) : real(1.0),
      m.z < real(0.0) ? real(-1.0) : real(1.0));
    real3 v = signs * o;
    real3 dv = signs * d;
    real turnX = NestedExtremum(v.x, dv.x, v.z, dv.z, form.q, octantEnd);
    real turnY = NestedExtremum(v.y, dv.y, v.z, dv.z, form.r, octantEnd);
    turnX = max(from, min(octantEnd, turnX));
    turnY = max(from, min(octantEnd, turnY));

    for (int piece = 0; piece < 3; ++piece)
    {
      real end = piece == 0 ? min(turnX, turnY) : piece == 1 ? max(turnX, turnY) : octantEnd;
      if (!(end > from))
      {
        continue;
      }
      real2 endLogs = NestedQuotients(form, o, d, plane, end);
      bool together = (endLogs.x - fromLogs.x) * (endLogs.y - fromLogs.y) >= real(0.0);
      real width = end - from;
      while (from < end)
      {
        --budget;
        // The window [from, to]: can N = 1 in it?
        real to = from + width;
        real2 logs = endLogs;
        if (to < end)
        {
          logs = NestedQuotients(form, o, d, plane, to);
        }
        else
        {
          to = end;
        }
        real f = LogNorm(form, logs);
        bool changes = (f <= real(0.0)) != inside;
        bool certain = together || budget < 0;
        bool touches = false;
        real touch = to;
        real way = inside ? real(-1.0) : real(1.0);
        if (!certain)
        {
          real bound = inside ? LogNorm(form, max(logs, fromLogs)) : LogNorm(form, min(logs, fromLogs));
          certain = inside ? bound < real(0.0) : bound > real(0.0);
          certain = certain || (changes && width < real(4e-4));
          // Short beside the distances from rim and tip: at most one extremum is in it, where the ray may touch.
          real away = min(abs(o.z + from * d.z), abs(o.z + to * d.z));
          away = min(away, real(1.0) - max(abs(o.z + from * d.z), abs(o.z + to * d.z)));
          bool atEnd = !certain && (width < real(16.0 * RTG_ROUNDOFF) || (width < real(4e-4) && width < real(0.06) * away));
          certain = certain || atEnd;
          if (atEnd && way * NestedRise(form, o, d, from) < real(0.0) && way * NestedRise(form, o, d, to) > real(0.0))
          {
            real below = from;
            real above = to;
            for (int k = 0; k < 14; ++k)
            {
              touch = real(0.5) * (below + above);
              bool falls = way * NestedRise(form, o, d, touch) < real(0.0);
              below = falls ? touch : below;
              above = falls ? above : touch;
            }
            touches = way * LogNorm(form, NestedQuotients(form, o, d, plane, touch)) < real(64.0 * RTG_ROUNDOFF);
          }
        }
        if (!certain)
        {
          width *= real(0.5);
          continue;
        }
        if (changes || touches)
        {
          real s = touch;
          if (changes)
          {
            s = NestedBracketed(form, o, d, plane, from, LogNorm(form, fromLogs), to, f);
          }
          LocalRay at;
          // A change of sign that is more than rounding needs no confirmation. At a tip everything is rounding.
          real end = inside ? from : to;
          bool sure = changes && min(abs(f), abs(LogNorm(form, fromLogs))) > real(256.0 * RTG_ROUNDOFF) &&
            abs(o.z + end * d.z) < real(0.99);
          bool polished = NestedPolish(form, ray, s / speed, way, speed, at);
          bool crosses = polished || sure;
          int axis = end == plane.z ? 2 : end == plane.x ? 0 : end == plane.y ? 1 : -1;
          if (!sure && changes && axis >= 0)
          {
            // Whether the glyph's rim or tip reaches this far, double words tell in the plane where it does.
            LocalRay sharp = AtPlane(ray, end / speed, axis);
            DoubleWord value = NestedAt(form, sharp.origin).value;
            crosses = value.hi <= real(0.0);
            if (!polished && value.hi > real(-64.0 * RTG_ROUNDOFF))
            {
              at = sharp;
            }
          }
          inside = inside != crosses;
          real t = at.start.hi;
          if (crosses && t >= tMin)
          {
            crossing.found = t <= tMax;
            crossing.t = t;
            crossing.at = at;
            return crossing;
          }
        }
        from = to;
        fromLogs = logs;
        width *= real(2.0);
      }
      from = end;
      fromLogs = endLogs;
    }
  }
  return crossing;
}

RTG_FN NestedCrossing NestedSuperquadricCrossing(GlyphRay ray, Glyph glyph, real tMin, real tMax)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  LocalRay local;
  if (!ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local))
  {
    crossing.at = local;
    return crossing;
  }

  // The origin next to the centre, plain copies with a direction of length one, the chord through the box
  real speed = length(local.direction.hi);
  local = Advance(local, -dot(local.origin.hi, local.direction.hi) / (speed * speed));
  crossing.at = local;
  real3 o = local.origin.hi;
  real3 d = local.direction.hi / speed;
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
    return crossing;
  }
  NestedForm form = MakeNestedForm(glyph.exponents);
  if (form.convex)
  {
    return NestedConvex(form, local, o, d, speed, sIn, sOut, tMin, tMax);
  }
  return NestedPieces(form, local, o, d, speed, sIn, sOut, tMin, tMax);
}

RTG_FN bool IntersectNestedSuperquadric(GlyphRay ray, Glyph glyph, real tMin, real tMax, RTG_OUT(real) t)
{
  NestedCrossing crossing = NestedSuperquadricCrossing(ray, glyph, tMin, tMax);
  t = crossing.t;
  return crossing.found;
}

RTG_FN real3 NestedSuperquadricNormal(GlyphRay ray, Glyph glyph, real t)
{
  NestedCrossing crossing = NestedSuperquadricCrossing(ray, glyph, Before(ray, glyph, t), real(RTG_NEVER));
  NestedForm form = MakeNestedForm(glyph.exponents);
  real3 p = crossing.at.origin.hi;
  real3 gradient = NestedAt(form, crossing.at.origin).gradient;
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

// Half the extent along each world axis is the glyph's support function there: of the dual norms, one in the other. A profile
// that is convex towards the axis (beta > 2) reaches as far as its hull. Of two profiles the fuller one counts,
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
