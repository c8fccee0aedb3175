// Ellipsoid swept along x, centered: the union of all (p - m)^T C^-1 (p - m) <= 1 whose middles m go from -x to +x and
// whose matrices C change linearly in between: README.md, Swept ellipsoids. The ellipsoid half-way is the image of the
// unit ball under v -> (after.z v.x + after.x v.y + after.y v.z, size.y / 2 v.y, size.z / 2 v.z): size.y and size.z are
// the diameters of its outline as seen along x.
//   size.x: extent along x
//   before: rotation to v from the frame in which the matrices are diagonal, 1 half-way
//   exponents: their diagonals at the end at +x, in [0, 2]
//   after.w: distance between the ends
//
// It may be a piece of a line (Glyph::joined): crossings that lie inside the next piece at either end are none. The
// ellipsoid that both share belongs to the piece before it. RTG_JOINT_VALUES numbers describe the next piece at -x, as
// many that at +x: in the frame in which the shared ellipsoid is the unit ball, the rotation to that frame from the one
// in which the next piece's matrices are diagonal, and in that one the displacement to its far end, all zero where
// there is none, and how much the matrix grows up to there.

#define RTG_ENTRY -1
#define RTG_EXIT 1

#define RTG_APPROACH 0
#define RTG_SEARCH 1
#define RTG_POLISH 2
#define RTG_DONE 3

#define RTG_JOINT_VALUES 10
#define RTG_LEAST_SQUARE 1.0e-9 // half-axes are at least 3e-5 of those half-way

// The ray in the frame of diagonal matrices: at height a in [-1, 1] the middle is a displacement, the matrix 1 + a
// growth.
struct SweptRay
{
  LocalRay ray;
  DoubleWord3 displacement;
  DoubleWord3 growth;
};

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
RTG_FN void DepthInSweep(const real3 o, const real3 d, const real3 displacement, const real3 growth,
  const real3 weights, const real side, RTG_OUT(real) rate, RTG_OUT(real) bend)
{
  real a = dot(weights * d, d);
  real b = dot(weights * o, d);
  real c = dot(weights * o, o) - real(1.0);
  real root = sqrt(max(b * b - a * c, real(0.0)));
  real3 gradient = weights * (o + ((side * root - b) / a) * d);
  real3 motion = displacement + growth * gradient;
  rate = -dot(displacement + motion, gradient);
  real mixed = real(-2.0) * dot(weights * d, motion);
  real slope = root > real(0.0) ? -rate / (real(2.0) * side * root) : -mixed / (real(2.0) * a);
  bend = real(2.0) * dot(weights * motion, motion) + mixed * slope;
}

// A search for the height where a rate that rises is zero, or for the end of the range that is next to it.
struct HeightSearch
{
  real at;
  real low;
  real high;
  bool lowIsEnd;
  bool highIsEnd;
  real rate; // the last
  bool done;
};

RTG_FN HeightSearch SearchFrom(const real at, const real low, const real high)
{
  return HeightSearch(at, low, high, true, true, real(RTG_NEVER), false);
}

// Takes the rate at search.at and its derivative. `enough`: a step that need not be taken, but where rates are above
// `leastRate`.
RTG_FN HeightSearch NextHeight(
  const HeightSearch search, const real rate, const real bend, const real enough, const real leastRate)
{
  HeightSearch next = search;
  bool below = rate < real(0.0);
  next.low = below ? search.at : search.low;
  next.high = below ? search.high : search.at;
  next.lowIsEnd = search.lowIsEnd && !below;
  next.highIsEnd = search.highIsEnd && below;
  real middle = real(0.5) * (next.low + next.high);
  // Newton's method, or a bisection where that does not halve the rate.
  next.at = bend > real(0.0) ? search.at - rate / bend : middle;
  next.done =
    (bend > real(0.0) && abs(next.at - search.at) <= enough && abs(rate) < leastRate) || !(next.low < next.high);
  if (!next.done && !(next.at > next.low))
  {
    next.at = next.lowIsEnd ? next.low : middle;
  }
  if (!next.done && !(next.at < next.high))
  {
    next.at = next.highIsEnd ? next.high : middle;
  }
  next.at = abs(rate) > real(0.5) * search.rate && !next.done ? middle : next.at;
  next.rate = abs(rate);
  return next;
}

