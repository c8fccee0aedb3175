// Scene and Tracer on the machine's Vulkan device: what an image holds.
#include "Tiles.h"
#include "TracerFixture.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

using rtg::Image;
using namespace rtg::testing;

// What lies idle of a launch keeps one core waiting for the other.
TEST(LaunchGrid, HasRoomForAllTilesAndNearlyNoMore)
{
  for (std::uint32_t tiles = 1; tiles <= 16 * rtg::LaunchGrid::mostColumns; ++tiles)
  {
    const rtg::LaunchGrid grid(tiles);
    ASSERT_LE(grid.columns, rtg::LaunchGrid::mostColumns);
    ASSERT_GE(grid.rows * grid.columns, tiles);
    ASSERT_LT(grid.rows * grid.columns, tiles + grid.rows);
  }
}

// A GPU takes as long for one tile as for so many that fill it, and its threads take their samples one after the other.
TEST(LaunchCost, LaunchesAreShortAndFillAGpu)
{
  constexpr std::uint32_t tiles = 240 * 135, wanted = 64;
  using Gpu = std::pair<std::uint32_t, double>; // tiles that fill it, seconds of one sample of a thread
  for (const auto& [filling, latency] :
    { Gpu(528, 1e-4), Gpu(528, 7e-4), Gpu(528, 1.5e-3), Gpu(528, 8e-3), Gpu(528, 2e-2), Gpu(32, 7e-4), Gpu(32, 2e-2) })
  {
    rtg::LaunchCost cost{ 512 };
    double all = 0.0, longestOfAll = 0.0;
    int slow = 0; // launches
    for (std::uint32_t samples = 1, done = 0; done < wanted;)
    {
      double longest = 0.0;
      for (std::uint32_t left = tiles; left > 0;)
      {
        const std::uint32_t launched = cost.NextTiles(left, samples);
        ASSERT_TRUE(0 < launched && launched <= left);
        const double seconds = samples * latency * std::max(1.0, double(launched) / filling);
        cost.Add(launched, samples, seconds);
        left -= launched;
        all += seconds;
        longest = std::max(longest, seconds);
        slow += seconds > rtg::LaunchCost::longest;
      }
      longestOfAll = std::max(longestOfAll, longest);
      done += samples;
      const double next = std::clamp(rtg::LaunchCost::NextSamples(samples, longest), 1.0, 32.0);
      samples = std::min(static_cast<std::uint32_t>(next), wanted - done);
    }
    EXPECT_LT(all, 1.3 * wanted * latency * tiles / filling) << latency;
    EXPECT_LE(longestOfAll, filling < 512 ? 0.4 : 2.0 * std::max(rtg::LaunchCost::wanted, latency)) << latency;
    EXPECT_LE(slow, 1) << latency;
  }
}

TEST_P(StructureTest, SphereCoversExactlyThePixelsWhoseCentersItCovers)
{
  this->AddSpheres({ { 0.1f, -0.2f, 0.0f } }, 1.0f);
  const Image image = this->Trace();
  for (int y = 0; y < 100; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      const double dx = (x + 0.5) / 50.0 - 1.0 - double(0.1f);
      const double dy = (y + 0.5) / 50.0 - 1.0 - double(-0.2f);
      const double r2 = dx * dx + dy * dy;
      if (std::abs(r2 - 0.25) < 1e-6)
      {
        continue;
      }
      const std::size_t at = y * 100 + x;
      ASSERT_EQ(image.glyphIds[at] != Image::noGlyph, r2 < 0.25) << x << ' ' << y;
      // Camera at z = 5, planes at 1 and 9: depth runs linearly from z = 4 to z = -4.
      const double depth = r2 < 0.25 ? (4.0 - std::sqrt(0.25 - r2)) / 8.0 : 1.0;
      ASSERT_NEAR(image.depth[at], depth, 1e-6) << x << ' ' << y;
    }
  }
}

