#include "Tracer.h"

#include "Frame.h"
#include "HostDevice.h"
#include "ImageBuffers.h"
#include "Parallel.h"
#include "SceneState.h"
#include "Stopwatch.h"
#include "Tiles.h"
#include "TracerResources.h"
#include "Vulkan/Pipeline.h"

#include <algorithm>
#include <chrono>

namespace rtg
{

struct Tracer::State
{
  // An image, or further samples of one, in the making.
  struct Job
  {
    std::uint64_t sceneVersion = 0; ///< 0: there is nothing to go on with
    Image image;
    TraceSettings settings;
    Specialization specialization;
    TileRange tiles;
    device::FrameRecord frame{};          ///< of the samples in work; firstTile: the first one that lacks them
    std::uint32_t fewest = 1, atMost = 1; ///< samples of one dispatch over all tiles
    std::uint32_t atOnce = 1;             ///< likewise, of the next where launches are cut
    double longest = 0.0;                 ///< seconds of a launch of the one in work

    /// The fraction of the requested samples that is traced; tiles before firstTile have those in work.
    double TracedFraction() const
    {
      const double done = double(this->frame.firstTile - this->tiles.begin) / std::max(1u, this->tiles.Size());
      return (this->image.samples + this->frame.samples * done) / this->settings.samples;
    }
  };

  Device::State& Vulkan() const { return this->shared->device->GetState(); }
  bool Cuts(bool interruptible) const { return interruptible || !this->shared->device->IsCpu(); }
  device::FrameRecord MakeFrame(const SceneRecords& scene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass);
  void Begin(const SceneRecords& scene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass, bool interruptible);
  void Run(const Interrupt& interrupt);
  double LaunchTiles(const std::shared_ptr<Program>& program, bool interruptible);

