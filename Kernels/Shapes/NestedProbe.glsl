// What plain arithmetic knows of a superquadric with two profiles (NestedSuperquadric.glsl) along a ray, and how far it
// errs.
#ifndef RTG_NESTED_PROBE
#define RTG_NESTED_PROBE

#include "NestedForm.glsl"

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

// What rounding does to log2 R: `rounding` is that of |z|, built-in logarithms and powers are good to 2^-20. Where 1 -
// z^q is next to nothing it may be nothing, but not much more: that is the certain side when the point is outside.
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
  real3 known =
    real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0), axis == 2 ? real(0.0) : real(1.0));
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

#endif
