#include "Tiles.h"

#include <algorithm>

namespace rtg
{

namespace
{

// A number of tiles that has no common divisor with their count and whose multiples, of all tiles, fit into 32 bits.
std::uint32_t StrideOf(std::uint32_t count)
{
  const std::uint64_t most = std::min<std::uint64_t>(count * 5ull / 13, 0xffffffffull / std::max(count, 1u));
  return CoprimeUpTo(static_cast<std::uint32_t>(most), count);
}

} // namespace

Tiling::Tiling(const TraceSettings& settings)
  : width_(settings.width)
  , height_(settings.height)
  , columns_(DivideUp(this->width_, tileSize))
  , count_(this->columns_ * DivideUp(this->height_, tileSize))
  , stride_(StrideOf(this->count_))
{
  // Tiles that follow each other are scattered already.
  const auto boundary = [&](std::uint32_t share)
  { return static_cast<std::uint32_t>(std::uint64_t(this->count_) * share / settings.shares); };
  this->begin_ = boundary(settings.share);
  this->end_ = boundary(settings.share + 1);
  this->rays_ =
    settings.shares > 1 ? std::size_t(this->Size()) * raysPerTile : std::size_t(this->width_) * this->height_;
}

// As LaunchPixel() of Programs/pixel.glsl has it.
Tiling::Rectangle Tiling::PixelsOf(std::uint32_t number) const
{
  const std::uint32_t tile = number * this->stride_ % this->count_;
  const std::uint32_t left = tile % this->columns_ * tileSize, bottom = tile / this->columns_ * tileSize;
  return { left, bottom, std::min(left + tileSize, this->width_), std::min(bottom + tileSize, this->height_) };
}

void Tiling::Fill(device::FrameRecord& frame) const
{
  frame.tileColumns = this->columns_;
  frame.tileCount = this->count_;
  frame.tileStride = this->stride_;
  frame.firstTile = this->begin_;
}

} // namespace rtg