TEST_P(StructureTest, ExponentsFollowTheirGlyphs)
{
  // Superquadrics side by side, seen along z: the outline is |x|^r + |y|^s = 1, whatever t is. There are so many
  // that they get sorted.
  constexpr int side = 8;
  constexpr float cell = 2.0f / side;
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Superquadric;
  instances.uniformSize = 0.9f * cell;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> logarithm(std::log(0.3f), std::log(20.0f));
  for (int i = 0; i < side * side; ++i)
  {
    instances.centers.emplace_back(-1.0f + cell * (i % side + 0.5f), -1.0f + cell * (i / side + 0.5f), 0.0f);
    instances.exponents3.emplace_back(
      std::exp(logarithm(random)), std::exp(logarithm(random)), std::exp(logarithm(random)));
  }
  const std::vector<glm::vec3> own = instances.exponents3;
  instances.uniformExponents = { 0.7f, 5.0f, 3.0f };
  const auto id = this->scene.Add();

  for (const bool uniform : { false, true })
  {
    const std::uint64_t uploads = this->scene.GetStatistics().instanceUploads;
    instances.exponents3 = uniform ? std::vector<glm::vec3>() : own;
    this->scene.SetInstances(id, instances);
    const Image image = this->Trace();
    EXPECT_EQ(this->scene.GetStatistics().instanceUploads, uploads + 1);
    int judged = 0;
    for (int at = 0; at < 10000; ++at)
    {
      const double px = (at % 100 + 0.5) / 50.0 - 1.0;
      const double py = (at / 100 + 0.5) / 50.0 - 1.0;
      const int glyph = int((py + 1.0) / cell) * side + int((px + 1.0) / cell);
      const glm::dvec3 e(uniform ? instances.uniformExponents : own[glyph]);
      const double halfSize = 0.5 * instances.uniformSize;
      const double x = std::abs(px - instances.centers[glyph].x) / halfSize;
      const double y = std::abs(py - instances.centers[glyph].y) / halfSize;
      const double value = std::pow(x, e.x) + std::pow(y, e.y);
      if (std::abs(value - 1.0) < 1e-3)
      {
        continue;
      }
      ++judged;
      ASSERT_EQ(image.glyphIds[at] != Image::noGlyph, value < 1.0) << at << ' ' << value;
      if (value < 1.0)
      {
        ASSERT_EQ(this->scene.OriginalGlyph(id, image.glyphIds[at]), std::uint32_t(glyph));
        const double z = halfSize * std::pow(1.0 - value, 1.0 / e.z);
        ASSERT_NEAR(image.depth[at], (4.0 - z) / 8.0, 1e-6) << at;
      }
    }
    EXPECT_GT(judged, 9900);
  }
}

TEST_P(StructureTest, MoreSamplesApproachTheExactArea)
{
  this->AddSpheres({ { 0.0f, 0.0f, 0.0f } }, 1.0f);
  this->settings.width = this->settings.height = 16;
  this->settings.samples = 256;
  const double area = glm::pi<double>() * 0.25 / 4.0;
  // 256 samples of 8-bit alpha in the 16 x 16 pixels: the R2 sequence errs by less than 1e-3 here, one sample by 8e-3.
  EXPECT_NEAR(Coverage(this->Trace()), area, 2e-3);
}

/// The places of samples in a pixel are as fine after many of them as at first.
// Mean square distance of what is seen from the middle of the image, along one axis, in pixels.
double Spread(const Image& image)
{
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t y = 0; y < image.height; ++y)
  {
    for (std::uint32_t x = 0; x < image.width; ++x)
    {
      const double alpha = (image.color[y * image.width + x] >> 24) / 255.0;
      const double dx = x + 0.5 - 0.5 * image.width, dy = y + 0.5 - 0.5 * image.height;
      sum += alpha;
      squares += alpha * 0.5 * (dx * dx + dy * dy);
    }
  }
  return squares / sum;
}

