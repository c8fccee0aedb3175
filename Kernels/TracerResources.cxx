#include "TracerResources.h"

#include "Parallel.h"
#include "SceneState.h"

#include <algorithm>

namespace rtg
{

namespace
{

constexpr std::size_t keptPrograms = 16;

// Some drivers compile when a pipeline is made, others at its first launch: that is one of no pixel.
void Compile(Device::State& vulkan, TracerResources::Program& program)
{
  program.pipeline = std::make_unique<Pipeline>(vulkan, program.generation, program.groups);
  device::FrameRecord frame{};
  frame.tileStride = frame.tileCount = frame.tileColumns = 1;
  frame.launchWidth = 1;
  Buffer buffer(vulkan, sizeof(frame), vk::BufferUsageFlagBits::eUniformBuffer, Buffer::Place::Host);
  buffer.Upload(&frame, sizeof(frame));
  vulkan.Submit([&](vk::raii::CommandBuffer& command) { program.pipeline->Trace(command, buffer, 1, 1); });
  vulkan.SavePrograms();
}

} // namespace

TracerResources::Program::~Program()
{
  if (this->compiling.valid())
  {
    this->compiling.wait();
  }
}

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

TracerResources::Program&
TracerResources::ProgramFor(const Generation& generation, const std::vector<HitGroup>& ofScene)
{
  const std::vector<HitGroup> groups = generation.ownTrees ? std::vector<HitGroup>() : ofScene;
  const auto found = std::find_if(this->programs_.begin(), this->programs_.end(),
    [&](const auto& p) { return p->generation == generation && p->groups == groups; });
  if (found != this->programs_.end())
  {
    std::rotate(found, found + 1, this->programs_.end());
    return *this->programs_.back();
  }
  if (this->programs_.size() >= keptPrograms)
  {
    this->programs_.erase(this->programs_.begin());
  }
  this->programs_.push_back(std::make_unique<Program>());
  Program& program = *this->programs_.back();
  program.generation = generation;
  program.groups = groups;
  std::packaged_task<void()> compiling([this, &program] { Compile(this->device->GetState(), program); });
  program.compiling = compiling.get_future();
  RunInBackground(std::move(compiling));
  return program;
}

bool TracerResources::IsCompiled(Program& program, std::chrono::milliseconds patience)
{
  if (program.compiling.valid())
  {
    if (program.compiling.wait_for(patience) != std::future_status::ready)
    {
      return false;
    }
    this->WaitFor(program);
  }
  return true;
}

void TracerResources::WaitFor(Program& program)
{
  if (!program.compiling.valid())
  {
    return;
  }
  try
  {
    program.compiling.get();
    ++this->statistics.pipelineBuilds;
  }
  catch (...)
  {
    this->programs_.erase(std::find_if(
      this->programs_.begin(), this->programs_.end(), [&program](const auto& p) { return p.get() == &program; }));
    throw;
  }
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

} // namespace rtg
