// Translucent surfaces along a camera ray, front to back: what each lets through lights what the eye sees of the next.
// That is how depth peeling composites them, and what path tracing, which stops at each by chance, shows in the mean.
layout(constant_id = 38) const bool layered = false; // the image is that of translucent sets: opaque ones only hide

// More are left out, and so is what shines through by less than half a level of a display's 255.
const uint maximumLayers = 256u;
const float leastPassing = 1.0 / 512.0;

struct Layers
{
  SceneRay ray;
  float tMin;    // from where the next one is sought
  float passing; // share of the light from there that reaches the eye
#ifdef RTG_WHOLE
  uint next; // in the list
#endif
};

Layers BeginLayers(DoubleWord3 origin, vec3 direction)
{
  Layers layers;
  layers.ray = EnterScene(origin, direction);
  layers.tMin = max(frame.nearDepth - layers.ray.start, 0.0);
  layers.passing = 1.0;
#ifdef RTG_WHOLE
  layerCount = layerLimit = layers.next = 0u;
#endif
  return layers;
}

#ifdef RTG_WHOLE
// Layers of the set's own opacity after which nothing shows.
uint LayersThatShow(GlyphSetRecord set)
{
  if (coloured || set.opacity <= 0.0)
  {
    return layerCapacity;
  }
  float count = log(leastPassing) / log(1.0 - min(set.opacity, 0.999));
  return uint(clamp(ceil(count + 0.01), 1.0, float(layerCapacity)));
}

// The next one of the list, which is filled in one traversal.
SurfaceHit NextOfList(inout Layers layers)
{
  GlyphSetRecord set = SetRecord(0u);
  GlyphSource source = SourceOf(set);
  float tMax = frame.farDepth - layers.ray.start;
  // A list that was not full was the last.
  if (layers.next == layerCount && layers.next == layerLimit && layers.tMin <= tMax && IsSeen(set, frame.cullMask))
  {
    layerLimit = LayersThatShow(set);
    layerCount = layers.next = 0u;
    Traverse(set, source, QueryOf(set, layers.ray, layers.tMin, tMax, false, 0u), true);
  }
  if (layers.next == layerCount)
  {
    return NoHit();
  }
  GlyphRay ray = GlyphRay(layers.ray.origin.hi, layers.ray.origin.lo, layers.ray.direction);
  uint at = layers.next++;
  return HitOnGlyph(0u, set, source, ray, unpack32(layer[at]).x, LayerT(at), 0u);
}
#endif

// Finds the next layer; false: there is none.
bool NextLayer(inout Layers layers, out SurfaceHit hit)
{
  hit = NoHit();
  if (layers.passing < leastPassing)
  {
    return false;
  }
  float tMax = frame.farDepth - layers.ray.start;
#ifdef RTG_WHOLE
  if (layered)
  {
    hit = NextOfList(layers);
  }
  else
  {
    hit = Intersect(layers.ray, layers.tMin, tMax, frame.cullMask, 0u);
  }
#else
  hit = Intersect(layers.ray, layers.tMin, tMax, layered ? frame.cullMask | OPAQUE_MASK : frame.cullMask, 0u);
#endif
  if (hit.t < 0.0 || (layered && SetRecord(hit.record).translucent == 0u))
  {
    return false;
  }
  if (layered)
  {
    layers.tMin = hit.t + ErrorOfT(layers.ray, hit);
  }
  return true;
}

// How much the layer weighs in the pixel.
float WeightOfLayer(inout Layers layers, SurfaceHit hit)
{
  float weight = layers.passing * hit.colour.a;
  layers.passing -= weight;
  return weight;
}
