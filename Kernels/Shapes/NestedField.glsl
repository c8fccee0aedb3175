// The field of a superquadric with two profiles (NestedSuperquadric.glsl) along a ray.
//
// A glyph with one profile, beta = c <= 2, and alpha <= 2 is convex: its gauge g = ||(||(x, y)||_p, z)||_q is a norm
// and so convex along the ray: f = g - 1, and the ray is one piece. Others have f = log2 N, N = ||(x / Rx, y / Ry)||_p.
// Inside one octant x / Rx along the ray has at most one extremum, at z^(1-q) = (z x' - x z') / x', and so
// has y / Ry. The ray is cut there and at the three coordinate planes, whose order double words decide: at most twelve
// pieces, on each of which both quotients are monotone. What a window of a piece holds is known from its ends:
//   - Both quotients rise or both fall, or one is all there is: N is monotone.
//   - N lies between the p-norms of the smaller and of the larger quotients at the ends: all outside, or all inside.
//   - The slope of N^p / p is |x|^(p-1) Rx^-p x' + (x / Rx)^p fall z' and the same of y, whose factors are monotone, so
//     that the ends bound it: N may be monotone, or lines from the ends prove that it does not come near 1.
// Every value comes with a bound of its rounding. Windows in which the quotients and the falls of their profiles change
// by less than 0.4 % count as having one extremum at most.

#define RTG_NESTED_LEAST 1.0e-6 // exponent
// Where 1 - z^q is less than the error of the logarithms, it counts as outside: the end of the axis.
#define RTG_NESTED_END (16.0 * RTG_ROUNDOFF * RTG_ROUNDOFF + 1.0e-22)
#define RTG_LN2 0.6931471805599453
#define RTG_LOG2_E 1.4426950408889634074

struct NestedField
{
  real p;
  real q;
  real r;
  real3 exponents; // alpha, beta, c, which p, q and r are rounded from
  bool convex;
  bool twoProfiles;
  real2 steepAt; // of a profile with q < 1: |z| where -d(log R)/d|z| is least, and that; 0 for others
  real2 leastFall;
  real accuracy;    // of the ray's parameter, after the last steps
  real convexWidth; // windows shorter than this are convex
  real3 o;          // the ray
  real3 d;
  real sOut;
  DoubleWord3 planes; // where the ray passes them
};

// The surface at one point of the ray in plain float.
struct NestedProbe
{
  DoubleWord where;
  int axis; // of the coordinate plane that the point is on, else -1
  bool outside;
  real f;
  real slope;
  real error; // rounding of f
  TaylorError taylor;
  real height;     // |z|
  real2 lows;      // log2 |x|, log2 |y|
  real2 logs;      // log2 |x| / Rx, log2 |y| / Ry
  real2 falls;     // -d(log R) / d|z|
  real2 tolerance; // rounding of the logs
};

// Where z^(q - 1) / (1 - z^q) is least: z^q = 1 - q.
RTG_FN real LeastFallAt(const real q)
{
  return q < real(1.0) ? exp2(max(log2(max(real(1.0) - q, real(1e-6))) / q, real(-60.0))) : real(0.0);
}

RTG_FN NestedField MakeNestedField(const Chord chord, const real3 exponents)
{
  real3 e = max(exponents, real3(real(RTG_NESTED_LEAST)));
  NestedField field;
  field.exponents = e;
  field.p = real(2.0) / e.x;
  field.q = real(2.0) / e.y;
  field.r = real(2.0) / e.z;
  field.twoProfiles = e.y != e.z;
  field.convex = !field.twoProfiles && e.x <= real(2.0) && e.y <= real(2.0);
  field.steepAt = real2(real(0.0));
  field.leastFall = real2(real(0.0));
  LocalRay unit = chord.unit;
  field.planes = PlanesOf(unit, real3(field.convex ? real(1.0) : real(0.0)));
  if (!field.convex)
  {
    field.steepAt = real2(LeastFallAt(field.q), LeastFallAt(field.r));
    field.leastFall.x = field.q < real(1.0) ? exp2((field.q - real(1.0)) * log2(field.steepAt.x)) / field.q : real(0.0);
    field.leastFall.y = field.r < real(1.0) ? exp2((field.r - real(1.0)) * log2(field.steepAt.y)) / field.r : real(0.0);
  }
  field.accuracy = real(RTG_ROUNDOFF / 64.0) / (real(1.0) + field.p);
  field.convexWidth = field.convex ? real(RTG_NEVER) : field.p >= real(1.0) ? real(0.05) : real(0.0);
  field.o = unit.origin.hi;
  field.d = unit.direction.hi;
  field.sOut = chord.sOut;
  return field;
}