TEST_F(TracerTest, LensBlursWhatIsOutOfFocusAndNothingElse)
{
  // 50 pixels a unit at the depth in focus, 10.
  const glm::dmat4 look = glm::frustum(-0.1, 0.1, -0.1, 0.1, 1.0, 40.0) * this->LookFrom(10.0);
  const rtg::Camera pinhole = rtg::Camera::FromWorldToClip(look);
  const auto id = this->AddSpheres({ { 0, 0, -10 } }, 0.3f);
  for (const auto shading : { rtg::Shading::Local, rtg::Shading::AmbientOcclusion, rtg::Shading::PathTracing })
  {
    SCOPED_TRACE(static_cast<int>(shading));
    const rtg::Pass pass = shading == rtg::Shading::PathTracing ? rtg::Pass::All : rtg::Pass::Opaque;
    this->settings.shading = shading;
    this->settings.samples = 256;
    const auto spreadAt = [&](float z, double radius)
    {
      rtg::GlyphInstances instances;
      instances.centers = { { 0, 0, z } };
      instances.uniformSize = 0.3f;
      this->scene.SetInstances(id, instances);
      this->camera = pinhole;
      this->camera.lensRadius = radius;
      this->camera.focusDepth = 10.0;
      return Spread(this->Trace(pass));
    };
    // The circle of confusion of a point at depth d is radius |d - 10| / d in the plane in focus; a disc of radius R
    // spreads by R * R / 4.
    for (const auto& [z, circle] : { std::pair(-10.0f, 12.5), std::pair(5.0f, 25.0) })
    {
      const double blurred = std::sqrt(4.0 * (spreadAt(z, 0.5) - spreadAt(z, 0.0)));
      EXPECT_NEAR(blurred, circle, 0.02 * circle) << "at " << z;
    }
    EXPECT_NEAR(spreadAt(0.0f, 0.5), spreadAt(0.0f, 0.0), 0.02 * spreadAt(0.0f, 0.0));
    // Depths and ids are those of the lens's middle.
    this->settings.samples = 1;
    spreadAt(-10.0f, 0.5);
    const Image first = this->Trace(pass);
    const std::vector<std::uint32_t> colors(first.color, first.color + 100 * 100);
    spreadAt(-10.0f, 0.0);
    EXPECT_TRUE(std::equal(colors.begin(), colors.end(), this->Trace(pass).color));
  }
}

TEST_F(TracerTest, AnEdgeCoversThePixelAlsoOfManySamples)
{
  // Just beyond a 64th of the pixel's width, to which places would be rounded here if they were computed in floats.
  const float edge = (33.0f + 0.01f) / 64.0f;
  rtg::GlyphInstances upright;
  upright.shape = rtg::Shape::Cylinder;
  upright.centers = { glm::vec3(2.0f * edge - 1.0f - 2.0f, 0.0f, 0.0f) };
  upright.uniformSize = 4.0f;
  this->scene.SetInstances(this->scene.Add(), std::move(upright));
  this->settings.width = this->settings.height = 1;
  this->settings.keepSums = true;
  constexpr std::uint32_t half = 1u << 17;
  this->settings.samples = half;
  this->Trace();
  const double first = this->tracer->Means()[0].a;
  EXPECT_NEAR(first, edge, 1e-4);
  this->tracer->Resume(this->scene, 2 * half);
  EXPECT_NEAR(2.0 * this->tracer->Means()[0].a - first, edge, 1e-4);
}

/// What all samples of a pixel agree on is their mean, however many they are.
TEST_F(TracerTest, AMeanOfManySamplesIsTheMean)
{
  const auto id = this->AddSpheres({ { 0.0f, 0.0f, 0.0f } }, 4.0f);
  rtg::Material material;
  material.color = { 0.51f, 0.7f, 0.3f };
  material.lighting = false;
  this->scene.SetMaterial(id, material);
  this->settings.width = this->settings.height = 1;
  this->settings.keepSums = true;
  for (const rtg::Shading shading : { rtg::Shading::Local, rtg::Shading::AmbientOcclusion, rtg::Shading::PathTracing })
  {
    for (const float opacity : { 1.0f, 0.3f })
    {
      // Path tracing passes translucent surfaces by chance.
      if (opacity < 1.0f && shading == rtg::Shading::PathTracing)
      {
        continue;
      }
      material.opacity = opacity;
      this->scene.SetMaterial(id, material);
      this->settings.shading = shading;
      const rtg::Pass pass = opacity < 1.0f ? rtg::Pass::Translucent : rtg::Pass::Opaque;
      this->settings.samples = 1;
      this->Trace(pass);
      const glm::vec4 one = this->tracer->Means()[0];
      this->settings.samples = 1u << 17;
      this->Trace(pass);
      const glm::vec4 many = this->tracer->Means()[0];
      for (int i = 0; i < 4; ++i)
      {
        EXPECT_NEAR(many[i], one[i], 2e-7f * one[i]) << int(shading) << ' ' << opacity << ' ' << i;
      }
    }
  }
}

