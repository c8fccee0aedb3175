// Tracing one ray from ray generation programs. With RTG_WHOLE they are those of a scene that is one set of glyphs with
// a tree (Pipeline.h, Generation::whole): the tree is walked here, and the driver's structure, through which a CPU device comes to
// it for a fifth of the time, is left out.
#ifdef RTG_WHOLE
#include "glyph.glsl"
#include "walk.glsl"
#include "surface.glsl"

SurfaceHit hit;
float hitUncertainty;
#else
#include "../Shapes/Dialect.glsl"
#include "../Shapes/DoubleWord.glsl"

layout(location = 0) rayPayloadEXT SurfaceHit hit;
#endif

// The last traced ray as the traversal saw it: its exact origin, and where on it `hit` lies.
DoubleWord3 tracedOrigin;
float tracedT;

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
// Leaves in `hit` what the ray meets, or hit.t < 0; with `any` only whether it meets something.
void WalkScene(DoubleWord3 origin, vec3 direction, float tMin, float tMax, uint cullMask, bool any)
{
  GlyphSetRecord set = SetRecord(0u);
  hit.t = -1.0;
  if ((cullMask & (set.translucent != 0u ? TRANSLUCENT_MASK : OPAQUE_MASK)) == 0u)
  {
    return;
  }
  GlyphSource source = SourceOf(set);
  GlyphRay ray = GlyphRay(origin.hi, origin.lo, direction);
  float t;
  uint triangle;
  uint glyph = NearestGlyph(set, source, ray, origin.hi - set.offset, direction, tMin, tMax, any, t, triangle);
  if (glyph != nothing)
  {
    hit.t = t;
    if (!any)
    {
      hit = HitOnGlyph(0u, set, source, ray, glyph, t, hitUncertainty);
    }
  }
}
#endif

// Traces the ray whose exact origin is that double word. The traversal's box tests are in float, so
// their error grows with the origin's distance: the origin is first moved to the scene's bounds, and the part
// of it that a float cannot hold goes to the intersection programs beside the ray. The result in `hit`
// counts t from the given origin.
void TraceNearest(DoubleWord3 origin, vec3 direction, float tMin, float tMax, uint cullMask)
{
  float start = SceneEntry(origin.hi, direction);
  // One step back in case rounding put the entry beyond the bounds.
  start = max(start - 1e-5 * start, 0.0);
  DoubleWord3 moved = origin;
  if (start > 0.0)
  {
    moved = Add(origin, TwoProduct(direction, vec3(start)));
  }
  tracedOrigin = moved;
  hit.t = -1.0;
  if (tMax > start)
  {
#ifdef RTG_WHOLE
    WalkScene(moved, direction, max(tMin - start, 0.0), tMax - start, cullMask, false);
#else
    frame.rays.at[LaunchIndex()].originLow = moved.lo;
    traceRayEXT(accelerationStructureEXT(frame.topLevel), gl_RayFlagsOpaqueEXT, cullMask, 0u, 0u, 0u, moved.hi,
      max(tMin - start, 0.0), direction, tMax - start, 0);
#endif
  }
  tracedT = hit.t;
  if (hit.t >= 0.0)
  {
    hit.t += start;
  }
}

// True when anything in `cullMask` lies between the exact origin, which is inside the scene's bounds, and
// `tMax`: the traversal ends at the first hit and runs no closest-hit program.
bool MeetsAny(DoubleWord3 origin, vec3 direction, float tMax, uint cullMask)
{
#ifdef RTG_WHOLE
  WalkScene(origin, direction, 0.0, tMax, cullMask, true);
#else
  frame.rays.at[LaunchIndex()].originLow = origin.lo;
  // The miss program makes it negative.
  hit.t = 0.0;
  traceRayEXT(accelerationStructureEXT(frame.topLevel),
    gl_RayFlagsOpaqueEXT | gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT, cullMask, 0u, 0u, 0u,
    origin.hi, 0.0, direction, tMax, 0);
#endif
  return hit.t >= 0.0;
}

// How far the found t may be from the exact surface: Shapes/README.md's 8 ulp, doubled.
float HitUncertainty(vec3 direction)
{
#ifdef RTG_WHOLE
  float uncertainty = hitUncertainty;
#else
  float uncertainty = frame.rays.at[LaunchIndex()].uncertainty;
#endif
  return uncertainty / length(direction) + 2e-6 * tracedT;
}

// Where rays from the last hit start: off the surface on the side of `normal`, so far that rounding
// cannot put the start behind it. A start clear of the surface needs no minimum t.
DoubleWord3 LeaveSurface(vec3 direction, vec3 normal)
{
  DoubleWord3 position = Add(tracedOrigin, TwoProduct(direction, vec3(tracedT)));
  return Add(position, TwoProduct(normal, vec3(HitUncertainty(direction) * length(direction))));
}
