// Light between two places, and rays that translucent surfaces may let through: a surface of opacity a stops
// a ray with probability a, so that the mean over samples is the light that passes.

// More surfaces than this on one ray count as a wall.
const uint maximumCrossings = 256u;

// Nearest surface that stops the ray, in `hit`; `event` numbers the ray within its sample.
void TraceStopping(
  DoubleWord3 origin, vec3 direction, float tMin, float tMax, uint cullMask, SampleNumber number, uint event)
{
  TraceNearest(origin, direction, tMin, tMax, cullMask);
  if (!translucency)
  {
    return;
  }
  for (uint crossing = 0u; crossing < maximumCrossings; ++crossing)
  {
    if (hit.t < 0.0 || hit.colour.a >= 1.0 ||
      SampleIndependent(number, event * maximumCrossings + crossing) < hit.colour.a)
    {
      return;
    }
    float behind = hit.t + HitUncertainty(direction);
    TraceNearest(origin, direction, behind, tMax, cullMask);
  }
}

// True when something stops light that arrives along `direction` (unit) from at most `distance` away.
bool Blocked(DoubleWord3 origin, vec3 direction, float distance, SampleNumber number, uint event)
{
  if (MeetsAny(origin, direction, distance, OPAQUE_MASK))
  {
    return true;
  }
  if (!translucency)
  {
    return false;
  }
  TraceStopping(origin, direction, 0.0, distance, TRANSLUCENT_MASK, number, event);
  return hit.t >= 0.0;
}
