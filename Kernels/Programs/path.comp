#version 460
#extension GL_GOOGLE_include_directive : require
// Path tracing: light followed back from the eye through up to maximumBounces scatterings, to the environment that
// surrounds everything and to the view's lights. Each sample follows several paths from what its camera ray hits.
#include "bindings.glsl"
#include "trace.glsl"
#include "pixel.glsl"
#include "../Shading/Lights.glsl"
#include "../Shading/Principled.glsl"
#include "../Shading/Environment.glsl"
#include "../Shading/Reflection.glsl"
#include "../Shading/Ground.glsl"

// The sample dimension of environment rays: beyond those of all bounces.
const uint eventEnvironment = 0x400000u;

// With uniform environment light and no other, the reflected light of a surface can be estimated, and
// Russian roulette may end a path from its second hit on; else from its third.
bool Guessing()
{
  return !environmentImage && frame.lightCount == 0u;
}

// Estimated fraction of occluded directions about a hit: of 0.5 to 0.8 the least error at
// equal time in the scenes of LightBenchmark. It changes no mean.
const float guessedOcclusion = 0.65;

// Roulette lets a path go on at least this often: dark surfaces may shine.
const float leastSurvival = 0.25;

Surface SurfaceOfHit(const SurfaceHit hit)
{
  GlyphSetRecord set = SetRecord(hit.record);
  vec3 base = set.diffuse * DisplayToLinear(hit.color.rgb);
  // Burley's range: Specular 0.5 is the usual dielectric of refractive index 1.5.
  return Surface(base * AlbedoScale(hit, base), set.metallic, set.roughness, 0.08 * set.specular,
    DisplayToLinear(set.specularColor), set.coatStrength, set.coatRoughness, set.coatReflectance,
    DisplayToLinear(set.coatColor));
}

// The ground's, which sends back all light evenly.
Surface GroundSurface()
{
  return Surface(vec3(1.0), 0.0, 0.0, 0.0, vec3(0.0), 0.0, 0.0, 0.0, vec3(0.0));
}

vec3 EvaluateAt(const bool onGround, const Surface surface, const vec3 from, const vec3 to, const ScatterNumbers u)
{
  return ground && onGround ? vec3(to.z / scatterPi) : Evaluate(surface, from, to, u);
}

// The numbers that decide one scattering; those that the surface does not need are not drawn.
ScatterNumbers DrawNumbers(const Surface surface, const SampleNumber number, const uint bounce)
{
  vec2 direction = SamplePair(number, PairOf(bounce, pairDirection));
  ScatterNumbers u = ScatterNumbers(direction, vec2(0.0, 1.0), vec2(0.0), vec2(0.0), vec2(0.0));
  if (surface.coat > 0.0)
  {
    u.coatFacet = SamplePair(number, PairOf(bounce, pairCoatFacet));
  }
  if (surface.coat > 0.0 || surface.metallic > 0.0)
  {
    u.lobe = SamplePair(number, PairOf(bounce, pairLobe));
  }
  if (surface.metallic > 0.0 || surface.reflectance > 0.0)
  {
    u.facet = SamplePair(number, PairOf(bounce, pairFacet));
    u.chance = SamplePair(number, PairOf(bounce, pairChance));
  }
  return u;
}

// Russian roulette at a hit that a path has come to along `direction` after `bounce` scatterings. A path that ends
// brings, instead of nothing, a guess of what the surface reflects, and the others only the rest: the nearer the guess,
// the less noise. In the manner of Szirmay-Kalos, Antal and Sbert, "Variance Based Go with the Winner Strategy in Path
// Tracing", WSCG 2005. The guess: a surface of albedo a, of whose surroundings a fraction o is covered by others like
// it, reflects r = a (1 - o + o r).
bool Survives(const SampleNumber number, const uint bounce, const Surface surface, const SurfaceHit hit,
  const vec3 direction, inout vec3 throughput, inout vec3 radiance)
{
  // One exit: LLVM 21 loses the guess of some lanes otherwise.
  bool survives = true;
  if (bounce >= (Guessing() ? 1u : 2u))
  {
    vec3 albedo = AlbedoSeen(surface, dot(normalize(direction), hit.shadingNormal));
    float strongest = max(throughput.x, max(throughput.y, throughput.z));
    float survival = strongest * max(max(albedo.x, albedo.y), max(albedo.z, leastSurvival));
    if (survival < 1.0)
    {
      vec3 guess = Guessing()
        ? throughput * frame.environment * albedo * (1.0 - guessedOcclusion) / (1.0 - guessedOcclusion * albedo)
        : vec3(0.0);
      radiance += guess;
      survives = SamplePair(number, PairOf(bounce, pairLight)).y < survival;
      if (survives)
      {
        throughput /= survival;
        radiance -= guess / survival;
      }
    }
  }
  return survives;
}

