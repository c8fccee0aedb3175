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
// has y / Ry. The chord is cut there and at the three coordinate planes, whose order double words tell: at most twelve pieces, on each
// of which both quotients are monotone. What a window [a, b] of a piece holds is known from its ends (NestedLook):
//   - Both quotients rise or both fall, or one is all there is: their p-norm N is monotone, and has one crossing or none.
//   - N lies between the p-norms of the smaller and of the larger quotients at the ends: all outside, or all inside.
//   - The slope of N^p / p is |x|^(p-1) Rx^-p x' + (x / Rx)^p fall z' and the same of y, whose factors are monotone, so
//     that the ends bound it: N may be monotone, or lines from the ends tell that it does not come near 1.
// Else it is cut where those lines leave room. Every value comes with a bound of its rounding, and what is less than that,
// a sign at a window's end or a window in which N touches 1 within rounding, is left to double words. Nothing is
// sampled; windows in which all coordinates and quotients change by less than 0.4 % (for sharp edges: less than the rounding of the
// edge) count as having one extremum at most. A crossing is bracketed and found by Chandrupatla's method (Advances in
// Engineering Software 28(3), 1997), which never leaves its bracket. Probes are counted: 3 on average, above RTG_NESTED_BUDGET only for
// rays that lie within rounding of the surface all along.
//
// Both: the last steps are Newton's on the logarithm of g, or of N, in double words (WordFunctions.glsl), until what a tangent
// leaves is below rounding: the plain solution knows the surface to 1e-6 only, and a grazing ray wants 1e-11. Where the terms of
// the slope cancel they are double words too, inside a bracket (NestedSettle).
// No hit is invented: each one is a change of sign.
#ifndef RTG_NESTED_SUPERQUADRIC
#define RTG_NESTED_SUPERQUADRIC

#include "Box.glsl"
#include "Disc.glsl"
#include "Span.glsl"
#include "WordFunctions.glsl"

#define RTG_NESTED_BUDGET 1024
#define RTG_NESTED_LEAST 1.0e-6 // exponent
// Where 1 - z^q is less than what the logarithms know of it, it counts as outside: the end of the axis.
#define RTG_NESTED_END (16.0 * RTG_ROUNDOFF * RTG_ROUNDOFF + 1.0e-22)
#define RTG_NESTED_TINY (RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF)

struct NestedForm
{
  real p;
  real q;
  real r;
  real3 exponents; // alpha, beta, c, which p, q and r are rounded from
  bool convex;
  bool twoProfiles;
  real2 steepAt;   // of a profile with q < 1: |z| where -d(log R)/d|z| is least, and that; 0 for others
  real2 leastFall;
};

// Where z^(q - 1) / (1 - z^q) is least: z^q = 1 - q.
RTG_FN real LeastFallAt(real q)
{
  return q < real(1.0) ? exp2(max(log2(max(real(1.0) - q, real(1e-6))) / q, real(-60.0))) : real(0.0);
}

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
  form.steepAt = real2(real(0.0));
  form.leastFall = real2(real(0.0));
  if (!form.convex)
  {
    form.steepAt = real2(LeastFallAt(form.q), LeastFallAt(form.r));
    form.leastFall.x = form.q < real(1.0) ? exp2((form.q - real(1.0)) * log2(form.steepAt.x)) / form.q : real(0.0);
    form.leastFall.y = form.r < real(1.0) ? exp2((form.r - real(1.0)) * log2(form.steepAt.y)) / form.r : real(0.0);
  }
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

// What plain arithmetic knows of the surface at one point of the ray.
struct NestedProbe
{
  DoubleWord where; // on the ray
  int axis;         // of the coordinate plane that the point is on, else -1
  bool outside;     // for certain
  real height;      // |z|
  real2 lows;       // log2 |x|, log2 |y|
  real2 logs;       // log2 |x| / Rx, log2 |y| / Ry
  real2 falls;      // -d(log R) / d|z|
  real2 doubts;     // rounding of the logs
  real f;           // log2 N
  real noise;       // rounding of f
};

// log2 of the p-norm of two numbers that are given by their logarithms.
RTG_FN real LogNorm(NestedForm form, real2 l)
{
  real high = max(l.x, l.y);
  real low = min(l.x, l.y);
  return high + log2(real(1.0) + SafeExp2(form.p * (low - high))) / form.p;
}

