#include "ProgramLibrary.h"

#include "../Parallel.h"

#include <algorithm>
#include <chrono>

namespace rtg
{

namespace
{

constexpr std::size_t keptPrograms = 64;

// Some drivers compile when a pipeline is made, others at its first launch: that is one of no pixel.
void Compile(Device::State& vulkan, Program& program)
{
  auto pipeline = std::make_unique<Pipeline>(vulkan, program.specialization);
  device::FrameRecord frame{};
  frame.tileStride = frame.tileCount = frame.tileColumns = 1;
  frame.launchWidth = 1;
  FrameBlock block(vulkan);
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      block.Send(command, frame);
      pipeline->Trace(command, block, 1, 1);
    });
  program.pipeline = std::move(pipeline);
}

bool IsCompiling(const Program& program)
{
  return program.compiled.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

bool HasFailed(const std::shared_ptr<Program>& program)
{
  return !IsCompiling(*program) && !program->pipeline;
}

} // namespace

ProgramLibrary::ProgramLibrary(Device::State& device)
  : device_(&device)
{
}

ProgramLibrary::~ProgramLibrary()
{
  std::unique_lock<std::mutex> lock(this->mutex_);
  this->idle_.wait(lock, [this] { return this->atWork_ == 0; });
}

std::pair<std::shared_ptr<Program>, bool> ProgramLibrary::Get(const Specialization& specialization)
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  std::erase_if(this->programs_, HasFailed);
  const auto found = std::find_if(this->programs_.begin(), this->programs_.end(),
    [&](const auto& program) { return program->specialization == specialization; });
  if (found != this->programs_.end())
  {
    std::rotate(found, found + 1, this->programs_.end());
    return { this->programs_.back(), false };
  }
  if (this->programs_.size() >= keptPrograms)
  {
    // One that is being compiled must stay: its thread uses it.
    const auto oldest = std::find_if_not(
      this->programs_.begin(), this->programs_.end(), [](const auto& program) { return IsCompiling(*program); });
    if (oldest != this->programs_.end())
    {
      this->programs_.erase(oldest);
    }
  }
  const auto program = std::make_shared<Program>();
  program->specialization = specialization;
  const auto compiling =
    std::make_shared<std::packaged_task<void()>>([device = this->device_, p = program.get()] { Compile(*device, *p); });
  program->compiled = compiling->get_future();
  this->programs_.push_back(program);
  RunInBackground(
    [this, compiling]
    {
      (*compiling)();
      // The program is used meanwhile.
      this->device_->SavePrograms();
      const std::lock_guard<std::mutex> done(this->mutex_);
      --this->atWork_;
      this->idle_.notify_all();
    });
  ++this->atWork_;
  return { program, true };
}

} // namespace rtg
