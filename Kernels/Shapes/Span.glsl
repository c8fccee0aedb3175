// The part of a ray inside a convex body, and how slabs and quadrics bound it.

// Inside for sIn <= s <= sOut. Faces are numbered by each shape for its normals.
struct Span
{
  DoubleWord sIn;
  DoubleWord sOut;
  int faceIn;
  int faceOut;
};

// One boundary point of a shape on a ray.
struct Crossing
{
  DoubleWord s; // parameter of the local ray
  real t;       // parameter of the world ray
  int face;
  bool leaves; // the shape, rather than enters it
};

RTG_FN Span WholeRay()
{
  return Span(Word(-real(RTG_NEVER)), Word(real(RTG_NEVER)), -1, -1);
}

RTG_FN Span EmptySpan()
{
  return Span(Word(real(RTG_NEVER)), Word(-real(RTG_NEVER)), -1, -1);
}

RTG_FN bool IsLess(const DoubleWord a, const DoubleWord b)
{
  return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}

RTG_FN bool IsEmpty(const Span span)
{
  return IsLess(span.sOut, span.sIn) || !(span.sIn.hi <= span.sOut.hi);
}

// The span that begins as a or, with `inOfB`, as b, and likewise ends.
RTG_FN Span Ends(const Span a, const Span b, const bool inOfB, const bool outOfB)
{
  return Span(
    inOfB ? b.sIn : a.sIn, outOfB ? b.sOut : a.sOut, inOfB ? b.faceIn : a.faceIn, outOfB ? b.faceOut : a.faceOut);
}

RTG_FN Span Intersection(const Span a, const Span b)
{
  return Ends(a, b, IsLess(a.sIn, b.sIn), IsLess(b.sOut, a.sOut));
}

// The smallest span that holds both; the union when they touch.
RTG_FN Span Hull(const Span a, const Span b)
{
  bool hasA = !IsEmpty(a);
  bool hasB = !IsEmpty(b);
  return Ends(a, b, hasB && (!hasA || IsLess(b.sIn, a.sIn)), hasB && (!hasA || IsLess(a.sOut, b.sOut)));
}

// The ray from where it is nearest to a point of the x axis, which becomes the frame's origin; `x` is that of the ray's
// origin from there. `start` is how much later it begins.
RTG_FN LocalRay NextTo(const LocalRay ray, const DoubleWord x)
{
  LocalRay next = ray;
  next.start = Word(real(0.0));
  next.origin.hi.x = x.hi;
  next.origin.lo.x = x.lo;
  return Advance(next, -dot(next.origin.hi, ray.direction.hi) / dot(ray.direction.hi, ray.direction.hi));
}

// The span of a ray that begins later by `start`, as one of the ray itself.
RTG_FN Span Later(const Span span, const DoubleWord start)
{
  return Span(Add(start, span.sIn), Add(start, span.sOut), span.faceIn, span.faceOut);
}

// Between the planes lower <= o + s d <= upper; faceLower, faceUpper name the planes.
// A ray inside a plane counts as inside the slab.
RTG_FN Span Slab(const DoubleWord o, const DoubleWord d, const DoubleWord lower, const DoubleWord upper,
  const int faceLower, const int faceUpper)
{
  DoubleWord toLower = Subtract(lower, o);
  DoubleWord toUpper = Subtract(upper, o);
  if (d.hi == real(0.0))
  {
    return toLower.hi > real(0.0) || toUpper.hi < real(0.0) ? EmptySpan() : WholeRay();
  }
  DoubleWord sLower = Divide(toLower, d);
  DoubleWord sUpper = Divide(toUpper, d);
  return d.hi > real(0.0) ? Span(sLower, sUpper, faceLower, faceUpper) : Span(sUpper, sLower, faceUpper, faceLower);
}

// The box -halfSize <= x, y, z <= halfSize. Faces 0 .. 5 are -x, +x, -y, +y, -z, +z.
RTG_FN Span BoxSpan(const LocalRay ray, const real3 halfSize)
{
  Span x = Slab(WordX(ray.origin), WordX(ray.direction), Word(-halfSize.x), Word(halfSize.x), 0, 1);
  Span y = Slab(WordY(ray.origin), WordY(ray.direction), Word(-halfSize.y), Word(halfSize.y), 2, 3);
  Span z = Slab(WordZ(ray.origin), WordZ(ray.direction), Word(-halfSize.z), Word(halfSize.z), 4, 5);
  return Intersection(x, Intersection(y, z));
}

