#include "ScreenEffects.h"

#include "Parallel.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace rtg
{

namespace
{

// From this angle between two surfaces on, in degrees, their edge is a crease. Either bends by less than this fraction
// of it from pixel to pixel: thin cylinders have none.
constexpr double creaseAngle = 40.0, flatness = 0.25;
// By how many pixels a depth must be off what its neighbors on either side lead to, to be a step.
constexpr double leastStep = 2.0;
// Of a glyph's visible diameter: its lines cover at most an eighth of it.
constexpr float widestLine = 1.0f / 16.0f;
// Pieces of a tube are longer than a quarter of its radius: next to each other are no others than these.
constexpr std::uint32_t nearestPieces = 8;
// Visible diameters, in pixels, up to which there are no lines and from which on they are whole.
constexpr float smallest = 8.0f, large = 24.0f;
// Pixels over which a border is blurred: up to the first its line is whole, from the second on there is none, because
// samples at pixels' centers would leave dots.
constexpr double sharpBlur = 1.0, widestBlur = 3.0;

// Sides of pixels with an inner line, in five by five pixels; fewer would be dots.
constexpr int leastInnerSides = 4;

// A side of two pixels: without a line, at the edge of a glyph, or at a step or crease within one.
enum class Line : char
{
  None,
  Outline,
  Inner
};

// The image's pixels as places in space, from their centers' depths.
class Surface
{
public:
  Surface(const Image& image, const float* depths, const Camera& camera, const OutlinedSets& sets)
    : image_(image)
    , depths_(depths)
    , camera_(camera)
    , sets_(sets)
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
    if (this->image_.setIds[a] != this->image_.setIds[b])
    {
      return false;
    }
    if (this->image_.glyphIds[a] == this->image_.glyphIds[b])
    {
      return true;
    }
    const OutlinedSets::Kind kind = this->KindOf(a);
    if (kind != OutlinedSets::Kind::Tubes)
    {
      return kind == OutlinedSets::Kind::Surface;
    }
    const std::uint32_t first = this->PieceOf(a).number, second = this->PieceOf(b).number;
    return std::max(first, second) - std::min(first, second) <= nearestPieces;
  }
  // What the pixel shows a part of.
  std::uint64_t KeyOf(std::size_t at) const
  {
    const bool whole = this->KindOf(at) == OutlinedSets::Kind::Surface;
    return std::uint64_t(this->image_.setIds[at]) << 32u | (whole ? 0u : this->image_.glyphIds[at]);
  }
  // Twice the pixels across a tube, which is what Visible::Diameter() of a long tube is; 0 of all else.
  float TubeDiameter(std::size_t at) const
  {
    return static_cast<float>(2.0 * this->PieceOf(at).width / this->PixelSize(this->ViewDepth(at)));
  }
  double ViewDepth(int x, int y) const { return this->ViewDepth(this->At(x, y)); }
  double ViewDepth(std::size_t at) const
  {
    const double window = this->depths_[at];
    const double offset = window - this->camera_.depthA;
    return this->camera_.parallel ? offset / this->camera_.depthB : this->camera_.depthB / offset;
  }
  double PixelSize(double viewDepth) const { return this->pixelAtOne_ * (this->camera_.parallel ? 1.0 : viewDepth); }

  // Pixels over which the lens and its motion spread what a pixel shows.
  double Blur(std::size_t at) const
  {
    const double depth = this->ViewDepth(at);
    const double defocus = (this->camera_.focusDepth - depth) / (this->camera_.focusDepth - this->camera_.lensDepth);
    const double circle = this->camera_.lensRadius > 0.0 ? 2.0 * this->camera_.lensRadius * std::abs(defocus) : 0.0;
    return std::max(circle, this->PathLength(at)) / this->PixelSize(depth);
  }
  double PathLength(std::size_t at) const
  {
    const auto& pathLength = this->sets_.pathLength;
    return pathLength ? pathLength(this->image_.setIds[at], this->image_.glyphIds[at]) : 0.0;
  }

  // The line between a pixel and the next one along (dx, dy), both of which the image has.
  Line Between(int x, int y, int dx, int dy) const
  {
    const int nextX = x + dx, nextY = y + dy;
    const bool hit = this->IsHit(x, y);
    if (hit != this->IsHit(nextX, nextY) || (hit && !this->IsSame(x, y, nextX, nextY)))
    {
      return Line::Outline;
    }
    // The depths of what moves are those of several moments.
    const bool inner = hit && this->HasStepOrCrease(x, y, dx, dy) && this->PathLength(this->At(x, y)) == 0.0;
    return inner ? Line::Inner : Line::None;
  }

private:
  // Whether the surface has a step or a crease between the two pixels, which show the same one.
  bool HasStepOrCrease(int x, int y, int dx, int dy) const
  {
    const int nextX = x + dx, nextY = y + dy;
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
    const double across = this->MeanSlope(x - dx, y - dy, dy, dx, pixel),
                 nextAcross = this->MeanSlope(nextX + dx, nextY + dy, dy, dx, pixel);
    const double turn = Turn(*before, across, *behind, nextAcross);
    if (turn < glm::radians(creaseAngle) || Turn(*before, across, between, across) < 0.1 * turn)
    {
      return false;
    }
    const std::optional<double> first = this->Slope(x - 2 * dx, y - 2 * dy, dx, dy, pixel);
    const std::optional<double> last = this->Slope(nextX + dx, nextY + dy, dx, dy, pixel);
    return first && last &&
      std::max(Turn(*first, across, *before, across), Turn(*behind, nextAcross, *last, nextAcross)) < flatness * turn;
  }

  bool Inside(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < static_cast<int>(this->image_.width) && y < static_cast<int>(this->image_.height);
  }
  std::size_t At(int x, int y) const { return std::size_t(y) * this->image_.width + x; }
  OutlinedSets::Kind KindOf(std::size_t at) const
  {
    return this->sets_.kind ? this->sets_.kind(this->image_.setIds[at]) : OutlinedSets::Kind::Glyphs;
  }
  OutlinedSets::Piece PieceOf(std::size_t at) const
  {
    return this->KindOf(at) == OutlinedSets::Kind::Tubes
      ? this->sets_.piece(this->image_.setIds[at], this->image_.glyphIds[at])
      : OutlinedSets::Piece{};
  }
  // Between a pixel and the next one along (dx, dy), if they show one glyph or parts of one surface.
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
  double MeanSlope(int x, int y, int dx, int dy, double pixel) const
  {
    const std::optional<double> before = this->Slope(x - dx, y - dy, dx, dy, pixel);
    const std::optional<double> behind = this->Slope(x, y, dx, dy, pixel);
    return 0.5 * (before ? *before : behind.value_or(0.0)) + 0.5 * (behind ? *behind : before.value_or(0.0));
  }
  // Angle between two surfaces, from their slopes along and across the pair of pixels.
  static double Turn(double along, double across, double otherAlong, double otherAcross)
  {
    const glm::dvec3 normal(along, across, 1.0), other(otherAlong, otherAcross, 1.0);
    return std::atan2(glm::length(glm::cross(normal, other)), glm::dot(normal, other));
  }

  const Image& image_;
  const float* depths_; ///< window depths of its pixels
  const Camera& camera_;
  const OutlinedSets& sets_;
  double pixelAtOne_; ///< width of a pixel at view depth 1
};

// What is visible of a glyph: its pixels, and how many of their sides have a line.
struct Visible
{
  std::size_t pixels = 0, sides = 0;

  // Four times the area over the circumference, which is a disc's diameter (the hydraulic diameter).
  float Diameter() const { return 4.0f * this->pixels / this->sides; }
};

// Widths of the lines in the middles of pixels' sides; 0: there is none.
struct Lines
{
  std::vector<float> right, above;
};

Lines FindLines(const ScreenEffects& effects, const Image& image, const Surface& surface)
{
  const std::size_t width = image.width, pixels = width * image.height;
  Lines lines{ std::vector<float>(pixels), std::vector<float>(pixels) };
  std::vector<Line> right(pixels, Line::None), above = right;
  ParallelFor(image.height,
    [&](std::size_t row)
    {
      const int y = static_cast<int>(row);
      for (int x = 0; x < static_cast<int>(width); ++x)
      {
        if (x + 1 < static_cast<int>(width))
        {
          right[row * width + x] = surface.Between(x, y, 1, 0);
        }
        if (row + 1 < image.height)
        {
          above[row * width + x] = surface.Between(x, y, 0, 1);
        }
      }
    });
  ParallelFor(image.height,
    [&](std::size_t row)
    {
      for (std::size_t x = 0; x < width; ++x)
      {
        const std::size_t i = row * width + x;
        int near = 0;
        if (right[i] == Line::Inner || above[i] == Line::Inner)
        {
          for (std::size_t y = row - std::min<std::size_t>(row, 2); y < std::min<std::size_t>(row + 3, image.height);
               ++y)
          {
            for (std::size_t j = y * width + x - std::min<std::size_t>(x, 2); j < y * width + std::min(x + 3, width);
                 ++j)
            {
              near += (right[j] == Line::Inner) + (above[j] == Line::Inner);
            }
          }
        }
        lines.right[i] = right[i] == Line::Outline || (right[i] == Line::Inner && near >= leastInnerSides);
        lines.above[i] = above[i] == Line::Outline || (above[i] == Line::Inner && near >= leastInnerSides);
      }
    });

  std::unordered_map<std::uint64_t, Visible> glyphs;
  std::vector<Visible*> at(pixels, nullptr);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (image.glyphIds[i] != Image::noGlyph)
    {
      const bool again = i > 0 && image.glyphIds[i] == image.glyphIds[i - 1] && image.setIds[i] == image.setIds[i - 1];
      at[i] = again ? at[i - 1] : &glyphs[surface.KeyOf(i)];
      ++at[i]->pixels;
    }
  }
  const auto forEach = [&](const auto& take)
  {
    for (std::size_t i = 0; i < pixels; ++i)
    {
      if (lines.right[i] > 0.0f)
      {
        take(lines.right[i], i, i + 1);
      }
      if (lines.above[i] > 0.0f)
      {
        take(lines.above[i], i, i + width);
      }
    }
  };
  Visible nothing;
  forEach(
    [&](float, std::size_t i, std::size_t other)
    {
      ++(at[i] ? at[i] : &nothing)->sides;
      ++(at[other] ? at[other] : &nothing)->sides;
    });
  forEach(
    [&](float& line, std::size_t i, std::size_t other)
    {
      const bool isOther = !at[i] || (at[other] && image.depth[other] < image.depth[i]);
      const std::size_t front = isOther ? other : i;
      const double sharp = (widestBlur - surface.Blur(front)) / (widestBlur - sharpBlur);
      const float tube = surface.TubeDiameter(front);
      const float diameter = tube > 0.0f ? tube : at[front]->Diameter();
      line = std::min(effects.outlineWidth, widestLine * diameter) *
        std::clamp((diameter - smallest) / (large - smallest), 0.0f, 1.0f) *
        static_cast<float>(std::clamp(sharp, 0.0, 1.0));
    });
  return lines;
}

