// What the tracers of one view share: compiled programs, the environment image on the device, counters.
#pragma once

#include "Environment.h"
#include "HostDevice.h"
#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/Pipeline.h"

#include <atomic>
#include <memory>
#include <vector>

namespace rtg
{

class TracerResources
{
public:
  explicit TracerResources(std::shared_ptr<Device> device);

  /// A pipeline, and what its launches have cost.
  struct Program
  {
    std::unique_ptr<Pipeline> pipeline;
    bool launched = false;          ///< a driver may compile at the first launch, which so tells nothing of the cost
    double secondsPerRay = 0.0;     ///< of a camera ray with all that follows it; 0: unknown
    std::size_t lastTiles = 0;      ///< of the last launch whose time is known
  };

  /// The program of these keys, compiled when it is not among the last ones used. Valid until the next call.
  Program& ProgramFor(const Generation& generation, const std::vector<HitGroup>& groups);

  /// Puts the environment image of path tracing, if the settings have one, on the device and into `frame`.
  void PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame);

  /// Squared thresholds of the sampler that needs them.
  vk::DeviceAddress BlueNoise();

  const Statistics& GetStatistics();

  std::shared_ptr<Device> device;
  Statistics statistics;
  std::atomic<double> denoiseSeconds{ 0.0 }; ///< counted by the threads that denoise

private:
  std::vector<std::unique_ptr<Program>> programs_; ///< newest last
  Buffer blueNoise_;
  std::shared_ptr<const EnvironmentImage> environment_; ///< that the next three are made from
  EnvironmentCells environmentCells_;
  Buffer environmentTexels_, environmentCellBuffer_;
};

} // namespace rtg
