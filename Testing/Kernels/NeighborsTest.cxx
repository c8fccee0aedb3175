// Images that several processes trace together: shares of one image, and glyphs of others that shade and are not seen.
#include "BoxMesh.h"
#include "GlyphArrays.h"
#include "GlyphBoxes.h"
#include "Neighbors.h"
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

constexpr std::uint32_t side = 100; // pixels

// Balls that touch and hide each other, in a box of half-width 1.
rtg::GlyphInstances Balls(std::size_t count)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<float> uniform(-0.85f, 0.85f);
  rtg::GlyphInstances balls;
  for (std::size_t i = 0; i < count; ++i)
  {
    balls.centers.emplace_back(uniform(random), uniform(random), uniform(random));
    balls.sizes1.push_back(0.2f + 0.1f * float(i % 3));
  }
  return balls;
}

// Those with x below zero, or the others: what one of two processes has.
rtg::GlyphInstances Half(const rtg::GlyphInstances& all, bool left)
{
  rtg::GlyphInstances half = all;
  half.centers.clear();
  half.sizes1.clear();
  for (std::size_t i = 0; i < all.Count(); ++i)
  {
    if ((all.centers[i].x < 0.0f) == left)
    {
      half.centers.push_back(all.centers[i]);
      half.sizes1.push_back(all.sizes1[i]);
    }
  }
  return half;
}

rtg::DoubleBox BoundsOf(const rtg::GlyphInstances& instances)
{
  return rtg::BoundsOf(instances, rtg::GlyphBoxes(instances));
}

class NeighborsTest : public ::testing::TestWithParam<rtg::Structure>
{
protected:
  rtg::Scene scene{ rtg::Device::Shared() };
  rtg::Tracer& tracer = rtg::testing::SharedTracer();
  rtg::TraceSettings settings;
  rtg::Camera camera = rtg::Camera::FromWorldToClip(
    glm::perspective(0.6, 1.0, 1.0, 20.0) * glm::lookAt(glm::dvec3(1.0, 2.0, 5.0), glm::dvec3(0), glm::dvec3(0, 1, 0)));

  void SetUp() override
  {
    RTG_NEEDS(this->GetParam());
    this->Prepare(this->scene);
    this->settings.width = this->settings.height = side;
    this->settings.shading = rtg::Shading::AmbientOcclusion;
    this->settings.samples = 4;
    this->settings.occlusionRays = 4;
  }

  void Prepare(rtg::Scene& prepared) const { prepared.GetState().structure = this->GetParam(); }

  static rtg::Scene::SetId Add(rtg::Scene& to, const rtg::GlyphInstances& instances, bool seen = true)
  {
    const rtg::Scene::SetId id = to.Add();
    to.SetInstances(id, instances);
    to.SetCameraVisible(id, seen);
    return id;
  }

  // The image's words, which stay when another one is traced.
  struct Kept
  {
    std::vector<std::uint32_t> colors, setIds, glyphIds;
    std::vector<float> depths;
  };
  static Kept Keep(const rtg::Image& image)
  {
    const std::size_t pixels = std::size_t(image.width) * image.height;
    return { { image.color, image.color + pixels }, { image.setIds, image.setIds + pixels },
      { image.glyphIds, image.glyphIds + pixels }, { image.depth, image.depth + pixels } };
  }
  Kept Trace(rtg::Scene& of, rtg::Pass pass = rtg::Pass::Opaque, const rtg::Interrupt& interrupt = {})
  {
    of.Commit();
    return Keep(this->tracer.Trace(of, this->camera, { rtg::Light() }, this->settings, pass, interrupt));
  }

  // As compositing between processes does it: the nearer one of each pixel.
  static std::vector<std::uint32_t> Nearer(const Kept& a, const Kept& b)
  {
    std::vector<std::uint32_t> colors;
    for (std::size_t i = 0; i < a.colors.size(); ++i)
    {
      colors.push_back(a.depths[i] <= b.depths[i] ? a.colors[i] : b.colors[i]);
    }
    return colors;
  }

