// Light from environment images.
#include "LightFixture.h"
#include "Shading/Shading.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>

using namespace light;

class EnvironmentTest : public LightTest
{
protected:
  void SetUp() override
  {
    this->LightTest::SetUp();
    this->settings.shading = Shading::PathTracing;
    this->settings.maximumBounces = 1;
    this->settings.samples = 64;
  }

  // Of w x h texels, the radiance a function of column and row.
  template <class Function>
  static std::shared_ptr<rtg::EnvironmentImage> Make(std::uint32_t w, std::uint32_t h, Function radiance)
  {
    auto image = std::make_shared<rtg::EnvironmentImage>();
    image->width = w;
    image->height = h;
    for (std::uint32_t y = 0; y < h; ++y)
    {
      for (std::uint32_t x = 0; x < w; ++x)
      {
        image->radiance.emplace_back(radiance(x, y));
      }
    }
    return image;
  }

  // What a white diffuse surface shows: irradiance over pi, summed over fine pieces of the texels.
  static double Expected(const rtg::EnvironmentImage& image, const glm::dvec3& normal)
  {
    const glm::dvec3 right(image.right), up(image.up), front = glm::cross(right, up);
    const int fine = 16;
    const double w = image.width * fine, h = image.height * fine;
    double sum = 0.0;
    for (int y = 0; y < h; ++y)
    {
      const double latitude = glm::pi<double>() * ((y + 0.5) / h - 0.5);
      for (int x = 0; x < w; ++x)
      {
        const double longitude = glm::two_pi<double>() * ((x + 0.5) / w - 0.5);
        const glm::dvec3 d =
          std::cos(latitude) * (std::cos(longitude) * right + std::sin(longitude) * front) + std::sin(latitude) * up;
        const double cosine = std::max(glm::dot(d, normal), 0.0);
        sum += cosine * std::cos(latitude) * image.radiance[(y / fine) * image.width + x / fine].x;
      }
    }
    return sum * glm::two_pi<double>() / w * glm::pi<double>() / h / glm::pi<double>();
  }

  // Mean over the pixels, which all show the same flat surface.
  double Mean()
  {
    this->Trace();
    double sum = 0.0;
    const auto radiances = this->Radiances();
    EXPECT_EQ(radiances.size(), 24u * 24u);
    for (const glm::vec3& radiance : radiances)
    {
      sum += radiance.x;
    }
    return sum / double(radiances.size());
  }
};

TEST_F(EnvironmentTest, OneColorIsTheSameFromEverywhere)
{
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(4) }, White());
  this->settings.environmentImage = Make(7, 5, [](auto, auto) { return glm::vec3(0.5f); });
  this->settings.lightIntensity = 3.0f;
  // Burley's diffuse lobe varies by up to 0.07 of itself from direction to direction: independent ones would err by
  // more.
  this->settings.independentSamples = false;
  const double image = this->Mean();
  EXPECT_NEAR(image, 1.5, 1e-4);
  // The same paths, no image.
  this->settings.environmentImage = nullptr;
  this->settings.lightIntensity = 1.5f;
  EXPECT_NEAR(this->Mean(), image, 1e-5);
}

// The sun, and dim sky: each face of a box shows the light that reaches it, whichever way the image is turned.
TEST_F(EnvironmentTest, FacesShowTheIrradianceThatReachesThem)
{
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(4) }, White());
  const glm::vec3 frames[][2] = { { { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 0 }, { 0, 0, 1 } },
    { glm::normalize(glm::vec3(1, 2, 0)), glm::normalize(glm::vec3(-2, 1, 1)) } };
  for (const auto& frame : frames)
  {
    const auto image = Make(37, 18, [](auto x, auto y) { return glm::vec3(x == 30 && y == 11 ? 200.0f : 0.02f * y); });
    image->right = frame[0];
    image->up = glm::normalize(frame[1] - glm::dot(frame[1], frame[0]) * frame[0]);
    this->settings.environmentImage = image;
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double side : { -1.0, 1.0 })
      {
        glm::dvec3 normal(0.0);
        normal[axis] = side;
        this->camera = this->LookFrom(5.0 * normal);
        const double expected = Expected(*image, normal);
        // The sun's fraction varies by its own size only, the sky's is at most its brightest texel.
        const double deviation = (0.2 * expected + 0.36) / std::sqrt(24.0 * 24.0 * 64.0);
        EXPECT_NEAR(this->Mean(), expected, certain * deviation) << axis << " " << side;
        most = std::max(most, expected);
      }
    }
    EXPECT_GT(most, 1.0); // the sun is there
  }
}