void DrawLines(const ScreenEffects& effects, const Image& image, const Surface& surface, EffectImage& result)
{
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  const Lines lines = FindLines(effects, image, surface);
  const int reach = static_cast<int>(std::ceil(0.5f * effects.outlineWidth + 0.5f));
  ParallelFor(image.height,
    [&](std::size_t row)
    {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x)
      {
        float deepest = 0.0f, cover = 0.0f, depth = 1.0f; // in a line
        for (int fromY = std::max(y - reach, 0); fromY <= std::min(y + reach, height - 1); ++fromY)
        {
          for (int fromX = std::max(x - reach, 0); fromX <= std::min(x + reach, width - 1); ++fromX)
          {
            const std::size_t from = std::size_t(fromY) * image.width + fromX;
            const auto take = [&](float line, float middleX, float middleY, std::size_t other)
            {
              const float within = line > 0.0f ? 0.5f * line + 0.5f - std::hypot(middleX - x, middleY - y) : 0.0f;
              if (within > deepest)
              {
                deepest = within;
                cover = std::min({ within, line, 1.0f });
                depth = std::min(image.depth[from], image.depth[other]);
              }
            };
            take(lines.right[from], fromX + 0.5f, fromY, from + 1);
            take(lines.above[from], fromX, fromY + 0.5f, from + image.width);
          }
        }
        if (cover > 0.0f)
        {
          const std::size_t at = row * image.width + x;
          const glm::vec4 below = glm::unpackUnorm4x8(result.colors[at]);
          const float alpha = cover + (1.0f - cover) * below.a;
          const glm::vec3 color = (cover * effects.outlineColor + (1.0f - cover) * below.a * glm::vec3(below)) / alpha;
          result.colors[at] = glm::packUnorm4x8(glm::vec4(color, alpha));
          result.depths[at] = std::min(result.depths[at], depth);
        }
      }
    });
}

} // namespace

EffectImage Apply(const ScreenEffects& effects, const Image& image, const Camera& camera, const OutlinedSets& sets)
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  EffectImage result;
  result.colors.assign(image.color, image.color + pixels);
  result.depths.assign(image.depth, image.depth + pixels);
  if (effects.outlineWidth > 0.0f)
  {
    DrawLines(effects, image, Surface(image, image.depth, camera, sets), result);
  }
  if (effects.depthCue > 0.0f)
  {
    const Surface places(image, result.depths.data(), camera, sets); // lines have depths of their own
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
            glm::vec4 color = glm::unpackUnorm4x8(result.colors[at]);
            color.a *= 1.0f - effects.depthCue * static_cast<float>(std::clamp(share, 0.0, 1.0));
            result.colors[at] = glm::packUnorm4x8(color);
          }
        }
      });
  }
  return result;
}

} // namespace rtg
