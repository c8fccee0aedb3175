// Tracing one ray from ray generation programs. There are two ways from a ray to what it meets: with RTG_OWN_TREES the
// program walks the trees of all sets itself (walk.glsl); else the driver traverses its own structure and calls the
// programs of the sets' hit groups.
#ifdef RTG_OWN_TREES
#define RTG_MESHES
#include "glyph.glsl"
#include "walk.glsl"
#include "surface.glsl"
#else
#include "../Shapes/Dialect.glsl"
#include "../Shapes/DoubleWord.glsl"
#include "../Shading/Sobol.glsl"

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

// Says when in the shutter's opening the rays that follow run.
void SetShutterTime(const float time)
{
  if (moves)
  {
#ifdef RTG_OWN_TREES
    shutterTime = time;
#else
    frame.rays.at[LaunchIndex()].time = time;
#endif
  }
}

// What a ray asks the scene.
struct Query
{
  SceneRay ray;
  float tMin;
  float tMax;
  uint mask; // of the sets that are asked
  uint seed; // of the chance by which it passes translucent surfaces, the same ones whenever it is asked; 0: it passes
             // none
  bool any;  // whether it meets anything, whatever that is
};

// Where the ray enters the scene's bounds, or 0 when it starts inside them.
float SceneEntry(const vec3 origin, const vec3 direction)
{
  vec3 inverse = 1.0 / direction;
  vec3 t0 = (frame.sceneLower - origin) * inverse;
  vec3 t1 = (frame.sceneUpper - origin) * inverse;
  // An axis the ray runs along says nothing about where it enters; min and max drop its NaN or infinities.
  vec3 entry = vec3(direction.x != 0.0 ? min(t0.x, t1.x) : 0.0, direction.y != 0.0 ? min(t0.y, t1.y) : 0.0,
    direction.z != 0.0 ? min(t0.z, t1.z) : 0.0);
  return max(max(entry.x, entry.y), max(entry.z, 0.0));
}

SceneRay EnterScene(const DoubleWord3 origin, const vec3 direction)
{
  float start = SceneEntry(origin.hi, direction);
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

#ifdef RTG_OWN_TREES
// The nearest hit with tMin <= t <= tMax, or one with t < 0; of a query of any, only the sign of t means something.
// With `gathers` the next of the layers, which are gathered in one traversal, as many as the list holds.
SurfaceHit Trace(const Query query, const bool gathers)
{
  GlyphRay ray = GlyphRay(query.ray.origin.hi, query.ray.origin.lo, query.ray.direction);
  GlyphCrossing found = GlyphCrossing(0u, nothing, nothing, query.tMax, vec3(0.0));
  // A list of layers that was not full was the last.
  bool walks = !gathers || (layerNext == layerCount && layerCount == layerLimit);
  if (walks && query.tMin <= query.tMax)
  {
    if (gathers)
    {
      layerLimit = frame.layerLimit;
      layerCount = layerNext = 0u;
    }
    found = WalkSets(ray, query.tMin, query.tMax, query.mask, query.seed, query.any, gathers);
  }
  if (gathers)
  {
    found.glyph = nothing;
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
      vec3 normal = found.normal;
      if (gathers)
      {
        normal = NormalOnGlyph(source, ray, found.glyph, found.t);
      }
      hit = HitOnGlyph(found.record, source, ray, found.glyph, found.t, normal, found.triangle, query.seed);
    }
  }
  return hit;
}
#else
// Lets the driver trace the ray; `flags`: besides that everything is opaque to it.
void TraceDriver(const Query query, const uint flags, const uint mask)
{
  frame.rays.at[LaunchIndex()].originLow = query.ray.origin.lo;
  if (translucency)
  {
    frame.rays.at[LaunchIndex()].seed = query.seed;
  }
  uint slice = moves ? uint(frame.rays.at[LaunchIndex()].time * float(frame.topLevelCount)) : 0u;
  // The miss program makes it negative.
  payload.t = 0.0;
  traceRayEXT(accelerationStructureEXT(frame.topLevels.at[slice]), gl_RayFlagsOpaqueEXT | flags, mask, 0u, 0u, 0u,
    query.ray.origin.hi, query.tMin, query.ray.direction, query.tMax, 0);
}

SurfaceHit Trace(Query query, const bool gathers)
{
  // Whether a ray of any still asks what is opaque, of which the first hit ends the traversal.
  bool any = query.any;
  uint pass = 0u;
  payload = NoHit();
  bool further = true;
  // The traversal is in the program once: some drivers copy it to every call. The loop has one exit: lavapipe with LLVM
  // 21 loses hits of one that returns.
  while (further && query.tMin <= query.tMax)
  {
    TraceDriver(query, any ? gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT : 0u,
      any ? query.mask & ANY_OPAQUE_MASK : query.mask);
    further = false;
    if (translucency && any)
    {
      any = false;
      query.mask &= ANY_TRANSLUCENT_MASK;
      further = payload.t < 0.0;
    }
    else if (translucency && query.seed != 0u && payload.t >= 0.0 && payload.colour.a < 1.0 && pass < maximumPasses)
    {
      // Among glyphs the traversal has decided; the opacity of one of the driver's triangles is known only now.
      ++pass;
      query.seed = Hash(query.seed) | 1u;
      further = UnitInterval(Hash(query.seed)) >= payload.colour.a;
      query.tMin = payload.t + ErrorOfT(query.ray, payload);
      payload.t = further ? -1.0 : payload.t; // nothing more may be hit
    }
  }
  return payload;
}
#endif

// Whether something stops light that arrives along `direction` (unit) from at most `distance` away.
Query ShadowQuery(const DoubleWord3 origin, const vec3 direction, const float distance, const uint seed)
{
  return Query(SceneRay(origin, direction, 0.0), 0.0, distance, ANY_MASK, translucency ? seed : 0u, true);
}
