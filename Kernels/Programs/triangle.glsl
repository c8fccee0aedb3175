// Normals and colors of triangles by their corners.
uvec3 CornersOf(const GlyphSetRecord set, const uint triangle)
{
  return uvec3(set.meshTriangles.at[3u * triangle], set.meshTriangles.at[3u * triangle + 1u],
    set.meshTriangles.at[3u * triangle + 2u]);
}

// Its normal, of some length. Products of edges themselves would overflow, or vanish, long before the edges do.
vec3 NormalOf(const vec3 toB, const vec3 toC)
{
  return cross(toB / max(LargestOf(toB), 1e-37), toC / max(LargestOf(toC), 1e-37));
}

// The normal in unit length; against the ray where it is zero: rounding may let rays meet triangles without
// area.
vec3 UnitNormal(const vec3 normal, const vec3 direction)
{
  float largest = LargestOf(normal);
  return normalize(largest > 0.0 ? normal / largest : -direction);
}

// Mean of the corners' normals, of any length; `flat_` where they cancel out.
vec3 SmoothNormal(const GlyphSetRecord set, const uvec3 corner, const vec3 weight, const vec3 flat_)
{
  vec3 smoothed = weight.x * set.meshNormals.at[corner.x] + weight.y * set.meshNormals.at[corner.y] +
    weight.z * set.meshNormals.at[corner.z];
  return dot(smoothed, smoothed) > 0.0 ? smoothed : flat_;
}

vec4 TriangleColor(
  const GlyphSetRecord set, const uvec3 corner, const vec3 weight, const uint triangle, const uint glyph)
{
  vec4 color = vec4(set.color, 1.0);
  if (Has(set.variants, MESH_POSITION_COLORS))
  {
    color = weight.x * unpackUnorm4x8(set.meshColors.at[corner.x]) +
      weight.y * unpackUnorm4x8(set.meshColors.at[corner.y]) + weight.z * unpackUnorm4x8(set.meshColors.at[corner.z]);
  }
  else if (Has(set.variants, MESH_VALUE_COLORS))
  {
    vec3 values =
      uintBitsToFloat(uvec3(set.meshColors.at[corner.x], set.meshColors.at[corner.y], set.meshColors.at[corner.z]));
    float value = ValueBetween(
      min(values.x, min(values.y, values.z)), weight.x * values.x + weight.y * values.y + weight.z * values.z);
    color = TableColor(set.meshColors, set.meshValueCount, set.meshTableSize, value);
  }
  else if (Has(set.variants, MESH_TRIANGLE_COLORS))
  {
    color = unpackUnorm4x8(set.meshColors.at[triangle]);
  }
  else if (Has(set.variants, COLORS))
  {
    color = ColorOf(set, glyph);
  }
  color.a *= OpacityOfGlyph(set, glyph);
  return color;
}
