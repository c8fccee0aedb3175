#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace rtg
{

/// The Vulkan device that traces. One is shared by all views of a process.
class Device
{
public:
  /// The process's device, made on first call: the one that the environment variable RTGLYPHS_DEVICE
  /// names (an index into, or part of a name in, the list of Vulkan devices), else the first GPU,
  /// else Mesa's lavapipe. Throws rtg::Error that says what is missing and how to
  /// install it; a later call tries again. After the device was lost, the next call makes a new one.
  static std::shared_ptr<Device> Shared();

  /// Another device of the same kind, for work that would delay this one's launches; not shared.
  static std::shared_ptr<Device> Another();

  struct Choice
  {
    std::string name;
    bool cpu = false;
  };
  /// The device that Shared() would make; lists the drivers' devices and makes none. Throws as Shared() does.
  static Choice Chosen();

  ~Device();
  std::string Name() const;
  bool IsCpu() const;
  bool Lost() const;
  /// Device memory that all buffers of the process hold.
  std::uint64_t HeldBytes() const;

  struct State; ///< Vulkan handles; for Kernels only, see Vulkan/DeviceState.h
  State& GetState() { return *this->state_; }

private:
  Device();
  void Choose();
  void Start();

  std::unique_ptr<State> state_;
};

} // namespace rtg
