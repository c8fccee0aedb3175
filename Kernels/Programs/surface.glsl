// The surface at a hit; after bindings.glsl and glyph.glsl.

// Whether the color of a glyph leaves that of its surface to other rules: none and white do.
bool LeavesColors(const GlyphSetRecord set, const vec4 color)
{
  return !Has(set.variants, COLORS) || color.rgb == vec3(1.0);
}

// The normal of an analytic shape where only t is known.
vec3 NormalOnGlyph(const GlyphSource source, const GlyphRay ray, const uint glyph, const float t)
{
  return IsOfShape(source.set.shape, RTG_MESH) ? vec3(0.0)
                                               : GlyphNormal(source.set.shape, ray, FetchGlyph(source, glyph), t);
}

// `glyph`: its number in the set. `normal`: of an analytic shape. `triangle`: of a mesh. `seed`: of the ray, see
// MayPass().
SurfaceHit HitOnGlyph(const uint record, const GlyphSource source, const GlyphRay ray, const uint glyph, const float t,
  const vec3 normal, const uint triangle, const uint seed)
{
  GlyphSetRecord set = source.set;
  Glyph found = FetchGlyph(source, glyph);
  SurfaceHit hit;
  bool cap = IsCap(set, triangle);
  if (IsOfShape(set.shape, RTG_MESH) && !cap)
  {
    hit = HitOnMesh(record, set, found, ray, glyph, t, triangle);
  }
  else
  {
    hit.t = t;
    hit.normal = cap ? CapNormal(set, triangle) : normal;
    hit.shadingNormal = hit.normal;
    // The shapes' bound is 1e-6 sizes (Shapes/README.md).
    hit.error = leavesSurface ? 2e-6 * ExtentOf(set, found) : 0.0;
    hit.record = record;
    hit.glyph = glyph;
    if (cap && set.identifiesTriangles != 0u)
    {
      // Behind a cap of a surface, the triangle through which the ray leaves it.
      float next;
      IntersectMesh(set, ray, found, t, RTG_NEVER, false, next, hit.glyph);
    }
    vec3 base = Has(set.variants, COLORS) ? ColorOf(set, glyph).rgb : set.color;
    hit.color = vec4(base, OpacityOf(set, glyph));
    if (Has(set.variants, END_COLORS))
    {
      vec4 between = ColorBetweenEnds(set, ray, found, glyph, t);
      hit.color = vec4(LeavesColors(set, hit.color) ? between.rgb : hit.color.rgb, between.a);
    }
  }
  if (MayPass(set, seed))
  {
    // Chance has decided that it stops the ray.
    hit.color.a = 1.0;
  }
  if (Has(set.variants, FORMS) && LeavesColors(set, hit.color))
  {
    // In glyph sizes: squares of tiny lengths vanish.
    vec3 p = FromCenter(ray, found, t) / max(found.size.x, max(found.size.y, found.size.z));
    hit.color.rgb =
      dot(set.forms.at[InSetIfHit(set, FORMS, glyph)], p * p) < 0.0 ? set.negativeColor : set.positiveColor;
  }
  if (Has(set.variants, SIGN_COLORS) && LeavesColors(set, hit.color))
  {
    hit.color.rgb = PolynomialIsNegative(found, FromCenter(ray, found, t)) ? set.negativeColor : set.positiveColor;
  }
  if (Has(set.variants, DIRECTION_COLORS) && LeavesColors(set, hit.color))
  {
    // In the world: a rotated glyph has other colors.
    vec3 axes = abs(RotateToWorld(found, FromCenter(ray, found, t)));
    hit.color.rgb = axes / max(length(axes), 1e-30);
  }
  hit.colored = set.colored != 0u;
  if (cap && set.sectionColors != 0u)
  {
    hit.color.rgb = set.sectionColor;
    hit.colored = true;
  }
  return hit;
}
