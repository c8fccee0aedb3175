// Buffers share few allocations of device memory, each with bytes of its own.
#include "Glyphs.h"
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>
#include <vector>

namespace
{

class MemoryTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Device::State& vulkan = this->device->GetState();

  rtg::Buffer Make(std::size_t size, rtg::Buffer::Place place) const
  {
    return rtg::Buffer(this->vulkan, size, vk::BufferUsageFlagBits::eStorageBuffer, place);
  }
};

/// Buffers of all sizes that come and go keep what was written to them, lie where everything may lie, and leave
/// nothing but an empty block of each kind.
TEST_F(MemoryTest, BuffersKeepWhatIsWritten)
{
  struct Written
  {
    rtg::Buffer buffer;
    std::uint32_t word = 0;
  };
  this->Make(4, rtg::Buffer::Place::Host);
  this->Make(4, rtg::Buffer::Place::Device);
  const std::size_t before = this->vulkan.memory.Blocks();
  const std::uint64_t bytes = this->device->HeldBytes();
  std::mt19937 random(5);
  {
    std::vector<Written> held;
    std::size_t most = 0;
    for (std::uint32_t step = 0; step < 3000; ++step)
    {
      if (held.size() < 200 || random() % 2)
      {
        // Now and then one with a block of its own.
        const std::size_t words = random() % 50 == 0 ? 1500000 : 1 + random() % 20000;
        Written made{ this->Make(4 * words, random() % 2 ? rtg::Buffer::Place::Host : rtg::Buffer::Place::Device),
          step };
        EXPECT_EQ(made.buffer.Address() % 256, 0u);
        made.buffer.Fill(0, 4 * words, step);
        held.push_back(std::move(made));
      }
      else
      {
        const std::size_t at = random() % held.size();
        std::swap(held[at], held.back());
        const Written gone = std::move(held.back());
        held.pop_back();
        gone.buffer.Read(gone.buffer.Size(),
          [&](const void* data)
          {
            const auto* words = static_cast<const std::uint32_t*>(data);
            ASSERT_TRUE(std::all_of(
              words, words + gone.buffer.Size() / 4, [&](std::uint32_t word) { return word == gone.word; }));
          });
      }
      most = std::max(most, held.size());
    }
    std::set<vk::DeviceAddress> places;
    for (const Written& written : held)
    {
      EXPECT_TRUE(places.insert(written.buffer.Address()).second);
    }
    EXPECT_GT(most, 250u);
    EXPECT_LT(this->vulkan.memory.Blocks(), before + 60);
  }
  EXPECT_EQ(this->vulkan.memory.Blocks(), before);
  EXPECT_EQ(this->device->HeldBytes(), bytes);
}

/// What fills a shared block and goes is followed by others in the same one: images and uploads do that all the time.
TEST_F(MemoryTest, AnEmptyBlockIsKept)
{
  const auto fill = [&](const auto& look)
  {
    std::vector<rtg::Buffer> held;
    for (int i = 0; i < 4; ++i)
    {
      held.push_back(this->Make(this->vulkan.memory.blockBytes / 4, rtg::Buffer::Place::Host));
    }
    look();
  };
  fill([] {});
  const std::size_t before = this->vulkan.memory.Blocks();
  fill([&] { EXPECT_EQ(this->vulkan.memory.Blocks(), before); });
}

/// What is larger than a batch holds arrives whole, whatever the size of its elements.
TEST_F(MemoryTest, LargeUploadsArriveWhole)
{
  const bool shares = this->vulkan.sharesMemory;
  this->vulkan.sharesMemory = false;
  for (const std::size_t stride : { 1, 12, 28 })
  {
    std::vector<char> sent(stride * (40000000 / stride));
    std::mt19937 random(11);
    std::generate(sent.begin(), sent.end(), [&] { return char(random() >> 24); });
    rtg::Buffer buffer = this->Make(sent.size(), rtg::Buffer::Place::Device);
    buffer.Write(sent.size() / stride, stride,
      [&](void* target, std::size_t first, std::size_t last)
      { std::memcpy(target, sent.data() + first * stride, (last - first) * stride); });
    buffer.Read(sent.size(), [&](const void* data) { EXPECT_EQ(std::memcmp(data, sent.data(), sent.size()), 0); });
  }
  this->vulkan.sharesMemory = shares;
}

/// Some devices allow 4096 allocations; a set takes several buffers.
TEST_F(MemoryTest, ThousandsOfSetsTakeFewAllocations)
{
  constexpr int side = 45;
  const std::size_t before = this->vulkan.memory.Blocks();
  {
    rtg::Scene scene(this->device);
    for (int i = 0; i < side * side; ++i)
    {
      rtg::GlyphInstances instances;
      instances.centers = { { (i % side + 0.5f) * 2.0f / side - 1.0f, (i / side + 0.5f) * 2.0f / side - 1.0f, 0.0f } };
      instances.sizes1 = { 1.0f / side };
      const rtg::Scene::SetId set = scene.Add();
      scene.SetInstances(set, instances);
      scene.SetColors(set, std::vector<std::uint32_t>{ 0xff000000u | std::uint32_t(i) });
    }
    scene.Commit();
    EXPECT_LT(this->vulkan.memory.Blocks(), before + 16);
    rtg::TraceSettings settings;
    settings.width = settings.height = 4 * side;
    const auto camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) *
      glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
    const rtg::Image image = rtg::testing::SharedTracer().Trace(scene, camera, { rtg::Light() }, settings);
    std::set<std::uint32_t> seen(image.setIds, image.setIds + std::size_t(image.width) * image.height);
    seen.erase(rtg::Image::noGlyph);
    EXPECT_EQ(seen.size(), std::size_t(side * side));
  }
  EXPECT_LT(this->vulkan.memory.Blocks(), before + 8);
}

} // namespace
