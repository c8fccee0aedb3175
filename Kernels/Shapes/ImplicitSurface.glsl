// Common code of implicit surfaces: f is positive outside, its zeros along a ray are the
// crossings. A family gives a field, which is f along one ray (RTG_FIELD, made from a Chord), with the `accuracy` that
// is wanted of the ray's parameter and the width of the windows in which it counts as convex (`convexWidth`), and these
// functions
//
//   RTG_PROBE ProbeAt(field, where, axis)             plain arithmetic's f at one point, with its slope and rounding
//   RTG_PROBE WithSign(field, unit, probe)            the same with a certain sign, from double words
//   DoubleWord NextBreak(field, after, axis)          the next point where the ray is to be cut into pieces
//   Window WindowOf(field, a, b, sign, width)          bounds of f in a part of a piece from the probes at its ends
//   ImplicitPoint PointAt(field, at)                  f in double words, with two derivatives and the gradient
//
// ImplicitSearch.glsl does the rest for each family: isolates the crossings, brackets them, refines them in double
// words.

// Evaluations of f that a ray may take. SuperquadricTest counts them: 4 to 5 on average, and hardly any ray comes near
// this number. Further pieces of such a ray are looked at with one each.
#define RTG_STEPS 1024
#define RTG_PIECES 64
#define RTG_TINY (RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF)

// A ray and the part of it in the box [-1, 1]^3 that is the glyph's: `unit` starts next to the center, the largest
// component of its direction is one to two, its parameter times `scale` is that of `ray`.
struct Chord
{
  LocalRay ray;
  LocalRay unit;
  real scale;
  real sIn; // slightly outside the box
  real sOut;
};

// False: the ray certainly has no crossing in [tMin, tMax], and `chord` means nothing.
RTG_FN bool ToChord(const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(Chord) chord)
{
  LocalRay local;
  bool near = ToBoxFrame(ray, glyph, real(0.5) * glyph.size, local);
  chord = Chord(local, local, real(1.0), real(0.0), real(0.0));
  if (!near)
  {
    return false;
  }
  real3 d = local.direction.hi;
  local = Advance(local, -dot(local.origin.hi, d) / dot(d, d));
  // By a power of two: third derivatives of tiny glyphs would overflow.
  chord.scale = ldexp(real(1.0), -int(floor(log2(max(abs(d.x), max(abs(d.y), abs(d.z)))))));
  chord.ray = local;
  chord.unit = LocalRay(
    Word(real(0.0)), local.origin, DoubleWord3(chord.scale * local.direction.hi, chord.scale * local.direction.lo));
  real3 padded = real3(real(1.0 + 32.0 * RTG_ROUNDOFF));
  if (!BoxChord(chord.unit.origin.hi, chord.unit.direction.hi, padded, chord.sIn, chord.sOut))
  {
    return false;
  }
  real margin = real(64.0 * RTG_ROUNDOFF) * (chord.sOut - chord.sIn);
  return RayParameter(local, Word(chord.scale * (chord.sIn - margin))).hi <= tMax &&
    RayParameter(local, Word(chord.scale * (chord.sOut + margin))).hi >= tMin;
}

// Zero for the axis, one for the others.
RTG_FN real3 OffPlane(const int axis)
{
  return real3(axis == 0 ? real(0.0) : real(1.0), axis == 1 ? real(0.0) : real(1.0), axis == 2 ? real(0.0) : real(1.0));
}

// The ray with its origin at a point of it; on the coordinate plane of `axis` that coordinate is zero to the last
// digit.
RTG_FN LocalRay RayFrom(const LocalRay ray, const DoubleWord where, const int axis)
{
  DoubleWord3 origin = Add(ray.origin, Multiply(ray.direction, Word3(where)));
  real3 keep = OffPlane(axis);
  return LocalRay(Add(ray.start, where), DoubleWord3(origin.hi * keep, origin.lo * keep), ray.direction);
}

RTG_FN DoubleWord PassesAt(const DoubleWord o, const DoubleWord d, const bool counts)
{
  return counts && abs(d.hi) > real(RTG_TINY) ? Divide(Minus(o), d) : Word(real(RTG_NEVER));
}

