#include "Probes.h"

#include "Frame.h"
#include "SceneState.h"
#include "Tracer.h"

#include <cmath>
#include <list>

namespace rtg::testing
{
namespace
{

#include "Programs/probe.inc"

// As probe.comp has them.
struct ProbeRecord
{
  glm::vec3 origin, originLow, direction;
  float time;
};
struct ProbeResult
{
  float t;
  glm::vec3 normal;
  std::uint32_t setId, glyph;
};

struct Compiled
{
  Constants constants;
  Pipeline pipeline;
};
std::list<Compiled> compiled;

const Pipeline& PipelineFor(Device::State& device, const Constants& constants)
{
  const auto found =
    std::find_if(compiled.begin(), compiled.end(), [&](const Compiled& one) { return one.constants == constants; });
  if (found != compiled.end())
  {
    return found->pipeline;
  }
  compiled.push_back({ constants, Pipeline(device, { sizeof(probe), probe }, constants) });
  return compiled.back().pipeline;
}

} // namespace

void ForgetProbes()
{
  compiled.clear();
}

std::vector<ProbeHit> TraceProbes(Scene& scene, const std::vector<Probe>& probes)
{
  const SceneRecords& glyphs = scene.GetState().records;
  std::vector<ProbeHit> hits(probes.size(), { INFINITY, glm::vec3(0.0f), Image::noGlyph, Image::noGlyph });
  if (probes.empty() || glyphs.sets.empty())
  {
    return hits;
  }
  Device::State& vulkan = scene.GetState().device->GetState();
  std::vector<ProbeRecord> records(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    Split(probes[i].origin - glyphs.origin, records[i].origin, records[i].originLow);
    records[i].direction = probes[i].direction;
    records[i].time = probes[i].time;
  }
  const Buffer input = Send(vulkan, records), output = Send(vulkan, std::vector<ProbeResult>(probes.size()));

  device::FrameRecord frame{};
  FillScene(frame, glyphs);
  frame.sums = input.Address();
  frame.features = output.Address();
  frame.width = static_cast<std::uint32_t>(probes.size());
  frame.cullMask = device::ANY_MASK;
  Constants constants;
  FillConstants(constants, glyphs);
  const Pipeline& pipeline = PipelineFor(vulkan, constants);
  FrameBlock block(vulkan);
  vulkan.Submit(
    [&](vk::raii::CommandBuffer& command)
    {
      block.Send(command, frame);
      pipeline.Trace(
        command, block, (frame.width + device::LAUNCH_GROUP - 1) / device::LAUNCH_GROUP * device::LAUNCH_GROUP, 1);
      Barrier(command, vulkan.programStages, vk::AccessFlagBits::eShaderWrite,
        vk::PipelineStageFlagBits::eTransfer | vk::PipelineStageFlagBits::eHost,
        vk::AccessFlagBits::eTransferRead | vk::AccessFlagBits::eHostRead);
    });
  output.Read(output.Size(),
    [&](const void* read)
    {
      const auto* results = static_cast<const ProbeResult*>(read);
      for (std::size_t i = 0; i < probes.size(); ++i)
      {
        if (results[i].t >= 0.0f)
        {
          hits[i] = { results[i].t, results[i].normal, results[i].setId,
            scene.OriginalGlyph(results[i].setId, results[i].glyph) };
        }
      }
    });
  return hits;
}

} // namespace rtg::testing
