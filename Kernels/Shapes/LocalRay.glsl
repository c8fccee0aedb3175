// A ray and a glyph, and the transform from the world to the glyph's own frame without loss.

RTG_FN real SumOf(const real3 v)
{
  return v.x + v.y + v.z;
}

RTG_FN real LeastOf(const real3 v)
{
  return min(v.x, min(v.y, v.z));
}

RTG_FN real MostOf(const real3 v)
{
  return max(v.x, max(v.y, v.z));
}

// The exact origin is origin + originLow, |originLow| <= ulp(origin) / 2; likewise centers.
struct GlyphRay
{
  real3 origin;
  real3 originLow;
  real3 direction; // of any length but zero; ray parameters count in its lengths
};

struct Glyph
{
  real3 center;
  real3 centerLow;
  real3 size;     // full extents along the unit glyph's axes, > 0
  real4 rotation; // unit quaternion (x, y, z, w), unit glyph to world; only if `rotated`
  bool rotated;
  bool sameSize; // size.x == size.y == size.z is known
  bool joined;   // `values` are those of the next pieces of a line
  real4 arrow;   // shaft radius, tip radius, tip length, tip rounding
  bool fixedHeads;
  real unitLength;
  real3 exponents; // of a superquadric's axes
  real4 before;    // of a round cone: RoundCone.glsl
  real4 after;
  RTG_VALUES values; // of polynomials: PolynomialForm.glsl; of joined pieces
  int firstValue;
  int degree; // of this glyph's polynomial
};

// Where a ray crosses a glyph's surface.
struct GlyphHit
{
  bool found;
  bool leaves; // the glyph, rather than enters it
  real t;
  real3 normal; // outward, unit, in the world, where it is wanted
};

// A glyph's box relative to its center.
struct Bounds
{
  real3 lower;
  real3 upper;
};

RTG_FN Bounds SymmetricBounds(const real3 reach)
{
  return Bounds(-reach, reach);
}

// A ray in a glyph's frame, not yet divided by the glyph's size. Its parameter s counts from the
// world ray's parameter `start`.
struct LocalRay
{
  DoubleWord start;
  DoubleWord3 origin;
  DoubleWord3 direction;
};

RTG_FN DoubleWord RayParameter(const LocalRay ray, const DoubleWord s)
{
  return Add(ray.start, s);
}

// Move the origin along the ray by s, which thereby needs not be accurate.
RTG_FN LocalRay Advance(const LocalRay ray, const real s)
{
  return LocalRay(Add(ray.start, s), Add(ray.origin, Multiply(ray.direction, real3(s))), ray.direction);
}

// The ray in a frame in which lengths are divided by these.
RTG_FN LocalRay Divide(const LocalRay ray, const real3 by)
{
  return LocalRay(ray.start, Divide(ray.origin, by), Divide(ray.direction, by));
}

// u x (a, lower and upper word).
RTG_FN DoubleWord3 CrossProduct(const real3 u, const DoubleWord3 a)
{
  DoubleWord3 yzx = DoubleWord3(real3(a.hi.y, a.hi.z, a.hi.x), real3(a.lo.y, a.lo.z, a.lo.x));
  DoubleWord3 zxy = DoubleWord3(real3(a.hi.z, a.hi.x, a.hi.y), real3(a.lo.z, a.lo.x, a.lo.y));
  DoubleWord3 left = Multiply(zxy, real3(u.y, u.z, u.x));
  DoubleWord3 right = Multiply(yzx, real3(u.z, u.x, u.y));
  return AddSloppy(left, Minus(right));
}

// |q|^2, which is one only up to the rounding of q.
RTG_FN DoubleWord SquaredNorm(const real4 q)
{
  DoubleWord xy = AddSloppy(TwoProduct(q.x, q.x), TwoProduct(q.y, q.y));
  DoubleWord zw = AddSloppy(TwoProduct(q.z, q.z), TwoProduct(q.w, q.w));
  return AddSloppy(xy, zw);
}

// The inverse rotation of the normalized quaternion, a + 2 (u x (u x a) - w (u x a)) / |q|^2, in
// double words: a needle of 1 : 1e-6 notices an angle of 1e-13.
RTG_FN DoubleWord3 RotateToLocal(const real4 q, const DoubleWord twoOverNorm, const DoubleWord3 a)
{
  real3 u = real3(q.x, q.y, q.z);
  DoubleWord3 c = CrossProduct(u, a);
  DoubleWord3 e = AddSloppy(CrossProduct(u, c), Multiply(c, real3(-q.w)));
  return AddSloppy(a, Multiply(e, Word3(twoOverNorm)));
}

// The rotation of the same quaternion in plain arithmetic, for normals, bounds and early rejection.
RTG_FN real3 Rotate(const real3 u, const real w, const real3 a)
{
  real3 c = cross(u, a);
  return a + (real(2.0) / (dot(u, u) + w * w)) * (cross(u, c) + w * c);
}

RTG_FN real3 RotateToWorld(const Glyph glyph, const real3 a)
{
  return glyph.rotated ? Rotate(real3(glyph.rotation.x, glyph.rotation.y, glyph.rotation.z), glyph.rotation.w, a) : a;
}

