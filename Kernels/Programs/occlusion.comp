#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient occlusion: a surface reflects what reaches it of the sky's light, and a part of it is lit by the view's
// lights, which nothing is in the way of. Each sample looks for the sky in several directions, with a density in
// proportion to the cosine. After Zellmann et al., "High-Quality Rendering of Glyphs Using Hardware-Accelerated Ray
// Tracing", EGPGV 2020, who darken all light; that makes clutter black.
#include "bindings.glsl"
#include "trace.glsl"
#include "pixel.glsl"
#include "layers.glsl"
#include "../Shading/Frame.glsl"
#include "../Shading/Local.glsl"
#include "../Shading/Reflection.glsl"

void main()
{
  uvec2 position;
  if (!LaunchPixel(gl_GlobalInvocationID.xy, position))
  {
    return;
  }
  Pixel pixel = BeginPixel(position);

  SampleNumber number;
  Layers layers;
  bool begins = true; // a sample
  // The layer that is asked about, and how many of its rays are still to be traced.
  SurfaceHit hit = NoHit();
  vec3 colour, reflected, x, y; // `reflected`: of the sky's light
  DoubleWord3 start;
  uint left = 0u;
  vec3 sky;
  float weight;

  // One ray a turn, of whatever kind: lanes of a CPU device that have no occlusion rays to trace go on with the next
  // sample instead of waiting for the others, and the traversal is in the program once.
  for (uint s = frame.firstSample; s < frame.firstSample + frame.samples;)
  {
    Query query;
    if (left > 0u)
    {
      uint layer = layers.count - 1u;
      // Those of one sample follow each other in the sequence: a power of two of them is spread evenly.
      SampleNumber own = SampleNumber(position, (s + 1u) * frame.branches - left);
      vec3 to = CosineDirection(SamplePair(own, PairOf(layer, pairDirection)));
      vec3 towardsLight = OutOfSurface(hit, FromFrame(to, x, y, hit.shadingNormal));
      query = ShadowQuery(start, towardsLight, frame.occlusionRadius, SeedOf(own, layer));
    }
    else
    {
      if (begins)
      {
        number = SampleNumber(position, s);
        OpenShutter(number);
        DoubleWord3 origin;
        vec3 direction;
        CameraRay(number, PixelPosition(number), origin, direction);
        layers = BeginLayers(origin, direction);
        begins = false;
      }
      query = LayerQuery(layers);
    }

    SurfaceHit found = Trace(query, layered && left == 0u);

    if (left > 0u)
    {
      sky += found.t < 0.0 ? SkyRadiance(query.ray.direction) : vec3(0.0);
      --left;
      if (left == 0u)
      {
        colour += reflected * (sky / float(frame.branches));
      }
    }
    else if (TakeLayer(layers, found))
    {
      hit = found;
      vec3 direction = layers.ray.direction;
      float depth = hit.t + layers.ray.start;
      if (layers.count == 1u)
      {
        Identify(pixel, s, depth, hit.record, hit.glyph);
        AddFeatures(position, s, hit.shadingNormal, hit.colour.rgb, depth);
      }
      colour = EmissionOfHit(hit);
      weight = WeightOfLayer(layers, hit);
      if (SetRecord(hit.record).lighting != 0u)
      {
        vec3 albedo = SetRecord(hit.record).diffuse * DisplayToLinear(hit.colour.rgb);
        float scale = AlbedoScale(hit, albedo);
        vec3 lit = ShadeLocal(hit, layers.ray.origin.hi + hit.t * direction, direction, vec3(0.0));
        colour += (frame.lightFraction * scale) * DisplayToLinear(lit);
        reflected = ((1.0 - frame.lightFraction) * scale) * albedo;
        FaceForward(hit, direction);
        Tangents(hit.shadingNormal, x, y);
        start = LeaveSurface(layers.ray, hit);
        sky = vec3(0.0);
        left = frame.branches;
      }
    }
    else
    {
      begins = true;
      weight = 0.0;
      colour = vec3(0.0);
    }
    if (left == 0u)
    {
      AddToPixel(pixel, weight * colour, weight);
      begins = begins || !MoreLayers(layers);
      s += begins ? 1u : 0u;
    }
  }
  EndPixel(position, pixel, true);
}
