// Sphere of diameter 1 and its affine images, the ellipsoids.

// radius^2 - |o|^2. The squares are exact and their sum is compensated (Ogita, Rump, Oishi: Accurate sum
// and dot product, SIAM J. Sci. Comput. 26(6), 2005, algorithm 5.3): near the silhouette all digits of
// a plain difference cancel.
RTG_FN real SquaredDepth(const DoubleWord radiusSquared, const DoubleWord3 o)
{
  DoubleWord3 p = TwoProduct(o.hi, o.hi);
  DoubleWord x = TwoSum(radiusSquared.hi, -p.hi.x);
  DoubleWord y = TwoSum(x.hi, -p.hi.y);
  DoubleWord z = TwoSum(y.hi, -p.hi.z);
  real rounding = ((x.lo + y.lo) + z.lo) + radiusSquared.lo;
  real squares = (p.lo.x + p.lo.y) + p.lo.z;
  real mixed = (o.hi.x * o.lo.x + o.hi.y * o.lo.y) + o.hi.z * o.lo.z;
  return z.hi + ((rounding - squares) - real(2.0) * mixed);
}

// The span inside |o + s d| <= radius when o is close to the point of the line nearest to the origin: then
// b is next to nothing and b^2 + a c cancels only inside c, which is compensated.
// Haines et al.: Precision improvements for ray/sphere intersection, Ray Tracing Gems, chapter 7, 2019.
RTG_FN Span CenteredSphereSpan(const DoubleWord3 o, const real3 d, const DoubleWord radiusSquared)
{
  real a = dot(d, d);
  real b = dot(o.hi, d);
  real c = SquaredDepth(radiusSquared, o);
  real discriminant = b * b + a * c;
  if (!(discriminant >= real(0.0)))
  {
    return EmptySpan();
  }
  real root = sqrt(discriminant);
  return Span(Word((-b - root) / a), Word((-b + root) / a), 0, 0);
}

// The span inside the ball of that radius round a point of the x axis, from an origin moved next to it.
RTG_FN Span BallSpan(const LocalRay ray, const DoubleWord centerX, const DoubleWord radius, const int face)
{
  LocalRay ball = NextTo(ray, Subtract(WordX(ray.origin), centerX));
  Span span = Later(CenteredSphereSpan(ball.origin, ray.direction.hi, Multiply(radius, radius)), ball.start);
  span.faceIn = face;
  span.faceOut = face;
  return span;
}

RTG_FN bool SphereCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  real3 halfSize = real(0.5) * glyph.size;
  Span span = EmptySpan();
  if (glyph.sameSize)
  {
    if (MissesBall(ray, glyph, real3(real(0.0)), halfSize.x))
    {
      return NoCrossing(local, crossing);
    }
    local = NearRay(ray, glyph);
    span = CenteredSphereSpan(local.origin, ray.direction, TwoProduct(halfSize.x, halfSize.x));
  }
  else
  {
    if (!ToLocal(ray, glyph, real3(real(0.0)), halfSize, local))
    {
      return NoCrossing(local, crossing);
    }
    // The frame where the ellipsoid is the unit sphere; the origin is moved once more: what is nearest to the center in
    // the world is far from it here when the sizes differ much.
    local = Divide(local, halfSize);
    real3 d = local.direction.hi;
    local = Advance(local, -dot(local.origin.hi, d) / dot(d, d));
    span = CenteredSphereSpan(local.origin, local.direction.hi, Word(real(1.0)));
  }
  return FirstCrossing(local, span, tMin, tMax, crossing);
}

RTG_FN Enclosure SphereEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  outer.boxed = false;
  outer.fills = true;
  outer.inWorld = glyph.sameSize;
  outer.radius = glyph.sameSize ? outer.halfSize.x : real(1.0);
  return outer;
}

// The point of the unit sphere next to the ray's origin, which lies on it but for the rounding of s: one Newton step,
// away from the silhouette. A needle's tip shows every digit.
RTG_FN real3 OnUnitSphere(const LocalRay ray)
{
  real a = dot(ray.direction.hi, ray.direction.hi);
  real b = dot(ray.origin.hi, ray.direction.hi);
  real c = SquaredDepth(Word(real(1.0)), ray.origin);
  real step = real(64.0) * a * abs(c) < b * b ? c / (real(2.0) * b) : real(0.0);
  return PointAt(ray, Word(step));
}

RTG_FN real3 SphereNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  if (glyph.sameSize)
  {
    return normalize(PointAt(local, crossing.s));
  }
  return normalize(RotateToWorld(glyph, OverSize(glyph, OnUnitSphere(Advance(local, crossing.s.hi)))));
}

RTG_INTERSECT_BY_SPANS(Sphere, Sphere)

// Half the extents of the ellipsoid with the given half-axes along the world's axes.
RTG_FN real3 EllipsoidReach(const Glyph glyph, const real3 halfAxes)
{
  if (!glyph.rotated)
  {
    return halfAxes;
  }
  Axes axes = WorldAxes(glyph, halfAxes);
  return sqrt(axes.x * axes.x + axes.y * axes.y + axes.z * axes.z);
}

RTG_FN Bounds SphereBounds(const Glyph glyph)
{
  real3 halfSize = real(0.5) * glyph.size;
  return SymmetricBounds(glyph.sameSize ? halfSize : EllipsoidReach(glyph, halfSize));
}
