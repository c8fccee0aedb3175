// A shadow catcher: a plane below the scene, black and as opaque as the fraction of its light that is blocked from
// it. Rays that start on surfaces do not see it.

// Fraction of the ground's light that comes from lights under local shading, which has no sky.
const float groundLights = 0.5;

// How much of its light the ground lacks.
float MissingShare(const vec3 missing, const vec3 all)
{
  return clamp(Luminance(missing) / max(Luminance(all), 1e-30), 0.0, 1.0);
}

// Where a ray that has met nothing meets the ground, from above.
bool IntersectGround(const SceneRay ray, out SurfaceHit hit)
{
  hit = NoHit();
  hit.normal = hit.shadingNormal = frame.groundNormal;
  float slope = dot(ray.direction, frame.groundNormal);
  float height = dot(ray.origin.hi, frame.groundNormal) - frame.groundHeight;
  hit.t = -height / slope;
  // Below the path to `ray.origin`, too: a ray that passes by the scene's bounds has been moved anywhere.
  return slope < 0.0 && hit.t + ray.start >= max(frame.nearDepth, 0.0);
}

// The window depth of the ground in a pixel's center; what lies beyond the far plane is there.
float GroundDepth(const uvec2 position)
{
  DoubleWord3 origin;
  vec3 direction;
  CameraRay(SampleNumber(position, 0u), vec2(0.5), origin, direction);
  SurfaceHit hit;
  bool met = IntersectGround(SceneRay(origin, direction, 0.0), hit);
  return met ? min(WindowDepth(hit.t), 0.99999994) : 1.0;
}

// Where rays from there start: beyond what rounding does to the place.
DoubleWord3 LeaveGround(const SceneRay ray, const SurfaceHit hit)
{
  DoubleWord3 position = Add(ray.origin, TwoProduct(ray.direction, vec3(hit.t)));
  float lift = 1e-6 * (abs(frame.groundHeight) + abs(hit.t) * length(ray.direction));
  return Add(position, TwoProduct(hit.normal, vec3(lift)));
}
