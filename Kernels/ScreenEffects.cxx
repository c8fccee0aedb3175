#include "ScreenEffects.h"

#include "Parallel.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rtg
{

namespace
{

// From this angle between two surfaces on, in degrees, their edge is a crease. Either bends by less than this fraction
// of it from pixel to pixel: thin cylinders have none.
constexpr double creaseAngle = 40.0, flatness = 0.25;
// By how many pixels a depth must be off what its neighbors on either side lead to, to be a step.
constexpr double leastStep = 2.0;

// The image's pixels as places in space, from their centers' depths.
class Surface
{
public:
  Surface(const Image& image, const float* depths, const Camera& camera)
    : image_(image)
    , depths_(depths)
    , camera_(camera)
    , pixelAtOne_(2.0 * glm::length(camera.parallel ? camera.eyeRight : camera.right) / image.width)
  {
  }

  bool IsHit(int x, int y) const
  {
    return this->Inside(x, y) && this->image_.glyphIds[this->At(x, y)] != Image::noGlyph;
  }
  bool IsSame(int x, int y, int otherX, int otherY) const
  {
    const std::size_t a = this->At(x, y), b = this->At(otherX, otherY);
    return this->image_.setIds[a] == this->image_.setIds[b] && this->image_.glyphIds[a] == this->image_.glyphIds[b];
  }
  double ViewDepth(int x, int y) const
  {
    const double window = this->depths_[this->At(x, y)];
    const double offset = window - this->camera_.depthA;
    return this->camera_.parallel ? offset / this->camera_.depthB : this->camera_.depthB / offset;
  }
  double PixelSize(double viewDepth) const { return this->pixelAtOne_ * (this->camera_.parallel ? 1.0 : viewDepth); }

  // Whether there is a line between a pixel and the next one along (dx, dy), both of which the image has.
  bool HasBorder(int x, int y, int dx, int dy) const
  {
    const int nextX = x + dx, nextY = y + dy;
    const bool hit = this->IsHit(x, y);
    if (hit != this->IsHit(nextX, nextY))
    {
      return true;
    }
    if (!hit)
    {
      return false;
    }
    if (!this->IsSame(x, y, nextX, nextY))
    {
      return true;
    }
    // Slopes before, between and behind, in pixels of depth a pixel.
    const double here = this->ViewDepth(x, y), next = this->ViewDepth(nextX, nextY);
    const double pixel = this->PixelSize(std::min(here, next));
    const std::optional<double> before = this->Slope(x - dx, y - dy, dx, dy, pixel);
    const std::optional<double> behind = this->Slope(nextX, nextY, dx, dy, pixel);
    if (!before || !behind)
    {
      return false;
    }
    const double between = (next - here) / pixel;
    const double step =
      leastStep + std::max(this->Steepness(x, y, dy, dx, pixel), this->Steepness(nextX, nextY, dy, dx, pixel));
    if (between > std::max(*before, *behind) + step || between < std::min(*before, *behind) - step)
    {
      return true;
    }
    // The edge may lie in a pixel that both pairs have: the first one, which does not bend, has no line.
    const double turn = Turn(*before, *behind);
    if (turn < glm::radians(creaseAngle) || Turn(*before, between) < 0.1 * turn)
    {
      return false;
    }
    const std::optional<double> first = this->Slope(x - 2 * dx, y - 2 * dy, dx, dy, pixel);
    const std::optional<double> last = this->Slope(nextX + dx, nextY + dy, dx, dy, pixel);
    return first && last && std::max(Turn(*first, *before), Turn(*behind, *last)) < flatness * turn;
  }

private:
  bool Inside(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < static_cast<int>(this->image_.width) && y < static_cast<int>(this->image_.height);
  }
  std::size_t At(int x, int y) const { return std::size_t(y) * this->image_.width + x; }
  // Between a pixel and the next one along (dx, dy), if they show one glyph.
  std::optional<double> Slope(int x, int y, int dx, int dy, double pixel) const
  {
    if (!this->IsHit(x, y) || !this->IsHit(x + dx, y + dy) || !this->IsSame(x, y, x + dx, y + dy))
    {
      return {};
    }
    return (this->ViewDepth(x + dx, y + dy) - this->ViewDepth(x, y)) / pixel;
  }
  // At the rim of a glyph depths are those of samples beside the pixel's center: on what is steep across the pair they
  // are off by up to so much.
  double Steepness(int x, int y, int dx, int dy, double pixel) const
  {
    return std::max(std::abs(this->Slope(x, y, dx, dy, pixel).value_or(0.0)),
      std::abs(this->Slope(x - dx, y - dy, dx, dy, pixel).value_or(0.0)));
  }
  static double Turn(double slope, double other) { return std::abs(std::atan(slope) - std::atan(other)); }

  const Image& image_;
  const float* depths_; ///< window depths of its pixels
  const Camera& camera_;
  double pixelAtOne_; ///< width of a pixel at view depth 1
};

void DrawLines(const ScreenEffects& effects, const Image& image, const Surface& surface, EffectImage& result)
{
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  // Middles of the pixels' common sides where there is a line.
  std::vector<std::uint8_t> right(result.colours.size()), above(result.colours.size());
  ParallelFor(image.height,
    [&](std::size_t row)
    {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x)
      {
        const std::size_t at = row * image.width + x;
        right[at] = x + 1 < width && surface.HasBorder(x, y, 1, 0);
        above[at] = y + 1 < height && surface.HasBorder(x, y, 0, 1);
      }
    });

  const float half = 0.5f * effects.outlineWidth;
  const int reach = static_cast<int>(std::ceil(half + 0.5f));
  ParallelFor(image.height,
    [&](std::size_t row)
    {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x)
      {
        float nearest = half + 0.5f, depth = 1.0f;
        for (int fromY = std::max(y - reach, 0); fromY <= std::min(y + reach, height - 1); ++fromY)
        {
          for (int fromX = std::max(x - reach, 0); fromX <= std::min(x + reach, width - 1); ++fromX)
          {
            const std::size_t from = std::size_t(fromY) * image.width + fromX;
            const auto take = [&](float middleX, float middleY, std::size_t other)
            {
              const float distance = std::hypot(middleX - x, middleY - y);
              if (distance < nearest)
              {
                nearest = distance;
                depth = std::min(image.depth[from], image.depth[other]);
              }
            };
            if (right[from])
            {
              take(fromX + 0.5f, fromY, from + 1);
            }
            if (above[from])
            {
              take(fromX, fromY + 0.5f, from + image.width);
            }
          }
        }
        const float cover = std::clamp(half + 0.5f - nearest, 0.0f, std::min(1.0f, effects.outlineWidth));
        if (cover > 0.0f)
        {
          const std::size_t at = row * image.width + x;
          const glm::vec4 below = glm::unpackUnorm4x8(result.colours[at]);
          const float alpha = cover + (1.0f - cover) * below.a;
          const glm::vec3 colour =
            (cover * effects.outlineColour + (1.0f - cover) * below.a * glm::vec3(below)) / alpha;
          result.colours[at] = glm::packUnorm4x8(glm::vec4(colour, alpha));
          result.depths[at] = std::min(result.depths[at], depth);
        }
      }
    });
}

} // namespace

