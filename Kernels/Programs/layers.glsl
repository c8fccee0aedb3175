// Translucent surfaces along a camera ray, front to back: what each lets through lights what the eye sees of the next. That is
// how depth peeling composites them, and what path tracing, which stops at each by chance, shows in the mean.
layout(constant_id = 38) const bool layered = false;  // the image is that of translucent sets: opaque ones only hide

// More are left out, and so is what shines through by less than half a level of a display's 255.
const uint maximumLayers = 256u;
const float leastPassing = 1.0 / 512.0;

struct Layers
{
  float start;    // view depth from which the next one is sought
  float passing;  // share of the light from there that reaches the eye
};

Layers BeginLayers()
{
  return Layers(frame.nearDepth, 1.0);
}

// Traces the next layer into `hit`; false: there is none.
bool NextLayer(inout Layers layers, DoubleWord3 origin, vec3 direction)
{
  if (layers.passing < leastPassing)
  {
    return false;
  }
  TraceNearest(origin, direction, layers.start, frame.farDepth, layered ? frame.cullMask | OPAQUE_MASK : frame.cullMask);
  if (hit.t < 0.0 || (layered && SetRecord(hit.record).translucent == 0u))
  {
    return false;
  }
  if (layered)
  {
    layers.start = hit.t + HitUncertainty(direction);
  }
  return true;
}

// How much the layer in `hit` weighs in the pixel.
float WeightOfLayer(inout Layers layers)
{
  float weight = layers.passing * hit.colour.a;
  layers.passing -= weight;
  return weight;
}
