// Ambient occlusion and path tracing through the pipeline, against closed forms.
//
// Confidence: a mean of n samples that each lie in [0, 1] with variance v is off by more than z sqrt(v / n) with
// the probability that a normal variable is beyond z; z = 5 is one in 1.7 million. v is taken from the samples'
// own bound (occlusion: p (1 - p); radiance: at most its largest value squared), never from the result.
#include "Scene.h"
#include "SceneState.h"
#include "Shading/Shading.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using rtg::Image;
using rtg::Roulette;
using rtg::Sampler;
using rtg::Shading;
using rtg::Shape;

constexpr double certain = 5.0; // standard deviations

class LightTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer tracer{ device };
  rtg::TraceSettings settings;
  std::vector<rtg::Light> lights;
  rtg::Camera camera = this->LookFrom({ 0, 0, 5 });

  void SetUp() override
  {
    this->settings.width = this->settings.height = 24;
    this->settings.keepSums = true;
    this->settings.sampler =
      Sampler::Random; // the confidence intervals are those of independent samples
  }

  // A parallel view of half-width 1.
  static rtg::Camera LookFrom(glm::dvec3 eye, glm::dvec3 target = glm::dvec3(0), double half = 1.0)
  {
    const glm::dvec3 up =
      std::abs(glm::normalize(eye - target).y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    return rtg::Camera::FromWorldToClip(
      glm::ortho(-half, half, -half, half, 0.01, 20.0) * glm::lookAt(eye, target, up));
  }

  rtg::Scene::SetId Add(Shape shape, std::vector<glm::vec3> centres, std::vector<glm::vec3> sizes,
    const rtg::Material& material, std::vector<glm::vec4> rotations = {})
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.arrow.fixedHeads = false;
    instances.centres = std::move(centres);
    instances.sizes3 = std::move(sizes);
    instances.rotations = std::move(rotations);
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    this->scene.SetMaterial(id, material);
    return id;
  }

  Image Trace(rtg::Pass pass = rtg::Pass::Opaque)
  {
    this->scene.Commit();
    return this->tracer.Trace(this->scene, this->camera, this->lights, this->settings, pass);
  }

  // Straight colour of each pixel that some sample hit.
  std::vector<glm::vec3> Radiances() const
  {
    std::vector<glm::vec3> radiances;
    for (const glm::vec4& mean : this->tracer.Means())
    {
      if (mean.a > 0.0f)
      {
        radiances.emplace_back(glm::vec3(mean) / mean.a);
      }
    }
    return radiances;
  }

  glm::vec4 PixelMean(int x, int y) const
  {
    return this->tracer.Means()[y * this->settings.width + x];
  }
};

rtg::Material White()
{
  return rtg::Material();
}

// What is unlit local shading: white, so that occlusion alone is seen.
rtg::Material Flat()
{
  rtg::Material material;
  material.ambient = 1.0f;
  material.diffuse = 0.0f;
  return material;
}

struct Finish
{
  const char* name;
  rtg::Material material;
};

std::vector<Finish> WhiteFinishes()
{
  std::vector<Finish> finishes;
  const auto add = [&finishes](const char* name, auto change)
  {
    rtg::Material material;
    change(material);
    finishes.push_back({ name, material });
  };
  add("diffuse, smooth", [](auto& m) { m.roughness = 0.0f; });
  add("diffuse, rough", [](auto& m) { m.roughness = 1.0f; });
  add("plastic",
    [](auto& m)
    {
      m.specular = 0.5f;
      m.roughness = 0.3f;
    });
  add("rough plastic",
    [](auto& m)
    {
      m.specular = 1.0f;
      m.roughness = 1.0f;
    });
  add("mirror",
    [](auto& m)
    {
      m.metallic = 1.0f;
      m.roughness = 0.0f;
    });
  add("rough metal",
    [](auto& m)
    {
      m.metallic = 1.0f;
      m.roughness = 1.0f;
    });
  add("half metal",
    [](auto& m)
    {
      m.metallic = 0.5f;
      m.specular = 0.5f;
      m.roughness = 0.6f;
    });
  add("coated metal",
    [](auto& m)
    {
      m.metallic = 1.0f;
      m.roughness = 0.7f;
      m.coatStrength = 1.0f;
      m.coatRoughness = 0.5f;
    });
  add("coated plastic",
    [](auto& m)
    {
      m.specular = 0.5f;
      m.coatStrength = 0.8f;
      m.roughness = 0.5f;
    });
  return finishes;
}

} // namespace

struct Form
{
  const char* name;
  Shape shape;
  glm::vec3 exponents{ 2.0f };
};

static void PrintTo(const Form& form, std::ostream* out)
{
  *out << form.name;
}

class WhiteLightTest : public LightTest
{
protected:
  void WhiteIsInvisible(const Form& form);

  // A tetrahedron.
  static std::shared_ptr<const rtg::TriangleMesh> Mesh()
  {
    rtg::TriangleMesh mesh;
    mesh.positions = { { 0.5f, 0.5f, 0.5f }, { 0.5f, -0.5f, -0.5f }, { -0.5f, 0.5f, -0.5f }, { -0.5f, -0.5f, 0.5f } };
    mesh.triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
    return std::make_shared<const rtg::TriangleMesh>(mesh);
  }

  rtg::Scene::SetId AddForm(const Form& form)
  {
    rtg::GlyphInstances instances;
    instances.shape = form.shape;
    instances.arrow.fixedHeads = false;
    instances.centres = { { 0, 0, 0 } };
    instances.sizes3 = { { 1.6f, 1.1f, 1.3f } };
    instances.rotations = { glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f)) };
    instances.uniformExponents = form.exponents;
    if (form.shape == Shape::Mesh)
    {
      instances.mesh = Mesh();
    }
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    return id;
  }
};

