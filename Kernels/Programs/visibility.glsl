// Light between two places, and rays that translucent surfaces may let through: a surface of opacity a stops
// a ray with probability a, so that the mean over samples is the light that passes.

// More triangles than this on one ray count as a wall.
const uint maximumPasses = 256u;

// Nearest surface that stops the ray; `event` numbers the ray within its sample.
SurfaceHit IntersectStopping(SceneRay ray, float tMin, float tMax, uint cullMask, SampleNumber number, uint event)
{
  uint seed = translucency ? SeedOf(number, event) : 0u;
  SurfaceHit hit = Intersect(ray, tMin, tMax, cullMask, seed);
#ifndef RTG_WHOLE
  // Among glyphs the traversal has decided; a triangle's opacity is known only now.
  for (uint pass = 0u; translucency && pass < maximumPasses && hit.t >= 0.0 && hit.colour.a < 1.0; ++pass)
  {
    seed = Hash(seed) | 1u;
    if (UnitInterval(Hash(seed)) < hit.colour.a)
    {
      break;
    }
    hit = Intersect(ray, hit.t + ErrorOfT(ray, hit), tMax, cullMask, seed);
  }
#endif
  return hit;
}

// True when something stops light that arrives along `direction` (unit) from at most `distance` away.
bool Blocked(DoubleWord3 origin, vec3 direction, float distance, SampleNumber number, uint event)
{
  if (Occluded(SceneRay(origin, direction, 0.0), distance, OPAQUE_MASK))
  {
    return true;
  }
  if (!translucency)
  {
    return false;
  }
  SceneRay ray = EnterScene(origin, direction);
  return IntersectStopping(ray, 0.0, distance - ray.start, TRANSLUCENT_MASK, number, event).t >= 0.0;
}