// Where a ray passes the coordinate planes of the axes with exponents below 1.
RTG_FN DoubleWord3 PlanesOf(const LocalRay ray, const real3 exponents)
{
  return Words(PassesAt(WordX(ray.origin), WordX(ray.direction), exponents.x < real(1.0)),
    PassesAt(WordY(ray.origin), WordY(ray.direction), exponents.y < real(1.0)),
    PassesAt(WordZ(ray.origin), WordZ(ray.direction), exponents.z < real(1.0)));
}

// Next to the glyph's center, or the end of the chord when that is behind: a ray that hits is likely to be inside
// there.
RTG_FN DoubleWord NextMiddle(const DoubleWord after, const real sOut)
{
  return Word(after.hi < real(0.0) && sOut > real(0.0) ? real(0.0) : sOut);
}

// The first plane behind `after` and the axis that it belongs to, or the last point and -1.
RTG_FN DoubleWord NextPlane(const DoubleWord3 planes, const DoubleWord after, const DoubleWord last, RTG_OUT(int) axis)
{
  DoubleWord next = last;
  axis = -1;
  for (int i = 0; i < 3; ++i)
  {
    DoubleWord plane = WordOf(planes, i);
    if (IsLess(after, plane) && IsLess(plane, next))
    {
      next = plane;
      axis = i;
    }
  }
  return next;
}

// A family's bounds of f on a window [a, b], at whose start f times the sign `sign` is positive.
struct Window
{
  bool empty;  // f has no zero if its signs at the ends are the same
  bool unique; // it has one zero if they differ
  bool single; // it is too short for more than one extremum
  bool convex; // sign f is convex
  real slopeA; // of straight lines through sign f at a, and at b, that stay below it
  real slopeB;
};

#define RTG_EMPTY 0
#define RTG_UNIQUE 1 // it has one crossing, which plain arithmetic finds
#define RTG_SETTLE 2 // only double words can decide
#define RTG_SPLIT 3

// Bound of the distance of f from its Taylor polynomial of degree 2: a bound of the third derivative, and the radius in
// which it holds.
struct TaylorError
{
  real third;
  real radius;
};

RTG_FN real TaylorRemainder(const TaylorError by, const real step)
{
  return abs(step) <= by.radius ? abs(step * step * step) * by.third * real(1.0 / 6.0) : real(RTG_NEVER);
}

// f at the origin of a ray in double words, and what else the last steps need in plain numbers.
struct ImplicitPoint
{
  DoubleWord value;
  real slope;  // along the ray
  real second; // derivative along the ray
  TaylorError taylor;
  real accuracy;  // to which its zero is wanted
  real3 gradient; // in absolute coordinates
};

// A crossing: the ray with its origin at the crossing, t, and where it is wanted the gradient, in absolute
// coordinates.
struct SurfaceCrossing
{
  bool found;
  bool leaves; // the glyph, rather than enters it
  real t;
  LocalRay at;
  real3 gradient;
  int steps;
};

RTG_FN SurfaceCrossing NoSurfaceCrossing(const LocalRay ray)
{
  return SurfaceCrossing(false, false, real(RTG_NEVER), ray, real3(real(0.0)), 0);
}

// The normal in the world from the gradient in absolute coordinates of the frame of the half-lengths.
RTG_FN real3 SurfaceNormal(const Glyph glyph, const real3 p, const real3 gradient)
{
  real3 g = gradient / max(gradient.x, max(gradient.y, max(gradient.z, real(RTG_TINY))));
  // On the axis of a thorn nothing points anywhere but along it.
  g = SumOf(g) > real(0.0) ? g : real3(real(0.0), real(0.0), real(1.0));
  real3 outward = real3(p.x < real(0.0) ? -g.x : g.x, p.y < real(0.0) ? -g.y : g.y, p.z < real(0.0) ? -g.z : g.z);
  return normalize(RotateToWorld(glyph, OverSize(glyph, outward)));
}

RTG_FN GlyphHit HitAt(const SurfaceCrossing crossing, const GlyphRay ray, const Glyph glyph, const bool wantsNormal)
{
  return GlyphHit(crossing.found, crossing.leaves, crossing.t,
    crossing.found && wantsNormal ? SurfaceNormal(glyph, crossing.at.origin.hi, crossing.gradient) : -ray.direction);
}
