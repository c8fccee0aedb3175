// What the tracers of one view share: compiled programs, the environment image on the device, counters.
#pragma once

#include "Environment.h"
#include "HostDevice.h"
#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/Pipeline.h"

#include <atomic>
#include <chrono>
#include <future>
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
    Generation generation;
    std::vector<HitGroup> groups;
    std::unique_ptr<Pipeline> pipeline; ///< null until it is compiled
    std::future<void> compiling;        ///< valid until somebody knows that it is done
    double secondsPerRay = 0.0;         ///< of a camera ray with all that follows it; 0: unknown
    std::size_t lastTiles = 0;          ///< of the last launch

    Program() = default;
    ~Program(); ///< waits for what compiles it
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
  };

  /// The program of these keys (of those that walk own trees, the first alone); compiling begins, in another thread,
  /// when it is not among the last ones used. Valid until the next call.
  Program& ProgramFor(const Generation& generation, const std::vector<HitGroup>& groups);

  /// Whether the program can be launched; waits for it so long at most. Throws what compiling failed of, and the
  /// program is no more.
  bool IsCompiled(Program& program, std::chrono::milliseconds patience);
  void WaitFor(Program& program);

  /// Puts the environment image of path tracing, if the settings have one, on the device and into `frame`.
  void PrepareEnvironment(const TraceSettings& settings, device::FrameRecord& frame);

  const Statistics& GetStatistics();

  std::shared_ptr<Device> device;
  Statistics statistics;
  std::atomic<double> denoiseSeconds{ 0.0 }; ///< counted by the threads that denoise

private:
  std::vector<std::unique_ptr<Program>> programs_;      ///< newest last
  std::shared_ptr<const EnvironmentImage> environment_; ///< that the next three are made from
  EnvironmentCells environmentCells_;
  Buffer environmentTexels_, environmentCellBuffer_;
};

} // namespace rtg
