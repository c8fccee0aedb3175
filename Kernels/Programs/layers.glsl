// Translucent surfaces along a camera ray, front to back: what each lets through lights what the eye sees of the next.
// That is how depth peeling composites them, and what path tracing, which stops at each at random, shows on average.

// More are left out, and so is what lies behind a transmittance below MIN_TRANSMITTANCE.
const uint maximumLayers = 256u;

struct Layers
{
  SceneRay ray;
  float tMin;          // from where the next one is sought
  float transmittance; // from there to the eye
  uint count;          // that have been found
};

Layers BeginLayers(const DoubleWord3 origin, const vec3 direction)
{
  SceneRay ray = EnterScene(origin, direction);
  layerCount = layerLimit = layerNext = 0u;
  return Layers(ray, max(frame.nearDepth - ray.start, 0.0), 1.0, 0u);
}

// Traces on to the next layer.
Query LayerQuery(const Layers layers)
{
  return Query(layers.ray, layers.tMin, frame.farDepth - layers.ray.start,
    layered ? frame.cullMask | OPAQUE_MASK : frame.cullMask, 0u, false);
}

// Whether the answer is a layer that is shown. Behind translucent ones an opaque surface is none.
bool NextLayer(inout Layers layers, inout Pixel pixel, const SurfaceHit hit)
{
  bool next = hit.t >= 0.0;
  if (layered && next && IsInOtherImage(hit.record))
  {
    next = layers.count == 0u && ShowsToo(pixel, hit.t + layers.ray.start);
  }
  if (next)
  {
    ++layers.count;
    layers.tMin = layered ? hit.t + ErrorOfT(layers.ray, hit) : layers.tMin;
  }
  return next;
}

// Whether more of them would show.
bool MoreLayers(const Layers layers)
{
  return layered && layers.count < maximumLayers && layers.transmittance >= MIN_TRANSMITTANCE;
}

// The layer's weight in the pixel.
float WeightOfLayer(inout Layers layers, const SurfaceHit hit)
{
  float weight = layers.transmittance * hit.color.a;
  layers.transmittance -= weight;
  return weight;
}
