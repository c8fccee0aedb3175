#include "TracerResources.h"

namespace rtg
{

std::shared_ptr<TracerResources>
MakeTracerResources(std::shared_ptr<Device> device, std::shared_ptr<Statistics> statistics)
{
  return std::make_shared<TracerResources>(std::move(device), std::move(statistics));
}

const Statistics& StatisticsOf(TracerResources& resources)
{
  return resources.GetStatistics();
}

TracerResources::TracerResources(std::shared_ptr<Device> d, std::shared_ptr<Statistics> s)
  : device(std::move(d))
  , statistics(std::move(s))
{
}

std::shared_ptr<Program> TracerResources::ProgramFor(const Specialization& specialization)
{
  const auto [program, begins] = this->device->GetState().programs->Get(specialization);
  this->statistics->pipelineBuilds += begins;
  std::erase_if(this->costs, [](const auto& cost) { return cost.first.expired(); });
  return program;
}

void TracerResources::PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame)
{
  if (!settings.environmentImage || !TraitsOf(settings).environmentImage)
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
    this->groundNormal_ = glm::vec3(0.0f);
  }
  if (this->groundNormal_ != settings.groundNormal)
  {
    this->groundNormal_ = settings.groundNormal;
    this->groundMean_ = MeanRadiance(image, settings.groundNormal);
  }
  frame.groundSky = frame.environment * this->groundMean_;
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
  this->statistics->deviceBytes = this->device->HeldBytes();
  this->statistics->programsAhead = this->device->GetState().programs->Ahead();
  this->statistics->denoiseSeconds += this->denoiseSeconds.exchange(0.0);
  return *this->statistics;
}

} // namespace rtg
