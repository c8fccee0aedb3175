#include "Tiles.h"

#include <algorithm>

namespace rtg
{

std::uint32_t LaunchCost::NextTiles(std::uint32_t left, std::uint32_t samples) const
{
  const double seconds = this->secondsPerRay * raysPerTile * samples;
  const double tiles = seconds > 0.0 ? std::min(wanted / seconds, 8.0 * this->lastTiles) : 8.0;
  return static_cast<std::uint32_t>(std::min<double>(std::max<double>(tiles, this->together), left));
}

void LaunchCost::Add(std::uint32_t tiles, std::uint32_t samples, double seconds)
{
  const double perRay = seconds / (double(tiles) * raysPerTile * samples);
  this->secondsPerRay = this->secondsPerRay > 0.0 ? 0.5 * (this->secondsPerRay + perRay) : perRay;
  this->lastTiles = std::max(tiles, 8u);
  constexpr std::uint32_t ofSmallGpus = 32;
  if (seconds > longest && samples == 1 && tiles <= this->together && this->together > ofSmallGpus)
  {
    this->together /= 2;
  }
}

double LaunchCost::NextSamples(std::uint32_t samples, double longest)
{
  return samples * std::min(8.0, wanted / std::max(longest, 1e-9));
}

TileRange FillTiles(device::FrameRecord& frame, const TraceSettings& settings)
{
  frame.tileColumns = DivideUp(settings.width, tileSize);
  frame.tileCount = frame.tileColumns * DivideUp(settings.height, tileSize);
  // Its multiples, for all tiles, fit into 32 bits.
  const std::uint64_t most = std::min<std::uint64_t>(frame.tileCount * 5ull / 13, 0xffffffffull / frame.tileCount);
  frame.tileStride = CoprimeUpTo(static_cast<std::uint32_t>(most), frame.tileCount);
  // Tiles that follow each other are scattered already.
  const auto boundary = [&](std::uint32_t part)
  { return static_cast<std::uint32_t>(std::uint64_t(frame.tileCount) * part / settings.parts); };
  TileRange tiles{ boundary(settings.part), boundary(settings.part + 1) };
  tiles.rays =
    settings.parts > 1 ? std::size_t(tiles.Size()) * raysPerTile : std::size_t(settings.width) * settings.height;
  frame.firstTile = tiles.begin;
  return tiles;
}

} // namespace rtg
