#include "Denoiser.h"

#include "Finite.h"
#include "Frame.h"
#include "Parallel.h"
#include "Shading/Shading.h"
#include "Stopwatch.h"
#include "TracerResources.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

constexpr int levels = 5;              // steps of 1, 2, 4, 8 and 16 pixels: 63 pixels in all
constexpr float depthTolerance = 1.0f; // times what the surface's own slope explains
constexpr float lightTolerance = 4.0f; // standard deviations of the noise
constexpr float darkest = 0.02f;       // color by which light is still divided
constexpr float distances[3][3] = { { 0.0f, 1.0f, 2.0f }, { 1.0f, 1.414f, 2.236f },
  { 2.0f, 2.236f, 2.828f } };                // of a tap so many pixels off in x and y
constexpr float kernel[2] = { 0.5f, 0.25f }; // binomial; wider ones take thrice the time and gain little

// Light of a pixel and the variance of its luminance.
using Estimate = glm::vec4;

using shading::Luminance;

// e^-x for x >= 0 to 4e-6, and exactly 0 where nothing is left: most of the filter's time goes here.
float Falloff(float x)
{
  // (1 - x / 256)^256 without its first-order error
  const float a = 1.0f - x * (1.0f / 256.0f) + x * x * (0.5f / 65536.0f);
  if (x > 12.0f)
  {
    return 0.0f;
  }
  const float a2 = a * a, a4 = a2 * a2, a8 = a4 * a4, a16 = a8 * a8, a32 = a16 * a16;
  const float a64 = a32 * a32, a128 = a64 * a64;
  return a128 * a128;
}

// All features of a pixel, together.
struct Guide
{
  glm::vec3 normal;
  float depth;
};

class Filter
{
public:
  // A pixel whose mean is no number counts as unknown.
  Filter(const ImageFeatures& guides, const std::vector<glm::vec4>& means, const std::stop_token& stop)
    : width_(static_cast<int>(guides.width))
    , height_(static_cast<int>(guides.height))
    , stop_(stop)
  {
    this->slopes_.resize(guides.normals.size());
    this->guides_.resize(guides.normals.size());
    for (std::size_t i = 0; i < this->guides_.size(); ++i)
    {
      this->guides_[i] = { IsFinite(glm::vec3(means[i])) ? guides.normals[i] : glm::vec3(0.0f), guides.viewDepths[i] };
    }
    this->ForKnown([this](int x, int y, std::size_t at) { this->slopes_[at] = this->SlopeAt(x, y); });
  }

  bool Known(std::size_t at) const { return this->guides_[at].normal != glm::vec3(0.0f); }

  // The variance of the luminance around each pixel, over pixels alike.
  void EstimateVariance(std::vector<Estimate>& lights) const
  {
    this->ForKnown(
      [&](int x, int y, std::size_t at)
      {
        float weights = 0.0f, sum = 0.0f, squares = 0.0f;
        this->ForTaps<2>(x, y, 1,
          [&](std::size_t other, int dx, int dy)
          {
            const float weight = this->Alike(at, other, distances[dx][dy], 0.0f);
            const float luminance = Luminance(glm::vec3(lights[other]));
            weights += weight;
            sum += weight * luminance;
            squares += weight * luminance * luminance;
          });
        lights[at].w = std::max(0.0f, squares / weights - sum * sum / (weights * weights));
      });
  }

  // One level of the transform: a smoother image from one of taps `step` apart.
  std::vector<Estimate> Smooth(const std::vector<Estimate>& lights, int step) const
  {
    std::vector<Estimate> smooth(lights);
    this->ForKnown([&](int x, int y, std::size_t at) { smooth[at] = this->SmoothPixel(lights, x, y, step); });
    return smooth;
  }

private:
  std::size_t At(int x, int y) const { return static_cast<std::size_t>(y) * this->width_ + x; }

  bool Inside(int x, int y) const { return x >= 0 && y >= 0 && x < this->width_ && y < this->height_; }

