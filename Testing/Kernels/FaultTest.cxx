// A scene whose memory runs out at every step that can fail, and after it. The calls fail by Testing/FaultLayer.
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/Device.h"
#include "Vulkan/ProgramLibrary.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <random>
#include <string>
#include <vector>

namespace
{

using rtg::Image;

constexpr std::uint32_t side = 64;

// What runs out of memory, as Testing/FaultLayer names it.
constexpr const char* functions[] = { "vkAllocateMemory", "vkCreateBuffer", "vkBindBufferMemory", "vkMapMemory", "mmap",
  "vkCreateAccelerationStructureKHR" };

// While it lives, that call of a function fails, and all further ones with "always".
class Fault
{
public:
  Fault(const std::string& function, int call, const std::string& how = "")
    : path_(std::getenv("RTGLYPHS_FAULT"))
  {
    std::ofstream(this->path_) << function << ' ' << call << ' ' << how << '\n';
  }
  ~Fault() { std::remove(this->path_.c_str()); }
  bool Pending() const { return std::ifstream(this->path_).good(); }

private:
  std::string path_;
};

enum class Content
{
  Spheres,
  Moving,
  Mesh
};

struct Glyphs
{
  rtg::GlyphInstances instances;
  std::vector<std::uint32_t> colors;
};

std::shared_ptr<const rtg::TriangleMesh> Tetrahedron()
{
  auto mesh = std::make_shared<rtg::TriangleMesh>();
  mesh->positions = { { 0, 0, 0.5f }, { 0.5f, 0, -0.5f }, { -0.5f, 0.5f, -0.5f }, { -0.5f, -0.5f, -0.5f } };
  mesh->triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  return mesh;
}

Glyphs RandomGlyphs(Content content, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.9f, 0.9f);
  Glyphs glyphs;
  constexpr std::uint32_t count = 300;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    glyphs.instances.centers.emplace_back(uniform(random), uniform(random), uniform(random));
    glyphs.instances.sizes1.push_back(0.1f + 0.05f * uniform(random));
    glyphs.colors.push_back(0xff000000u | (i * 2654435761u >> 8));
  }
  if (content == Content::Moving)
  {
    for (std::uint32_t i = 0; i < count; ++i)
    {
      glyphs.instances.motion.velocities.emplace_back(uniform(random), uniform(random), uniform(random));
    }
    glyphs.instances.motion.shutterOpen = -0.05f;
    glyphs.instances.motion.shutterClose = 0.05f;
  }
  if (content == Content::Mesh)
  {
    static const std::shared_ptr<const rtg::TriangleMesh> mesh = Tetrahedron();
    glyphs.instances.shape = rtg::Shape::Mesh;
    glyphs.instances.mesh = mesh;
  }
  return glyphs;
}

// What an image shows, whatever the order of the glyphs on the device.
struct Picture
{
  std::vector<std::uint32_t> colors, glyphs;
  bool operator==(const Picture&) const = default;
};

Picture Trace(rtg::Scene& scene, rtg::Tracer& tracer = rtg::testing::SharedTracer())
{
  rtg::TraceSettings settings;
  settings.width = settings.height = side;
  const auto camera = rtg::Camera::FromWorldToClip(
    glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  const Image image = tracer.Trace(scene, camera, { rtg::Light() }, settings);
  Picture picture;
  picture.colors.assign(image.color, image.color + side * side);
  for (std::uint32_t i = 0; i < side * side; ++i)
  {
    const std::uint32_t glyph = image.glyphIds[i];
    picture.glyphs.push_back(glyph == Image::noGlyph ? glyph : scene.OriginalGlyph(image.setIds[i], glyph));
  }
  return picture;
}

class FaultTest : public ::testing::TestWithParam<rtg::Structure>
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();

  void SetUp() override
  {
    ASSERT_TRUE(std::getenv("RTGLYPHS_FAULT")) << "the environment is that of CTest's entry FaultTest";
    RTG_NEEDS(GetParam());
    // Each buffer is an allocation that can fail.
    this->device->GetState().memory.blockBytes = 0;
  }

  std::unique_ptr<rtg::Scene> MakeScene() const
  {
    auto scene = std::make_unique<rtg::Scene>(this->device);
    scene->GetState().structure = this->GetParam();
    return scene;
  }

  static void Set(rtg::Scene& scene, rtg::Scene::SetId id, const Glyphs& glyphs)
  {
    scene.SetInstances(id, glyphs.instances);
    scene.SetColors(id, glyphs.colors);
  }

  Picture Expected(const Glyphs& glyphs) const
  {
    const auto scene = this->MakeScene();
    Set(*scene, scene->Add(), glyphs);
    scene->Commit();
    return Trace(*scene);
  }
};

} // namespace

