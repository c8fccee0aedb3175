// Capsule along x, centered: a cylinder of length 1 and radius 0.5 with half balls on its ends: 2 long in all. Its
// sizes are the length of the cylinder and the diameters along y and z. Where these differ it is the round capsule of
// the larger diameter, flattened along the other axis: seen along that axis its ends are half discs. The round capsule
// is the round cone of two balls alike.

// The half-axes of the ends.
RTG_FN real3 CapsuleEnd(const Glyph glyph)
{
  return real(0.5) * real3(max(glyph.size.y, glyph.size.z), glyph.size.y, glyph.size.z);
}

// Half the extents of the whole.
RTG_FN real3 CapsuleHalfSize(const Glyph glyph)
{
  return CapsuleEnd(glyph) + real3(real(0.5) * glyph.size.x, real(0.0), real(0.0));
}

// Half the length of the cylinder where its radius is 1.
RTG_FN DoubleWord CapsuleHalfLength(const Glyph glyph)
{
  return Divide(Word(glyph.size.x), Word(max(glyph.size.y, glyph.size.z)));
}

// The ray in the frame where the capsule is round and its radius is 1.
RTG_FN bool CapsuleCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  if (!ToLocal(ray, glyph, real3(real(0.0)), CapsuleHalfSize(glyph), local))
  {
    return NoCrossing(local, crossing);
  }
  local = Divide(local, CapsuleEnd(glyph));
  RoundConeForm form = MakeRoundCone(CapsuleHalfLength(glyph), Word(real(1.0)), Word(real(1.0)));
  return FirstCrossing(local, RoundConeSpan(local, form), tMin, tMax, crossing);
}

RTG_FN Enclosure CapsuleEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  outer.halfSize = CapsuleHalfSize(glyph);
  // Of a capsule with the half-length h and the radius 1, squeezed by h + 1: its farthest points lie on the half balls
  // and have the square 2 (h + 1) / (h + 2).
  real halfLength = glyph.size.x / max(glyph.size.y, glyph.size.z);
  outer.radius = real(1.000001) * sqrt(real(2.0) * (halfLength + real(1.0)) / (halfLength + real(2.0)));
  return outer;
}

RTG_FN real3 CapsuleNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  // The ray from the crossing, and from the middle of the half ball when the crossing lies on one.
  LocalRay at = Advance(Advance(local, crossing.s.hi), crossing.s.lo);
  DoubleWord x = WordX(at.origin);
  DoubleWord halfLength = CapsuleHalfLength(glyph);
  DoubleWord middle = x.hi < real(0.0) ? Minus(halfLength) : halfLength;
  DoubleWord fromMiddle = Subtract(x, middle);
  real3 p = real3(real(0.0), at.origin.hi.y, at.origin.hi.z);
  if (fromMiddle.hi * x.hi > real(0.0))
  {
    at.origin.hi.x = fromMiddle.hi;
    at.origin.lo.x = fromMiddle.lo;
    p = OnUnitSphere(at);
  }
  real smallest = min(glyph.size.y, glyph.size.z);
  return normalize(RotateToWorld(glyph, p * (real(0.5) * real3(smallest) / CapsuleEnd(glyph))));
}

RTG_INTERSECT_BY_SPANS(Capsule, Capsule)

RTG_FN Bounds CapsuleBounds(const Glyph glyph)
{
  real3 axis = RotateToWorld(glyph, real3(real(0.5) * glyph.size.x, real(0.0), real(0.0)));
  return SymmetricBounds(abs(axis) + EllipsoidReach(glyph, CapsuleEnd(glyph)));
}
