#pragma once

#include "Buffer.h"

#include <vector>

namespace rtg
{

/// Copies to the device and builds of acceleration structures that are submitted together and waited for once. Builds
/// run after the copies, one after the other, each seeing what those before it built. While one lives, all of its
/// thread's Buffer::Write() and builds go into it; what they made may be used when Run() has returned, and is empty if
/// that is never called.
class Batch
{
public:
  explicit Batch(Device::State& device);
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  /// Bytes of one call of Stage().
  static constexpr std::size_t mostAtOnce = std::size_t(4) << 20;

  /// Host memory, to be filled before the next call, whose content will be copied into `target` from `offset` on.
  void* Stage(const Buffer& target, std::size_t offset, std::size_t size);
  /// `input`: what the geometry is read from, kept until the build is done; the info's scratch address is filled in.
  void Build(const vk::AccelerationStructureBuildGeometryInfoKHR& info,
    const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count, std::size_t scratchSize, Buffer&& input);
  void Run();

private:
  struct Copy
  {
    vk::Buffer from, to;
    vk::BufferCopy region;
  };
  struct StructureBuild
  {
    vk::AccelerationStructureBuildGeometryInfoKHR info;
    vk::AccelerationStructureGeometryKHR geometry;
    std::uint32_t count;
  };

  Device::State& device_;
  Batch* outer_;
  std::vector<Buffer> staging_; ///< the last one is filled up to stagingUsed_
  std::size_t stagingUsed_ = 0, staged_ = 0;
  std::vector<Copy> copies_;
  std::vector<StructureBuild> builds_;
  std::vector<Buffer> inputs_;
  std::size_t scratchSize_ = 0;
};

} // namespace rtg