// From an unoccluded direction without a sampled light.
vec3 LightFrom(const vec3 direction)
{
  return environmentImage ? ClampedEnvironment(direction) : SkyRadiance(direction);
}

// Unoccluded light on the ground.
vec3 GroundLight(const SceneRay ray, const SurfaceHit hit)
{
  vec3 position = LeaveGround(ray, hit).hi;
  vec3 light = frame.groundSky;
  for (uint i = 0u; i < frame.lightCount; ++i)
  {
    Incidence at = ArriveAt(frame.lights.at[i], position);
    light += frame.lights.at[i].color * (at.attenuation * max(dot(hit.normal, -at.direction), 0.0));
  }
  return light;
}

// Light that a surface reflects unless it is occluded.
struct DirectLight
{
  vec3 radiance; // zero: no shadow ray is needed
  vec3 direction;
  float distance;
  uint seed; // of the ray toward it
};

DirectLight NoLight()
{
  return DirectLight(vec3(0.0), vec3(0.0), 0.0, 0u);
}

// Reflected light at `origin` from one of the view's lights, as if it were all of them; `x`, `y` and `normal`:
// its frame, in which `from` points back along the path.
DirectLight FromLights(const bool onGround, const DoubleWord3 origin, const Surface surface, const vec3 x, const vec3 y,
  const vec3 normal, const vec3 from, const ScatterNumbers u, const SampleNumber number, const uint bounce)
{
  DirectLight direct = NoLight();
  if (frame.lightCount > 0u)
  {
    float pick = frame.lightCount > 1u ? SamplePair(number, PairOf(bounce, pairLight)).x : 0.0;
    LightRecord light = frame.lights.at[min(uint(pick * float(frame.lightCount)), frame.lightCount - 1u)];
    Incidence incidence = ArriveAt(light, origin.hi);
    float distance;
    vec2 place = incidence.spread > 0.0 ? SamplePair(number, PairOf(bounce, pairToLight)) : vec2(0.0);
    vec3 toLight = SampleLight(light, incidence, place, distance);
    vec3 to = vec3(dot(toLight, x), dot(toLight, y), dot(toLight, normal));
    if (incidence.attenuation > 0.0 && to.z > 0.0)
    {
      // vtkLight's colors are what a white surface facing the light shows, hence pi.
      vec3 radiance = EvaluateAt(onGround, surface, from, to, u) * light.color *
        (scatterPi * incidence.attenuation * float(frame.lightCount));
      direct = DirectLight(radiance, toLight, distance, SeedOf(number, 2u * bounce + 1u));
    }
  }
  return direct;
}

// The same for a sampled direction of the environment.
DirectLight FromEnvironment(const bool onGround, const Surface surface, const vec3 x, const vec3 y, const vec3 normal,
  const vec3 from, const ScatterNumbers u, const SampleNumber number, const uint bounce)
{
  DirectLight direct = NoLight();
  if (environmentImage && frame.environmentCellColumns > 0u)
  {
    vec3 toLight;
    vec3 light = SampleEnvironment(
      SamplePair(number, PairOf(bounce, pairToLight)), SamplePair(number, PairOf(bounce, pairToLight) + 1u), toLight);
    vec3 to = vec3(dot(toLight, x), dot(toLight, y), dot(toLight, normal));
    if (to.z > 0.0 && light.x + light.y + light.z > 0.0)
    {
      direct = DirectLight(
        EvaluateAt(onGround, surface, from, to, u) * light, toLight, 1e38, SeedOf(number, eventEnvironment + bounce));
    }
  }
  return direct;
}

