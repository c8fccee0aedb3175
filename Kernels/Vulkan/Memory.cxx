#include "Memory.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <optional>
#include <utility>

namespace rtg
{

struct MemoryPiece::Block
{
  vk::raii::DeviceMemory memory{ nullptr };
  std::uint32_t type = 0;
  bool shared = false;
  void* mapped = nullptr;
  std::map<vk::DeviceSize, vk::DeviceSize> free; ///< start -> size of free ranges
  std::size_t pieces = 0;

  // First fit: pieces of a set come and go together.
  std::optional<vk::DeviceSize> Take(vk::DeviceSize size, vk::DeviceSize alignment)
  {
    for (auto gap = this->free.begin(); gap != this->free.end(); ++gap)
    {
      const auto [start, length] = *gap;
      const vk::DeviceSize offset = AlignUp(start, alignment);
      if (offset + size > start + length)
      {
        continue;
      }
      // The new gap first: what may throw leaves all as it was.
      if (offset + size < start + length)
      {
        this->free[offset + size] = start + length - offset - size;
      }
      if (offset == start)
      {
        this->free.erase(gap);
      }
      else
      {
        gap->second = offset - start;
      }
      ++this->pieces;
      return offset;
    }
    return std::nullopt;
  }

  // Joined with the gaps beside it.
  void GiveBack(vk::DeviceSize offset, vk::DeviceSize size)
  {
    --this->pieces;
    auto after = this->free.lower_bound(offset);
    if (after != this->free.end() && after->first == offset + size)
    {
      size += after->second;
      after = this->free.erase(after);
    }
    if (after != this->free.begin())
    {
      const auto before = std::prev(after);
      if (before->first + before->second == offset)
      {
        before->second += size;
        return;
      }
    }
    this->free.emplace_hint(after, offset, size);
  }
};

MemoryPiece::~MemoryPiece()
{
  if (this->owner_)
  {
    this->owner_->Free(*this);
  }
}

MemoryPiece::MemoryPiece(MemoryPiece&& other) noexcept
{
  *this = std::move(other);
}

MemoryPiece& MemoryPiece::operator=(MemoryPiece&& other) noexcept
{
  std::swap(this->owner_, other.owner_);
  std::swap(this->block_, other.block_);
  std::swap(this->offset_, other.offset_);
  std::swap(this->size_, other.size_);
  return *this;
}

vk::DeviceMemory MemoryPiece::Handle() const
{
  return *this->block_->memory;
}

void* MemoryPiece::Mapped() const
{
  return this->block_ && this->block_->mapped ? static_cast<char*>(this->block_->mapped) + this->offset_ : nullptr;
}

Memory::Memory() = default;

Memory::~Memory() = default;

MemoryPiece
Memory::Allocate(const vk::raii::Device& device, const vk::MemoryRequirements& needs, std::uint32_t type, bool mapped)
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  MemoryPiece piece;
  constexpr vk::DeviceSize leastAlignment = 256; // enough for structures, tables and programs on every driver
  // Gaps start and end at multiples of that, so none is too small to be used again.
  piece.size_ = AlignUp(needs.size, leastAlignment);
  const vk::DeviceSize alignment = std::max(needs.alignment, leastAlignment);
  const bool shares = piece.size_ <= this->blockBytes / 4;
  const auto take = [&](MemoryPiece::Block& block)
  {
    const std::optional<vk::DeviceSize> offset = block.Take(piece.size_, alignment);
    if (offset)
    {
      this->bytes += piece.size_;
      piece.offset_ = *offset;
      piece.block_ = &block;
      piece.owner_ = this;
    }
    return offset.has_value();
  };
  if (shares &&
    std::any_of(this->blocks_.begin(), this->blocks_.end(),
      [&](MemoryPiece::Block& block)
      { return block.shared && block.type == type && (block.mapped != nullptr) == mapped && take(block); }))
  {
    return piece;
  }
  MemoryPiece::Block block;
  block.type = type;
  block.shared = shares;
  const vk::DeviceSize size = shares ? vk::DeviceSize(this->blockBytes) : piece.size_;
  const vk::MemoryAllocateFlagsInfo addressable(vk::MemoryAllocateFlagBits::eDeviceAddress);
  vk::MemoryAllocateInfo info(size, type);
  info.pNext = &addressable;
  block.memory = vk::raii::DeviceMemory(device, info);
  block.mapped = mapped ? block.memory.mapMemory(0, VK_WHOLE_SIZE) : nullptr;
  // lavapipe calls it a success where the computer has no memory left, and gives what malloc() or mmap() gave.
  if (mapped && (!block.mapped || reinterpret_cast<std::intptr_t>(block.mapped) == -1))
  {
    throw vk::OutOfHostMemoryError("vkMapMemory");
  }
  block.free[0] = size;
  this->blocks_.push_front(std::move(block));
  take(this->blocks_.front());
  return piece;
}

void Memory::Free(MemoryPiece& piece)
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  this->bytes -= piece.size_;
  try
  {
    piece.block_->GiveBack(piece.offset_, piece.size_);
  }
  catch (const std::bad_alloc&)
  {
    // The gap is lost until the whole block is empty.
  }
  if (piece.block_->pieces > 0)
  {
    return;
  }
  const MemoryPiece::Block& empty = *piece.block_;
  const auto another = [&](const MemoryPiece::Block& block)
  {
    return &block != &empty && block.shared && block.pieces == 0 && block.type == empty.type &&
      (block.mapped != nullptr) == (empty.mapped != nullptr);
  };
  if (!empty.shared || std::any_of(this->blocks_.begin(), this->blocks_.end(), another))
  {
    this->blocks_.remove_if([&](const MemoryPiece::Block& block) { return &block == &empty; });
  }
}

std::size_t Memory::Blocks() const
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  return this->blocks_.size();
}

} // namespace rtg
