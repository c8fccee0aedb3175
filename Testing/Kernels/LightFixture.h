// A white or colored scene, its light and a parallel view, for tests of ambient occlusion and path tracing through the
// pipeline.
//
// Confidence: a mean of n samples that each lie in [0, 1] with variance v is off by more than z sqrt(v / n) with
// the probability that a normal variable is beyond z; z = 5 is one in 1.7 million. v is taken from the samples'
// own bound (occlusion: p (1 - p); radiance: at most its largest value squared), never from the result.
#pragma once

#include "Scene.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace light
{

using rtg::Image;
using rtg::Shading;
using rtg::Shape;

constexpr double certain = 5.0; // standard deviations

inline rtg::Material White()
{
  return rtg::Material();
}

// Random places in a cube of half-width 0.8.
inline std::vector<glm::vec3> Clutter(unsigned seed, std::size_t count)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.8f, 0.8f);
  std::vector<glm::vec3> places(count);
  for (glm::vec3& place : places)
  {
    place = { uniform(random), uniform(random), uniform(random) };
  }
  return places;
}

class LightTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer& tracer = rtg::testing::SharedTracer();
  rtg::TraceSettings settings;
  std::vector<rtg::Light> lights;
  rtg::Camera camera = this->LookFrom({ 0, 0, 5 });

  void SetUp() override
  {
    this->settings.width = this->settings.height = 24;
    this->settings.keepSums = true;
    this->settings.independentSamples = true; // their confidence intervals are known
  }

  // A parallel view of half-width 1.
  static rtg::Camera LookFrom(glm::dvec3 eye, glm::dvec3 target = glm::dvec3(0), double half = 1.0)
  {
    const glm::dvec3 up = std::abs(glm::normalize(eye - target).y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    return rtg::Camera::FromWorldToClip(
      glm::ortho(-half, half, -half, half, 0.01, 20.0) * glm::lookAt(eye, target, up));
  }

  rtg::Scene::SetId Add(Shape shape, std::vector<glm::vec3> centers, std::vector<glm::vec3> sizes,
    const rtg::Material& material, std::vector<glm::vec4> rotations = {})
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.arrow.fixedHeads = false;
    instances.centers = std::move(centers);
    instances.sizes3 = std::move(sizes);
    instances.rotations = std::move(rotations);
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    this->scene.SetMaterial(id, material);
    return id;
  }

  Image Trace(rtg::Pass pass = rtg::Pass::Opaque)
  {
    this->scene.Commit();
    return this->tracer.Trace(this->scene, this->camera, this->lights, this->settings, pass);
  }

  // Straight color of each pixel that some sample hit.
  std::vector<glm::vec3> Radiances() const
  {
    std::vector<glm::vec3> radiances;
    for (const glm::vec4& mean : this->tracer.Means())
    {
      if (mean.a > 0.0f)
      {
        radiances.emplace_back(glm::vec3(mean) / mean.a);
      }
    }
    return radiances;
  }

  glm::vec4 PixelMean(int x, int y) const { return this->tracer.Means()[y * this->settings.width + x]; }

  // A disc over a floor, and all pixels at one place, from which half of the cosine-weighted hemisphere is open
  // (OcclusionOfParallelPlanes).
  void LookUnderALid(const rtg::Material& material)
  {
    this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 10.0f, 0.1f, 10.0f } }, material);
    this->Add(Shape::Cylinder, { { 0, 0.55f, 0 } }, { { 1.0f, 0.1f, 1.0f } }, material);
    this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1e-4, 1e-4, -1e-4, 1e-4, 0.01, 20.0) *
      glm::lookAt(glm::dvec3(0, 0.3, 3), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  }

  // Over the last image's pixels: the mean of the red channel's distance from `expected`, and of its square.
  struct Error
  {
    double mean = 0.0, square = 0.0;
  };

  Error ErrorOf(double expected) const
  {
    Error error;
    const std::vector<glm::vec4> means = this->tracer.Means();
    for (const glm::vec4& mean : means)
    {
      const double off = mean.r - expected;
      error.mean += off / static_cast<double>(means.size());
      error.square += off * off / static_cast<double>(means.size());
    }
    return error;
  }
};

} // namespace light