// 2^x without underflow.
RTG_FN real SafeExp2(const real x)
{
  return x > real(-100.0) ? exp2(min(x, real(100.0))) : real(0.0);
}

// log2 of the p-norm of two numbers that are given by their logarithms, and the fraction of each in the sum of powers.
RTG_FN real LogNorm(const real a, const real b, const real p, RTG_OUT(real2) weights)
{
  real high = max(a, b);
  real power = SafeExp2(p * (min(a, b) - high));
  real low = power / (real(1.0) + power);
  weights = a >= b ? real2(real(1.0) - low, low) : real2(low, real(1.0) - low);
  return high + log2(real(1.0) + power) / p;
}

RTG_FN real LogNorm(const real2 l, const real p)
{
  real2 weights;
  return LogNorm(l.x, l.y, p, weights);
}

// log2 R of a profile at log2 |z| and its fall.
RTG_FN real PlainProfile(const real z, const real logZ, const real q, RTG_OUT(real) fall)
{
  real power = SafeExp2(q * logZ);
  real rest = max(real(1.0) - power, real(RTG_TINY));
  fall = power / (rest * z);
  return log2(rest) / q;
}

// Rounding of log2 R: `rounding` is that of |z|, built-in logarithms and powers are good to 2^-20. Where 1 -
// z^q is next to nothing it may be nothing, but not much more: that is the certain side when the point is outside.
RTG_FN real ProfileTolerance(const real fall, const real z, const real q, const real rounding, const bool outside)
{
  real excess = q * rounding * fall + real(16.0 * RTG_ROUNDOFF) * (real(1.0) + q) * (real(1.0) + fall * z);
  return excess < real(0.5) ? real(2.0) * excess / q : outside ? log2(real(1.0) + excess) / q : real(1e9);
}

// Directions in absolute coordinates.
RTG_FN real3 Toward(const real3 v, const real3 d)
{
  return real3(v.x < real(0.0) ? -d.x : d.x, v.y < real(0.0) ? -d.y : d.y, v.z < real(0.0) ? -d.z : d.z);
}

// On this side of the coordinate planes, where the surface may be bent all at once, and only as far as powers that are
// negligible stay so.
RTG_FN TaylorError TaylorErrorOf(
  const NestedField field, const real3 gradient, const real3 v, const real3 d, const real2 falls)
{
  real3 a = max(abs(v), real3(real(RTG_TINY)));
  real3 rate = abs(d) / a;
  real3 bends = gradient * abs(d) * rate * rate;
  real steep = real(1.0) + max(falls.x, falls.y);
  real sharp = real(1.0) + max(field.p, max(field.q, field.r));
  real3 growth = sharp * real3(real(1.0), real(1.0), steep) * abs(d) / max(a, real3(real(0.5)));
  rate = real3(v.x == real(0.0) ? real(0.0) : rate.x, v.y == real(0.0) ? real(0.0) : rate.y,
    v.z == real(0.0) ? real(0.0) : rate.z);
  real third = sharp * sharp * (bends.x + bends.y + steep * steep * bends.z);
  return TaylorError(third, real(1.0) / MostOf(max(rate, growth)));
}

