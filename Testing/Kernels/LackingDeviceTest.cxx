// Devices that lack what the kernels need. Testing/FaultLayer makes them look so.
#include "Glyphs.h"
#include "Scene.h"
#include "Tracer.h"
#include "Variable.h"
#include "Vulkan/DeviceState.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <string>

namespace
{

using rtg::testing::Variable;

std::string Message(bool look)
{
  try
  {
    if (look)
    {
      rtg::Device::Chosen();
    }
    else
    {
      rtg::Device::Shared();
    }
  }
  catch (const rtg::Error& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(LackingDeviceTest, WhatADeviceLacksIsNamedOnce)
{
  EXPECT_EQ(Message(false), "");
  for (const char* property :
    { "Vulkan 1.2", "shaderRoundingModeRTEFloat32", "shaderSignedZeroInfNanPreserveFloat32", "shaderInt64" })
  {
    const Variable lacks("RTGLYPHS_LACKS", property);
    const std::string message = Message(false);
    const auto at = message.find(property);
    ASSERT_NE(at, std::string::npos) << property << ": " << message;
    EXPECT_NE(message.find("no Vulkan device can trace rays"), std::string::npos) << message;
    EXPECT_NE(message.find("Install a driver"), std::string::npos) << message;
    EXPECT_EQ(Message(true), message) << "when only looked at";
    EXPECT_EQ(message.find("its driver has 1.1") != std::string::npos, property == std::string("Vulkan 1.2"))
      << message;
  }
  EXPECT_EQ(Message(false), "");
}

// Without ray queries it walks own trees, also where the driver has acceleration structures and ray-tracing pipelines.
TEST(LackingDeviceTest, ADeviceWithoutRayQueriesTraces)
{
  const Variable lacks("RTGLYPHS_LACKS", "rayQuery");
  const auto device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::GlyphInstances ball;
  ball.centers = { glm::vec3(0.0f, 0.0f, 0.0f) };
  const auto id = scene.Add();
  scene.SetInstances(id, ball);
  scene.Commit();
  rtg::Tracer tracer{ device };
  rtg::TraceSettings settings;
  settings.width = settings.height = 33;
  const auto camera = rtg::Camera::FromWorldToClip(
    glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  const std::uint64_t before = device->GetState().submissions;
  const rtg::Image image = tracer.Trace(scene, camera, { rtg::Light() }, settings);
  EXPECT_LE(device->GetState().submissions - before, 2u); // not one for each of its 25 tiles
  std::size_t covered = 0;
  for (std::size_t i = 0; i < 33 * 33; ++i)
  {
    covered += image.setIds[i] == id;
  }
  // A disc of radius 1/2 in a square of side 2.
  EXPECT_NEAR(covered / (33.0 * 33.0), 3.14159 / 16.0, 0.02);

  const Variable wanted("RTGLYPHS_STRUCTURE", "boxes");
  try
  {
    rtg::Scene boxes{ device };
    FAIL() << "a scene of boxes without a driver for them";
  }
  catch (const rtg::Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("lacks VK_KHR_ray_query"), std::string::npos) << error.what();
  }
}
