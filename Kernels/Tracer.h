#pragma once

#include "Camera.h"
#include "Glyphs.h"
#include "Scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rtg
{

/// One finished or refining image in host memory, bottom row first, as OpenGL wants it.
/// The pointers stay valid until the next Trace() of the same Tracer.
struct Image
{
  std::uint32_t width = 0, height = 0;
  /// RGBA8, straight (not premultiplied): the mean colour of the samples that hit, and in alpha the
  /// share of samples that hit times opacity.
  const std::uint32_t* colour = nullptr;
  /// Window depth in [0, 1] of the sample at the pixel's centre, or else of the nearest sample; 1: nothing hit.
  const float* depth = nullptr;
  /// Set and glyph (see Scene::OriginalGlyph) of the same sample; noGlyph: nothing hit.
  const std::uint32_t* setIds = nullptr;
  const std::uint32_t* glyphIds = nullptr;
  std::uint32_t samples = 0; ///< samples a pixel in it so far
  static constexpr std::uint32_t noGlyph = 0xffffffffu;
};

enum class Pass : std::uint32_t
{
  Opaque = 0,     ///< the sets that HasOpaque() speaks of
  Translucent = 1 ///< nearest translucent layer
};

struct TraceSettings
{
  std::uint32_t width = 0, height = 0;
  std::uint32_t samples =
    1; ///< samples a pixel of this image, >= 1; sample 0 is the pixel's centre
  std::uint32_t pixelStep = 1; ///< trace every n-th pixel in x and y and repeat it, for interaction
};

/// Traces a committed scene. Not thread-safe. Throws rtg::Error; on a lost device the message says so
/// and Device::Lost() becomes true.
class Tracer
{
public:
  explicit Tracer(std::shared_ptr<Device> device);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  Image Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights,
    const TraceSettings& settings, Pass pass = Pass::Opaque);

  const Statistics& GetStatistics() const;

  /// One given ray and what the pipeline found on it, for tests: positions in world coordinates.
  struct Probe
  {
    glm::dvec3 origin;
    glm::vec3 direction; ///< need not be of length one; t counts in its lengths
  };
  struct ProbeHit
  {
    float t;          ///< +inf: no hit
    glm::vec3 normal; ///< outward, unit
    std::uint32_t setId, glyphId;
  };
  std::vector<ProbeHit> TraceProbes(Scene& scene, const std::vector<Probe>& probes);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace rtg