/// More light than floats can hold is white, not black.
TEST_F(TracerTest, EndlessLightIsWhite)
{
  const auto id = this->AddSpheres({ { 0.0f, 0.0f, 0.0f } }, 4.0f);
  rtg::Material material;
  material.ambient = 1.0f;
  material.ambientColor = glm::vec3(1e16f); // which is above 1e38 in linear light
  this->scene.SetMaterial(id, material);
  this->settings.width = this->settings.height = 1;
  this->settings.shading = rtg::Shading::PathTracing;
  this->settings.samples = 64;
  EXPECT_EQ(this->Trace().color[0], 0xffffffffu);
}

TEST_P(StructureTest, HeadlightShadesAsVtkDoes)
{
  const auto id = this->AddSpheres({ { 0.0f, 0.0f, 0.0f } }, 1.8f);
  rtg::Material material;
  material.color = { 0.8f, 0.4f, 0.2f };
  material.ambientColor = { 0.2f, 0.9f, 1.0f };
  material.ambient = 0.1f;
  material.diffuse = 0.7f;
  material.specular = 0.3f;
  material.specularPower = 20.0f;
  this->scene.SetMaterial(id, material);
  const Image image = this->Trace();
  for (int x = 10; x < 90; x += 7)
  {
    const double dx = (x + 0.5) / 50.0 - 1.0;
    const double dy = 0.5 / 50.0;
    const double nz = std::sqrt(1.0 - (dx * dx + dy * dy) / 0.81);
    const std::uint32_t color = image.color[50 * 100 + x];
    for (int channel = 0; channel < 3; ++channel)
    {
      const double expected =
        material.ambientColor[channel] * 0.1 + material.color[channel] * 0.7 * nz + 0.3 * std::pow(nz, 20.0);
      EXPECT_NEAR((color >> (8 * channel)) & 255, 255.0 * std::min(expected, 1.0), 1.0) << x;
    }
  }
}

TEST_P(StructureTest, EachGlyphShowsItsOwnColorAndId)
{
  const std::vector<glm::vec3> centers = { { -0.5f, -0.5f, 0 }, { 0.5f, -0.5f, 0 }, { -0.5f, 0.5f, 0 },
    { 0.5f, 0.5f, 0 }, { 0.0f, 0.0f, 0.2f } };
  const auto id = this->AddSpheres(centers, 0.5f);
  const std::vector<std::uint32_t> colors = { 0xff0000ff, 0xff00ff00, 0xffff0000, 0xff00ffff, 0xffff00ff };
  this->scene.SetColors(id, colors);
  rtg::Material material;
  material.lighting = false;
  this->scene.SetMaterial(id, material);
  const Image image = this->Trace();
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    const int x = static_cast<int>((centers[i].x + 1.0f) * 50.0f);
    const int y = static_cast<int>((centers[i].y + 1.0f) * 50.0f);
    EXPECT_EQ(image.color[y * 100 + x], colors[i]);
    EXPECT_EQ(this->scene.OriginalGlyph(id, image.glyphIds[y * 100 + x]), i);
    EXPECT_EQ(image.setIds[y * 100 + x], id);
  }
}

TEST_P(StructureTest, SetsFarApartKeepTheirPlaces)
{
  // The second set's own origin is far from the first's, and its glyph sits back at the middle.
  this->AddSpheres({ { -0.5f, 0.0f, 0.0f } }, 0.5f);
  const auto far = this->scene.Add();
  rtg::GlyphInstances instances;
  instances.origin = { 1000.25, 0.0, 0.0 };
  instances.centers = { { -999.75f, 0.0f, 0.0f } };
  instances.uniformSize = 0.5f;
  this->scene.SetInstances(far, instances);
  const Image image = this->Trace();
  EXPECT_EQ(image.setIds[50 * 100 + 75], far);
  EXPECT_EQ(image.setIds[50 * 100 + 51 + 13 - 1], far); // just inside its left edge at x = 0.25
  EXPECT_EQ(image.setIds[50 * 100 + 50], Image::noGlyph);
}

