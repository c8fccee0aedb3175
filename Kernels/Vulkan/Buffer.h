#pragma once

#include "DeviceState.h"

#include <cstddef>
#include <functional>

namespace rtg
{

/// A buffer with its own memory and a device address.
class Buffer
{
public:
  enum class Place
  {
    Device, ///< fastest for programs; filled by Upload()
    Host    ///< mapped; programs may write it and the host reads it, or the other way round
  };

  Buffer() = default;
  /// Throws vk::SystemError. A size of zero makes an empty buffer with address 0.
  Buffer(Device::State& device, std::size_t size, vk::BufferUsageFlags usage, Place place);
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  std::size_t Size() const { return this->size_; }
  vk::Buffer Handle() const { return *this->buffer_; }
  vk::DeviceAddress Address() const { return this->address_; }
  /// Host pointer; null for a Place::Device buffer whose memory the host cannot reach.
  void* Mapped() const { return this->mapped_; }

  /// Copies host data to the start of the buffer, through a staging buffer when it is not mapped.
  void Upload(const void* data, std::size_t size);
  /// Lets `fill` write so many bytes, which then are at the start of the buffer.
  void Write(std::size_t size, const std::function<void(void*)>& fill);

private:
  Device::State* device_ = nullptr;
  std::size_t size_ = 0;
  std::size_t allocated_ = 0;
  vk::raii::Buffer buffer_{ nullptr };
  vk::raii::DeviceMemory memory_{ nullptr };
  vk::DeviceAddress address_ = 0;
  void* mapped_ = nullptr;
};

} // namespace rtg
