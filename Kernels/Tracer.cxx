#include "Tracer.h"

#include "BlueNoise.h"
#include "Denoiser.h"
#include "Frame.h"
#include "HostDevice.h"
#include "SceneState.h"
#include "Shading/Shading.h"
#include "Stopwatch.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rtg
{

namespace
{

using Usage = vk::BufferUsageFlagBits;

constexpr std::uint32_t tileSize = 8;
constexpr std::uint32_t lanesPerTile = tileSize * tileSize;
constexpr std::uint32_t blueNoiseSide = 64; ///< as in Shading/Sampling.glsl

std::uint32_t DivideUp(std::uint32_t value, std::uint32_t by)
{
  return (value + by - 1) / by;
}

// Makes `buffer` at least `size` bytes; keeps a larger one unless it is far too large.
void Fit(Buffer& buffer, Device::State& device, std::size_t size)
{
  if (buffer.Size() < size || buffer.Size() > 4 * size)
  {
    buffer = Buffer();
    buffer = Buffer(device, size, Usage::eStorageBuffer, Buffer::Place::Host);
  }
}

} // namespace

struct Tracer::State
{
  explicit State(std::shared_ptr<Device> d)
    : device(std::move(d))
  {
  }

  const Pipeline& PipelineFor(const Generation& generation, const std::vector<HitGroup>& groups);
  void Prepare(const TraceSettings& settings, bool keepSums);
  void CheckContinues(const TraceSettings& settings) const;
  void Clear(std::size_t pixels);
  void FillFeatures(Image& image) const;
  void PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame);
  device::FrameRecord MakeFrame(const Scene::State& scene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass);
  void Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame,
    std::uint32_t width, std::uint32_t height);

  std::shared_ptr<Device> device;
  Statistics statistics;
  std::vector<std::unique_ptr<Pipeline>> pipelines; ///< the last few used, newest last
  Buffer frameBuffer, lightBuffer, colour, depth, setIds, glyphIds, rays;
  Buffer sums, features;         ///< none unless asked for
  Buffer blueNoise;              ///< none unless its sampler was used
  std::shared_ptr<const EnvironmentImage> environment; ///< that the next three are made from
  EnvironmentCells environmentCells;
  Buffer environmentTexels, environmentCellBuffer;
  std::vector<std::uint32_t> denoised; ///< colours of the last image, if they are
  TraceSettings last;            ///< of the last image
  std::uint32_t keptSamples = 0; ///< that `sums` hold
};

Tracer::Tracer(std::shared_ptr<Device> device)
  : state_(std::make_unique<State>(std::move(device)))
{
}

Tracer::~Tracer() = default;

const Statistics& Tracer::GetStatistics() const
{
  this->state_->statistics.deviceBytes = this->state_->device->GetState().bytes;
  return this->state_->statistics;
}

const Pipeline&
Tracer::State::PipelineFor(const Generation& generation, const std::vector<HitGroup>& groups)
{
  const auto found = std::find_if(this->pipelines.begin(), this->pipelines.end(),
    [&](const auto& p) { return p->GetGeneration() == generation && p->Groups() == groups; });
  if (found != this->pipelines.end())
  {
    std::rotate(found, found + 1, this->pipelines.end());
    return *this->pipelines.back();
  }

  constexpr std::size_t kept = 8;
  if (this->pipelines.size() >= kept)
  {
    this->pipelines.erase(this->pipelines.begin());
  }
  this->pipelines.push_back(
    std::make_unique<Pipeline>(this->device->GetState(), generation, groups));
  ++this->statistics.pipelineBuilds;
  return *this->pipelines.back();
}

