#include "Tracer.h"

#include "Denoiser.h"
#include "Frame.h"
#include "HostDevice.h"
#include "SceneState.h"
#include "Shading/Shading.h"
#include "Stopwatch.h"
#include "TracerResources.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace rtg
{

namespace
{

using Usage = vk::BufferUsageFlagBits;

constexpr std::size_t imagesPerPixel = 4; ///< words: color, depth, id of the set, id of the glyph
constexpr std::uint32_t tileSize = 8;
constexpr std::uint32_t lanesPerTile = tileSize * tileSize;
constexpr std::uint32_t tilesPerRow = 1024;           ///< of a launch
constexpr std::uint32_t mostTiles = 16 * tilesPerRow; ///< of a launch: 29 MB of ray records
/// Seconds that a launch is to take where TilesAtOnce() cuts: whoever waits for it to stop, or for the display, waits
/// so long.
constexpr double launchSeconds = 0.04;
/// After so long whoever waits for a program is asked whether to go on waiting.
constexpr std::chrono::milliseconds compilingPatience(20);

std::uint32_t DivideUp(std::uint32_t value, std::uint32_t by)
{
  return (value + by - 1) / by;
}

// Makes `buffer` at least `size` bytes; keeps a larger one unless it is far too large.
void Fit(Buffer& buffer, Device::State& device, std::size_t size, Buffer::Place place = Buffer::Place::Device)
{
  if (buffer.Size() < size || buffer.Size() > 4 * size)
  {
    buffer = Buffer();
    buffer = Buffer(device, size, Usage::eStorageBuffer, place);
  }
}

// A number of tiles from one to the next of a launch that has no common divisor with their count and whose multiples,
// of all tiles, fit into 32 bits: neighbors in a launch are far apart in the image.
std::uint32_t TileStride(std::uint32_t count)
{
  auto stride =
    static_cast<std::uint32_t>(std::min<std::uint64_t>(count * 5ull / 13, 0xffffffffull / std::max(count, 1u)));
  while (stride > 1 && std::gcd(stride, count) != 1)
  {
    --stride;
  }
  return std::max(stride, 1u);
}

} // namespace

struct Tracer::State
{
  // An image, or further samples of one, in the making.
  struct Job
  {
    const Scene::State* scene = nullptr;
    std::uint64_t sceneVersion = 0;
    Image image;
    TraceSettings settings;
    Generation generation;
    device::FrameRecord frame{};              ///< of the samples in work; firstTile: the first one that lacks them
    std::uint32_t beginTile = 0, endTile = 0; ///< of the share of the image
    std::uint32_t atOnce = 1;                 ///< samples of one dispatch over all tiles
    std::uint32_t done = 0;                   ///< samples that all tiles have
    std::size_t rays = 0;                     ///< camera rays of one sample

    /// Of the tiles, those that have the samples in work.
    double TracedShare() const
    {
      return double(this->frame.firstTile - this->beginTile) / std::max(1u, this->endTile - this->beginTile);
    }
  };

  void Prepare(const TraceSettings& settings, bool keepSums);
  void CheckContinues(const TraceSettings& settings, const Scene::State& scene) const;
  void Clear(std::size_t pixels);
  void Show(Image& image);
  void ShowShare(Image& image);
  void FillFeatures(Image& image) const;
  device::FrameRecord MakeFrame(const Scene::State& scene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass);
  void Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame, std::uint32_t width,
    std::uint32_t height);
  std::uint32_t TilesAtOnce(const TracerResources::UsedProgram& program, const Job& job, bool interruptible) const;
  void FitRays(const Generation& generation, std::size_t count);
  void Begin(const Scene::State& scene, bool translucentScene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass, bool interruptible);
  void Run(const Scene::State& scene, const Interrupt& interrupt);

  std::shared_ptr<TracerResources> shared;
  std::shared_ptr<Device> device;
  FrameBlock frameBlock;
  Buffer lightBuffer, rays;
  Buffer images;                         ///< colors, depths, ids of sets, ids of glyphs, one word a pixel each
  Buffer shown;                          ///< a copy of them for the host, none on a device that shares its memory
  std::vector<std::uint32_t> shareShown; ///< likewise, of a share of the image
  Buffer sums, features;                 ///< none unless asked for
  Job job;                               ///< the last one; goes on where image.complete is false
  TraceSettings last;                    ///< of the last image
  std::uint32_t keptSamples = 0;         ///< that `sums` hold
};

