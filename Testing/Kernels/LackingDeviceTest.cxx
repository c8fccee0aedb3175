// Devices that lack what the kernels need. Testing/FaultLayer makes them look so.
#include "Glyphs.h"
#include "Vulkan/Device.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace
{

// An environment variable while it lives.
class Variable
{
public:
  Variable(const char* name, const char* value)
    : name_(name)
  {
    setenv(name, value, 1);
  }
  ~Variable() { unsetenv(this->name_); }

private:
  const char* name_;
};

std::string Message()
{
  try
  {
    rtg::Device::Shared();
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
  EXPECT_EQ(Message(), "");
  for (const char* property :
    { "shaderRoundingModeRTEFloat32", "shaderSignedZeroInfNanPreserveFloat32", "vulkanMemoryModel" })
  {
    const Variable lacks("RTGLYPHS_LACKS", property);
    const std::string message = Message();
    const auto at = message.find(property);
    ASSERT_NE(at, std::string::npos) << property << ": " << message;
    EXPECT_NE(message.find("no Vulkan device can trace rays"), std::string::npos) << message;
    EXPECT_NE(message.find("Install a driver"), std::string::npos) << message;
  }
  EXPECT_EQ(Message(), "");
}
