// Candidates from the driver's BVH, by ray queries: glyphs as boxes, and triangles of meshes at rest, which the
// driver intersects.
#extension GL_EXT_ray_query : require

// Whether there may be triangles of the driver.
bool QueriesTriangles()
{
  return (shapes & (1u << RTG_MESH)) != 0u && (inAllSets & MESH_TREE) == 0u;
}

// A triangle where the ray meets it, with t by our own arithmetic.
GlyphCrossing CrossingOfTriangle(
  const uint record, const GlyphRay ray, const uint instance, const uint triangle, const float tMin, const float tMax)
{
  GlyphSource source = SourceOf(SetRecord(record));
  uint number = instance - source.set.firstInstance;
  float t = CrossTriangle(source.set, ray, FetchGlyph(source, number), triangle).t;
  return GlyphCrossing(record, number, triangle, clamp(t, tMin, tMax), vec3(0.0));
}

// Intersects a candidate, whose set may have a cut.
bool IntersectParts(const uint record, const GlyphSetRecord set, const GlyphRay ray, const uint number,
  const Glyph glyph, const uint seed, const float tMin, const bool any, const bool gathers, inout GlyphCrossing hit)
{
  bool cuts = CutsGlyphs(set);
  Span body = cuts ? SectionSpan(set, ray) : WholeRay();
  bool met = false;
  for (uint part = 0u; part < (cuts ? 2u : 1u) && !(any && met); ++part)
  {
    GlyphCrossing found = hit;
    vec2 range = vec2(tMin, hit.t);
    if (partsOfRay > 1u)
    {
      range = BeginPart(set, cuts, body, part, tMin, hit.t);
      found.t = range.y;
    }
    float low, high;
    bool near = range.x <= range.y && Estimate(set, ray, glyph, range.x, range.y, low, high) != RTG_MISSED;
    if (near && IntersectCandidate(record, set, ray, number, glyph, seed, range.x, any, gathers, found))
    {
      met = true;
      if (!(layered && gathers) || found.t < range.y)
      {
        hit = found;
      }
    }
  }
  return met;
}

// The same hits as WalkSets() in walk.glsl.
GlyphCrossing QueryStructure(const GlyphRay ray, const float tMin, const float tMax, const uint mask, const uint seed,
  const bool any, const bool gathers)
{
  GlyphCrossing hit = GlyphCrossing(0u, nothing, nothing, tMax, vec3(0.0));
  uint slice = moves ? uint(shutterTime * float(frame.topLevelCount)) : 0u;
  // The driver commits the nearest triangle; translucent ones are candidates.
  uint flags = (any ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT) |
    (translucency || (layered && gathers) ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT);
  rayQueryEXT query;
  rayQueryInitializeEXT(
    query, accelerationStructureEXT(frame.topLevels.at[slice]), flags, mask, ray.origin, tMin, ray.direction, tMax);
  bool going = true;
  while (going && rayQueryProceedEXT(query))
  {
    uint record = rayQueryGetIntersectionInstanceCustomIndexEXT(query, false);
    uint primitive = rayQueryGetIntersectionPrimitiveIndexEXT(query, false);
    GlyphSource source = SourceOf(SetRecord(record));
    GlyphSetRecord set = source.set;
    bool adds = layered && gathers && set.translucent != 0u;
    if (QueriesTriangles() &&
      rayQueryGetIntersectionTypeEXT(query, false) == gl_RayQueryCandidateIntersectionTriangleEXT)
    {
      GlyphCrossing met =
        CrossingOfTriangle(record, ray, rayQueryGetIntersectionInstanceIdEXT(query, false), primitive, tMin, tMax);
      if (layered && adds)
      {
        if (met.t <= hit.t)
        {
          AddLayer(met, ErrorOfT(set, ray, FetchGlyph(source, met.glyph), met.t), 1.0);
          hit.t = LayersEnd(hit.t);
        }
      }
      else if (!MayPass(set, seed) ||
        !PassesTriangle(set, ray, seed, met.glyph, FetchGlyph(source, met.glyph), primitive))
      {
        rayQueryConfirmIntersectionEXT(query);
        going = !any;
      }
    }
    else
    {
      if (QueriesTriangles() &&
        rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT)
      {
        hit.t = min(hit.t, rayQueryGetIntersectionTEXT(query, true));
      }
      Glyph glyph = FetchGlyph(source, primitive);
      float before = hit.t;
      if (IntersectParts(record, set, ray, primitive, glyph, seed, tMin, any, adds, hit))
      {
        going = !any;
      }
      if (hit.t < before)
      {
        rayQueryGenerateIntersectionEXT(query, hit.t);
      }
    }
  }
  if (QueriesTriangles() && rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT)
  {
    hit = CrossingOfTriangle(rayQueryGetIntersectionInstanceCustomIndexEXT(query, true), ray,
      rayQueryGetIntersectionInstanceIdEXT(query, true), rayQueryGetIntersectionPrimitiveIndexEXT(query, true), tMin,
      tMax);
  }
  if (layered && gathers)
  {
    // Layers that were found before what is opaque in front of them.
    while (layerCount > 0u && LayerAt(layerCount - 1u).t > hit.t)
    {
      --layerCount;
    }
  }
  return hit;
}