  // Largest difference of a channel, of pixels wholly inside in both, its mean, and the numbers of those that differ
  // and of all.
  struct Difference
  {
    int largest = 0;
    double mean = 0.0;
    std::size_t differing = 0, pixels = 0;
  };
  static Difference Between(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b)
  {
    Difference difference;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      if (a[i] >> 24 == 255 && b[i] >> 24 == 255)
      {
        ++difference.pixels;
        const int apart = std::abs(int(a[i] & 255) - int(b[i] & 255));
        difference.largest = std::max(difference.largest, apart);
        difference.differing += apart > 0;
        difference.mean += apart;
      }
    }
    difference.mean /= double(std::max<std::size_t>(1, difference.pixels));
    return difference;
  }

  // Two processes, each with half of the glyphs, and with what the other has near it.
  std::vector<std::uint32_t> OnTwo(const rtg::GlyphInstances& left, const rtg::GlyphInstances& right, double reach)
  {
    std::vector<Kept> images;
    for (const auto& [own, other] : { std::pair(left, right), std::pair(right, left) })
    {
      rtg::Scene part(rtg::Device::Shared());
      this->Prepare(part);
      Add(part, own);
      if (reach > 0.0)
      {
        const std::vector<char> bytes = rtg::PackNear(other, {}, rtg::GlyphBoxes(other), BoundsOf(own).Widened(reach));
        rtg::GlyphInstances near;
        rtg::GlyphColors colors;
        rtg::Unpack(bytes, near, colors);
        Add(part, near, /*seen=*/false);
      }
      images.push_back(this->Trace(part));
    }
    return Nearer(images[0], images[1]);
  }
};

TEST_P(NeighborsTest, SharesMakeUpTheImage)
{
  Add(this->scene, Balls(60));
  constexpr std::uint32_t shares = 3;
  const Kept whole = this->Trace(this->scene);
  const auto covered = whole.colors.size() - std::count(whole.colors.begin(), whole.colors.end(), 0u);
  this->settings.parts = shares;
  std::vector<int> found(side * side, 0);
  std::size_t wrong = 0;
  for (std::uint32_t share = 0; share < shares; ++share)
  {
    this->settings.part = share;
    // At once, or in parts as a window requests it.
    const Kept part = this->Trace(
      this->scene, rtg::Pass::Opaque, share == 0 ? rtg::Interrupt() : [](double) { return false; });
    std::size_t own = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const bool shown = part.glyphIds[i] != rtg::Image::noGlyph || part.colors[i] != 0u;
      found[i] += shown;
      own += shown;
      wrong += shown &&
        (part.colors[i] != whole.colors[i] || part.depths[i] != whole.depths[i] ||
          part.glyphIds[i] != whole.glyphIds[i] || part.setIds[i] != whole.setIds[i]);
    }
    const double fair = double(covered) / shares;
    EXPECT_NEAR(double(own), fair, 0.4 * fair) << "share " << share;
  }
  EXPECT_EQ(wrong, 0u);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    missing += found[i] != (whole.glyphIds[i] != rtg::Image::noGlyph || whole.colors[i] != 0u);
  }
  EXPECT_EQ(missing, 0u);
}

TEST_P(NeighborsTest, ShareOfSamplesThatAreAdded)
{
  Add(this->scene, Balls(60));
  this->settings.part = 1;
  this->settings.parts = 2;
  const Kept atOnce = this->Trace(this->scene);
  this->settings.plannedSamples = this->settings.samples;
  this->settings.samples = 1;
  this->settings.keepSums = true;
  Kept added = this->Trace(this->scene);
  for (std::uint32_t samples = 2; samples <= 4; ++samples)
  {
    added = Keep(this->tracer.Resume(this->scene, samples));
  }
  EXPECT_EQ(added.colors, atOnce.colors);
}

TEST_P(NeighborsTest, UnseenGlyphsShadeOnly)
{
  // Among white balls on a white floor all light would come back.
  rtg::Material dark;
  dark.color = glm::vec3(0.1f);
  this->scene.SetMaterial(Add(this->scene, Balls(60), /*seen=*/false), dark);
  const Kept alone = this->Trace(this->scene);
  EXPECT_TRUE(std::all_of(alone.colors.begin(), alone.colors.end(), [](std::uint32_t c) { return c == 0u; }));

  // A ball, too: one program for both scenes.
  rtg::GlyphInstances floor;
  floor.centers = { glm::vec3(0.0f, -11.1f, 0.0f) };
  floor.sizes1 = { 20.0f };
  const rtg::Scene::SetId seen = Add(this->scene, floor);
  for (const rtg::Shading shading : { rtg::Shading::AmbientOcclusion, rtg::Shading::PathTracing })
  {
    this->settings.shading = shading;
    const Kept shaded = this->Trace(this->scene);
    rtg::Scene bare(rtg::Device::Shared());
    this->Prepare(bare);
    Add(bare, floor);
    const Kept light = this->Trace(bare);
    double darker = 0.0;
    for (std::size_t i = 0; i < shaded.colors.size(); ++i)
    {
      EXPECT_TRUE(shaded.setIds[i] == seen || shaded.setIds[i] == rtg::Image::noGlyph);
      darker += double(light.colors[i] & 255) - double(shaded.colors[i] & 255);
    }
    // Where the scene begins rays are moved to, so they differ in their last bits.
    for (std::size_t i = 0; i < shaded.depths.size(); ++i)
    {
      ASSERT_NEAR(shaded.depths[i], light.depths[i], 1e-6f);
    }
    EXPECT_GT(darker / double(shaded.colors.size()), 2.0);
  }
}