// The height, less `start`, of the ellipsoid that the line enters first, or leaves last. Where a line is inside, F is a
// convex function of height and s, so the rate tells on which side of a height that ellipsoid is.
RTG_FN real HeightOfCrossing(
  const real3 o, const real3 d, const real3 displacement, const real3 growth, const real start, const real side)
{
  real low = real(-1.0) - start;
  real high = real(1.0) - start;
  HeightSearch search = SearchFrom(clamp(real(0.0), low, high), low, high);
  real scale = real(1.0) + length(displacement);
  for (int i = 0; i < 80 && !search.done; ++i)
  {
    real rate, bend;
    real3 squares = max(real3(1.0) + (start + search.at) * growth, real3(RTG_LEAST_SQUARE));
    DepthInSweep(o - search.at * displacement, d, displacement, growth, real3(1.0) / squares, side, rate, bend);
    // Steps are short, too, where the line hardly meets that ellipsoid.
    search = NextHeight(search, rate, bend, real(0.05) * sqrt(real(RTG_ROUNDOFF)) / scale, real(1.0e-3) * scale);
  }
  return clamp(search.at, low, high);
}

// 1 - F.
RTG_FN real SweptDepth(const DoubleWord3 o, const DoubleWord3 weights)
{
  return -Add(SumOf(Multiply(o, Multiply(o, weights))), real(-1.0)).hi;
}

// A point of the sweep's surface.
struct SweptPoint
{
  real t;
  DoubleWord height;
  DoubleWord3 fromMiddle; // of the ellipsoid at that height
  DoubleWord3 gradient;   // half that of F: right only where it is wanted
};