// A white thing in white light is invisible, in every pixel.
void WhiteLightTest::WhiteIsInvisible(const Form& form)
{
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 256;
  this->settings.maximumBounces = 100;
  // The forms whose rays cost most get fewer pixels; each has its own interval.
  const bool costly = form.shape == Shape::Superquadric || form.shape == Shape::NestedSuperquadric;
  this->settings.width = this->settings.height = costly ? 8 : 16;
  SCOPED_TRACE(form.name);
  const auto id = this->AddForm(form);
  std::vector<Finish> finishes = WhiteFinishes();
  // Opacity below one: light goes in, is scattered inside, and comes out.
  for (const int which : { 0, 2, 5, 8 })
  {
    finishes.push_back(finishes[which]);
    finishes.back().material.opacity = 0.6f;
  }
  for (const Finish& finish : finishes)
  {
    this->scene.SetMaterial(id, finish.material);
    this->Trace(rtg::Pass::All);
    // A sample is a product of weights of mean 1, each at most (7/2)^2 / 0.48 but seldom beyond 1; what Burley's
    // diffuse lobe varies about its mean is below 0.5 at any angle.
    const double deviation =
      finish.material.roughness > 0.0f || finish.material.metallic == 0.0f ? 0.6 : 0.0;
    double sum = 0.0;
    const std::vector<glm::vec4> means = this->tracer.Means();
    double count = 0.0;
    for (const glm::vec4& mean : means)
    {
      if (mean.a <= 0.0f)
      {
        continue;
      }
      const double samples = mean.a * this->settings.samples;
      const double radiance = mean.r / mean.a;
      EXPECT_NEAR(radiance, 1.0, certain * deviation / std::sqrt(samples) + 1e-5) << finish.name;
      sum += mean.r * this->settings.samples;
      count += samples;
    }
    EXPECT_GT(count, 4.0 * this->settings.samples);
    EXPECT_NEAR(sum / count, 1.0, certain * deviation / std::sqrt(count) + 1e-5) << finish.name;
  }
  this->scene.Remove(id);
}

class Furnace
  : public WhiteLightTest
  , public ::testing::WithParamInterface<Form>
{
};

TEST_P(Furnace, WhiteInWhiteLightIsWhite)
{
  this->WhiteIsInvisible(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Shapes, Furnace,
  ::testing::Values(Form{ "Sphere", Shape::Sphere }, Form{ "Box", Shape::Box },
    Form{ "Cylinder", Shape::Cylinder }, Form{ "Cone", Shape::Cone }, Form{ "Arrow", Shape::Arrow },
    Form{ "Mesh", Shape::Mesh }, Form{ "RoundedBox", Shape::Superquadric, { 6, 4, 10 } },
    Form{ "Star", Shape::Superquadric, { 0.6f, 0.8f, 0.7f } }),
  [](const auto& info) { return std::string(info.param.name); });

// In one process: their programs take longest to compile.
TEST_F(WhiteLightTest, WhiteTensorGlyphsInWhiteLightAreWhite)
{
  for (const Form& form : { Form{ "rod", Shape::NestedSuperquadric, { 0.4f, 0.2f, 0.2f } },
         Form{ "double", Shape::NestedSuperquadric, { 0.5f, 0.7f, 0.3f } },
         Form{ "thorn", Shape::NestedSuperquadric, { 1.0f, 2.6f, 2.6f } } })
  {
    this->WhiteIsInvisible(form);
  }
}

// In clutter light takes several bounces to get out: more bounces let more out, never more than came in.
TEST_F(LightTest, EnergyNeverGrowsWithBounces)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-0.8f, 0.8f);
  std::vector<glm::vec3> centres(200);
  for (auto& c : centres)
  {
    c = { uniform(random), uniform(random), uniform(random) };
  }
  rtg::Material metal;
  metal.metallic = 1.0f;
  metal.roughness = 0.8f;
  const auto id =
    this->Add(Shape::Sphere, centres, std::vector<glm::vec3>(200, glm::vec3(0.3f)), White());
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 64;
  rtg::Material half;
  half.opacity = 0.5f;
  for (const rtg::Material& material : { White(), metal, half })
  {
    this->scene.SetMaterial(id, material);
    double before = 0.0;
    for (std::uint32_t bounces : { 1, 2, 4, 8, 16, 64, 256 })
    {
      this->settings.maximumBounces = bounces;
      this->Trace(rtg::Pass::All);
      glm::dvec4 sum(0.0);
      for (const glm::vec4& mean : this->tracer.Means())
      {
        sum += glm::dvec4(mean);
      }
      const double radiance = sum.r / sum.a;
      const double interval = certain * 0.6 / std::sqrt(sum.a * this->settings.samples);
      EXPECT_LT(radiance, 1.0 + interval) << bounces;
      // The same random numbers up to where the shorter paths were cut: nothing can be lost.
      EXPECT_GE(radiance, before) << bounces;
      before = radiance;
    }
    EXPECT_NEAR(before, 1.0, certain * 0.6 / std::sqrt(24 * 24 * 64.0 * 0.5));
  }
}

