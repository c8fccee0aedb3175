// What an analytic glyph's surface is like where a ray meets it; after bindings.glsl and glyph.glsl.
layout(constant_id = 8) const bool colouredByForm = false;

// `glyph`: its number in the set. `seed`: of the ray, as PassesBy() has it.
SurfaceHit HitOnGlyph(uint record, GlyphSetRecord set, GlyphSource source, GlyphRay ray, uint glyph, float t, uint seed)
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
  hit.colour = vec4(coloured ? unpackUnorm4x8(set.colours.at[glyph]).rgb : set.colour, OpacityOf(set, glyph));
  if (translucency && seed != 0u)
  {
    // Chance has decided that it stops the ray.
    hit.colour.a = 1.0;
  }
  if (colouredByForm)
  {
    // In glyph sizes: squares of tiny lengths vanish.
    vec3 p = FromCentre(ray, found, t) / max(found.size.x, max(found.size.y, found.size.z));
    hit.colour.rgb = dot(set.forms.at[glyph], p * p) < 0.0 ? set.negativeColour : set.positiveColour;
  }
  return hit;
}