Tracer::Tracer(std::shared_ptr<Device> device)
  : Tracer(std::make_shared<TracerResources>(std::move(device)))
{
}

Tracer::Tracer(std::shared_ptr<TracerResources> shared)
  : state_(std::make_unique<State>())
{
  this->state_->device = shared->device;
  this->state_->shared = std::move(shared);
}

Tracer::~Tracer() = default;

const Statistics& Tracer::GetStatistics() const
{
  return this->state_->shared->GetStatistics();
}

// Launches width x height rays.
void Tracer::State::Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame,
  std::uint32_t width, std::uint32_t height)
{
  Device::State& vulkan = this->device->GetState();
  frame.launchWidth = width;
  frame.rays = this->rays.Address();
  frame.topLevels = scene.topLevelAddresses.Address();
  frame.topLevelCount = static_cast<std::uint32_t>(scene.topLevels.size());
  frame.onlySet = scene.records.front();
  if (!this->frameBlock.Exists())
  {
    this->frameBlock = FrameBlock(vulkan);
  }
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      this->frameBlock.Send(command, frame);
      pipeline.Trace(command, this->frameBlock, width, height);
      // The host or a copy reads the results, the next launch adds to them.
      Barrier(command, vulkan.programStages, Access::eShaderWrite,
        vulkan.programStages | Stage::eTransfer | Stage::eHost,
        Access::eShaderRead | Access::eShaderWrite | Access::eTransferRead | Access::eTransferWrite |
          Access::eHostRead);
    });
}

// The buffers of an image; those that it does not need are given back.
void Tracer::State::Prepare(const TraceSettings& settings, bool keepSums)
{
  Device::State& vulkan = this->device->GetState();
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  Fit(this->images, vulkan, imagesPerPixel * pixels * sizeof(std::uint32_t));
  if (!this->images.Mapped())
  {
    Fit(this->shown, vulkan, imagesPerPixel * pixels * sizeof(std::uint32_t), Buffer::Place::Host);
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
    this->features.Fill(0, pixels * sizeof(device::PixelFeatures), 0);
  }
}

// Throws unless new samples can be added to what is kept.
void Tracer::State::CheckContinues(const TraceSettings& settings, const Scene::State& scene) const
{
  if (settings.firstSample == 0)
  {
    return;
  }
  const TraceSettings& l = this->last;
  const bool same = l.width == settings.width && l.height == settings.height && l.pixelStep == settings.pixelStep &&
    l.shading == settings.shading && l.features == settings.features && l.occlusionRays == settings.occlusionRays &&
    l.paths == settings.paths && l.share == settings.share && l.shares == settings.shares &&
    l.environmentImage == settings.environmentImage && this->job.image.complete && this->job.scene == &scene &&
    this->job.sceneVersion == scene.version;
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
  const std::uint32_t empty[imagesPerPixel] = { 0u, glm::floatBitsToUint(1.0f), Image::noGlyph, Image::noGlyph };
  const std::size_t bytes = pixels * sizeof(std::uint32_t);
  for (std::size_t i = 0; i < imagesPerPixel; ++i)
  {
    this->images.Fill(i * bytes, bytes, empty[i]);
  }
}

// The image's pixels, where the host can read them.
void Tracer::State::Show(Image& image)
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  if (!this->images.Mapped())
  {
    this->images.CopyTo(this->shown, imagesPerPixel * pixels * sizeof(std::uint32_t));
  }
  const void* place = this->images.Mapped() ? this->images.Mapped() : this->shown.Mapped();
  const auto* words = static_cast<const std::uint32_t*>(place);
  image.colour = image.traced = words;
  image.depth = reinterpret_cast<const float*>(words + pixels);
  image.setIds = words + 2 * pixels;
  image.glyphIds = words + 3 * pixels;
  if (this->job.settings.shares > 1)
  {
    this->ShowShare(image);
  }
}

