#include "Launcher.h"

#include "Stopwatch.h"
#include "Tiles.h"

#include <algorithm>

namespace rtg
{

namespace
{

constexpr std::uint32_t mostTiles = 16 * LaunchGrid::mostColumns; ///< of a launch
/// Seconds that a launch is to take where launches are cut: a user who stops it, or whose display stands still, waits
/// so long.
constexpr double launchSeconds = 0.02;

} // namespace

Launcher::Launcher(std::shared_ptr<Device> device)
  : device_(std::move(device))
{
}

// Launches width x height rays.
void Launcher::Launch(const Pipeline& pipeline, device::FrameRecord& frame, std::uint32_t width, std::uint32_t height)
{
  Device::State& vulkan = this->device_->GetState();
  frame.launchWidth = width;
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

// The number of tiles of the next launch, out of `left`, by the measured cost of the program's launches: at most eight
// times as many as in the last one, because costs differ, and eight in the first.
std::uint32_t Launcher::TilesAtOnce(
  const TracerResources::Cost& cost, std::uint32_t left, std::uint32_t samples, bool interruptible) const
{
  // Compute shaders may have 65,535 groups along each axis, which the tiles of a launch stay below.
  const std::uint32_t most = std::min(left, mostTiles);
  if (!this->Cuts(interruptible))
  {
    return most;
  }
  const double tileSeconds = cost.secondsPerRay * raysPerTile * samples;
  if (tileSeconds <= 0.0)
  {
    return std::min(most, 8u);
  }
  const double wanted = std::min(launchSeconds / tileSeconds, 8.0 * cost.lastTiles);
  return std::min(most, static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 1e9)));
}

double Launcher::LaunchTiles(const Pipeline& pipeline, TracerResources::Cost& cost, device::FrameRecord& frame,
  std::uint32_t end, bool interruptible)
{
  Stopwatch watch;
  const std::uint32_t tiles = this->TilesAtOnce(cost, end - frame.firstTile, frame.samples, interruptible);
  frame.endTile = frame.firstTile + tiles;
  const LaunchGrid grid(tiles);
  this->Launch(pipeline, frame, grid.columns * raysPerTile, grid.rows);
  frame.firstTile = frame.endTile;
  // The mean of old and new costs, because launches differ.
  const double seconds = watch.Lap();
  const double perRay = seconds / (double(tiles) * raysPerTile * frame.samples);
  cost.secondsPerRay = cost.secondsPerRay > 0.0 ? 0.5 * (cost.secondsPerRay + perRay) : perRay;
  cost.lastTiles = std::max(tiles, 8u);
  return seconds;
}

} // namespace rtg
