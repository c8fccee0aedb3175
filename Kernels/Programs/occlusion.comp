#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient occlusion: a surface reflects what reaches it of the sky's light, and a part of it is lit by the view's
// lights. Each sample traces occlusion rays, with a density in proportion to the cosine. After
// Zellmann et al., "High-Quality Rendering of Glyphs Using Hardware-Accelerated Ray Tracing", EGPGV 2020, who darken
// all light; that makes clutter black.
// With `shadows` each sample traces a shadow ray for each light that casts shadows. Local shading
// with shadows is this program without `sky`: lights add up as display colors then.
#include "bindings.glsl"
#include "trace.glsl"
#include "pixel.glsl"
#include "layers.glsl"
#include "../Shading/Local.glsl"
#include "../Shading/Reflection.glsl"
#include "../Shading/Ground.glsl"

// The numbers of the rays toward lights: beyond those of all layers.
const uint eventLight = 0x400000u;

// Light of the view's lights as this program adds it up.
vec3 Linear(const vec3 shown)
{
  return sky ? DisplayToLinear(shown) : shown;
}

// A surface whose lights are sampled one after the other.
struct DirectLighting
{
  uint light; // the next; frame.lightCount: none is left
  LocalLight sum;
  vec3 position;
  vec3 normal;
  vec3 toViewer;
  float power;
  // The direction to a point of it.
  vec3 toLight;
  float distance;
};

DirectLighting BeginLighting(const vec3 position, const vec3 normal, const vec3 toViewer, const float power)
{
  return DirectLighting(0u, LocalLight(vec3(0.0), vec3(0.0)), position, normal, toViewer, power, vec3(0.0), 0.0);
}

// Adds lights that cast no shadows here, up to the first that may.
void NextLight(inout DirectLighting direct, const vec2 u)
{
  bool found = false;
  while (direct.light < frame.lightCount && !found)
  {
    LightRecord light = LightAt(direct.light);
    Incidence at = ArriveAt(light, direct.position);
    found = light.casts != 0u && at.attenuation * dot(direct.normal, -at.direction) > 0.0;
    if (found)
    {
      direct.toLight = SampleLight(light, at, u, direct.distance);
    }
    else
    {
      AddLight(direct.sum, light, at, direct.normal, direct.toViewer, direct.power);
      ++direct.light;
    }
  }
}

// Adds the light of the last shadow ray.
void AddSampledLight(inout DirectLighting direct)
{
  LightRecord light = LightAt(direct.light);
  AddLight(direct.sum, light, ArriveAt(light, direct.position), direct.normal, direct.toViewer, direct.power);
}