// A sphere of radius r that touches a plane: a sphere wholly above the horizon covers sin^2 of its half angle times
// the cosine of its direction, of the cosine-weighted hemisphere.
TEST_F(LightTest, OcclusionOfASphereOnAPlane)
{
  const double radius = 0.4;
  this->Add(Shape::Sphere, { { 0, 0.4f, 0 } }, { glm::vec3(0.8f) }, Flat());
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 100.0f, 0.1f, 100.0f } }, Flat());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 4096;
  // From below the sphere's equator the floor is hidden, so the camera sees it from the side, aslant.
  this->settings.width = 24;
  this->settings.height = 1;
  this->camera = this->LookFrom({ 0, 3, 3 }, { 0, 0, 0 });
  // One row of pixels along x, thin: height of the view 1e-3 about the floor's line z = 0.8.
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-2.0, 2.0, -1e-3, 1e-3, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 3, 3.8), glm::dvec3(0, 0, 0.8), glm::dvec3(0, 1, 0)));
  this->Trace();
  for (int x = 0; x < 24; ++x)
  {
    // Mean of the closed form over the pixel's width.
    double expected = 0.0;
    for (int i = 0; i < 64; ++i)
    {
      const double px = -2.0 + 4.0 * (x + (i + 0.5) / 64.0) / 24.0;
      const double distance2 = px * px + 0.8 * 0.8 + radius * radius;
      expected += (1.0 - radius * radius * radius / (distance2 * std::sqrt(distance2))) / 64.0;
    }
    const double interval =
      certain * std::sqrt(expected * (1.0 - expected) / this->settings.samples);
    EXPECT_NEAR(this->PixelMean(x, 0).r, expected, interval + 1e-5) << x;
    EXPECT_EQ(this->PixelMean(x, 0).a, 1.0f);
  }
}

// Between two discs face to face on one axis: seen from the middle of one, the other of radius R at height h
// takes R^2 / (R^2 + h^2) of the light.
TEST_F(LightTest, OcclusionOfParallelPlanes)
{
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 10.0f, 0.1f, 10.0f } }, Flat());
  this->Add(Shape::Cylinder, { { 0, 0.55f, 0 } }, { { 1.0f, 0.1f, 1.0f } }, Flat());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 16384;
  this->settings.width = this->settings.height = 1;
  // Looks at the floor's middle under the disc, from the side.
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1e-4, 1e-4, -1e-4, 1e-4, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 0.3, 3), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  const double open = 1.0 - 0.25 / (0.25 + 0.25);
  const double interval = certain * std::sqrt(0.25 / this->settings.samples);
  this->Trace();
  EXPECT_NEAR(this->PixelMean(0, 0).r, open, interval);

  // Within a radius a, only directions up to acos(h / a) reach the disc: it takes 1 - h^2 / a^2.
  this->settings.occlusionRadius = 0.55f;
  this->Trace();
  EXPECT_NEAR(this->PixelMean(0, 0).r, 0.25 / (0.55 * 0.55), interval);
  this->settings.occlusionRadius = 0.4f;
  this->Trace();
  EXPECT_EQ(this->PixelMean(0, 0).r, 1.0f);

  // The light's colour and strength multiply what is left.
  this->settings.environmentColour = { 1.0f, 0.5f, 0.0f };
  this->settings.lightIntensity = 0.5f;
  this->Trace();
  EXPECT_EQ(this->PixelMean(0, 0), glm::vec4(0.5f, 0.25f, 0.0f, 1.0f));
}

// Where occluders are large in view, scrambled nets err less than independent samples, each pixel on its own.
TEST_F(LightTest, NetsErrLessThanIndependentSamples)
{
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 10.0f, 0.1f, 10.0f } }, Flat());
  this->Add(Shape::Cylinder, { { 0, 0.55f, 0 } }, { { 1.0f, 0.1f, 1.0f } }, Flat());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 256;
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1e-4, 1e-4, -1e-4, 1e-4, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 0.3, 3), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  const auto meanSquare = [this](Sampler sampler)
  {
    this->settings.sampler = sampler;
    this->Trace();
    double sum = 0.0;
    const std::vector<glm::vec4> means = this->tracer.Means();
    for (const glm::vec4& mean : means)
    {
      sum += (mean.r - 0.5) * (mean.r - 0.5) / static_cast<double>(means.size());
    }
    return sum;
  };
  const double random = meanSquare(Sampler::Random);
  // p (1 - p) / n; the mean square of 576 pixels varies by sqrt(2 / 576) of itself.
  EXPECT_NEAR(random, 0.25 / 256, certain * std::sqrt(2.0 / 576) * 0.25 / 256);
  for (Sampler sampler : { Sampler::Stratified, Sampler::Sobol, Sampler::BlueNoise })
  {
    const double error = meanSquare(sampler);
    EXPECT_LT(error, 0.5 * random) << static_cast<int>(sampler);
    std::printf("sampler %d errs %.1f times less than independent samples\n",
      static_cast<int>(sampler), random / error);
  }
}

// Several occlusion rays a sample: the same mean, to which each ray adds its part, and those of one sample and of all together are nets.
TEST_F(LightTest, SeveralOcclusionRaysASample)
{
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 10.0f, 0.1f, 10.0f } }, Flat());
  this->Add(Shape::Cylinder, { { 0, 0.55f, 0 } }, { { 1.0f, 0.1f, 1.0f } }, Flat());
  this->settings.shading = Shading::AmbientOcclusion;
  // One place in all pixels: half of the light is seen from there.
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1e-4, 1e-4, -1e-4, 1e-4, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 0.3, 3), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  struct Error
  {
    double mean = 0.0, square = 0.0;
  };
  const auto errors = [this](Sampler sampler, std::uint32_t samples, std::uint32_t rays)
  {
    this->settings.sampler = sampler;
    this->settings.samples = samples;
    this->settings.occlusionRays = rays;
    this->Trace();
    Error error;
    const std::vector<glm::vec4> means = this->tracer.Means();
    for (const glm::vec4& mean : means)
    {
      error.mean += (mean.r - 0.5) / static_cast<double>(means.size());
      error.square += (mean.r - 0.5) * (mean.r - 0.5) / static_cast<double>(means.size());
    }
    return error;
  };
  const double pixels = static_cast<double>(this->settings.width * this->settings.height);
  for (const std::uint32_t samples : { 1u, 4u })
  {
    const double variance = 0.25 / (64.0 * samples); // of independent rays
    const Error independent = errors(Sampler::Random, samples, 64);
    EXPECT_NEAR(independent.mean, 0.0, certain * std::sqrt(variance / pixels));
    EXPECT_NEAR(independent.square, variance, certain * std::sqrt(2.0 / pixels) * variance);
    for (Sampler sampler : { Sampler::Stratified, Sampler::Sobol, Sampler::BlueNoise })
    {
      const Error spread = errors(sampler, samples, 64);
      EXPECT_NEAR(spread.mean, 0.0, certain * std::sqrt(variance / pixels)) << static_cast<int>(sampler);
      EXPECT_LT(spread.square, 0.5 * variance) << static_cast<int>(sampler);
    }
  }
}