// Where the ray enters or leaves the sweep. `enough`: an error of its parameter that is none, 0 where the normal is
// wanted.
RTG_FN bool IntersectSweep(const SweptRay swept, const real side, const real enough, RTG_OUT(SweptPoint) point)
{
  real3 d = swept.ray.direction.hi;
  real3 displacement = swept.displacement.hi;
  real3 growth = swept.growth.hi;
  // From where the ray passes the axis.
  real dd = dot(d, d);
  real dw = dot(d, displacement);
  real ww = dot(displacement, displacement);
  real apart = dd * ww - dw * dw;
  real3 o = swept.ray.origin.hi;
  real at = apart > real(1.0e-4) * dd * ww ? (dot(o, displacement) * dd - dot(o, d) * dw) / apart : real(0.0);
  at = clamp(at, real(-1.0), real(1.0));
  LocalRay near = swept.ray;
  DoubleWord height = Word(real(0.0));
  DoubleWord low = Word(real(-1.0));
  DoubleWord high = Word(real(1.0));
  bool lowIsEnd = true;
  bool highIsEnd = true;
  DoubleWord3 gradient = near.origin;
  bool met = false;
  real last = real(RTG_NEVER);
  int step = RTG_APPROACH;
  for (int pass = 0; pass < 60 && step != RTG_DONE; ++pass)
  {
    if (step == RTG_SEARCH)
    {
      at = HeightOfCrossing(near.origin.hi, d, displacement, growth, height.hi, side);
    }
    DoubleWord toLow = Subtract(low, height);
    DoubleWord toHigh = Subtract(high, height);
    DoubleWord climb = at > toLow.hi ? (at < toHigh.hi ? Word(at) : toHigh) : toLow;
    height = Add(height, climb);
    near.origin = Subtract(near.origin, Multiply(swept.displacement, Word3(climb)));
    DoubleWord3 squares = Add(Multiply(swept.growth, Word3(height)), real3(1.0));
    squares.hi = max(squares.hi, real3(RTG_LEAST_SQUARE));
    DoubleWord3 weights = Divide(Word3(real3(1.0)), squares);
    real3 dWeighted = weights.hi * d;
    real a = dot(dWeighted, d);
    near = Advance(near, -dot(dWeighted, near.origin.hi) / a);
    real b = dot(dWeighted, near.origin.hi);
    real depth = SweptDepth(near.origin, weights);
    real discriminant = b * b + a * depth;
    // The height that rounding changes may be one that the ray just misses.
    met = discriminant >= real(-64.0 * RTG_ROUNDOFF) * a;
    near = Advance(near, (side * sqrt(max(discriminant, real(0.0))) - b) / a);
    if (step == RTG_APPROACH)
    {
      step = RTG_SEARCH;
    }
    else
    {
      // One Newton step, away from the silhouette.
      b = dot(dWeighted, near.origin.hi);
      depth = SweptDepth(near.origin, weights);
      near = Advance(near, real(64.0) * a * abs(depth) < b * b ? depth / (real(2.0) * b) : real(0.0));
      depth = SweptDepth(near.origin, weights);

      // -dF / da and half dF / ds, in double words where plain numbers cancel.
      gradient = Multiply(near.origin, weights);
      real fall =
        SumOf(Multiply(Add(Multiply(swept.displacement, real3(2.0)), Multiply(swept.growth, gradient)), gradient)).hi;
      real rise = SumOf(Multiply(gradient, near.direction)).hi;
      real3 motion = displacement + growth * gradient.hi;
      real mixed = dot(dWeighted, motion);
      // Where the line is nearest, if it misses.
      bool higher = (discriminant > real(0.0) ? fall : fall - real(2.0) * mixed * rise / a) > real(0.0);
      lowIsEnd = lowIsEnd && !higher;
      highIsEnd = highIsEnd && higher;
      low = higher ? height : low;
      high = higher ? high : height;
      toLow = Subtract(low, height);
      toHigh = Subtract(high, height);

      // The quadric that F is next to the point, least in height: c + 2 b s + a s^2.
      real bend = dot(weights.hi * motion, motion);
      real3 halves = sqrt(weights.hi);
      real3 across = cross(halves * d, halves * motion);
      real aLeast = max(dot(across, across) / bend, real(RTG_ROUNDOFF * RTG_ROUNDOFF) * a);
      real bLeast = rise - real(0.5) * fall * mixed / bend;
      real cLeast = -depth - real(0.25) * fall * fall / bend;
      real root = side * sqrt(max(bLeast * bLeast - aLeast * cLeast, real(0.0)));
      real s = side * bLeast > real(0.0) && root != real(0.0) ? -cLeast / (root + bLeast) : (root - bLeast) / aLeast;
      at = real(0.5) * fall / bend + mixed / bend * s;

      real moved = abs(at) * sqrt(bend);
      real reach = toHigh.hi - toLow.hi;
      bool beside = depth + abs(fall) * reach < real(-64.0 * RTG_ROUNDOFF) * (real(1.0) + sqrt(bend) * reach);
      // Within rounding, steps lead out of the bracket or do not become shorter.
      bool rounded =
        moved < real(16.0 * RTG_ROUNDOFF) && !(at > toLow.hi && at < toHigh.hi && moved < real(0.25) * last);
      bool settled = rounded || moved < real(0.01 * RTG_ROUNDOFF) || (met && abs(s) < enough) || (!met && beside) ||
        !(reach > real(8.0 * RTG_ROUNDOFF * RTG_ROUNDOFF));
      // A bisection where that leaves the bracket, or steps do not halve.
      real middle = real(0.5) * (toLow.hi + toHigh.hi);
      real wanted = at;
      at = moved < real(0.5) * last ? wanted : middle;
      at = wanted > toLow.hi ? at : (lowIsEnd ? toLow.hi : middle);
      at = wanted < toHigh.hi ? at : (highIsEnd ? toHigh.hi : middle);
      last = abs(at) * sqrt(bend);
      step = settled ? RTG_DONE : RTG_POLISH;
    }
  }
  point = SweptPoint(near.start.hi, height, near.origin, gradient);
  return met;
}

// It lies within the ellipsoids of half-way enlarged: their matrices are less than that times 1 + growth.
RTG_FN real3 SweptHalfSize(const Glyph glyph)
{
  real3 growth = abs(glyph.exponents - real3(1.0));
  real larger = real(0.5000005) * sqrt(real(1.0) + max(growth.x, max(growth.y, growth.z)));
  return real3(real(0.5) * glyph.size.x, larger * glyph.size.y, larger * glyph.size.z);
}

// A sweep that begins with the unit ball round 0, as seen from a point: the least F, and by how much that is less than
// the first.
struct SweptDrop
{
  real least;
  real drop;
};

