// Round cone along x, centered: the convex hull of two balls, which the cone between them touches. Its sizes are the
// distance between the balls' middles and the diameters of the balls at -x and at +x: of size 1 it is the unit capsule.
// Where one ball holds the other that is all.
//
// It may be a piece of a line. At each end of it (Glyph::before at -x, Glyph::after at +x) the line goes on, or ends
// round or flat:
//   w > 0: it goes on to the ball of that radius round xyz, in the glyph's frame. Crossings that lie inside that next
//          piece are none: a ray enters and leaves the line as a whole. The ball that both share belongs to the piece
//          before it.
//   w = 0: the ball.
//   w < 0: the plane through the ball's middle, across the axis.

// Faces of the round cone.
#define RTG_FIRST_BALL 0
#define RTG_LAST_BALL 1
#define RTG_SIDE 2
#define RTG_FIRST_DISC 3
#define RTG_LAST_DISC 4

// In the frame where the radius of the larger ball is 1.
struct RoundConeForm
{
  DoubleWord halfLength; // between the middles of the balls
  DoubleWord first;      // radius of the ball at -x
  DoubleWord last;       // and at +x
  DoubleWord sine;       // of the angle between side and axis: the radius falls toward +x
  DoubleWord cosine;
  bool ball; // one ball holds the other
};

RTG_FN RoundConeForm MakeRoundCone(const DoubleWord halfLength, const DoubleWord first, const DoubleWord last)
{
  DoubleWord fall = Subtract(first, last);
  DoubleWord run = Multiply(halfLength, real(2.0));
  bool ball = !IsLess(fall.hi < real(0.0) ? Minus(fall) : fall, run);
  RoundConeForm form = RoundConeForm(halfLength, first, last, Word(real(0.0)), Word(real(1.0)), ball);
  if (!ball && fall.hi != real(0.0))
  {
    form.sine = Divide(fall, run);
    form.cosine = SquareRoot(Multiply(Add(form.sine, real(1.0)), Minus(Add(form.sine, real(-1.0)))));
  }
  return form;
}

RTG_FN real RoundConeUnit(const Glyph glyph)
{
  return real(0.5) * max(glyph.size.y, glyph.size.z);
}

RTG_FN RoundConeForm FormOfRoundCone(const Glyph glyph)
{
  real larger = max(glyph.size.y, glyph.size.z);
  return MakeRoundCone(
    Divide(Word(glyph.size.x), larger), Divide(Word(glyph.size.y), larger), Divide(Word(glyph.size.z), larger));
}

// The box round it in the glyph's frame.
RTG_FN void RoundConeBox(const Glyph glyph, RTG_OUT(real3) middle, RTG_OUT(real3) halfSize)
{
  real halfLength = real(0.5) * glyph.size.x;
  real first = real(0.5) * glyph.size.y;
  real last = real(0.5) * glyph.size.z;
  real lower = min(-halfLength - first, halfLength - last);
  real upper = max(halfLength + last, first - halfLength);
  real radius = max(first, last);
  middle = real3(real(0.5) * (lower + upper), real(0.0), real(0.0));
  halfSize = real3(real(0.5) * (upper - lower), radius, radius);
}

RTG_FN Span RoundConeSpan(const LocalRay ray, const RoundConeForm form)
{
  DoubleWord x = WordX(ray.origin);
  DoubleWord dx = WordX(ray.direction);
  DoubleWord firstMiddle = Minus(form.halfLength);
  if (form.ball)
  {
    bool lastIsLarger = IsLess(form.first, form.last);
    DoubleWord middle = lastIsLarger ? form.halfLength : firstMiddle;
    return BallSpan(ray, middle, Word(real(1.0)), lastIsLarger ? RTG_LAST_BALL : RTG_FIRST_BALL);
  }

  DoubleWord radius = Divide(Subtract(form.first, Multiply(Subtract(x, firstMiddle), form.sine)), form.cosine);
  DoubleWord rate = Minus(Divide(Multiply(dx, form.sine), form.cosine));
  Span side =
    RoundSpan(WordY(ray.origin), WordZ(ray.origin), radius, WordY(ray.direction), WordZ(ray.direction), rate, RTG_SIDE);
  if (IsEmpty(side))
  {
    return side; // the cone holds both balls
  }
  // Side and balls share the planes of the circles where they touch; each ends there, since next to them their surfaces
  // are too close to decide which is outside.
  DoubleWord start = Add(firstMiddle, Multiply(form.first, form.sine));
  DoubleWord end = Add(form.halfLength, Multiply(form.last, form.sine));
  DoubleWord before = Subtract(firstMiddle, Multiply(form.first, real(2.0)));
  DoubleWord behind = Add(form.halfLength, Multiply(form.last, real(2.0)));
  Span body = Intersection(Slab(x, dx, start, end, RTG_SIDE, RTG_SIDE), side);
  Span first = Intersection(
    Slab(x, dx, before, start, RTG_FIRST_BALL, RTG_SIDE), BallSpan(ray, firstMiddle, form.first, RTG_FIRST_BALL));
  Span last = Intersection(
    Slab(x, dx, end, behind, RTG_SIDE, RTG_LAST_BALL), BallSpan(ray, form.halfLength, form.last, RTG_LAST_BALL));
  return Hull(body, Hull(first, last));
}