// Launches width x height rays in as many dispatches as the device's limit asks for.
void Tracer::State::Launch(const Pipeline& pipeline, const Scene::State& scene,
  device::FrameRecord& frame, std::uint32_t width, std::uint32_t height)
{
  Device::State& vulkan = this->device->GetState();
  const std::uint32_t rowsAtOnce =
    std::max(1u, std::min(height, vulkan.pipelineLimits.maxRayDispatchInvocationCount / width));
  frame.launchWidth = width;
  Fit(this->rays, vulkan, std::size_t(width) * rowsAtOnce * sizeof(device::RayRecord));
  frame.rays = this->rays.Address();
  frame.topLevel = scene.topLevel.Address();
  frame.onlySet = scene.records.front();
  if (this->frameBuffer.Size() == 0)
  {
    this->frameBuffer = Buffer(vulkan, sizeof(frame), Usage::eUniformBuffer, Buffer::Place::Host);
  }

  for (std::uint32_t row = 0; row < height; row += rowsAtOnce)
  {
    frame.firstRow = row;
    this->frameBuffer.Upload(&frame, sizeof(frame));
    vulkan.Submit(
      [&](vk::raii::CommandBuffer& command)
      {
        pipeline.Trace(command, this->frameBuffer, width, std::min(rowsAtOnce, height - row));
        // Results are read by the host.
        const vk::MemoryBarrier barrier(
          vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
        command.pipelineBarrier(vk::PipelineStageFlagBits::eRayTracingShaderKHR,
          vk::PipelineStageFlagBits::eHost, {}, barrier, {}, {});
      });
    ++this->statistics.dispatches;
  }
}

// The buffers of an image; those that it does not need are given back.
void Tracer::State::Prepare(const TraceSettings& settings, bool keepSums)
{
  Device::State& vulkan = this->device->GetState();
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  for (Buffer* buffer : { &this->colour, &this->depth, &this->setIds, &this->glyphIds })
  {
    Fit(*buffer, vulkan, pixels * sizeof(std::uint32_t));
  }
  if (keepSums)
  {
    Fit(this->sums, vulkan, pixels * sizeof(device::PixelSums));
  }
  else
  {
    this->sums = Buffer();
  }
  if (!settings.features)
  {
    this->features = Buffer();
  }
  else if (settings.firstSample == 0)
  {
    Fit(this->features, vulkan, pixels * sizeof(device::PixelFeatures));
    std::memset(this->features.Mapped(), 0, pixels * sizeof(device::PixelFeatures));
  }
  if (settings.sampler == Sampler::BlueNoise && this->blueNoise.Size() == 0)
  {
    this->blueNoise = Send(vulkan, BlueNoiseTile(blueNoiseSide));
  }
}

// The environment image on the device, if path tracing asks for one.
void Tracer::State::PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame)
{
  if (!settings.environmentImage || settings.shading != Shading::PathTracing)
  {
    return;
  }
  const EnvironmentImage& image = *settings.environmentImage;
  if (this->environment != settings.environmentImage)
  {
    Device::State& vulkan = this->device->GetState();
    this->environment.reset();
    this->environmentCells = MakeEnvironmentCells(image);
    this->environmentTexels = Buffer();
    this->environmentTexels = Send(vulkan, image.radiance);
    this->environmentCellBuffer = Buffer();
    this->environmentCellBuffer = Send(vulkan, this->environmentCells.cells);
    this->environment = settings.environmentImage;
  }
  frame.environmentTexels = this->environmentTexels.Address();
  frame.environmentSize = { image.width, image.height };
  frame.environmentThreshold = this->environmentCells.threshold;
  frame.environmentRight = image.right;
  frame.environmentUp = image.up;
  if (!this->environmentCells.cells.empty())
  {
    frame.environmentCells = this->environmentCellBuffer.Address();
    frame.environmentCellSide = this->environmentCells.side;
    frame.environmentCellColumns = this->environmentCells.columns;
    frame.environmentCellRows = this->environmentCells.rows;
  }
}

// Throws unless new samples can be added to what is kept.
void Tracer::State::CheckContinues(const TraceSettings& settings) const
{
  if (settings.firstSample == 0)
  {
    return;
  }
  const bool same = this->last.width == settings.width && this->last.height == settings.height &&
    this->last.pixelStep == settings.pixelStep && this->last.shading == settings.shading &&
    this->last.features == settings.features &&
    this->last.environmentImage == settings.environmentImage;
  if (!same || this->keptSamples != settings.firstSample)
  {
    throw Error("Ray Traced Glyphs: samples from number " + std::to_string(settings.firstSample) +
      " on are to be added to an image that holds " + std::to_string(same ? this->keptSamples : 0) +
      "; trace it from its first sample with keepSums.");
  }
}

// An image of nothing.
void Tracer::State::Clear(std::size_t pixels)
{
  const auto fill = [pixels](Buffer& buffer, auto value)
  { std::fill_n(static_cast<decltype(value)*>(buffer.Mapped()), pixels, value); };
  fill(this->colour, 0u);
  fill(this->depth, 1.0f);
  fill(this->setIds, Image::noGlyph);
  fill(this->glyphIds, Image::noGlyph);
  if (this->sums.Size())
  {
    fill(this->sums, device::PixelSums{ glm::vec4(0.0f), 1e38f });
  }
}

void Tracer::State::FillFeatures(Image& image) const
{
  const auto* sums = static_cast<const device::PixelFeatures*>(this->features.Mapped());
  const std::size_t pixels = std::size_t(image.width) * image.height;
  image.normals.assign(pixels, glm::vec3(0.0f));
  image.albedos.assign(pixels, glm::vec3(0.0f));
  image.viewDepths.assign(pixels, 0.0f);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (sums[i].hits > 0.0f)
    {
      const float length = glm::length(sums[i].normal);
      image.normals[i] = length > 0.0f ? sums[i].normal / length : glm::vec3(0.0f);
      image.albedos[i] = sums[i].albedo / sums[i].hits;
      image.viewDepths[i] = sums[i].depth / sums[i].hits;
    }
  }
}

