#version 460
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"
#include "glyph.glsl"
#include "surface.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

void main()
{
  uint record = gl_InstanceCustomIndexEXT;
  uint glyph = hasTree ? frame.rays.at[LaunchIndex()].glyph : gl_PrimitiveID;
  hit = HitOnGlyph(record, SetRecord(record), CurrentSource(), CurrentRay(), glyph, gl_HitTEXT, CurrentSeed());
}