// On the coordinate plane of `axis` that coordinate is zero whatever rounding makes of o + s d: next to the rim of a
// concave profile the difference matters.
RTG_FN NestedProbe ProbeAt(const NestedField field, const DoubleWord where, const int axis)
{
  real3 offset = where.hi * field.d;
  real3 known = OffPlane(axis);
  real3 v = field.o + offset;
  real3 a = max(known * abs(v), real3(real(RTG_TINY)));
  real u = real(RTG_ROUNDOFF);
  real3 rounding = real(4.0) * u * (known * (abs(field.o) + abs(offset)));
  real3 l = log2(a);
  NestedProbe probe;
  probe.where = where;
  probe.axis = axis;
  probe.height = a.z;
  probe.lows = real2(l.x, l.y);
  real2 profiles = real2(real(0.0));
  probe.falls = real2(real(0.0));
  if (!field.convex)
  {
    profiles.x = PlainProfile(a.z, l.z, field.q, probe.falls.x);
    profiles.y = profiles.x;
    probe.falls.y = probe.falls.x;
    if (field.twoProfiles)
    {
      profiles.y = PlainProfile(a.z, l.z, field.r, probe.falls.y);
    }
  }
  probe.logs = probe.lows - profiles;
  real2 weights;
  real norm = LogNorm(probe.logs.x, probe.logs.y, field.p, weights);
  real3 gradient =
    real3(weights.x, weights.y, weights.x * probe.falls.x + weights.y * probe.falls.y) / real3(a.x, a.y, real(1.0));
  probe.tolerance = real2(real(0.0));
  if (field.convex)
  {
    real2 outer;
    real g = exp2(LogNorm(norm, l.z, field.q, outer));
    gradient = g * real3(outer.x * gradient.x, outer.x * gradient.y, outer.y / a.z);
    probe.f = g - real(1.0);
    probe.outside = probe.f > real(0.0);
    probe.error = real(32.0) * u + dot(gradient, rounding);
  }
  else
  {
    probe.f = norm;
    probe.outside = probe.f > real(0.0);
    probe.tolerance.x = ProfileTolerance(probe.falls.x, a.z, field.q, rounding.z, probe.outside);
    probe.tolerance.y = probe.tolerance.x;
    if (field.twoProfiles)
    {
      probe.tolerance.y = ProfileTolerance(probe.falls.y, a.z, field.r, rounding.z, probe.outside);
    }
    probe.tolerance += real2(real(16.0) * u) + real(2.0) * real2(rounding.x / a.x, rounding.y / a.y);
    // Outside the larger quotient alone keeps N up; inside neither may be large.
    probe.error = real(16.0) * u * (real(1.0) + real(1.0) / field.p) +
      (probe.outside ? dot(weights, probe.tolerance) : LogNorm(probe.logs + probe.tolerance, field.p) - norm);
    gradient = real(RTG_LOG2_E) * gradient;
  }
  probe.slope = dot(gradient, Toward(v, field.d));
  probe.taylor = TaylorErrorOf(field, gradient, v, field.d, probe.falls);
  return probe;
}

// The extremum of x / R along the ray, R with exponent q: x' z^(1-q) = x' z - x z'. `none` when there is none.
RTG_FN real NestedExtremum(const real x, const real dx, const real z, const real dz, const real q, const real none)
{
  real base = (z * dx - x * dz) / dx;
  if (dx == real(0.0) || dz == real(0.0) || !(base > real(RTG_TINY)) || abs(q - real(1.0)) < real(1e-6))
  {
    return none;
  }
  return (exp2(max(min(log2(base) / (real(1.0) - q), real(100.0)), real(-100.0))) - z) / dz;
}

RTG_FN DoubleWord NextBreak(const NestedField field, const DoubleWord after, RTG_OUT(int) axis)
{
  DoubleWord last = field.convex ? NextMiddle(after, field.sOut) : Word(field.sOut);
  DoubleWord next = NextPlane(field.planes, after, last, axis);
  if (!field.convex)
  {
    real3 middle = field.o + (real(0.5) * (after.hi + next.hi)) * field.d;
    real3 v = Toward(middle, field.o);
    real3 d = Toward(middle, field.d);
    real extremumX = NestedExtremum(v.x, d.x, v.z, d.z, field.q, after.hi);
    real extremumY = NestedExtremum(v.y, d.y, v.z, d.z, field.r, after.hi);
    real low = min(extremumX, extremumY);
    real extremum = low > after.hi ? low : max(extremumX, extremumY);
    if (extremum > after.hi && extremum < next.hi)
    {
      next = Word(extremum);
      axis = -1;
    }
  }
  return next;
}