// The part of a span between the planes where flat ends are.
RTG_FN Span CutFlat(const LocalRay ray, const RoundConeForm form, const Glyph glyph, const Span span)
{
  DoubleWord lower = Minus(form.halfLength);
  lower = glyph.before.w < real(0.0) ? lower : Add(lower, real(-2.0));
  DoubleWord upper = glyph.after.w < real(0.0) ? form.halfLength : Add(form.halfLength, real(2.0));
  return Intersection(Slab(WordX(ray.origin), WordX(ray.direction), lower, upper, RTG_FIRST_DISC, RTG_LAST_DISC), span);
}

// Whether a point lies in the next piece of a line: by the sign of b + b' of README.md, Round cones and lines.
// `own`: b of this piece, for points of its side; zero for points of the ball at the joint. `ties`: whether the next
// piece has the points in the plane itself.
RTG_FN bool InNextPiece(const real3 p, const real3 joint, const real radius, const real4 next, const bool touches,
  const real own, const bool ties)
{
  real3 far = real3(next.x, next.y, next.z);
  real3 axis = far - joint;
  real run = length(axis);
  real fall = radius - next.w;
  bool inFarBall = dot(p - far, p - far) < next.w * next.w;
  if (!(run > abs(fall)))
  {
    // One of its balls holds the other.
    return fall < real(0.0) && inFarBall;
  }
  real sine = fall / run;
  real cosine = sqrt((real(1.0) - sine) * (real(1.0) + sine));
  real along = dot(p - joint, axis) / run;
  real beyond = (along - radius * sine) / cosine;
  bool inside = beyond + own > real(0.0) || (ties && beyond + own == real(0.0));
  if (!touches)
  {
    inside = beyond > real(0.0) && dot(p - joint, p - joint) - radius * radius < beyond * beyond;
  }
  return inside && (along <= run + next.w * sine || inFarBall);
}

// Whether a crossing at p, in the glyph's frame, lies inside the rest of the line.
RTG_FN bool IsInner(const RoundConeForm form, const Glyph glyph, const real3 p, const int face)
{
  real unit = RoundConeUnit(glyph);
  real cosine = form.cosine.hi;
  bool side = face == RTG_SIDE;
  bool inner = false;
  if (glyph.before.w > real(0.0))
  {
    real3 joint = real3(-form.halfLength.hi, real(0.0), real(0.0));
    real own = (form.first.hi * form.sine.hi - (p.x - joint.x)) / cosine;
    inner = face == RTG_FIRST_BALL ||
      InNextPiece(p, joint, form.first.hi, glyph.before / unit, side, side ? min(own, real(0.0)) : real(0.0), true);
  }
  if (glyph.after.w > real(0.0))
  {
    real3 joint = real3(form.halfLength.hi, real(0.0), real(0.0));
    real own = ((p.x - joint.x) - form.last.hi * form.sine.hi) / cosine;
    bool touches = side || face == RTG_LAST_BALL;
    inner = inner ||
      InNextPiece(p, joint, form.last.hi, glyph.after / unit, touches, side ? min(own, real(0.0)) : real(0.0), false);
  }
  return inner;
}

// Whether the convex hull of two balls holds a point.
RTG_FN bool InHull(const real3 p, const real3 first, const real firstRadius, const real3 last, const real lastRadius)
{
  real3 axis = last - first;
  real run = length(axis);
  real fall = firstRadius - lastRadius;
  real3 fromFirst = p - first;
  real3 fromLast = p - last;
  bool held =
    dot(fromFirst, fromFirst) <= firstRadius * firstRadius || dot(fromLast, fromLast) <= lastRadius * lastRadius;
  if (run > abs(fall))
  {
    real sine = fall / run;
    real along = dot(fromFirst, axis) / run;
    bool between = along >= firstRadius * sine && along <= run + lastRadius * sine;
    real reach = (firstRadius - along * sine) / sqrt((real(1.0) - sine) * (real(1.0) + sine));
    held = held || (between && length(fromFirst - (along / run) * axis) <= reach);
  }
  return held;
}

