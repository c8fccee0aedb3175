// Common code of shapes with round cross-sections.

// Half the extents of the ellipse with the given half-axes (unit glyph's frame) along the world's axes.
RTG_FN real3 DiscReach(const Glyph glyph, const real3 u, const real3 v)
{
  real3 a = RotateToWorld(glyph, u);
  real3 b = RotateToWorld(glyph, v);
  return sqrt(a * a + b * b);
}

// The ray in the frame where the glyph's box is [-1, 1]^3: all that follows is of the order of one, whatever
// the sizes' ratios. False: it certainly misses.
RTG_FN bool ToBoxFrame(const GlyphRay ray, const Glyph glyph, const real3 halfSize, RTG_OUT(LocalRay) unit)
{
  bool near = ToLocal(ray, glyph, real3(real(0.0)), halfSize, unit);
  unit = near ? Divide(unit, halfSize) : unit;
  return near;
}