// Several paths a sample: those of one sample and of all together are nets, too. One scattering on a matt floor under the same lid: half of the
// light, but for the shape of the diffuse lobe.
TEST_F(LightTest, SeveralPathsASample)
{
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 10.0f, 0.1f, 10.0f } }, White());
  this->Add(Shape::Cylinder, { { 0, 0.55f, 0 } }, { { 1.0f, 0.1f, 1.0f } }, White());
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 1;
  this->settings.paths = 64;
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1e-4, 1e-4, -1e-4, 1e-4, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 0.3, 3), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  const double pixels = static_cast<double>(this->settings.width * this->settings.height);
  for (const std::uint32_t samples : { 1u, 4u })
  {
    this->settings.samples = samples;
    const double independent = 0.25 / (64.0 * samples);
    for (Sampler sampler : { Sampler::Random, Sampler::Stratified, Sampler::Sobol, Sampler::BlueNoise })
    {
      this->settings.sampler = sampler;
      this->Trace();
      double sum = 0.0, squares = 0.0;
      for (const glm::vec4& mean : this->tracer.Means())
      {
        sum += mean.r / pixels;
        squares += mean.r * mean.r / pixels;
      }
      EXPECT_NEAR(sum, 0.5, 0.05) << static_cast<int>(sampler);
      const double variance = squares - sum * sum;
      if (sampler == Sampler::Random)
      {
        EXPECT_NEAR(variance, independent, 0.2 * independent);
      }
      else
      {
        EXPECT_LT(variance, 0.5 * independent) << static_cast<int>(sampler);
      }
    }
  }
}

// A thing that covers a quarter of each pixel is hit by exactly a quarter of the samples: their places are a net, although the
// first of them is the pixel's centre.
TEST_F(LightTest, PlacesInAPixelAreANet)
{
  std::vector<glm::vec3> centres;
  for (int column = 0; column < 24; ++column)
  {
    centres.emplace_back(-1.0f + (column + 0.125f) / 12.0f, 0.0f, 0.0f);
  }
  this->Add(Shape::Box, centres, std::vector<glm::vec3>(24, glm::vec3(0.25f / 12.0f, 10.0f, 0.1f)), Flat());
  this->settings.sampler = Sampler::Sobol;
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
    // That of the nearest sample, none of which is the centre.
    EXPECT_LT(image.depth[0], 1.0f);
  }
}

// Convex things alone hide nothing from themselves, wherever they lie and however they are seen.
TEST_F(LightTest, NothingShadowsItself)
{
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 64;
  for (Shape shape : { Shape::Sphere, Shape::Box, Shape::Cylinder, Shape::Cone })
  {
    for (const glm::vec3& size : { glm::vec3(1.0f), glm::vec3(1e-3f), glm::vec3(1.0f, 0.01f, 0.3f),
           glm::vec3(0.01f, 1.0f, 1.0f) })
    {
      for (float where : { 0.0f, 900.0f })
      {
        const glm::vec4 turn = glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f));
        const auto id = this->Add(shape, { { where, 0, 0 } }, { size }, Flat(), { turn });
        const double extent = std::max({ size.x, size.y, size.z });
        this->camera = this->LookFrom(
          glm::dvec3(where, 0, 0) + glm::dvec3(0, 0, 5), glm::dvec3(where, 0, 0), 0.7 * extent);
        this->Trace();
        for (const glm::vec3& radiance : this->Radiances())
        {
          ASSERT_EQ(radiance.r, 1.0f)
            << static_cast<int>(shape) << ' ' << size.x << ' ' << size.y << ' ' << where;
        }
        this->scene.Remove(id);
      }
    }
  }
}

// Inside a sphere no light comes in. What roulette guesses of it is taken back on average.
TEST_F(LightTest, InsideIsDark)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(4.0f) }, Flat());
  this->camera = this->LookFrom({ 0, 0, 1 });
  this->settings.roulette = Roulette::None;
  for (Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->scene.SetMaterial(0, shading == Shading::PathTracing ? White() : Flat());
    this->settings.shading = shading;
    this->Trace();
    for (const glm::vec4& mean : this->tracer.Means())
    {
      ASSERT_EQ(mean, glm::vec4(0, 0, 0, 1));
    }
  }
  this->settings.roulette = Roulette::Guessing;
  this->settings.samples = 64;
  this->Trace();
  double sum = 0.0, squares = 0.0;
  const std::vector<glm::vec4> means = this->tracer.Means();
  for (const glm::vec4& mean : means)
  {
    sum += mean.r;
    squares += mean.r * mean.r;
  }
  EXPECT_NEAR(sum, 0.0, certain * std::sqrt(squares));
  EXPECT_LT(certain * std::sqrt(squares) / static_cast<double>(means.size()), 0.01);
}

