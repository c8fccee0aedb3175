// Arrow along +x from 0 to its length; its outline is in ArrowForm.glsl.

// Faces of the arrow.
#define RTG_SHAFT_SIDE 0
#define RTG_TAIL 1
#define RTG_SHAFT_END 2
#define RTG_HEAD_BASE 3
#define RTG_HEAD_CONE 4
#define RTG_HEAD_BALL 5
#define RTG_HEAD_APEX 6

// The box round the arrow in the glyph's frame.
RTG_FN void ArrowBox(const Glyph glyph, const ArrowScale scale, RTG_OUT(real3) middle, RTG_OUT(real3) halfSize)
{
  real radius = max(glyph.arrow.x, glyph.arrow.y);
  real3 worldSize = scale.over / scale.times;
  real halfLength = real(0.5) * glyph.size.x;
  middle = real3(halfLength, real(0.0), real(0.0));
  halfSize = real3(halfLength, radius * worldSize.y, radius * worldSize.z);
}

RTG_FN Span ShaftSpan(const LocalRay ray, const Glyph glyph, const ArrowScale scale)
{
  Span height =
    Slab(WordX(ray.origin), WordX(ray.direction), Word(glyph.arrow.z), scale.extent, RTG_SHAFT_END, RTG_TAIL);
  Span side = RoundSpan(WordY(ray.origin), WordZ(ray.origin), Word(glyph.arrow.x), WordY(ray.direction),
    WordZ(ray.direction), Word(real(0.0)), RTG_SHAFT_SIDE);
  return Intersection(height, side);
}

RTG_FN Span HeadSpan(const LocalRay ray, const Glyph glyph, const ArrowHead head)
{
  DoubleWord x = WordX(ray.origin);
  DoubleWord dx = WordX(ray.direction);
  // The cone from next to its base: a fixed head may be a millionth of the arrow.
  LocalRay base = NextTo(ray, Add(x, -glyph.arrow.z));
  DoubleWord radius = Add(Multiply(WordX(base.origin), head.slope), glyph.arrow.y);
  DoubleWord rate = Multiply(dx, head.slope);

  bool rounded = head.ball.hi > real(0.0);
  DoubleWord start = Word(head.coneStart);
  int startFace = rounded ? RTG_HEAD_CONE : RTG_HEAD_APEX;
  Span height = Slab(x, dx, start, Word(glyph.arrow.z), startFace, RTG_HEAD_BASE);
  Span side = RoundSpan(
    WordY(base.origin), WordZ(base.origin), radius, WordY(ray.direction), WordZ(ray.direction), rate, RTG_HEAD_CONE);
  Span cone = Intersection(height, Later(side, base.start));
  if (!rounded)
  {
    return cone;
  }
  // Cone and ball meet in the plane of their circle of tangency; each ends there, since next to it their
  // surfaces are too close to decide which is outside.
  Span cap = Slab(x, dx, Word(real(0.0)), start, RTG_HEAD_BALL, startFace);
  return Hull(cone, Intersection(cap, BallSpan(ray, head.ball, head.ball, RTG_HEAD_BALL)));
}

// The ray in the arrow's unit frame, x turned round to count from the tip to the tail.
RTG_FN bool ArrowCrossing(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax,
  RTG_OUT(LocalRay) local, RTG_OUT(Crossing) crossing)
{
  ArrowScale scale = ScaleOfArrow(glyph);
  real3 middle, halfSize;
  ArrowBox(glyph, scale, middle, halfSize);
  if (!ToLocal(ray, glyph, middle, halfSize, local))
  {
    return NoCrossing(local, crossing);
  }
  DoubleWord3 fromTip = Add(local.origin, real3(-glyph.size.x, real(0.0), real(0.0)));
  real3 turnedRound = real3(-scale.times, scale.times, scale.times);
  local = LocalRay(local.start, Divide(Multiply(fromTip, turnedRound), scale.over),
    Divide(Multiply(local.direction, turnedRound), scale.over));
  Span shaftPart = HasShaft(glyph, scale) ? ShaftSpan(local, glyph, scale) : EmptySpan();
  Span headPart = HasHead(glyph) ? HeadSpan(local, glyph, HeadOfArrow(glyph)) : EmptySpan();

  // Shaft and head meet in the plane of the head's base, to the bit: their spans meet there or are apart.
  bool apart = IsEmpty(shaftPart) || IsEmpty(headPart) || IsLess(headPart.sOut, shaftPart.sIn) ||
    IsLess(shaftPart.sOut, headPart.sIn);
  bool shaftFirst = IsLess(shaftPart.sIn, headPart.sIn);
  Span first = !apart ? Hull(shaftPart, headPart) : shaftFirst ? shaftPart : headPart;
  Span second = !apart ? EmptySpan() : shaftFirst ? headPart : shaftPart;
  // Both are computed, and one is chosen at the end: see FirstCrossing().
  Crossing other;
  bool found = FirstCrossing(local, first, tMin, tMax, crossing);
  bool foundOther = FirstCrossing(local, second, tMin, tMax, other);
  crossing = found ? crossing : other;
  return found || foundOther;
}

RTG_FN Enclosure ArrowEnclosure(const Glyph glyph)
{
  Enclosure outer = RoundEnclosure(glyph);
  ArrowBox(glyph, ScaleOfArrow(glyph), outer.middle, outer.halfSize);
  return outer;
}

RTG_FN real3 ArrowNormal(const Glyph glyph, const LocalRay local, const Crossing crossing)
{
  real3 p = PointAt(local, crossing.s);
  bool backwards = crossing.face == RTG_TAIL || crossing.face == RTG_HEAD_BASE;
  real3 flat_ = real3(backwards ? real(-1.0) : real(1.0), real(0.0), real(0.0));
  real radius = sqrt(p.y * p.y + p.z * p.z); // zero at the apex, where there is no normal
  real3 normal = crossing.face == RTG_SHAFT_SIDE           ? real3(real(0.0), p.y, p.z)
    : crossing.face == RTG_HEAD_BALL                       ? real3(HeadOfArrow(glyph).ball.hi - p.x, p.y, p.z)
    : crossing.face == RTG_HEAD_CONE && radius > real(0.0) ? real3(HeadOfArrow(glyph).slope.hi * radius, p.y, p.z)
                                                           : flat_;
  return normalize(RotateToWorld(glyph, glyph.fixedHeads ? normal : OverSize(glyph, normal)));
}

RTG_INTERSECT_BY_SPANS(Arrow, Arrow)