// Bounds of the derivative of (x / R)^p / p along the ray between two probes, over 2^(p unit): that is
//   |x|^(p-1) R^-p x' + (x / R)^p fall z',
// in which every factor is monotone, but for the fall of a profile with q < 1.
RTG_FN real2 NestedSlopeOfTerm(const real p, const real unit, const real2 lows, const real2 logs, const real2 falls,
  const real2 heights, const real steepAt, const real leastFall, const real2 tolerance, const real dx, const real dz)
{
  real2 k = (p - real(1.0)) * lows;
  real2 r = lows - logs;
  real most = SafeExp2(max(k.x, k.y) - p * (min(r.x, r.y) + unit));
  real least = SafeExp2(min(k.x, k.y) - p * (max(r.x, r.y) + unit));
  bool dips = steepAt > min(heights.x, heights.y) && steepAt < max(heights.x, heights.y);
  real fallMost = SafeExp2(p * (max(logs.x, logs.y) - unit)) * max(falls.x, falls.y);
  real fallLeast = SafeExp2(p * (min(logs.x, logs.y) - unit)) * (dips ? leastFall : min(falls.x, falls.y));
  real pad = (real(1.0) + p) * min(tolerance.x, tolerance.y) * (abs(dx) * most + abs(dz) * fallMost);
  real low = dx * (dx < real(0.0) ? most : least) + dz * (dz < real(0.0) ? fallMost : fallLeast);
  real high = dx * (dx < real(0.0) ? least : most) + dz * (dz < real(0.0) ? fallLeast : fallMost);
  return real2(low - pad, high + pad);
}

RTG_FN Window WindowOf(
  const NestedField field, const NestedProbe a, const NestedProbe b, const real sign, const real width)
{
  Window window;
  window.empty = false;
  window.unique = true;
  // So short that nothing but one extremum is in it. A quotient counts by the root of its fraction in the sum of
  // powers: where that is small, so is what bends f.
  real2 change = abs(b.logs - a.logs);
  real2 bend = abs(b.falls - a.falls) / max(max(a.falls, b.falls), real2(real(1.0)));
  real2 smaller = max(a.logs, b.logs) - min(max(a.logs.x, a.logs.y), max(b.logs.x, b.logs.y));
  real2 halfPower = real(0.5) * field.p * min(smaller, real2(real(0.0)));
  real2 counts = real2(SafeExp2(halfPower.x), SafeExp2(halfPower.y)) * max(change, bend);
  window.single = field.convex || max(counts.x, counts.y) < real(0.004);
  window.convex = field.convex && sign > real(0.0);
  real chord = sign * (b.f - a.f) / width;
  window.slopeA = sign > real(0.0) ? a.slope : chord;
  window.slopeB = sign > real(0.0) ? b.slope : chord;
  if (!field.convex)
  {
    real2 rises = b.logs - a.logs;
    real2 tolerance = a.tolerance + b.tolerance;
    bool together =
      abs(rises.x) > tolerance.x && abs(rises.y) > tolerance.y && (rises.x > real(0.0)) == (rises.y > real(0.0));
    // One of the quotients is all there is.
    real apart =
      max(min(a.logs.x, b.logs.x) - max(a.logs.y, b.logs.y), min(a.logs.y, b.logs.y) - max(a.logs.x, b.logs.x));
    bool alone = field.p * (apart - max(tolerance.x, tolerance.y)) > real(60.0);
    window.unique = together || alone;
    window.empty = window.unique && width > real(64.0 * RTG_ROUNDOFF);
  }
  if (!field.convex && !window.empty)
  {
    real2 largest = max(a.logs, b.logs);
    real2 smallest = min(a.logs, b.logs);
    real2 inner = min(a.logs - a.tolerance, b.logs - b.tolerance);
    real2 outer = max(a.logs + a.tolerance, b.logs + b.tolerance);
    real bound = sign > real(0.0) ? LogNorm(inner, field.p) : -LogNorm(outer, field.p);

    // Over the largest term, so that nothing that counts under- or overflows; f' = slope 2^(p (most - f)) with
    // least <= f
    real most = max(largest.x, largest.y);
    real least = LogNorm(smallest, field.p);
    real2 heights = real2(a.height, b.height);
    real3 d = Toward(field.o + (real(0.5) * (a.where.hi + b.where.hi)) * field.d, field.d);
    real2 slopes = NestedSlopeOfTerm(field.p, most, real2(a.lows.x, b.lows.x), real2(a.logs.x, b.logs.x),
                     real2(a.falls.x, b.falls.x), heights, field.steepAt.x, field.leastFall.x,
                     real2(a.tolerance.x, b.tolerance.x), d.x, d.z) +
      NestedSlopeOfTerm(field.p, most, real2(a.lows.y, b.lows.y), real2(a.logs.y, b.logs.y),
        real2(a.falls.y, b.falls.y), heights, field.steepAt.y, field.leastFall.y, real2(a.tolerance.y, b.tolerance.y),
        d.y, d.z);
    real steepness = field.p * (most - least);
    steepness = real(RTG_LOG2_E) * (steepness < real(60.0) ? exp2(steepness) : real(1e18));
    window.slopeA = steepness * (sign > real(0.0) ? slopes.x : -slopes.y);
    window.slopeB = steepness * (sign > real(0.0) ? slopes.y : -slopes.x);
    window.unique = window.unique || window.slopeA >= real(0.0) || window.slopeB <= real(0.0);
    window.empty = bound > real(32.0 * RTG_ROUNDOFF);
  }
  return window;
}

