// Directions about a normal.
#ifndef RTG_FRAME
#define RTG_FRAME

#ifndef RTG_SHADING_HOST
#include "Dialect.glsl"
#endif

// Two unit vectors that make a right-handed frame with the unit vector n. Duff et al., "Building an Orthonormal
// Basis, Revisited", JCGT 6(1), 2017.
RTG_SHADING_FN void Tangents(vec3 n, RTG_SHADING_OUT(vec3) x, RTG_SHADING_OUT(vec3) y)
{
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  y = vec3(b, s + n.y * n.y * a, -n.y);
}

// A direction that is given in a frame of unit vectors, among which z is the normal.
RTG_SHADING_FN vec3 FromFrame(vec3 to, vec3 x, vec3 y, vec3 z)
{
  return normalize(to.x * x + to.y * y + to.z * z);
}

// The unit vector, z > 0, that uniform numbers in [0,1)^2 choose with density z / pi: a point of the disc, lifted to
// the hemisphere (Malley's method). Squares about the middle become circles, so that cells of the square stay compact:
// Shirley and Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools 2(3), 1997.
RTG_SHADING_FN vec3 CosineDirection(vec2 u)
{
  const float eighth = 0.78539816339744831f; // of a turn
  float a = 2.0f * u.x - 1.0f;
  float b = 2.0f * u.y - 1.0f;
  bool beside = abs(a) > abs(b);
  float radius = beside ? a : b;
  float angle = beside ? eighth * (b / a) : b == 0.0f ? 0.0f : 2.0f * eighth - eighth * (a / b);
  return vec3(radius * cos(angle), radius * sin(angle), max(sqrt(max(1.0f - radius * radius, 0.0f)), 1e-6f));
}

#endif
