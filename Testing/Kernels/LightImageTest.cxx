// What becomes of light: exposure, features, denoising; and settings that it cannot be traced with.
#include "Denoiser.h"
#include "LightFixture.h"
#include "Shading/Shading.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <functional>
#include <numeric>

using namespace light;

TEST_F(LightTest, BadSettingsAreNamed)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  const auto fails = [this](const char* name, auto change)
  {
    const rtg::TraceSettings before = this->settings;
    change(this->settings);
    try
    {
      this->Trace();
      ADD_FAILURE() << name;
    }
    catch (const rtg::Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    this->settings = before;
  };
  fails("radius", [](auto& s) { s.occlusionRadius = -1.0f; });
  fails("radius", [](auto& s) { s.occlusionRadius = NAN; });
  fails("occlusion rays", [](auto& s) { s.occlusionRays = 0; });
  fails("occlusion rays", [](auto& s) { s.occlusionRays = 65; });
  fails("paths", [](auto& s) { s.paths = 0; });
  fails("paths", [](auto& s) { s.paths = 65; });
  fails("bounces", [](auto& s) { s.maximumBounces = 0; });
  fails("slope of the sky", [](auto& s) { s.skySlope = glm::vec3(1.0f); });
  fails("fraction", [](auto& s) { s.lightFraction = 1.5f; });
  fails("albedo", [](auto& s) { s.albedoLimit = 0.0f; });
  fails("intensity", [](auto& s) { s.lightIntensity = -0.5f; });
  fails("exposure", [](auto& s) { s.exposure = INFINITY; });
}

TEST_F(LightTest, ExposureAndToneMappingDevelopTheImage)
{
  rtg::Material material;
  material.lighting = false;
  material.color = glm::vec3(0.5f);
  this->Add(Shape::Box, { { 0, 0, 0 } }, { { 10, 10, 1 } }, material);
  const auto shown = [this] { return static_cast<int>(this->Trace().color[0] & 255u); };
  for (Shading shading : { Shading::Local, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->settings.exposure = 0.0f;
    this->settings.toneMapping = rtg::ToneMapping::None;
    EXPECT_NEAR(shown(), 128, 1);
    // 0.5 is 0.2140 in linear light; one stop doubles it.
    this->settings.exposure = 1.0f;
    EXPECT_NEAR(shown(), 255.0 * (1.055 * std::pow(0.42808, 1.0 / 2.4) - 0.055), 1.0);
    this->settings.exposure = 10.0f;
    EXPECT_EQ(shown(), 255);
    this->settings.exposure = 0.0f;
    this->settings.toneMapping = rtg::ToneMapping::Filmic;
    const double x = 0.21404;
    const double filmic = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    EXPECT_NEAR(shown(), 255.0 * (1.055 * std::pow(filmic, 1.0 / 2.4) - 0.055), 1.0);
    // Neutral leaves it, and brings what is twice as bright as white to 1 - 0.01 / 1.2.
    this->settings.toneMapping = rtg::ToneMapping::Neutral;
    EXPECT_NEAR(shown(), 128, 1);
    this->settings.exposure = static_cast<float>(std::log2(2.0 / x));
    EXPECT_NEAR(shown(), 255.0 * (1.055 * std::pow(1.0 - 0.01 / 1.2, 1.0 / 2.4) - 0.055), 1.0);
  }
}

TEST_F(LightTest, FeaturesSayWhatTheEyeMet)
{
  rtg::Material material;
  material.color = { 0.25f, 0.5f, 0.75f };
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.8f) }, material);
  this->settings.features = true;
  this->Trace();
  const rtg::ImageFeatures features = this->tracer.Features();
  const std::size_t middle = 12 * 24 + 12;
  EXPECT_EQ(features.width * features.height, 24u * 24u);
  EXPECT_GT(features.normals[middle].z, 0.99f);
  EXPECT_EQ(features.albedos[middle], material.color);
  EXPECT_NEAR(features.viewDepths[middle], 5.0 - 0.9, 2e-3 + 0.01);
  EXPECT_EQ(features.normals[0], glm::vec3(0.0f));
  this->settings.features = false;
  this->Trace();
  EXPECT_THROW(this->tracer.Features(), rtg::Error);
}

TEST_F(LightTest, DenoisingBringsAnImageCloserToTheTruth)
{
  // A sphere on a floor, darkened where they meet.
  this->camera = LookFrom({ 0, -5, 4 }, { 0, 0, 0.3 }, 1.5);
  const auto ball = this->Add(Shape::Sphere, { { 0, 0, 0.5 } }, { glm::vec3(1.0f) }, White());
  const auto floor = this->Add(Shape::Box, { { 0, 0, -0.5 } }, { { 20, 20, 1 } }, White());
  rtg::Material gray;
  gray.color = glm::vec3(0.7f);
  this->settings.width = this->settings.height = 48;
  for (Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    if (shading == Shading::PathTracing)
    {
      this->scene.SetMaterial(ball, gray);
      this->scene.SetMaterial(floor, gray);
    }
    this->settings.shading = shading;
    this->settings.features = false;
    this->settings.independentSamples = false;
    this->settings.samples = 512;
    this->Trace();
    const std::vector<glm::vec4> truth = this->tracer.Means();
    // Display colors of the truth and of few samples, with noise and without.
    const auto error = [&](const Image& image)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < truth.size(); ++i)
      {
        glm::vec3 wanted = glm::vec3(truth[i]) / std::max(truth[i].a, 1e-6f);
        wanted = rtg::shading::LinearToDisplay(glm::clamp(wanted, 0.0f, 1.0f));
        const glm::vec3 apart = glm::vec3(glm::unpackUnorm4x8(image.color[i])) - wanted;
        sum += glm::dot(apart, apart);
      }
      return sum / (3.0 * truth.size());
    };
    this->settings.features = true;
    this->settings.samples = 4;
    Image image = this->Trace();
    const double noisy = error(image);
    const std::vector<std::uint32_t> alphas(image.color, image.color + truth.size());
    const std::vector<std::uint32_t> denoised = this->tracer.Denoise()();
    image.color = denoised.data();
    const double smooth = error(image);
    std::printf("squared error of 4 samples %.2e, denoised %.2e\n", noisy, smooth);
    // What is left is edges: few samples do not smooth these.
    EXPECT_LT(smooth, 0.5 * noisy);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      ASSERT_EQ(image.color[i] >> 24, alphas[i] >> 24);
    }
  }
}

