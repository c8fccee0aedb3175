#version 460
#extension GL_GOOGLE_include_directive : require
// Local shading: the view's lights, nothing in between; rays through a box filter.
#include "bindings.glsl"
#include "trace.glsl"
#include "pixel.glsl"
#include "layers.glsl"
#include "../Shading/Local.glsl"

void main()
{
  uvec2 position;
  if (!LaunchPixel(gl_GlobalInvocationID.xy, position))
  {
    return;
  }
  Pixel pixel = BeginPixel(position);
  for (uint s = frame.firstSample; s < frame.firstSample + frame.samples; ++s)
  {
    SampleNumber number = SampleNumber(position, s);
    OpenShutter(number);
    // The same pattern for all pixels: without light from other glyphs there is no noise to spread.
    DoubleWord3 origin;
    vec3 direction;
    CameraRay(number, PixelSample(moves ? PlaceAmongTimes(s) : s), origin, direction);
    Layers layers = BeginLayers(origin, direction);
    bool more;
    do
    {
      SurfaceHit hit = Trace(LayerQuery(layers), layered);
      more = NextLayer(layers, pixel, hit);
      if (more)
      {
        float depth = hit.t + layers.ray.start;
        if (layers.count == 1u)
        {
          Identify(pixel, number, hit, depth);
        }
        float weight = WeightOfLayer(layers, hit);
        AddToPixel(pixel, weight * ShadeLocal(hit, origin.hi + depth * direction, direction, AmbientOf(hit)), weight);
        more = MoreLayers(layers);
      }
    } while (more);
  }
  EndPixel(position, pixel, false);
}
