// Outlines and depth cue on images that are made by hand: their places and widths are known.
#include "ScreenEffects.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace
{

using rtg::Image;

class ScreenEffectsTest : public ::testing::Test
{
protected:
  // What a pixel shows: view depth and glyph; a depth of 0: nothing.
  struct Seen
  {
    double depth = 0.0;
    std::uint32_t glyph = 0;
  };

  static constexpr std::uint32_t rows = 32;

  // The middle rows of a square image: of a parallel view of half-width 1, or of one in perspective that is so wide at
  // depth 4.
  void Make(std::uint32_t side, const std::function<Seen(double x, double y)>& scene, bool parallel = true)
  {
    const double half = double(rows) / side; // of the height
    const glm::dmat4 projection = parallel ? glm::ortho(-1.0, 1.0, -half, half, 1.0, 9.0)
                                           : glm::frustum(-0.25, 0.25, -0.25 * half, 0.25 * half, 1.0, 9.0);
    this->camera =
      rtg::Camera::FromWorldToClip(projection * glm::lookAt(glm::dvec3(0, 0, 4), glm::dvec3(0), glm::dvec3(0, 1, 0)));
    this->side = side;
    this->colors.assign(std::size_t(side) * rows, 0);
    this->depths.assign(this->colors.size(), 1.0f);
    this->setIds.assign(this->colors.size(), Image::noGlyph);
    this->glyphs = this->setIds;
    for (std::uint32_t row = 0; row < rows; ++row)
    {
      for (std::uint32_t column = 0; column < side; ++column)
      {
        const Seen seen = scene(2.0 * (column + 0.5) / side - 1.0, half * (2.0 * (row + 0.5) / rows - 1.0));
        const std::size_t at = std::size_t(row) * side + column;
        if (seen.depth > 0.0)
        {
          this->colors[at] = glm::packUnorm4x8(glm::vec4(1.0f));
          this->depths[at] = static_cast<float>(
            this->camera.depthA + (parallel ? this->camera.depthB * seen.depth : this->camera.depthB / seen.depth));
          this->setIds[at] = 0;
          this->glyphs[at] = seen.glyph;
        }
      }
    }
    this->image.width = side;
    this->image.height = rows;
    this->image.color = this->colors.data();
    this->image.depth = this->depths.data();
    this->image.setIds = this->setIds.data();
    this->image.glyphIds = this->glyphs.data();
  }

  rtg::EffectImage Apply() const { return rtg::Apply(this->effects, this->image, this->camera, this->sets); }

  // In the middle row, how much of each pixel is black line: what its white is darker by, or its opacity.
  std::vector<double> LineInRow() const
  {
    const rtg::EffectImage result = this->Apply();
    std::vector<double> line;
    for (std::uint32_t column = 0; column < this->side; ++column)
    {
      const std::size_t at = std::size_t(rows) / 2 * this->side + column;
      const glm::vec4 color = glm::unpackUnorm4x8(result.colors[at]);
      const bool hit = this->colors[at] != 0;
      line.push_back(hit ? 1.0 - color.r : color.a);
    }
    return line;
  }

  rtg::ScreenEffects effects;
  rtg::Camera camera;
  rtg::OutlinedSets sets;
  std::uint32_t side = 0;
  std::vector<std::uint32_t> colors, setIds, glyphs;
  std::vector<float> depths;
  Image image;
};

class SilhouetteTest
  : public ScreenEffectsTest
  , public ::testing::WithParamInterface<std::uint32_t>
{
};

// A ball's outline is as wide in each image and lies, half inside and half outside, on its edge; nothing is drawn
// within.
TEST_P(SilhouetteTest, SilhouettesAreAsWideInEveryImage)
{
  const double radius = 0.5;
  for (const bool parallel : { true, false })
  {
    this->Make(
      this->GetParam(),
      [&](double x, double y)
      {
        const double square = radius * radius - x * x - y * y;
        return Seen{ square > 0.0 ? 4.0 - std::sqrt(square) : 0.0, 0 };
      },
      parallel);
    for (const float width : { 1.0f, 2.0f, 5.0f })
    {
      this->effects.outlineWidth = width;
      const std::vector<double> line = this->LineInRow();
      const auto middle = line.begin() + this->side / 2;
      EXPECT_NEAR(std::accumulate(line.begin(), middle, 0.0), width, 0.5) << width;
      EXPECT_NEAR(std::accumulate(middle, line.end(), 0.0), width, 0.5) << width;
      const double edge = 0.5 * this->side * (1.0 - radius); // in pixels
      double center = 0.0;
      for (std::uint32_t i = 0; i < this->side / 2; ++i)
      {
        center += (i + 0.5) * line[i] / std::accumulate(line.begin(), middle, 0.0);
      }
      EXPECT_NEAR(center, edge, 0.6) << width;
      const auto reach = static_cast<std::uint32_t>(edge + width + 2.0);
      EXPECT_EQ(std::accumulate(line.begin() + reach, line.end() - reach, 0.0), 0.0) << width;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, SilhouetteTest, ::testing::Values(200u, 1000u, 8000u));

// Lines run between glyphs, along steps and creases within one, and nowhere on what is smooth.
TEST_F(ScreenEffectsTest, LinesWithinAGlyph)
{
  this->effects.outlineWidth = 2.0f;
  const double slope = 3.0;
  const auto lineAt = [this](const std::function<Seen(double, double)>& scene)
  {
    this->Make(200, scene);
    const std::vector<double> line = this->LineInRow();
    return std::accumulate(line.begin() + 5, line.end() - 5, 0.0);
  };
  // A plane that leans much; one glyph or two beside each other; a small and a large step; a roof of 90 and one of 20
  // degrees.
  EXPECT_EQ(lineAt([&](double x, double) { return Seen{ 4.0 + slope * x * 0.9, 0 }; }), 0.0);
  EXPECT_NEAR(lineAt([](double x, double) { return Seen{ 4.0, x < 0.0 ? 0u : 1u }; }), 2.0, 0.5);
  EXPECT_EQ(lineAt([](double x, double) { return Seen{ x < 0.0 ? 4.0 : 4.01, 0 }; }), 0.0);
  EXPECT_NEAR(lineAt([](double x, double) { return Seen{ x < 0.0 ? 4.0 : 4.2, 0 }; }), 2.0, 0.5);
  EXPECT_NEAR(lineAt([](double x, double) { return Seen{ 4.0 + std::abs(x), 0 }; }), 2.0, 0.5);
  EXPECT_EQ(lineAt([](double x, double) { return Seen{ 4.0 + 0.17 * std::abs(x), 0 }; }), 0.0);
  // A low roof of 90 degrees, one in every fourth row only, and one that moves.
  for (const int rowsApart : { 1, 4 })
  {
    const double found = lineAt(
      [rowsApart](double x, double y)
      {
        const bool roof = std::lround(100.0 * y + 15.5) % rowsApart == 0;
        return Seen{ 4.0 - (roof ? std::max(0.035 - std::abs(x), 0.0) : 0.0), 0 };
      });
    EXPECT_EQ(found > 1.0, rowsApart == 1) << found;
    EXPECT_EQ(found == 0.0, rowsApart > 1) << found;
  }
  this->sets.pathLength = [](std::uint32_t, std::uint32_t) { return 1e-4; };
  EXPECT_EQ(lineAt([](double x, double) { return Seen{ 4.0 + std::abs(x), 0 }; }), 0.0);
  this->sets = {};
  // The same roof of 20 degrees where it is seen at a flat angle.
  EXPECT_EQ(lineAt([](double x, double y) { return Seen{ 4.0 + 1.5 * std::abs(x) + 8.0 * y, 0 }; }), 0.0);
}

// Neighboring pieces of a tube and triangles of a surface have no lines between them, only at steps. Lines of a tube
// are as wide as it allows: of 16 pixels, and of 6.
TEST_F(ScreenEffectsTest, SurfacesHaveNoLinesBetweenTheirParts)
{
  this->effects.outlineWidth = 2.0f;
  using Kind = rtg::OutlinedSets::Kind;
  const auto lineAt = [this](Kind kind, double width, double behind, std::uint32_t next)
  {
    this->sets.kind = [kind](std::uint32_t) { return kind; };
    this->sets.piece = [width](std::uint32_t, std::uint32_t glyph) { return rtg::OutlinedSets::Piece{ glyph, width }; };
    this->Make(200, [&](double x, double) { return Seen{ x < 0.0 ? 4.0 : 4.0 + behind, x < 0.0 ? 0u : next }; });
    const std::vector<double> line = this->LineInRow();
    return std::accumulate(line.begin() + 5, line.end() - 5, 0.0);
  };
  EXPECT_NEAR(lineAt(Kind::Glyphs, 0.0, 0.0, 1), 2.0, 0.02);
  for (const Kind kind : { Kind::Tubes, Kind::Surface })
  {
    EXPECT_EQ(lineAt(kind, 0.16, 0.0, 1), 0.0);
    EXPECT_NEAR(lineAt(kind, 0.16, 0.2, 1), 2.0, 0.02);
  }
  EXPECT_NEAR(lineAt(Kind::Tubes, 0.16, 0.0, 100), 2.0, 0.02);
  EXPECT_NEAR(lineAt(Kind::Tubes, 0.06, 0.2, 100), 0.75 * (12.0 - 8.0) / 16.0, 0.02);
  EXPECT_EQ(lineAt(Kind::Surface, 0.0, 0.0, 100), 0.0);
}

// Lines cover at most an eighth of a lattice of squares. They are whole around large ones, none around small ones.
TEST_F(ScreenEffectsTest, SmallGlyphsHaveFaintLines)
{
  this->effects.outlineWidth = 1.5f;
  for (const std::uint32_t length : { 32u, 16u, 8u, 4u, 2u, 1u })
  {
    this->Make(256,
      [length](double x, double y)
      {
        const auto column = static_cast<std::uint32_t>(128.0 * (x + 1.0)) / length;
        const auto row = static_cast<std::uint32_t>(128.0 * y + 16.0) / length;
        return Seen{ (column + row) % 2 == 0 ? 4.0 : 4.5, 256 * row + column };
      });
    double covered = 0.0;
    for (const std::uint32_t color : this->Apply().colors)
    {
      covered += (1.0 - glm::unpackUnorm4x8(color).r) / (256.0 * rows);
    }
    // A square at the image's border has three sides, so it counts as larger.
    EXPECT_LE(covered, length > 8 ? 0.13 : length == 8 ? 0.015 : 0.0) << length;
    EXPECT_EQ(covered > 0.04, length > 8) << length;
  }
  this->Make(256, [](double x, double) { return Seen{ 4.0, x < 0.0 ? 0u : 1u }; });
  const std::vector<double> line = this->LineInRow();
  EXPECT_NEAR(std::accumulate(line.begin(), line.end(), 0.0), 1.5, 0.01);
}

// A line fades where its glyph is blurred by one to three pixels, which are 0.01 wide: by a lens that focuses before
// it, by one in focus never, or by motion.
TEST_F(ScreenEffectsTest, NoLinesWhereGlyphsAreBlurred)
{
  this->effects.outlineWidth = 2.0f;
  for (const bool parallel : { true, false })
  {
    this->Make(
      200,
      [](double x, double) {
        return Seen{ x < 0.0 ? 4.0 : 0.0, 0 };
      },
      parallel);
    const auto lineOf = [this](double blur, double focus, double moved)
    {
      this->camera.focusDepth = focus;
      this->camera.lensRadius = 0.5 * blur * focus / (4.0 - 2.0);
      this->sets.pathLength = [moved](std::uint32_t, std::uint32_t) { return moved; };
      const std::vector<double> line = this->LineInRow();
      return std::accumulate(line.begin() + 5, line.end() - 5, 0.0);
    };
    const double whole = lineOf(0.0, 2.0, 0.0);
    EXPECT_NEAR(whole, 2.0, 0.5);
    EXPECT_EQ(lineOf(0.04, 4.0, 0.0), whole);
    for (const double blur : { 0.005, 0.02, 0.04 })
    {
      const double sharp = glm::clamp((3.0 - blur / 0.01) / 2.0, 0.0, 1.0);
      EXPECT_NEAR(lineOf(blur, 2.0, 0.0), sharp * whole, 0.15) << blur;
      EXPECT_NEAR(lineOf(0.0, 2.0, blur), sharp * whole, 0.15) << blur;
    }
  }
}

// A line over nothing has the depth of what it belongs to, and what has none stays as it was.
TEST_F(ScreenEffectsTest, LinesHaveDepth)
{
  this->effects.outlineWidth = 4.0f;
  this->effects.outlineColor = { 1.0f, 0.0f, 0.0f };
  this->Make(64, [](double x, double) { return Seen{ x < 0.0 ? 4.0 : 0.0, 0 }; });
  const rtg::EffectImage result = this->Apply();
  const std::size_t row = 64 * rows / 2;
  EXPECT_EQ(result.colors[row + 32], glm::packUnorm4x8(glm::vec4(1, 0, 0, 1)));
  EXPECT_EQ(result.depths[row + 32], this->depths[row + 31]);
  EXPECT_EQ(result.depths[row + 40], 1.0f);
  EXPECT_EQ(result.colors[row + 40], 0u);
  EXPECT_EQ(result.colors[row + 10], this->colors[row + 10]);
}

// What is half-way between the planes loses half of what the farthest loses.
TEST_F(ScreenEffectsTest, DepthCueGrowsWithDistance)
{
  this->effects.depthCue = 0.8f;
  this->effects.nearDepth = 3.0;
  this->effects.farDepth = 5.0;
  for (const bool parallel : { true, false })
  {
    this->Make(
      100,
      [](double x, double) {
        return Seen{ 4.0 + 1.5 * x, 0 };
      },
      parallel);
    const rtg::EffectImage result = this->Apply();
    for (std::size_t column = 0; column < 100; ++column)
    {
      const double share = glm::clamp((4.0 + 1.5 * (2.0 * (column + 0.5) / 100.0 - 1.0) - 3.0) / 2.0, 0.0, 1.0);
      const glm::vec4 color = glm::unpackUnorm4x8(result.colors[rows / 2 * 100 + column]);
      EXPECT_NEAR(color.a, 1.0 - 0.8 * share, 0.003);
      EXPECT_EQ(color.r, 1.0f);
    }
  }
}

} // namespace