  std::shared_ptr<TracerResources> shared;
  FrameBlock frameBlock;
  ImageBuffers buffers;
  Buffer lightBuffer;
  Job job; ///< the last one; goes on where image.complete is false
};

Tracer::Tracer(std::shared_ptr<Device> device)
  : Tracer(MakeTracerResources(std::move(device)))
{
}

Tracer::Tracer(std::shared_ptr<TracerResources> shared)
  : state_(std::make_unique<State>())
{
  this->state_->shared = std::move(shared);
}

Tracer::~Tracer() = default;

const Statistics& Tracer::GetStatistics() const
{
  return this->state_->shared->GetStatistics();
}

// The frame's record but for samples and times.
device::FrameRecord Tracer::State::MakeFrame(const SceneRecords& scene, const Camera& camera,
  const std::vector<Light>& lights, const TraceSettings& settings, Pass pass)
{
  device::FrameRecord frame{};
  FillCamera(frame, camera, scene.origin);
  FillSettings(frame, settings, scene.origin);
  const std::vector<device::LightRecord> records = MakeLights(lights, scene.origin);
  frame.lightCount = static_cast<std::uint32_t>(records.size());
  if (records.size() <= device::FEW_LIGHTS)
  {
    std::copy(records.begin(), records.end(), frame.fewLights);
  }
  else
  {
    const std::size_t bytes = records.size() * sizeof(device::LightRecord);
    this->lightBuffer.Fit(this->Vulkan(), bytes);
    this->lightBuffer.Upload(records.data(), bytes);
    frame.lights = this->lightBuffer.Address();
  }
  this->buffers.Fill(frame);
  frame.cullMask = pass == Pass::All ? device::OPAQUE_MASK | device::TRANSLUCENT_MASK
    : pass == Pass::Opaque           ? device::OPAQUE_MASK
                                     : device::TRANSLUCENT_MASK;
  this->shared->PrepareEnvironment(settings, frame);
  return frame;
}

// Prepares the launches of an image; nothing is launched yet.
void Tracer::State::Begin(const SceneRecords& scene, const Camera& camera, const std::vector<Light>& lights,
  const TraceSettings& settings, Pass pass, bool interruptible)
{
  Job& begun = this->job;
  begun = Job();
  begun.settings = settings;
  begun.image.width = settings.width;
  begun.image.height = settings.height;
  begun.image.complete = false;
  const std::size_t pixels = std::size_t(settings.width) * settings.height;
  if (pixels == 0)
  {
    return;
  }
  begun.atMost = SamplesAtOnce(settings, pixels);
  // A thread of a GPU takes its samples one after the other, however few there are.
  begun.fewest = this->shared->device->IsCpu() ? std::min(SamplesAtFirst(settings), begun.atMost) : 1;
  begun.atOnce = begun.fewest;
  const std::uint32_t atOnce = this->Cuts(interruptible) ? begun.fewest : begun.atMost;
  const bool keeps = settings.keepSums || atOnce < settings.samples;
  this->buffers.Prepare(this->Vulkan(), settings, keeps);
  const bool empty = scene.sets.empty();
  if (empty || interruptible || settings.parts > 1)
  {
    this->buffers.Clear();
  }
  if (empty)
  {
    this->buffers.ClearSums();
    return;
  }
  begun.frame = this->MakeFrame(scene, camera, lights, settings, pass);
  begun.specialization = SpecializationFor(scene, lights.size(), settings, pass);
  FillScene(begun.frame, scene);
  begun.frame.accumulates = keeps;
  if (begun.specialization.constants.moves)
  {
    begun.frame.sharedTimeBits = SharedTimeBits(settings, scene.sliceBits);
    FillTimeStrata(begun.frame, settings);
  }

  begun.tiles = FillTiles(begun.frame, settings);
}

// Traces some of the tiles from frame.firstTile on, and makes the next one that. Returns the seconds that it took.
double Tracer::State::LaunchTiles(const std::shared_ptr<Program>& program, bool interruptible)
{
  Stopwatch watch;
  Device::State& vulkan = this->Vulkan();
  device::FrameRecord& frame = this->job.frame;
  constexpr std::uint32_t ofGpu = 512;
  const std::uint32_t together = vulkan.cpu ? static_cast<std::uint32_t>(ThreadCount()) : ofGpu;
  LaunchCost& cost = this->shared->costs.try_emplace(program, LaunchCost{ together }).first->second;
  const std::uint32_t left = std::min(this->job.tiles.end - frame.firstTile, LaunchGrid::mostTiles);
  const std::uint32_t tiles = this->Cuts(interruptible) ? cost.NextTiles(left, frame.samples) : left;
  const LaunchGrid grid(tiles);
  frame.endTile = frame.firstTile + tiles;
  frame.launchWidth = grid.columns * raysPerTile;
  if (!this->frameBlock.Exists())
  {
    this->frameBlock = FrameBlock(vulkan);
  }
  if (frame.lightCount <= device::FEW_LIGHTS)
  {
    frame.lights = this->frameBlock.Lights();
  }
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      this->frameBlock.Send(command, frame);
      program->pipeline->Trace(command, this->frameBlock, frame.launchWidth, grid.rows);
      // The host or a copy reads the results, the next launch adds to them.
      Barrier(command, vulkan.programStages, Access::eShaderWrite,
        vulkan.programStages | Stage::eTransfer | Stage::eHost,
        Access::eShaderRead | Access::eShaderWrite | Access::eTransferRead | Access::eTransferWrite |
          Access::eHostRead);
    });
  frame.firstTile = frame.endTile;
  const double seconds = watch.Lap();
  cost.Add(tiles, frame.samples, seconds);
  return seconds;
}

// Goes on with the job until it is done or the interrupt callback stops it, called after each launch.
void Tracer::State::Run(const Interrupt& interrupt)
{
  Job& work = this->job;
  Stopwatch watch;
  const TraceSettings& settings = work.settings;
  const bool interruptible = static_cast<bool>(interrupt);
  bool stopped = false;
  if (work.tiles.Size() == 0)
  {
    work.image.samples = settings.samples;
  }
  if (work.image.samples < settings.samples)
  {
    const std::shared_ptr<Program> program = this->shared->ProgramFor(work.specialization);
    // Compiling may take many seconds: the callback is called at this interval meanwhile.
    constexpr std::chrono::milliseconds compilingPatience(20);
    while (!stopped && program->compiled.wait_for(compilingPatience) != std::future_status::ready)
    {
      stopped = interruptible && interrupt(work.TracedFraction());
    }
    if (!stopped)
    {
      program->compiled.get();
    }
    while (work.image.samples < settings.samples && !stopped)
    {
      device::FrameRecord& frame = work.frame;
      if (frame.firstTile == work.tiles.begin)
      {
        frame.firstSample = work.image.samples;
        frame.samples =
          std::min(this->Cuts(interruptible) ? work.atOnce : work.atMost, settings.samples - frame.firstSample);
        work.longest = 0.0;
      }
      work.longest = std::max(work.longest, this->LaunchTiles(program, interruptible));
      this->shared->statistics->traceSeconds += watch.Lap();
      if (frame.firstTile == work.tiles.end)
      {
        frame.firstTile = work.tiles.begin;
        work.image.samples += frame.samples;
        work.atOnce = static_cast<std::uint32_t>(
          std::clamp<double>(LaunchCost::NextSamples(frame.samples, work.longest), work.fewest, work.atMost));
        ++this->shared->statistics->dispatches;
        this->shared->statistics->primaryRays += work.tiles.rays * frame.samples;
      }
      stopped = work.image.samples < settings.samples && interruptible && interrupt(work.TracedFraction());
    }
  }
  work.image.complete = work.image.samples == settings.samples;
  work.image.fraction = work.TracedFraction();
  if (work.image.width > 0 && work.image.height > 0)
  {
    this->buffers.Show(work.image);
  }
  this->shared->statistics->traceSeconds += watch.Lap();
}

