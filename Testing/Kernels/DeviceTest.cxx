// Which device the environment variable RTGLYPHS_DEVICE chooses.
#include "Glyphs.h"
#include "Variable.h"
#include "Vulkan/Device.h"
#include "Vulkan/DeviceState.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <thread>
#include <vector>

using rtg::testing::Variable;

TEST(DeviceTest, NumbersAreIndicesOrPartsOfNames)
{
  const Variable unset("RTGLYPHS_DEVICE", nullptr);
  const std::string name = rtg::Device::Shared()->Name();
  EXPECT_EQ(rtg::Device::Chosen().name, name);

  // No machine has so many devices.
  const Variable other("RTGLYPHS_DEVICE", "4090");
  if (name.find("4090") == std::string::npos)
  {
    try
    {
      rtg::Device::Shared();
      FAIL() << "no error";
    }
    catch (const rtg::Error& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("RTGLYPHS_DEVICE='4090'"), std::string::npos) << text;
      EXPECT_NE(text.find(name), std::string::npos) << text;
    }
  }

  // The longest number in the device's name, such as that of its model.
  std::string number;
  for (auto at = name.begin(); at != name.end();)
  {
    const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
    at = std::find_if(at, name.end(), isDigit);
    const auto end = std::find_if_not(at, name.end(), isDigit);
    number = std::max(number, std::string(at, end), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    at = end;
  }
  if (number.size() < 2)
  {
    GTEST_SKIP() << name << " has no number in its name";
  }
  const Variable own("RTGLYPHS_DEVICE", number.c_str());
  EXPECT_EQ(rtg::Device::Shared()->Name(), name);
}

/// As when several programs are compiled at once.
TEST(DeviceTest, DevicesComeAndGoInSeveralThreads)
{
  std::vector<std::thread> threads(8);
  for (std::thread& thread : threads)
  {
    thread = std::thread(
      []
      {
        for (int i = 0; i < 50; ++i)
        {
          EXPECT_NO_THROW(rtg::Device::Another());
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
