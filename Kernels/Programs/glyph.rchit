#version 460
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"
#include "glyph.glsl"
#include "driver.glsl"
#include "surface.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

void main()
{
  uint triangle = nothing;
#ifdef RTG_MESHES
  triangle = frame.rays.at[LaunchIndex()].triangle;
#endif
  uint record = gl_InstanceCustomIndexEXT;
  GlyphSource source = SourceOf(SetRecord(record));
  // The normal is computed anew: hit attributes are not safe on every driver (lavapipe overwrites them with those of
  // rejected candidates).
  vec3 normal = NormalOnGlyph(source, CurrentRay(), gl_PrimitiveID, gl_HitTEXT);
  hit = HitOnGlyph(record, source, CurrentRay(), gl_PrimitiveID, gl_HitTEXT, normal, triangle, CurrentSeed());
}
