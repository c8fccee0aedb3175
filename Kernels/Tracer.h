#pragma once

#include "Camera.h"
#include "Environment.h"
#include "Glyphs.h"
#include "Scene.h"
#include "Shading/List.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace rtg
{

/// One finished or refining image in host memory, bottom row first, as OpenGL wants it.
/// The pointers stay valid until the next Trace() of the same Tracer.
struct Image
{
  std::uint32_t width = 0, height = 0;
  /// RGBA8, straight (not premultiplied): the mean color of the samples that hit, weighted by their opacity, and in
  /// alpha the mean over all samples of the opacity hit.
  const std::uint32_t* color = nullptr;
  const std::uint32_t* traced = nullptr; ///< the same before denoising
  /// Window depth in [0, 1] of the sample at the pixel's center, or else of the nearest sample; 1: nothing hit.
  const float* depth = nullptr;
  /// Set and glyph (see Scene::OriginalGlyph) of the same sample; noGlyph: nothing hit.
  const std::uint32_t* setIds = nullptr;
  const std::uint32_t* glyphIds = nullptr;
  std::uint32_t samples = 0; ///< samples a pixel in it so far, in all pixels
  /// False: tracing was interrupted, and some pixels have further samples, or none yet where samples is 0.
  bool complete = true;
  double fraction = 1.0; ///< of the samples requested so far that are traced, in [0, 1]
  static constexpr std::uint32_t noGlyph = 0xffffffffu;
};

/// Features of an image's pixels besides their noisy light: means over the samples that hit. Zero: nothing was hit.
struct ImageFeatures
{
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec3> normals; ///< unit, of the surface, in the world's frame
  std::vector<glm::vec3> albedos; ///< color without light
  std::vector<float> viewDepths;
};

enum class Pass : std::uint32_t
{
  Opaque = 0,      ///< sets that are opaque, with all their glyphs and colors
  Translucent = 1, ///< all translucent layers in front of the nearest opaque surface, up to 256 on a ray
  All = 2          ///< both in one image; for path tracing, which mixes them at random
};

/// Shading modes: Shading/List.h.
enum class Shading : std::uint32_t
{
#define RTG_SHADING_NUMBER(number, Name, ...) Name = number,
  RTG_SHADINGS(RTG_SHADING_NUMBER)
#undef RTG_SHADING_NUMBER
};

enum class ToneMapping : std::uint32_t
{
  None = 0,   ///< light beyond 1 is clipped
  Filmic = 1, ///< a fit of the ACES curve
  Neutral = 2 ///< light beyond 0.9 is compressed, hues stay
};

struct TraceSettings
{
  std::uint32_t width = 0, height = 0; ///< pixels
  std::uint32_t samples = 1;           ///< samples a pixel, >= 1; sample 0 is the pixel's center
  bool keepSums = false;               ///< Resume() will add samples: keep what they are added to

  Shading shading = Shading::Local;
  /// Radiance of the environment light (the sky) of ambient occlusion and path tracing, >= 0.
  float lightIntensity = 1.0f;
  /// The sky's radiance in a unit direction d is 1 + skySlope . d times that: its mean stays. Length in [0, 1]; zero:
  /// it is uniform.
  glm::vec3 skySlope{ 0.0f };
  /// Ambient occlusion: the fraction of the light on a surface that is the view's lights, which nothing occludes; the
  /// rest is the sky's. In [0, 1].
  float lightFraction = 0.0f;
  /// Surfaces whose color is their material's reflect at most this fraction of the light, in (0, 1]; 1: no limit.
  /// Colors of glyphs and triangles stay.
  float albedoLimit = 1.0f;
  /// Path tracing: the environment light is this image's, times lightIntensity; null: it is uniform. Immutable: another
  /// image is another object.
  std::shared_ptr<const EnvironmentImage> environmentImage;
  /// Local shading and ambient occlusion: lights that cast shadows do; path tracing's always do.
  bool shadows = false;
  /// A plane that shows only the fraction of its light that is blocked: ambient occlusion's and path
  /// tracing's, and that of shadows. It is visible from the side to which its normal (unit) points, behind all else;
  /// zero: there is none.
  glm::vec3 groundNormal{ 0.0f };
  double groundHeight = 0.0;    ///< along the normal, world coordinates
  float occlusionRadius = 0.0f; ///< world units, largest distance of occluders; 0: any
  /// Ambient occlusion: occlusion rays per sample, 1 to 64; powers of two are spread best. Among small
  /// glyphs the light varies more with the direction than with the position in the pixel, and an occlusion ray costs
  /// less than a sample.
  std::uint32_t occlusionRays = 1;
  /// Path tracing: paths that each sample follows from what its camera ray hits, 1 to 64; powers of two are spread
  /// best.
  std::uint32_t paths = 1;
  std::uint32_t maximumBounces = 10; ///< of path tracing, 1 to 1000

  /// The samples of a pixel are independent instead of stratified (Shading/Sobol.glsl): they err more,
  /// but their confidence intervals are known. For tests and references.
  bool independentSamples = false;
  /// Samples a pixel of the finished image, for the times of scenes that move; 0: `samples`. Such images are the same
  /// for any division of the samples into calls only when it is given.
  std::uint32_t plannedSamples = 0;
  ToneMapping toneMapping = ToneMapping::None;
  float exposure = 0.0f; ///< stops, that is powers of two, in [-100, 100]
  bool features = false; ///< gather ImageFeatures

  /// The image has so many equal parts, scattered over it in tiles. This one, < parts, is traced; the rest stays empty.
  /// For processes that trace an image together.
  std::uint32_t part = 0, parts = 1;

  bool operator==(const TraceSettings&) const = default;
};

/// Traits of a shading mode: Shading/List.h.
struct ShadingTraits
{
  bool scatters, linear, layers, environmentImage;
  std::optional<Shading> withShadows;
  std::uint32_t TraceSettings::*rays; ///< null: one
  int atOnce;
};
ShadingTraits TraitsOf(const TraceSettings& settings);

/// Called some twenty times a second while an image is traced, with the fraction of the work done, in [0, 1]; true:
/// stop.
using Interrupt = std::function<bool(double fraction)>;

/// Common to the tracers of one view: compiled programs, an environment image on the device, and statistics.
class TracerResources;
std::shared_ptr<TracerResources> MakeTracerResources(
  std::shared_ptr<Device> device, std::shared_ptr<Statistics> statistics = std::make_shared<Statistics>());
const Statistics& StatisticsOf(TracerResources& resources);

/// The denoising of an image (Denoiser.h), which may run in another thread while its tracer goes on.
class DenoiseTask
{
public:
  /// The colors of the image with less noise, RGBA8; edges and glyphs' own colors stay.
  std::vector<std::uint32_t> operator()();

private:
  friend class Tracer;
  std::vector<glm::vec4> means_;
  std::vector<float> missingLight_; ///< on the ground; empty: there is none
  ImageFeatures features_;
  TraceSettings settings_;
  std::shared_ptr<TracerResources> shared_;
  std::stop_token stop_;
};

/// Traces a committed scene. The same scene, settings and device give the same image, for any division of its
/// samples into calls and threads. Not thread-safe. Throws rtg::Error; on a lost device the message says so
/// and Device::Lost() becomes true.
class Tracer
{
public:
  explicit Tracer(std::shared_ptr<Device> device);
  /// The tracers of a view share what they can: programs are compiled once. Their statistics are one, too.
  explicit Tracer(std::shared_ptr<TracerResources> shared);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// With `interrupt` the image is traced in parts of some hundredths of a second, and after each the callback decides
  /// whether to stop.
  Image Trace(Scene& scene, const Camera& camera, const std::vector<Light>& lights, const TraceSettings& settings,
    Pass pass = Pass::Opaque, const Interrupt& interrupt = {});

  /// Compiles the programs for images of the scene in other shading modes in the background, when the processor has
  /// nothing else to do. `ofShading`: the settings of each kind of shading.
  void CompileAhead(Scene& scene, const std::vector<Light>& lights, const std::vector<TraceSettings>& ofShading);

  /// Goes on with the last image, of the same scene, until it has that many samples a pixel: with one that was
  /// interrupted, or that was traced with keepSums.
  Image Resume(Scene& scene, std::uint32_t samples, const Interrupt& interrupt = {});

  /// Mean linear radiance (of local shading: display color) times opacity, and opacity, of each pixel of the last
  /// image as sums left them, before any clipping: for error measurements. Needs keepSums.
  std::vector<glm::vec4> Means(std::vector<float>* missingLight = nullptr) const;

  /// Of the last image, which must be complete and traced with features.
  ImageFeatures Features() const;

  /// The denoising of the last image, which must be complete and traced with keepSums and features. It has copies of
  /// what it needs: more samples can be added meanwhile. It throws rtg::Error soon after a stop is requested.
  DenoiseTask Denoise(std::stop_token stop = {}) const;

  const Statistics& GetStatistics() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace rtg