TEST_P(NeighborsTest, UnseenTranslucentGlyphsAreNoLayers)
{
  rtg::Material half;
  half.opacity = 0.5f;
  this->scene.SetMaterial(Add(this->scene, Balls(60), /*seen=*/false), half);
  const rtg::Scene::SetId seen = Add(this->scene, Balls(5));
  this->scene.SetMaterial(seen, half);
  this->settings.shading = rtg::Shading::Local;
  const Kept both = this->Trace(this->scene, rtg::Pass::Translucent);
  rtg::Scene bare(rtg::Device::Shared());
  this->Prepare(bare);
  bare.SetMaterial(Add(bare, Balls(5)), half);
  EXPECT_EQ(both.colors, this->Trace(bare, rtg::Pass::Translucent).colors);
}

TEST_P(NeighborsTest, OcclusionIsThatOfOneProcess)
{
  const rtg::GlyphInstances all = Balls(150);
  const rtg::GlyphInstances left = Half(all, true), right = Half(all, false);
  // With one sample no pixel is a mixture of glyphs of both.
  this->settings.samples = 1;
  this->settings.occlusionRays = 16;
  this->settings.occlusionRadius = 0.4f;
  Add(this->scene, all);
  const Kept whole = this->Trace(this->scene);
  const Difference near = Between(whole.colors, this->OnTwo(left, right, this->settings.occlusionRadius));
  const Difference none = Between(whole.colors, this->OnTwo(left, right, 0.0));
  EXPECT_GT(near.pixels, side * side / 3);
  // Rays start from places that differ in their last bits.
  EXPECT_LT(near.mean, 0.01);
  EXPECT_GT(none.mean, 1.0);
  // A wider reach brings more glyphs and changes nothing.
  EXPECT_LT(Between(whole.colors, this->OnTwo(left, right, 10.0)).mean, 0.01);
}

TEST_P(NeighborsTest, OcclusionOfSurfacesIsThatOfOneProcess)
{
  // A cup of two halves, and a ball in it.
  const auto wall = [](float x)
  {
    rtg::GlyphInstances surface;
    surface.shape = rtg::Shape::Mesh;
    surface.identifyTriangles = true;
    surface.centers = { glm::vec3(0.0f) };
    rtg::TriangleMesh mesh = rtg::testing::BoxMesh(glm::vec3(x, -0.2f, 0.0f));
    for (glm::vec3& position : mesh.positions)
    {
      position *= glm::vec3(1.0f, 0.4f, 2.0f);
    }
    surface.mesh = rtg::testing::Share(std::move(mesh));
    return surface;
  };
  rtg::GlyphInstances ball;
  ball.centers = { glm::vec3(0.0f, 0.3f, 0.0f) };
  ball.uniformSize = 0.6f;
  this->settings.occlusionRadius = 0.5f;
  Add(this->scene, wall(-0.5f));
  Add(this->scene, wall(0.5f));
  Add(this->scene, ball);
  const Kept whole = this->Trace(this->scene);

  const auto onTwo = [&](double reach)
  {
    std::vector<Kept> images;
    for (const bool first : { true, false })
    {
      const rtg::GlyphInstances own[] = { wall(first ? -0.5f : 0.5f), ball };
      rtg::Scene part(rtg::Device::Shared());
      this->Prepare(part);
      Add(part, own[0]);
      rtg::DoubleBox bounds = BoundsOf(own[0]);
      if (first)
      {
        Add(part, ball);
        bounds.Include(BoundsOf(ball));
      }
      const rtg::GlyphInstances others[] = { wall(first ? 0.5f : -0.5f), ball };
      for (int i = 0; i < (first ? 1 : 2) && reach > 0.0; ++i)
      {
        rtg::GlyphInstances near;
        rtg::GlyphColors colors;
        const std::vector<char> bytes = rtg::PackNear(others[i], {}, rtg::GlyphBoxes(others[i]), bounds.Widened(reach));
        ASSERT_FALSE(bytes.empty());
        rtg::Unpack(bytes, near, colors);
        Add(part, near, /*seen=*/false);
      }
      images.push_back(this->Trace(part));
    }
    const Difference difference = Between(whole.colors, Nearer(images[0], images[1]));
    EXPECT_GT(difference.pixels, side * side / 5);
    if (reach > 0.0)
    {
      // Where an edge of one process lies before something of the other the nearer one's samples are the whole pixel.
      EXPECT_LE(difference.differing, 5u);
    }
    else
    {
      EXPECT_GT(difference.mean, 0.5);
    }
  };
  onTwo(this->settings.occlusionRadius);
  onTwo(0.0);
}