void main()
{
  uvec2 position;
  if (!LaunchPixel(gl_GlobalInvocationID.xy, position))
  {
    return;
  }
  Pixel pixel = BeginPixel(position);
  // Opaque surfaces hide translucent ones behind them, also where only those are shown.
  const uint cameraMask = translucency ? frame.cullMask | OPAQUE_MASK : frame.cullMask;

  SampleNumber number;
  uint path, bounce = 0u;
  DoubleWord3 origin;
  vec3 direction, throughput, radiance;
  // The hit of the sample's camera ray, from where its paths start.
  SurfaceHit first = NoHit();
  DoubleWord3 start;
  vec3 firstDirection;

  // The ground, and what something keeps from it.
  bool onGround = false;
  vec3 all, missing;

  // Light whose shadow ray is still to be traced.
  DirectLight fromLights = NoLight(), fromEnvironment = NoLight();

  // One ray an iteration, of any kind: lanes whose path has ended go on with the next one instead of waiting for the
  // others (Novak, Havran and Dachsbacher, "Path Regeneration for Interactive Path Tracing", Eurographics 2010), and
  // the traversal is in the program once.
  for (uint s = frame.firstSample; s < frame.firstSample + frame.samples;)
  {
    bool asksLights = fromLights.radiance != vec3(0.0);
    bool shadow = asksLights || fromEnvironment.radiance != vec3(0.0);
    bool camera = bounce == 0u;
    if (camera)
    {
      number = SampleNumber(position, s);
      OpenShutter(number);
      CameraRay(number, PixelPosition(number), origin, direction);
      radiance = vec3(0.0);
      throughput = vec3(1.0);
      path = 0u;
    }
    SceneRay ray = EnterScene(origin, direction);
    Query query =
      Query(ray, camera ? max(frame.nearDepth - ray.start, 0.0) : 0.0, camera ? frame.farDepth - ray.start : 1e38,
        camera ? cameraMask : ANY_MASK, translucency ? SeedOf(number, 2u * bounce) : 0u, false);
    if (shadow)
    {
      DirectLight direct = asksLights ? fromLights : fromEnvironment;
      query = ShadowQuery(origin, direct.direction, direct.distance, direct.seed);
    }

    SurfaceHit hit = Trace(query, false);

    if (shadow)
    {
      vec3 arrived = asksLights ? fromLights.radiance : fromEnvironment.radiance;
      bool free = hit.t < 0.0;
      radiance += free ? arrived : vec3(0.0);
      missing += free ? vec3(0.0) : arrived;
      fromLights.radiance = asksLights ? vec3(0.0) : fromLights.radiance;
      fromEnvironment.radiance = asksLights ? fromEnvironment.radiance : vec3(0.0);
      continue;
    }
    bool onward = hit.t >= 0.0;
    if (camera)
    {
      if (translucency && onward && IsInOtherImage(hit.record))
      {
        onward = ShowsToo(pixel, hit.t + ray.start);
      }
      if (onward)
      {
        float depth = hit.t + ray.start;
        Identify(pixel, number, hit, depth);
        pixel.opacity = Add(pixel.opacity, 1.0);
      }
      onGround = ground && hit.t < 0.0 && IntersectGround(ray, hit);
      if (onGround)
      {
        missing = vec3(0.0);
        all = GroundLight(ray, hit);
        onward = true;
      }
    }
    else if (onGround)
    {
      missing += onward ? LightFrom(direction) : vec3(0.0);
      onward = false;
    }
    else if (!onward)
    {
      radiance += throughput * LightFrom(direction);
    }

    Surface surface;
    if (onward && !onGround)
    {
      // Once for all paths of the sample.
      radiance += throughput * EmissionOfHit(hit) * (camera ? float(frame.raysPerSample) : 1.0);
      onward = bounce < frame.maximumBounces && SetRecord(hit.record).lighting != 0u;
    }
    if (onward && onGround)
    {
      surface = GroundSurface();
      origin = LeaveGround(ray, hit);
    }
    else if (onward)
    {
      surface = SurfaceOfHit(hit);
      onward = Survives(number, bounce, surface, hit, direction, throughput, radiance);
      FaceForward(hit, direction);
      origin = LeaveSurface(ray, hit);
    }
    if (onward && camera)
    {
      first = hit;
      start = origin;
      firstDirection = direction;
      number.index = s * frame.raysPerSample;
    }
    else if (!onward && !camera && path + 1u < frame.raysPerSample)
    {
      // The sample's next path.
      ++path;
      bounce = 0u;
      number.index = s * frame.raysPerSample + path;
      throughput = vec3(1.0);
      hit = first;
      origin = start;
      direction = firstDirection;
      surface = onGround ? GroundSurface() : SurfaceOfHit(hit);
      onward = true;
    }

    if (!onward)
    {
      if (onGround)
      {
        pixel.missing += MissingShare(missing / float(frame.raysPerSample), all);
        onGround = false;
      }
      else
      {
        AddToPixel(pixel, radiance / float(frame.raysPerSample), 0.0);
      }
      bounce = 0u;
      ++s;
      continue;
    }
    // The directions about the surface.
    ScatterNumbers u = DrawNumbers(surface, number, bounce);
    vec3 normal = hit.shadingNormal;
    vec3 x, y;
    Tangents(normal, x, y);
    vec3 back = -normalize(direction);
    vec3 from = normalize(vec3(dot(back, x), dot(back, y), max(dot(back, normal), 1e-4)));
    fromLights = FromLights(onGround, origin, surface, x, y, normal, from, u, number, bounce);
    fromLights.radiance *= throughput;
    fromEnvironment = FromEnvironment(onGround, surface, x, y, normal, from, u, number, bounce);
    fromEnvironment.radiance *= throughput;
    vec3 to;
    if (ground && onGround)
    {
      to = CosineDirection(u.direction);
    }
    else
    {
      throughput *= Scatter(surface, from, u, to);
    }
    direction = OutOfSurface(hit, FromFrame(to, x, y, normal));
    ++bounce;
  }
  if (ground)
  {
    pixel.behind = GroundDepth(position);
  }
  EndPixel(position, pixel, true);
}