// The body of revolution y^2 + z^2 <= rho^2 where y, z and the radius rho change linearly along the ray:
// a cylinder, or the nappe rho >= 0 of a cone, of which the caller keeps the part between two planes with
// rho >= 0. `oRho`, `dRho`: the radius at s = 0 and its rate. All is computed, and one is chosen at the end: with exits
// before, LLVM 21 compiles what is done with the span wrongly.
RTG_FN Span RoundSpan(const DoubleWord oy, const DoubleWord oz, const DoubleWord oRho, const DoubleWord dy,
  const DoubleWord dz, const DoubleWord dRho, const int face)
{
  // a s^2 + 2 b s + c <= 0
  DoubleWord a = Add(Add(Multiply(dy, dy), Multiply(dz, dz)), Minus(Multiply(dRho, dRho)));
  DoubleWord b = Add(Add(Multiply(oy, dy), Multiply(oz, dz)), Minus(Multiply(oRho, dRho)));
  DoubleWord c = Add(Add(Multiply(oy, oy), Multiply(oz, oz)), Minus(Multiply(oRho, oRho)));
  DoubleWord discriminant = Subtract(Multiply(b, b), Multiply(a, c));
  bool misses = discriminant.hi < real(0.0) && a.hi > real(0.0);

  // The two roots without cancellation: q / a and c / q.
  DoubleWord root = SquareRoot(discriminant);
  DoubleWord q = Minus(b.hi < real(0.0) ? Subtract(b, root) : Add(b, root));
  // Neither term in s: the ray runs along the body.
  bool along = q.hi == real(0.0) && a.hi == real(0.0);
  DoubleWord first = q.hi == real(0.0) ? Word(real(0.0)) : Divide(c, q);
  real never = (q.hi < real(0.0)) == (a.hi < real(0.0)) ? real(RTG_NEVER) : -real(RTG_NEVER);
  DoubleWord second = abs(q.hi) >= real(RTG_NEVER) * abs(a.hi) ? Word(never) : Divide(q, a);
  bool ordered = IsLess(first, second);
  DoubleWord s1 = ordered ? first : second;
  DoubleWord s2 = ordered ? second : first;

  Span span = Span(Word(-real(RTG_NEVER)), Word(real(RTG_NEVER)), face, face);
  // Steeper along the axis than the cone's side: one half line lies in each nappe.
  bool steep = a.hi < real(0.0);
  bool widens = dRho.hi > real(0.0);
  if (!along && !(steep && widens))
  {
    span.sOut = steep ? s1 : s2;
  }
  if (!along && !(steep && !widens))
  {
    span.sIn = steep ? s2 : s1;
  }
  if (misses || (along && c.hi > real(0.0)))
  {
    span = EmptySpan();
  }
  return span;
}

// The first end of the span with tMin <= t <= tMax. Both are computed, and one is chosen at the end: LLVM 21 loses half
// of a crossing that one branch fills and another one overwrites.
RTG_FN bool
FirstCrossing(const LocalRay ray, const Span span, const real tMin, const real tMax, RTG_OUT(Crossing) crossing)
{
  real tIn = RayParameter(ray, span.sIn).hi;
  real tOut = RayParameter(ray, span.sOut).hi;
  bool first = IsEmpty(span) || (tIn >= tMin && tIn <= tMax);
  crossing = Crossing(span.sOut, tOut, span.faceOut, true);
  if (first)
  {
    crossing = Crossing(span.sIn, tIn, span.faceIn, false);
  }
  return !IsEmpty(span) && crossing.t >= tMin && crossing.t <= tMax;
}

// The answer to a ray that certainly misses.
RTG_FN bool NoCrossing(RTG_OUT(LocalRay) ray, RTG_OUT(Crossing) crossing)
{
  ray = LocalRay(Word(real(0.0)), Word3(real3(real(0.0))), Word3(real3(real(0.0))));
  crossing = Crossing(Word(real(0.0)), real(RTG_NEVER), -1, false);
  return false;
}

// Intersect<Name>() of a shape whose <Shape>Crossing() finds the crossing on a ray in a frame of its own, and whose
// <Shape>Normal() gives the normal there.
#define RTG_INTERSECT_BY_SPANS(Name, Shape)                                                                            \
  RTG_FN GlyphHit Intersect##Name(                                                                                     \
    const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsNormal)                   \
  {                                                                                                                    \
    LocalRay local;                                                                                                    \
    Crossing crossing;                                                                                                 \
    bool found = Shape##Crossing(ray, glyph, tMin, tMax, local, crossing);                                             \
    return GlyphHit(found, crossing.leaves, crossing.t,                                                                \
      found && wantsNormal ? Shape##Normal(glyph, local, crossing) : -ray.direction);                                  \
  }

// The local point at s in plain numbers.
RTG_FN real3 PointAt(const LocalRay ray, const DoubleWord s)
{
  return Add(ray.origin, Multiply(ray.direction, Word3(s))).hi;
}

// The vector from the glyph's center to the ray's point at t, in the glyph's frame: right to a few ulps of the glyph's
// size beside what the rounding of t does.
RTG_FN real3 FromCenter(const GlyphRay ray, const Glyph glyph, const real t)
{
  LocalRay near = NearRay(ray, glyph);
  return RotateToLocal(glyph, PointAt(near, Add(Word(t), Minus(near.start))));
}