INSTANTIATE_TEST_SUITE_P(Structures, NeighborsTest, ::testing::Values(rtg::Structure::Tree, rtg::Structure::Boxes),
  [](const auto& info) { return info.param == rtg::Structure::Boxes ? "Boxes" : "Tree"; });

// Every array of the glyphs that are near, and nothing of the others.
TEST(NearGlyphs, ArriveAsTheyWere)
{
  rtg::GlyphInstances sent;
  sent.shape = rtg::Shape::Superquadric;
  sent.origin = glm::dvec3(1e6, -2e6, 3e6);
  sent.uniformSize = 0.5f;
  sent.arrow.tipRadius = 0.25f;
  sent.motion.shutterOpen = -0.125f;
  sent.motion.shutterClose = 0.25f;
  constexpr std::size_t count = 10;
  rtg::GlyphColors colors;
  float value = 1.0f;
  const auto fill = [&](auto& values)
  {
    for (auto& v : values)
    {
      v = std::decay_t<decltype(v)>(value += 0.25f);
    }
  };
  rtg::ForEachArray(sent, colors,
    [&](std::size_t, std::uint32_t, auto& values, const char*)
    {
      if constexpr (std::is_same_v<std::decay_t<decltype(values)>, rtg::GlyphTuples>)
      {
        values.width = 6;
        values.values.resize(values.width * count);
        fill(values.values);
      }
      else
      {
        values.resize(count);
        fill(values);
      }
    });
  sent.sizes1.clear();
  sent.centersLow.clear();
  std::fill(sent.sizes3.begin(), sent.sizes3.end(), glm::vec3(1.0f));
  std::fill(sent.exponents3.begin(), sent.exponents3.end(), glm::vec3(2.0f));
  std::fill(sent.rotations.begin(), sent.rotations.end(), glm::vec4(0, 0, 0, 1));
  std::fill(sent.motion.velocities.begin(), sent.motion.velocities.end(), glm::vec3(0.0f));
  std::fill(sent.motion.accelerations.begin(), sent.motion.accelerations.end(), glm::vec3(0.0f));
  std::fill(sent.motion.angularVelocities.begin(), sent.motion.angularVelocities.end(), glm::vec3(0.0f));
  for (std::size_t i = 0; i < count; ++i)
  {
    sent.centers[i] = glm::vec3(float(i), 0.0f, 0.0f);
  }
  // Glyph 4 moves a long way into the region.
  sent.motion.velocities[4] = glm::vec3(8.0f, 0.0f, 0.0f);

  const rtg::DoubleBox region{ sent.origin + glm::dvec3(5.4, -1, -1), sent.origin + glm::dvec3(7.6, 1, 1) };
  const std::vector<char> bytes = rtg::PackNear(sent, colors, rtg::GlyphBoxes(sent), region);
  rtg::GlyphInstances near;
  rtg::GlyphColors nearColors;
  rtg::Unpack(bytes, near, nearColors);
  const std::vector<std::size_t> expected{ 4, 5, 6, 7, 8 };
  ASSERT_EQ(near.Count(), expected.size());
  EXPECT_EQ(near.shape, sent.shape);
  EXPECT_EQ(near.origin, sent.origin);
  EXPECT_EQ(near.uniformSize, sent.uniformSize);
  EXPECT_EQ(near.arrow, sent.arrow);
  EXPECT_EQ(near.motion.shutterOpen, sent.motion.shutterOpen);
  EXPECT_EQ(near.motion.shutterClose, sent.motion.shutterClose);
  std::size_t arrays = 0;
  rtg::ForEachArray(sent, colors,
    [&](std::size_t number, std::uint32_t, const auto& values, const char* words)
    {
      rtg::ForEachArray(near, nearColors,
        [&](std::size_t other, std::uint32_t, const auto& arrived, const char*)
        {
          if constexpr (std::is_same_v<decltype(values), decltype(arrived)>)
          {
            if (other == number && !values.empty())
            {
              ++arrays;
              ASSERT_EQ(arrived.size(), expected.size()) << words;
              for (std::size_t i = 0; i < expected.size(); ++i)
              {
                if constexpr (std::is_same_v<std::decay_t<decltype(values)>, rtg::GlyphTuples>)
                {
                  ASSERT_EQ(arrived.width, values.width);
                  EXPECT_TRUE(std::equal(arrived[i], arrived[i] + arrived.width, values[expected[i]])) << words;
                }
                else
                {
                  EXPECT_EQ(arrived[i], values[expected[i]]) << words;
                }
              }
            }
            else if (other == number)
            {
              EXPECT_TRUE(arrived.empty()) << words;
            }
          }
        });
    });
  EXPECT_EQ(arrays, rtg::glyphArrays - 2);

  const rtg::DoubleBox elsewhere{ sent.origin + glm::dvec3(0, 2, 2), sent.origin + glm::dvec3(9, 3, 3) };
  EXPECT_TRUE(rtg::PackNear(sent, colors, rtg::GlyphBoxes(sent), elsewhere).empty());
  EXPECT_THROW(rtg::Unpack({ bytes.begin(), bytes.end() - 5 }, near, nearColors), rtg::Error);
}