// Views have one image on the device: what another tracer of the view has used meanwhile does not light the rest.
TEST_F(EnvironmentTest, AnImageThatGoesOnKeepsItsOwn)
{
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(4) }, White());
  this->scene.Commit();
  const auto resources = rtg::MakeTracerResources(this->device);
  rtg::Tracer first(resources), second(resources);
  this->settings.environmentImage = Make(7, 5, [](auto, auto) { return glm::vec3(0.5f); });
  this->settings.width = this->settings.height = 256; // long enough to be interrupted
  this->settings.samples = 64;
  const auto trace = [&](rtg::Tracer& tracer, const rtg::Interrupt& interrupt)
  { return tracer.Trace(this->scene, this->camera, {}, this->settings, rtg::Pass::All, interrupt); };
  trace(first, {});
  const std::vector<glm::vec4> whole = first.Means();
  const Image part = trace(first, [](double share) { return share > 0.0; });
  ASSERT_FALSE(part.complete);
  this->settings.environmentImage = Make(7, 5, [](auto, auto) { return glm::vec3(4.0f); });
  trace(second, {});
  ASSERT_TRUE(first.Resume(this->scene, 64).complete);
  EXPECT_EQ(first.Means(), whole);
}

// What is aimed at and what is found by scattering add up, on surfaces that shine: quarters of the sky are brighter
// than their threshold, the whole is not.
TEST_F(EnvironmentTest, AimingAndScatteringAddUp)
{
  rtg::Material plastic = White();
  plastic.specular = 1.0f;
  plastic.roughness = 0.4f;
  plastic.metallic = 0.3f;
  plastic.coatStrength = 0.5f;
  plastic.coatIor = 1.5f;
  plastic.coatRoughness = 0.5f;
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(8) }, plastic);
  this->camera = this->LookFrom({ 0, 5.5, 2.0 }, { 0, 4, 0 }, 0.5);
  this->settings.samples = 256;
  this->settings.environmentImage = Make(16, 8, [](auto, auto y) { return glm::vec3(y >= 4 ? 1.0f : 0.0f); });
  EXPECT_TRUE(rtg::MakeEnvironmentCells(*this->settings.environmentImage).cells.empty());
  const double whole = this->Mean();
  double quarters = 0.0;
  for (unsigned quarter = 0; quarter < 4; ++quarter)
  {
    this->settings.environmentImage =
      Make(16, 8, [quarter](auto x, auto y) { return glm::vec3(y >= 4 && x / 4 == quarter ? 1.0f : 0.0f); });
    EXPECT_FALSE(rtg::MakeEnvironmentCells(*this->settings.environmentImage).cells.empty());
    const double part = this->Mean();
    EXPECT_GT(part, 0.05);
    quarters += part;
  }
  // Samples lie in [0, 1], but for glossy reflections that are aimed at, whose weight may reach a few.
  EXPECT_NEAR(quarters, whole, certain * 2.0 * std::sqrt(5.0) / std::sqrt(24.0 * 24.0 * 256.0));
}

// Camera and sun see the floor through the same black roof: each of the two ways meets both of its faces, and whether a
// face stops one says nothing about the other.
TEST_F(EnvironmentTest, TranslucentThingsStopTheSunIndependently)
{
  rtg::Material roof = White();
  roof.diffuse = 0.0f;
  roof.opacity = 0.5f;
  this->Add(Shape::Box, { { 0, 0, 0 } }, { { 1000.0f, 1000.0f, 0.1f } }, roof);
  this->Add(Shape::Box, { { 0, 0, -2 } }, { { 1000.0f, 1000.0f, 0.1f } }, White());
  const auto image = Make(64, 32, [](auto x, auto y) { return glm::vec3(x == 48 && y == 16 ? 100.0f : 0.0f); });
  this->settings.environmentImage = image;
  this->scene.Commit();
  this->tracer.Trace(this->scene, this->camera, this->lights, this->settings, rtg::Pass::All);
  double sum = 0.0;
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_EQ(mean.a, 1.0f);
    sum += mean.r;
  }
  const double lit = Expected(*image, { 0, 0, 1 }), share = 1.0 / 16.0;
  EXPECT_NEAR(sum / (24.0 * 24.0), share * lit, certain * lit * std::sqrt(share / (24.0 * 24.0 * 64.0)));
}

TEST_F(EnvironmentTest, LargeImagesAreAimedAtInCells)
{
  // 1030 columns in cells of three texels, the last of one; the sun lies in that.
  const auto image = Make(1030, 400, [](auto x, auto y) { return glm::vec3(x == 1029 && y == 399 ? 1e6f : 0.0f); });
  const rtg::EnvironmentCells cells = rtg::MakeEnvironmentCells(*image);
  EXPECT_EQ(cells.side, 3u);
  EXPECT_EQ(cells.columns, 344u);
  EXPECT_EQ(cells.rows, 134u);
  double total = 0.0;
  for (std::size_t i = 0; i < cells.cells.size(); ++i)
  {
    total += cells.cells[i].density > 0.0f;
  }
  EXPECT_EQ(total, 1.0);
  EXPECT_GT(cells.cells.back().density, 0.0f);
}

TEST_F(EnvironmentTest, SizesThatDoNotFitAreRefused)
{
  rtg::EnvironmentImage image;
  image.width = 3;
  image.height = 2;
  image.radiance.resize(5);
  EXPECT_THROW(rtg::MakeEnvironmentCells(image), rtg::Error);
}
