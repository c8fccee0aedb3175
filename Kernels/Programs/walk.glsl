// The nearest glyph of a set that a ray meets, by the set's GlyphTree; after bindings.glsl and glyph.glsl.
#ifndef RTG_WALK
#define RTG_WALK

#include "tree.glsl"

layout(constant_id = 34) const bool ownTreeOrder = false;  // the slices of time are sorted each for itself

const uint nothing = 0xffffffffu;

// The glyph whose crossing in [tMin, tMax] is nearest, or `nothing`; with `any`, one of which a crossing there is certain. `origin` and
// `direction`: the ray in the frame of the set's centres, for boxes. `triangle`: of a mesh glyph, which one.
uint NearestGlyph(GlyphSetRecord set, GlyphSource source, GlyphRay ray, vec3 origin, vec3 direction, float tMin, float tMax,
  bool any, out float t, out uint triangle)
{
  TreeNodes nodes = TreeNodes(set.tree);
  uint levels = set.treeLevels;
  uint leafBits = set.treeLeafBits;
  uint64_t count = uint64_t(set.glyphCount);
  uint slice = CurrentSlice(set);
  uint firstNode = slice * set.nodesPerSlice;
  uint firstPlace = slice * set.glyphCount;
  BoxRay boxRay = MakeBoxRay(origin, direction);

  triangle = nothing;
  float nearest = tMax;
  uint found = nothing;
  // While `found` is estimated, its t lies between `surely` and `nearest`.
  float surely = nearest;
  bool estimated = false;
  TreePosition position = RootOfTree();
  uint i = 0u, end = 0u;  // what is left of the current leaf
  bool going = true;
  do
  {
    // In plain arithmetic to the next glyph that must be looked at exactly: so the lanes of a CPU device do that together, and
    // most rays only once.
    uint candidate = nothing;
    do
    {
      if (position.level < levels)
      {
        uint mask, order;
        float behind;
        IntersectNode(nodes, firstNode + NodeNumber(position), boxRay, tMin, nearest, mask, order, behind);
        PushChildren(position, mask, order, behind);
      }
      else if (i < end)
      {
        uint glyph = ownTreeOrder ? set.treeOrder.at[firstPlace + i] : i;
        float low, high;
        int verdict = EstimateGlyph(ray, FetchGlyph(source, glyph), tMin, nearest, low, high);
        if (verdict == RTG_MET && high < surely)
        {
          found = glyph;
          estimated = true;
          surely = low;
          nearest = high;
          going = !any;
          DropHidden(position, nearest);
        }
        else if (verdict != RTG_MISSED)
        {
          // Which of two estimated ones is nearer their exact t must tell: first the one, then this one again.
          candidate = estimated ? found : glyph;
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
      candidate = found;
    }
    if (candidate != nothing)
    {
      if (IntersectGlyph(ray, FetchGlyph(source, candidate), tMin, nearest, t))
      {
        found = candidate;
#if RTG_SHAPE == 7
        triangle = metTriangle;
#endif
        nearest = t;
        going = going && !any;
        DropHidden(position, nearest);
      }
      surely = nearest;
      estimated = false;
    }
  } while (going);

  t = nearest;
  return found;
}

#endif