// Only the tiles of the share: the others are nothing to see, whatever the device's image has there.
void Tracer::State::ShowShare(Image& image)
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  const std::uint32_t empty[imagesPerPixel] = { 0u, glm::floatBitsToUint(1.0f), Image::noGlyph, Image::noGlyph };
  this->shareShown.resize(imagesPerPixel * pixels);
  for (std::size_t i = 0; i < imagesPerPixel; ++i)
  {
    std::fill_n(this->shareShown.begin() + i * pixels, pixels, empty[i]);
  }
  const device::FrameRecord& frame = this->job.frame;
  const std::uint32_t side = tileSize * this->job.settings.pixelStep;
  for (std::uint32_t number = this->job.beginTile; number < this->job.endTile; ++number)
  {
    const std::uint32_t tile = number * frame.tileStride % frame.tileCount; // as LaunchPixel() has it
    const std::uint32_t left = tile % frame.tileColumns * side, bottom = tile / frame.tileColumns * side;
    const std::uint32_t right = std::min(left + side, image.width), top = std::min(bottom + side, image.height);
    for (std::uint32_t y = bottom; y < top; ++y)
    {
      const std::size_t first = std::size_t(y) * image.width + left;
      for (std::size_t i = 0; i < imagesPerPixel; ++i)
      {
        std::copy_n(image.colour + i * pixels + first, right - left, this->shareShown.begin() + i * pixels + first);
      }
    }
  }
  const std::uint32_t* words = this->shareShown.data();
  image.colour = image.traced = words;
  image.depth = reinterpret_cast<const float*>(words + pixels);
  image.setIds = words + 2 * pixels;
  image.glyphIds = words + 3 * pixels;
}

void Tracer::State::FillFeatures(Image& image) const
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  image.normals.assign(pixels, glm::vec3(0.0f));
  image.albedos.assign(pixels, glm::vec3(0.0f));
  image.viewDepths.assign(pixels, 0.0f);
  this->features.Read(pixels * sizeof(device::PixelFeatures),
    [&](const void* read)
    {
      const auto* sums = static_cast<const device::PixelFeatures*>(read);
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
    });
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
  std::copy_n(records.begin(), std::min<std::size_t>(records.size(), device::FEW_LIGHTS), frame.fewLights);
  const std::size_t imageBytes = std::size_t(settings.width) * settings.height * sizeof(std::uint32_t);
  frame.colour = this->images.Address();
  frame.depth = frame.colour + imageBytes;
  frame.setIds = frame.depth + imageBytes;
  frame.glyphIds = frame.setIds + imageBytes;
  frame.sums = this->sums.Address();
  frame.features = this->features.Address();
  frame.cullMask = pass == Pass::All ? device::OPAQUE_MASK | device::TRANSLUCENT_MASK
    : pass == Pass::Opaque           ? device::OPAQUE_MASK
                                     : device::TRANSLUCENT_MASK;
  this->shared->PrepareEnvironment(settings, frame);
  return frame;
}

// What the driver's programs know of so many rays in flight.
void Tracer::State::FitRays(const Generation& generation, std::size_t count)
{
  if (generation.ownTrees)
  {
    this->rays = Buffer();
  }
  else
  {
    Fit(this->rays, this->device->GetState(), count * sizeof(device::RayRecord));
  }
}