// A gradient in the frame where the sizes are 1 as one in the glyph's frame, times the smallest size against overflow.
RTG_FN real3 OverSize(const Glyph glyph, const real3 gradient)
{
  return gradient * (real3(LeastOf(glyph.size)) / glyph.size);
}

// The unit glyph's axes in the world, with these lengths.
struct Axes
{
  real3 x;
  real3 y;
  real3 z;
};

RTG_FN Axes WorldAxes(const Glyph glyph, const real3 lengths)
{
  return Axes(RotateToWorld(glyph, real3(lengths.x, real(0.0), real(0.0))),
    RotateToWorld(glyph, real3(real(0.0), lengths.y, real(0.0))),
    RotateToWorld(glyph, real3(real(0.0), real(0.0), lengths.z)));
}

// Half the extents of a box of these half-lengths.
RTG_FN real3 BoxReach(const Glyph glyph, const real3 halfSize)
{
  Axes axes = WorldAxes(glyph, halfSize);
  return abs(axes.x) + abs(axes.y) + abs(axes.z);
}

RTG_FN real3 RotateToLocal(const Glyph glyph, const real3 a)
{
  return glyph.rotated ? Rotate(-real3(glyph.rotation.x, glyph.rotation.y, glyph.rotation.z), glyph.rotation.w, a) : a;
}

// True only if the line passes the ball around center + middle: most candidates of a ray end here, in
// plain arithmetic. The rounding of v, of s d and of their sum moves p by less than 12 u (|v| + radius).
RTG_FN bool MissesBall(const GlyphRay ray, const Glyph glyph, const real3 middle, const real radius)
{
  real3 d = ray.direction;
  real3 v = (ray.origin - glyph.center) + (ray.originLow - glyph.centerLow) - middle;
  real3 p = v - (dot(v, d) / dot(d, d)) * d;
  real distance = abs(v.x) + abs(v.y) + abs(v.z);
  real reach = radius + real(16.0 * RTG_ROUNDOFF) * (distance + radius);
  return dot(p, p) > reach * reach;
}

// Subtract the center exactly and go along the ray to where it passes the center, still in the world's
// frame: from here on errors are relative to the distance between ray and center.
RTG_FN LocalRay NearRay(const GlyphRay ray, const Glyph glyph)
{
  DoubleWord3 offset = Subtract(DoubleWord3(ray.origin, ray.originLow), DoubleWord3(glyph.center, glyph.centerLow));
  real t0 = -dot(offset.hi, ray.direction) / dot(ray.direction, ray.direction);

  return LocalRay(Word(t0), Add(offset, TwoProduct(real3(t0), ray.direction)), Word3(ray.direction));
}

RTG_FN LocalRay RotateToLocal(const LocalRay ray, const Glyph glyph)
{
  if (!glyph.rotated)
  {
    return ray;
  }
  DoubleWord twoOverNorm = Divide(Word(real(2.0)), SquaredNorm(glyph.rotation));
  return LocalRay(ray.start, RotateToLocal(glyph.rotation, twoOverNorm, ray.origin),
    RotateToLocal(glyph.rotation, twoOverNorm, ray.direction));
}

// Where a ray passes the box -halfSize .. halfSize, in plain arithmetic. False: it misses that.
RTG_FN bool BoxChord(const real3 o, const real3 d, const real3 halfSize, RTG_OUT(real) sIn, RTG_OUT(real) sOut)
{
  real least = real(RTG_ROUNDOFF * RTG_ROUNDOFF) * (abs(d.x) + abs(d.y) + abs(d.z));
  real3 e = real3(abs(d.x) > least ? d.x : least, abs(d.y) > least ? d.y : least, abs(d.z) > least ? d.z : least);
  real3 a = (-halfSize - o) / e;
  real3 b = (halfSize - o) / e;
  real3 sNear = min(a, b);
  real3 sFar = max(a, b);
  sIn = max(sNear.x, max(sNear.y, sNear.z));
  sOut = min(sFar.x, min(sFar.y, sFar.z));
  return sIn <= sOut;
}

// The ray in the glyph's frame, its origin moved to the middle of its chord through the glyph's box, from middle -
// halfSize to middle + halfSize. False: the ray certainly misses that box, which is padded by more than its rounding,
// and `local` means nothing.
RTG_FN bool
ToLocal(const GlyphRay ray, const Glyph glyph, const real3 middle, const real3 halfSize, RTG_OUT(LocalRay) local)
{
  real radius = length(halfSize);
  local = LocalRay(Word(real(0.0)), Word3(real3(real(0.0))), Word3(ray.direction));
  if (MissesBall(ray, glyph, RotateToWorld(glyph, middle), radius))
  {
    return false;
  }
  LocalRay near = NearRay(ray, glyph);
  real3 o = RotateToLocal(glyph, near.origin.hi) - middle;
  real3 d = RotateToLocal(glyph, near.direction.hi);
  real padding = real(64.0 * RTG_ROUNDOFF) * (radius + abs(middle.x));
  real sIn, sOut;
  if (!BoxChord(o, d, halfSize + real3(padding), sIn, sOut))
  {
    return false;
  }
  local = Advance(RotateToLocal(near, glyph), real(0.5) * (sIn + sOut));
  return true;
}
