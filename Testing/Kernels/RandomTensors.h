// Tensors with given eigenvalues, and random frames for them. Deterministic.
#pragma once

#include "Tensor.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <random>

namespace rtg::testing
{

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : engine_(seed)
  {
  }
  double Uniform(double low, double high) { return low + (high - low) * double(this->engine_() >> 11) * 0x1p-53; }
  glm::dquat Rotation()
  {
    std::normal_distribution<double> normal;
    const double w = normal(this->engine_), x = normal(this->engine_);
    const double y = normal(this->engine_), z = normal(this->engine_);
    return glm::normalize(glm::dquat(w, x, y, z));
  }

private:
  std::mt19937_64 engine_;
};

inline SymmetricTensor TensorOf(const glm::dvec3& values, const glm::dquat& rotation)
{
  const glm::dmat3 r = glm::mat3_cast(rotation);
  glm::dmat3 m(0.0);
  for (int k = 0; k < 3; ++k)
  {
    m += values[k] * glm::outerProduct(r[k], r[k]);
  }
  return SymmetricTensor::Of(m);
}

} // namespace rtg::testing
