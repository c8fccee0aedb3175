// Cylinder along y, height 1, radius 0.5, centered, with its caps.

// Faces: 0 the side, 1 the cap at -y, 2 the cap at +y.
RTG_FN bool CylinderCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  real3 halfSize = real(0.5) * glyph.size;
  if (!ToBoxFrame(ray, glyph, halfSize, local))
  {
    return NoCrossing(local, crossing);
  }
  DoubleWord one = Word(real(1.0));
  Span height = Slab(WordY(local.origin), WordY(local.direction), Minus(one), one, 1, 2);
  Span side = RoundSpan(
    WordX(local.origin), WordZ(local.origin), one, WordX(local.direction), WordZ(local.direction), Word(real(0.0)), 0);
  return FirstCrossing(local, Intersection(height, side), tMin, tMax, crossing);
}

#define CylinderEnclosure RoundEnclosure

RTG_FN real3 CylinderNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  real3 normal = real3(real(0.0), crossing.face == 1 ? real(-1.0) : real(1.0), real(0.0));
  if (crossing.face == 0)
  {
    real3 p = PointAt(local, crossing.s);
    real smallest = min(glyph.size.x, glyph.size.z);
    normal = real3(p.x * (smallest / glyph.size.x), real(0.0), p.z * (smallest / glyph.size.z));
  }
  return normalize(RotateToWorld(glyph, normal));
}

RTG_INTERSECT_BY_SPANS(Cylinder, Cylinder)

RTG_FN Bounds CylinderBounds(const Glyph glyph)
{
  real3 halfSize = real(0.5) * glyph.size;
  real3 axis = RotateToWorld(glyph, real3(real(0.0), halfSize.y, real(0.0)));
  return SymmetricBounds(
    abs(axis) + DiscReach(glyph, real3(halfSize.x, real(0.0), real(0.0)), real3(real(0.0), real(0.0), halfSize.z)));
}