// Of a surface the triangles that are near, with the values of their corners.
TEST(NearGlyphs, OfSurfacesAreTriangles)
{
  rtg::TriangleMesh strip;
  for (int i = 0; i < 20; ++i)
  {
    strip.positions.emplace_back(float(i / 2), float(i % 2), 0.0f);
    strip.normals.emplace_back(0.0f, 0.0f, 1.0f);
    strip.positionValues.push_back(float(i) / 20.0f);
    strip.motion.velocities.emplace_back(i == 19 ? -8.0f : 0.0f, 0.0f, 0.0f); // the last corner moves far
    if (i >= 2)
    {
      strip.triangles.emplace_back(i - 2, i - 1, i);
      strip.triangleColors.push_back(static_cast<std::uint32_t>(i));
    }
  }
  strip.valueColors = { 1u, 2u, 3u };
  rtg::GlyphInstances surface;
  surface.shape = rtg::Shape::Mesh;
  surface.identifyTriangles = true;
  surface.centers = { glm::vec3(0.0f) };
  surface.motion.shutterOpen = 0.0f;
  surface.motion.shutterClose = 0.5f;
  surface.mesh = rtg::testing::Share(strip);
  rtg::GlyphInstances near;
  rtg::GlyphColors colors;
  rtg::Unpack(rtg::PackNear(surface, {}, rtg::GlyphBoxes(surface), { { 5.2, 0, -1 }, { 5.8, 1, 1 } }), near, colors);
  ASSERT_TRUE(near.mesh);
  EXPECT_TRUE(near.identifyTriangles);
  // Between corners 5 and 6 along x lie two triangles; the one that moves is the last.
  ASSERT_EQ(near.mesh->triangleColors, (std::vector<std::uint32_t>{ 12u, 13u, 19u }));
  ASSERT_EQ(near.mesh->triangles.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::uvec3 from = strip.triangles[near.mesh->triangleColors[i] - 2u];
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t arrived = near.mesh->triangles[i][corner];
      EXPECT_EQ(near.mesh->positions[arrived], strip.positions[from[corner]]);
      EXPECT_EQ(near.mesh->normals[arrived], strip.normals[from[corner]]);
      EXPECT_EQ(near.mesh->positionValues[arrived], strip.positionValues[from[corner]]);
      EXPECT_EQ(near.mesh->motion.velocities[arrived], strip.motion.velocities[from[corner]]);
    }
  }
  EXPECT_EQ(near.mesh->positions.size(), 7u);
  EXPECT_EQ(near.mesh->valueColors, strip.valueColors);
}

} // namespace
