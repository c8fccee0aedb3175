// How the samples of ambient occlusion and path tracing are spread, ended and added up.
#include "LightFixture.h"
#include "SceneState.h"

#include <algorithm>
#include <random>

using namespace light;

// Where occluders are large in view, scrambled nets err less than independent samples, each pixel on its own.
TEST_F(LightTest, NetsErrLessThanIndependentSamples)
{
  this->LookUnderALid(White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 256;
  this->Trace();
  const double independent = this->ErrorOf(0.5).square;
  // p (1 - p) / n; the mean square of 576 pixels varies by sqrt(2 / 576) of itself.
  EXPECT_NEAR(independent, 0.25 / 256, certain * std::sqrt(2.0 / 576) * 0.25 / 256);
  this->settings.independentSamples = false;
  this->Trace();
  EXPECT_LT(this->ErrorOf(0.5).square, 0.5 * independent);
}

// Several occlusion rays a sample: the same mean, to which each ray adds its part, and those of one sample and of all
// together are nets.
TEST_F(LightTest, SeveralOcclusionRaysASample)
{
  this->LookUnderALid(White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.occlusionRays = 64;
  const auto errors = [this](bool independent, std::uint32_t samples)
  {
    this->settings.independentSamples = independent;
    this->settings.samples = samples;
    this->Trace();
    return this->ErrorOf(0.5);
  };
  const double pixels = static_cast<double>(this->settings.width * this->settings.height);
  for (const std::uint32_t samples : { 1u, 4u })
  {
    const double variance = 0.25 / (64.0 * samples); // of independent rays
    const Error independent = errors(true, samples);
    EXPECT_NEAR(independent.mean, 0.0, certain * std::sqrt(variance / pixels));
    EXPECT_NEAR(independent.square, variance, certain * std::sqrt(2.0 / pixels) * variance);
    const Error spread = errors(false, samples);
    EXPECT_NEAR(spread.mean, 0.0, certain * std::sqrt(variance / pixels));
    EXPECT_LT(spread.square, 0.5 * variance);
  }
}

// Several paths a sample: those of one sample and of all together are nets, too. One scattering on a matt floor under
// the same lid: half of the light, but for the shape of the diffuse lobe.
TEST_F(LightTest, SeveralPathsASample)
{
  this->LookUnderALid(White());
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 1;
  this->settings.paths = 64;
  for (const std::uint32_t samples : { 1u, 4u })
  {
    this->settings.samples = samples;
    const double independentVariance = 0.25 / (64.0 * samples);
    for (const bool independent : { true, false })
    {
      this->settings.independentSamples = independent;
      this->Trace();
      const Error error = this->ErrorOf(0.5);
      EXPECT_NEAR(error.mean, 0.0, 0.05) << independent;
      const double variance = error.square - error.mean * error.mean;
      EXPECT_LT(variance, (independent ? 1.2 : 0.5) * independentVariance);
      EXPECT_TRUE(!independent || variance > 0.8 * independentVariance) << variance;
    }
  }
}

// A thing that covers a quarter of each pixel is hit by exactly a quarter of the samples: their places are a net,
// although the first of them is the pixel's center.
TEST_F(LightTest, PlacesInAPixelAreANet)
{
  std::vector<glm::vec3> centers;
  for (int column = 0; column < 24; ++column)
  {
    centers.emplace_back(-1.0f + (column + 0.125f) / 12.0f, 0.0f, 0.0f);
  }
  this->Add(Shape::Box, centers, std::vector<glm::vec3>(24, glm::vec3(0.25f / 12.0f, 10.0f, 0.1f)), White());
  this->settings.independentSamples = false;
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.occlusionRadius = 1e-6f;
  for (std::uint32_t samples : { 4, 16, 64 })
  {
    this->settings.samples = samples;
    const Image image = this->Trace();
    for (const glm::vec4& mean : this->tracer.Means())
    {
      ASSERT_EQ(mean.a, 0.25f) << samples;
    }
    // That of the nearest sample, none of which is the center.
    EXPECT_LT(image.depth[0], 1.0f);
  }
}

// Russian roulette, with guesses where light comes from all around alone and without, and several paths a sample: the
// same mean.
TEST_F(LightTest, RouletteAndPathsChangeNoMean)
{
  rtg::Material shining;
  shining.color = glm::vec3(0.6f, 0.75f, 0.9f);
  shining.ambientColor = glm::vec3(0.5f, 0.3f, 0.1f);
  shining.ambient = 0.2f;
  shining.specular = 0.5f;
  shining.roughness = 0.4f;
  std::vector<glm::vec3> centers;
  for (int i = 0; i < 27; ++i)
  {
    centers.emplace_back(0.5f * (i % 3 - 1), 0.5f * (i / 3 % 3 - 1), 0.5f * (i / 9 - 1));
  }
  this->Add(Shape::Sphere, centers, std::vector<glm::vec3>(27, glm::vec3(0.55f)), shining);
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 128;
  rtg::Light sun, none;
  sun.kind = rtg::Light::Kind::Directional;
  sun.direction = glm::normalize(glm::vec3(0.3f, -0.5f, -1.0f));
  none.color = glm::vec3(0.0f); // changes nothing, but where there is a light roulette guesses nothing
  struct Settings
  {
    std::vector<rtg::Light> lights;
    std::uint32_t bounces, paths;
  };
  const auto trace = [this](const Settings& chosen)
  {
    this->lights = chosen.lights;
    this->settings.maximumBounces = chosen.bounces;
    this->settings.paths = chosen.paths;
    this->Trace();
    return this->tracer.Means();
  };
  const auto expectSame = [&](const Settings& reference, const std::vector<Settings>& others)
  {
    const std::vector<glm::vec4> expected = trace(reference);
    for (const Settings& other : others)
    {
      const std::vector<glm::vec4> means = trace(other);
      for (int channel = 0; channel < 3; ++channel)
      {
        // Pixel by pixel, so that only noise is left; mean and deviation of the difference.
        double sum = 0.0, squares = 0.0;
        const double count = static_cast<double>(means.size());
        for (std::size_t i = 0; i < means.size(); ++i)
        {
          const double difference = means[i][channel] - expected[i][channel];
          sum += difference;
          squares += difference * difference;
        }
        EXPECT_GT(squares, 0.0);
        EXPECT_NEAR(sum / count, 0.0, certain * std::sqrt(squares) / count)
          << other.lights.size() << ' ' << other.bounces << ' ' << other.paths << ' ' << channel;
        EXPECT_LT(certain * std::sqrt(squares) / count, 0.01);
      }
    }
  };
  // Without guesses no roulette is played before the third hit, that is none with two scatterings.
  expectSame({ { none }, 2, 1 }, { { {}, 2, 1 }, { { none }, 2, 4 }, { {}, 2, 5 } });
  expectSame({ {}, 10, 1 }, { { { none }, 10, 1 }, { {}, 10, 5 } });
  expectSame({ { sun }, 10, 1 }, { { { sun }, 10, 5 } });
}

class Steps
  : public LightTest
  , public ::testing::WithParamInterface<Shading>
{
};

// However the samples are shared out among calls: the same image to the bit.
TEST_P(Steps, AccumulateToTheSameImage)
{
  const std::vector<glm::vec3> centers = Clutter(6, 50);
  rtg::Material material;
  material.color = { 0.9f, 0.5f, 0.3f };
  material.specular = 0.4f;
  this->Add(Shape::Sphere, centers, std::vector<glm::vec3>(50, glm::vec3(0.3f)), material);
  this->lights.emplace_back();
  this->settings.shading = GetParam();
  this->settings.width = 41;
  this->settings.height = 33;
  this->settings.plannedSamples = 13;
  this->settings.occlusionRays = this->settings.paths = 3;
  this->settings.features = true;
  const std::size_t pixels = 41 * 33;
  this->settings.independentSamples = false;
  this->settings.samples = 13;
  const Image whole = this->Trace();
  const std::vector<std::uint32_t> color(whole.color, whole.color + pixels);
  const std::vector<std::uint32_t> glyphs(whole.glyphIds, whole.glyphIds + pixels);
  const std::vector<std::uint32_t> sets(whole.setIds, whole.setIds + pixels);
  const std::vector<float> depth(whole.depth, whole.depth + pixels);
  const std::vector<glm::vec4> means = this->tracer.Means();
  const rtg::ImageFeatures features = this->tracer.Features();

  // A fresh tracer too: nothing may depend on what was traced before.
  rtg::Tracer other(this->device);
  this->settings.samples = 1;
  Image image = other.Trace(this->scene, this->camera, this->lights, this->settings);
  for (std::uint32_t samples : { 5, 13 })
  {
    image = other.Resume(this->scene, samples);
    EXPECT_EQ(image.samples, samples);
  }
  EXPECT_EQ(color, std::vector<std::uint32_t>(image.color, image.color + pixels));
  EXPECT_EQ(glyphs, std::vector<std::uint32_t>(image.glyphIds, image.glyphIds + pixels));
  EXPECT_EQ(sets, std::vector<std::uint32_t>(image.setIds, image.setIds + pixels));
  EXPECT_EQ(depth, std::vector<float>(image.depth, image.depth + pixels));
  EXPECT_EQ(means, other.Means());
  EXPECT_EQ(features.normals, other.Features().normals);
  EXPECT_EQ(features.albedos, other.Features().albedos);
  EXPECT_EQ(features.viewDepths, other.Features().viewDepths);
}

static std::string NameOf(const ::testing::TestParamInfo<Shading>& info)
{
  static const char* const names[] = { "Local", "AmbientOcclusion", "PathTracing" };
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(
  Shadings, Steps, ::testing::Values(Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing), NameOf);

struct Whole
{
  const char* name;
  Shape shape;
  bool plain; ///< all alike and at rest
  Shading shading;
};

static void PrintTo(const Whole& whole, std::ostream* out)
{
  *out << whole.name;
}

class WholeScene
  : public LightTest
  , public ::testing::WithParamInterface<Whole>
{
};

// Programs of a scene of one set of glyphs have its features and address as constants. With another set, hidden
// inside one of the glyphs, they read the records of both, and the picture is the same.
TEST_P(WholeScene, LooksLikeOneOfSeveralSets)
{
  RTG_NEEDS(rtg::Structure::Tree);
  const auto [name, shape, plain, shading] = GetParam();
  this->scene.GetState().structure = rtg::Structure::Tree;
  this->settings.width = this->settings.height = 80;
  this->settings.samples = 3;
  this->settings.paths = 2;
  this->settings.shading = shading;
  this->lights.emplace_back();
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  rtg::GlyphInstances instances;
  instances.shape = shape;
  instances.origin = { 0.03, -0.01, 0.02 };
  instances.uniformSize = 0.2f;
  std::vector<std::uint32_t> colors;
  for (int i = 0; i < 300; ++i)
  {
    instances.centers.emplace_back(1.8f * uniform(random) - 0.9f, 1.8f * uniform(random) - 0.9f, uniform(random));
    if (!plain)
    {
      instances.sizes3.emplace_back(0.1f + 0.2f * uniform(random), 0.1f + 0.1f * uniform(random), 0.1f);
      instances.rotations.push_back(glm::normalize(glm::vec4(uniform(random), uniform(random), uniform(random), 1.0f)));
      instances.motion.velocities.emplace_back(0.1f, 0.05f, 0.0f);
      colors.push_back(static_cast<std::uint32_t>(random()) | 0xff000000u);
      instances.exponents3.emplace_back(1.0f + 3.0f * uniform(random), 2.0f, 1.0f + 5.0f * uniform(random));
    }
  }
  if (shape != Shape::Superquadric)
  {
    instances.exponents3.clear();
  }
  // A set that is not shown, but whose origin is the scene's: centers are not relative to that.
  rtg::GlyphInstances away;
  away.origin = { 0.7, -0.4, 0.2 };
  away.centers = { glm::vec3(0.0f) };
  const auto first = this->scene.Add();
  this->scene.SetInstances(first, away);
  this->scene.SetVisible(first, false);
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  this->scene.SetColors(id, colors);
  const Image one = this->Trace();
  const std::size_t pixels = std::size_t(one.width) * one.height;
  const std::vector<std::uint32_t> glyphs(one.glyphIds, one.glyphIds + pixels);
  const std::vector<float> depths(one.depth, one.depth + pixels);
  const std::vector<glm::vec4> means = this->tracer.Means();
  EXPECT_GT(pixels, 3 * std::size_t(std::count(glyphs.begin(), glyphs.end(), Image::noGlyph)) / 2);

  rtg::GlyphInstances hidden;
  hidden.origin = instances.origin;
  hidden.uniformSize = 1e-4f;
  hidden.centers = { instances.centers[0] };
  if (!plain)
  {
    hidden.motion.velocities = { instances.motion.velocities[0] };
  }
  this->scene.SetInstances(this->scene.Add(), hidden);
  const Image several = this->Trace();
  const std::vector<glm::vec4> others = this->tracer.Means();
  std::size_t otherGlyphs = 0, otherDepths = 0, otherColors = 0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    otherGlyphs += glyphs[i] != several.glyphIds[i];
    otherDepths += depths[i] != several.depth[i];
    otherColors += means[i] != others[i];
  }
  EXPECT_EQ(otherGlyphs, 0u);
  EXPECT_EQ(otherDepths, 0u);
  EXPECT_EQ(otherColors, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, WholeScene,
  ::testing::Values(Whole{ "SphereLocal", Shape::Sphere, true, Shading::Local },
    Whole{ "SphereOcclusion", Shape::Sphere, true, Shading::AmbientOcclusion },
    Whole{ "SpherePath", Shape::Sphere, true, Shading::PathTracing },
    Whole{ "EllipsoidPath", Shape::Sphere, false, Shading::PathTracing },
    Whole{ "BoxOcclusion", Shape::Box, false, Shading::AmbientOcclusion },
    Whole{ "CylinderLocal", Shape::Cylinder, true, Shading::Local },
    Whole{ "CapsulePath", Shape::Capsule, false, Shading::PathTracing },
    Whole{ "ConeOcclusion", Shape::Cone, true, Shading::AmbientOcclusion },
    Whole{ "ArrowOcclusion", Shape::Arrow, false, Shading::AmbientOcclusion },
    Whole{ "SuperquadricLocal", Shape::Superquadric, false, Shading::Local }),
  [](const auto& info) { return std::string(info.param.name); });

TEST_F(LightTest, SamplesAreAddedOnlyToTheirOwnImage)
{
  const auto id = this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  this->settings.samples = 4;
  this->settings.keepSums = false;
  this->Trace();
  EXPECT_THROW(this->tracer.Resume(this->scene, 5), rtg::Error); // it keeps no sums
  this->settings.keepSums = true;
  this->Trace();
  EXPECT_EQ(this->tracer.Resume(this->scene, 3).samples, 4u); // they are there
  EXPECT_EQ(this->tracer.Resume(this->scene, 8).samples, 8u);
  EXPECT_THROW(this->tracer.Resume(this->scene, 1u << 21), rtg::Error);
  this->scene.SetMaterial(id, White());
  this->scene.Commit();
  EXPECT_THROW(this->tracer.Resume(this->scene, 9), rtg::Error); // of the scene as it was
}