// How many rays a layer is worth, a power of two where it is not worth all of them: as many as it has of the pixel, so
// that all layers together are no noisier than one that is opaque.
uint RaysOfWeight(const float weight)
{
  uint wanted = max(uint(ceil(weight * float(frame.raysPerSample))), 1u);
  return min(wanted > 1u ? 2u << findMSB(wanted - 1u) : 1u, frame.raysPerSample);
}

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
  // The current layer, and how many of its occlusion rays are still to be traced.
  SurfaceHit hit = NoHit();
  vec3 color, reflected, x, y; // `reflected`: of the sky's light
  DoubleWord3 start;
  uint rays, left = 0u;
  vec3 arrived; // of the sky's light
  float weight;
  // Of its lights: what they bring is shown times `lightScale`.
  DirectLighting direct;
  direct.light = frame.lightCount;
  bool adds = false;
  vec3 ambient;
  float lightScale;
  // The ground: its light, and what something keeps from it.
  bool onGround = false;
  vec3 all, missing;

  // One ray an iteration, of any kind: lanes of a CPU device that have no occlusion rays to trace go on with the next
  // sample instead of waiting for the others, and the traversal is in the program once.
  for (uint s = frame.firstSample; s < frame.firstSample + frame.samples;)
  {
    Query query;
    bool tracesShadow = shadows && direct.light < frame.lightCount;
    bool tracesOcclusion = !tracesShadow && left > 0u;
    if (tracesShadow)
    {
      query = ShadowQuery(start, OutOfSurface(hit, direct.toLight), direct.distance,
        SeedOf(number, eventLight + maximumLayers * direct.light + layers.count));
    }
    else if (tracesOcclusion)
    {
      uint layer = layers.count - (onGround ? 0u : 1u);
      // Those of one sample follow each other in the sequence: a power of two of them is spread evenly.
      SampleNumber own = SampleNumber(position, (s + 1u) * rays - left);
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

    SurfaceHit found = Trace(query, layered && !tracesShadow && !tracesOcclusion);

    if (tracesShadow)
    {
      if (found.t < 0.0)
      {
        AddSampledLight(direct);
      }
      ++direct.light;
    }
    else if (tracesOcclusion)
    {
      vec3 light = SkyRadiance(query.ray.direction);
      arrived += found.t < 0.0 ? light : vec3(0.0);
      missing += found.t < 0.0 ? vec3(0.0) : light * ((1.0 - frame.lightFraction) / float(rays));
      --left;
      if (left == 0u)
      {
        color += reflected * (arrived / float(rays));
      }
    }
    else if (NextLayer(layers, pixel, found))
    {
      hit = found;
      vec3 direction = layers.ray.direction;
      float depth = hit.t + layers.ray.start;
      if (layers.count == 1u)
      {
        Identify(pixel, number, hit, depth);
      }
      ambient = sky ? vec3(0.0) : AmbientOf(hit);
      color = sky ? EmissionOfHit(hit) : vec3(0.0);
      weight = WeightOfLayer(layers, hit);
      GlyphSetRecord set = SetRecord(hit.record);
      if (set.lighting != 0u)
      {
        vec3 albedo = set.diffuse * DisplayToLinear(hit.color.rgb);
        float scale = AlbedoScale(hit, albedo);
        lightScale = sky ? frame.lightFraction * scale : 1.0;
        vec3 place = layers.ray.origin.hi + hit.t * direction;
        if (shadows)
        {
          direct =
            BeginLighting(place, LitNormal(hit, direction), normalize(frame.viewPosition - place), set.specularPower);
          adds = true;
        }
        else
        {
          color += lightScale * Linear(ShadeLocal(hit, place, direction, ambient));
        }
        reflected = ((1.0 - frame.lightFraction) * scale) * albedo;
        FaceForward(hit, direction);
        Tangents(hit.shadingNormal, x, y);
        start = LeaveSurface(layers.ray, hit);
        arrived = vec3(0.0);
        rays = RaysOfWeight(weight);
        left = sky ? rays : 0u;
      }
      else if (!sky)
      {
        color = ShadeLocal(hit, vec3(0.0), direction, ambient);
      }
    }
    else
    {
      begins = true;
      weight = 0.0;
      color = vec3(0.0);
      onGround = ground && IntersectGround(layers.ray, hit);
      if (onGround)
      {
        start = LeaveGround(layers.ray, hit);
        Tangents(hit.normal, x, y);
        direct = BeginLighting(start.hi, hit.normal, hit.normal, 0.0);
        adds = shadows;
        lightScale = sky ? frame.lightFraction : groundLights;
        LocalLight full = LocalLight(vec3(0.0), vec3(0.0));
        for (uint i = 0u; i < frame.lightCount; ++i)
        {
          LightRecord light = LightAt(i);
          AddLight(full, light, ArriveAt(light, start.hi), hit.normal, hit.normal, 0.0);
        }
        all = lightScale * Linear(clamp(full.diffuse, 0.0, 1.0));
        missing = shadows ? all : vec3(0.0);
        all += sky ? (1.0 - frame.lightFraction) * frame.groundSky : all * (1.0 / groundLights - 1.0);
        reflected = arrived = vec3(0.0);
        rays = frame.raysPerSample;
        left = sky ? rays : 0u;
      }
    }

    if (shadows)
    {
      if (direct.light < frame.lightCount)
      {
        NextLight(direct, SamplePair(number, PairOf(layers.count, pairToLight)));
      }
      if (adds && direct.light == frame.lightCount)
      {
        adds = false;
        if (onGround)
        {
          missing -= lightScale * Linear(clamp(direct.sum.diffuse, 0.0, 1.0));
        }
        else
        {
          GlyphSetRecord set = SetRecord(hit.record);
          color += lightScale * Linear(ReflectLocal(set, hit.color.rgb, ambient, direct.sum));
        }
      }
    }
    if (left == 0u && !adds)
    {
      if (onGround)
      {
        pixel.missing += layers.transmittance * MissingShare(missing, all);
        onGround = false;
      }
      AddToPixel(pixel, weight * color, weight);
      begins = begins || !MoreLayers(layers);
      s += begins ? 1u : 0u;
    }
  }
  if (ground)
  {
    pixel.behind = GroundDepth(position);
  }
  EndPixel(position, pixel, sky);
}
