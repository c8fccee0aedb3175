// The outline of an arrow: a shaft and a head that is the convex hull of its base disc and of a sphere
// that touches the tip.
//
//   shaft: radius Rs, from the tail to the head's base
//   head:  base disc of radius R at distance H from the tip, sphere of radius a centered at distance a
//          from the tip, and the cone that touches both; so the tip lies at x = 1 for every a.
//   a = rounding^2 R H / (R + sqrt(R^2 + H^2)). The fraction is the inradius of the sharp head's profile:
//          the largest sphere that fits between the head's base and sides, hence always narrower than
//          the base. rounding = 0 leaves vtkArrowSource's cone, rounding = 1 gives a bullet; the square keeps
//          the middle of the range an arrow with a soft tip.

// Where the arrow lies in its own frame: p_unit = p times / over, component by component. In the unit
// frame the head has the proportions of glyph.arrow; the arrow is `extent` long there.
struct ArrowScale
{
  real times;
  real3 over;
  DoubleWord extent;
};

RTG_FN ArrowScale ScaleOfArrow(const Glyph glyph)
{
  ArrowScale scale = ArrowScale(real(1.0), glyph.size, Word(real(1.0)));
  if (glyph.fixedHeads)
  {
    real tipLength = glyph.arrow.z;
    if (glyph.size.x > tipLength * glyph.unitLength)
    {
      scale.over = real3(glyph.unitLength);
      scale.extent = Divide(Word(glyph.size.x), glyph.unitLength);
    }
    else
    {
      // Shorter than its head: the head alone, shrunk as a whole.
      scale.times = tipLength;
      scale.over = real3(glyph.size.x);
      scale.extent = Word(tipLength);
    }
  }
  return scale;
}

RTG_FN bool HasShaft(const Glyph glyph, const ArrowScale scale)
{
  DoubleWord shaft = Add(scale.extent, -glyph.arrow.z);
  return glyph.arrow.x > real(0.0) && shaft.hi > real(0.0);
}

RTG_FN bool HasHead(const Glyph glyph)
{
  return glyph.arrow.y > real(0.0);
}

// The head in the unit frame, as functions of the distance from the tip.
struct ArrowHead
{
  DoubleWord ball;  // a, the radius of the sphere and the distance of its center from the tip
  DoubleWord slope; // of the cone's radius
  real coneStart;   // where the cone touches the sphere
};

RTG_FN ArrowHead HeadOfArrow(const Glyph glyph)
{
  real radius = glyph.arrow.y;
  real height = glyph.arrow.z;
  real rounding = glyph.arrow.w;
  ArrowHead head = ArrowHead(Word(real(0.0)), Divide(Word(radius), height), real(0.0));
  if (!(rounding > real(0.0)))
  {
    return head;
  }

  DoubleWord radiusSquared = TwoProduct(radius, radius);
  DoubleWord sideSquared = Add(radiusSquared, TwoProduct(height, height));
  DoubleWord a =
    Divide(Multiply(TwoProduct(radius, height), TwoProduct(rounding, rounding)), Add(SquareRoot(sideSquared), radius));
  DoubleWord center = Minus(Add(a, -height)); // distance between the sphere's center and the base

  // The line from the base's rim (0, R) that touches the circle (center, a): its unit normal is
  // (t R - a c, a R + t c) / (R^2 + c^2) with t the tangent's length, t^2 = R^2 + c^2 - a^2.
  DoubleWord twoHeightA = Multiply(a, real(2.0) * height);
  DoubleWord tangent = SquareRoot(Subtract(sideSquared, twoHeightA));
  DoubleWord along = Subtract(Multiply(tangent, radius), Multiply(a, center));
  DoubleWord across = Add(Multiply(a, radius), Multiply(tangent, center));
  real norm = radiusSquared.hi + center.hi * center.hi;
  head.ball = a;
  head.slope = Divide(along, across);
  head.coneStart = a.hi * (real(1.0) - along.hi / norm);
  return head;
}

// The arrow's bounds in its own frame, in world units: two discs and the ball at the tip.
RTG_FN Bounds ArrowBounds(const Glyph glyph)
{
  ArrowScale scale = ScaleOfArrow(glyph);
  real3 worldSize = scale.over / scale.times;
  real3 tip = RotateToWorld(glyph, real3(glyph.size.x, real(0.0), real(0.0)));
  real3 base = RotateToWorld(glyph, real3(glyph.size.x - glyph.arrow.z * worldSize.x, real(0.0), real(0.0)));
  real3 unitDisc = DiscReach(glyph, real3(real(0.0), worldSize.y, real(0.0)), real3(real(0.0), real(0.0), worldSize.z));
  bool shaft = HasShaft(glyph, scale);
  bool head = HasHead(glyph);
  Bounds bounds = SymmetricBounds(real3(real(0.0)));
  if (shaft)
  {
    real3 reach = glyph.arrow.x * unitDisc;
    bounds = Bounds(min(-reach, base - reach), max(reach, base + reach));
  }
  if (head)
  {
    real a = HeadOfArrow(glyph).ball.hi;
    real3 x = RotateToWorld(glyph, real3(worldSize.x, real(0.0), real(0.0)));
    real3 ball = a * sqrt(x * x + unitDisc * unitDisc);
    real3 center = tip - a * x;
    real3 reach = glyph.arrow.y * unitDisc;
    real3 headLower = min(base - reach, center - ball);
    real3 headUpper = max(base + reach, center + ball);
    bounds.lower = shaft ? min(bounds.lower, headLower) : headLower;
    bounds.upper = shaft ? max(bounds.upper, headUpper) : headUpper;
  }
  return bounds;
}