  // Calls visit(x, y, At(x, y)) for each pixel that is known, on all cores.
  template <class Visit>
  void ForKnown(const Visit& visit) const
  {
    ParallelFor(static_cast<std::size_t>(this->height_),
      [&](std::size_t row)
      {
        if (this->stop_.stop_requested())
        {
          throw Error("Ray Traced Glyphs: denoising was stopped.");
        }
        for (int x = 0; x < this->width_; ++x)
        {
          const int y = static_cast<int>(row);
          if (this->Known(this->At(x, y)))
          {
            visit(x, y, this->At(x, y));
          }
        }
      });
  }

  // Calls visit(other, dx, dy) for the pixels of the image up to `reach` steps from one, so many to the side.
  template <int reach, class Visit>
  void ForTaps(int x, int y, int step, const Visit& visit) const
  {
    for (int dy = -reach; dy <= reach; ++dy)
    {
      for (int dx = -reach; dx <= reach; ++dx)
      {
        if (this->Inside(x + dx * step, y + dy * step))
        {
          visit(this->At(x + dx * step, y + dy * step), std::abs(dx), std::abs(dy));
        }
      }
    }
  }

  // How likely two pixels, `distance` apart, see the same smooth surface, and light `apart` standard deviations from
  // each other is noise; in [0, 1]. The first of them is known.
  float Alike(std::size_t a, std::size_t b, float distance, float apart) const
  {
    const Guide &first = this->guides_[a], &second = this->guides_[b];
    // The normal of what is not known is zero.
    const float cosine = glm::dot(first.normal, second.normal);
    if (cosine <= 0.0f)
    {
      return 0.0f;
    }
    const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8, c32 = c16 * c16;
    const float tolerance = depthTolerance * this->slopes_[a] * distance + 1e-4f * first.depth + 1e-30f;
    return c32 * c32 * Falloff(std::abs(first.depth - second.depth) / tolerance + apart);
  }

  // Steepest of the depth differences to neighbors along one line: at an edge only one side does.
  float SlopeAt(int x, int y) const
  {
    float steepest = 0.0f;
    for (const auto& [dx, dy] : { std::pair(1, 0), std::pair(0, 1) })
    {
      float least = INFINITY;
      for (int side : { -1, 1 })
      {
        const int otherX = x + side * dx, otherY = y + side * dy;
        if (this->Inside(otherX, otherY) && this->Known(this->At(otherX, otherY)))
        {
          const float depth = this->guides_[this->At(otherX, otherY)].depth;
          least = std::min(least, std::abs(depth - this->guides_[this->At(x, y)].depth));
        }
      }
      steepest = std::max(steepest, std::isinf(least) ? 0.0f : least);
    }
    return steepest;
  }

  // Noise around a pixel, itself less noisy than one pixel's estimate.
  float Deviation(const std::vector<Estimate>& lights, int x, int y) const
  {
    float sum = 0.0f, weights = 0.0f;
    this->ForTaps<1>(x, y, 1,
      [&](std::size_t other, int dx, int dy)
      {
        const float weight = this->Known(other) ? 1.0f / float(1 << (dx + dy)) : 0.0f;
        sum += weight * lights[other].w;
        weights += weight;
      });
    return std::sqrt(sum / weights);
  }

  Estimate SmoothPixel(const std::vector<Estimate>& lights, int x, int y, int step) const
  {
    const std::size_t at = this->At(x, y);
    const float luminance = Luminance(glm::vec3(lights[at]));
    const float perSlack =
      1.0f / (lightTolerance * (step == 1 ? this->Deviation(lights, x, y) : std::sqrt(lights[at].w)) + 1e-6f);
    glm::vec3 light(0.0f);
    float variance = 0.0f, weights = 0.0f;
    this->ForTaps<1>(x, y, step,
      [&](std::size_t other, int dx, int dy)
      {
        float weight = kernel[dx] * kernel[dy];
        if (other != at)
        {
          weight *= this->Alike(at, other, float(step) * distances[dx][dy],
            std::abs(luminance - Luminance(glm::vec3(lights[other]))) * perSlack);
          if (weight <= 0.0f)
          {
            return;
          }
        }
        light += weight * glm::vec3(lights[other]);
        variance += weight * weight * lights[other].w;
        weights += weight;
      });
    return Estimate(light / weights, variance / (weights * weights));
  }

