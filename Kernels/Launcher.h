// Launches of programs over the tiles of an image.
#pragma once

#include "HostDevice.h"
#include "TracerResources.h"
#include "Vulkan/Pipeline.h"

#include <cstdint>
#include <memory>

namespace rtg
{

class Launcher
{
public:
  explicit Launcher(std::shared_ptr<Device> device);

  /// Whether launches are to take some hundredths of a second: those that can be interrupted, and all on a GPU, whose
  /// display stands still meanwhile and whose driver takes a launch of seconds for hung.
  bool Cuts(bool interruptible) const;

  /// Traces some of the tiles from frame.firstTile on, `end` not included, and makes the next one that. Returns the
  /// seconds that it took.
  double LaunchTiles(const Pipeline& pipeline, TracerResources::Cost& cost, device::FrameRecord& frame,
    std::uint32_t end, bool interruptible);

  /// Samples a pixel of the next dispatch where launches are cut, after one of so many whose longest launch took so
  /// many seconds: at most eight times as many.
  static double NextSamples(std::uint32_t samples, double longest);

private:
  void Launch(const Pipeline& pipeline, device::FrameRecord& frame, std::uint32_t width, std::uint32_t height);
  std::uint32_t
  TilesAtOnce(const TracerResources::Cost& cost, std::uint32_t left, std::uint32_t samples, bool interruptible) const;

  std::shared_ptr<Device> device_;
  FrameBlock frameBlock_;
};

} // namespace rtg
