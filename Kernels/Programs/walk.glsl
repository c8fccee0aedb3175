// Candidates from the plugin's BVH: a ray visits the visible sets one after the other and traverses the BVH of each
// (Kernels/GlyphTree.h).

// Brings a crossing of a glyph of the set that is nearer than `hit`; with `any` whichever comes first. With `gathers`
// all crossings nearer than it are added to the layers instead, as many as are wanted.
void Traverse(const uint record, const GlyphSource source, const GlyphRay ray, const float tMin, const uint seed,
  const bool any, const bool gathers, inout GlyphCrossing hit)
{
  GlyphSetRecord set = source.set;
  TreeRecord tree = set.tree;
  uint64_t count = uint64_t(set.glyphCount);
  uint slice = Has(set.variants, MOVING_GLYPHS | MOVING_MESH) ? SliceOf(tree.sliceBits) : 0u;
  uint firstNode = slice * tree.nodesPerSlice;
  uint firstPlace = slice * set.glyphCount;
  BoxRay boxRay = MakeBoxRay(ray.origin - set.offset, abs(ray.origin) + abs(set.offset), ray.direction);
  bool chance = MayPass(set, seed);
  // While the hit is estimated, its t lies between `surely` and hit.t.
  float surely = hit.t;
  bool estimated = false;
  TreePosition position = RootOfTree();
  uvec2 leaf = uvec2(0u); // what is left of the current one
  bool going = true;
  do
  {
    // Plain arithmetic goes on to the next glyph that must be intersected exactly: so the lanes of a CPU device do that
    // together, and most rays only once.
    uint candidate = nothing;
    do
    {
      if (position.level < tree.levels)
      {
        VisitNode(position, tree, firstNode, boxRay, tMin, hit.t);
      }
      else if (leaf.x < leaf.y)
      {
        uint glyph = moves && Has(set.variants, ORDER_OF_SLICES)
          ? tree.order.at[InSet(set, ORDER_OF_SLICES, firstPlace + leaf.x)]
          : leaf.x;
        float low, high;
        int verdict = Estimate(set, ray, FetchGlyph(source, glyph), tMin, hit.t, low, high);
        if (chance && Has(set.variants, END_COLORS) && verdict == RTG_HIT)
        {
          verdict = RTG_UNKNOWN; // the opacity is that at the exact t
        }
        // An estimated glyph is met twice at most; a ray that passes by both misses it.
        bool passes =
          chance && verdict == RTG_HIT && Passes(set, seed, glyph, CrossingNumber(set, 0u), OpacityOf(set, glyph));
        if (passes && Passes(set, seed, glyph, CrossingNumber(set, 1u), OpacityOf(set, glyph)))
        {
          verdict = RTG_MISSED;
        }
        if (!(layered && gathers) && !passes && verdict == RTG_HIT && high < surely)
        {
          hit.record = record;
          hit.glyph = glyph;
          estimated = true;
          surely = low;
          hit.t = high;
          going = !any;
        }
        else if (verdict != RTG_MISSED)
        {
          // The exact t decides which of two estimated glyphs is nearer: first that of the hit, then this one comes
          // again.
          candidate = estimated ? hit.glyph : glyph;
        }
        leaf.x += candidate == nothing || !estimated ? 1u : 0u;
      }
      if (leaf.x >= leaf.y && going)
      {
        going = PopChild(position);
        leaf = LeafRange(position, tree, count);
      }
    } while (going && candidate == nothing);

    if (candidate == nothing && estimated && !any)
    {
      candidate = hit.glyph;
    }
    if (candidate != nothing)
    {
      bool met =
        IntersectCandidate(record, set, ray, candidate, FetchGlyph(source, candidate), seed, tMin, any, gathers, hit);
      going = going && !(any && met);
      surely = hit.t;
      estimated = false;
    }
  } while (going);
}

// Whether the ray may meet a set between tMin and tMax: not where it passes by its bounds. NaN: it may.
bool MayIntersect(const GlyphSetRecord set, const BoxRay ray, const float tMin, const float tMax)
{
  vec3 toLower = (set.lower - ray.origin) * ray.inverse, toUpper = (set.upper - ray.origin) * ray.inverse;
  vec3 tolerance = max(abs(toLower), abs(toUpper)) * 9.5367431640625e-7 + ray.tolerance;
  vec3 near = min(toLower, toUpper) - tolerance, far = max(toLower, toUpper) + tolerance;
  return !(max(max(near.x, near.y), max(near.z, tMin)) > min(min(far.x, far.y), min(far.z, tMax)));
}

// The nearest crossing of all sets in `mask`; with `any` whichever comes first. With `gathers` the layers of
// translucent sets up to what is opaque.
GlyphCrossing WalkSets(const GlyphRay ray, const float tMin, const float tMax, const uint mask, const uint seed,
  const bool any, const bool gathers)
{
  GlyphCrossing hit = GlyphCrossing(0u, nothing, nothing, tMax, vec3(0.0));
  uint count = alone ? 1u : frame.setCount;
  // Two rounds where layers are gathered: opaque sets end them.
  uint end = layered && gathers && !alone ? 2u * count : count;
  // A ray that is cut goes through a set once for each part of it.
  Span body = WholeRay();
  BoxRay boxRay = MakeBoxRay(ray.origin, abs(ray.origin), ray.direction);
  for (uint step = 0u; step < partsOfRay * end && !(any && hit.glyph != nothing); ++step)
  {
    uint i = step / partsOfRay;
    uint record = i < count ? i : i - count;
    bool gathering = layered && gathers && (alone || i >= count);
    GlyphSetRecord set = SetRecord(record);
    if ((set.mask & (layered && gathers ? (gathering ? mask & TRANSLUCENT_MASK : OPAQUE_MASK) : mask)) != 0u &&
      (alone || MayIntersect(set, boxRay, tMin, hit.t)))
    {
      GlyphCrossing found = hit;
      vec2 range = vec2(tMin, hit.t);
      if (partsOfRay > 1u)
      {
        bool cuts = CutsGlyphs(set);
        if (cuts && step % partsOfRay == 0u)
        {
          body = SectionSpan(set, ray);
        }
        range = BeginPart(set, cuts, body, step % partsOfRay, tMin, hit.t);
        found = GlyphCrossing(0u, nothing, nothing, range.y, vec3(0.0));
      }
      if (range.x <= range.y)
      {
        Traverse(record, SourceOf(set), ray, range.x, seed, any, gathering, found);
        if (partsOfRay == 1u || found.glyph != nothing || found.t < range.y)
        {
          hit = found;
        }
      }
    }
  }
  return hit;
}