RTG_FN DoubleWord Magnitude(const DoubleWord a)
{
  return a.hi < real(0.0) ? Minus(a) : a;
}

// log2 (2^(a p) + 2^(b p))^(1/p), p = 2 / exponent, and the fraction of each in the sum of powers. A rounded p would be
// another surface, as a grazing ray notices.
RTG_FN DoubleWord LogNorm(
  const DoubleWord a, const DoubleWord b, const real exponent, RTG_OUT(DoubleWord) shareA, RTG_OUT(DoubleWord) shareB)
{
  bool aHigh = !IsLess(a, b);
  DoubleWord high = aHigh ? a : b;
  DoubleWord low = aHigh ? b : a;
  DoubleWord power = Exp2(Multiply(Subtract(low, high), Divide(Word(real(2.0)), exponent)));
  DoubleWord sum = Add(power, real(1.0));
  DoubleWord shareHigh = Divide(Word(real(1.0)), sum);
  DoubleWord shareLow = Multiply(power, shareHigh);
  shareA = aHigh ? shareHigh : shareLow;
  shareB = aHigh ? shareLow : shareHigh;
  return Add(high, Multiply(Log2(sum), real(0.5) * exponent));
}

// log2 R of a profile with q = 2 / exponent at log2 z, and -z d(log R)/dz.
RTG_FN DoubleWord LogProfile(const DoubleWord logZ, const real exponent, RTG_OUT(DoubleWord) fall)
{
  DoubleWord power = Exp2(Multiply(logZ, Divide(Word(real(2.0)), exponent)));
  DoubleWord rest = Add(Minus(power), real(1.0));
  rest = rest.hi > real(RTG_NESTED_END) ? rest : Word(real(RTG_NESTED_END));
  fall = Divide(power, rest);
  return Multiply(Log2(rest), real(0.5) * exponent);
}

RTG_FN DoubleWord RateOf(const DoubleWord x, const DoubleWord dx)
{
  return abs(x.hi) > real(1e-30) ? Divide(dx, x) : Word(real(0.0));
}