// But for samples and times.
device::FrameRecord Tracer::State::MakeFrame(const Scene::State& scene, const Camera& camera,
  const std::vector<Light>& lights, const TraceSettings& settings, Pass pass)
{
  device::FrameRecord frame{};
  FillCamera(frame, camera, scene.origin);
  FillSettings(frame, settings);
  const std::vector<device::LightRecord> records = MakeLights(lights, scene.origin);
  const std::size_t lightBytes = records.size() * sizeof(device::LightRecord);
  Fit(this->lightBuffer, this->device->GetState(), std::max(lightBytes, sizeof(device::LightRecord)));
  this->lightBuffer.Upload(records.data(), lightBytes);
  frame.lights = this->lightBuffer.Address();
  frame.lightCount = static_cast<std::uint32_t>(records.size());
  frame.sets = scene.recordBuffer.Address();
  frame.sceneLower = scene.bounds.lower;
  frame.sceneUpper = scene.bounds.upper;
  frame.colour = this->colour.Address();
  frame.depth = this->depth.Address();
  frame.setIds = this->setIds.Address();
  frame.glyphIds = this->glyphIds.Address();
  frame.sums = this->sums.Address();
  frame.features = this->features.Address();
  frame.blueNoise = this->blueNoise.Address();
  frame.cullMask = pass == Pass::All ? device::OPAQUE_MASK | device::TRANSLUCENT_MASK
    : pass == Pass::Opaque           ? device::OPAQUE_MASK
                                     : device::TRANSLUCENT_MASK;
  this->PrepareEnvironment(settings, frame);
  return frame;
}

Image Tracer::Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights,
  const TraceSettings& settings, Pass pass)
{
  CheckSettings(settings);
  State& state = *this->state_;
  state.CheckContinues(settings);
  const Scene::State& glyphs = scene.GetState();
  Image image;
  image.width = settings.width;
  image.height = settings.height;
  image.samples = settings.firstSample + settings.samples;
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  state.keptSamples = 0;
  if (pixels == 0)
  {
    return image;
  }

  Device::State& vulkan = state.device->GetState();
  vulkan.Guard("tracing an image",
    [&]
    {
      Stopwatch watch;
      const std::uint32_t atOnce = SamplesAtOnce(settings, pixels);
      const bool keeps = settings.keepSums || settings.firstSample > 0 || atOnce < settings.samples;
      state.Prepare(settings, keeps);
      image.colour = static_cast<const std::uint32_t*>(state.colour.Mapped());
      image.depth = static_cast<const float*>(state.depth.Mapped());
      image.setIds = static_cast<const std::uint32_t*>(state.setIds.Mapped());
      image.glyphIds = static_cast<const std::uint32_t*>(state.glyphIds.Mapped());
      if (glyphs.topLevel.Address() == 0)
      {
        state.Clear(pixels);
      }
      else
      {
        device::FrameRecord frame = state.MakeFrame(glyphs, camera, lights, settings, pass);
        Generation generation = GenerationFor(settings);
        generation.alone = glyphs.records.size() == 1;
        generation.accumulates = keeps;
        generation.moves = glyphs.moves;
        if (glyphs.moves)
        {
          generation.sampler = static_cast<std::uint32_t>(settings.sampler);
          frame.sharedTimeBits = SharedTimeBits(settings, glyphs.placedTimeSliceBits);
          frame.timeStrataBits = TimeStrataBits(settings);
        }
        // The sets of a pass of translucent ones are translucent whether or not the scene still says so.
        generation.layered = pass == Pass::Translucent && settings.shading != Shading::PathTracing;
        generation.translucency = settings.shading != Shading::Local && scene.HasTranslucent();
        generation.whole = CanBeWhole(generation, glyphs.groups);
        const Pipeline& pipeline = state.PipelineFor(generation, glyphs.groups);
        const std::uint32_t columns = DivideUp(settings.width, settings.pixelStep);
        const std::uint32_t rows = DivideUp(settings.height, settings.pixelStep);
        for (std::uint32_t done = 0; done < settings.samples; done += frame.samples)
        {
          frame.firstSample = settings.firstSample + done;
          frame.samples = std::min(atOnce, settings.samples - done);
          state.Launch(pipeline, glyphs, frame, DivideUp(columns, tileSize) * lanesPerTile,
            DivideUp(rows, tileSize));
        }
        state.statistics.primaryRays += std::uint64_t(columns) * rows * settings.samples;
      }
      state.last = settings;
      state.keptSamples = settings.keepSums ? image.samples : 0;
      if (settings.features && settings.pixelStep == 1)
      {
        state.FillFeatures(image);
      }
      state.statistics.traceSeconds += watch.Lap();
    });
  return image;
}