// One pixel that is no number leaves the others theirs.
// A sphere over the ground, whose shadow is opacity.
TEST_F(LightTest, DenoisingSmoothsShadowsOnTheGround)
{
  this->camera = LookFrom({ 0, -5, 4 }, { 0, 0, 0.3 }, 1.5);
  this->Add(Shape::Sphere, { { 0, 0, 0.5 } }, { glm::vec3(1.0f) }, White());
  this->settings.groundNormal = { 0, 0, 1 };
  this->settings.groundHeight = 0.0;
  this->settings.width = this->settings.height = 48;
  this->settings.features = true;
  this->settings.independentSamples = false;
  const auto opacities = [](const std::uint32_t* colors)
  {
    std::vector<double> found(48 * 48);
    std::transform(colors, colors + found.size(), found.begin(), [](std::uint32_t c) { return (c >> 24) / 255.0; });
    return found;
  };
  for (Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->settings.samples = 512;
    const std::vector<double> truth = opacities(this->Trace().color);
    const auto error = [&](const std::vector<double>& found)
    {
      return std::inner_product(truth.begin(), truth.end(), found.begin(), 0.0, std::plus<>(),
        [](double a, double b) { return (a - b) * (a - b); });
    };
    this->settings.samples = 4;
    const Image image = this->Trace();
    const double noisy = error(opacities(image.color));
    const double smooth = error(opacities(this->tracer.Denoise()().data()));
    std::printf("squared error of the opacity: 4 samples %.2e, denoised %.2e\n", noisy, smooth);
    EXPECT_LT(smooth, 0.5 * noisy);
  }
}

TEST(Denoising, SpreadsNoNaN)
{
  constexpr std::size_t pixels = 40 * 40;
  std::vector<glm::vec4> means(pixels, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
  means[20 * 40 + 20] = glm::vec4(NAN, NAN, NAN, 1.0f);
  const std::vector<glm::vec3> normals(pixels, glm::vec3(0, 0, 1)), albedos(pixels, glm::vec3(0.8f));
  const std::vector<float> depths(pixels, 1.0f);
  rtg::Denoise(means, { 40, 40, normals, albedos, depths });
  for (std::size_t i = 0; i < pixels; ++i)
  {
    EXPECT_TRUE(i == 20 * 40 + 20 || std::abs(means[i].r - 0.5f) < 1e-4f) << i;
  }
}

// Pixels' middles, which the first samples go through, see the points of cones and sharp arrows, and the ends of round
// ones.
TEST_F(LightTest, ApexesHaveNormals)
{
  this->settings.width = this->settings.height = 64;
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 1;
  const auto floor = this->Add(Shape::Box, { { 0, 0, -1 } }, { { 4.0f, 4.0f, 0.1f } }, White());
  for (const Shape shape : { Shape::Cone, Shape::Arrow, Shape::RoundCone })
  {
    for (const float side : { 1.0f, -1.0f })
    {
      rtg::GlyphInstances instances;
      instances.shape = shape;
      instances.arrow.tipRounding = 0.0f;
      instances.arrow.unitLength = 0.5f;
      for (int i = 0; i < 49; ++i)
      {
        instances.centers.push_back(0.25f * glm::vec3(i / 7 - 3, i % 7 - 3, 0) + glm::vec3(0.015625f, 0.015625f, 0.0f));
        instances.sizes3.emplace_back(shape == Shape::RoundCone ? glm::vec3(0.125f, 0.1875f, 0.0f) : glm::vec3(0.125f));
        instances.rotations.emplace_back(side > 0.0f ? glm::vec4(0, 0, 0, 1) : glm::vec4(0, 0, 1, 0));
      }
      const auto id = this->scene.Add();
      this->scene.SetInstances(id, instances);
      this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) *
        glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
      this->Trace(rtg::Pass::All);
      for (const glm::vec4& mean : this->tracer.Means())
      {
        ASSERT_TRUE(std::isfinite(mean.r)) << "shape " << static_cast<int>(shape) << ", side " << side;
      }
      this->scene.Remove(id);
    }
  }
  this->scene.Remove(floor);
}

TEST_F(LightTest, DenoisingNeedsWhatItIsGuidedBy)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->Trace();
  EXPECT_THROW(this->tracer.Denoise(), rtg::Error);
}

TEST_F(LightTest, DenoisingCanBeStopped)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.features = this->settings.keepSums = true;
  this->Trace();
  std::stop_source stop;
  EXPECT_NO_THROW(this->tracer.Denoise(stop.get_token())());
  stop.request_stop();
  EXPECT_THROW(this->tracer.Denoise(stop.get_token())(), rtg::Error);
}
