// Translucent surfaces along a camera ray, front to back: what each lets through lights what the eye sees of the next. That is
// how depth peeling composites them, and what path tracing, which stops at each by chance, shows in the mean.
layout(constant_id = 38) const bool layered = false;  // the image is that of translucent sets: opaque ones only hide

// More are left out, and so is what shines through by less than half a level of a display's 255.
const uint maximumLayers = 256u;
const float leastPassing = 1.0 / 512.0;

struct Layers
{
  SceneRay ray;
  float tMin;     // from where the next one is sought
  float passing;  // share of the light from there that reaches the eye
};

Layers BeginLayers(DoubleWord3 origin, vec3 direction)
{
  SceneRay ray = EnterScene(origin, direction);
  return Layers(ray, max(frame.nearDepth - ray.start, 0.0), 1.0);
}

// Finds the next layer; false: there is none.
bool NextLayer(inout Layers layers, out SurfaceHit hit)
{
  hit = NoHit();
  if (layers.passing < leastPassing)
  {
    return false;
  }
  hit = Intersect(layers.ray, layers.tMin, frame.farDepth - layers.ray.start,
    layered ? frame.cullMask | OPAQUE_MASK : frame.cullMask);
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
