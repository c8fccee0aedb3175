// Ellipsoid swept along x, centered: the union of all (p - m)^T C^-1 (p - m) <= 1 whose middles m go from -x to +x and
// whose matrices C change linearly on the way: README.md, Swept ellipsoids. The ellipsoid half-way is the image of the
// unit ball under v -> (after.z v.x + after.x v.y + after.y v.z, size.y / 2 v.y, size.z / 2 v.z): size.y and size.z are
// the diameters of its outline as seen along x.
//   size.x: extent along x
//   before: rotation to v from the frame in which the matrices are diagonal, 1 half-way
//   exponents: their diagonals at the end at +x, in [0, 2]
//   after.w: distance between the ends
#ifndef RTG_SWEPT_ELLIPSOID
#define RTG_SWEPT_ELLIPSOID

#include "Estimate.glsl"
#include "Span.glsl"

#define RTG_ENTRY -1
#define RTG_EXIT 1

#define RTG_APPROACH 0
#define RTG_SEARCH 1
#define RTG_POLISH 2
#define RTG_DONE 3

#define RTG_LEAST_SQUARE 1.0e-9 // half-axes are at least 3e-5 of those half-way

// The ray in the frame of diagonal matrices: at height a in [-1, 1] the middle is a way, the matrix 1 + a growth.
struct SweptRay
{
  LocalRay ray;
  DoubleWord3 way;
  DoubleWord3 growth;
};

RTG_FN DoubleWord3 Words(const DoubleWord x, const DoubleWord y, const DoubleWord z)
{
  return DoubleWord3(real3(x.hi, y.hi, z.hi), real3(x.lo, y.lo, z.lo));
}

RTG_FN DoubleWord3 ToDiagonal(const Glyph glyph, const DoubleWord3 p)
{
  DoubleWord y = Divide(WordY(p), real(0.5) * glyph.size.y);
  DoubleWord z = Divide(WordZ(p), real(0.5) * glyph.size.z);
  DoubleWord sheared = Add(Multiply(y, glyph.after.x), Multiply(z, glyph.after.y));
  DoubleWord x = Divide(Subtract(WordX(p), sheared), glyph.after.z);
  DoubleWord twoOverNorm = Divide(Word(real(2.0)), SquaredNorm(glyph.before));
  return RotateToLocal(glyph.before, twoOverNorm, Words(x, y, z));
}

// The world's unit normal from half the gradient in that frame.
RTG_FN real3 SweptNormal(const Glyph glyph, const DoubleWord3 gradient)
{
  real4 back = real4(-glyph.before.x, -glyph.before.y, -glyph.before.z, glyph.before.w);
  DoubleWord3 v = RotateToLocal(back, Divide(Word(real(2.0)), SquaredNorm(back)), gradient);
  DoubleWord x = Divide(WordX(v), glyph.after.z);
  DoubleWord y = Divide(Subtract(WordY(v), Multiply(x, glyph.after.x)), real(0.5) * glyph.size.y);
  DoubleWord z = Divide(Subtract(WordZ(v), Multiply(x, glyph.after.y)), real(0.5) * glyph.size.z);
  // Scaled against overflow.
  real smallest = min(glyph.after.z, min(glyph.size.y, glyph.size.z));
  return normalize(RotateToWorld(glyph, smallest * real3(x.hi, y.hi, z.hi)));
}

// Where the line o + s d enters or leaves an ellipsoid round 0 of those inverse squares of half-axes, or, if it misses
// that, is nearest. With F = (p - m)^T C^-1 (p - m): `rate`, dF / da there at the same point; `bend`, the derivative of
// that along the sweep.
RTG_FN void MeetOneOfSweep(const real3 o, const real3 d, const real3 way, const real3 growth, const real3 weights,
  const real side, RTG_OUT(real) rate, RTG_OUT(real) bend)
{
  real a = dot(weights * d, d);
  real b = dot(weights * o, d);
  real c = dot(weights * o, o) - real(1.0);
  real root = sqrt(max(b * b - a * c, real(0.0)));
  real3 gradient = weights * (o + ((side * root - b) / a) * d);
  real3 motion = way + growth * gradient;
  rate = -dot(way + motion, gradient);
  real mixed = real(-2.0) * dot(weights * d, motion);
  real slope = root > real(0.0) ? -rate / (real(2.0) * side * root) : -mixed / (real(2.0) * a);
  bend = real(2.0) * dot(weights * motion, motion) + mixed * slope;
}

