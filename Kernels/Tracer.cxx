#include "Tracer.h"

#include "HostDevice.h"
#include "SceneState.h"
#include "Stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtg
{

namespace
{

using Usage = vk::BufferUsageFlagBits;

constexpr std::uint32_t tileSize = 8;
constexpr std::uint32_t lanesPerTile = tileSize * tileSize;
constexpr std::uint32_t maxSide = 32768; ///< of an image, in pixels; more than any OpenGL viewport

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
}

std::vector<device::LightRecord>
MakeLights(const std::vector<Light>& lights, const glm::dvec3& origin)
{
  std::vector<device::LightRecord> records;
  for (const Light& light : lights)
  {
    device::LightRecord record{};
    record.kind = static_cast<std::uint32_t>(light.kind);
    record.colour = light.colour;
    record.position = light.position - origin;
    record.direction = light.direction;
    record.attenuation = light.attenuation;
    record.cosCone = light.coneAngle < 90.0f ? std::cos(glm::radians(light.coneAngle)) : -2.0f;
    record.exponent = light.exponent;
    records.push_back(record);
  }
  return records;
}

void CheckSettings(const TraceSettings& settings)
{
  const auto check = [](const char* name, std::uint32_t value, std::uint32_t most)
  {
    if (value < 1 || value > most)
    {
      throw Error("Ray Traced Glyphs: " + std::string(name) + " is " + std::to_string(value) +
        "; it must lie between 1 and " + std::to_string(most) + ".");
    }
  };
  check("the samples per pixel", settings.samples, 1u << 20);
  check("the pixel step", settings.pixelStep, 64);
  if (settings.width > maxSide || settings.height > maxSide)
  {
    throw Error("Ray Traced Glyphs: an image of " + std::to_string(settings.width) + " x " +
      std::to_string(settings.height) + " pixels is too large; the most is " +
      std::to_string(maxSide) + " a side.");
  }
}

} // namespace

struct Tracer::State
{
  explicit State(std::shared_ptr<Device> d)
    : device(std::move(d))
  {
  }

  const Pipeline& PipelineFor(Program program, const std::vector<HitGroup>& groups, bool alone);
  void Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame,
    std::uint32_t width, std::uint32_t height);

  std::shared_ptr<Device> device;
  Statistics statistics;
  std::vector<std::unique_ptr<Pipeline>> pipelines; ///< the last few used, newest last
  Buffer frameBuffer, lightBuffer, colour, depth, setIds, glyphIds, rays;
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
Tracer::State::PipelineFor(Program program, const std::vector<HitGroup>& groups, bool alone)
{
  const auto found = std::find_if(this->pipelines.begin(), this->pipelines.end(),
    [&](const auto& p)
    { return p->GetProgram() == program && p->Groups() == groups && p->Alone() == alone; });
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
    std::make_unique<Pipeline>(this->device->GetState(), program, groups, alone));
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

Image Tracer::Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights,
  const TraceSettings& settings, Pass pass)
{
  CheckSettings(settings);
  State& state = *this->state_;
  const Scene::State& glyphs = scene.GetState();
  Image image;
  image.width = settings.width;
  image.height = settings.height;
  image.samples = settings.samples;
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  if (pixels == 0)
  {
    return image;
  }

  Device::State& vulkan = state.device->GetState();
  vulkan.Guard("tracing an image",
    [&]
    {
      Stopwatch watch;
      for (Buffer* buffer : { &state.colour, &state.depth, &state.setIds, &state.glyphIds })
      {
        Fit(*buffer, vulkan, pixels * sizeof(std::uint32_t));
      }
      image.colour = static_cast<const std::uint32_t*>(state.colour.Mapped());
      image.depth = static_cast<const float*>(state.depth.Mapped());
      image.setIds = static_cast<const std::uint32_t*>(state.setIds.Mapped());
      image.glyphIds = static_cast<const std::uint32_t*>(state.glyphIds.Mapped());
      if (glyphs.topLevel.Address() == 0)
      {
        std::fill_n(static_cast<std::uint32_t*>(state.colour.Mapped()), pixels, 0u);
        std::fill_n(static_cast<float*>(state.depth.Mapped()), pixels, 1.0f);
        std::fill_n(static_cast<std::uint32_t*>(state.setIds.Mapped()), pixels, Image::noGlyph);
        std::fill_n(static_cast<std::uint32_t*>(state.glyphIds.Mapped()), pixels, Image::noGlyph);
        return;
      }

      device::FrameRecord frame{};
      FillCamera(frame, camera, glyphs.origin);
      const auto lightRecords = MakeLights(lights, glyphs.origin);
      Fit(state.lightBuffer, vulkan,
        std::max<std::size_t>(1, lightRecords.size()) * sizeof(device::LightRecord));
      state.lightBuffer.Upload(
        lightRecords.data(), lightRecords.size() * sizeof(device::LightRecord));
      frame.sets = glyphs.recordBuffer.Address();
      frame.lights = state.lightBuffer.Address();
      frame.lightCount = static_cast<std::uint32_t>(lightRecords.size());
      frame.colour = state.colour.Address();
      frame.depth = state.depth.Address();
      frame.setIds = state.setIds.Address();
      frame.glyphIds = state.glyphIds.Address();
      frame.sceneLower = glyphs.bounds.lower;
      frame.sceneUpper = glyphs.bounds.upper;
      frame.width = settings.width;
      frame.height = settings.height;
      frame.samples = settings.samples;
      frame.pixelStep = settings.pixelStep;
      frame.cullMask = 1u << static_cast<std::uint32_t>(pass);

      const std::uint32_t tilesX = DivideUp(DivideUp(settings.width, settings.pixelStep), tileSize);
      const std::uint32_t tilesY =
        DivideUp(DivideUp(settings.height, settings.pixelStep), tileSize);
      state.Launch(state.PipelineFor(Program::Image, glyphs.groups, glyphs.records.size() == 1),
        glyphs, frame, tilesX * lanesPerTile, tilesY);
      state.statistics.primaryRays += std::uint64_t(DivideUp(settings.width, settings.pixelStep)) *
        DivideUp(settings.height, settings.pixelStep) * settings.samples;
      state.statistics.traceSeconds += watch.Lap();
    });
  return image;
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
      constexpr std::uint32_t rowLength = 1024;
      state.Launch(state.PipelineFor(Program::Probe, glyphs.groups, glyphs.records.size() == 1),
        glyphs, frame, rowLength, DivideUp(frame.probeCount, rowLength));

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
