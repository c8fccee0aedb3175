// The nearest glyph of a set that a ray meets, by the set's GlyphTree; after bindings.glsl and glyph.glsl.
#ifndef RTG_WALK
#define RTG_WALK

#include "tree.glsl"

layout(constant_id = 34) const bool ownTreeOrder = false; // the slices of time are sorted each for itself

// What a ray asks a set of glyphs.
struct Query
{
  GlyphRay ray;
  vec3 boxOrigin; // the ray's origin in the frame of the set's centres, for boxes
  float tMin;
  float tMax;
  bool any;  // one crossing will do, whichever it is
  uint seed; // PassesBy()
};

// What it finds.
struct GlyphHit
{
  uint glyph; // or `nothing`
  float t;
  uint triangle; // of a mesh glyph
};

// The nearest crossings of a ray that gathers its layers, of all glyphs, in their order: t as the upper half, the glyph
// as the lower. Not a parameter: compilers copy arrays at every call.
const uint layerCapacity = 24u;
uint layerCount = 0u;
uint layerLimit = 0u; // no more are wanted
uint64_t layer[layerCapacity];

// Adds a crossing; of more than the limit the farthest is dropped. They come in nearly in their order.
void AddLayer(float t, uint glyph)
{
  uint64_t added = pack64(uvec2(glyph, floatBitsToUint(t))); // of floats from 0 on the bits have the numbers' order
  uint at = min(layerCount, layerLimit - 1u);
  for (; at > 0u && layer[at - 1u] > added; --at)
  {
    layer[at] = layer[at - 1u];
  }
  layer[at] = added;
  layerCount = min(layerCount + 1u, layerLimit);
}

float LayerT(uint at)
{
  return uintBitsToFloat(unpack32(layer[at]).y);
}

// Adds the glyph's crossings in [tMin, tMax]; returns up to where others are still wanted.
float AddLayersOf(GlyphRay ray, uint number, Glyph glyph, float tMin, float tMax)
{
  float t;
  uint triangle;
  for (uint crossing = 0u; crossing < maximumCrossings && IntersectGlyph(ray, glyph, tMin, tMax, t, triangle);
       ++crossing)
  {
    AddLayer(t, number);
    tMax = layerCount == layerLimit ? LayerT(layerLimit - 1u) : tMax;
    tMin = t + ErrorOfT(ray, glyph, t);
  }
  return tMax;
}

// The glyph whose crossing is nearest. With `gathers` all crossings are added to the layers instead, as many as are
// wanted.
GlyphHit Traverse(GlyphSetRecord set, GlyphSource source, Query query, const bool gathers)
{
  TreeNodes nodes = TreeNodes(set.tree);
  uint levels = set.treeLevels;
  uint leafBits = set.treeLeafBits;
  uint64_t count = uint64_t(set.glyphCount);
  uint slice = CurrentSlice(set);
  uint firstNode = slice * set.nodesPerSlice;
  uint firstPlace = slice * set.glyphCount;
  BoxRay boxRay = MakeBoxRay(query.boxOrigin, query.ray.direction);
  GlyphHit hit = GlyphHit(nothing, query.tMax, nothing);
  // While the hit is estimated, its t lies between `surely` and hit.t.
  float surely = hit.t;
  bool estimated = false;
  TreePosition position = RootOfTree();
  uint i = 0u, end = 0u; // what is left of the current leaf
  bool going = true;
  do
  {
    // In plain arithmetic to the next glyph that must be looked at exactly: so the lanes of a CPU device do that
    // together, and most rays only once.
    uint candidate = nothing;
    do
    {
      if (position.level < levels)
      {
        uint mask, order;
        float behind;
        IntersectNode(nodes, firstNode + NodeNumber(position), boxRay, query.tMin, hit.t, mask, order, behind);
        PushChildren(position, mask, order, behind);
      }
      else if (i < end)
      {
        uint glyph = ownTreeOrder ? set.treeOrder.at[firstPlace + i] : i;
        float low, high;
        int verdict = EstimateGlyph(query.ray, FetchGlyph(source, glyph), query.tMin, hit.t, low, high);
        // An estimated glyph is met twice; a ray that passes by both misses it.
        bool passes = verdict == RTG_MET && PassesBy(query.seed, set, glyph, 0u);
        if (passes && PassesBy(query.seed, set, glyph, 1u))
        {
          verdict = RTG_MISSED;
        }
        if (!gathers && !passes && verdict == RTG_MET && high < surely)
        {
          hit.glyph = glyph;
          estimated = true;
          surely = low;
          hit.t = high;
          going = !query.any;
          DropHidden(position, hit.t);
        }
        else if (verdict != RTG_MISSED)
        {
          // Which of two estimated glyphs is nearer their exact t must tell: first that of the hit, then this one comes
          // again.
          candidate = estimated ? hit.glyph : glyph;
        }
        i += candidate == nothing || !estimated ? 1u : 0u;
      }
      if (i >= end && going)
      {
        going = PopChild(position);
        uvec2 range = LeafRange(position, levels, count, leafBits);
        i = range.x;
        end = range.y;
      }
    } while (going && candidate == nothing);

    if (candidate == nothing && estimated && !query.any)
    {
      candidate = hit.glyph;
    }
    if (candidate != nothing)
    {
      Glyph glyph = FetchGlyph(source, candidate);
      float t;
      uint triangle;
      if (gathers)
      {
        hit.t = AddLayersOf(query.ray, candidate, glyph, query.tMin, hit.t);
        DropHidden(position, hit.t);
      }
      else if (IntersectStopping(set, query.ray, candidate, glyph, query.seed, query.tMin, hit.t, t, triangle))
      {
        hit.glyph = candidate;
        hit.triangle = triangle;
        hit.t = t;
        going = going && !query.any;
        DropHidden(position, hit.t);
      }
      surely = hit.t;
      estimated = false;
    }
  } while (going);
  return hit;
}

GlyphHit NearestGlyph(GlyphSetRecord set, GlyphSource source, Query query)
{
  return Traverse(set, source, query, false);
}

#endif