RTG_FN SweptDrop DropAlong(const real3 p, const real3 displacement, const real3 growth)
{
  HeightSearch search = SearchFrom(real(0.0), real(0.0), real(1.0));
  for (int i = 0; i < 80 && !search.done; ++i)
  {
    real3 squares = max(real3(1.0) + search.at * growth, real3(RTG_LEAST_SQUARE));
    real3 gradient = (p - search.at * displacement) / squares;
    real3 motion = displacement + growth * gradient;
    search = NextHeight(search, -dot(displacement + motion, gradient), real(2.0) * dot(motion / squares, motion),
      real(4.0 * RTG_ROUNDOFF) * search.at, real(RTG_NEVER));
  }
  real at = clamp(search.at, real(0.0), real(1.0));
  real3 weights = real3(1.0) / max(real3(1.0) + at * growth, real3(RTG_LEAST_SQUARE));
  real3 left = p - at * displacement;
  return SweptDrop(dot(weights * left, left),
    at * dot(weights, p * (real(2.0) * displacement + growth * p) - at * displacement * displacement));
}

// Whether a point of the sweep's surface, or of its inside, lies in the next piece of the line at an end (side -1, 1).
// `p`: in the frame of diagonal matrices, from the middle of the ellipsoid at that end.
RTG_FN bool InNextSweep(const SweptRay swept, const Glyph glyph, const real side, const real3 p, const bool surface)
{
  int first = side < real(0.0) ? 0 : RTG_JOINT_VALUES;
  real3 axis = real3(RTG_VALUE(glyph, first), RTG_VALUE(glyph, first + 1), RTG_VALUE(glyph, first + 2));
  real3 displacement = real3(RTG_VALUE(glyph, first + 4), RTG_VALUE(glyph, first + 5), RTG_VALUE(glyph, first + 6));
  real3 growth = real3(RTG_VALUE(glyph, first + 7), RTG_VALUE(glyph, first + 8), RTG_VALUE(glyph, first + 9));
  real3 squares = max(real3(1.0) + side * swept.growth.hi, real3(RTG_LEAST_SQUARE));
  real3 halves = sqrt(squares);
  real3 q = p / halves;
  bool inside = false;
  if (dot(displacement, displacement) > real(0.0))
  {
    SweptDrop next = DropAlong(Rotate(-axis, RTG_VALUE(glyph, first + 3), q), displacement, growth);
    inside = next.least < real(1.0);
    // On the surface F is 1 less this piece's own drop: README.md, Swept ellipsoids.
    if (surface && dot(q, q) < real(4.0))
    {
      real twice = real(-2.0) * side;
      real own = DropAlong(q, twice * swept.displacement.hi / halves, twice * swept.growth.hi / squares).drop;
      inside = next.drop > own || (side < real(0.0) && next.drop == own);
    }
  }
  return inside;
}

// Whether a point of the surface lies inside the rest of the line.
RTG_FN bool IsInner(const SweptRay swept, const Glyph glyph, const SweptPoint point)
{
  bool inner = false;
  for (int side = -1; side <= 1 && !inner; side += 2)
  {
    real3 p = Add(point.fromMiddle, Multiply(swept.displacement, Word3(Add(point.height, real(-side))))).hi;
    inner = InNextSweep(swept, glyph, real(side), p, true);
  }
  return inner;
}

// In the frame of diagonal matrices; false: the ray misses the glyph's box.
RTG_FN bool ToSwept(const GlyphRay ray, const Glyph glyph, RTG_OUT(SweptRay) swept)
{
  bool near = ToLocal(ray, glyph, real3(real(0.0)), SweptHalfSize(glyph), swept.ray);
  if (near)
  {
    swept.ray.origin = ToDiagonal(glyph, swept.ray.origin);
    swept.ray.direction = ToDiagonal(glyph, swept.ray.direction);
    swept.displacement = ToDiagonal(glyph, Word3(real3(real(0.5) * glyph.after.w, real(0.0), real(0.0))));
    swept.growth = TwoSum(glyph.exponents, real3(-1.0));
  }
  return near;
}

