// Box of side 1, centered.

RTG_FN bool BoxCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  real3 halfSize = real(0.5) * glyph.size;
  if (!ToLocal(ray, glyph, real3(real(0.0)), halfSize, local))
  {
    return NoCrossing(local, crossing);
  }
  return FirstCrossing(local, BoxSpan(local, halfSize), tMin, tMax, crossing);
}

#define BoxEnclosure BoxedEnclosure

RTG_FN real3 BoxNormal(const Glyph glyph, const LocalRay, const Crossing crossing)
{
  int axis = crossing.face / 2;
  real outward = crossing.face == 2 * axis ? real(-1.0) : real(1.0);
  real3 normal =
    real3(axis == 0 ? outward : real(0.0), axis == 1 ? outward : real(0.0), axis == 2 ? outward : real(0.0));
  return normalize(RotateToWorld(glyph, normal));
}

RTG_INTERSECT_BY_SPANS(Box, Box)

RTG_FN Bounds BoxBounds(const Glyph glyph)
{
  return SymmetricBounds(BoxReach(glyph, real(0.5) * glyph.size));
}