// Russian roulette, with guesses where light comes from all around alone and without, and several paths a sample: the same mean.
TEST_F(LightTest, RouletteAndPathsChangeNoMean)
{
  rtg::Material shining;
  shining.colour = glm::vec3(0.6f, 0.75f, 0.9f);
  shining.ambientColour = glm::vec3(0.5f, 0.3f, 0.1f);
  shining.ambient = 0.2f;
  shining.specular = 0.5f;
  shining.roughness = 0.4f;
  std::vector<glm::vec3> centres;
  for (int i = 0; i < 27; ++i)
  {
    centres.emplace_back(0.5f * (i % 3 - 1), 0.5f * (i / 3 % 3 - 1), 0.5f * (i / 9 - 1));
  }
  this->Add(Shape::Sphere, centres, std::vector<glm::vec3>(27, glm::vec3(0.55f)), shining);
  this->settings.shading = Shading::PathTracing;
  this->settings.environmentColour = glm::vec3(1.0f, 0.8f, 0.9f);
  this->settings.samples = 128;
  rtg::Light sun;
  sun.kind = rtg::Light::Kind::Directional;
  sun.direction = glm::normalize(glm::vec3(0.3f, -0.5f, -1.0f));
  for (const bool lit : { false, true })
  {
    this->lights = lit ? std::vector<rtg::Light>{ sun } : std::vector<rtg::Light>();
    this->settings.roulette = Roulette::None;
    this->settings.paths = 1;
    this->Trace();
    const std::vector<glm::vec4> plain = this->tracer.Means();
    for (const auto& [roulette, paths] : { std::pair(Roulette::Guessing, 1u), std::pair(Roulette::None, 4u),
           std::pair(Roulette::Plain, 1u), std::pair(Roulette::Guessing, 5u) })
    {
      this->settings.roulette = roulette;
      this->settings.paths = paths;
      this->Trace();
      const std::vector<glm::vec4> means = this->tracer.Means();
      for (int channel = 0; channel < 3; ++channel)
      {
        // Pixel by pixel, so that only noise is left; mean and deviation of the difference.
        double sum = 0.0, squares = 0.0;
        const double count = static_cast<double>(means.size());
        for (std::size_t i = 0; i < means.size(); ++i)
        {
          const double difference = means[i][channel] - plain[i][channel];
          sum += difference;
          squares += difference * difference;
        }
        EXPECT_GT(squares, 0.0);
        EXPECT_NEAR(sum / count, 0.0, certain * std::sqrt(squares) / count) << lit << static_cast<int>(roulette) << paths << channel;
        EXPECT_LT(certain * std::sqrt(squares) / count, 0.01);
      }
    }
  }
}

// A view's light on a white plane: what local shading shows, to a matt surface, is what path tracing must converge to
// when nothing else shines.
TEST_F(LightTest, DirectionalLightShinesOnAPlaneAsLocally)
{
  rtg::Material grey;
  grey.colour = glm::vec3(0.5f);
  grey.roughness = 0.0f;
  this->Add(Shape::Box, { { 0, 0, -0.5f } }, { { 100.0f, 100.0f, 1.0f } }, grey);
  rtg::Light light;
  light.kind = rtg::Light::Kind::Directional;
  light.direction = glm::normalize(glm::vec3(0.3f, 0.2f, -1.0f));
  light.colour = glm::vec3(0.8f, 0.6f, 0.4f);
  this->lights = { light, light };
  this->settings.shading = Shading::PathTracing;
  this->settings.lightIntensity = 0.0f;
  this->settings.samples = 16;
  this->Trace();
  const rtg::shading::Surface surface = { glm::vec3(0.214041f), 0, 0, 0, glm::vec3(1), 0, 0, 0,
    glm::vec3(1) };
  const glm::vec3 from(0, 0, 1), to = -light.direction;
  const glm::vec3 expected =
    2.0f * glm::pi<float>() * light.colour * rtg::shading::Evaluate(surface, from, to, {});
  // Burley's smooth diffuse differs from Lambert's by the normal's view factor only: near 0.5^2.2 * 2 * cos.
  EXPECT_NEAR(expected.r / (2 * 0.214041 * 0.8 * to.z), 1.0, 0.06);
  for (const glm::vec3& radiance : this->Radiances())
  {
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_NEAR(radiance[i], expected[i], 1e-4);
    }
  }
}