// What is to be launched for an image; nothing is launched yet.
void Tracer::State::Begin(const Scene::State& scene, bool translucentScene, const Camera& camera,
  const std::vector<Light>& lights, const TraceSettings& settings, Pass pass, bool interruptible)
{
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  Job& begun = this->job;
  begun = Job();
  begun.scene = &scene;
  begun.sceneVersion = scene.version;
  begun.settings = settings;
  begun.image.width = settings.width;
  begun.image.height = settings.height;
  begun.image.complete = false;
  begun.atOnce = SamplesAtOnce(settings, pixels);
  const bool keeps = settings.keepSums || settings.firstSample > 0 || begun.atOnce < settings.samples;
  this->Prepare(settings, keeps);
  const bool empty = scene.records.empty();
  if (empty || (interruptible && settings.firstSample == 0 && !settings.overPreview))
  {
    this->Clear(pixels);
  }
  if (empty)
  {
    if (this->sums.Size())
    {
      const device::PixelSums none{ glm::vec4(0.0f), 1e38f };
      this->sums.Write(pixels * sizeof(none),
        [&](void* target) { std::fill_n(static_cast<device::PixelSums*>(target), pixels, none); });
    }
    begun.done = settings.samples;
    return;
  }
  begun.frame = this->MakeFrame(scene, camera, lights, settings, pass);
  begun.generation = GenerationFor(settings);
  FillScene(begun.frame, begun.generation, scene);
  Constants& constants = begun.generation.constants;
  constants.accumulates = keeps;
  constants.manyLights = lights.size() > device::FEW_LIGHTS;
  if (scene.moves)
  {
    constants.independentSamples = settings.independentSamples;
    begun.frame.sharedTimeBits = SharedTimeBits(settings, scene.placedTimeSliceBits);
    begun.frame.timeStrataBits = TimeStrataBits(settings);
  }
  // The sets of a pass of translucent ones are translucent whether or not the scene still says so.
  constants.layered = pass == Pass::Translucent && settings.shading != Shading::PathTracing;
  constants.translucency = settings.shading != Shading::Local && translucentScene;
  constants.leavesSurface = settings.shading != Shading::Local || constants.layered;

  const std::uint32_t columns = DivideUp(settings.width, settings.pixelStep);
  const std::uint32_t rows = DivideUp(settings.height, settings.pixelStep);
  begun.frame.tileColumns = DivideUp(columns, tileSize);
  begun.frame.tileCount = begun.frame.tileColumns * DivideUp(rows, tileSize);
  begun.frame.tileStride = TileStride(begun.frame.tileCount);
  // Tiles that follow each other are scattered already.
  const auto boundary = [&](std::uint32_t share)
  { return static_cast<std::uint32_t>(std::uint64_t(begun.frame.tileCount) * share / settings.shares); };
  begun.beginTile = begun.frame.firstTile = boundary(settings.share);
  begun.endTile = boundary(settings.share + 1);
  const std::uint32_t tiles = begun.endTile - begun.beginTile;
  begun.rays = settings.shares > 1 ? std::size_t(tiles) * lanesPerTile : std::size_t(columns) * rows;
  begun.done = tiles > 0 ? 0 : settings.samples;
  const std::uint32_t largest = std::min(mostTiles, tiles);
  const std::uint32_t launched = DivideUp(largest, tilesPerRow) * std::min(largest, tilesPerRow);
  this->FitRays(begun.generation, std::size_t(launched) * lanesPerTile);
}

// Tiles of the next launch. What can be interrupted, and all on a GPU, whose display stands still meanwhile and whose
// driver takes a launch of seconds for hung, is launched in parts of some hundredths of a second, as far as the
// program's launches so far tell; a part is at most eight times the last one, because costs differ, and the first is
// one tile.
std::uint32_t
Tracer::State::TilesAtOnce(const TracerResources::UsedProgram& program, const Job& job, bool interruptible) const
{
  const Device::State& vulkan = this->device->GetState();
  const std::uint32_t left = job.endTile - job.frame.firstTile;
  // Compute shaders may have 65,535 groups along each axis, which the tiles of a launch stay below.
  const std::uint32_t limit = job.generation.ownTrees
    ? mostTiles
    : std::max(1u, std::min(mostTiles, vulkan.pipelineLimits.maxRayDispatchInvocationCount / lanesPerTile));
  std::uint32_t most = std::min(left, limit > tilesPerRow ? limit - limit % tilesPerRow : limit);
  if (!interruptible && vulkan.cpu)
  {
    return most;
  }
  if (program.secondsPerRay <= 0.0)
  {
    return std::min(most, 8u);
  }
  const double tileSeconds = program.secondsPerRay * lanesPerTile * job.frame.samples;
  const double wanted = std::min(launchSeconds / tileSeconds, 8.0 * static_cast<double>(program.lastTiles));
  return std::min(most, static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 1e9)));
}