TEST_P(StructureTest, TranslucentSetsShowInTheirOwnPass)
{
  const auto opaque = this->AddSpheres({ { -0.5f, 0.0f, 0.0f } }, 0.5f);
  const auto translucent = this->AddSpheres({ { 0.5f, 0.0f, 0.0f } }, 0.5f);
  rtg::Material material;
  material.opacity = 0.5f;
  this->scene.SetMaterial(translucent, material);
  EXPECT_TRUE(this->scene.GetState().Shows(false));
  EXPECT_TRUE(this->scene.GetState().Shows(true));
  Image image = this->Trace(rtg::Pass::Opaque);
  EXPECT_EQ(image.setIds[50 * 100 + 25], opaque);
  EXPECT_EQ(image.setIds[50 * 100 + 75], Image::noGlyph);
  image = this->Trace(rtg::Pass::Translucent);
  EXPECT_EQ(image.setIds[50 * 100 + 25], Image::noGlyph);
  EXPECT_EQ(image.setIds[50 * 100 + 75], translucent);
  // Its front and its back, as depth peeling shows them.
  EXPECT_NEAR(image.color[50 * 100 + 75] >> 24, 0.75 * 255.0, 1.0);
}

TEST_P(StructureTest, FindsTheNearestOfManyGlyphsOfAnyCount)
{
  // Against brute force, from counts that make the smallest trees, with even and odd depth, upwards.
  // Then so densely that most lies behind what rays hit.
  const std::pair<std::size_t, float> scenes[] = { { 1, 0.6f }, { 2, 0.6f }, { 3, 0.6f }, { 4, 0.6f }, { 5, 0.6f },
    { 7, 0.6f }, { 8, 0.6f }, { 9, 0.6f }, { 16, 0.6f }, { 17, 0.6f }, { 33, 0.6f }, { 100, 0.6f }, { 1000, 0.6f },
    { 1000, 4.0f }, { 4100, 4.0f }, { 33000, 1.5f } };
  for (const auto& [count, filling] : scenes)
  {
    const auto points = RandomPoints(count);
    const float size = filling / std::cbrt(static_cast<float>(count));
    const auto id = this->AddSpheres(points, size);
    this->scene.Commit();
    const Image image = this->Trace();
    for (int y = 0; y < 100; y += 3)
    {
      for (int x = 0; x < 100; x += 3)
      {
        const double px = (x + 0.5) / 50.0 - 1.0;
        const double py = (y + 0.5) / 50.0 - 1.0;
        double highest = -INFINITY;
        std::uint32_t nearest = Image::noGlyph;
        bool grazing = false;
        for (std::size_t i = 0; i < count; ++i)
        {
          const double dx = px - points[i].x;
          const double dy = py - points[i].y;
          const double left = 0.25 * size * size - dx * dx - dy * dy;
          grazing = grazing || std::abs(left) < 1e-6 * size * size;
          if (left > 0.0 && points[i].z + std::sqrt(left) > highest)
          {
            highest = points[i].z + std::sqrt(left);
            nearest = static_cast<std::uint32_t>(i);
          }
        }
        if (grazing)
        {
          continue;
        }
        const std::uint32_t found = image.glyphIds[y * 100 + x];
        ASSERT_EQ(found == Image::noGlyph ? found : this->scene.OriginalGlyph(id, found), nearest)
          << count << " glyphs, pixel " << x << ' ' << y;
      }
    }
    this->scene.Remove(id);
  }
}