std::vector<glm::vec4> Tracer::Means() const
{
  const State& state = *this->state_;
  const std::size_t pixels = std::size_t(state.last.width) * state.last.height;
  if (state.keptSamples == 0)
  {
    throw Error("Ray Traced Glyphs: means are asked of an image that was traced without keepSums.");
  }
  const auto* sums = static_cast<const device::PixelSums*>(state.sums.Mapped());
  std::vector<glm::vec4> means(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    means[i] = sums[i].colour / static_cast<float>(state.keptSamples);
  }
  return means;
}

void Tracer::Denoise(Image& image)
{
  State& state = *this->state_;
  std::vector<glm::vec4> means = this->Means();
  if (image.normals.size() != means.size())
  {
    throw Error("Ray Traced Glyphs: an image is to be denoised that was traced without features.");
  }
  Stopwatch watch;
  const bool linear = state.last.shading == Shading::PathTracing;
  std::vector<glm::vec3> albedos = image.albedos;
  if (linear)
  {
    std::transform(albedos.begin(), albedos.end(), albedos.begin(), shading::DisplayToLinear);
  }
  rtg::Denoise(means, { image.width, image.height, image.normals, albedos, image.viewDepths });

  const bool develops = GenerationFor(state.last).develops;
  const float exposureFactor = std::exp2(state.last.exposure);
  const bool filmic = state.last.toneMapping == ToneMapping::Filmic;
  state.denoised.resize(means.size());
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    const glm::vec4& mean = means[i];
    if (mean.a <= 0.0f)
    {
      state.denoised[i] = 0;
      continue;
    }
    const glm::vec3 colour = glm::vec3(mean) / mean.a;
    state.denoised[i] = glm::packUnorm4x8(glm::vec4(
      develops ? shading::Develop(colour, linear, exposureFactor, filmic) : colour, mean.a));
  }
  image.colour = state.denoised.data();
  state.statistics.denoiseSeconds += watch.Lap();
}

std::vector<Tracer::ProbeHit> Tracer::TraceProbes(Scene& scene, const std::vector<Probe>& probes)
{
  State& state = *this->state_;
  const Scene::State& glyphs = scene.GetState();
  std::vector<ProbeHit> hits(
    probes.size(), { INFINITY, glm::vec3(0.0f), Image::noGlyph, Image::noGlyph });
  if (probes.empty() || glyphs.topLevel.Address() == 0)
  {
    return hits;
  }

  Device::State& vulkan = state.device->GetState();
  vulkan.Guard("tracing probes",
    [&]
    {
      std::vector<device::ProbeRecord> records(probes.size());
      for (std::size_t i = 0; i < probes.size(); ++i)
      {
        Split(probes[i].origin - glyphs.origin, records[i].origin, records[i].originLow);
        records[i].direction = probes[i].direction;
        records[i].time = probes[i].time;
      }
      Buffer input(
        vulkan, records.size() * sizeof(records[0]), Usage::eStorageBuffer, Buffer::Place::Host);
      input.Upload(records.data(), input.Size());
      Buffer output(vulkan, probes.size() * sizeof(device::ProbeResult), Usage::eStorageBuffer,
        Buffer::Place::Host);

      device::FrameRecord frame{};
      frame.sets = glyphs.recordBuffer.Address();
      frame.probes = input.Address();
      frame.probeResults = output.Address();
      frame.probeCount = static_cast<std::uint32_t>(probes.size());
      frame.sceneLower = glyphs.bounds.lower;
      frame.sceneUpper = glyphs.bounds.upper;
      frame.cullMask = 0xff;
      Generation probing;
      probing.program = Program::Probe;
      probing.alone = glyphs.records.size() == 1;
      probing.moves = glyphs.moves;
      constexpr std::uint32_t rowLength = 1024;
      state.Launch(state.PipelineFor(probing, glyphs.groups), glyphs, frame, rowLength,
        DivideUp(frame.probeCount, rowLength));

      const auto* results = static_cast<const device::ProbeResult*>(output.Mapped());
      for (std::size_t i = 0; i < probes.size(); ++i)
      {
        if (results[i].t >= 0.0f)
        {
          hits[i] = { results[i].t, results[i].normal, results[i].setId,
            scene.OriginalGlyph(results[i].setId, results[i].glyph) };
        }
      }
    });
  return hits;
}

} // namespace rtg
