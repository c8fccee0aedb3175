// What a shape is asked about, and the way from the world to the glyph's own frame without loss.
#ifndef RTG_LOCAL_RAY
#define RTG_LOCAL_RAY

#include "DoubleWord.glsl"

// The exact origin is origin + originLow, |originLow| <= ulp(origin) / 2; likewise centres.
struct GlyphRay
{
  real3 origin;
  real3 originLow;
  real3 direction; // of any length but zero; ray parameters count in its lengths
};

struct Glyph
{
  real3 centre;
  real3 centreLow;
  real3 size;      // full extents along the unit form's axes, > 0
  real4 rotation;  // unit quaternion (x, y, z, w), unit form to world; used only when turned
  bool turned;
  bool sameSize;   // size.x == size.y == size.z is known
  real4 arrow;     // shaft radius, tip radius, tip length, tip rounding
  bool fixedHeads;
  real unitLength;
};

// A ray in a glyph's frame, not yet divided by the glyph's size. Its parameter s counts from the
// world ray's parameter `start`.
struct LocalRay
{
  DoubleWord start;
  DoubleWord3 origin;
  DoubleWord3 direction;
};

RTG_FN DoubleWord RayParameter(LocalRay ray, DoubleWord s)
{
  return Add(ray.start, s);
}

// Move the origin along the ray by s, which thereby needs not be accurate.
RTG_FN LocalRay Advance(LocalRay ray, real s)
{
  LocalRay moved;
  moved.start = Add(ray.start, s);
  moved.origin = Add(ray.origin, Multiply(ray.direction, real3(s)));
  moved.direction = ray.direction;
  return moved;
}

// u x (a, lower and upper word).
RTG_FN DoubleWord3 CrossProduct(real3 u, DoubleWord3 a)
{
  DoubleWord3 yzx;
  yzx.hi = real3(a.hi.y, a.hi.z, a.hi.x);
  yzx.lo = real3(a.lo.y, a.lo.z, a.lo.x);
  DoubleWord3 zxy;
  zxy.hi = real3(a.hi.z, a.hi.x, a.hi.y);
  zxy.lo = real3(a.lo.z, a.lo.x, a.lo.y);
  DoubleWord3 left = Multiply(zxy, real3(u.y, u.z, u.x));
  DoubleWord3 right = Multiply(yzx, real3(u.z, u.x, u.y));
  return AddSloppy(left, Minus(right));
}

// |q|^2, which is one only up to the rounding of q.
RTG_FN DoubleWord SquaredNorm(real4 q)
{
  DoubleWord xy = AddSloppy(TwoProduct(q.x, q.x), TwoProduct(q.y, q.y));
  DoubleWord zw = AddSloppy(TwoProduct(q.z, q.z), TwoProduct(q.w, q.w));
  return AddSloppy(xy, zw);
}

// The inverse rotation of the normalised quaternion, a + 2 (u x (u x a) - w (u x a)) / |q|^2, in
// double words: a needle of 1 : 1e-6 notices an angle of 1e-13.
RTG_FN DoubleWord3 RotateToLocal(real4 q, DoubleWord twoOverNorm, DoubleWord3 a)
{
  real3 u = real3(q.x, q.y, q.z);
  DoubleWord3 c = CrossProduct(u, a);
  DoubleWord3 e = AddSloppy(CrossProduct(u, c), Multiply(c, real3(-q.w)));
  DoubleWord3 factor;
  factor.hi = real3(twoOverNorm.hi);
  factor.lo = real3(twoOverNorm.lo);
  return AddSloppy(a, Multiply(e, factor));
}

// The rotation of the same quaternion in plain arithmetic, for normals and bounds.
RTG_FN real3 RotateToWorld(Glyph glyph, real3 a)
{
  if (!glyph.turned)
  {
    return a;
  }
  real4 q = glyph.rotation;
  real3 u = real3(q.x, q.y, q.z);
  real3 c = cross(u, a) + q.w * a;
  return a + (real(2.0) / dot(q, q)) * cross(u, c - q.w * a) + (real(2.0) * q.w / dot(q, q)) * cross(u, a);
}

// Subtract the centre exactly, go along the ray to where it passes the centre, still in the world frame:
// from here on errors are relative to the distance between ray and centre.
RTG_FN LocalRay NearRay(GlyphRay ray, Glyph glyph)
{
  DoubleWord3 origin;
  origin.hi = ray.origin;
  origin.lo = ray.originLow;
  DoubleWord3 centre;
  centre.hi = glyph.centre;
  centre.lo = glyph.centreLow;

  LocalRay offset;
  offset.start = Word(real(0.0));
  offset.origin = Subtract(origin, centre);
  offset.direction = Word3(ray.direction);
  real t0 = -dot(offset.origin.hi, ray.direction) / dot(ray.direction, ray.direction);

  LocalRay near;
  near.start = Word(t0);
  near.origin = Add(offset.origin, TwoProduct(real3(t0), ray.direction));
  near.direction = offset.direction;
  return near;
}

RTG_FN LocalRay TurnToLocal(LocalRay ray, Glyph glyph)
{
  if (!glyph.turned)
  {
    return ray;
  }
  DoubleWord twoOverNorm = Divide(Word(real(2.0)), SquaredNorm(glyph.rotation));
  LocalRay local;
  local.start = ray.start;
  local.origin = RotateToLocal(glyph.rotation, twoOverNorm, ray.origin);
  local.direction = RotateToLocal(glyph.rotation, twoOverNorm, ray.direction);
  return local;
}

#endif