// log2 R of a profile at log2 |z| and its fall.
RTG_FN real PlainProfile(real z, real logZ, real q, RTG_OUT(real) fall)
{
  real power = SafeExp2(q * logZ);
  real rest = max(real(1.0) - power, real(RTG_NESTED_TINY));
  fall = power / (rest * z);
  return log2(rest) / q;
}

RTG_FN real LogNAt(NestedForm form, real3 o, real3 d, real s)
{
  real3 a = max(abs(o + s * d), real3(real(RTG_NESTED_TINY)));
  real z = log2(a.z);
  real fall;
  real rx = PlainProfile(a.z, z, form.q, fall);
  real ry = rx;
  if (form.twoProfiles)
  {
    ry = PlainProfile(a.z, z, form.r, fall);
  }
  return LogNorm(form, real2(log2(a.x) - rx, log2(a.y) - ry));
}

// What rounding does to log2 R: `rounding` is that of |z|, built-in logarithms and powers are good to 2^-20. Where 1 - z^q is next to
// nothing it may be nothing, but not much more: that is the certain side when the point is outside.
RTG_FN real ProfileDoubt(real fall, real z, real q, real rounding, bool outside)
{
  real share = q * rounding * fall + real(16.0 * RTG_ROUNDOFF) * (real(1.0) + q) * (real(1.0) + fall * z);
  return share < real(0.5) ? real(2.0) * share / q : outside ? log2(real(1.0) + share) / q : real(1e9);
}

// On the coordinate plane of `axis` that coordinate is zero whatever rounding makes of o + s d: next to the rim of a
// concave profile the difference matters.
RTG_FN NestedProbe NestedProbeAt(NestedForm form, real3 o, real3 d, DoubleWord where, int axis)
{
  real3 way = where.hi * d;
  real3 known = real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0),
    axis == 2 ? real(0.0) : real(1.0));
  real3 a = max(known * abs(o + way), real3(real(RTG_NESTED_TINY)));
  real u = real(RTG_ROUNDOFF);
  real3 rounding = real(4.0) * u * (known * (abs(o) + abs(way)));
  real3 l = log2(a);
  NestedProbe probe;
  probe.where = where;
  probe.axis = axis;
  probe.height = a.z;
  probe.lows = real2(l.x, l.y);
  real rx = PlainProfile(a.z, l.z, form.q, probe.falls.x);
  real ry = rx;
  probe.falls.y = probe.falls.x;
  if (form.twoProfiles)
  {
    ry = PlainProfile(a.z, l.z, form.r, probe.falls.y);
  }
  probe.logs = real2(l.x - rx, l.y - ry);
  probe.f = LogNorm(form, probe.logs);
  probe.outside = probe.f > real(0.0);
  probe.doubts.x = ProfileDoubt(probe.falls.x, a.z, form.q, rounding.z, probe.outside);
  probe.doubts.y = probe.doubts.x;
  if (form.twoProfiles)
  {
    probe.doubts.y = ProfileDoubt(probe.falls.y, a.z, form.r, rounding.z, probe.outside);
  }
  probe.doubts.x += real(16.0) * u + real(2.0) * rounding.x / a.x;
  probe.doubts.y += real(16.0) * u + real(2.0) * rounding.y / a.y;
  // Outside the larger quotient alone keeps N up; inside neither may be large.
  probe.noise = real(16.0) * u * (real(1.0) + real(1.0) / form.p);
  if (probe.outside)
  {
    probe.noise += SafeExp2(form.p * (probe.logs.x - probe.f)) * probe.doubts.x +
      SafeExp2(form.p * (probe.logs.y - probe.f)) * probe.doubts.y;
  }
  else
  {
    probe.noise += LogNorm(form, probe.logs + probe.doubts) - probe.f;
  }
  return probe;
}

