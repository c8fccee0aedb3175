// How images are cut into tiles, and the order of these.
#pragma once

#include "HostDevice.h"
#include "Tracer.h"

#include <cstddef>
#include <cstdint>
#include <numeric>

namespace rtg
{

constexpr std::uint32_t tileSize = 8; ///< rays a side; Programs/pixel.glsl has it, too
constexpr std::uint32_t raysPerTile = tileSize * tileSize;

constexpr std::uint32_t DivideUp(std::uint32_t value, std::uint32_t by)
{
  return (value + by - 1) / by;
}

/// The largest number up to `most`, or else 1, that has no common divisor with `count`.
constexpr std::uint32_t CoprimeUpTo(std::uint32_t most, std::uint32_t count)
{
  while (most > 1 && std::gcd(most, count) != 1)
  {
    --most;
  }
  return most > 1 ? most : 1;
}

/// How a launch of at least one tile is laid out: rows are full, but for less than a tile each. lavapipe gives every
/// core as many places in a row as any other, with tiles or without.
struct LaunchGrid
{
  static constexpr std::uint32_t mostColumns = 1024;

  explicit constexpr LaunchGrid(std::uint32_t tiles)
    : rows(DivideUp(tiles, mostColumns))
    , columns(DivideUp(tiles, rows))
  {
  }
  std::uint32_t rows, columns; ///< tiles
};

/// The tiles of an image in the order in which they are traced, neighbors in it being far apart in the image, and those
/// of the part that is traced.
class Tiling
{
public:
  Tiling() = default; ///< none
  /// For an image of at least one pixel.
  explicit Tiling(const TraceSettings& settings);

  std::uint32_t Begin() const { return this->begin_; } ///< number of the part's first tile
  std::uint32_t End() const { return this->end_; }     ///< one more than that of its last
  std::uint32_t Size() const { return this->end_ - this->begin_; }
  std::size_t Rays() const { return this->rays_; } ///< camera rays of one sample

  /// Writes the frame's record, and makes the first tile of the part the next.
  void Fill(device::FrameRecord& frame) const;

private:
  std::uint32_t columns_ = 0, count_ = 0; ///< tiles of a row, of the image
  std::uint32_t stride_ = 1;              ///< from a tile to the next that is traced
  std::uint32_t begin_ = 0, end_ = 0;
  std::size_t rays_ = 0;
};

} // namespace rtg
