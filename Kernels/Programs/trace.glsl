// Tracing one ray from ray generation programs.
layout(location = 0) rayPayloadEXT SurfaceHit hit;

// a * b = product + low, exactly (Dekker 1971, Veltkamp's split with 2^12 + 1).
void TwoProduct(vec3 a, float b, out vec3 product, out vec3 low)
{
  precise vec3 p = a * b;
  precise vec3 ca = a * 4097.0;
  precise float cb = b * 4097.0;
  precise vec3 ah = ca - (ca - a);
  precise float bh = cb - (cb - b);
  precise vec3 al = a - ah;
  precise float bl = b - bh;
  precise vec3 e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
  product = p;
  low = e;
}

// a + b = sum + low, exactly (Knuth's two-sum).
void TwoSum(vec3 a, vec3 b, out vec3 sum, out vec3 low)
{
  precise vec3 s = a + b;
  precise vec3 bb = s - a;
  precise vec3 e = (a - (s - bb)) + (b - bb);
  sum = s;
  low = e;
}

// Where the ray enters the scene's bounds, or 0 when it starts inside them.
float SceneEntry(vec3 origin, vec3 direction)
{
  vec3 inverse = 1.0 / direction;
  vec3 t0 = (push.frame.value.sceneLower - origin) * inverse;
  vec3 t1 = (push.frame.value.sceneUpper - origin) * inverse;
  // An axis the ray runs along says nothing about where it enters; min and max drop its NaN or infinities.
  vec3 entry = vec3(direction.x != 0.0 ? min(t0.x, t1.x) : 0.0, direction.y != 0.0 ? min(t0.y, t1.y) : 0.0,
    direction.z != 0.0 ? min(t0.z, t1.z) : 0.0);
  return max(max(entry.x, entry.y), max(entry.z, 0.0));
}

// Traces the ray whose exact origin is origin + originLow. The traversal's box tests are in float, so
// their error grows with the origin's distance: the origin is first moved to the scene's bounds, and the part
// of it that a float cannot hold goes to the intersection programs beside the ray. The result in `hit`
// counts t from the given origin.
void TraceNearest(vec3 origin, vec3 originLow, vec3 direction, float tMin, float tMax, uint cullMask)
{
  float start = SceneEntry(origin, direction);
  // One step back in case rounding put the entry beyond the bounds.
  start = max(start - 1e-5 * start, 0.0);
  vec3 moved = origin;
  vec3 movedLow = originLow;
  if (start > 0.0)
  {
    vec3 step, stepLow, sumLow;
    TwoProduct(direction, start, step, stepLow);
    TwoSum(origin, step, moved, sumLow);
    TwoSum(moved, sumLow + (stepLow + originLow), moved, movedLow);
  }
  uint launch = gl_LaunchIDEXT.y * push.frame.value.launchWidth + gl_LaunchIDEXT.x;
  push.frame.value.originLow.at[launch] = movedLow;

  hit.t = -1.0;
  if (tMax > start)
  {
    traceRayEXT(accelerationStructureEXT(push.topLevel), gl_RayFlagsOpaqueEXT, cullMask, 0u, 0u, 0u, moved,
      max(tMin - start, 0.0), direction, tMax - start, 0);
  }
  if (hit.t >= 0.0)
  {
    hit.t += start;
  }
}