// Whether the ray's point at t is inside a piece of a line, and of those that share it the first.
RTG_FN bool IsInPiece(const GlyphRay ray, const Glyph glyph, const real t)
{
  real3 p = FromCenter(ray, glyph, t);
  real3 last = real3(real(0.5) * glyph.size.x, real(0.0), real(0.0));
  real first = real(0.5) * glyph.size.y;
  bool held = InHull(p, -last, first, last, real(0.5) * glyph.size.z);
  held = held && !(glyph.before.w < real(0.0) && p.x < -last.x) && !(glyph.after.w < real(0.0) && p.x > last.x);
  real3 before = real3(glyph.before.x, glyph.before.y, glyph.before.z);
  return held && !(glyph.before.w > real(0.0) && InHull(p, -last, first, before, glyph.before.w));
}

// The ray in the glyph's frame.
RTG_FN bool RoundConeCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  RoundConeForm form = FormOfRoundCone(glyph);
  real3 middle, halfSize;
  RoundConeBox(glyph, middle, halfSize);
  if (!ToLocal(ray, glyph, middle, halfSize, local))
  {
    return NoCrossing(local, crossing);
  }
  local = Divide(local, real3(RoundConeUnit(glyph)));
  Span span = RoundConeSpan(local, form);
  if (glyph.before.w < real(0.0) || glyph.after.w < real(0.0))
  {
    span = CutFlat(local, form, glyph, span);
  }
  bool innerIn = false;
  bool innerOut = false;
  if ((glyph.before.w > real(0.0) || glyph.after.w > real(0.0)) && !IsEmpty(span))
  {
    innerIn = IsInner(form, glyph, PointAt(local, span.sIn), span.faceIn);
    innerOut = IsInner(form, glyph, PointAt(local, span.sOut), span.faceOut);
  }
  // The remaining ones of the two crossings.
  Span kept = Span(innerIn ? span.sOut : span.sIn, innerOut ? span.sIn : span.sOut,
    innerIn ? span.faceOut : span.faceIn, innerOut ? span.faceIn : span.faceOut);
  bool found = FirstCrossing(local, kept, tMin, tMax, crossing) && !(innerIn && innerOut);
  crossing.leaves = crossing.leaves || innerIn;
  return found;
}

RTG_FN Enclosure RoundConeEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  RoundConeBox(glyph, outer.middle, outer.halfSize);
  // It lies in the capsule of the larger radius that fills the box: CapsuleEnclosure.
  outer.radius = real(1.000001) * sqrt(real(2.0) / (real(1.0) + outer.halfSize.y / outer.halfSize.x));
  return outer;
}

#define RTG_OUTSIDE 0
#define RTG_INSIDE 1

// What is certain of InNextPiece(): RTG_OUTSIDE, RTG_INSIDE or RTG_UNKNOWN. Lengths are the world's; `own` is `cosine`
// times that of InNextPiece(), `error` how far p may be moved, `extent` that of what is near.
RTG_FN int EstimateInNextPiece(const real3 p, const real3 joint, const real radius, const real4 next,
  const bool touches, const real own, const real cosine, const real error, const real extent)
{
  real3 far = real3(next.x, next.y, next.z);
  real3 axis = far - joint;
  real run = length(axis);
  real sine = (radius - next.w) / run;
  real squaredCosine = real(1.0) - sine * sine;
  real along = dot(p - joint, axis) / run;
  real beyond = (along - radius * sine) * cosine + own * sqrt(max(squaredCosine, real(0.0)));
  real tolerance = error * (real(4.0) + extent / run);
  real toEnd = run + next.w * sine - along;
  real depth = next.w * next.w - dot(p - far, p - far);
  real depthTolerance = real(8.0) * extent * error;
  bool inside = touches && beyond > tolerance && (toEnd > tolerance || depth > depthTolerance);
  bool outside = beyond < -tolerance || (toEnd < -tolerance && depth < -depthTolerance);
  bool certain = squaredCosine > real(0.0625) && (inside || outside);
  return !certain ? RTG_UNKNOWN : outside ? RTG_OUTSIDE : RTG_INSIDE;
}

