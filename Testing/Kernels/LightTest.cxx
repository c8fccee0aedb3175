// Ambient occlusion and path tracing through the pipeline, against closed forms.
#include "FormExtents.h"
#include "HarmonicForms.h"
#include "LightFixture.h"
#include "Shading/Shading.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace
{

using namespace light;

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

class Furnace
  : public LightTest
  , public ::testing::WithParamInterface<Form>
{
protected:
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
    instances.centers = { { 0, 0, 0 } };
    instances.sizes3 = { { 1.6f, 1.1f, 1.3f } };
    instances.rotations = { glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f)) };
    instances.uniformExponents = form.exponents;
    if (form.shape == Shape::Mesh)
    {
      instances.mesh = Mesh();
    }
    if (form.shape == Shape::Polynomial)
    {
      // Lobes of both signs
      const double harmonics[15] = { 0.3, 0.2, -0.5, 0.4, 0.1, 0.3, 0.5, -0.2, 0.3, 0.1, 0.6, -0.3, 0.2, 0.4, -0.1 };
      const rtg::FormMap map = rtg::FormMap::Harmonics(15, rtg::HarmonicsBasis::MRtrix3);
      const rtg::FormMeter meter(map.Degree());
      std::vector<double> coefficients(rtg::FormTerms(map.Degree()));
      map.Apply(harmonics, coefficients.data());
      instances.polynomialDegree = map.Degree();
      instances.polynomials.width = 3 + coefficients.size();
      instances.polynomials.values.resize(instances.polynomials.width);
      meter.Store(coefficients.data(), meter.Measure(coefficients.data()), instances.polynomials.values.data());
    }
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    return id;
  }
};

// A white thing in white light is invisible, in every pixel.
TEST_P(Furnace, WhiteInWhiteLightIsWhite)
{
  const Form form = GetParam();
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 100;
  // The forms whose rays cost most get fewer; each has its own interval.
  const bool costly =
    form.shape == Shape::Superquadric || form.shape == Shape::NestedSuperquadric || form.shape == Shape::Polynomial;
  this->settings.samples = costly ? 256 : 1024;
  this->settings.width = this->settings.height = costly ? 8 : 16;
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
    const double deviation = finish.material.roughness > 0.0f || finish.material.metallic == 0.0f ? 0.6 : 0.0;
    double sum = 0.0, squares = 0.0, count = 0.0;
    int pixels = 0;
    const std::vector<glm::vec4> means = this->tracer.Means();
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
      squares += samples * (radiance - 1.0) * (radiance - 1.0);
      count += samples;
      ++pixels;
    }
    EXPECT_GT(count, 4.0 * this->settings.samples);
    // Over all pixels, by what a sample varies: 0.03 to 0.18. A loss of 0.3 % is seen on most forms.
    EXPECT_LT(squares / pixels, deviation * deviation + 1e-9) << finish.name;
    EXPECT_NEAR(sum / count, 1.0, certain * std::sqrt(squares / pixels / count) + 1e-5) << finish.name;
  }
  this->scene.Remove(id);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Furnace,
  ::testing::Values(Form{ "Sphere", Shape::Sphere }, Form{ "Box", Shape::Box }, Form{ "Cylinder", Shape::Cylinder },
    Form{ "Capsule", Shape::Capsule }, Form{ "RoundCone", Shape::RoundCone }, Form{ "Cone", Shape::Cone },
    Form{ "Arrow", Shape::Arrow }, Form{ "Mesh", Shape::Mesh }, Form{ "Harmonics", Shape::Polynomial },
    Form{ "RoundedBox", Shape::Superquadric, { 6, 4, 10 } }, Form{ "Star", Shape::Superquadric, { 0.6f, 0.8f, 0.7f } },
    Form{ "TensorRod", Shape::NestedSuperquadric, { 0.4f, 0.2f, 0.2f } },
    Form{ "TensorDouble", Shape::NestedSuperquadric, { 0.5f, 0.7f, 0.3f } },
    Form{ "TensorThorn", Shape::NestedSuperquadric, { 1.0f, 2.6f, 2.6f } }),
  [](const auto& info) { return std::string(info.param.name); });

// In clutter light takes several bounces to get out: more bounces let more out, never more than came in.
TEST_F(LightTest, EnergyNeverGrowsWithBounces)
{
  const std::vector<glm::vec3> centers = Clutter(5, 200);
  rtg::Material metal;
  metal.metallic = 1.0f;
  metal.roughness = 0.8f;
  const auto id = this->Add(Shape::Sphere, centers, std::vector<glm::vec3>(200, glm::vec3(0.3f)), White());
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
  this->Add(Shape::Sphere, { { 0, 0.4f, 0 } }, { glm::vec3(0.8f) }, White());
  this->Add(Shape::Box, { { 0, -0.05f, 0 } }, { { 100.0f, 0.1f, 100.0f } }, White());
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
    const double interval = certain * std::sqrt(expected * (1.0 - expected) / this->settings.samples);
    EXPECT_NEAR(this->PixelMean(x, 0).r, expected, interval + 1e-5) << x;
    EXPECT_EQ(this->PixelMean(x, 0).a, 1.0f);
  }
}