RTG_FN GlyphHit IntersectSweptEllipsoid(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsNormal)
{
  GlyphHit hit = GlyphHit(false, false, tMin, -ray.direction);
  SweptRay swept;
  if (ToSwept(ray, glyph, swept))
  {
    bool met = true;
    real largest = max(glyph.size.x, max(glyph.size.y, glyph.size.z));
    real enough = real(RTG_ROUNDOFF) * largest / length(ray.direction);
    for (int side = RTG_ENTRY; side <= RTG_EXIT && met && !hit.found; side += RTG_EXIT - RTG_ENTRY)
    {
      SweptPoint point;
      met = IntersectSweep(swept, real(side), wantsNormal ? real(0.0) : enough, point);
      bool found = met && point.t >= tMin && point.t <= tMax && !(glyph.joined && IsInner(swept, glyph, point));
      hit = GlyphHit(
        found, side == RTG_EXIT, point.t, found && wantsNormal ? SweptNormal(glyph, point.gradient) : -ray.direction);
    }
  }
  return hit;
}

// Whether the ray's point at t is inside the sweep, and of joined pieces that share it in the first.
RTG_FN bool IsInSweep(const GlyphRay ray, const Glyph glyph, const real t)
{
  SweptRay swept;
  bool inside = false;
  if (ToSwept(ray, glyph, swept))
  {
    real3 p = PointAt(swept.ray, Add(Word(t), Minus(swept.ray.start)));
    real3 squares = max(real3(1.0) - swept.growth.hi, real3(RTG_LEAST_SQUARE));
    real3 halves = sqrt(squares);
    p += swept.displacement.hi;
    SweptDrop own =
      DropAlong(p / halves, real(2.0) * swept.displacement.hi / halves, real(2.0) * swept.growth.hi / squares);
    inside = own.least <= real(1.0) && !(glyph.joined && InNextSweep(swept, glyph, real(-1.0), p, false));
  }
  return inside;
}

RTG_FN Enclosure SweptEllipsoidEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  outer.halfSize = SweptHalfSize(glyph);
  return outer;
}

// The largest of height * displacement + sqrt(square + height * growth), which is concave.
RTG_FN real SweptSupport(const real displacement, const real square, const real growth)
{
  real root = real(-0.5) * growth / displacement;
  real at = root > real(0.0) ? clamp((root * root - square) / growth, real(-1.0), real(1.0)) : real(1.0);
  real between = at * displacement + sqrt(max(square + at * growth, real(0.0)));
  real first = sqrt(max(square - growth, real(0.0))) - displacement;
  real last = sqrt(max(square + growth, real(0.0))) + displacement;
  return max(between, max(first, last));
}

// The farthest in a direction of the world.
RTG_FN real SweptReach(const Glyph glyph, const real3 direction)
{
  real3 n = RotateToLocal(glyph, direction);
  real3 v = real3(glyph.after.z * n.x, glyph.after.x * n.x + real(0.5) * glyph.size.y * n.y,
    glyph.after.y * n.x + real(0.5) * glyph.size.z * n.z);
  v = Rotate(-real3(glyph.before.x, glyph.before.y, glyph.before.z), glyph.before.w, v);
  return SweptSupport(real(0.5) * glyph.after.w * n.x, dot(v, v), dot((glyph.exponents - real3(1.0)) * v, v));
}

// A vector of the glyph's frame in that of diagonal matrices, in plain numbers.
RTG_FN real3 ToDiagonal(const Glyph glyph, const real3 p)
{
  real y = real(2.0) * p.y / glyph.size.y;
  real z = real(2.0) * p.z / glyph.size.z;
  real x = (p.x - (y * glyph.after.x + z * glyph.after.y)) / glyph.after.z;
  return Rotate(-real3(glyph.before.x, glyph.before.y, glyph.before.z), glyph.before.w, real3(x, y, z));
}

