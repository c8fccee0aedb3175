// What a ray meets of the sets of a scene, by their own trees (Kernels/GlyphTree.h); after bindings.glsl and
// glyph.glsl.
#ifndef RTG_WALK
#define RTG_WALK

#include "tree.glsl"

// A crossing of a glyph's surface
struct GlyphCrossing
{
  uint record; // of the glyph's set
  uint glyph;  // or `nothing`
  uint triangle;
  float t;
  vec3 normal; // of an analytic shape; a layer has none
};

// The nearest crossings of a ray that gathers its layers, of all glyphs, in their order: by t, then by glyph. Not a
// parameter: compilers copy arrays at every call.
uint layerCount = 0u;
uint layerLimit = 0u;           // no more are wanted
uint layerNext = 0u;            // the first that has not been shown
uint layerTime[LAYER_CAPACITY]; // bits of t: of floats from 0 on they have their order
uint layerGlyph[LAYER_CAPACITY];
uint layerRecord[LAYER_CAPACITY];   // where there are several
uint layerTriangle[LAYER_CAPACITY]; // where there are meshes
const bool gathersTriangles = (shapes & (1u << RTG_MESH)) != 0u;

// Adds a crossing; of more than the limit the farthest is dropped. They come in nearly in their order.
void AddLayer(const GlyphCrossing added)
{
  uint time = floatBitsToUint(added.t);
  uint at = min(layerCount, layerLimit - 1u);
  for (; at > 0u && (layerTime[at - 1u] > time || (layerTime[at - 1u] == time && layerGlyph[at - 1u] > added.glyph));
       --at)
  {
    layerTime[at] = layerTime[at - 1u];
    layerGlyph[at] = layerGlyph[at - 1u];
    if (!alone)
    {
      layerRecord[at] = layerRecord[at - 1u];
    }
    if (gathersTriangles)
    {
      layerTriangle[at] = layerTriangle[at - 1u];
    }
  }
  layerTime[at] = time;
  layerGlyph[at] = added.glyph;
  if (!alone)
  {
    layerRecord[at] = added.record;
  }
  if (gathersTriangles)
  {
    layerTriangle[at] = added.triangle;
  }
  layerCount = min(layerCount + 1u, layerLimit);
}

GlyphCrossing LayerAt(const uint at)
{
  return GlyphCrossing(alone ? 0u : layerRecord[at], layerGlyph[at], gathersTriangles ? layerTriangle[at] : nothing,
    uintBitsToFloat(layerTime[at]), vec3(0.0));
}

// Adds the glyph's crossings in [tMin, tMax]; returns up to where others are still wanted.
float AddLayersOf(const uint record, const GlyphSetRecord set, const GlyphRay ray, const uint number, const Glyph glyph,
  float tMin, float tMax)
{
  float t;
  vec3 normal;
  uint triangle;
  for (uint crossing = 0u;
       crossing < maximumPasses && Intersect(set, ray, glyph, tMin, tMax, false, false, t, normal, triangle);
       ++crossing)
  {
    AddLayer(GlyphCrossing(record, number, triangle, t, normal));
    tMax = layerCount == layerLimit ? LayerAt(layerLimit - 1u).t : tMax;
    tMin = t + ErrorOfT(set, ray, glyph, t);
  }
  return tMax;
}

// Brings a crossing of a glyph of the set that is nearer than `hit`; with `any` whichever comes first. With `gathers`
// all crossings nearer than it are added to the layers instead, as many as are wanted.
void Traverse(const uint record, const GlyphSource source, const GlyphRay ray, const float tMin, const uint seed,
  const bool any, const bool gathers, inout GlyphCrossing hit)
{
  GlyphSetRecord set = source.set;
  TreeNodes nodes = TreeNodes(set.tree.nodes);
  uint levels = set.tree.levels;
  uint leafBits = set.tree.leafBits;
  uint64_t count = uint64_t(set.glyphCount);
  uint slice = Has(set.variants, MOVING_GLYPHS | MOVING_MESH) ? SliceOf(set.tree.sliceBits) : 0u;
  uint firstNode = slice * set.tree.nodesPerSlice;
  uint firstPlace = slice * set.glyphCount;
  BoxRay boxRay = MakeBoxRay(ray.origin - set.offset, abs(ray.origin) + abs(set.offset), ray.direction);
  bool chance = MayPass(set, seed);
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
        uint children = ChildrenOf(position, levels, leafBits);
        IntersectNode(nodes, firstNode + NodeNumber(position), children, boxRay, tMin, hit.t, mask, order, behind);
        PushChildren(position, mask, order, behind);
      }
      else if (i < end)
      {
        uint glyph = moves && Has(set.variants, ORDER_OF_SLICES)
          ? set.tree.order.at[InSet(set, ORDER_OF_SLICES, firstPlace + i)]
          : i;
        float low, high;
        int verdict = Estimate(set, ray, FetchGlyph(source, glyph), tMin, hit.t, low, high);
        // An estimated glyph is met twice; a ray that passes by both misses it.
        bool passes = chance && verdict == RTG_MET && Passes(set, seed, glyph, 0u, OpacityOf(set, glyph));
        if (passes && Passes(set, seed, glyph, 1u, OpacityOf(set, glyph)))
        {
          verdict = RTG_MISSED;
        }
        if (!gathers && !passes && verdict == RTG_MET && high < surely)
        {
          hit.record = record;
          hit.glyph = glyph;
          estimated = true;
          surely = low;
          hit.t = high;
          going = !any;
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

    if (candidate == nothing && estimated && !any)
    {
      candidate = hit.glyph;
    }
    if (candidate != nothing)
    {
      Glyph glyph = FetchGlyph(source, candidate);
      float t;
      vec3 normal;
      uint triangle;
      if (gathers)
      {
        hit.t = AddLayersOf(record, set, ray, candidate, glyph, tMin, hit.t);
        DropHidden(position, hit.t);
      }
      else if (IntersectStopping(set, ray, candidate, glyph, seed, tMin, hit.t, any, !any, t, normal, triangle))
      {
        hit.record = record;
        hit.glyph = candidate;
        hit.triangle = triangle;
        hit.t = t;
        hit.normal = normal;
        going = going && !any;
        DropHidden(position, hit.t);
      }
      surely = hit.t;
      estimated = false;
    }
  } while (going);
}

// The nearest crossing of all sets in `mask`; with `any` whichever comes first. With `gathers` the layers of
// translucent sets up to what is opaque.
GlyphCrossing WalkSets(const GlyphRay ray, const float tMin, const float tMax, const uint mask, const uint seed,
  const bool any, const bool gathers)
{
  GlyphCrossing hit = GlyphCrossing(0u, nothing, nothing, tMax, vec3(0.0));
  uint count = alone ? 1u : frame.setCount;
  // Two rounds where layers are gathered: opaque sets end them.
  uint end = gathers && !alone ? 2u * count : count;
  for (uint i = 0u; i < end && !(any && hit.glyph != nothing); ++i)
  {
    uint record = i < count ? i : i - count;
    bool gathering = gathers && (alone || i >= count);
    GlyphSetRecord set = SetRecord(record);
    if ((set.mask & (gathers ? (gathering ? mask & TRANSLUCENT_MASK : OPAQUE_MASK) : mask)) != 0u)
    {
      Traverse(record, SourceOf(set), ray, tMin, seed, any, gathering, hit);
    }
  }
  return hit;
}

#endif
