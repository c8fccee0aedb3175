#include "Frame.h"

#include "Tiles.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <sstream>

namespace rtg
{

namespace
{

constexpr std::uint32_t maxSide = 32768;       ///< of an image, in pixels; more than any OpenGL viewport
constexpr std::uint32_t maxSamples = 1u << 20; ///< a pixel
constexpr std::uint32_t maxParts = 1u << 20;   ///< of an image

// Samples of the whole image, over all calls.
std::uint32_t PlannedSamples(const TraceSettings& settings)
{
  return settings.plannedSamples ? settings.plannedSamples : settings.samples;
}

// Secondary rays per sample.
std::uint32_t RaysPerSample(const TraceSettings& settings)
{
  const auto rays = TraitsOf(settings).rays;
  return rays ? settings.*rays : 1;
}

// How many layers of a translucent set show on a ray.
std::uint32_t LayersThatShow(const device::GlyphSetRecord& record)
{
  if (record.colored || (record.variants & device::OPACITIES) || record.opacity <= 0.0f)
  {
    return device::LAYER_CAPACITY;
  }
  const float count = std::log(device::MIN_TRANSMITTANCE) / std::log1p(-std::min(record.opacity, 0.999f));
  return static_cast<std::uint32_t>(
    std::clamp(std::ceil(count + 0.01f), 1.0f, static_cast<float>(device::LAYER_CAPACITY)));
}

} // namespace

ShadingTraits TraitsOf(const TraceSettings& settings)
{
#define RTG_TRAITS(number, Name, program, ...) { __VA_ARGS__ },
  static constexpr ShadingTraits traits[] = { RTG_SHADINGS(RTG_TRAITS) };
#undef RTG_TRAITS
  ShadingTraits result = traits[static_cast<std::size_t>(settings.shading)];
  result.scatters |= settings.shadows;
  return result;
}

void Split(const glm::dvec3& exact, glm::vec3& high, glm::vec3& low)
{
  high = glm::vec3(exact);
  low = glm::vec3(exact - glm::dvec3(high));
}

void FillCamera(device::FrameRecord& frame, const Camera& camera, const glm::dvec3& origin)
{
  Split(camera.eye - origin, frame.eye, frame.eyeLow);
  frame.eyeRight = camera.eyeRight;
  frame.eyeUp = camera.eyeUp;
  frame.forward = camera.forward;
  frame.right = camera.right;
  frame.up = camera.up;
  frame.viewPosition = camera.position - origin;
  // Screen-space right cross up points at the viewer for both kinds of projection.
  const glm::dvec3 spanX = camera.parallel ? camera.eyeRight : camera.right;
  const glm::dvec3 spanY = camera.parallel ? camera.eyeUp : camera.up;
  const glm::dvec3 axis = glm::normalize(glm::cross(spanX, spanY));
  frame.viewAxis = glm::dot(axis, camera.forward) > 0 ? -axis : axis;
  frame.nearDepth = static_cast<float>(camera.nearDepth);
  frame.farDepth = static_cast<float>(camera.farDepth);
  frame.depthA = static_cast<float>(camera.depthA);
  frame.depthB = static_cast<float>(camera.depthB);
  frame.parallel = camera.parallel;
  frame.lensRadius = static_cast<float>(camera.lensRadius);
  frame.lensAtEye = static_cast<float>(camera.focusDepth / (camera.focusDepth - camera.lensDepth));
  frame.lensSlope = static_cast<float>(1.0 / (camera.focusDepth - camera.lensDepth));
  frame.lensX = glm::normalize(spanX);
  frame.lensY = glm::normalize(spanY);
}

std::vector<device::LightRecord> MakeLights(const std::vector<Light>& lights, const glm::dvec3& origin)
{
  std::vector<device::LightRecord> records;
  for (const Light& light : lights)
  {
    device::LightRecord record{};
    record.kind = static_cast<std::uint32_t>(light.kind);
    record.color = light.color;
    record.position = light.position - origin;
    record.direction = light.direction;
    record.attenuation = light.attenuation;
    record.cosCone = light.coneAngle < 90.0f ? std::cos(glm::radians(light.coneAngle)) : -2.0f;
    record.exponent = light.exponent;
    record.spread = light.kind == Light::Kind::Directional ? 1.0f - std::cos(glm::radians(light.angularRadius)) : 0.0f;
    record.radius = light.kind == Light::Kind::Positional ? light.radius : 0.0f;
    record.casts = light.castsShadow && light.kind != Light::Kind::Headlight;
    records.push_back(record);
  }
  return records;
}

void CheckSettings(const TraceSettings& settings)
{
  const auto check = [](const char* name, auto value, auto least, auto most)
  {
    if (!(value >= least && value <= most))
    {
      std::ostringstream message;
      message << "Ray Traced Glyphs: " << name << " is " << value << "; it must lie between " << least << " and "
              << most << ".";
      throw Error(message.str());
    }
  };
  check("the samples per pixel", settings.samples, 1u, maxSamples);
  check("the ambient occlusion radius", settings.occlusionRadius, 0.0f, FLT_MAX);
  check("the number of occlusion rays", settings.occlusionRays, 1u, 64u);
  check("the number of paths a sample", settings.paths, 1u, 64u);
  check("the maximum of bounces", settings.maximumBounces, 1u, 1000u);
  check("the light intensity", settings.lightIntensity, 0.0f, 1e30f);
  check("the slope of the sky's light", glm::length(settings.skySlope), 0.0f, 1.0001f);
  check("the lights' fraction", settings.lightFraction, 0.0f, 1.0f);
  check("the albedo limit", settings.albedoLimit, 1e-3f, 1.0f);
  check("the exposure", settings.exposure, -100.0f, 100.0f);
  const float groundNormal = glm::length(settings.groundNormal);
  check("the length of the ground's normal", groundNormal, groundNormal > 0.0f ? 0.999f : 0.0f, 1.001f);
  check("the ground's height", std::abs(settings.groundHeight), 0.0, double(FLT_MAX));
  check("the number of parts", settings.parts, 1u, maxParts);
  check("the part", settings.part, 0u, settings.parts - 1u);
  if (settings.parts > 1 && settings.features)
  {
    throw Error("Ray Traced Glyphs: features need the whole image, not a part of it.");
  }
  if (settings.width > maxSide || settings.height > maxSide)
  {
    throw Error("Ray Traced Glyphs: an image of " + std::to_string(settings.width) + " x " +
      std::to_string(settings.height) + " pixels is too large; make it smaller, at most " + std::to_string(maxSide) +
      " pixels a side.");
  }
}

bool MapsTones(const TraceSettings& settings)
{
  return TraitsOf(settings).linear || settings.exposure != 0.0f || settings.toneMapping != ToneMapping::None;
}

void FillSettings(device::FrameRecord& frame, const TraceSettings& settings, const glm::dvec3& origin)
{
  frame.width = settings.width;
  frame.height = settings.height;
  frame.environment = glm::vec3(settings.lightIntensity);
  frame.skySlope = settings.skySlope;
  frame.lightFraction = settings.lightFraction;
  frame.albedoLimit = settings.albedoLimit;
  frame.occlusionRadius = settings.occlusionRadius > 0.0f ? settings.occlusionRadius : 1e38f;
  frame.raysPerSample = RaysPerSample(settings);
  frame.groundNormal = settings.groundNormal;
  frame.groundHeight = static_cast<float>(settings.groundHeight - glm::dot(glm::dvec3(settings.groundNormal), origin));
  // The mean of 1 + s.d about a normal n, by the cosine, is 1 + 2/3 s.n.
  frame.groundSky = frame.environment * (1.0f + 2.0f / 3.0f * glm::dot(settings.skySlope, settings.groundNormal));
  frame.maximumBounces = settings.maximumBounces;
  frame.mapsTones = MapsTones(settings);
  frame.exposureFactor = std::exp2(settings.exposure);
  frame.toneMapping = static_cast<std::uint32_t>(settings.toneMapping);
}

void FillConstants(Constants& constants, const SceneRecords& scene)
{
  constants.alone = scene.sets.size() == 1;
  constants.rayQueries = !scene.topLevels.empty();
  constants.inAllSets = ~device::RUN_TIME_FEATURES;
  constants.inSomeSets = device::RUN_TIME_FEATURES;
  for (const device::GlyphSetRecord& record : scene.sets)
  {
    constants.shapes |= 1u << record.shape;
    constants.inAllSets &= record.variants;
    constants.inSomeSets |= record.variants;
    constants.degree = std::max(constants.degree, record.polynomialDegree);
  }
  constants.moves = Variants{ constants.inSomeSets }.Moves();
}

// Features that a mode does not use need no program of their own.
Specialization
SpecializationFor(const SceneRecords& scene, std::size_t lights, const TraceSettings& settings, Pass pass)
{
  Specialization specialization;
  const ShadingTraits traits = TraitsOf(settings);
  Constants& constants = specialization.constants;
  FillConstants(constants, scene);
  const bool translucent = std::any_of(
    scene.sets.begin(), scene.sets.end(), [](const device::GlyphSetRecord& record) { return record.translucent != 0; });
  constants.shadows = settings.shadows && traits.withShadows;
  specialization.program = static_cast<std::uint32_t>(constants.shadows ? *traits.withShadows : settings.shading);
  constants.sky = traits.linear;
  constants.independentSamples = settings.independentSamples && (traits.scatters || constants.moves);
  constants.gathersFeatures = settings.features;
  constants.environmentImage = settings.environmentImage && traits.environmentImage;
  constants.ground = traits.scatters && settings.groundNormal != glm::vec3(0.0f);
  constants.manyLights = lights > device::FEW_LIGHTS;
  constants.layered = pass == Pass::Translucent && traits.layers;
  constants.translucency = traits.scatters && translucent;
  constants.leavesSurface = traits.scatters || constants.layered;
  return specialization;
}

void FillScene(device::FrameRecord& frame, const SceneRecords& scene)
{
  frame.sets = scene.buffer.Address();
  frame.setCount = static_cast<std::uint32_t>(scene.sets.size());
  frame.onlySet = scene.sets.front();
  frame.topLevels = scene.topLevelAddresses.Address();
  frame.topLevelCount = static_cast<std::uint32_t>(scene.topLevels.size());
  frame.sceneLower = scene.sets.front().lower;
  frame.sceneUpper = scene.sets.front().upper;
  frame.layerLimit = 1;
  for (const device::GlyphSetRecord& record : scene.sets)
  {
    frame.sceneLower = glm::min(frame.sceneLower, record.lower);
    frame.sceneUpper = glm::max(frame.sceneUpper, record.upper);
    frame.layerLimit = std::max(frame.layerLimit, record.translucent ? LayersThatShow(record) : 1);
  }
}

std::uint32_t SamplesAtOnce(const TraceSettings& settings, std::size_t pixels)
{
  const std::size_t cameraRays = std::size_t(1) << TraitsOf(settings).atOnce;
  return static_cast<std::uint32_t>(std::max<std::size_t>(1, cameraRays / (pixels * RaysPerSample(settings))));
}

std::uint32_t SamplesAtFirst(const TraceSettings& settings)
{
  constexpr std::uint32_t cameraRays = 32; // of one thread
  return std::max(1u, cameraRays / RaysPerSample(settings));
}

std::uint32_t SharedTimeBits(const TraceSettings& settings, std::uint32_t sliceBits)
{
  const std::uint32_t planned = PlannedSamples(settings);
  std::uint32_t bits = 0;
  // Parts of different numbers of samples would be seen longer or shorter, by all pixels alike.
  while (bits < sliceBits && planned % (2u << bits) == 0)
  {
    ++bits;
  }
  return bits;
}

void FillTimeStrata(device::FrameRecord& frame, const TraceSettings& settings)
{
  constexpr std::uint32_t most = 65536;
  constexpr double goldenSection = 0.6180339887498949;
  const bool stratified = !TraitsOf(settings).scatters && !settings.independentSamples;
  const std::uint32_t planned = std::min(PlannedSamples(settings), most);
  frame.timeStrata = stratified && planned > 1 ? planned : 0;
  frame.timeStep = CoprimeUpTo(static_cast<std::uint32_t>(std::lround(goldenSection * planned)), planned);
}

} // namespace rtg
