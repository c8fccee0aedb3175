// Handles a candidate, a glyph that a ray may meet, whether the plugin's BVH (walk.glsl) or the driver's (query.glsl)
// have found it; after bindings.glsl and glyph.glsl.

// A crossing of a glyph's surface
struct GlyphCrossing
{
  uint record; // of the glyph's set
  uint glyph;  // or `nothing`
  uint triangle;
  float t;
  vec3 normal; // of an analytic shape; a layer has none
};

// The nearest crossings of a ray that gathers its layers, of all glyphs, in their order: by t, then by glyph and set.
// Not a parameter: compilers copy arrays at every call.
uint layerCount = 0u;
uint layerLimit = 0u;           // no more are wanted
uint layerNext = 0u;            // the first that has not been shown
uint layerTime[LAYER_CAPACITY]; // bits of t: of floats from 0 on they have their order
uint layerGlyph[LAYER_CAPACITY];
uint layerRecord[LAYER_CAPACITY];         // where there are several
uint layerTriangle[LAYER_CAPACITY];       // where there are meshes or cuts
float layerTransmittance[LAYER_CAPACITY]; // transmittance, 1 where unknown
bool layersStopLight = false;             // what lies behind the last does not show
const bool gathersTriangles = ((shapes & (1u << RTG_MESH)) | (inSomeSets & SECTION)) != 0u;

// Whether opacities decide how many of them show: where all are alike the limit does.
bool CountsLight()
{
  return layerLimit == LAYER_CAPACITY;
}

GlyphCrossing LayerAt(const uint at)
{
  return GlyphCrossing(alone ? 0u : layerRecord[at], layerGlyph[at], gathersTriangles ? layerTriangle[at] : nothing,
    uintBitsToFloat(layerTime[at]), vec3(0.0));
}

void SetLayer(const uint at, const GlyphCrossing crossing, const float transmittance)
{
  layerTime[at] = floatBitsToUint(crossing.t);
  layerGlyph[at] = crossing.glyph;
  layerTransmittance[at] = transmittance;
  if (!alone)
  {
    layerRecord[at] = crossing.record;
  }
  if (gathersTriangles)
  {
    layerTriangle[at] = crossing.triangle;
  }
}

// Whether the layer at that place comes after a crossing.
bool IsBehind(const uint at, const GlyphCrossing crossing)
{
  uint time = floatBitsToUint(crossing.t);
  bool same = layerTime[at] == time && layerGlyph[at] == crossing.glyph;
  // The plugin's BVH yields one set after the other.
  return rayQueries && !alone && same
    ? layerRecord[at] > crossing.record
    : layerTime[at] > time || (layerTime[at] == time && layerGlyph[at] > crossing.glyph);
}

// Whether the layers have a crossing already: drivers may bring a candidate twice, and bring both triangles at an edge.
// `error`: how far from t the exact crossing may lie.
bool IsListed(const GlyphCrossing crossing, const float error)
{
  bool listed = false;
  for (uint at = 0u; at < layerCount; ++at)
  {
    GlyphCrossing layer = LayerAt(at);
    listed = listed ||
      (layer.glyph == crossing.glyph && layer.record == crossing.record && abs(layer.t - crossing.t) <= error);
  }
  return listed;
}

// Adds a crossing of that transmittance; of more than the limit, and of those that do not show, the farthest are
// dropped. They come in nearly in their order.
void AddLayer(const GlyphCrossing added, const float error, const float transmittance)
{
  if (rayQueries && IsListed(added, error))
  {
    return;
  }
  uint at = min(layerCount, layerLimit - 1u);
  for (; at > 0u && IsBehind(at - 1u, added); --at)
  {
    SetLayer(at, LayerAt(at - 1u), layerTransmittance[at - 1u]);
  }
  SetLayer(at, added, transmittance);
  layerCount = min(layerCount + 1u, layerLimit);
  float light = 1.0;
  for (uint i = 0u; CountsLight() && i < layerCount; ++i)
  {
    light *= layerTransmittance[i];
    if (light < 0.99 * MIN_TRANSMITTANCE)
    {
      layerCount = i + 1u;
      layersStopLight = true;
    }
  }
}

// The t, at most tMax, up to which further layers are wanted. The driver's BVH yields opaque surfaces among the layers,
// so that the last layer may lie behind one.
float LayersEnd(const float tMax)
{
  return layerCount == layerLimit || layersStopLight ? min(tMax, LayerAt(layerCount - 1u).t) : tMax;
}

// Adds the glyph's crossings in [tMin, tMax]; returns up to where others are still wanted.
float AddLayersOf(const uint record, const GlyphSetRecord set, const GlyphRay ray, const uint number, const Glyph glyph,
  float tMin, float tMax)
{
  float t;
  vec3 normal;
  uint triangle;
  uint most = ((uint(RTG_CONVEX_SHAPES) >> set.shape) & 1u) != 0u ? 2u : maximumPasses;
  for (uint crossing = 0u; crossing < most && Intersect(set, ray, glyph, tMin, tMax, false, false, t, normal, triangle);
       ++crossing)
  {
    float error = ErrorOfT(set, ray, glyph, t);
    float opacity = 0.0;
    if (CountsLight() && !Has(set.variants, MESH_TREE))
    {
      opacity = Has(set.variants, END_COLORS) ? ColorBetweenEnds(set, ray, glyph, number, t).a : OpacityOf(set, number);
    }
    AddLayer(GlyphCrossing(record, number, triangle, t, normal), error, 1.0 - opacity);
    tMax = LayersEnd(tMax);
    tMin = t + error;
  }
  return tMax;
}

// Intersects a candidate exactly. A crossing nearer than `hit` becomes the hit; with `any` whichever is found first.
// With `gathers` all crossings nearer than it are added to the layers instead, as many as are wanted, and hit.t is up
// to where others still are. False: the hit stays.
bool IntersectCandidate(const uint record, const GlyphSetRecord set, const GlyphRay ray, const uint number,
  const Glyph glyph, const uint seed, const float tMin, const bool any, const bool gathers, inout GlyphCrossing hit)
{
  if (layered && gathers)
  {
    hit.t = AddLayersOf(record, set, ray, number, glyph, tMin, hit.t);
    return true;
  }
  float t;
  vec3 normal;
  uint triangle;
  bool met = IntersectStopping(set, ray, number, glyph, seed, tMin, hit.t, any, !any, t, normal, triangle);
  if (met)
  {
    hit = GlyphCrossing(record, number, triangle, t, normal);
  }
  return met;
}
