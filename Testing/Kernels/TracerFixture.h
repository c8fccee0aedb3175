// A scene, a camera and a tracer, for TracerTest and its parts.
#pragma once

#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <random>
#include <vector>

namespace rtg
{
// Names the parameter in lists of tests.
inline void PrintTo(Structure structure, std::ostream* out)
{
  *out << (structure == Structure::Boxes ? "Boxes" : "Tree");
}
} // namespace rtg

namespace rtg::testing
{

class TracerTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer* tracer = &rtg::testing::SharedTracer();
  rtg::TraceSettings settings;
  std::vector<rtg::Light> lights{ rtg::Light() };
  rtg::Camera camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * this->LookFrom(5.0));

  void SetUp() override { this->settings.width = this->settings.height = 100; }

  // Of pipelines and memory this test alone shall count.
  void UseOwnTracer()
  {
    this->own_ = std::make_unique<rtg::Tracer>(this->device);
    this->tracer = this->own_.get();
  }

  static glm::dmat4 LookFrom(double z) { return glm::lookAt(glm::dvec3(0, 0, z), glm::dvec3(0), glm::dvec3(0, 1, 0)); }

  rtg::Scene::SetId AddSpheres(const std::vector<glm::vec3>& centers, float size)
  {
    const auto id = this->scene.Add();
    rtg::GlyphInstances instances;
    instances.centers = centers;
    instances.uniformSize = size;
    this->scene.SetInstances(id, instances);
    return id;
  }

  Image Trace(rtg::Pass pass = rtg::Pass::Opaque)
  {
    this->scene.Commit();
    return this->tracer->Trace(this->scene, this->camera, this->lights, this->settings, pass);
  }

  static double Coverage(const Image& image)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::size_t(image.width) * image.height; ++i)
    {
      sum += (image.color[i] >> 24) / 255.0;
    }
    return sum / (double(image.width) * image.height);
  }

private:
  std::unique_ptr<rtg::Tracer> own_;
};

class StructureTest : public WithStructure<TracerTest>
{
};

inline std::vector<glm::vec3> RandomPoints(std::size_t count)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-0.9f, 0.9f);
  std::vector<glm::vec3> points(count);
  for (auto& p : points)
  {
    p = { uniform(random), uniform(random), uniform(random) };
  }
  return points;
}

} // namespace rtg::testing
