// Device memory in pieces of larger blocks: drivers allow as few as 4096 allocations, and each costs them a call to the
// operating system.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <mutex>

namespace rtg
{

class Memory;

/// The least multiple of an alignment that is not below the value.
inline vk::DeviceSize AlignUp(vk::DeviceSize value, vk::DeviceSize alignment)
{
  return (value + alignment - 1) / alignment * alignment;
}

/// A part of a block that belongs to its holder.
class MemoryPiece
{
public:
  MemoryPiece() = default;
  ~MemoryPiece();
  MemoryPiece(MemoryPiece&& other) noexcept;
  MemoryPiece& operator=(MemoryPiece&& other) noexcept;
  MemoryPiece(const MemoryPiece&) = delete;
  MemoryPiece& operator=(const MemoryPiece&) = delete;

  vk::DeviceMemory Handle() const;
  vk::DeviceSize Offset() const { return this->offset_; }
  /// Null: its memory is not mapped.
  void* Mapped() const;

private:
  friend class Memory;
  struct Block;
  Memory* owner_ = nullptr;
  Block* block_ = nullptr;
  vk::DeviceSize offset_ = 0, size_ = 0;
};

/// All memory of a device. In any thread.
class Memory
{
public:
  Memory();
  ~Memory();

  /// Small allocations are parts of common blocks; a large one has a block of its own. Of the shared blocks of a kind
  /// that are empty one is kept: each image needs some for a moment. Throws vk::SystemError, and nothing has changed
  /// then.
  MemoryPiece
  Allocate(const vk::raii::Device& device, const vk::MemoryRequirements& needs, std::uint32_t type, bool mapped);

  /// vkAllocateMemory calls whose memory is not freed yet.
  std::size_t Blocks() const;

  std::atomic<std::uint64_t> bytes{ 0 }; ///< of all pieces

  /// Size of new blocks that are shared. 0: each piece has a block of its own. Tests set it.
  std::size_t blockBytes = std::size_t(16) << 20;

private:
  friend class MemoryPiece;
  void Free(MemoryPiece& piece);

  mutable std::mutex mutex_;
  std::list<MemoryPiece::Block> blocks_;
};

} // namespace rtg