// Bounds of the derivative of (x / R)^p / p along the ray between two probes, over 2^(p unit): that is
//   |x|^(p-1) R^-p x' + (x / R)^p fall z',
// in which every factor is monotone, but for the fall of a profile with q < 1.
RTG_FN real2 NestedSlopeOfTerm(real p, real unit, real2 lows, real2 logs, real2 falls, real2 heights, real steepAt,
  real leastFall, real2 doubts, real dx, real dz)
{
  real2 k = (p - real(1.0)) * lows;
  real2 r = lows - logs;
  real most = SafeExp2(max(k.x, k.y) - p * (min(r.x, r.y) + unit));
  real least = SafeExp2(min(k.x, k.y) - p * (max(r.x, r.y) + unit));
  bool dips = steepAt > min(heights.x, heights.y) && steepAt < max(heights.x, heights.y);
  real fallMost = SafeExp2(p * (max(logs.x, logs.y) - unit)) * max(falls.x, falls.y);
  real fallLeast = SafeExp2(p * (min(logs.x, logs.y) - unit)) * (dips ? leastFall : min(falls.x, falls.y));
  real pad = (real(1.0) + p) * min(doubts.x, doubts.y) * (abs(dx) * most + abs(dz) * fallMost);
  real low = dx * (dx < real(0.0) ? most : least) + dz * (dz < real(0.0) ? fallMost : fallLeast);
  real high = dx * (dx < real(0.0) ? least : most) + dz * (dz < real(0.0) ? fallLeast : fallMost);
  return real2(low - pad, high + pad);
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

// A zero of log N in [a, b], whose signs at the ends differ.
RTG_FN real NestedBracketed(NestedForm form, real3 o, real3 d, real a, real fa, real b, real fb)
{
  // Chandrupatla's names: the zero is between x1 and x2, x3 is an earlier x1.
  real x1 = b, x2 = a, x3 = b;
  real f1 = fb, f2 = fa, f3 = fb;
  real t = real(0.5);
  for (int i = 0; i < 60; ++i)
  {
    real x = x1 + t * (x2 - x1);
    real f = LogNAt(form, o, d, x);
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
    if (width <= real(2.0) * least || abs(f) <= real(8.0 * RTG_ROUNDOFF))
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

// log (high^p + low^p)^(1/p), p = 2 / exponent, of numbers given by their logarithms; which of them is high, and the power of low
// over high. A rounded p would be another surface, as a grazing ray notices.
RTG_FN DoubleWord LogNorm(DoubleWord a, DoubleWord b, real exponent, RTG_OUT(bool) aHigh, RTG_OUT(DoubleWord) power)
{
  aHigh = !IsLess(a, b);
  DoubleWord high = a;
  DoubleWord low = b;
  if (!aHigh)
  {
    high = b;
    low = a;
  }
  power = Exponential(Multiply(Subtract(low, high), Divide(Word(real(2.0)), exponent)));
  if (power.hi == real(0.0))
  {
    return high;
  }
  return Add(high, Multiply(Logarithm(Add(power, real(1.0))), real(0.5) * exponent));
}

// The same, and the share of each in the sum of powers.
RTG_FN DoubleWord LogNorm(DoubleWord a, DoubleWord b, real exponent, RTG_OUT(real2) share)
{
  bool aHigh;
  DoubleWord power;
  DoubleWord norm = LogNorm(a, b, exponent, aHigh, power);
  real highShare = real(1.0) / (real(1.0) + power.hi);
  real lowShare = power.hi * highShare;
  share = aHigh ? real2(highShare, lowShare) : real2(lowShare, highShare);
  return norm;
}

RTG_FN DoubleWord Magnitude(DoubleWord a)
{
  if (a.hi < real(0.0))
  {
    return Minus(a);
  }
  return a;
}

RTG_FN NestedPoint NestedConvexAt(NestedForm form, DoubleWord3 at)
{
  DoubleWord x = Logarithm(Magnitude(WordX(at)));
  DoubleWord y = Logarithm(Magnitude(WordY(at)));
  DoubleWord z = Logarithm(Magnitude(WordZ(at)));
  NestedPoint point;
  real2 inner;
  real2 outer;
  DoubleWord rho = LogNorm(x, y, form.exponents.x, inner);
  point.value = LogNorm(rho, z, form.exponents.y, outer);
  real3 share = real3(outer.x * inner.x, outer.x * inner.y, outer.y);
  point.gradient = share / max(abs(at.hi), real3(real(RTG_NESTED_TINY)));
  return point;
}

// log R of a profile with q = 2 / exponent at log z, and -z d(log R)/dz.
RTG_FN DoubleWord LogProfile(DoubleWord logZ, real exponent, RTG_OUT(DoubleWord) fall)
{
  DoubleWord power = Exponential(Multiply(logZ, Divide(Word(real(2.0)), exponent)));
  DoubleWord rest = Add(Minus(power), real(1.0));
  if (!(rest.hi > real(RTG_NESTED_END)))
  {
    rest = Word(real(RTG_NESTED_END));
  }
  fall = Divide(power, rest);
  return Multiply(Logarithm(rest), real(0.5) * exponent);
}

RTG_FN DoubleWord RateOf(DoubleWord x, DoubleWord dx)
{
  if (!(abs(x.hi) > real(1e-30)))
  {
    return Word(real(0.0));
  }
  return Divide(dx, x);
}

// The logarithm of N at the origin of a ray, with its slope along that: the terms of a slope cancel where the ray grazes.
struct NestedProfilePoint
{
  DoubleWord value;
  real slope;
  real bend;      // about the second derivative along the ray; rather too large
  real3 gradient; // in absolute coordinates
};

RTG_FN NestedProfilePoint NestedProfileAt(NestedForm form, LocalRay at)
{
  DoubleWord z = Logarithm(Magnitude(WordZ(at.origin)));
  DoubleWord fallX;
  DoubleWord rx = LogProfile(z, form.exponents.y, fallX);
  DoubleWord fallY = fallX;
  DoubleWord ry = rx;
  if (form.twoProfiles)
  {
    ry = LogProfile(z, form.exponents.z, fallY);
  }
  DoubleWord x = Subtract(Logarithm(Magnitude(WordX(at.origin))), rx);
  DoubleWord y = Subtract(Logarithm(Magnitude(WordY(at.origin))), ry);

  // The p-norm of the quotients, and the share of each in the sum of powers
  NestedProfilePoint point;
  bool xHigh;
  DoubleWord power;
  point.value = LogNorm(x, y, form.exponents.x, xHigh, power);
  if (fallX.hi * real(RTG_NESTED_END) > real(0.5) || fallY.hi * real(RTG_NESTED_END) > real(0.5))
  {
    point.value = Word(real(100.0));
  }
  DoubleWord shareX = Divide(Word(real(1.0)), Add(power, real(1.0)));
  DoubleWord shareY = Multiply(power, shareX);
  if (!xHigh)
  {
    DoubleWord swapped = shareX;
    shareX = shareY;
    shareY = swapped;
  }

  DoubleWord rateZ = RateOf(WordZ(at.origin), WordZ(at.direction));
  DoubleWord rateX = Add(RateOf(WordX(at.origin), WordX(at.direction)), Multiply(fallX, rateZ));
  DoubleWord rateY = Add(RateOf(WordY(at.origin), WordY(at.direction)), Multiply(fallY, rateZ));
  point.slope = Add(Multiply(shareX, rateX), Multiply(shareY, rateY)).hi;
  // On a flat end x and y tell 1 - z^q = rho^q better than z.
  real unlike = form.q * point.value.hi;
  real mend = form.twoProfiles || !(abs(unlike) < real(0.5)) ? real(1.0) : exp2(real(-1.4426950408889634074) * unlike);
  real3 share = real3(shareX.hi, shareY.hi, mend * (shareX.hi * fallX.hi + shareY.hi * fallY.hi));
  real3 a = max(abs(at.origin.hi), real3(real(RTG_NESTED_TINY)));
  point.gradient = share / a;
  real3 d = at.direction.hi;
  real3 bends = point.gradient * (d * d) / a;
  bends.z *= real(1.0) + max(fallX.hi, fallY.hi);
  point.bend = (real(1.0) + max(form.p, max(form.q, form.r))) * (bends.x + bends.y + bends.z);
  return point;
}

// `steepness` is what the slope would be if its terms did not cancel.
RTG_FN real NestedSlope(NestedPoint point, LocalRay ray, RTG_OUT(real) steepness)
{
  real3 o = ray.origin.hi;
  real3 d = ray.direction.hi;
  real3 towards = real3(o.x < real(0.0) ? -d.x : d.x, o.y < real(0.0) ? -d.y : d.y, o.z < real(0.0) ? -d.z : d.z);
  steepness = dot(point.gradient, abs(d));
  return dot(point.gradient, towards);
}

// About the second derivative along the ray; rather too large.
RTG_FN real NestedBend(NestedForm form, NestedPoint point, LocalRay ray)
{
  real3 d = ray.direction.hi;
  real3 bends = point.gradient * (d * d) / max(abs(ray.origin.hi), real3(real(RTG_NESTED_TINY)));
  return (real(1.0) + max(form.p, max(form.q, form.r))) * (bends.x + bends.y + bends.z);
}

// What is found: the ray with its origin at the crossing, and t.
struct NestedCrossing
{
  bool found;
  real t;
  LocalRay at;
};

// Where the ray passes the coordinate planes, and the axes in that order.
struct NestedPlanes
{
  DoubleWord x;
  DoubleWord y;
  DoubleWord z;
  int first;
  int second;
  int third;
};

RTG_FN DoubleWord PlaneOf(NestedPlanes planes, int axis)
{
  if (axis == 0)
  {
    return planes.x;
  }
  if (axis == 1)
  {
    return planes.y;
  }
  return planes.z;
}

RTG_FN DoubleWord PassesAt(DoubleWord o, DoubleWord d)
{
  if (!(abs(d.hi) > real(RTG_NESTED_TINY)))
  {
    return Word(real(RTG_NEVER));
  }
  return Divide(Minus(o), d);
}

RTG_FN NestedPlanes MakeNestedPlanes(LocalRay ray)
{
  NestedPlanes planes;
  planes.x = PassesAt(WordX(ray.origin), WordX(ray.direction));
  planes.y = PassesAt(WordY(ray.origin), WordY(ray.direction));
  planes.z = PassesAt(WordZ(ray.origin), WordZ(ray.direction));
  bool yx = IsLess(planes.y, planes.x);
  int low = yx ? 1 : 0;
  int high = yx ? 0 : 1;
  bool zFirst = IsLess(planes.z, PlaneOf(planes, low));
  bool zLast = !IsLess(planes.z, PlaneOf(planes, high));
  planes.first = zFirst ? 2 : low;
  planes.second = zFirst ? low : zLast ? high : 2;
  planes.third = zLast ? 2 : high;
  return planes;
}

// The ray with its origin at a point of it; on a coordinate plane that coordinate is zero to the last digit.
RTG_FN LocalRay RayFrom(LocalRay ray, DoubleWord where, int axis)
{
  DoubleWord3 along;
  along.hi = real3(where.hi);
  along.lo = real3(where.lo);
  LocalRay at;
  at.start = Add(ray.start, where);
  at.origin = Add(ray.origin, Multiply(ray.direction, along));
  at.direction = ray.direction;
  real3 keep = real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0),
    axis == 2 ? real(0.0) : real(1.0));
  at.origin.hi = at.origin.hi * keep;
  at.origin.lo = at.origin.lo * keep;
  return at;
}

// Whether a step stays on its side of the coordinate planes, where the surface may be bent all at once.
RTG_FN bool StaysInOctant(LocalRay at, real step)
{
  real3 v = at.origin.hi;
  real3 w = v * (v + step * at.direction.hi);
  return min(w.x, min(w.y, w.z)) >= real(0.0);
}

// What plain arithmetic leaves open, in double words. `low` to `high` is a part of the ray round its origin; at low
// way log N is above zero. `changes`: at high it is not, and the crossing is Newton's or, where that leaves the bracket or
// dawdles, bisection's. Else the least of it is looked for by its slopes, which change their sign once. False: there is none.
RTG_FN bool NestedSettle(NestedForm form, LocalRay ray, real low, real high, real way, bool changes, RTG_OUT(LocalRay) at)
{
  real fine = real(RTG_ROUNDOFF / 64.0) / (real(1.0) + form.p);
  bool root = changes;
  real slopeLow = real(0.0);
  real slopeHigh = real(0.0);
  at = ray;
  for (int i = 0; i < 48; ++i)
  {
    NestedProfilePoint point = NestedProfileAt(form, at);
    real g = way * (point.value.hi + point.value.lo);
    real slope = way * point.slope;
    root = root || g <= real(0.0);
    real step;
    bool settled = false;
    if (root)
    {
      low = g > real(0.0) ? real(0.0) : low;
      high = g > real(0.0) ? high : real(0.0);
      step = -g / slope;
      // What a tangent leaves is half the second derivative times the square of the step, over the slope.
      bool newton = slope < real(0.0) && abs(g) < real(0.5);
      settled = newton &&
        (abs(step) <= real(1e-3) * fine || (point.bend * step * step <= fine * -slope && StaysInOctant(at, step)));
      bool inside = newton && step >= low && step <= high && (i < 12 || (i & 1) == 0);
      if (!settled && !inside)
      {
        step = real(0.5) * (low + high);
        settled = high - low <= fine;
      }
    }
    else
    {
      bool falls = slope < real(0.0);
      low = falls ? real(0.0) : low;
      slopeLow = falls ? slope : slopeLow;
      high = falls ? high : real(0.0);
      slopeHigh = falls ? slopeHigh : slope;
      // The tangent of a convex function stays below it.
      bool above = form.p >= real(1.0) && high - low < real(0.05) && g - abs(slope) * (falls ? high : -low) > real(0.0);
      if (above || !(high - low > fine))
      {
        return false;
      }
      real share = slopeLow < real(0.0) && slopeHigh > real(0.0) && (i & 3) != 3
        ? max(real(0.02), min(real(0.98), slopeLow / (slopeLow - slopeHigh)))
        : real(0.5);
      step = low + share * (high - low);
    }
    at = Advance(at, step);
    low -= step;
    high -= step;
    if (settled)
    {
      return true;
    }
  }
  return root;
}

// The crossing near s where a ray enters a convex glyph, in double words: `at` is the ray with its origin there. `reach` is more than
// the length of its chord through the box. False: there is none.
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
      bool settled =
        (bend <= real(0.125 * RTG_ROUNDOFF) * -slope && StaysInOctant(at, step)) || abs(step) < real(1e-4 * RTG_ROUNDOFF);
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
RTG_FN NestedCrossing NestedConvex(NestedForm form, LocalRay ray, LocalRay unit, real scale, real sIn, real sOut,
  real tMin, real tMax)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  crossing.at = ray;
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

// What is known of a window.
#define RTG_NESTED_EMPTY 0
#define RTG_NESTED_UNIQUE 1 // it has one crossing, which plain arithmetic finds
#define RTG_NESTED_SETTLE 2 // only double words can tell
#define RTG_NESTED_SPLIT 3  // at `next`

RTG_FN int NestedLook(NestedForm form, NestedProbe a, NestedProbe b, real3 towards, RTG_OUT(real) next)
{
  real way = a.outside ? real(1.0) : real(-1.0);
  bool changes = a.outside != b.outside;
  int unique = changes ? RTG_NESTED_UNIQUE : RTG_NESTED_EMPTY;
  real width = Subtract(b.where, a.where).hi;
  bool narrow = !(width > real(64.0 * RTG_ROUNDOFF));
  real noise = a.noise + b.noise;
  next = a.where.hi;

  real2 rises = b.logs - a.logs;
  real2 doubts = a.doubts + b.doubts;
  bool together = abs(rises.x) > doubts.x && abs(rises.y) > doubts.y && (rises.x > real(0.0)) == (rises.y > real(0.0));
  // One of the quotients is all there is.
  real apart = max(min(a.logs.x, b.logs.x) - max(a.logs.y, b.logs.y), min(a.logs.y, b.logs.y) - max(a.logs.x, b.logs.x));
  bool alone = form.p * (apart - max(doubts.x, doubts.y)) > real(60.0);
  if ((together || alone) && !narrow)
  {
    return unique;
  }
  real bound = a.outside ? LogNorm(form, min(a.logs - a.doubts, b.logs - b.doubts))
                         : -LogNorm(form, max(a.logs + a.doubts, b.logs + b.doubts));
  if (!changes && bound > real(32.0 * RTG_ROUNDOFF))
  {
    return RTG_NESTED_EMPTY;
  }
  if (narrow)
  {
    return RTG_NESTED_SETTLE;
  }

  // Over the largest term, so that nothing that counts under- or overflows; f' = slope 2^(p (most - f)) with least <= f
  real2 largest = max(a.logs, b.logs);
  real most = max(largest.x, largest.y);
  real least = LogNorm(form, min(a.logs, b.logs));
  real2 heights = real2(a.height, b.height);
  real2 slopes = NestedSlopeOfTerm(form.p, most, real2(a.lows.x, b.lows.x), real2(a.logs.x, b.logs.x),
                   real2(a.falls.x, b.falls.x), heights, form.steepAt.x, form.leastFall.x,
                   real2(a.doubts.x, b.doubts.x), towards.x, towards.z) +
    NestedSlopeOfTerm(form.p, most, real2(a.lows.y, b.lows.y), real2(a.logs.y, b.logs.y),
      real2(a.falls.y, b.falls.y), heights, form.steepAt.y, form.leastFall.y, real2(a.doubts.y, b.doubts.y), towards.y,
      towards.z);
  real low = real(1.4426950408889634074) * (a.outside ? slopes.x : -slopes.y);
  real high = real(1.4426950408889634074) * (a.outside ? slopes.y : -slopes.x);
  if (low >= real(0.0) || high <= real(0.0))
  {
    return unique;
  }
  real stretch = form.p * (most - least);
  stretch = stretch < real(60.0) ? exp2(stretch) : real(1e18);
  low *= stretch;
  high *= stretch;

  // Lines below way f from both ends.
  real fa = max(way * a.f - a.noise, real(0.0));
  real fb = max(way * b.f - b.noise, real(0.0));
  real left = max(a.where.hi, a.where.hi - fa / low);
  real right = changes ? b.where.hi : min(b.where.hi, b.where.hi - fb / high);
  if (!changes && left >= right)
  {
    return RTG_NESTED_EMPTY;
  }
  real meet = (fa + high * width - fb) / (high - low);
  real depth = changes ? max(abs(a.f), abs(b.f)) : -(fa + low * meet);
  next = real(0.5) * (left + right);
  // So short that nothing but one extremum is in it.
  real3 change = real3(abs(rises.x), abs(rises.y), abs(b.height - a.height) / max(a.height, b.height));
  bool tiny = depth <= real(4.0) * noise && max(change.x, max(change.y, change.z)) < real(0.004) + real(0.0004) * form.p;
  return tiny || !(next > a.where.hi) || !(next < b.where.hi) ? RTG_NESTED_SETTLE : RTG_NESTED_SPLIT;
}

// `unit` is the ray with a direction of length one to two, its start zero; s counts in its lengths, `scale` of them are one
// of the ray's.
RTG_FN NestedCrossing NestedPieces(NestedForm form, LocalRay ray, LocalRay unit, real scale, real sIn, real sOut,
  real tMin, real tMax)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  crossing.at = ray;
  real3 o = unit.origin.hi;
  real3 d = unit.direction.hi;
  NestedPlanes planes = MakeNestedPlanes(unit);

  // The window is [a, b], its piece ends at `end`.
  NestedProbe a = NestedProbeAt(form, o, d, Word(sIn), -1);
  a.outside = true;
  NestedProbe end = a;
  NestedProbe b = a;
  NestedProbe beyond = a; // where the window ended before it was split
  int octant = -1;
  DoubleWord octantEnd = Word(sIn);
  int octantAxis = -1;
  real turnLow = sIn;
  real turnHigh = sIn;
  real3 towards = d;
  bool newPiece = true;
  bool resumes = false;
  DoubleWord next = Word(sIn);
  for (int step = 0; step < RTG_NESTED_BUDGET; ++step)
  {
    int axis = -1;
    if (newPiece)
    {
      if (!IsLess(end.where, octantEnd))
      {
        // On to the next octant
        do
        {
          ++octant;
          octantAxis = octant == 0 ? planes.first : octant == 1 ? planes.second : octant == 2 ? planes.third : -1;
          octantEnd = octant < 3 ? PlaneOf(planes, octantAxis) : Word(sOut);
        } while (octant < 3 && !(IsLess(end.where, octantEnd) && octantEnd.hi < sOut));
        if (octant > 3 || !IsLess(end.where, octantEnd))
        {
          return crossing;
        }
        real3 m = o + (real(0.5) * (end.where.hi + octantEnd.hi)) * d;
        real3 signs = real3(m.x < real(0.0) ? real(-1.0) : real(1.0), m.y < real(0.0) ? real(-1.0) : real(1.0),
          m.z < real(0.0) ? real(-1.0) : real(1.0));
        real3 v = signs * o;
        towards = signs * d;
        real turnX = NestedExtremum(v.x, towards.x, v.z, towards.z, form.q, sIn);
        real turnY = NestedExtremum(v.y, towards.y, v.z, towards.z, form.r, sIn);
        turnLow = min(turnX, turnY);
        turnHigh = max(turnX, turnY);
      }
      real turn = turnLow > end.where.hi ? turnLow : turnHigh;
      bool turns = turn > end.where.hi && turn < octantEnd.hi;
      next = octantEnd;
      if (turns)
      {
        next = Word(turn);
      }
      axis = turns ? -1 : octantAxis;
    }

    // A probe, and for certain whether it is outside
    NestedProbe probe = NestedProbeAt(form, o, d, next, axis);
    if (!(abs(probe.f) > probe.noise))
    {
      probe.outside = NestedProfileAt(form, RayFrom(unit, next, axis)).value.hi > real(0.0);
    }
    probe.outside = probe.outside || (octant == 3 && axis == -1 && next.hi == sOut);
    if (resumes)
    {
      probe.outside = !a.outside;
      a = probe;
    }
    else
    {
      b = probe;
      if (newPiece)
      {
        end = probe;
        beyond = probe;
      }
    }
    newPiece = false;
    resumes = false;

    bool looking = true;
    while (looking)
    {
      real split;
      int verdict = NestedLook(form, a, b, towards, split);
      looking = false;
      if (verdict == RTG_NESTED_SPLIT)
      {
        next = Word(split);
        beyond = b;
      }
      else
      {
        bool changes = a.outside != b.outside;
        bool crosses = false;
        if (verdict != RTG_NESTED_EMPTY)
        {
          real way = a.outside ? real(1.0) : real(-1.0);
          real width = Subtract(b.where, a.where).hi;
          LocalRay base;
          real from = real(0.0);
          if (verdict == RTG_NESTED_UNIQUE)
          {
            real least = real(RTG_NESTED_TINY);
            real fa = a.outside ? max(a.f, least) : min(a.f, -least);
            real fb = b.outside ? max(b.f, least) : min(b.f, -least);
            from = NestedBracketed(form, o, d, a.where.hi, fa, b.where.hi, fb) - a.where.hi;
          }
          else
          {
            from = real(0.5) * width;
          }
          from = max(real(0.0), min(width, from));
          base = Advance(RayFrom(unit, a.where, a.axis), from);
          LocalRay at;
          crosses = NestedSettle(form, base, -from, width - from, way, changes, at) || changes;
          if (crosses)
          {
            DoubleWord s;
            s.hi = scale * at.start.hi;
            s.lo = scale * at.start.lo;
            real t = RayParameter(ray, s).hi;
            if (t >= tMin)
            {
              crossing.found = t <= tMax;
              crossing.t = t;
              crossing.at = at;
              return crossing;
            }
            if (!changes)
            {
              // It touched before tMin: the other crossing is still to come.
              resumes = true;
              next = at.start;
            }
          }
        }
        if (!resumes)
        {
          a = b;
          newPiece = !IsLess(b.where, end.where);
          b = beyond;
          beyond = end;
          looking = !newPiece;
        }
      }
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

  // The origin next to the centre, a copy with a direction of about length one, the chord through the box
  NestedForm form = MakeNestedForm(glyph.exponents);
  real speed = length(local.direction.hi);
  local = Advance(local, -dot(local.origin.hi, local.direction.hi) / (speed * speed));
  crossing.at = local;
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
    return crossing;
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

RTG_FN real3 NestedSuperquadricNormal(GlyphRay ray, Glyph glyph, real t)
{
  NestedCrossing crossing = NestedSuperquadricCrossing(ray, glyph, Before(ray, glyph, t), real(RTG_NEVER));
  NestedForm form = MakeNestedForm(glyph.exponents);
  real3 p = crossing.at.origin.hi;
  real3 gradient = form.convex ? NestedConvexAt(form, crossing.at.origin).gradient
                               : NestedProfileAt(form, crossing.at).gradient;
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
