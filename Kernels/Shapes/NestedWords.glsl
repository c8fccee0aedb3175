// A superquadric with two profiles (NestedSuperquadric.glsl) along a ray in double words: its logarithm there, and
// where that is zero.
#ifndef RTG_NESTED_WORDS
#define RTG_NESTED_WORDS

#include "NestedForm.glsl"
#include "WordFunctions.glsl"

#define RTG_LN2 0.6931471805599453

// The logarithm of g, or of N, at a point, and its gradient in absolute coordinates.
struct NestedPoint
{
  DoubleWord value;
  real3 gradient;
};

// log2 (high^p + low^p)^(1/p), p = 2 / exponent, of numbers given by their logarithms; which of them is high, and the
// power of low over high. A rounded p would be another surface, as a grazing ray notices.
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
  power = Exp2(Multiply(Subtract(low, high), Divide(Word(real(2.0)), exponent)));
  if (power.hi == real(0.0))
  {
    return high;
  }
  return Add(high, Multiply(Log2(Add(power, real(1.0))), real(0.5) * exponent));
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
  DoubleWord x = Log2(Magnitude(WordX(at)));
  DoubleWord y = Log2(Magnitude(WordY(at)));
  DoubleWord z = Log2(Magnitude(WordZ(at)));
  NestedPoint point;
  real2 inner;
  real2 outer;
  DoubleWord rho = LogNorm(x, y, form.exponents.x, inner);
  point.value = Multiply(LogNorm(rho, z, form.exponents.y, outer), real(RTG_LN2));
  real3 share = real3(outer.x * inner.x, outer.x * inner.y, outer.y);
  point.gradient = share / max(abs(at.hi), real3(real(RTG_NESTED_TINY)));
  return point;
}

// log2 R of a profile with q = 2 / exponent at log2 z, and -z d(log R)/dz.
RTG_FN DoubleWord LogProfile(DoubleWord logZ, real exponent, RTG_OUT(DoubleWord) fall)
{
  DoubleWord power = Exp2(Multiply(logZ, Divide(Word(real(2.0)), exponent)));
  DoubleWord rest = Add(Minus(power), real(1.0));
  if (!(rest.hi > real(RTG_NESTED_END)))
  {
    rest = Word(real(RTG_NESTED_END));
  }
  fall = Divide(power, rest);
  return Multiply(Log2(rest), real(0.5) * exponent);
}

RTG_FN DoubleWord RateOf(DoubleWord x, DoubleWord dx)
{
  if (!(abs(x.hi) > real(1e-30)))
  {
    return Word(real(0.0));
  }
  return Divide(dx, x);
}

// The logarithm of N at the origin of a ray, with its slope along that: the terms of a slope cancel where the ray
// grazes.
struct NestedProfilePoint
{
  DoubleWord value;
  real slope;
  real bend;      // about the second derivative along the ray; rather too large
  real3 gradient; // in absolute coordinates
};

RTG_FN NestedProfilePoint NestedProfileAt(NestedForm form, LocalRay at)
{
  DoubleWord z = Log2(Magnitude(WordZ(at.origin)));
  DoubleWord fallX;
  DoubleWord rx = LogProfile(z, form.exponents.y, fallX);
  DoubleWord fallY = fallX;
  DoubleWord ry = rx;
  if (form.twoProfiles)
  {
    ry = LogProfile(z, form.exponents.z, fallY);
  }
  DoubleWord x = Subtract(Log2(Magnitude(WordX(at.origin))), rx);
  DoubleWord y = Subtract(Log2(Magnitude(WordY(at.origin))), ry);

  // The p-norm of the quotients, and the share of each in the sum of powers
  NestedProfilePoint point;
  bool xHigh;
  DoubleWord power;
  point.value = Multiply(LogNorm(x, y, form.exponents.x, xHigh, power), real(RTG_LN2));
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

RTG_FN NestedCrossing NoCrossing(LocalRay ray)
{
  NestedCrossing crossing;
  crossing.found = false;
  crossing.t = real(RTG_NEVER);
  crossing.at = ray;
  return crossing;
}

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
  real3 keep =
    real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0), axis == 2 ? real(0.0) : real(1.0));
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
// way log N is above zero. `changes`: at high it is not, and the crossing is Newton's or, where that leaves the bracket
// or dawdles, bisection's. Else the least of it is looked for by its slopes, which change their sign once. False: there
// is none.
RTG_FN bool
NestedSettle(NestedForm form, LocalRay ray, real low, real high, real way, bool changes, RTG_OUT(LocalRay) at)
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

#endif
