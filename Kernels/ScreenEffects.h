#pragma once

#include "Camera.h"
#include "Tracer.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace rtg
{

/// Effects on the pixels of a traced image.
struct ScreenEffects
{
  float outlineWidth = 0.0f;              ///< pixels, in [0, 64]; 0: no lines
  glm::vec3 outlineColor{ 0.0f };         ///< display color, in [0, 1]
  float depthCue = 0.0f;                  ///< [0, 1]: what is lost of the opacity at farDepth; in between in proportion
  double nearDepth = 0.0, farDepth = 1.0; ///< view depths between which the depth cue grows

  bool Any() const { return this->outlineWidth > 0.0f || this->depthCue > 0.0f; }
  bool operator==(const ScreenEffects&) const = default;
};

/// What lines have to know of the sets of an image. Empty functions: Glyphs, 0.
struct OutlinedSets
{
  enum class Kind
  {
    Glyphs,
    Tubes,  ///< of pieces, between which there are no lines
    Surface ///< of triangles, between which there are no lines
  };
  std::function<Kind(std::uint32_t set)> kind;
  struct Piece
  {
    std::uint32_t number = 0; ///< along the tubes, one after the other
    double width = 0.0;       ///< world units
  };
  std::function<Piece(std::uint32_t set, std::uint32_t glyph)> piece; ///< of Tubes
  /// World length that a glyph moves while the shutter is open.
  std::function<double(std::uint32_t set, std::uint32_t glyph)> pathLength;
};

/// The colors and window depths of an image with these effects. Lines run along borders between glyphs, or between a
/// glyph and what is behind it, along steps of the depth within a glyph, and along creases of more than 40 degrees.
/// They are as wide in every image, half of it on either side of the border, and lie at the depth of what is in front.
/// Around what is less than 24 pixels wide they are thinner, below 8 pixels there are none, nor around what a lens or
/// its motion blurs over more than a pixel or two.
struct EffectImage
{
  std::vector<std::uint32_t> colors; ///< as Image::color
  std::vector<float> depths;
};
EffectImage
Apply(const ScreenEffects& effects, const Image& image, const Camera& camera, const OutlinedSets& sets = {});

} // namespace rtg