// What is certain of IsInner(), at a point p of a round cone whose side has that sine and cosine.
RTG_FN int
EstimateInner(const Glyph glyph, const real3 p, const real sine, const real cosine, const real error, const real extent)
{
  real halfLength = real(0.5) * glyph.size.x;
  real first = real(0.5) * glyph.size.y;
  real last = real(0.5) * glyph.size.z;
  // From the planes of the circles of tangency.
  real afterFirst = p.x + halfLength - first * sine;
  real beforeLast = halfLength - p.x + last * sine;
  real tolerance = real(2.0) * error;
  int inBefore = RTG_OUTSIDE;
  int inAfter = RTG_OUTSIDE;
  if (glyph.before.w > real(0.0))
  {
    bool side = beforeLast > tolerance;
    real3 joint = real3(-halfLength, real(0.0), real(0.0));
    inBefore = afterFirst < -tolerance ? RTG_INSIDE
      : !(afterFirst > tolerance)
      ? RTG_UNKNOWN
      : EstimateInNextPiece(p, joint, first, glyph.before, side, side ? -afterFirst : real(0.0), cosine, error, extent);
  }
  if (glyph.after.w > real(0.0))
  {
    bool touches = afterFirst > tolerance;
    inAfter = EstimateInNextPiece(p, real3(halfLength, real(0.0), real(0.0)), last, glyph.after, touches,
      touches ? min(-beforeLast, real(0.0)) : real(0.0), cosine, error, extent);
  }
  bool cut = (glyph.before.w < real(0.0) && !(p.x + halfLength > tolerance)) ||
    (glyph.after.w < real(0.0) && !(halfLength - p.x > tolerance));
  bool inside = inBefore == RTG_INSIDE || inAfter == RTG_INSIDE;
  bool outside = inBefore == RTG_OUTSIDE && inAfter == RTG_OUTSIDE;
  return cut || !(inside || outside) ? RTG_UNKNOWN : inside ? RTG_INSIDE : RTG_OUTSIDE;
}

