#pragma once

#include "Scene.h"

#include <cstdint>
#include <vector>

namespace rtg::testing
{

/// A given ray and what the shaders find on it: positions in world coordinates.
struct Probe
{
  glm::dvec3 origin;
  glm::vec3 direction; ///< need not be of length one; t counts in its lengths
  float time = 0.5f;   ///< fraction of the shutter's opening, [0, 1)
};
struct ProbeHit
{
  float t;          ///< +inf: no hit
  glm::vec3 normal; ///< outward, unit
  std::uint32_t setId, glyphId;
};

/// Traces rays through a committed scene of Device::Shared().
std::vector<ProbeHit> TraceProbes(Scene& scene, const std::vector<Probe>& probes);

/// Destroys what TraceProbes() has compiled.
void ForgetProbes();

} // namespace rtg::testing
