// Common to the tracers of one view: costs of programs, the environment image on the device, counters.
#pragma once

#include "Environment.h"
#include "HostDevice.h"
#include "Scene.h"
#include "Tiles.h"
#include "Tracer.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/ProgramLibrary.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>

namespace rtg
{

class TracerResources
{
public:
  TracerResources(std::shared_ptr<Device> device, std::shared_ptr<Statistics> statistics);

  std::map<std::weak_ptr<const Program>, LaunchCost, std::owner_less<>> costs; ///< in this view

  /// The device's program of that key; if it has none, another thread begins to compile it.
  std::shared_ptr<Program> ProgramFor(const Specialization& specialization);

  /// Puts the environment image of path tracing, if the settings have one, on the device and into `frame`.
  void PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame);

  const Statistics& GetStatistics();

  std::shared_ptr<Device> device;
  std::shared_ptr<Statistics> statistics;
  std::atomic<double> denoiseSeconds{ 0.0 }; ///< counted by the threads that denoise, since the last GetStatistics()

private:
  std::shared_ptr<const EnvironmentImage> environment_; ///< that the next four are made from
  EnvironmentCells environmentCells_;
  Buffer environmentTexels_, environmentCellBuffer_;
  glm::vec3 groundNormal_{ 0.0f }, groundMean_{ 0.0f }; ///< its light on a surface with that normal
};

} // namespace rtg
