// Directions about a normal.

// Two unit vectors that make a right-handed frame with the unit vector n. Duff et al., "Building an Orthonormal
// Basis, Revisited", JCGT 6(1), 2017.
RTG_FN void Tangents(vec3 n, RTG_OUT(vec3) x, RTG_OUT(vec3) y)
{
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  y = vec3(b, s + n.y * n.y * a, -n.y);
}

// A direction that is given in a frame of unit vectors, among which z is the normal.
RTG_FN vec3 FromFrame(vec3 to, vec3 x, vec3 y, vec3 z)
{
  return normalize(to.x * x + to.y * y + to.z * z);
}

// Radius and angle of the point of the unit disc that uniform numbers in [0,1)^2 choose evenly. Squares about the
// middle become circles, so that cells of the square stay compact: Shirley and Chiu, "A Low Distortion Map Between Disk
// and Square", Journal of Graphics Tools 2(3), 1997.
RTG_FN vec2 DiscPoint(vec2 u)
{
  const float eighth = 0.78539816339744831f; // of a turn
  float a = 2.0f * u.x - 1.0f;
  float b = 2.0f * u.y - 1.0f;
  bool beside = abs(a) > abs(b);
  return vec2(beside ? a : b, beside ? eighth * (b / a) : b == 0.0f ? 0.0f : 2.0f * eighth - eighth * (a / b));
}

// The unit vector, z > 0, that uniform numbers in [0,1)^2 choose with density z / pi: a point of the disc, lifted to
// the hemisphere (Malley's method).
RTG_FN vec3 CosineDirection(vec2 u)
{
  vec2 at = DiscPoint(u);
  return vec3(at.x * cos(at.y), at.x * sin(at.y), max(sqrt(max(1.0f - at.x * at.x, 0.0f)), 1e-6f));
}

// The unit vector that they choose evenly about the unit vector `axis`, at cosines to it from 1 - spread to 1.
RTG_FN vec3 ConeDirection(vec2 u, vec3 axis, float spread)
{
  vec2 at = DiscPoint(u);
  float height = spread * at.x * at.x; // 1 - cosine
  float sine = at.x * sqrt(spread * (2.0f - height));
  vec3 x, y;
  Tangents(axis, x, y);
  return FromFrame(vec3(sine * cos(at.y), sine * sin(at.y), 1.0f - height), x, y, axis);
}