// Goes on with the job until it is done or somebody interrupts; after each launch one is asked.
void Tracer::State::Run(const Scene::State& scene, const Interrupt& interrupt)
{
  Job& work = this->job;
  Stopwatch watch;
  const TraceSettings& settings = work.settings;
  const bool interruptible = static_cast<bool>(interrupt);
  bool stopped = false;
  if (work.done < settings.samples)
  {
    TracerResources::UsedProgram& program = this->shared->ProgramFor(work.generation, scene.groups);
    // Compiling may take many seconds.
    if (!interruptible)
    {
      this->shared->WaitFor(program);
    }
    while (!stopped && !this->shared->IsCompiled(program, compilingPatience))
    {
      stopped = interrupt(double(work.done) / settings.samples);
    }
    double secondsBefore = watch.Lap();
    while (work.done < settings.samples && !stopped)
    {
      device::FrameRecord& frame = work.frame;
      if (frame.firstTile == work.beginTile)
      {
        frame.firstSample = settings.firstSample + work.done;
        frame.samples = std::min(work.atOnce, settings.samples - work.done);
      }
      const std::uint32_t tiles = this->TilesAtOnce(program, work, interruptible);
      frame.endTile = frame.firstTile + tiles;
      const std::uint32_t columns = std::min(tiles, tilesPerRow);
      this->Launch(*program.program->pipeline, scene, frame, columns * lanesPerTile, DivideUp(tiles, columns));
      const double seconds = watch.Lap();
      this->shared->statistics.traceSeconds += secondsBefore + seconds;
      secondsBefore = 0.0;
      // Of old and new costs the mean: launches differ.
      const double cost = seconds / (double(tiles) * lanesPerTile * frame.samples);
      program.secondsPerRay = program.secondsPerRay > 0.0 ? 0.5 * (program.secondsPerRay + cost) : cost;
      program.lastTiles = std::max(tiles, 8u);
      frame.firstTile = frame.endTile;
      if (frame.firstTile == work.endTile)
      {
        frame.firstTile = work.beginTile;
        work.done += frame.samples;
        ++this->shared->statistics.dispatches;
        this->shared->statistics.primaryRays += work.rays * frame.samples;
      }
      const double part = double(frame.samples) * work.TracedShare();
      stopped = work.done < settings.samples && interruptible && interrupt((work.done + part) / settings.samples);
    }
  }
  work.image.complete = work.done == settings.samples;
  work.image.samples = settings.firstSample + work.done;
  const float part = work.image.complete ? 0.0f : float(work.frame.samples * work.TracedShare());
  work.image.share = (work.done + part) / settings.samples;
  this->Show(work.image);
  this->keptSamples = settings.keepSums && work.image.complete ? work.image.samples : 0;
  this->last = settings;
  if (settings.features && settings.pixelStep == 1 && work.image.complete)
  {
    this->FillFeatures(work.image);
  }
  this->shared->statistics.traceSeconds += watch.Lap();
}

Image Tracer::Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights, const TraceSettings& settings,
  Pass pass, const Interrupt& interrupt)
{
  CheckSettings(settings);
  State& state = *this->state_;
  const Scene::State& glyphs = scene.GetState();
  state.CheckContinues(settings, glyphs);
  state.keptSamples = 0;
  if (settings.width == 0 || settings.height == 0)
  {
    Image image;
    image.width = settings.width;
    image.height = settings.height;
    image.samples = settings.firstSample + settings.samples;
    return image;
  }
  state.device->GetState().Guard("tracing an image",
    [&]
    {
      const bool translucent = scene.HasTranslucent();
      state.Begin(glyphs, translucent, camera, lights, settings, pass, static_cast<bool>(interrupt));
      state.Run(glyphs, interrupt);
    });
  return state.job.image;
}

Image Tracer::Resume(Scene& scene, const Interrupt& interrupt)
{
  State& state = *this->state_;
  const Scene::State& glyphs = scene.GetState();
  if (state.job.scene != &glyphs || state.job.sceneVersion != glyphs.version)
  {
    throw Error("Ray Traced Glyphs: an image of another scene is to be gone on with; trace it from "
                "its first sample.");
  }
  state.device->GetState().Guard("tracing an image", [&] { state.Run(glyphs, interrupt); });
  return state.job.image;
}