// Something of opacity a is hit with probability a, by eye, light and bounces: white in white light stays white.
TEST_F(LightTest, TranslucentThingsAreHitByChance)
{
  rtg::Material half;
  half.opacity = 0.5f;
  this->Add(Shape::Box, { { 0, 0, 0 } }, { { 100.0f, 100.0f, 0.1f } }, half);
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 1024;
  this->settings.maximumBounces = 200;
  this->settings.width = this->settings.height = 8;
  this->Trace(rtg::Pass::All);
  // Two faces: half of the rays stop at the first, half of the rest at the second.
  const double interval = certain * std::sqrt(0.75 * 0.25 / 1024);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_NEAR(mean.a, 0.75, interval);
    EXPECT_NEAR(mean.r / mean.a, 1.0, certain * 0.6 / std::sqrt(1024 * 0.75));
  }

  // In the translucent pass what is opaque hides what is behind it, here the second face.
  const auto wall = this->Add(Shape::Box, { { 0, 0, 0 } }, { { 100.0f, 100.0f, 0.05f } }, White());
  this->Trace(rtg::Pass::Translucent);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_NEAR(mean.a, 0.5, certain * std::sqrt(0.5 * 0.5 / 1024));
  }
  this->scene.Remove(wall);

  // A translucent roof above an opaque floor lets a quarter of the light through, at every angle.
  this->scene.Remove(0);
  this->Add(Shape::Box, { { 0, -1.0f, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, Flat());
  this->Add(Shape::Box, { { 0, 0, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, half);
  this->settings.shading = Shading::AmbientOcclusion;
  this->camera = this->LookFrom({ 0, 5, 0.5 }, { 0, 0, 0 });
  this->Trace(rtg::Pass::Opaque);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_NEAR(mean.r, 0.25, interval);
  }
}

// All layers along a ray, front to back, up to what is opaque: exactly, in every pixel.
TEST_F(LightTest, TranslucentLayersAreBlendedFrontToBack)
{
  const auto add = [this](float z, glm::vec3 colour, float opacity)
  {
    rtg::Material material;
    material.colour = colour;
    material.opacity = opacity;
    material.lighting = false;
    this->Add(Shape::Box, { { 0, 0, z } }, { { 100.0f, 100.0f, 0.1f } }, material);
  };
  add(0.0f, { 1, 0, 0 }, 0.5f);
  add(-1.0f, { 0, 0, 1 }, 0.25f);
  add(-2.0f, { 0, 1, 0 }, 1.0f);
  add(-3.0f, { 1, 1, 1 }, 0.5f);
  // Of each box both faces.
  const float red = 0.75f, blue = 0.25f * (1.0f - 0.75f * 0.75f);
  this->settings.samples = 4;
  for (Shading shading : { Shading::Local, Shading::AmbientOcclusion })
  {
    this->settings.shading = shading;
    const Image image = this->Trace(rtg::Pass::Translucent);
    for (const glm::vec4& mean : this->tracer.Means())
    {
      ASSERT_NEAR(mean.r, red, 1e-6);
      ASSERT_EQ(mean.g, 0.0f);
      ASSERT_NEAR(mean.b, blue, 1e-6);
      ASSERT_NEAR(mean.a, red + blue, 1e-6);
    }
    // The nearest layer's depth and identity.
    EXPECT_EQ(image.setIds[0], 0u);
    EXPECT_NEAR(image.depth[0], (4.95 - 0.01) / 19.99, 1e-6);
    for (const glm::vec4& mean : (this->Trace(rtg::Pass::Opaque), this->tracer.Means()))
    {
      ASSERT_EQ(mean, glm::vec4(0, 1, 0, 1));
    }
  }
  // Path tracing stops at each by chance.
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 1024;
  this->Trace(rtg::Pass::Translucent);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_NEAR(mean.r, red, certain * std::sqrt(red * (1 - red) / 1024));
    EXPECT_NEAR(mean.b, blue, certain * std::sqrt(blue * (1 - blue) / 1024));
    EXPECT_NEAR(mean.a, red + blue, certain * std::sqrt((red + blue) * (1 - red - blue) / 1024));
  }
}

TEST_F(LightTest, LayersOfARayAreLimited)
{
  std::vector<glm::vec3> centres;
  for (int i = 0; i < 200; ++i)
  {
    centres.emplace_back(0.0f, 0.0f, -0.01f * i);
  }
  rtg::Material thin;
  thin.lighting = false;
  thin.opacity = 0.004f;
  this->Add(Shape::Box, centres, std::vector<glm::vec3>(200, glm::vec3(10, 10, 0.005f)), thin);
  this->Trace(rtg::Pass::Translucent);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    ASSERT_NEAR(mean.a, 1.0 - std::pow(0.996, 256), 1e-4);
  }
}

class Steps
  : public LightTest
  , public ::testing::WithParamInterface<Shading>
{
};

// However the samples are shared out among calls: the same image to the bit.
TEST_P(Steps, AccumulateToTheSameImage)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(-0.8f, 0.8f);
  std::vector<glm::vec3> centres(50);
  for (auto& c : centres)
  {
    c = { uniform(random), uniform(random), uniform(random) };
  }
  rtg::Material material;
  material.colour = { 0.9f, 0.5f, 0.3f };
  material.specular = 0.4f;
  this->Add(Shape::Sphere, centres, std::vector<glm::vec3>(50, glm::vec3(0.3f)), material);
  this->lights.emplace_back();
  this->settings.shading = GetParam();
  this->settings.width = 41;
  this->settings.height = 33;
  this->settings.plannedSamples = 13;
  this->settings.occlusionRays = this->settings.paths = 3;
  this->settings.features = true;
  const std::size_t pixels = 41 * 33;
  for (Sampler sampler : { Sampler::Stratified, Sampler::Sobol })
  {
    this->settings.sampler = sampler;
    this->settings.firstSample = 0;
    this->settings.samples = 13;
    const Image whole = this->Trace();
    const std::vector<std::uint32_t> colour(whole.colour, whole.colour + pixels);
    const std::vector<std::uint32_t> glyphs(whole.glyphIds, whole.glyphIds + pixels);
    const std::vector<std::uint32_t> sets(whole.setIds, whole.setIds + pixels);
    const std::vector<float> depth(whole.depth, whole.depth + pixels);
    const std::vector<glm::vec4> means = this->tracer.Means();

    // A fresh tracer too: nothing may depend on what was traced before.
    rtg::Tracer other(this->device);
    Image image;
    std::uint32_t done = 0;
    for (std::uint32_t step : { 1, 4, 8 })
    {
      this->settings.firstSample = done;
      this->settings.samples = step;
      image = other.Trace(this->scene, this->camera, this->lights, this->settings);
      done += step;
      EXPECT_EQ(image.samples, done);
    }
    EXPECT_EQ(colour, std::vector<std::uint32_t>(image.colour, image.colour + pixels));
    EXPECT_EQ(glyphs, std::vector<std::uint32_t>(image.glyphIds, image.glyphIds + pixels));
    EXPECT_EQ(sets, std::vector<std::uint32_t>(image.setIds, image.setIds + pixels));
    EXPECT_EQ(depth, std::vector<float>(image.depth, image.depth + pixels));
    EXPECT_EQ(means, other.Means());
    EXPECT_EQ(whole.normals, image.normals);
    EXPECT_EQ(whole.albedos, image.albedos);
    EXPECT_EQ(whole.viewDepths, image.viewDepths);
  }
}

static std::string NameOf(const ::testing::TestParamInfo<Shading>& info)
{
  static const char* const names[] = { "Local", "AmbientOcclusion", "PathTracing" };
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Shadings, Steps,
  ::testing::Values(Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing), NameOf);

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