Image Tracer::Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights, const TraceSettings& settings,
  Pass pass, const Interrupt& interrupt)
{
  CheckSettings(settings);
  State& state = *this->state_;
  const SceneRecords& glyphs = scene.GetState().records;
  state.Vulkan().Guard("tracing an image",
    [&]
    {
      state.Begin(glyphs, camera, lights, settings, pass, static_cast<bool>(interrupt));
      // Resume() needs an image whose Begin() has succeeded.
      state.job.sceneVersion = glyphs.version;
      state.Run(interrupt);
    });
  return state.job.image;
}

void Tracer::CompileAhead(Scene& scene, const std::vector<Light>& lights, const std::vector<TraceSettings>& ofShading)
{
  const SceneRecords& glyphs = scene.GetState().records;
  std::vector<Specialization> wanted;
  for (const Pass pass : { Pass::Opaque, Pass::Translucent })
  {
    if (glyphs.sets.empty() || !scene.GetState().Shows(pass == Pass::Translucent))
    {
      continue;
    }
    for (const TraceSettings& settings : ofShading)
    {
      wanted.push_back(SpecializationFor(glyphs, lights.size(), settings, pass));
    }
  }
  this->state_->Vulkan().programs->CompileAhead(std::move(wanted));
}

Image Tracer::Resume(Scene& scene, std::uint32_t samples, const Interrupt& interrupt)
{
  State& state = *this->state_;
  TraceSettings settings = state.job.settings;
  settings.samples = std::max(settings.samples, samples);
  CheckSettings(settings);
  const bool adds = settings.samples > state.job.settings.samples;
  if (state.job.sceneVersion != scene.GetState().records.version || (adds && !settings.keepSums))
  {
    throw Error("Ray Traced Glyphs: there is no image of this scene, as it is now, to go on with; trace one from its "
                "first sample, with keepSums.");
  }
  state.job.settings = settings;
  state.Vulkan().Guard("tracing an image",
    [&]
    {
      // Another tracer of the view may have brought its own meanwhile.
      state.shared->PrepareEnvironment(state.job.settings, state.job.frame);
      state.Run(interrupt);
    });
  return state.job.image;
}

std::vector<glm::vec4> Tracer::Means(std::vector<float>* missingLight) const
{
  const State& state = *this->state_;
  const Image& image = state.job.image;
  if (!state.job.settings.keepSums || !image.complete || !image.color)
  {
    throw Error("Ray Traced Glyphs: Means() needs an image that was traced with keepSums.");
  }
  return state.Vulkan().Guard("reading an image", [&] { return state.buffers.Means(image.samples, missingLight); });
}

ImageFeatures Tracer::Features() const
{
  const State& state = *this->state_;
  const Image& image = state.job.image;
  if (!state.job.settings.features || !image.complete || !image.color)
  {
    throw Error("Ray Traced Glyphs: Features() needs an image that was traced with features.");
  }
  return state.Vulkan().Guard("reading an image", [&] { return state.buffers.Features(image); });
}

DenoiseTask Tracer::Denoise(std::stop_token stop) const
{
  const State& state = *this->state_;
  DenoiseTask task;
  task.settings_ = state.job.settings;
  task.features_ = this->Features();
  task.means_ = this->Means(task.settings_.groundNormal != glm::vec3(0.0f) ? &task.missingLight_ : nullptr);
  task.shared_ = state.shared;
  task.stop_ = std::move(stop);
  return task;
}

} // namespace rtg