std::vector<glm::vec4> Tracer::Means() const
{
  const State& state = *this->state_;
  const std::size_t pixels = std::size_t(state.last.width) * state.last.height;
  if (state.keptSamples == 0)
  {
    throw Error("Ray Traced Glyphs: means are asked of an image that was traced without keepSums.");
  }
  return state.device->GetState().Guard("reading an image",
    [&]
    {
      std::vector<glm::vec4> means(pixels);
      state.sums.Read(pixels * sizeof(device::PixelSums),
        [&](const void* read)
        {
          const auto* sums = static_cast<const device::PixelSums*>(read);
          for (std::size_t i = 0; i < pixels; ++i)
          {
            means[i] = sums[i].colour / static_cast<float>(state.keptSamples);
          }
        });
      return means;
    });
}

DenoiseTask Tracer::Denoise(const Image& image) const
{
  DenoiseTask task;
  task.means_ = this->Means();
  if (image.normals.size() != task.means_.size())
  {
    throw Error("Ray Traced Glyphs: an image is to be denoised that was traced without features.");
  }
  task.image_ = image;
  task.settings_ = this->state_->last;
  task.shared_ = this->state_->shared;
  return task;
}

std::vector<std::uint32_t> DenoiseTask::operator()()
{
  Stopwatch watch;
  const bool linear = this->settings_.shading == Shading::PathTracing;
  if (linear)
  {
    std::transform(
      this->image_.albedos.begin(), this->image_.albedos.end(), this->image_.albedos.begin(), shading::DisplayToLinear);
  }
  rtg::Denoise(this->means_,
    { this->image_.width, this->image_.height, this->image_.normals, this->image_.albedos, this->image_.viewDepths });

  const bool develops = GenerationFor(this->settings_).constants.develops != 0;
  const float exposureFactor = std::exp2(this->settings_.exposure);
  const bool filmic = this->settings_.toneMapping == ToneMapping::Filmic;
  std::vector<std::uint32_t> smooth(this->means_.size(), 0);
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    const glm::vec4& mean = this->means_[i];
    if (mean.a > 0.0f)
    {
      const glm::vec3 colour = glm::vec3(mean) / mean.a;
      smooth[i] = glm::packUnorm4x8(
        glm::vec4(develops ? shading::Develop(colour, linear, exposureFactor, filmic) : colour, mean.a));
    }
  }
  this->shared_->denoiseSeconds += watch.Lap();
  return smooth;
}

std::vector<Tracer::ProbeHit> Tracer::TraceProbes(Scene& scene, const std::vector<Probe>& probes)
{
  State& state = *this->state_;
  const Scene::State& glyphs = scene.GetState();
  std::vector<ProbeHit> hits(probes.size(), { INFINITY, glm::vec3(0.0f), Image::noGlyph, Image::noGlyph });
  if (probes.empty() || glyphs.records.empty())
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
      Buffer input(vulkan, records.size() * sizeof(records[0]), Usage::eStorageBuffer, Buffer::Place::Device);
      input.Upload(records.data(), input.Size());
      Buffer output(vulkan, probes.size() * sizeof(device::ProbeResult), Usage::eStorageBuffer, Buffer::Place::Device);

      device::FrameRecord frame{};
      frame.probes = input.Address();
      frame.probeResults = output.Address();
      frame.probeCount = static_cast<std::uint32_t>(probes.size());
      frame.cullMask = 0xff;
      Generation probing;
      probing.program = probeProgram;
      FillScene(frame, probing, glyphs);
      constexpr std::uint32_t rowLength = 1024;
      state.FitRays(probing, records.size() + rowLength);
      TracerResources::UsedProgram& program = state.shared->ProgramFor(probing, glyphs.groups);
      state.shared->WaitFor(program);
      state.Launch(*program.program->pipeline, glyphs, frame, rowLength, DivideUp(frame.probeCount, rowLength));

      output.Read(output.Size(),
        [&](const void* read)
        {
          const auto* results = static_cast<const device::ProbeResult*>(read);
          for (std::size_t i = 0; i < probes.size(); ++i)
          {
            if (results[i].t >= 0.0f)
            {
              hits[i] = { results[i].t, results[i].normal, results[i].setId,
                scene.OriginalGlyph(results[i].setId, results[i].glyph) };
            }
          }
        });
    });
  return hits;
}

} // namespace rtg