// The height, less `start`, of the ellipsoid that the line enters first, or leaves last. Where a line is inside, F is a
// convex function of height and s, so the rate tells on which side of a height that ellipsoid is.
RTG_FN real HeightOfCrossing(
  const real3 o, const real3 d, const real3 way, const real3 growth, const real start, const real side)
{
  real low = real(-1.0) - start;
  real high = real(1.0) - start;
  bool lowIsEnd = true;
  bool highIsEnd = true;
  real at = clamp(real(0.0), low, high);
  real enough = real(0.05) * sqrt(real(RTG_ROUNDOFF)) / (real(1.0) + length(way));
  real before = real(RTG_NEVER);
  bool done = false;
  for (int i = 0; i < 80 && !done; ++i)
  {
    real rate;
    real bend;
    real3 squares = max(real3(1.0) + (start + at) * growth, real3(RTG_LEAST_SQUARE));
    MeetOneOfSweep(o - at * way, d, way, growth, real3(1.0) / squares, side, rate, bend);
    if (rate < real(0.0))
    {
      low = at;
      lowIsEnd = false;
    }
    else
    {
      high = at;
      highIsEnd = false;
    }
    real middle = real(0.5) * (low + high);
    // Newton's method, or a bisection where that does not halve the rate.
    real next = bend > real(0.0) ? at - rate / bend : middle;
    // Steps are short, too, where the line hardly meets that ellipsoid.
    done = (bend > real(0.0) && abs(next - at) <= enough && abs(rate) < real(1.0e-3) * (real(1.0) + length(way))) ||
      !(low < high);
    if (!done && !(next > low))
    {
      next = lowIsEnd ? low : middle;
    }
    if (!done && !(next < high))
    {
      next = highIsEnd ? high : middle;
    }
    at = abs(rate) > real(0.5) * before && !done ? middle : next;
    before = abs(rate);
  }
  return clamp(at, real(-1.0) - start, real(1.0) - start);
}

// 1 - F.
RTG_FN real SweptDepth(const DoubleWord3 o, const DoubleWord3 weights)
{
  return -Add(SumOf(Multiply(o, Multiply(o, weights))), real(-1.0)).hi;
}

// Where the ray enters or leaves the sweep; half the gradient of F there, which is right only where it is wanted.
RTG_FN bool
MeetSweep(const SweptRay swept, const real side, const bool wantsNormal, RTG_OUT(real) t, RTG_OUT(DoubleWord3) gradient)
{
  real3 d = swept.ray.direction.hi;
  real3 way = swept.way.hi;
  real3 growth = swept.growth.hi;
  // From where the ray passes the axis, and again from next to the crossing where that is far.
  real dd = dot(d, d);
  real dw = dot(d, way);
  real ww = dot(way, way);
  real apart = dd * ww - dw * dw;
  real3 o = swept.ray.origin.hi;
  real at = apart > real(1.0e-4) * dd * ww ? (dot(o, way) * dd - dot(o, d) * dw) / apart : real(0.0);
  at = clamp(at, real(-1.0), real(1.0));
  LocalRay near = swept.ray;
  DoubleWord height = Word(real(0.0));
  DoubleWord3 weights = Word3(real3(1.0));
  real a = dd;
  real depth = real(0.0);
  bool met = false;
  int step = RTG_APPROACH;
  int polishes = wantsNormal ? 3 : 0;
  for (int pass = 0; pass < 14 && step != RTG_DONE; ++pass)
  {
    if (step == RTG_SEARCH)
    {
      at = HeightOfCrossing(near.origin.hi, d, way, growth, height.hi, side);
    }
    height = Add(height, at);
    near.origin = Subtract(near.origin, Multiply(swept.way, real3(at)));
    DoubleWord3 squares = Add(Multiply(swept.growth, Word3(height)), real3(1.0));
    squares.hi = max(squares.hi, real3(RTG_LEAST_SQUARE));
    weights = Divide(Word3(real3(1.0)), squares);
    a = dot(weights.hi * d, d);
    near = Advance(near, -dot(weights.hi * near.origin.hi, d) / a);
    real b = dot(weights.hi * near.origin.hi, d);
    depth = SweptDepth(near.origin, weights);
    real discriminant = b * b + a * depth;
    // The height that rounding changes may be one that the ray just misses.
    met = discriminant >= real(-64.0 * RTG_ROUNDOFF) * a;
    near = Advance(near, (side * sqrt(max(discriminant, real(0.0))) - b) / a);

    bool found = step == RTG_POLISH || (step == RTG_SEARCH && (pass == 9 || abs(at) * length(way) < real(1.0)));
    bool settled = polishes == 0 || !(abs(height.hi) < real(1.0));
    step = !found ? RTG_SEARCH : settled ? RTG_DONE : RTG_POLISH;
    if (step == RTG_POLISH)
    {
      // An error of the height moves the crossing by its square only, but the normal by itself: Newton's method.
      real rate;
      real bend;
      gradient = Multiply(near.origin, weights);
      MeetOneOfSweep(near.origin.hi, d, way, growth, weights.hi, side, rate, bend);
      rate = SumOf(Multiply(Add(Multiply(swept.way, real3(2.0)), Multiply(swept.growth, gradient)), gradient)).hi;
      at = bend > real(0.0) && abs(rate) < real(0.2) * bend / (real(1.0) + length(way)) ? rate / bend : real(0.0);
      --polishes;
    }
  }
  // One Newton step, away from the silhouette.
  real b = dot(weights.hi * near.origin.hi, d);
  depth = SweptDepth(near.origin, weights);
  near = Advance(near, real(64.0) * a * abs(depth) < b * b ? depth / (real(2.0) * b) : real(0.0));
  t = near.start.hi;
  gradient = Multiply(near.origin, weights);
  return met;
}

