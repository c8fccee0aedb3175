#pragma once

#include "DeviceState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rtg
{

/// A buffer with memory and a device address, a multiple of 256.
class Buffer
{
public:
  enum class Place
  {
    Device, ///< fastest for programs; filled by Upload() or by programs
    Host    ///< mapped; for what is copied to the device or back
  };

  Buffer() = default;
  /// Throws vk::SystemError, or rtg::Error where the device allows no such size. A size of zero makes an empty buffer
  /// with address 0.
  Buffer(Device::State& device, std::size_t size, vk::BufferUsageFlags usage, Place place);

  /// Makes it a buffer of programs of at least that size, of any content. A larger one stays, unless it is far too
  /// large.
  void Fit(Device::State& device, std::size_t size, Place place = Place::Device);

  std::size_t Size() const { return this->size_; }
  vk::Buffer Handle() const { return *this->buffer_; }
  vk::DeviceAddress Address() const { return this->address_; }
  /// Host pointer; null for a Place::Device buffer, unless the device shares the host's memory.
  void* Mapped() const { return this->mapped_; }

  /// Copies host data to the start of the buffer: at once, or with the device's batch where there is one and the buffer
  /// is not mapped.
  void Upload(const void* data, std::size_t size);
  /// Copies `count` elements of `stride` bytes likewise, in pieces: `fill` writes elements [first, last) from `target`
  /// on.
  void Write(std::size_t count, std::size_t stride,
    const std::function<void(void* target, std::size_t first, std::size_t last)>& fill);
  /// Repeats a word over some of its bytes, multiples of four.
  void Fill(std::size_t offset, std::size_t size, std::uint32_t word);
  /// Shows `read` so many bytes from the start, what programs have written included.
  void Read(std::size_t size, const std::function<void(const void*)>& read) const;
  /// Copies as many bytes from the start to a host buffer.
  void CopyTo(const Buffer& target, std::size_t size) const;

private:
  Device::State* device_ = nullptr;
  std::size_t size_ = 0;
  MemoryPiece memory_; ///< goes after the buffer
  vk::raii::Buffer buffer_{ nullptr };
  vk::DeviceAddress address_ = 0;
  void* mapped_ = nullptr;
};

/// A buffer on the device with these values; `more` is usage besides that of a storage buffer.
template <class T>
Buffer Send(Device::State& device, const std::vector<T>& values, vk::BufferUsageFlags more = {})
{
  Buffer buffer(
    device, values.size() * sizeof(T), vk::BufferUsageFlagBits::eStorageBuffer | more, Buffer::Place::Device);
  buffer.Upload(values.data(), values.size() * sizeof(T));
  return buffer;
}

} // namespace rtg
