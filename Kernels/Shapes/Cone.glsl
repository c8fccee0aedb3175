// Cone along +x with its base: base of radius 0.5 at x = -0.5, apex at x = 0.5.

// Faces: 0 the side, 1 the base, 2 the apex.
RTG_FN bool ConeCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  real3 halfSize = real(0.5) * glyph.size;
  if (!ToBoxFrame(ray, glyph, halfSize, local))
  {
    return NoCrossing(local, crossing);
  }

  // In the frame of the box the radius is (1 - x) / 2.
  DoubleWord one = Word(real(1.0));
  DoubleWord x = WordX(local.origin);
  DoubleWord dx = WordX(local.direction);
  DoubleWord radius = Multiply(Subtract(one, x), real(0.5));
  DoubleWord rate = Multiply(dx, real(-0.5));

  Span height = Slab(x, dx, Minus(one), one, 1, 2);
  Span side = RoundSpan(
    WordY(local.origin), WordZ(local.origin), radius, WordY(local.direction), WordZ(local.direction), rate, 0);
  return FirstCrossing(local, Intersection(height, side), tMin, tMax, crossing);
}

#define ConeEnclosure RoundEnclosure

RTG_FN real3 ConeNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  real3 normal = real3(crossing.face == 1 ? real(-1.0) : real(1.0), real(0.0), real(0.0));
  if (crossing.face == 0)
  {
    // Gradient of y^2 + z^2 - radius^2, with radius = sqrt(y^2 + z^2) on the side.
    real3 p = PointAt(local, crossing.s);
    real radius = sqrt(p.y * p.y + p.z * p.z);
    // At the apex there is none.
    normal = radius > real(0.0) ? OverSize(glyph, real3(real(0.5) * radius, p.y, p.z)) : normal;
  }
  return normalize(RotateToWorld(glyph, normal));
}

RTG_INTERSECT_BY_SPANS(Cone, Cone)

RTG_FN Bounds ConeBounds(const Glyph glyph)
{
  real3 halfSize = real(0.5) * glyph.size;
  real3 apex = RotateToWorld(glyph, real3(halfSize.x, real(0.0), real(0.0)));
  real3 disc = DiscReach(glyph, real3(real(0.0), halfSize.y, real(0.0)), real3(real(0.0), real(0.0), halfSize.z));
  return Bounds(min(apex, -apex - disc), max(apex, -apex + disc));
}
