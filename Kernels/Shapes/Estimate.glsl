// Hits and misses that plain float proves. Traversals call it first: most candidates end here,
// and of the others most need no exact t before the nearest is known.

#define RTG_MISSED 0  // no crossing in [tMin, tMax]
#define RTG_HIT 1     // the nearest crossing in [tMin, tMax] exists and lies in [low, high]
#define RTG_UNKNOWN 2 // a crossing in [tMin, tMax], if there is one, lies at low or behind it

// Inside what the glyph is known to lie: a ball of that radius and, when `boxed`, the cube [-1, 1]^3, both in the frame
// in which its half-lengths round its middle are 1, or in the world's frame when it is a plain sphere.
struct Enclosure
{
  real3 middle;
  real3 halfSize;
  real radius;
  bool boxed;
  bool fills;   // the glyph is that ball
  bool inWorld; // a plain sphere: `radius` is the world's
};

// That of a shape from -size / 2 to size / 2 along each of its axes that fills neither cube nor ball.
RTG_FN Enclosure BoxedEnclosure(const Glyph glyph)
{
  real toCorner = real(1.7320509); // of the cube
  return Enclosure(real3(real(0.0)), real(0.5) * glyph.size, toCorner, true, false, false);
}

// The same of a shape that lies in the round cylinder of its box, along any of the axes.
RTG_FN Enclosure RoundEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  outer.radius = real(1.4142137);
  return outer;
}

// The ray in that frame.
struct EnclosureRay
{
  real3 o;
  real3 d;
  real moved; // rounding may have moved its points near it by so much
};

// The rounding of the differences and of the line's nearest point is less than 12 u (|v| + radius): see MissesBall.
RTG_FN EnclosureRay ToSphere(const GlyphRay ray, const Glyph glyph, const real radius)
{
  real3 v = (ray.origin - glyph.center) + (ray.originLow - glyph.centerLow);
  real away = abs(v.x) + abs(v.y) + abs(v.z);
  return EnclosureRay(v, ray.direction, real(16.0 * RTG_ROUNDOFF) * (away + radius));
}

// Turning adds less than 25 u |v| to the origin and 25 u |d| to the direction, which at the glyph's distance is the
// same again; the shortest half-length magnifies all of it.
RTG_FN EnclosureRay ToEnclosure(const GlyphRay ray, const Glyph glyph, const Enclosure outer)
{
  real3 v = (ray.origin - glyph.center) + (ray.originLow - glyph.centerLow);
  real shortest = min(outer.halfSize.x, min(outer.halfSize.y, outer.halfSize.z));
  real away = abs(v.x) + abs(v.y) + abs(v.z) + abs(outer.middle.x);
  return EnclosureRay((RotateToLocal(glyph, v) - outer.middle) / outer.halfSize,
    RotateToLocal(glyph, ray.direction) / outer.halfSize, real(64.0 * RTG_ROUNDOFF) * (away / shortest + outer.radius));
}

RTG_FN int Estimate(const EnclosureRay ray, const Enclosure outer, const real tMin, const real tMax, RTG_OUT(real) low,
  RTG_OUT(real) high)
{
  low = tMin;
  high = tMax;
  real dd = dot(ray.d, ray.d);
  real nearest = -dot(ray.o, ray.d) / dd;
  real3 p = ray.o + nearest * ray.d;
  real depth = outer.radius * outer.radius - dot(p, p);
  // Where it matters |p| <= radius + moved, so moving p changes its square by less than 2 (radius + moved) moved +
  // moved^2; the rounding of the squares is less than 8 u radius^2, and u radius less than moved / 16.
  real errorBound = real(4.0) * (outer.radius + ray.moved) * ray.moved;
  // Too small or too large for plain numbers, or NaN.
  if (!(errorBound > real(1.0e-30) && errorBound < real(1.0e30)))
  {
    return RTG_UNKNOWN;
  }
  if (depth < -errorBound)
  {
    return RTG_MISSED;
  }
  // Half the chord is wrong by less than errorBound over itself; near the silhouette it is at most sqrt(5 errorBound),
  // and what is taken for it plus its uncertainty is more.
  bool clear = depth > real(4.0) * errorBound;
  real halfChord = sqrt(max(depth, real(4.0) * errorBound));
  real perUnit = inversesqrt(dd);
  real toSurface = perUnit * halfChord;
  real uncertain = real(2.0) * perUnit * (ray.moved + errorBound / halfChord);
  low = nearest - toSurface - uncertain;
  real behind = nearest + toSurface + uncertain;
  if (outer.boxed)
  {
    real least = real(RTG_ROUNDOFF * RTG_ROUNDOFF) / perUnit;
    real3 e = real3(abs(ray.d.x) > least ? ray.d.x : least, abs(ray.d.y) > least ? ray.d.y : least,
      abs(ray.d.z) > least ? ray.d.z : least);
    real3 inverse = real(1.0) / e;
    real3 middle = -(ray.o * inverse);
    real3 reach = (real(1.0) + ray.moved) * abs(inverse);
    real3 sNear = middle - reach;
    real3 sFar = middle + reach;
    real sIn = max(sNear.x, max(sNear.y, sNear.z));
    real sOut = min(sFar.x, min(sFar.y, sFar.z));
    real rounding = real(8.0 * RTG_ROUNDOFF) * (abs(sIn) + abs(sOut));
    low = max(low, sIn - rounding);
    behind = min(behind, sOut + rounding);
  }
  if (low > min(behind, tMax) || behind < tMin)
  {
    return RTG_MISSED;
  }
  high = nearest - toSurface + uncertain;
  if (outer.fills && clear && low >= tMin && high <= tMax)
  {
    return RTG_HIT;
  }
  low = max(low, tMin);
  high = tMax;
  return RTG_UNKNOWN;
}