// Between two discs face to face on one axis: seen from the middle of one, the other of radius R at height h
// takes R^2 / (R^2 + h^2) of the light.
TEST_F(LightTest, OcclusionOfParallelPlanes)
{
  this->LookUnderALid(White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 16384;
  this->settings.width = this->settings.height = 1;
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

  // The light's strength multiplies what is left.
  this->settings.lightIntensity = 0.5f;
  this->settings.samples = 4;
  this->Trace();
  EXPECT_FLOAT_EQ(this->PixelMean(0, 0).r, 0.5f);
}

// The sky's light on a plane: of 1 + s.d from each direction d, 1 + 2/3 s.n times pi; and of that what the albedo's
// limit leaves, which colors that stand for values lack. Ambient occlusion mixes it with the view's lights.
TEST_F(LightTest, SkyOfTwoHalves)
{
  const auto id = this->Add(Shape::Box, { { 0, -0.5f, 0 } }, { { 100.0f, 1.0f, 100.0f } }, White());
  this->camera = this->LookFrom({ 0, 5, 0.5 }, { 0, 0, 0 });
  const rtg::GlyphColors white(std::vector<std::uint32_t>{ 0xffffffffu });
  this->settings.samples = 64;
  const double samples = 24.0 * 24.0 * this->settings.samples;
  const auto seen = [this] { return this->Trace(), this->ErrorOf(0.0).mean; };
  for (const Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->settings.lightFraction = 0.0f;
    this->settings.albedoLimit = 1.0f;
    // A sample varies by the slope's part, path tracing's also by Burley's weights.
    const double interval = certain * (shading == Shading::PathTracing ? 0.6 : 0.3) / std::sqrt(samples);
    for (const glm::vec3& slope : { glm::vec3(0, 0.75f, 0), glm::vec3(0, -0.75f, 0), glm::vec3(0.6f, 0.6f, 0) })
    {
      this->settings.skySlope = slope;
      EXPECT_NEAR(seen(), 1.0 + 2.0 / 3.0 * slope.y, interval) << slope.x << ' ' << slope.y;
    }
    this->settings.skySlope = glm::vec3(0.0f);
    this->settings.albedoLimit = 0.8f;
    EXPECT_NEAR(seen(), 0.8, interval);
    this->scene.SetColors(id, white);
    EXPECT_NEAR(seen(), 1.0, interval);
    this->scene.SetColors(id, {});
  }

  // The plane faces the headlight by the cosine c between its normal and the view's axis, as a display color.
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.albedoLimit = 1.0f;
  this->settings.lightFraction = 0.25f;
  this->lights = { rtg::Light() };
  const float cosine = 5.0f / std::sqrt(25.25f);
  EXPECT_NEAR(seen(), 0.75 + 0.25 * rtg::shading::DisplayToLinear(glm::vec3(cosine)).x, 1e-5);
}

// Beside the edge of a roof a light of angular radius r shines with the part of its disc that the edge leaves over: at
// an angle a beyond it that is 1/2 + (u sqrt(1 - u^2) + asin u) / pi with u = a / r.
TEST_F(LightTest, LightsOfSomeWidthHavePenumbras)
{
  this->Add(Shape::Box, { { 0, -0.5f, 0 } }, { { 100.0f, 1.0f, 100.0f } }, White());
  // Its edge is at x = 0, 1 above the floor; the light shines straight down.
  this->Add(Shape::Box, { { -25.0f, 1.0f + 5e-4f, 0 } }, { { 50.0f, 1e-3f, 100.0f } }, White());
  rtg::Light light;
  light.kind = rtg::Light::Kind::Directional;
  light.direction = { 0, -1, 0 };
  light.angularRadius = 5.0f;
  this->lights = { light };
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 1;
  this->settings.lightIntensity = 0.0f;
  this->settings.samples = 4096;
  this->settings.width = 25;
  this->settings.height = 1;
  // A row of pixels along x on the floor, seen from the side below the roof.
  const double half = 1.25 * std::tan(glm::radians(5.0));
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-half, half, -1e-4, 1e-4, 0.01, 20.0) *
    glm::lookAt(glm::dvec3(0, 0.4, 5), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  this->Trace();
  double lit = 0.0;
  for (int x = 0; x < 25; ++x)
  {
    double expected = 0.0; // mean over the pixel's width
    for (int i = 0; i < 64; ++i)
    {
      const double u =
        glm::clamp(std::atan(half * (2.0 * (x + (i + 0.5) / 64.0) / 25.0 - 1.0)) / glm::radians(5.0), -1.0, 1.0);
      expected += (0.5 + (u * std::sqrt(1.0 - u * u) + std::asin(u)) / glm::pi<double>()) / 64.0;
    }
    const float found = this->PixelMean(x, 0).r;
    lit = x == 0 ? this->PixelMean(24, 0).r : lit; // what no edge is before
    const double interval = certain * std::sqrt(expected * (1.0 - expected) / this->settings.samples);
    EXPECT_NEAR(found / lit, expected, interval + 2e-3)
      << x; // the cosine over the disc, and the flat disc of the formula
  }
  EXPECT_GT(lit, 0.7);
}

// Convex things alone hide nothing from themselves, wherever they lie and however they are seen.
TEST_F(LightTest, NothingShadowsItself)
{
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 64;
  for (Shape shape : { Shape::Sphere, Shape::Box, Shape::Cylinder, Shape::Capsule, Shape::RoundCone, Shape::Cone })
  {
    for (const glm::vec3& size :
      { glm::vec3(1.0f), glm::vec3(1e-3f), glm::vec3(1.0f, 0.01f, 0.3f), glm::vec3(0.01f, 1.0f, 1.0f) })
    {
      for (float where : { 0.0f, 900.0f })
      {
        const glm::vec4 turn = glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f));
        const auto id = this->Add(shape, { { where, 0, 0 } }, { size }, White(), { turn });
        const double extent = std::max({ size.x, size.y, size.z });
        this->camera =
          this->LookFrom(glm::dvec3(where, 0, 0) + glm::dvec3(0, 0, 5), glm::dvec3(where, 0, 0), 0.7 * extent);
        this->Trace();
        const std::vector<glm::vec3> radiances = this->Radiances();
        ASSERT_GE(radiances.size(), 20u) << static_cast<int>(shape) << ' ' << size.x << ' ' << size.y << ' ' << where;
        for (const glm::vec3& radiance : radiances)
        {
          ASSERT_EQ(radiance.r, 1.0f) << static_cast<int>(shape) << ' ' << size.x << ' ' << size.y << ' ' << where;
        }
        this->scene.Remove(id);
      }
    }
  }
}

