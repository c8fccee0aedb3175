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
  hit =
    HitOnGlyph(record, SourceOf(SetRecord(record)), CurrentRay(), gl_PrimitiveID, gl_HitTEXT, triangle, CurrentSeed());
}
