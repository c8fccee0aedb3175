#version 460
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"
#include "glyph.glsl"

layout(constant_id = 8) const bool colouredByForm = false;
layout(constant_id = 20) const bool leavesSurface = false;  // rays will start from the hit

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

void main()
{
  uint record = gl_InstanceCustomIndexEXT;
  GlyphSetRecord set = SetRecord(record);

  uint glyph = hasTree ? frame.rays.at[LaunchIndex()].glyph : gl_PrimitiveID;

  // The normal is computed anew: hit attributes are not safe on every driver (lavapipe overwrites them
  // with those of rejected candidates).
  Glyph found = FetchGlyph(CurrentSource(), glyph);
  hit.t = gl_HitTEXT;
  hit.normal = GlyphNormal(CurrentRay(), found, gl_HitTEXT);
  // The shapes promise 1e-6 sizes (Shapes/README.md).
  if (leavesSurface)
  {
    frame.rays.at[LaunchIndex()].uncertainty = 2e-6 * max(found.size.x, max(found.size.y, found.size.z));
  }
  hit.record = record;
  hit.glyph = set.firstGlyph + glyph;
  hit.colour = vec4(set.colour, set.opacity);
  if (coloured)
  {
    vec4 own = unpackUnorm4x8(set.colours.at[glyph]);
    hit.colour = vec4(own.rgb, own.a * hit.colour.a);
  }
  if (colouredByForm)
  {
    // In glyph sizes: squares of tiny lengths vanish.
    vec3 p = FromCentre(CurrentRay(), found, gl_HitTEXT) / max(found.size.x, max(found.size.y, found.size.z));
    hit.colour.rgb = dot(set.forms.at[glyph], p * p) < 0.0 ? set.negativeColour : set.positiveColour;
  }
}
