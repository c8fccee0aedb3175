// Crowds of glyphs for benchmarks: any shape, any number, at random in a cube.
#pragma once

#include "Camera.h"
#include "Glyphs.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <random>

namespace benchmark
{

struct Crowd
{
  const char* name;
  rtg::Shape shape;
  bool turned;                                     ///< and of any proportions
  float leastExponent = 2.0f, mostExponent = 2.0f; ///< equal: one for all
};

constexpr float crowdSide = 100.0f; ///< of the cube, whose middle is the origin

/// Glyphs that would nearly touch on a lattice.
inline rtg::GlyphInstances MakeInstances(const Crowd& crowd, std::size_t count)
{
  std::mt19937 random(20190923);
  std::uniform_real_distribution<float> unit;
  std::normal_distribution<float> normal;
  const auto vector = [&]
  {
    const float x = unit(random), y = unit(random);
    return glm::vec3(x, y, unit(random));
  };
  rtg::GlyphInstances instances;
  instances.shape = crowd.shape;
  instances.uniformSize = 0.8f * crowdSide / std::cbrt(float(count));
  instances.arrow.unitLength = instances.uniformSize;
  instances.centers.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    instances.centers.push_back(crowdSide * (vector() - 0.5f));
    if (crowd.turned)
    {
      instances.sizes3.push_back(instances.uniformSize * (0.5f + 0.5f * vector()));
      const float x = normal(random), y = normal(random), z = normal(random);
      instances.rotations.push_back(glm::normalize(glm::vec4(x, y, z, normal(random))));
    }
    if (crowd.mostExponent > crowd.leastExponent)
    {
      instances.exponents3.push_back(
        crowd.leastExponent * glm::pow(glm::vec3(crowd.mostExponent / crowd.leastExponent), vector()));
    }
  }
  return instances;
}

/// A camera at `eye` that looks at `target` with a square view of `degrees`.
inline rtg::Camera
LookAt(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up, double degrees, double nearDepth, double farDepth)
{
  const double tangent = std::tan(glm::radians(0.5 * degrees));
  rtg::Camera camera;
  camera.eye = camera.position = eye;
  camera.forward = glm::normalize(target - eye);
  camera.right = tangent * glm::normalize(glm::cross(camera.forward, up));
  camera.up = tangent * glm::normalize(glm::cross(camera.right, camera.forward));
  camera.nearDepth = nearDepth;
  camera.farDepth = farDepth;
  camera.depthA = farDepth / (farDepth - nearDepth);
  camera.depthB = -farDepth * nearDepth / (farDepth - nearDepth);
  return camera;
}

/// The near face of the cube just fills a square view of 30 degrees.
inline rtg::Camera CrowdCamera()
{
  return LookAt({ 0.0, 0.0, 236.6025 }, {}, { 0.0, 1.0, 0.0 }, 30.0, 100.0, 500.0);
}

} // namespace benchmark
