#include "Tiles.h"

#include <algorithm>

namespace rtg
{

Tiling::Tiling(const TraceSettings& settings)
  : columns_(DivideUp(settings.width, tileSize))
  , count_(this->columns_ * DivideUp(settings.height, tileSize))
{
  // Its multiples, for all tiles, fit into 32 bits.
  const std::uint64_t most =
    std::min<std::uint64_t>(this->count_ * 5ull / 13, 0xffffffffull / std::max(this->count_, 1u));
  this->stride_ = CoprimeUpTo(static_cast<std::uint32_t>(most), this->count_);
  // Tiles that follow each other are scattered already.
  const auto boundary = [&](std::uint32_t part)
  { return static_cast<std::uint32_t>(std::uint64_t(this->count_) * part / settings.parts); };
  this->begin_ = boundary(settings.part);
  this->end_ = boundary(settings.part + 1);
  this->rays_ =
    settings.parts > 1 ? std::size_t(this->Size()) * raysPerTile : std::size_t(settings.width) * settings.height;
}

void Tiling::Fill(device::FrameRecord& frame) const
{
  frame.tileColumns = this->columns_;
  frame.tileCount = this->count_;
  frame.tileStride = this->stride_;
  frame.firstTile = this->begin_;
}

} // namespace rtg