// Inside a sphere no light comes in. What roulette guesses of it after the first scattering is taken back on average.
TEST_F(LightTest, InsideIsDark)
{
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(4.0f) }, White());
  this->camera = this->LookFrom({ 0, 0, 1 });
  this->settings.maximumBounces = 1;
  for (Shading shading : { Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->Trace();
    for (const glm::vec4& mean : this->tracer.Means())
    {
      ASSERT_EQ(mean, glm::vec4(0, 0, 0, 1));
    }
  }
  this->settings.maximumBounces = 10;
  this->settings.samples = 64;
  this->Trace();
  const Error error = this->ErrorOf(0.0);
  const double interval = certain * std::sqrt(error.square / (24.0 * 24.0));
  EXPECT_NEAR(error.mean, 0.0, interval);
  EXPECT_LT(interval, 0.01);
}

// A view's light on a white plane: what local shading shows, to a matt surface, is what path tracing must converge to
// when nothing else shines.
TEST_F(LightTest, DirectionalLightShinesOnAPlaneAsLocally)
{
  rtg::Material gray;
  gray.color = glm::vec3(0.5f);
  gray.roughness = 0.0f;
  this->Add(Shape::Box, { { 0, 0, -0.5f } }, { { 100.0f, 100.0f, 1.0f } }, gray);
  rtg::Light light;
  light.kind = rtg::Light::Kind::Directional;
  light.direction = glm::normalize(glm::vec3(0.3f, 0.2f, -1.0f));
  light.color = glm::vec3(0.8f, 0.6f, 0.4f);
  this->lights = { light, light };
  this->settings.shading = Shading::PathTracing;
  this->settings.lightIntensity = 0.0f;
  this->settings.samples = 16;
  this->Trace();
  const rtg::shading::Surface surface = { glm::vec3(0.214041f), 0, 0, 0, glm::vec3(1), 0, 0, 0, glm::vec3(1) };
  const glm::vec3 from(0, 0, 1), to = -light.direction;
  const glm::vec3 expected = 2.0f * glm::pi<float>() * light.color * rtg::shading::Evaluate(surface, from, to, {});
  // Burley's smooth diffuse differs from Lambert's by the normal's view factor only: near 0.5^2.2 * 2 * cos.
  EXPECT_NEAR(expected.r / (2 * 0.214041 * 0.8 * to.z), 1.0, 0.06);
  const std::vector<glm::vec3> radiances = this->Radiances();
  EXPECT_EQ(radiances.size(), 24u * 24u);
  for (const glm::vec3& radiance : radiances)
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
  this->Add(Shape::Box, { { 0, -1.0f, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, White());
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
  const auto add = [this](float z, glm::vec3 color, float opacity)
  {
    rtg::Material material;
    material.color = color;
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
  std::vector<glm::vec3> centers;
  for (int i = 0; i < 200; ++i)
  {
    centers.emplace_back(0.0f, 0.0f, -0.01f * i);
  }
  rtg::Material thin;
  thin.lighting = false;
  thin.opacity = 0.004f;
  this->Add(Shape::Box, centers, std::vector<glm::vec3>(200, glm::vec3(10, 10, 0.005f)), thin);
  this->Trace(rtg::Pass::Translucent);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    ASSERT_NEAR(mean.a, 1.0 - std::pow(0.996, 256), 1e-4);
  }
}
