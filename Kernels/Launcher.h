// Launches of programs over the tiles of an image, or over given rays.
#pragma once

#include "HostDevice.h"
#include "SceneState.h"
#include "TracerResources.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/Pipeline.h"

#include <cstdint>
#include <memory>

namespace rtg
{

class Launcher
{
public:
  explicit Launcher(std::shared_ptr<Device> device);

  /// Memory for launches of as many tiles at most.
  void FitTiles(const Generation& generation, std::uint32_t tiles);

  /// Traces some of the tiles from frame.firstTile on, `end` not included, and makes the next one that. What can be
  /// interrupted, and all on a GPU, whose display stands still meanwhile and whose driver takes a launch of seconds for
  /// hung, is launched in parts of some hundredths of a second.
  void LaunchTiles(TracerResources::UsedProgram& program, const Generation& generation, const Scene::State& scene,
    device::FrameRecord& frame, std::uint32_t end, bool interruptible);

  /// Traces frame.probeCount rays.
  void LaunchProbes(TracerResources::UsedProgram& program, const Generation& generation, const Scene::State& scene,
    device::FrameRecord& frame);

private:
  void FitRays(const Generation& generation, std::size_t count);
  void Launch(const Pipeline& pipeline, const Scene::State& scene, device::FrameRecord& frame, std::uint32_t width,
    std::uint32_t height);
  std::uint32_t TilesAtOnce(const TracerResources::UsedProgram& program, const Generation& generation,
    std::uint32_t left, std::uint32_t samples, bool interruptible) const;

  std::shared_ptr<Device> device_;
  FrameBlock frameBlock_;
  Buffer rays_; ///< what the driver's programs know of rays in flight
};

} // namespace rtg