// A scene that is one set of glyphs has programs of its own, which walk its tree without the driver's structure. With another set, which nobody can
// see inside one of the glyphs, the same picture comes through that structure.
TEST_P(WholeScene, LooksLikeOneOfSeveralSets)
{
  const auto [name, shape, plain, shading] = GetParam();
  this->scene.GetState().structure = rtg::Structure::Tree;
  this->settings.width = this->settings.height = 80;
  this->settings.samples = 3;
  this->settings.sharedTimeBits = 0; // the sets have different numbers of slices
  this->settings.paths = 2;
  this->settings.shading = shading;
  this->lights.emplace_back();
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  rtg::GlyphInstances instances;
  instances.shape = shape;
  instances.origin = { 0.03, -0.01, 0.02 };
  instances.uniformSize = 0.2f;
  rtg::GlyphColours colours;
  for (int i = 0; i < 300; ++i)
  {
    instances.centres.emplace_back(1.8f * uniform(random) - 0.9f, 1.8f * uniform(random) - 0.9f, uniform(random));
    if (!plain)
    {
      instances.sizes3.emplace_back(0.1f + 0.2f * uniform(random), 0.1f + 0.1f * uniform(random), 0.1f);
      instances.rotations.push_back(glm::normalize(glm::vec4(uniform(random), uniform(random), uniform(random), 1.0f)));
      instances.motion.velocities.emplace_back(0.1f, 0.05f, 0.0f);
      colours.push_back(static_cast<std::uint32_t>(random()) | 0xff000000u);
      instances.exponents3.emplace_back(1.0f + 3.0f * uniform(random), 2.0f, 1.0f + 5.0f * uniform(random));
    }
  }
  if (shape != Shape::Superquadric)
  {
    instances.exponents3.clear();
  }
  // A set that is not shown, but whose origin is the scene's: centres are not relative to that.
  rtg::GlyphInstances away;
  away.origin = { 0.7, -0.4, 0.2 };
  away.centres = { glm::vec3(0.0f) };
  const auto first = this->scene.Add();
  this->scene.SetInstances(first, away);
  this->scene.SetVisible(first, false);
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  this->scene.SetColours(id, colours);
  const Image one = this->Trace();
  const std::size_t pixels = std::size_t(one.width) * one.height;
  const std::vector<std::uint32_t> glyphs(one.glyphIds, one.glyphIds + pixels);
  const std::vector<float> depths(one.depth, one.depth + pixels);
  const std::vector<glm::vec4> means = this->tracer.Means();
  EXPECT_GT(pixels, 3 * std::size_t(std::count(glyphs.begin(), glyphs.end(), Image::noGlyph)) / 2);

  rtg::GlyphInstances hidden;
  hidden.origin = instances.origin;
  hidden.uniformSize = 1e-4f;
  hidden.centres = { instances.centres[0] };
  if (!plain)
  {
    hidden.motion.velocities = { instances.motion.velocities[0] };
  }
  this->scene.SetInstances(this->scene.Add(), hidden);
  const Image several = this->Trace();
  const std::vector<glm::vec4> others = this->tracer.Means();
  std::size_t otherGlyphs = 0, otherDepths = 0, otherColours = 0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    otherGlyphs += glyphs[i] != several.glyphIds[i];
    otherDepths += depths[i] != several.depth[i];
    otherColours += means[i] != others[i];
  }
  EXPECT_EQ(otherGlyphs, 0u);
  EXPECT_EQ(otherDepths, 0u);
  EXPECT_EQ(otherColours, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, WholeScene,
  ::testing::Values(Whole{ "SphereLocal", Shape::Sphere, true, Shading::Local },
    Whole{ "SphereOcclusion", Shape::Sphere, true, Shading::AmbientOcclusion },
    Whole{ "SpherePath", Shape::Sphere, true, Shading::PathTracing },
    Whole{ "EllipsoidPath", Shape::Sphere, false, Shading::PathTracing },
    Whole{ "BoxOcclusion", Shape::Box, false, Shading::AmbientOcclusion },
    Whole{ "CylinderLocal", Shape::Cylinder, true, Shading::Local },
    Whole{ "ConeOcclusion", Shape::Cone, true, Shading::AmbientOcclusion },
    Whole{ "ArrowOcclusion", Shape::Arrow, false, Shading::AmbientOcclusion },
    Whole{ "SuperquadricLocal", Shape::Superquadric, false, Shading::Local }),
  [](const auto& info) { return std::string(info.param.name); });

TEST_F(LightTest, SamplesAreAddedOnlyToTheirOwnImage)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  this->settings.samples = 4;
  this->Trace();
  this->settings.firstSample = 3;
  EXPECT_THROW(this->Trace(), rtg::Error); // four are there
  this->settings.firstSample = 4;
  this->settings.shading = Shading::AmbientOcclusion;
  EXPECT_THROW(this->Trace(), rtg::Error); // of another kind
  this->settings.shading = Shading::Local;
  EXPECT_EQ(this->Trace().samples, 8u);
}

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
  fails("intensity", [](auto& s) { s.lightIntensity = -0.5f; });
  fails("colour", [](auto& s) { s.environmentColour.g = NAN; });
  fails("exposure", [](auto& s) { s.exposure = INFINITY; });
}

TEST_F(LightTest, ExposureAndToneMappingDevelopTheImage)
{
  rtg::Material material;
  material.lighting = false;
  material.colour = glm::vec3(0.5f);
  this->Add(Shape::Box, { { 0, 0, 0 } }, { { 10, 10, 1 } }, material);
  const auto shown = [this] { return static_cast<int>(this->Trace().colour[0] & 255u); };
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
  }
}