/// Needles, whose boxes are large and mostly empty: rays meet many before they hit.
TEST_F(TracerTest, NeedlesInFrontAreFound)
{
  RTG_NEEDS(rtg::Structure::Boxes);
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  rtg::GlyphInstances needles;
  needles.centers = RandomPoints(3000);
  needles.sizes3.assign(needles.centers.size(), glm::vec3(0.01f, 0.01f, 0.5f));
  for (std::size_t i = 0; i < needles.centers.size(); ++i)
  {
    const float x = normal(random), y = normal(random), z = normal(random), w = normal(random);
    needles.rotations.push_back(glm::normalize(glm::vec4(x, y, z, w)));
  }
  this->camera = rtg::Camera::FromWorldToClip(glm::perspective(0.6, 1.0, 1.0, 9.0) *
    glm::lookAt(glm::dvec3(2.0, -1.5, 3.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0)));
  this->settings.width = this->settings.height = 200;
  const auto trace = [&](rtg::Structure structure)
  {
    this->scene.GetState().structure = structure;
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, needles);
    this->scene.Commit();
    const Image image = this->Trace();
    std::vector<std::uint32_t> found(image.glyphIds, image.glyphIds + 40000);
    for (std::uint32_t& glyph : found)
    {
      glyph = glyph == Image::noGlyph ? glyph : this->scene.OriginalGlyph(id, glyph);
    }
    this->scene.Remove(id);
    return found;
  };
  const auto expected = trace(rtg::Structure::Boxes);
  EXPECT_GT(std::count(expected.begin(), expected.end(), Image::noGlyph), 2000);
  EXPECT_EQ(trace(rtg::Structure::Tree), expected);
}

TEST_P(StructureTest, NearestAcrossSetsWins)
{
  // Two interleaved sets: what the second set's program rejects must not disturb the first's hit.
  const auto points = RandomPoints(400);
  std::vector<glm::vec3> even, odd;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    (i % 2 ? odd : even).push_back(points[i]);
  }
  const auto whole = this->AddSpheres(points, 0.2f);
  Image image = this->Trace();
  std::vector<std::uint32_t> expected(10000);
  for (std::size_t i = 0; i < 10000; ++i)
  {
    expected[i] =
      image.glyphIds[i] == Image::noGlyph ? Image::noGlyph : this->scene.OriginalGlyph(whole, image.glyphIds[i]);
  }
  this->scene.Remove(whole);
  const auto evenId = this->AddSpheres(even, 0.2f);
  const auto oddId = this->AddSpheres(odd, 0.2f);
  image = this->Trace();
  for (std::size_t i = 0; i < 10000; ++i)
  {
    std::uint32_t glyph = image.glyphIds[i];
    if (glyph != Image::noGlyph)
    {
      glyph = 2 * this->scene.OriginalGlyph(image.setIds[i], glyph) + (image.setIds[i] == oddId ? 1 : 0);
      ASSERT_TRUE(image.setIds[i] == evenId || image.setIds[i] == oddId);
    }
    ASSERT_EQ(glyph, expected[i]) << i;
  }
}

// Heads that keep their size take it from each arrow where there is no length of a unit arrow, in whichever array it
// is.
TEST_P(StructureTest, ArrowsOfOneSizeAreThoseOfThreeEqualOnes)
{
  std::vector<double> covered;
  for (int kind = 0; kind < 3; ++kind)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Arrow;
    instances.centers = { glm::vec3(-0.5f, 0.0f, 0.0f) };
    instances.arrow.unitLength = 0.0f;
    instances.arrow.fixedHeads = true;
    instances.uniformSize = kind == 0 ? 0.8f : 0.1f;
    instances.sizes1.assign(kind == 1 ? 1 : 0, 0.8f);
    instances.sizes3.assign(kind == 2 ? 1 : 0, glm::vec3(0.8f));
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, instances);
    covered.push_back(Coverage(this->Trace()));
    this->scene.Remove(id);
  }
  EXPECT_GT(covered[2], 0.005);
  EXPECT_EQ(covered[0], covered[2]);
  EXPECT_EQ(covered[1], covered[2]);
}

TEST_P(StructureTest, EmptyThingsAreFine)
{
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  const auto id = this->AddSpheres({}, 1.0f);
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->scene.InstancesOf(id).Count(), 0u);
  this->settings.width = 0;
  EXPECT_EQ(this->Trace().color, nullptr);
  this->settings.keepSums = true;
  EXPECT_EQ(this->Trace().samples, 1u);
  const Image none = this->tracer->Resume(this->scene, 2);
  EXPECT_EQ(none.color, nullptr) << "of no pixels more samples are as few";
  EXPECT_EQ(none.samples, 2u);
  this->settings.width = this->settings.height = 1;
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  EXPECT_EQ(Coverage(this->Trace()), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Structures, StructureTest, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree),
  [](const auto& info) { return ::testing::PrintToString(info.param); });
