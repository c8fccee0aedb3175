// Directions about a normal.
#ifndef RTG_FRAME
#define RTG_FRAME

// Two unit vectors that make a right-handed frame with the unit vector n. Duff et al., "Building an Orthonormal
// Basis, Revisited", JCGT 6(1), 2017.
void Tangents(vec3 n, out vec3 x, out vec3 y)
{
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
  y = vec3(b, s + n.y * n.y * a, -n.y);
}

// Malley's method: uniform on the disc, lifted to the hemisphere; density cos / pi.
vec3 CosineDirection(vec3 normal, vec2 u)
{
  vec3 x, y;
  Tangents(normal, x, y);
  float radius = sqrt(u.x);
  float angle = 6.28318530717958648 * u.y;
  return normalize(radius * (cos(angle) * x + sin(angle) * y) + sqrt(1.0 - u.x) * normal);
}

#endif
