#include "Launcher.h"

#include "Stopwatch.h"
#include "Tiles.h"

#include <algorithm>

namespace rtg
{

namespace
{

constexpr std::uint32_t mostTiles = 16 * LaunchGrid::mostColumns; ///< of a launch: 29 MB of ray records
/// Seconds that a launch is to take where launches are cut: a user who stops it, or whose display stands still, waits
/// so long.
constexpr double launchSeconds = 0.04;

} // namespace

Launcher::Launcher(std::shared_ptr<Device> device)
  : device_(std::move(device))
{
}

void Launcher::FitRays(const Generation& generation, std::size_t count)
{
  if (generation.ownTrees)
  {
    this->rays_ = Buffer();
  }
  else
  {
    this->rays_.Fit(this->device_->GetState(), count * sizeof(device::RayRecord));
  }
}

void Launcher::FitTiles(const Generation& generation, std::uint32_t tiles)
{
  // A smaller launch may have more places without a tile.
  const std::uint32_t largest = std::min(mostTiles, tiles);
  this->FitRays(generation, std::size_t(largest + LaunchGrid(largest).rows) * raysPerTile);
}

// Launches width x height rays.
void Launcher::Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame,
  std::uint32_t width, std::uint32_t height)
{
  Device::State& vulkan = this->device_->GetState();
  frame.launchWidth = width;
  frame.rays = this->rays_.Address();
  frame.topLevels = scene.topLevelAddresses.Address();
  frame.topLevelCount = static_cast<std::uint32_t>(scene.topLevels.size());
  frame.onlySet = scene.records.front();
  if (!this->frameBlock_.Exists())
  {
    this->frameBlock_ = FrameBlock(vulkan);
  }
  if (frame.lightCount <= device::FEW_LIGHTS)
  {
    frame.lights = this->frameBlock_.Lights();
  }
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      this->frameBlock_.Send(command, frame);
      pipeline.Trace(command, this->frameBlock_, width, height);
      // The host or a copy reads the results, the next launch adds to them.
      Barrier(command, vulkan.programStages, Access::eShaderWrite,
        vulkan.programStages | Stage::eTransfer | Stage::eHost,
        Access::eShaderRead | Access::eShaderWrite | Access::eTransferRead | Access::eTransferWrite |
          Access::eHostRead);
    });
}

bool Launcher::Cuts(bool interruptible) const
{
  return interruptible || !this->device_->IsCpu();
}

double Launcher::NextSamples(std::uint32_t samples, double longest)
{
  return samples * std::min(8.0, launchSeconds / std::max(longest, 1e-9));
}

// Of the `left` tiles those of the next launch, as far as the program's launches so far tell: at most eight times as
// many as in the last one, because costs differ, and eight in the first.
std::uint32_t Launcher::TilesAtOnce(const TracerResources::UsedProgram& program, const Generation& generation,
  std::uint32_t left, std::uint32_t samples, bool interruptible) const
{
  const Device::State& vulkan = this->device_->GetState();
  // Compute shaders may have 65,535 groups along each axis, which the tiles of a launch stay below.
  const std::uint32_t limit = generation.ownTrees
    ? mostTiles
    : std::max(1u, std::min(mostTiles, vulkan.pipelineLimits.maxRayDispatchInvocationCount / raysPerTile));
  const std::uint32_t most =
    std::min(left, limit > LaunchGrid::mostColumns ? limit - limit % LaunchGrid::mostColumns : limit);
  if (!this->Cuts(interruptible))
  {
    return most;
  }
  if (program.secondsPerRay <= 0.0)
  {
    return std::min(most, 8u);
  }
  const double tileSeconds = program.secondsPerRay * raysPerTile * samples;
  const double wanted = std::min(launchSeconds / tileSeconds, 8.0 * static_cast<double>(program.lastTiles));
  return std::min(most, static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 1e9)));
}

double Launcher::LaunchTiles(TracerResources::UsedProgram& program, const Generation& generation,
  const Scene::State& scene, device::FrameRecord& frame, std::uint32_t end, bool interruptible)
{
  Stopwatch watch;
  const std::uint32_t tiles =
    this->TilesAtOnce(program, generation, end - frame.firstTile, frame.samples, interruptible);
  frame.endTile = frame.firstTile + tiles;
  const LaunchGrid grid(tiles);
  this->Launch(*program.program->pipeline, scene, frame, grid.columns * raysPerTile, grid.rows);
  frame.firstTile = frame.endTile;
  // Of old and new costs the mean: launches differ.
  const double seconds = watch.Lap();
  const double cost = seconds / (double(tiles) * raysPerTile * frame.samples);
  program.secondsPerRay = program.secondsPerRay > 0.0 ? 0.5 * (program.secondsPerRay + cost) : cost;
  program.lastTiles = std::max(tiles, 8u);
  return seconds;
}

void Launcher::LaunchProbes(TracerResources::UsedProgram& program, const Generation& generation,
  const Scene::State& scene, device::FrameRecord& frame)
{
  const LaunchGrid grid(DivideUp(frame.probeCount, raysPerTile));
  this->FitRays(generation, std::size_t(grid.columns) * grid.rows * raysPerTile);
  this->Launch(*program.program->pipeline, scene, frame, grid.columns * raysPerTile, grid.rows);
}

} // namespace rtg