// It lies within the ellipsoids of half-way enlarged: their matrices are less than that times 1 + growth.
RTG_FN real3 SweptHalfSize(const Glyph glyph)
{
  real3 growth = abs(glyph.exponents - real3(1.0));
  real larger = real(0.5000005) * sqrt(real(1.0) + max(growth.x, max(growth.y, growth.z)));
  return real3(real(0.5) * glyph.size.x, larger * glyph.size.y, larger * glyph.size.z);
}

RTG_FN bool IntersectSweptEllipsoid(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  const bool wantsNormal, RTG_OUT(real) t, RTG_OUT(real3) normal)
{
  bool found = false;
  t = tMin;
  normal = -ray.direction;
  SweptRay swept;
  if (ToLocal(ray, glyph, real3(real(0.0)), SweptHalfSize(glyph), swept.ray))
  {
    swept.ray.origin = ToDiagonal(glyph, swept.ray.origin);
    swept.ray.direction = ToDiagonal(glyph, swept.ray.direction);
    swept.way = ToDiagonal(glyph, Word3(real3(real(0.5) * glyph.after.w, real(0.0), real(0.0))));
    swept.growth = TwoSum(glyph.exponents, real3(-1.0));
    bool met = true;
    for (int side = RTG_ENTRY; side <= RTG_EXIT && met && !found; side += RTG_EXIT - RTG_ENTRY)
    {
      DoubleWord3 gradient;
      met = MeetSweep(swept, real(side), wantsNormal, t, gradient);
      found = met && t >= tMin && t <= tMax;
      if (found && wantsNormal)
      {
        normal = SweptNormal(glyph, gradient);
      }
    }
  }
  return found;
}

RTG_FN Enclosure SweptEllipsoidEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  outer.halfSize = SweptHalfSize(glyph);
  return outer;
}

// The farthest in a direction of the world: of all heights a the largest half-way a + sqrt(A + a B).
RTG_FN real SweptReach(const Glyph glyph, const real3 direction)
{
  real3 n = RotateToLocal(glyph, direction);
  real3 v = real3(glyph.after.z * n.x, glyph.after.x * n.x + real(0.5) * glyph.size.y * n.y,
    glyph.after.y * n.x + real(0.5) * glyph.size.z * n.z);
  real3 q = real3(glyph.before.x, glyph.before.y, glyph.before.z);
  v = Rotate(-q, glyph.before.w, v);
  real way = real(0.5) * glyph.after.w * n.x;
  real squared = dot(v, v);
  real growth = dot((glyph.exponents - real3(1.0)) * v, v);
  real root = real(-0.5) * growth / way;
  real at = root > real(0.0) ? clamp((root * root - squared) / growth, real(-1.0), real(1.0)) : real(1.0);
  real between = at * way + sqrt(max(squared + at * growth, real(0.0)));
  real first = sqrt(max(squared - growth, real(0.0))) - way;
  real last = sqrt(max(squared + growth, real(0.0))) + way;
  return max(between, max(first, last));
}

RTG_FN void SweptEllipsoidBounds(const Glyph glyph, RTG_OUT(real3) lower, RTG_OUT(real3) upper)
{
  real3 x = real3(real(1.0), real(0.0), real(0.0));
  real3 y = real3(real(0.0), real(1.0), real(0.0));
  real3 z = real3(real(0.0), real(0.0), real(1.0));
  lower = glyph.center + (glyph.centerLow - real3(SweptReach(glyph, -x), SweptReach(glyph, -y), SweptReach(glyph, -z)));
  upper = glyph.center + (glyph.centerLow + real3(SweptReach(glyph, x), SweptReach(glyph, y), SweptReach(glyph, z)));
}

#endif
