#include "ProgramLibrary.h"

#include "../Stopwatch.h"
#include "../System.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <string>
#include <system_error>
#include <thread>

namespace rtg
{

namespace
{

constexpr std::size_t keptPrograms = 24; // lavapipe takes some 17 MB for each

// Some drivers compile when a pipeline is made, others at its first launch: that is one of no pixel, which takes so
// many seconds.
std::unique_ptr<Pipeline> MakePipeline(Device::State& vulkan, const Specialization& specialization, double& seconds)
{
  auto pipeline =
    std::make_unique<Pipeline>(vulkan, programs::modules[specialization.program], specialization.constants);
  device::FrameRecord frame{};
  frame.tileStride = frame.tileCount = frame.tileColumns = 1;
  frame.launchWidth = 1;
  FrameBlock block(vulkan);
  Stopwatch watch;
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      block.Send(command, frame);
      pipeline->Trace(command, block, 1, 1);
    });
  seconds = watch.Lap();
  return pipeline;
}

// lavapipe compiles where it launches, so that what is launched next waits. It keeps what it has compiled on disk, when
// a device goes at the latest: another device compiles first, beside which this one has nothing left to do.
std::unique_ptr<Pipeline> MakePipelineAside(Device::State& vulkan, const Specialization& specialization)
{
  static std::atomic<bool> helps{ true }; // the user may have switched that cache off
  constexpr double worthSaving = 0.2;     // seconds
  double before = 0.0, after = 0.0;
  if (vulkan.cpu && helps)
  {
    try
    {
      MakePipeline(Device::Another()->GetState(), specialization, before);
    }
    catch (const std::exception&) // this device may have what the other lacked
    {
    }
  }
  std::unique_ptr<Pipeline> pipeline = MakePipeline(vulkan, specialization, after);
  helps = helps && (before < worthSaving || after < 0.5 * before);
  return pipeline;
}

bool IsCompiling(const Program& program)
{
  return program.compiled.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

} // namespace

ProgramLibrary::ProgramLibrary(Device::State& device)
  : device_(&device)
{
}

ProgramLibrary::~ProgramLibrary()
{
  std::unique_lock<std::mutex> lock(this->mutex_);
  this->ahead_.clear();
  this->idle_.wait(lock, [this] { return this->atWork_ == 0; });
}

std::pair<std::shared_ptr<Program>, bool> ProgramLibrary::Get(const Specialization& specialization)
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  const auto hasFailed = [](const auto& program) { return !IsCompiling(*program) && !program->pipeline; };
  std::erase_if(this->programs_, hasFailed);
  std::shared_ptr<Program> program = this->Find(specialization);
  const bool begins = !program;
  if (begins)
  {
    program = this->Add(specialization);
  }
  // On a busy machine what was begun ahead takes very long.
  if (begins || (program->ahead && IsCompiling(*program)))
  {
    program->ahead = false;
    try
    {
      std::thread(
        [this, program]() mutable
        {
          this->Compile(*program);
          const std::lock_guard<std::mutex> done(this->mutex_);
          program.reset(); // the device may go as soon as nothing is at work
          --this->atWork_;
          this->idle_.notify_all();
        })
        .detach();
      ++this->atWork_; // the thread ends with the mutex, which is held here
    }
    catch (const std::system_error& error)
    {
      program->done.set_exception(std::make_exception_ptr(
        Error(std::string("Ray Traced Glyphs: the system starts no thread that compiles a shader: ") + error.what() +
          ". Close other programs or raise the limit of threads (ulimit -u).")));
    }
  }
  return { program, begins };
}

// The thread that is ready first makes the program.
void ProgramLibrary::Compile(Program& program)
{
  std::unique_ptr<Pipeline> pipeline;
  std::exception_ptr failure;
  try
  {
    pipeline = MakePipelineAside(*this->device_, program.specialization);
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(this->mutex_);
  if (IsCompiling(program))
  {
    program.pipeline = std::move(pipeline);
    failure ? program.done.set_exception(failure) : program.done.set_value();
  }
}

// The program of that key, which now is the last used one; null: there is none. The mutex is held.
std::shared_ptr<Program> ProgramLibrary::Find(const Specialization& specialization)
{
  const auto found = std::find_if(this->programs_.begin(), this->programs_.end(),
    [&](const auto& program) { return program->specialization == specialization; });
  if (found == this->programs_.end())
  {
    return nullptr;
  }
  std::rotate(found, found + 1, this->programs_.end());
  return this->programs_.back();
}

// A program that is to be compiled. The mutex is held.
std::shared_ptr<Program> ProgramLibrary::Add(const Specialization& specialization)
{
  if (this->programs_.size() >= keptPrograms)
  {
    const auto oldest = std::find_if_not(
      this->programs_.begin(), this->programs_.end(), [](const auto& program) { return IsCompiling(*program); });
    if (oldest != this->programs_.end())
    {
      this->programs_.erase(oldest);
    }
  }
  const auto program = std::make_shared<Program>();
  program->specialization = specialization;
  this->programs_.push_back(program);
  return program;
}

void ProgramLibrary::CompileAhead(std::vector<Specialization> wanted)
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  std::erase_if(wanted, [this](const Specialization& one) { return this->Find(one) != nullptr; });
  this->ahead_ = std::move(wanted);
  if (!this->ahead_.empty() && !this->worksAhead_)
  {
    try
    {
      std::thread([this] { this->WorkAhead(); }).detach();
      this->worksAhead_ = true;
      ++this->atWork_;
    }
    catch (const std::system_error&) // what is not compiled ahead is compiled when it is needed
    {
      this->ahead_.clear();
    }
  }
}

std::size_t ProgramLibrary::Ahead()
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  return this->ahead_.size() + this->worksAhead_;
}

// In a thread of its own, because what has the lowest priority keeps it.
void ProgramLibrary::WorkAhead()
{
  LowerPriority();
  std::unique_lock<std::mutex> lock(this->mutex_);
  while (!this->ahead_.empty())
  {
    const Specialization next = this->ahead_.back();
    this->ahead_.pop_back();
    if (!this->Find(next))
    {
      const std::shared_ptr<Program> program = this->Add(next);
      program->ahead = true;
      lock.unlock();
      this->Compile(*program);
      lock.lock();
    }
  }
  this->worksAhead_ = false;
  --this->atWork_;
  this->idle_.notify_all();
}

} // namespace rtg
