// Vulkan handles of a Device, for Kernels only.
#pragma once

#include "Device.h"
#include "Memory.h"

#include "../Glyphs.h"

#include <vulkan/vulkan_raii.hpp>

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <vector>

namespace rtg
{

class Batch;
class ProgramLibrary;

/// Makes what was written in the first stages visible to accesses in the second ones.
inline void Barrier(vk::raii::CommandBuffer& command, vk::PipelineStageFlags from, vk::AccessFlags written,
  vk::PipelineStageFlags to, vk::AccessFlags seen)
{
  command.pipelineBarrier(from, to, {}, vk::MemoryBarrier(written, seen), {}, {});
}

struct Device::State
{
  vk::raii::Context context;
  vk::raii::Instance instance{ nullptr };
  vk::raii::PhysicalDevice physical{ nullptr };
  vk::raii::Device device{ nullptr };
  vk::raii::Queue queue{ nullptr };
  std::mutex queueMutex; ///< programs are compiled in threads of their own
  Memory memory;
  vk::PhysicalDeviceMemoryProperties memoryTypes;
  vk::PhysicalDeviceAccelerationStructurePropertiesKHR structureLimits;
  /// Bytes of a buffer, and of an allocation: drivers may give more than they say of the latter. Tests lower them.
  vk::DeviceSize mostOfBuffer = std::numeric_limits<vk::DeviceSize>::max(), mostOfAllocation = mostOfBuffer;
  std::uint32_t queueFamily = 0;
  std::string name;
  bool cpu = false;
  /// Programs run on the host's processor, so that its memory is theirs: every buffer is mapped and nothing is copied.
  /// Tests switch it off to have a CPU device treated like others.
  bool sharesMemory = false;
  /// The driver has acceleration structures and ray queries. For a GPU this means ray-tracing hardware: a
  /// driver that emulates it, as NVIDIA's does, has ray-tracing pipelines, but no ray queries
  /// (github.com/KhronosGroup/Vulkan-Docs/issues/1241).
  bool rayQueries = false;
  vk::PipelineStageFlags programStages; ///< in which programs run and structures are built
  std::atomic<bool> lost{ false };

  vk::raii::DescriptorSetLayout frameLayout{ nullptr }; ///< of all programs: the uniform block of a launch
  vk::raii::PipelineLayout programLayout{ nullptr };
  std::atomic<std::uint64_t> submissions{ 0 }; ///< so far
  static thread_local Batch* batch; ///< that copies and builds of this thread go into; null: each copy is done at once

  /// Records commands, submits them and waits until they are done. In any thread.
  void Submit(const std::function<void(vk::raii::CommandBuffer&)>& record);

  /// Runs `work`; throws failures of Vulkan, and exhausted memory of the computer, as one rtg::Error
  /// that says what was being done.
  template <class Work>
  auto Guard(const char* doing, Work&& work) -> decltype(work())
  {
    try
    {
      return work();
    }
    catch (const vk::SystemError& error)
    {
      this->Rethrow(doing, error);
    }
    catch (const std::bad_alloc&)
    {
      this->ThrowOutOfMemory(doing, "the computer's memory does not suffice");
    }
  }

private:
  // Objects of one submission, made once: drivers ask the system for memory to make it.
  struct Submission
  {
    vk::raii::CommandPool pool{ nullptr };
    vk::raii::CommandBuffer command{ nullptr };
    vk::raii::Fence done{ nullptr };
  };
  Submission TakeSubmission();

  std::mutex submissionMutex_;
  std::vector<Submission> idleSubmissions_; ///< as many as threads have submitted at once

  [[noreturn]] void Rethrow(const char* doing, const vk::SystemError& error);
  [[noreturn]] void ThrowOutOfMemory(const char* doing, const std::string& what);

public:
  std::unique_ptr<ProgramLibrary> programs; ///< goes first: its threads use all of the above
};

} // namespace rtg