TEST_F(LightTest, FeaturesSayWhatTheEyeMet)
{
  rtg::Material material;
  material.colour = { 0.25f, 0.5f, 0.75f };
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.8f) }, material);
  this->settings.features = true;
  const Image image = this->Trace();
  const std::size_t middle = 12 * 24 + 12;
  EXPECT_GT(image.normals[middle].z, 0.99f);
  EXPECT_EQ(image.albedos[middle], material.colour);
  EXPECT_NEAR(image.viewDepths[middle], 5.0 - 0.9, 2e-3 + 0.01);
  EXPECT_EQ(image.normals[0], glm::vec3(0.0f));
}

TEST_F(LightTest, DenoisingBringsAnImageCloserToTheTruth)
{
  // A sphere on a floor, darkened where they meet.
  this->camera = LookFrom({ 0, -5, 4 }, { 0, 0, 0.3 }, 1.5);
  const auto ball = this->Add(Shape::Sphere, { { 0, 0, 0.5 } }, { glm::vec3(1.0f) }, Flat());
  const auto floor = this->Add(Shape::Box, { { 0, 0, -0.5 } }, { { 20, 20, 1 } }, Flat());
  rtg::Material grey;
  grey.colour = glm::vec3(0.7f);
  this->settings.width = this->settings.height = 48;
  for (Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    if (shading == Shading::PathTracing)
    {
      this->scene.SetMaterial(ball, grey);
      this->scene.SetMaterial(floor, grey);
    }
    this->settings.shading = shading;
    this->settings.features = false;
    this->settings.sampler = Sampler::Sobol;
    this->settings.samples = 512;
    this->Trace();
    const std::vector<glm::vec4> truth = this->tracer.Means();
    // Display colours of the truth and of few samples, with noise and without.
    const auto error = [&](const Image& image)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < truth.size(); ++i)
      {
        glm::vec3 wanted = glm::vec3(truth[i]) / std::max(truth[i].a, 1e-6f);
        if (shading == Shading::PathTracing)
        {
          wanted = rtg::shading::LinearToDisplay(glm::clamp(wanted, 0.0f, 1.0f));
        }
        const glm::vec3 apart = glm::vec3(glm::unpackUnorm4x8(image.colour[i])) - wanted;
        sum += glm::dot(apart, apart);
      }
      return sum / (3.0 * truth.size());
    };
    this->settings.features = true;
    this->settings.samples = 4;
    Image image = this->Trace();
    const double noisy = error(image);
    const std::vector<std::uint32_t> alphas(image.colour, image.colour + truth.size());
    this->tracer.Denoise(image);
    const double smooth = error(image);
    std::printf("squared error of 4 samples %.2e, denoised %.2e\n", noisy, smooth);
    // What is left is edges: few samples do not smooth these.
    EXPECT_LT(smooth, 0.5 * noisy);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      ASSERT_EQ(image.colour[i] >> 24, alphas[i] >> 24);
    }
  }
}

TEST_F(LightTest, DenoisingNeedsWhatItIsGuidedBy)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(1.0f) }, White());
  this->settings.shading = Shading::AmbientOcclusion;
  Image image = this->Trace();
  EXPECT_THROW(this->tracer.Denoise(image), rtg::Error);
}

// ---- Environment images --------------------------------------------------------------------------------------

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
        const glm::dvec3 d = std::cos(latitude) * (std::cos(longitude) * right + std::sin(longitude) * front) +
          std::sin(latitude) * up;
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

TEST_F(EnvironmentTest, OneColourIsTheSameFromEverywhere)
{
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(4) }, White());
  this->settings.environmentImage = Make(7, 5, [](auto, auto) { return glm::vec3(0.5f); });
  this->settings.environmentColour = glm::vec3(1.0f);
  this->settings.lightIntensity = 3.0f;
  EXPECT_NEAR(this->Mean(), 1.5, 1e-4);
}

// The sun, and dim sky: each face of a box shows the light that reaches it, whichever way the image is turned.
TEST_F(EnvironmentTest, FacesShowTheIrradianceThatReachesThem)
{
  this->Add(Shape::Box, { glm::vec3(0) }, { glm::vec3(4) }, White());
  const glm::vec3 frames[][2] = { { { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 0 }, { 0, 0, 1 } },
    { glm::normalize(glm::vec3(1, 2, 0)), glm::normalize(glm::vec3(-2, 1, 1)) } };
  for (const auto& frame : frames)
  {
    const auto image = Make(37, 18,
      [](auto x, auto y) { return glm::vec3(x == 30 && y == 11 ? 200.0f : 0.02f * y); });
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
        // The sun's share varies by its own size only, the sky's is at most its brightest texel.
        const double deviation = (0.2 * expected + 0.36) / std::sqrt(24.0 * 24.0 * 64.0);
        EXPECT_NEAR(this->Mean(), expected, certain * deviation) << axis << " " << side;
        most = std::max(most, expected);
      }
    }
    EXPECT_GT(most, 1.0); // the sun is there
  }
}

// What is aimed at and what is found by scattering add up, on surfaces that shine: quarters of the sky are brighter than their
// threshold, the whole is not.
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
    this->settings.environmentImage = Make(
      16, 8, [quarter](auto x, auto y) { return glm::vec3(y >= 4 && x / 4 == quarter ? 1.0f : 0.0f); });
    EXPECT_FALSE(rtg::MakeEnvironmentCells(*this->settings.environmentImage).cells.empty());
    const double part = this->Mean();
    EXPECT_GT(part, 0.05);
    quarters += part;
  }
  // Samples lie in [0, 1], but for glossy reflections that are aimed at, whose weight may reach a few.
  EXPECT_NEAR(quarters, whole, certain * 2.0 * std::sqrt(5.0) / std::sqrt(24.0 * 24.0 * 256.0));
}

// Camera and sun see the floor through the same black roof: each of the two ways meets both of its faces, and whether a face
// stops one says nothing about the other.
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