TEST_P(FaultTest, ACommitAfterOneThatFailedShowsEveryGlyphAsItIs)
{
  for (const Content content : { Content::Spheres, Content::Moving, Content::Mesh })
  {
    const Glyphs first = RandomGlyphs(content, 1), second = RandomGlyphs(content, 2);
    Glyphs recolored = second;
    std::reverse(recolored.colors.begin(), recolored.colors.end());
    const Picture firstPicture = this->Expected(first), secondPicture = this->Expected(second),
                  recoloredPicture = this->Expected(recolored);
    EXPECT_FALSE(firstPicture == secondPicture);
    int failures = 0;
    for (const char* function : functions)
    {
      const auto scene = this->MakeScene();
      const auto id = scene->Add();
      Set(*scene, id, first);
      scene->Commit();
      // A call later each time, until none is left that would fail.
      for (int call = 1;; ++call)
      {
        ASSERT_LT(call, 100);
        SCOPED_TRACE(std::string(function) + " " + std::to_string(call));
        Set(*scene, id, second);
        bool failed = false;
        {
          const Fault fault(function, call);
          try
          {
            scene->Commit();
          }
          catch (const rtg::OutOfMemory&)
          {
            failed = true;
          }
          ASSERT_NE(failed, fault.Pending());
        }
        if (failed)
        {
          ++failures;
          // A caller that traces without another Commit() gets the second glyphs or nothing.
          for (const std::uint32_t glyph : Trace(*scene).glyphs)
          {
            ASSERT_EQ(glyph, Image::noGlyph);
          }
        }
        scene->Commit();
        ASSERT_TRUE(Trace(*scene) == secondPicture);

        scene->SetColors(id, recolored.colors);
        {
          const Fault fault(function, call);
          try
          {
            scene->Commit();
          }
          catch (const rtg::OutOfMemory&)
          {
            ++failures;
          }
        }
        scene->Commit();
        ASSERT_TRUE(Trace(*scene) == recoloredPicture);
        Set(*scene, id, first);
        scene->Commit();
        ASSERT_TRUE(Trace(*scene) == firstPicture);
        if (!failed)
        {
          break;
        }
      }
    }
    EXPECT_GT(failures, 10);
  }
}

TEST_P(FaultTest, WhatFailedIsNotCounted)
{
  const std::uint64_t before = this->device->HeldBytes();
  for (const char* function : functions)
  {
    int failures = 0;
    for (int call = 1; call < 8; ++call)
    {
      const auto scene = this->MakeScene();
      Set(*scene, scene->Add(), RandomGlyphs(Content::Spheres, 3));
      const Fault fault(function, call);
      try
      {
        scene->Commit();
      }
      catch (const rtg::OutOfMemory&)
      {
        ++failures;
      }
    }
    // Trees of our own are buffers.
    const bool called =
      GetParam() == rtg::Structure::Boxes || std::string(function) != "vkCreateAccelerationStructureKHR";
    EXPECT_EQ(failures > 0, called) << function;
    EXPECT_EQ(this->device->HeldBytes(), before) << function;
  }
}

