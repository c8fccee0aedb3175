// Tracing one ray from ray generation programs. With RTG_WHOLE they are those of a scene that is one set of glyphs with
// a tree (Pipeline.h, Generation::whole): the tree is walked here, and the driver's structure, through which a CPU
// device comes to it for a fifth of the time, is left out.
#ifdef RTG_WHOLE
#include "glyph.glsl"
#include "walk.glsl"
#include "surface.glsl"
#else
#include "../Shapes/Dialect.glsl"
#include "../Shapes/DoubleWord.glsl"

layout(location = 0) rayPayloadEXT SurfaceHit payload;
#endif

// A ray ready to be traced. Floats near the scene are small numbers, and so are the errors of the traversal's box
// tests: the origin is moved to where the ray enters the scene's bounds, exactly, and t counts from there. A place on
// the ray is (ray, t): t is never added to `start` but to tell the depth, because the sum would be rounded to what the
// distance of the eye leaves of it.
struct SceneRay
{
  DoubleWord3 origin; // exact; the low part goes to the intersection programs beside the driver's ray
  vec3 direction;
  float start; // how far the origin was moved along the ray
};

// Where the ray enters the scene's bounds, or 0 when it starts inside them.
float SceneEntry(vec3 origin, vec3 direction)
{
  vec3 inverse = 1.0 / direction;
  vec3 t0 = (frame.sceneLower - origin) * inverse;
  vec3 t1 = (frame.sceneUpper - origin) * inverse;
  // An axis the ray runs along says nothing about where it enters; min and max drop its NaN or infinities.
  vec3 entry = vec3(direction.x != 0.0 ? min(t0.x, t1.x) : 0.0, direction.y != 0.0 ? min(t0.y, t1.y) : 0.0,
    direction.z != 0.0 ? min(t0.z, t1.z) : 0.0);
  return max(max(entry.x, entry.y), max(entry.z, 0.0));
}

#ifdef RTG_WHOLE
bool IsSeen(GlyphSetRecord set, uint cullMask)
{
  return (cullMask & (set.translucent != 0u ? TRANSLUCENT_MASK : OPAQUE_MASK)) != 0u;
}

Query QueryOf(GlyphSetRecord set, SceneRay ray, float tMin, float tMax, bool any, uint seed)
{
  return Query(
    GlyphRay(ray.origin.hi, ray.origin.lo, ray.direction), ray.origin.hi - set.offset, tMin, tMax, any, seed);
}
#else
// Tells the intersection programs what the driver does not.
void BeginRay(SceneRay ray, uint seed)
{
  frame.rays.at[LaunchIndex()].originLow = ray.origin.lo;
  if (translucency)
  {
    frame.rays.at[LaunchIndex()].seed = seed;
  }
}
#endif

SceneRay EnterScene(DoubleWord3 origin, vec3 direction)
{
  float start = SceneEntry(origin.hi, direction);
  // One step back in case rounding put the entry beyond the bounds.
  start = max(start - 1e-5 * start, 0.0);
  return SceneRay(start > 0.0 ? Add(origin, TwoProduct(direction, vec3(start))) : origin, direction, start);
}

// The nearest hit with tMin <= t <= tMax, or one with t < 0. A `seed` other than 0 lets the ray pass translucent glyphs
// by chance, the same ones whenever it is traced again.
SurfaceHit Intersect(SceneRay ray, float tMin, float tMax, uint cullMask, uint seed)
{
  if (!(tMin <= tMax))
  {
    return NoHit();
  }
#ifdef RTG_WHOLE
  SurfaceHit hit = NoHit();
  GlyphSetRecord set = SetRecord(0u);
  if (IsSeen(set, cullMask))
  {
    GlyphSource source = SourceOf(set);
    Query query = QueryOf(set, ray, tMin, tMax, false, seed);
    GlyphHit found = NearestGlyph(set, source, query);
    if (found.glyph != nothing)
    {
      hit = HitOnGlyph(0u, set, source, query.ray, found.glyph, found.t, seed);
    }
  }
  return hit;
#else
  BeginRay(ray, seed);
  traceRayEXT(accelerationStructureEXT(frame.topLevel), gl_RayFlagsOpaqueEXT, cullMask, 0u, 0u, 0u, ray.origin.hi, tMin,
    ray.direction, tMax, 0);
  return payload;
#endif
}

// True when anything in `cullMask` lies between the ray's origin and `tMax`: the traversal ends at the first hit and
// runs no closest-hit program.
bool Occluded(SceneRay ray, float tMax, uint cullMask)
{
#ifdef RTG_WHOLE
  GlyphSetRecord set = SetRecord(0u);
  return IsSeen(set, cullMask) &&
    NearestGlyph(set, SourceOf(set), QueryOf(set, ray, 0.0, tMax, true, 0u)).glyph != nothing;
#else
  BeginRay(ray, 0u);
  // The miss program makes it negative.
  payload.t = 0.0;
  traceRayEXT(accelerationStructureEXT(frame.topLevel),
    gl_RayFlagsOpaqueEXT | gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT, cullMask, 0u, 0u, 0u,
    ray.origin.hi, 0.0, ray.direction, tMax, 0);
  return payload.t >= 0.0;
#endif
}

// How far the hit's t may be from the exact surface: Shapes/README.md's 8 ulp, doubled, and the hit's own error.
float ErrorOfT(SceneRay ray, SurfaceHit hit)
{
  return hit.error / length(ray.direction) + 2e-6 * hit.t;
}

// Where rays from a hit that faces forward start: off the surface, so far that rounding cannot put the start behind it.
// A start clear of the surface needs no minimum t.
DoubleWord3 LeaveSurface(SceneRay ray, SurfaceHit hit)
{
  DoubleWord3 position = Add(ray.origin, TwoProduct(ray.direction, vec3(hit.t)));
  return Add(position, TwoProduct(hit.normal, vec3(ErrorOfT(ray, hit) * length(ray.direction))));
}
