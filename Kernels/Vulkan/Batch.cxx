#include "Batch.h"

#include <algorithm>
#include <utility>

namespace rtg
{

thread_local Batch* Device::State::batch = nullptr;

Batch::Batch(Device::State& device)
  : device_(device)
  , outer_(std::exchange(device.batch, this))
{
}

Batch::~Batch()
{
  this->device_.batch = this->outer_;
}

void* Batch::Stage(const Buffer& target, std::size_t offset, std::size_t size)
{
  // More than this is copied before the batch goes on. It fits into one shared block of memory, which is kept: NVIDIA's
  // driver takes a third of a millisecond for each megabyte of the host's memory that it is to see.
  constexpr std::size_t mostStaged = 3 * mostAtOnce;
  if (this->staged_ > 0 && this->staged_ + size > mostStaged)
  {
    this->Run();
  }
  if (this->staging_.empty() || this->stagingUsed_ + size > this->staging_.back().Size())
  {
    this->staging_.emplace_back(
      this->device_, std::max(size, mostAtOnce), vk::BufferUsageFlagBits::eTransferSrc, Buffer::Place::Host);
    this->stagingUsed_ = 0;
  }
  Buffer& block = this->staging_.back();
  this->copies_.push_back({ block.Handle(), target.Handle(), vk::BufferCopy(this->stagingUsed_, offset, size) });
  void* place = static_cast<char*>(block.Mapped()) + this->stagingUsed_;
  this->stagingUsed_ += (size + 15) / 16 * 16;
  this->staged_ += size;
  return place;
}

void Batch::Build(const vk::AccelerationStructureBuildGeometryInfoKHR& info,
  const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count, std::size_t scratchSize, Buffer&& input)
{
  this->builds_.push_back({ info, geometry, count });
  this->inputs_.push_back(std::move(input));
  this->scratchSize_ = std::max(this->scratchSize_, scratchSize);
}

void Batch::Run()
{
  if (this->copies_.empty() && this->builds_.empty())
  {
    return;
  }
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  // The scratch address must be aligned to the device's limit.
  const std::size_t alignment = this->device_.structureLimits.minAccelerationStructureScratchOffsetAlignment;
  const Buffer scratch(this->device_, this->builds_.empty() ? 0 : this->scratchSize_ + alignment,
    vk::BufferUsageFlagBits::eStorageBuffer, Buffer::Place::Device);
  this->device_.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      for (const Copy& copy : this->copies_)
      {
        command.copyBuffer(copy.from, copy.to, copy.region);
      }
      if (!this->copies_.empty())
      {
        Barrier(command, Stage::eTransfer, Access::eTransferWrite, this->device_.programStages, Access::eShaderRead);
      }
      for (StructureBuild& build : this->builds_)
      {
        build.info.setGeometries(build.geometry);
        build.info.scratchData.deviceAddress = (scratch.Address() + alignment - 1) / alignment * alignment;
        const vk::AccelerationStructureBuildRangeInfoKHR range(build.count, 0, 0, 0);
        command.buildAccelerationStructuresKHR(build.info, &range);
        // The next one uses the same scratch memory, and may be built over this one.
        Barrier(command, Stage::eAccelerationStructureBuildKHR, Access::eAccelerationStructureWriteKHR,
          this->device_.programStages, Access::eAccelerationStructureReadKHR | Access::eAccelerationStructureWriteKHR);
      }
    });
  this->copies_.clear();
  this->builds_.clear();
  this->inputs_.clear();
  this->staging_.clear();
  this->stagingUsed_ = this->staged_ = this->scratchSize_ = 0;
}

} // namespace rtg
