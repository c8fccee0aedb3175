// What an analytic glyph's surface is like where a ray meets it; after bindings.glsl and glyph.glsl.
layout(constant_id = 8) const bool colouredByForm = false;

// `glyph`: its number in the set.
SurfaceHit HitOnGlyph(uint record, GlyphSetRecord set, GlyphSource source, GlyphRay ray, uint glyph, float t)
{
  SurfaceHit hit;
  // The normal is computed anew: hit attributes are not safe on every driver (lavapipe overwrites them
  // with those of rejected candidates).
  Glyph found = FetchGlyph(source, glyph);
  hit.t = t;
  hit.normal = GlyphNormal(ray, found, t);
  hit.shadingNormal = hit.normal;
  // The shapes promise 1e-6 sizes (Shapes/README.md).
  hit.error = leavesSurface ? 2e-6 * max(found.size.x, max(found.size.y, found.size.z)) : 0.0;
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
    vec3 p = FromCentre(ray, found, t) / max(found.size.x, max(found.size.y, found.size.z));
    hit.colour.rgb = dot(set.forms.at[glyph], p * p) < 0.0 ? set.negativeColour : set.positiveColour;
  }
  return hit;
}