// What plain float proves of a candidate that its enclosure leaves open: README.md, Swept ellipsoids. Where inner
// crossings are none it proves misses only.
RTG_FN int EstimateSweptEllipsoid(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(real) low, RTG_OUT(real) high)
{
  low = tMin;
  high = tMax;
  real3 v = (ray.origin - glyph.center) + (ray.originLow - glyph.centerLow);
  real nearest = -dot(v, ray.direction) / dot(ray.direction, ray.direction);
  real3 o = ToDiagonal(glyph, RotateToLocal(glyph, v + nearest * ray.direction));
  real3 d = ToDiagonal(glyph, RotateToLocal(glyph, ray.direction));
  real3 displacement = ToDiagonal(glyph, real3(real(0.5) * glyph.after.w, real(0.0), real(0.0)));
  real3 growth = glyph.exponents - real3(1.0);
  real3 rows = real3(
    (real(1.0) + real(2.0) * (abs(glyph.after.x) / glyph.size.y + abs(glyph.after.y) / glyph.size.z)) / glyph.after.z,
    real(2.0) / glyph.size.y, real(2.0) / glyph.size.z);
  real away = abs(v.x) + abs(v.y) + abs(v.z) + real(6.0) * (glyph.size.x + glyph.size.y + glyph.size.z);
  real diagonalMoved = real(16.0 * RTG_ROUNDOFF) * (rows.x + rows.y + rows.z) * away;

  int verdict = RTG_UNKNOWN;
  bool outside = true; // the ray surely starts there
  bool going = true;
  // Where it enters; and where it leaves, if it may start inside.
  for (int i = 0; i < 2 && going; ++i)
  {
    real side = i == 0 ? real(RTG_ENTRY) : real(RTG_EXIT);
    real at = HeightOfCrossing(o, d, displacement, growth, real(0.0), side);
    // The ray in the frame where the ellipsoid of that height is the unit ball.
    real3 scale = inversesqrt(max(real3(1.0) + at * growth, real3(RTG_LEAST_SQUARE)));
    real largest = max(scale.x, max(scale.y, scale.z));
    real moved = largest * (diagonalMoved + real(4.0 * RTG_ROUNDOFF) * largest);
    real tolerance = real(4.0) * (real(1.0) + moved) * moved;
    real3 m = scale * (o - at * displacement);
    real3 e = scale * d;
    real ee = dot(e, e);
    real toNearest = -dot(m, e) / ee;
    real3 q = m + toNearest * e;
    real depth = real(1.0) - dot(q, q);
    going = tolerance > real(1.0e-30) && tolerance < real(1.0e30) && depth > real(4.0) * tolerance;
    real halfChord = sqrt(max(depth, real(4.0) * tolerance));
    real perUnit = inversesqrt(ee);
    real toSurface = -side * perUnit * halfChord;
    // The plane that touches the ball where the ray meets it, or is nearest to it, and how far the sweep reaches
    // beyond.
    real3 n = going ? q - toSurface * e : q;
    real3 r = scale * n;
    real along = dot(displacement, r);
    real beyond = SweptSupport(along, dot(r, r), dot(growth * r, r)) - at * along;
    real rounding = real(16.0 * RTG_ROUNDOFF) * (real(1.0) + abs(along) + dot(r, r));
    if (going)
    {
      real excess = max(beyond - dot(n, n), real(0.0)) + rounding;
      real uncertain = real(2.0) * (moved + tolerance / halfChord);
      real crossing = nearest + (toNearest - toSurface);
      real inner = crossing - side * perUnit * uncertain;
      real outer = crossing + side * perUnit * (uncertain + excess / halfChord);
      if (i == 0)
      {
        outside = outer >= tMin;
        low = max(outer, tMin);
        going = !outside;
        if (outside && inner <= tMax && !glyph.joined)
        {
          verdict = RTG_HIT;
          high = inner;
        }
      }
      if (low > tMax || (i == 1 && outer < tMin))
      {
        verdict = RTG_MISSED;
        going = false;
      }
    }
    else if (dot(q, q) > beyond + tolerance * (real(1.0) + beyond) + rounding)
    {
      verdict = RTG_MISSED; // it passes by behind a plane along it
    }
  }
  return verdict;
}

RTG_FN Bounds SweptEllipsoidBounds(const Glyph glyph)
{
  real3 x = real3(real(1.0), real(0.0), real(0.0));
  real3 y = real3(real(0.0), real(1.0), real(0.0));
  real3 z = real3(real(0.0), real(0.0), real(1.0));
  return Bounds(-real3(SweptReach(glyph, -x), SweptReach(glyph, -y), SweptReach(glyph, -z)),
    real3(SweptReach(glyph, x), SweptReach(glyph, y), SweptReach(glyph, z)));
}
