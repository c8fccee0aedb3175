#include "TracerResources.h"

#include "BlueNoise.h"
#include "SceneState.h"

#include <algorithm>

namespace rtg
{

namespace
{

constexpr std::uint32_t blueNoiseSide = 64; ///< as in Shading/Sampling.glsl
constexpr std::size_t keptPrograms = 16;

} // namespace

std::shared_ptr<TracerResources> MakeTracerResources(std::shared_ptr<Device> device)
{
  return std::make_shared<TracerResources>(std::move(device));
}

const Statistics& StatisticsOf(TracerResources& resources)
{
  return resources.GetStatistics();
}

TracerResources::TracerResources(std::shared_ptr<Device> d)
  : device(std::move(d))
{
}

TracerResources::Program& TracerResources::ProgramFor(
  const Generation& generation, const std::vector<HitGroup>& groups)
{
  const auto found = std::find_if(this->programs_.begin(), this->programs_.end(),
    [&](const auto& p)
    { return p->pipeline->GetGeneration() == generation && p->pipeline->Groups() == groups; });
  if (found != this->programs_.end())
  {
    std::rotate(found, found + 1, this->programs_.end());
    return *this->programs_.back();
  }
  if (this->programs_.size() >= keptPrograms)
  {
    this->programs_.erase(this->programs_.begin());
  }
  auto program = std::make_unique<Program>();
  program->pipeline = std::make_unique<Pipeline>(this->device->GetState(), generation, groups);
  this->programs_.push_back(std::move(program));
  ++this->statistics.pipelineBuilds;
  return *this->programs_.back();
}

void TracerResources::PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame)
{
  if (!settings.environmentImage || settings.shading != Shading::PathTracing)
  {
    return;
  }
  const EnvironmentImage& image = *settings.environmentImage;
  if (this->environment_ != settings.environmentImage)
  {
    Device::State& vulkan = this->device->GetState();
    this->environment_.reset();
    this->environmentCells_ = MakeEnvironmentCells(image);
    this->environmentTexels_ = Buffer();
    this->environmentTexels_ = Send(vulkan, image.radiance);
    this->environmentCellBuffer_ = Buffer();
    this->environmentCellBuffer_ = Send(vulkan, this->environmentCells_.cells);
    this->environment_ = settings.environmentImage;
  }
  frame.environmentTexels = this->environmentTexels_.Address();
  frame.environmentSize = { image.width, image.height };
  frame.environmentThreshold = this->environmentCells_.threshold;
  frame.environmentRight = image.right;
  frame.environmentUp = image.up;
  if (!this->environmentCells_.cells.empty())
  {
    frame.environmentCells = this->environmentCellBuffer_.Address();
    frame.environmentCellSide = this->environmentCells_.side;
    frame.environmentCellColumns = this->environmentCells_.columns;
    frame.environmentCellRows = this->environmentCells_.rows;
  }
}

const Statistics& TracerResources::GetStatistics()
{
  this->statistics.deviceBytes = this->device->GetState().bytes;
  this->statistics.denoiseSeconds = this->denoiseSeconds;
  return this->statistics;
}

vk::DeviceAddress TracerResources::BlueNoise()
{
  if (this->blueNoise_.Size() == 0)
  {
    this->blueNoise_ = Send(this->device->GetState(), BlueNoiseTile(blueNoiseSide));
  }
  return this->blueNoise_.Address();
}

} // namespace rtg
