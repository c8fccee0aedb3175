// Tracing one ray. Candidates come from the plugin's BVH (walk.glsl) or, by ray queries, from the driver's
// (query.glsl); the code after that is common.
#include "glyph.glsl"
#include "candidates.glsl"
#include "query.glsl"
#include "walk.glsl"
#include "surface.glsl"

// A ray ready to be traced. Floats near the scene are small numbers, and so are the errors of the traversal's box
// tests: the origin is moved to where the ray enters the scene's bounds, exactly, and t counts from there. A place on
// the ray is (ray, t): t is never added to `start` but for the depth, because the sum would be rounded to what the
// distance of the eye leaves of it.
struct SceneRay
{
  DoubleWord3 origin; // exact; drivers see the high part
  vec3 direction;
  float start; // how far the origin was moved along the ray
};

// A ray's query of the scene.
struct Query
{
  SceneRay ray;
  float tMin;
  float tMax;
  uint mask; // of the sets that it may hit
  uint seed; // of the random choice which translucent surfaces it passes, the same at each call; 0: it passes
             // none
  bool any;  // any hit will do
};

// The ray from where it enters the scene's bounds, or from its origin when that lies inside them.
SceneRay EnterScene(const DoubleWord3 origin, const vec3 direction)
{
  vec3 inverse = 1.0 / direction;
  vec3 t0 = (frame.sceneLower - origin.hi) * inverse;
  vec3 t1 = (frame.sceneUpper - origin.hi) * inverse;
  // An axis the ray runs along says nothing about where it enters; min and max drop its NaN or infinities.
  vec3 entry = vec3(direction.x != 0.0 ? min(t0.x, t1.x) : 0.0, direction.y != 0.0 ? min(t0.y, t1.y) : 0.0,
    direction.z != 0.0 ? min(t0.z, t1.z) : 0.0);
  float start = max(max(entry.x, entry.y), max(entry.z, 0.0));
  // One step back in case rounding put the entry beyond the bounds.
  start = max(start - 1e-5 * start, 0.0);
  return SceneRay(start > 0.0 ? Add(origin, TwoProduct(direction, vec3(start))) : origin, direction, start);
}

// How far the hit's t may be from the exact surface: Shapes/README.md's 8 ulp, doubled, and the hit's own error.
float ErrorOfT(const SceneRay ray, const SurfaceHit hit)
{
  return hit.error / length(ray.direction) + 2e-6 * hit.t;
}

// Where rays from a hit that faces forward start: off the surface, so far that rounding cannot put the start behind it.
// A start clear of the surface needs no minimum t.
DoubleWord3 LeaveSurface(const SceneRay ray, const SurfaceHit hit)
{
  DoubleWord3 position = Add(ray.origin, TwoProduct(ray.direction, vec3(hit.t)));
  return Add(position, TwoProduct(hit.normal, vec3(ErrorOfT(ray, hit) * length(ray.direction))));
}

// The nearest hit with tMin <= t <= tMax, or one with t < 0; of a query of any, only the sign of t means something.
// With `gathers` it is the next layer; one traversal gathers as many layers as the list holds. Where there are none, it
// is the nearest opaque surface.
SurfaceHit Trace(const Query query, const bool gathers)
{
  GlyphRay ray = GlyphRay(query.ray.origin.hi, query.ray.origin.lo, query.ray.direction);
  GlyphCrossing found = GlyphCrossing(0u, nothing, nothing, query.tMax, vec3(0.0));
  // A list of layers that was not full was the last.
  bool walks = !(layered && gathers) || (layerNext == layerCount && layerCount == layerLimit);
  if (walks && query.tMin <= query.tMax)
  {
    if (layered && gathers)
    {
      layerLimit = frame.layerLimit;
      layerCount = layerNext = 0u;
      layersStopLight = false;
    }
    found = rayQueries ? QueryStructure(ray, query.tMin, query.tMax, query.mask, query.seed, query.any, gathers)
                       : WalkSets(ray, query.tMin, query.tMax, query.mask, query.seed, query.any, gathers);
  }
  if (layered && gathers)
  {
    found.glyph = layerCount > 0u ? nothing : found.glyph; // else an opaque one
    if (layerNext < layerCount)
    {
      found = LayerAt(layerNext++);
    }
  }
  SurfaceHit hit = NoHit();
  if (found.glyph != nothing)
  {
    hit.t = found.t;
    if (!query.any)
    {
      GlyphSource source = SourceOf(SetRecord(found.record));
      vec3 normal = layered && gathers ? NormalOnGlyph(source, ray, found.glyph, found.t) : found.normal;
      hit = HitOnGlyph(found.record, source, ray, found.glyph, found.t, normal, found.triangle, query.seed);
    }
  }
  return hit;
}

// Whether something stops light that arrives along `direction` (unit) from at most `distance` away. From the ground the
// scene may be farther than the driver's boxes are padded for.
Query ShadowQuery(const DoubleWord3 origin, const vec3 direction, const float distance, const uint seed)
{
  SceneRay ray = rayQueries ? EnterScene(origin, direction) : SceneRay(origin, direction, 0.0);
  return Query(ray, 0.0, distance - ray.start, ANY_MASK, translucency ? seed : 0u, true);
}
