#version 460
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"
#include "glyph.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

void main()
{
  uint record = gl_InstanceCustomIndexEXT;
  GlyphSetRecord set = SetRecord(record);

  uint glyph = hasTree ? frame.rays.at[LaunchIndex()].glyph : gl_PrimitiveID;

  // The normal is computed anew: hit attributes are not safe on every driver (lavapipe overwrites them
  // with those of rejected candidates).
  hit.t = gl_HitTEXT;
  hit.normal = GlyphNormal(CurrentRay(), FetchGlyph(CurrentSource(), glyph), gl_HitTEXT);
  hit.record = record;
  hit.glyph = set.firstGlyph + glyph;
  hit.colour = vec4(set.colour, set.opacity);
  if (coloured)
  {
    vec4 own = unpackUnorm4x8(set.colours.at[glyph]);
    hit.colour = vec4(own.rgb, own.a * hit.colour.a);
  }
}