  int width_, height_;
  const std::stop_token& stop_;
  std::vector<Guide> guides_;
  std::vector<float> slopes_; ///< of the view depth, per pixel
};

} // namespace

void Denoise(std::vector<glm::vec4>& means, const ImageFeatures& guides, const std::stop_token& stop)
{
  const Filter filter(guides, means, stop);
  const auto colorOf = [&](std::size_t i) { return glm::max(guides.albedos[i], glm::vec3(darkest)); };
  std::vector<Estimate> lights(means.size(), Estimate(0.0f));
  ParallelEach(means.size(),
    [&](std::size_t i)
    {
      if (means[i].a > 0.0f && IsFinite(glm::vec3(means[i])))
      {
        lights[i] = Estimate(glm::vec3(means[i]) / means[i].a / colorOf(i), 0.0f);
      }
    });
  filter.EstimateVariance(lights);
  for (int level = 0; level < levels; ++level)
  {
    lights = filter.Smooth(lights, 1 << level);
  }
  ParallelEach(means.size(),
    [&](std::size_t i)
    {
      if (means[i].a > 0.0f && filter.Known(i))
      {
        means[i] = glm::vec4(glm::vec3(lights[i]) * colorOf(i) * means[i].a, means[i].a);
      }
    });
}

std::vector<std::uint32_t> DenoiseTask::operator()()
{
  Stopwatch watch;
  // The device may not outlive the thread that waits for this: it is let go before the result is known.
  const std::shared_ptr<TracerResources> shared = std::move(this->shared_);
  const bool linear = TraitsOf(this->settings_).linear;
  if (linear)
  {
    ParallelEach(this->features_.albedos.size(),
      [this](std::size_t i) { this->features_.albedos[i] = shading::DisplayToLinear(this->features_.albedos[i]); });
  }
  // The ground is a white surface whose light is what it lacks. Its depth, which no glyph has, tells it from glyphs.
  constexpr float groundDepth = 0.0f;
  for (std::size_t i = 0; i < this->missingLight_.size(); ++i)
  {
    if (this->features_.normals[i] == glm::vec3(0.0f))
    {
      this->features_.normals[i] = this->settings_.groundNormal;
      this->features_.albedos[i] = glm::vec3(1.0f);
      this->features_.viewDepths[i] = groundDepth;
      this->means_[i] = glm::vec4(glm::vec3(this->missingLight_[i]), 1.0f);
    }
  }
  Denoise(this->means_, this->features_, this->stop_);

  const bool mapsTones = MapsTones(this->settings_);
  const float exposureFactor = std::exp2(this->settings_.exposure);
  const auto toneMapping = static_cast<std::uint32_t>(this->settings_.toneMapping);
  std::vector<std::uint32_t> smooth(this->means_.size(), 0);
  ParallelEach(smooth.size(),
    [&](std::size_t i)
    {
      const glm::vec4& mean = this->means_[i];
      const bool onGround = !this->missingLight_.empty() && this->features_.viewDepths[i] == groundDepth;
      glm::vec4 shown(0.0f);
      if (mean.a > 0.0f && !onGround)
      {
        const glm::vec3 color = glm::vec3(mean) / mean.a;
        shown = glm::vec4(mapsTones ? shading::ToneMap(color, linear, exposureFactor, toneMapping) : color, mean.a);
      }
      if (!this->missingLight_.empty())
      {
        shown = shading::OverShadow(shown, onGround ? mean.r : this->missingLight_[i], linear);
      }
      smooth[i] = glm::packUnorm4x8(glm::mix(shown, glm::vec4(0.0f), glm::isnan(shown)));
    });
  shared->denoiseSeconds += watch.Lap();
  return smooth;
}

} // namespace rtg