/// The computer's memory, not the device's.
TEST_P(FaultTest, MemoryOfTheComputerIsNamed)
{
  const auto scene = this->MakeScene();
  const Glyphs glyphs = RandomGlyphs(Content::Spheres, 6);
  Set(*scene, scene->Add(), glyphs);
  const auto fails = [](double) -> bool { throw std::bad_alloc(); };
  const auto message = [](const auto& work) -> std::string
  {
    try
    {
      work();
    }
    catch (const rtg::OutOfMemory& error)
    {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(message([&] { scene->Commit(fails); }).find("the computer's memory does not suffice"), std::string::npos);
  scene->Commit();
  EXPECT_TRUE(Trace(*scene) == this->Expected(glyphs));
}

/// Drivers may give more in one piece than they promise: only where they do not is that the reason.
TEST_P(FaultTest, WhatIsTooLargeForOneAllocationIsSaidSo)
{
  auto& vulkan = this->device->GetState();
  const auto message = [this]
  {
    const auto scene = this->MakeScene();
    Set(*scene, scene->Add(), RandomGlyphs(Content::Spheres, 9));
    const Fault fault("vkAllocateMemory", 1);
    try
    {
      scene->Commit();
    }
    catch (const rtg::OutOfMemory&)
    {
      return std::string("out of memory");
    }
    catch (const rtg::Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(), "out of memory");
  const vk::DeviceSize most = vulkan.mostOfAllocation;
  vulkan.mostOfAllocation = 100;
  EXPECT_NE(message().find("in one buffer, of which '" + this->device->Name() + "' allows 0 MiB"), std::string::npos);
  vulkan.mostOfAllocation = most;
}

TEST_P(FaultTest, OneSetThatFailsLeavesTheOthersInPlace)
{
  const auto scene = this->MakeScene();
  const Glyphs first = RandomGlyphs(Content::Spheres, 4), second = RandomGlyphs(Content::Spheres, 5);
  Set(*scene, scene->Add(), first);
  scene->Commit();
  const auto builds = scene->GetStatistics().structureBuilds;
  const auto other = scene->Add();
  Set(*scene, other, second);
  {
    const Fault fault("vkCreateBuffer", 1); // that of the structure
    EXPECT_THROW(scene->Commit(), rtg::OutOfMemory);
  }
  scene->Commit();
  EXPECT_EQ(scene->GetStatistics().structureBuilds, builds + 1);
  scene->Remove(other);
  scene->Commit();
  EXPECT_TRUE(Trace(*scene) == this->Expected(first));
}

/// An image that failed before anything was launched is nothing to go on with.
TEST_P(FaultTest, AnImageThatFailedIsNotGoneOnWith)
{
  const auto scene = this->MakeScene();
  Set(*scene, scene->Add(), RandomGlyphs(Content::Spheres, 8));
  scene->Commit();
  rtg::Tracer tracer(this->device);
  {
    const Fault fault("vkCreateBuffer", 1);
    EXPECT_THROW(Trace(*scene, tracer), rtg::OutOfMemory);
  }
  EXPECT_THROW(tracer.Resume(*scene, 1), rtg::Error);
  EXPECT_TRUE(Trace(*scene, tracer) == Trace(*scene));
}

// No thread has waited for it: the view that wanted it is gone.
TEST_P(FaultTest, AProgramThatFailedIsCompiledAgainForTheNext)
{
  rtg::ProgramLibrary& programs = *this->device->GetState().programs;
  rtg::Specialization specialization;
  specialization.constants.rayQueries = GetParam() == rtg::Structure::Boxes;
  specialization.constants.shapes = 1u;
  specialization.constants.degree = 4321u; // of no other test
  const auto failing = [&]
  {
    const Fault fault("vkCreateBuffer", 1, "always");
    const auto [program, began] = programs.Get(specialization);
    EXPECT_TRUE(began);
    EXPECT_THROW(program->compiled.get(), vk::SystemError);
  };
  failing();
  failing();
  for (const bool begins : { true, false })
  {
    const auto [program, began] = programs.Get(specialization);
    EXPECT_EQ(began, begins);
    EXPECT_NO_THROW(program->compiled.get());
    EXPECT_TRUE(program->pipeline);
  }
}

// It compiles the first time only to fill the driver's cache.
TEST_P(FaultTest, AnotherDeviceThatFailsLeavesTheProgramToItsOwn)
{
  rtg::Specialization specialization;
  specialization.constants.rayQueries = GetParam() == rtg::Structure::Boxes;
  specialization.constants.shapes = 1u;
  specialization.constants.degree = 1234u; // of no other test
  const Fault fault("vkCreateBuffer", 1);
  const auto [program, began] = this->device->GetState().programs->Get(specialization);
  EXPECT_TRUE(began);
  EXPECT_NO_THROW(program->compiled.get());
  EXPECT_FALSE(fault.Pending());
}

INSTANTIATE_TEST_SUITE_P(, FaultTest, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree),
  [](const auto& info) { return info.param == rtg::Structure::Boxes ? "Boxes" : "Tree"; });