EffectImage Apply(const ScreenEffects& effects, const Image& image, const Camera& camera)
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  EffectImage result;
  result.colours.assign(image.colour, image.colour + pixels);
  result.depths.assign(image.depth, image.depth + pixels);
  if (effects.outlineWidth > 0.0f)
  {
    DrawLines(effects, image, Surface(image, image.depth, camera), result);
  }
  if (effects.depthCue > 0.0f)
  {
    const Surface places(image, result.depths.data(), camera); // lines have depths of their own
    ParallelFor(image.height,
      [&](std::size_t row)
      {
        for (std::uint32_t x = 0; x < image.width; ++x)
        {
          const std::size_t at = row * image.width + x;
          if (result.depths[at] < 1.0f)
          {
            const double depth = places.ViewDepth(static_cast<int>(x), static_cast<int>(row));
            const double share = (depth - effects.nearDepth) / std::max(effects.farDepth - effects.nearDepth, 1e-300);
            glm::vec4 colour = glm::unpackUnorm4x8(result.colours[at]);
            colour.a *= 1.0f - effects.depthCue * static_cast<float>(std::clamp(share, 0.0, 1.0));
            result.colours[at] = glm::packUnorm4x8(colour);
          }
        }
      });
  }
  return result;
}

} // namespace rtg
