#include "Buffer.h"

#include "Batch.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

namespace rtg
{

namespace
{

std::uint32_t ChooseMemoryType(const Device::State& device, std::uint32_t allowed, Buffer::Place place)
{
  using Flag = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags host = Flag::eHostVisible | Flag::eHostCoherent;
  const vk::MemoryPropertyFlags preferences[2][3] = {
    { device.sharesMemory ? Flag::eDeviceLocal | host : vk::MemoryPropertyFlags(Flag::eDeviceLocal), Flag::eDeviceLocal,
      {} },
    { host | Flag::eHostCached, host, host },
  };
  for (const auto& wanted : preferences[static_cast<int>(place)])
  {
    for (std::uint32_t i = 0; i < device.memoryTypes.memoryTypeCount; ++i)
    {
      if ((allowed & (1u << i)) && (device.memoryTypes.memoryTypes[i].propertyFlags & wanted) == wanted)
      {
        return i;
      }
    }
  }
  throw vk::OutOfDeviceMemoryError("no suitable memory type");
}

[[noreturn]] void ThrowTooLarge(const Device::State& device, std::size_t size, vk::DeviceSize most)
{
  throw Error("Ray Traced Glyphs: " + std::to_string(size >> 20) + " MiB are needed in one buffer, of which '" +
    device.name + "' allows " + std::to_string(most >> 20) +
    " MiB. Show fewer glyphs in one display (GlyphMode, MaximumNumberOfGlyphs), or make the picture smaller.");
}

} // namespace

Buffer::Buffer(Device::State& device, std::size_t size, vk::BufferUsageFlags usage, Place place)
  : device_(&device)
  , size_(size)
{
  if (size == 0)
  {
    return;
  }
  using Usage = vk::BufferUsageFlagBits;
  usage |= Usage::eShaderDeviceAddress;
  if (!device.sharesMemory)
  {
    usage |= Usage::eTransferDst | Usage::eTransferSrc;
  }
  if (size > device.mostOfBuffer)
  {
    ThrowTooLarge(device, size, device.mostOfBuffer);
  }
  this->buffer_ = vk::raii::Buffer(device.device, vk::BufferCreateInfo({}, size, usage));
  const vk::MemoryRequirements needs = this->buffer_.getMemoryRequirements();

  const std::uint32_t type = ChooseMemoryType(device, needs.memoryTypeBits, place);
  using Flag = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags flags = device.memoryTypes.memoryTypes[type].propertyFlags;
  const bool mapped =
    (place == Place::Host || device.sharesMemory) && flags & Flag::eHostVisible && flags & Flag::eHostCoherent;
  try
  {
    this->memory_ = device.memory.Allocate(device.device, needs, type, mapped);
  }
  catch (const vk::OutOfDeviceMemoryError&)
  {
    // Other data need not be hidden for what no driver promises.
    if (needs.size > device.mostOfAllocation)
    {
      ThrowTooLarge(device, size, device.mostOfAllocation);
    }
    throw;
  }

  this->buffer_.bindMemory(this->memory_.Handle(), this->memory_.Offset());
  this->address_ = device.device.getBufferAddress(vk::BufferDeviceAddressInfo(*this->buffer_));
  this->mapped_ = this->memory_.Mapped();
}

void Buffer::Fit(Device::State& device, std::size_t size, Place place)
{
  if (this->size_ < size || this->size_ > 4 * size)
  {
    *this = Buffer(); // before there is another
    *this = Buffer(device, size, vk::BufferUsageFlagBits::eStorageBuffer, place);
  }
}

void Buffer::Upload(const void* data, std::size_t size)
{
  const auto* bytes = static_cast<const char*>(data);
  this->Write(size, 1,
    [&](void* target, std::size_t first, std::size_t last) { std::memcpy(target, bytes + first, last - first); });
}

void Buffer::Write(
  std::size_t count, std::size_t stride, const std::function<void(void*, std::size_t, std::size_t)>& fill)
{
  if (count == 0)
  {
    return;
  }
  if (this->mapped_)
  {
    fill(this->mapped_, 0, count);
    return;
  }
  std::optional<Batch> own;
  if (!this->device_->batch)
  {
    own.emplace(*this->device_);
  }
  const std::size_t atOnce = std::max<std::size_t>(1, Batch::mostAtOnce / stride);
  for (std::size_t first = 0; first < count; first += atOnce)
  {
    const std::size_t last = std::min(count, first + atOnce);
    fill(this->device_->batch->Stage(*this, first * stride, (last - first) * stride), first, last);
  }
  if (own)
  {
    own->Run();
  }
}

void Buffer::Fill(std::size_t offset, std::size_t size, std::uint32_t word)
{
  if (this->mapped_)
  {
    std::fill_n(
      reinterpret_cast<std::uint32_t*>(static_cast<char*>(this->mapped_) + offset), size / sizeof(word), word);
    return;
  }
  this->device_->Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      command.fillBuffer(this->Handle(), offset, size, word);
      Barrier(command, vk::PipelineStageFlagBits::eTransfer, vk::AccessFlagBits::eTransferWrite,
        this->device_->programStages | vk::PipelineStageFlagBits::eTransfer,
        vk::AccessFlagBits::eShaderRead | vk::AccessFlagBits::eShaderWrite | vk::AccessFlagBits::eTransferRead |
          vk::AccessFlagBits::eTransferWrite);
    });
}

void Buffer::Read(std::size_t size, const std::function<void(const void*)>& read) const
{
  if (this->mapped_)
  {
    read(this->mapped_);
    return;
  }
  const Buffer host(*this->device_, size, vk::BufferUsageFlagBits::eTransferDst, Place::Host);
  this->CopyTo(host, size);
  read(host.Mapped());
}

void Buffer::CopyTo(const Buffer& target, std::size_t size) const
{
  this->device_->Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      command.copyBuffer(this->Handle(), target.Handle(), vk::BufferCopy(0, 0, size));
      Barrier(command, vk::PipelineStageFlagBits::eTransfer, vk::AccessFlagBits::eTransferWrite,
        vk::PipelineStageFlagBits::eHost, vk::AccessFlagBits::eHostRead);
    });
}

} // namespace rtg