// What plain float proves of a candidate that its enclosure leaves open: README.md, Estimates of round cones. Where the
// ray may start inside, inner crossings count as if they were outer ones: a cut may close the piece there.
RTG_FN int EstimateRoundCone(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(real) low, RTG_OUT(real) high)
{
  low = tMin;
  high = tMax;
  real along = glyph.size.x;
  real halfLength = real(0.5) * along;
  real first = real(0.5) * glyph.size.y;
  real last = real(0.5) * glyph.size.z;
  bool joined = glyph.before.w > real(0.0) || glyph.after.w > real(0.0);
  bool hasDisc = glyph.before.w < real(0.0) || glyph.after.w < real(0.0);

  real3 v = (ray.origin - glyph.center) + (ray.originLow - glyph.centerLow);
  real nearest = -dot(v, ray.direction) / dot(ray.direction, ray.direction);
  real3 p = RotateToLocal(glyph, v + nearest * ray.direction);
  real3 d = RotateToLocal(glyph, ray.direction);
  real extent = halfLength + max(first, last) + max(glyph.before.w, real(0.0)) + max(glyph.after.w, real(0.0));
  real moved = real(16.0 * RTG_ROUNDOFF) * (abs(v.x) + abs(v.y) + abs(v.z) + real(6.0) * extent);
  real tolerance = real(4.0) * (extent + moved) * moved;
  if (!(tolerance > real(1.0e-30) && tolerance < real(1.0e30)))
  {
    return RTG_UNKNOWN;
  }

  // Where the line crosses the cone, in plain numbers.
  real sine = (first - last) / along;
  real squaredCosine = real(1.0) - sine * sine;
  bool ball = !(squaredCosine > real(0.0625));
  real cosine = sqrt(max(squaredCosine, real(0.0625)));
  real start = p.x + halfLength;
  real radius = (first - start * sine) / cosine;
  real rate = -d.x * sine / cosine;
  real a = d.y * d.y + d.z * d.z - rate * rate;
  real b = p.y * d.y + p.z * d.z - radius * rate;
  real c = p.y * p.y + p.z * p.z - radius * radius;
  real root = sqrt(max(b * b - a * c, real(0.0)));
  real dd = dot(d, d);
  real perUnit = inversesqrt(dd);

  int verdict = RTG_UNKNOWN;
  bool outside = true; // the ray surely starts there
  bool going = true;
  // Where it enters; and where it leaves, if it enters inside the line.
  for (int i = 0; i < 2 && going; ++i)
  {
    real sign = i == 0 ? real(1.0) : real(-1.0);
    // The middle of the ball that touches the cone there.
    real middle = (start - (b + sign * root) / a * d.x - first * sine) / squaredCosine;
    bool parallel = !(a > real(0.0)) && !(sign * rate > real(0.0));
    middle = parallel ? (sign * d.x > real(0.0) ? real(0.0) : along) : middle;
    middle = ball ? (first < last ? along : real(0.0)) : middle;
    middle = middle > real(0.0) ? min(middle, along) : real(0.0);
    real ballRadius = first - middle * sine;
    real3 m = p - real3(middle - halfLength, real(0.0), real(0.0));
    real toNearest = -dot(m, d) / dd;
    real3 q = m + toNearest * d;
    real qq = dot(q, q);
    real depth = ballRadius * ballRadius - qq;
    going = depth > real(4.0) * tolerance;
    if (going)
    {
      real halfChord = sqrt(depth);
      real toSurface = sign * perUnit * halfChord;
      real3 n = q - toSurface * d;
      // How far the balls at the ends reach beyond the plane that touches the ball there.
      real tilt = n.x - ballRadius * sine;
      real excess = max(max(-middle * tilt, (along - middle) * tilt), real(0.0)) / halfChord;
      real uncertain = real(2.0) * (moved + tolerance / halfChord);
      real at = nearest + (toNearest - toSurface);
      real inner = at + sign * perUnit * uncertain;
      real outer = at - sign * perUnit * (uncertain + excess);
      int isInner = RTG_OUTSIDE;
      if (joined || hasDisc)
      {
        isInner = ball ? RTG_UNKNOWN
                       : EstimateInner(glyph, n + real3(middle - halfLength, real(0.0), real(0.0)), sine, cosine,
                           real(2.0) * (uncertain + moved) + excess, extent);
      }
      if (i == 0)
      {
        outside = outer >= tMin;
        low = max(outer, tMin);
        going = !outside || isInner == RTG_INSIDE;
        if (isInner == RTG_OUTSIDE && outside && inner <= tMax)
        {
          verdict = RTG_HIT;
          high = inner;
        }
      }
      else
      {
        low = outside && !hasDisc ? max(low, inner) : low;
        if ((outside && isInner == RTG_INSIDE) || outer < tMin)
        {
          verdict = RTG_MISSED;
        }
        if (isInner == RTG_OUTSIDE && outside && outer <= tMax)
        {
          verdict = RTG_HIT;
          low = inner;
          high = outer;
        }
      }
      if (low > tMax)
      {
        verdict = RTG_MISSED;
        going = false;
      }
    }
    else
    {
      // It passes by if both balls lie behind a plane along it.
      real distance = sqrt(qq);
      if (min(qq + q.x * middle - first * distance, qq - q.x * (along - middle) - last * distance) > tolerance)
      {
        verdict = RTG_MISSED;
      }
    }
  }
  return verdict;
}

RTG_FN real3 RoundConeNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  RoundConeForm form = FormOfRoundCone(glyph);
  LocalRay at = Advance(Advance(local, crossing.s.hi), crossing.s.lo);
  DoubleWord x = WordX(at.origin);
  real3 p = at.origin.hi;
  real3 flat_ = real3(crossing.face == RTG_FIRST_DISC ? real(-1.0) : real(1.0), real(0.0), real(0.0));
  real3 normal = crossing.face == RTG_SIDE
    ? real3(form.sine.hi * sqrt(p.y * p.y + p.z * p.z), form.cosine.hi * p.y, form.cosine.hi * p.z)
    : crossing.face == RTG_FIRST_BALL ? real3(Add(x, form.halfLength).hi, p.y, p.z)
    : crossing.face == RTG_LAST_BALL  ? real3(Subtract(x, form.halfLength).hi, p.y, p.z)
                                      : flat_;
  // A ball without radius is an apex, which has none.
  normal =
    dot(normal, normal) > real(0.0) ? normal : real3(p.x < real(0.0) ? real(-1.0) : real(1.0), real(0.0), real(0.0));
  return normalize(RotateToWorld(glyph, normal));
}

RTG_INTERSECT_BY_SPANS(RoundCone, RoundCone)

RTG_FN Bounds RoundConeBounds(const Glyph glyph)
{
  real3 toLast = RotateToWorld(glyph, real3(real(0.5) * glyph.size.x, real(0.0), real(0.0)));
  real3 first = real3(real(0.5) * glyph.size.y);
  real3 last = real3(real(0.5) * glyph.size.z);
  return Bounds(min(-toLast - first, toLast - last), max(first - toLast, toLast + last));
}
