#include "SharedDevice.h"

#include "Probes.h"
#include "Vulkan/Device.h"
#include "Vulkan/DeviceState.h"

#include <cstdlib>

namespace rtg::testing
{
namespace
{

std::unique_ptr<Tracer> tracer;

/// Holds device and tracer while tests run. Both are destroyed before main() ends: the driver may be
/// unloaded then. The validation layers report what was not destroyed.
class SharedDevice : public ::testing::Environment
{
public:
  void SetUp() override
  {
    ASSERT_NO_THROW(tracer = std::make_unique<Tracer>(Device::Shared()));
    // As with a GPU that has memory of its own: what the host sends is staged and copied, and images are copied back.
    if (std::getenv("RTGLYPHS_STAGED"))
    {
      Device::Shared()->GetState().sharesMemory = false;
    }
  }
  void TearDown() override
  {
    ForgetProbes();
    tracer.reset();
  }
};

const ::testing::Environment* const environment = ::testing::AddGlobalTestEnvironment(new SharedDevice);

} // namespace

Tracer& SharedTracer()
{
  return *tracer;
}

std::string WhatLacksFor(Structure structure)
{
  return structure == Structure::Tree || Device::Shared()->GetState().rayQueries ? "" : "VK_KHR_ray_query";
}

} // namespace rtg::testing
