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
  static constexpr std::uint32_t mostColumns = 1024, mostTiles = 16 * mostColumns;

  explicit constexpr LaunchGrid(std::uint32_t tiles)
    : rows(DivideUp(tiles, mostColumns))
    , columns(DivideUp(tiles, rows))
  {
  }
  std::uint32_t rows, columns; ///< tiles
};

/// What the launches of a program have cost, and how large the next one is to be where launches are cut: those that can
/// be interrupted, and all on a GPU, whose display stands still meanwhile and whose driver takes a launch of seconds
/// for hung.
struct LaunchCost
{
  static constexpr double wanted = 0.02, longest = 0.2; ///< seconds of a launch
  std::uint32_t together = 1;  ///< tiles that the device may trace at the same time, which take as long as one
  double secondsPerRay = 0.0;  ///< of a camera ray with all that follows it; 0: unknown
  std::uint32_t lastTiles = 0; ///< of the last launch

  /// Tiles of the next launch, out of `left`, with so many samples a pixel: at most eight times as many as in the last
  /// one, because costs differ, and at least `together`, which is halved while as many take too long with one sample.
  std::uint32_t NextTiles(std::uint32_t left, std::uint32_t samples) const;
  /// Counts a launch. The cost is the mean of old and new ones, because launches differ.
  void Add(std::uint32_t tiles, std::uint32_t samples, double seconds);
  /// Samples a pixel of the next launches over all tiles, after so many whose longest launch took so many seconds: at
  /// most eight times as many.
  static double NextSamples(std::uint32_t samples, double longest);
};

/// Those tiles that are traced, by their numbers. Neighbors in this order are far apart in the image.
struct TileRange
{
  std::uint32_t begin = 0, end = 0; ///< the first; one more than the last
  std::size_t rays = 0;             ///< camera rays of one sample

  std::uint32_t Size() const { return this->end - this->begin; }
};

/// Writes the tiles of an image of at least one pixel into the frame's record; the next is the first.
TileRange FillTiles(device::FrameRecord& frame, const TraceSettings& settings);

} // namespace rtg
