#pragma once

#include "Buffer.h"
#include "Programs.h"

#include "../HostDevice.h"

#include <cstddef>
#include <vector>

namespace rtg
{

/// The specialization constants of a program (Variants.h), by which Specialize() makes it.
struct Constants
{
#define RTG_FIELD(id, type, name) std::uint32_t name = 0;
  RTG_CONSTANTS(RTG_FIELD)
#undef RTG_FIELD

  bool operator==(const Constants&) const = default;
};

/// A program, and what it is specialized for.
struct Specialization
{
  std::uint32_t program = 0; ///< number of a shading
  Constants constants;

  bool operator==(const Specialization&) const = default;
};

/// A program whose specialization constants have these values, without the branches that are then never taken and
/// without the functions that are called in these alone. Drivers inline every function before they look at constants,
/// which takes seconds for shapes that are not there. Throws rtg::Error.
std::vector<std::uint32_t> Specialize(const programs::Code& code, const Constants& constants);

/// The uniform block of a launch, and the descriptor by which programs see it.
class FrameBlock
{
public:
  FrameBlock() = default; ///< none
  explicit FrameBlock(Device::State& device);

  bool Exists() const { return this->buffer_.Size() > 0; }
  /// For the launches that are recorded after it. Not while one before is still running.
  void Send(vk::raii::CommandBuffer& command, const device::FrameRecord& frame);
  vk::DescriptorSet Descriptor() const { return *this->set_; }
  /// Address of the block's own few lights.
  vk::DeviceAddress Lights() const { return this->buffer_.Address() + offsetof(device::FrameRecord, fewLights); }

private:
  Device::State* device_ = nullptr;
  Buffer buffer_;
  vk::raii::DescriptorPool pool_{ nullptr };
  vk::raii::DescriptorSet set_{ nullptr };
};

/// A compiled program.
class Pipeline
{
public:
  /// Throws vk::SystemError.
  Pipeline(Device::State& device, const programs::Code& code, const Constants& constants);

  /// Binds and launches; `frame` is the uniform block that the program sees. In any thread.
  void
  Trace(vk::raii::CommandBuffer& command, const FrameBlock& frame, std::uint32_t width, std::uint32_t height) const;

private:
  Device::State* device_;
  vk::raii::Pipeline pipeline_{ nullptr };
};

} // namespace rtg