// The logarithm of g or N.
RTG_FN ImplicitPoint PointAt(const NestedField field, const LocalRay at)
{
  DoubleWord x = Log2(Magnitude(WordX(at.origin)));
  DoubleWord y = Log2(Magnitude(WordY(at.origin)));
  DoubleWord z = Log2(Magnitude(WordZ(at.origin)));
  DoubleWord fallX = Word(real(0.0));
  DoubleWord fallY = fallX;
  if (!field.convex)
  {
    DoubleWord profile = LogProfile(z, field.exponents.y, fallX);
    fallY = fallX;
    x = Subtract(x, profile);
    if (field.twoProfiles)
    {
      profile = LogProfile(z, field.exponents.z, fallY);
    }
    y = Subtract(y, profile);
  }
  DoubleWord weightX, weightY;
  DoubleWord norm = LogNorm(x, y, field.exponents.x, weightX, weightY);
  DoubleWord rateZ = RateOf(WordZ(at.origin), WordZ(at.direction));
  DoubleWord rateX = RateOf(WordX(at.origin), WordX(at.direction));
  DoubleWord rateY = RateOf(WordY(at.origin), WordY(at.direction));
  real2 falls = real2(fallX.hi, fallY.hi);
  // Second derivatives of the quotients' logarithms, from there that of N's
  real2 second =
    rateZ.hi * rateZ.hi * falls * (real2(field.q, field.r) * (real2(real(1.0)) + falls) - real2(real(1.0))) -
    real2(rateX.hi * rateX.hi, rateY.hi * rateY.hi);
  rateX = Add(rateX, Multiply(fallX, rateZ));
  rateY = Add(rateY, Multiply(fallY, rateZ));
  DoubleWord slope = Add(Multiply(weightX, rateX), Multiply(weightY, rateY));
  ImplicitPoint point;
  point.second = weightX.hi * (second.x + field.p * rateX.hi * rateX.hi) +
    weightY.hi * (second.y + field.p * rateY.hi * rateY.hi) - field.p * slope.hi * slope.hi;
  real3 weights = real3(weightX.hi, weightY.hi, weightX.hi * falls.x + weightY.hi * falls.y);
  if (field.convex)
  {
    DoubleWord weightRho, weightZ;
    norm = LogNorm(norm, z, field.exponents.y, weightRho, weightZ);
    real2 slopes = real2(slope.hi, rateZ.hi);
    slope = Add(Multiply(weightRho, slope), Multiply(weightZ, rateZ));
    point.second = weightRho.hi * (point.second + field.q * slopes.x * slopes.x) +
      (field.q - real(1.0)) * weightZ.hi * slopes.y * slopes.y - field.q * slope.hi * slope.hi;
    weights = real3(weightRho.hi * weights.x, weightRho.hi * weights.y, weightZ.hi);
  }
  else
  {
    // On a flat end x and y give 1 - z^q = rho^q more exactly than z.
    weights.z *= field.twoProfiles ? real(1.0) : exp2(clamp(-field.q * norm.hi, real(-60.0), real(60.0)));
  }

  bool beyondEnd = max(falls.x, falls.y) * real(RTG_NESTED_END) > real(0.5);
  point.value = beyondEnd ? Word(real(100.0)) : Multiply(norm, real(RTG_LN2));
  point.slope = slope.hi;
  point.gradient = weights / max(abs(at.origin.hi), real3(real(RTG_TINY)));
  point.taylor = TaylorErrorOf(field, point.gradient, at.origin.hi, at.direction.hi, falls);
  point.accuracy = field.accuracy;
  return point;
}

RTG_FN NestedProbe WithSign(const NestedField field, const LocalRay unit, const NestedProbe probe)
{
  NestedProbe certain = probe;
  certain.outside = PointAt(field, RayFrom(unit, probe.where, probe.axis)).value.hi > real(0.0);
  return certain;
}

#define RTG_FIELD NestedField
#define RTG_PROBE NestedProbe
#define RTG_SEARCH NestedSearch
#define RTG_MAKE_FIELD MakeNestedField
#define RTG_CROSSING NestedSuperquadricCrossing
#include "ImplicitSearch.glsl"
