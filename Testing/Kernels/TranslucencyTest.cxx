// What shines through translucent glyphs: every layer counts once, however far away the camera is and however many
// glyphs there are.
#include "BoxMesh.h"
#include "LightFixture.h"

#include "SceneState.h"

#include <algorithm>
#include <functional>

namespace rtg
{
// Names the parameter in lists of tests.
static void PrintTo(Structure structure, std::ostream* out)
{
  *out << (structure == Structure::Boxes ? "Boxes" : "Tree");
}
} // namespace rtg

namespace
{

using namespace light;

constexpr float opacity = 0.3f;

class TranslucencyTest : public rtg::testing::WithStructure<LightTest>
{
protected:
  void SetUp() override
  {
    this->WithStructure::SetUp();
    this->settings.keepSums = false;
  }

  void AddBalls(const std::vector<glm::vec3>& centers, float size)
  {
    rtg::GlyphInstances instances;
    instances.centers = centers;
    instances.uniformSize = size;
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    rtg::Material material;
    material.opacity = opacity;
    this->scene.SetMaterial(id, material);
  }

  // A perspective view along -z of a square of that width about the world's origin.
  void LookFromFar(double distance, double width)
  {
    const double nearPlane = std::max(distance - 4.0 * width, 0.5 * distance);
    this->camera = rtg::Camera::FromWorldToClip(
      glm::perspective(2.0 * std::atan(0.5 * width / distance), 1.0, nearPlane, distance + 4.0 * width) *
      glm::lookAt(glm::dvec3(0, 0, distance), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  }

  // Of a channel, over the last image's pixels.
  double Mean(int channel) const
  {
    double sum = 0.0;
    const std::vector<glm::vec4> means = this->tracer.Means();
    for (const glm::vec4& pixel : means)
    {
      sum += pixel[channel];
    }
    return sum / static_cast<double>(means.size());
  }

  glm::dvec2 PixelCenter(std::size_t at) const
  {
    return { (at % this->settings.width + 0.5) / this->settings.width * 2.0 - 1.0,
      (at / this->settings.width + 0.5) / this->settings.height * 2.0 - 1.0 };
  }
};

} // namespace

TEST_P(TranslucencyTest, BothSidesOfABallShowAtEveryDistance)
{
  this->AddBalls({ { 0, 0, 0 } }, 1.0f);
  this->settings.width = this->settings.height = 40;
  this->settings.keepSums = true;
  const float both = 1.0f - (1.0f - opacity) * (1.0f - opacity);
  for (double distance = 10.0; distance < 2e6; distance *= 10.0)
  {
    this->LookFromFar(distance, 1.2);
    for (Shading shading : { Shading::Local, Shading::AmbientOcclusion })
    {
      this->settings.shading = shading;
      this->settings.samples = 1;
      this->Trace(rtg::Pass::Translucent);
      std::size_t covered = 0, wrong = 0;
      for (const glm::vec4& mean : this->tracer.Means())
      {
        covered += mean.a > 0.0f;
        wrong += mean.a > 0.0f && std::abs(mean.a - both) > 1e-5f;
      }
      EXPECT_GT(covered, 600u);
      EXPECT_EQ(wrong, 0u) << "of " << covered << " pixels, camera " << distance << " glyph sizes away";
    }
    // Path tracing stops at each side by chance.
    this->settings.shading = Shading::PathTracing;
    this->settings.samples = 64;
    this->LookFromFar(distance, 0.2);
    this->Trace(rtg::Pass::Translucent);
    EXPECT_NEAR(this->Mean(3), both, certain * std::sqrt(both * (1.0 - both) / (40.0 * 40.0 * 64.0)))
      << "camera " << distance << " glyph sizes away";
  }
}

// Of two faces of opacity a half, three quarters of a path tracer's camera rays stop at one, and a quarter of the light
// from behind them arrives.
TEST_P(TranslucencyTest, BoxesAreMetByChance)
{
  rtg::Material half;
  half.opacity = 0.5f;
  this->settings.keepSums = true;
  this->settings.samples = 16;
  const double rays = 24.0 * 24.0 * 16.0;
  const auto floor = this->Add(Shape::Box, { { 0, -1.0f, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, White());
  for (const Shape shape : { Shape::Box, Shape::Mesh })
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.mesh = std::make_shared<rtg::TriangleMesh>(rtg::testing::BoxMesh());
    instances.centers = { glm::vec3(0.0f) };
    instances.sizes3 = { { 1000.0f, 0.1f, 1000.0f } };
    const auto roof = this->scene.Add();
    this->scene.SetInstances(roof, instances);
    this->scene.SetMaterial(roof, half);
    this->camera = this->LookFrom({ 0, 5, 0.5 }, { 0, 0, 0 });

    this->settings.shading = Shading::AmbientOcclusion;
    this->Trace(rtg::Pass::Opaque);
    EXPECT_NEAR(this->Mean(0), 0.25, certain * std::sqrt(0.25 * 0.75 / rays)) << "shape " << static_cast<int>(shape);

    this->scene.SetVisible(floor, false);
    this->settings.shading = Shading::PathTracing;
    this->Trace(rtg::Pass::All);
    EXPECT_NEAR(this->Mean(3), 0.75, certain * std::sqrt(0.25 * 0.75 / rays)) << "shape " << static_cast<int>(shape);
    this->scene.SetVisible(floor, true);
    this->scene.Remove(roof);
  }
}

// A ball in a shell, in the same light from everywhere. The shell's front sees all of the sky; from the ball, and from
// the shell's far side beside it, the shell lets a part through, and the ball hides (r / R)^2 of the cosine-weighted
// hemisphere.
TEST_P(TranslucencyTest, TheSkyShinesThroughShells)
{
  constexpr double inner = 0.25, outer = 1.0, through = 1.0 - opacity;
  this->Add(Shape::Sphere, { { 0, 0, 0 } }, { glm::vec3(2.0 * inner) }, White());
  this->AddBalls({ { 0, 0, 0 } }, 2.0f * outer);
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.keepSums = true;
  this->settings.occlusionRays = 8;
  this->settings.samples = 16;
  // Of all layers together, no more than of an opaque one.
  const double error = certain * 0.5 / std::sqrt(24.0 * 24.0 * 16.0 * 8.0);
  this->camera = this->LookFrom({ 0, 0, 5 }, { 0, 0, 0 }, 0.5 * inner);
  this->Trace(rtg::Pass::Opaque);
  EXPECT_NEAR(this->Mean(0), through, error);
  this->Trace(rtg::Pass::Translucent);
  EXPECT_NEAR(this->Mean(0), opacity, error);
  this->camera = this->LookFrom({ 0.6, 0, 5 }, { 0.6, 0, 0 }, 0.1);
  this->Trace(rtg::Pass::Translucent);
  EXPECT_NEAR(this->Mean(3), 1.0 - through * through, 1e-5);
  const double farSide = through * (1.0 - inner * inner / (outer * outer));
  EXPECT_NEAR(this->Mean(0), opacity + through * opacity * farSide, error);
}

// A triangle is met once by each ray, however large the surface is and however near to its edge the ray enters.
TEST_P(TranslucencyTest, ASurfaceOfAnyExtentCountsOnce)
{
  this->settings.width = this->settings.height = 40;
  this->settings.keepSums = true;
  for (const float extent : { 1.0f, 1e3f, 1e6f })
  {
    constexpr glm::uint side = 24;
    rtg::TriangleMesh sheet;
    for (glm::uint i = 0; i <= side; ++i)
    {
      for (glm::uint k = 0; k <= side; ++k)
      {
        const glm::vec2 at = glm::vec2(i, k) / float(side) - 0.5f;
        sheet.positions.push_back(extent * glm::vec3(at, 0.2f * std::sin(5.0f * at.x) * std::cos(4.0f * at.y)));
      }
    }
    for (glm::uint i = 0; i < side * side; ++i)
    {
      const glm::uint a = i / side * (side + 1) + i % side;
      sheet.triangles.push_back({ a, a + side + 1, a + 1 });
      sheet.triangles.push_back({ a + 1, a + side + 1, a + side + 2 });
    }
    rtg::GlyphInstances instances;
    instances.shape = Shape::Mesh;
    instances.mesh = rtg::testing::Share(std::move(sheet));
    instances.centers = { glm::vec3(0.0f) };
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, instances);
    rtg::Material material;
    material.opacity = opacity;
    this->scene.SetMaterial(id, material);
    const double half = 0.4 * extent;
    this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-half, half, -half, half, 0.1 * extent, 9.0 * extent) *
      glm::lookAt(glm::dvec3(1e-3, 2e-3, 5.0) * double(extent), glm::dvec3(0), glm::dvec3(0, 1, 0)));
    this->settings.shading = Shading::Local;
    this->settings.samples = 1;
    this->Trace(rtg::Pass::Translucent);
    float least = 1.0f, most = 0.0f;
    for (const glm::vec4& mean : this->tracer.Means())
    {
      least = std::min(least, mean.a);
      most = std::max(most, mean.a);
    }
    EXPECT_NEAR(least, opacity, 1e-5f) << "extent " << extent;
    EXPECT_NEAR(most, opacity, 1e-5f) << "extent " << extent;
    this->settings.shading = Shading::PathTracing;
    this->settings.samples = 16;
    this->Trace(rtg::Pass::Translucent);
    EXPECT_NEAR(this->Mean(3), opacity, certain * std::sqrt(opacity * (1.0 - opacity) / (40.0 * 40.0 * 16.0)))
      << "extent " << extent;
    this->scene.Remove(id);
  }
}

// Triangles of one surface behind each other stop what their opacities say, and none of opacity zero stops anything.
TEST_P(TranslucencyTest, ManyTrianglesOfASurfaceAreNoWall)
{
  constexpr glm::uint layers = 300;
  rtg::TriangleMesh stack;
  for (glm::uint i = 0; i < layers; ++i)
  {
    const float z = -1.0f + 2.0f * float(i) / layers;
    stack.positions.insert(stack.positions.end(), { { -1, -1, z }, { 3, -1, z }, { -1, 3, z } });
    stack.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  rtg::GlyphInstances instances;
  instances.shape = Shape::Mesh;
  instances.mesh = rtg::testing::Share(std::move(stack));
  instances.centers = { glm::vec3(0.0f) };
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  this->camera = rtg::Camera::FromWorldToClip(
    glm::ortho(-0.9, 0.9, -0.9, 0.9, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  this->settings.width = this->settings.height = 12;
  this->settings.keepSums = true;
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 1;
  this->settings.samples = 16;
  for (const float each : { 0.0f, 0.002f })
  {
    rtg::Material material;
    material.opacity = each;
    this->scene.SetMaterial(id, material);
    this->Trace(rtg::Pass::All);
    const double exact = 1.0 - std::pow(1.0 - each, layers);
    EXPECT_NEAR(this->Mean(3), exact, certain * std::sqrt(exact * (1.0 - exact) / (12.0 * 12.0 * 16.0)))
      << "opacity " << each;
  }
}

// Opacities of glyphs are as the alphas of their colors would be, of balls and of copies of a mesh.
TEST_P(TranslucencyTest, GlyphsHaveTheirOwnOpacities)
{
  std::vector<float> opacities;
  std::vector<std::uint32_t> colors;
  for (std::uint32_t i = 0; i < 60; ++i)
  {
    const std::uint32_t alpha = 255 - 4 * i;
    opacities.push_back(static_cast<float>(alpha) / 255.0f);
    colors.push_back(alpha << 24 | 0xffffffu);
  }
  rtg::GlyphInstances balls;
  balls.centers = Clutter(3, 60);
  balls.uniformSize = 0.4f;
  rtg::GlyphInstances boxes = balls;
  boxes.shape = Shape::Mesh;
  boxes.mesh = std::make_shared<rtg::TriangleMesh>(rtg::testing::BoxMesh());
  for (rtg::GlyphInstances& instances : { std::ref(balls), std::ref(boxes) })
  {
    const auto id = this->scene.Add();
    rtg::Material material;
    material.opacity = 0.8f;
    this->scene.SetMaterial(id, material);
    this->settings.keepSums = true;
    std::vector<glm::vec4> byColor[2], byOpacity[2];
    for (const bool own : { false, true })
    {
      instances.opacities = own ? opacities : std::vector<float>();
      this->scene.SetInstances(id, instances);
      this->scene.SetColors(id, own ? std::vector<std::uint32_t>() : colors);
      EXPECT_TRUE(this->scene.GetState().Shows(true));
      for (const Shading shading : { Shading::Local, Shading::PathTracing })
      {
        this->settings.shading = shading;
        this->Trace(rtg::Pass::Translucent);
        (own ? byOpacity : byColor)[shading == Shading::Local] = this->tracer.Means();
      }
    }
    for (const int shading : { 0, 1 })
    {
      std::size_t covered = 0, wrong = 0;
      for (std::size_t at = 0; at < byColor[shading].size(); ++at)
      {
        covered += byColor[shading][at].a > 0.0f;
        wrong += glm::length(byColor[shading][at] - byOpacity[shading][at]) > 1e-4f;
      }
      EXPECT_GT(covered, 200u);
      EXPECT_EQ(wrong, 0u) << "of " << covered << " pixels";
    }
    this->scene.Remove(id);
  }
}

TEST_P(TranslucencyTest, EveryLayerOfACrowdCountsOnce)
{
  constexpr float radius = 0.02f;
  std::vector<glm::vec3> centers = Clutter(5, 20000);
  // Many balls lie twice at one place.
  centers.insert(centers.end(), centers.begin(), centers.begin() + 5000);
  this->AddBalls(centers, 2.0f * radius);
  this->settings.width = this->settings.height = 60;
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-0.7, 0.7, -0.7, 0.7, 1.0, 100.0) *
    glm::lookAt(glm::dvec3(0, 0, 50), glm::dvec3(0), glm::dvec3(0, 1, 0)));

  // The balls that the ray through a pixel's center meets, or -1 where it grazes one.
  std::vector<int> met(60 * 60, 0);
  for (std::size_t at = 0; at < met.size(); ++at)
  {
    const glm::dvec2 place = 0.7 * this->PixelCenter(at);
    for (const glm::vec3& center : centers)
    {
      const double off = glm::length(place - glm::dvec2(center)) / radius;
      if (std::abs(off - 1.0) < 1e-4)
      {
        met[at] = -1;
        break;
      }
      met[at] += off < 1.0;
    }
  }

  for (Shading shading : { Shading::Local, Shading::AmbientOcclusion })
  {
    this->settings.shading = shading;
    this->settings.keepSums = true;
    this->Trace(rtg::Pass::Translucent);
    const std::vector<glm::vec4> means = this->tracer.Means();
    std::size_t judged = 0, wrong = 0;
    for (std::size_t at = 0; at < met.size(); ++at)
    {
      judged += met[at] > 0;
      // What shines through by less than half a level of a display's 255 is left out.
      wrong += met[at] >= 0 && std::abs(means[at].a - (1.0 - std::pow(1.0 - opacity, 2 * met[at]))) > 1.0 / 512.0;
    }
    EXPECT_GT(judged, 3000u);
    EXPECT_EQ(wrong, 0u) << "of " << judged << " pixels";
  }

  // Path tracing: the mean over rays beside each other, of a place that is not nearly opaque.
  const auto thin = std::find(met.begin(), met.end(), 3) - met.begin();
  ASSERT_LT(std::size_t(thin), met.size());
  const glm::dvec2 place = 0.7 * this->PixelCenter(thin);
  const double half = 1e-7;
  this->camera = rtg::Camera::FromWorldToClip(
    glm::ortho(place.x - half, place.x + half, place.y - half, place.y + half, 1.0, 100.0) *
    glm::lookAt(glm::dvec3(0, 0, 50), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  this->settings.shading = Shading::PathTracing;
  this->settings.samples = 16;
  this->Trace(rtg::Pass::Translucent);
  const double expected = 1.0 - std::pow(1.0 - opacity, 6);
  EXPECT_NEAR(this->Mean(3), expected, certain * std::sqrt(expected * (1.0 - expected) / (60.0 * 60.0 * 16.0)));
}

// Many more layers show than one traversal gathers, each glyph has an opacity of its own, and what is opaque ends them.
TEST_P(TranslucencyTest, ThinLayersOfACrowdCountOnceUpToAWall)
{
  constexpr float radius = 0.02f;
  std::vector<glm::vec3> centers = Clutter(6, 20000);
  this->AddBalls(centers, 2.0f * radius);
  std::vector<std::uint32_t> colors(centers.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    colors[i] = 0xffffffu | std::uint32_t(i % 60) << 24;
  }
  this->scene.SetMaterial(0, White());
  this->settings.width = this->settings.height = 60;
  this->settings.keepSums = true;
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-0.7, 0.7, -0.7, 0.7, 1.0, 100.0) *
    glm::lookAt(glm::dvec3(0, 0, 50), glm::dvec3(0), glm::dvec3(0, 1, 0)));

  const float wallZ = -0.3f;
  for (const bool wall : { false, true })
  {
    if (wall)
    {
      this->Add(Shape::Box, { { 0, 0, wallZ - 1.0f } }, { glm::vec3(2, 2, 2) }, White());
    }
    this->scene.SetColors(0, colors);
    this->settings.shading = Shading::Local;
    this->Trace(rtg::Pass::Translucent);
    const std::vector<glm::vec4> means = this->tracer.Means();
    std::size_t judged = 0, wrong = 0, deep = 0;
    for (std::size_t at = 0; at < means.size(); ++at)
    {
      const glm::dvec2 place = 0.7 * this->PixelCenter(at);
      double transmittance = 1.0;
      unsigned layers = 0;
      bool unclear = false;
      for (std::size_t i = 0; i < centers.size(); ++i)
      {
        const double off = glm::length(place - glm::dvec2(centers[i])) / radius;
        unclear |= std::abs(off - 1.0) < 1e-4;
        const double half = off < 1.0 ? radius * std::sqrt(1.0 - off * off) : -1.0;
        for (const double z : { centers[i].z + half, centers[i].z - half })
        {
          if (half >= 0.0 && (!wall || z > wallZ))
          {
            transmittance *= 1.0 - (colors[i] >> 24) / 255.0;
            ++layers;
          }
        }
      }
      judged += !unclear;
      deep += layers > 24;
      wrong += !unclear && std::abs(means[at].a - (1.0 - transmittance)) > 1.0 / 512.0;
    }
    EXPECT_GT(judged, 3000u);
    EXPECT_GT(deep, wall ? 50u : 500u);
    EXPECT_EQ(wrong, 0u) << "of " << judged << " pixels" << (wall ? " before a wall" : "");
  }
}

// What rays meet does not depend on what finds it: layers, coincident ones among them, triangles, light.
TEST_F(LightTest, BoxesAndTreesGiveTheSameImages)
{
  RTG_NEEDS(rtg::Structure::Boxes);
  RTG_NEEDS(rtg::Structure::Tree);
  this->settings.width = this->settings.height = 60;
  this->settings.samples = 4;
  this->camera = LookFrom({ 1.0, 2.0, 4.0 });
  this->lights.resize(1);
  rtg::Material thin;
  thin.opacity = opacity;
  std::vector<glm::vec3> places = Clutter(8, 400);
  places.insert(places.end(), places.begin(), places.begin() + 100);
  std::vector<glm::vec4> images[2][3];
  for (const rtg::Structure structure : { rtg::Structure::Boxes, rtg::Structure::Tree })
  {
    this->scene.GetState().structure = structure;
    const auto balls = this->Add(Shape::Sphere, places, std::vector<glm::vec3>(500, glm::vec3(0.2f)), thin);
    const auto solid = this->Add(Shape::Superquadric, Clutter(9, 100), std::vector<glm::vec3>(100, glm::vec3(0.3f)),
      White(), std::vector<glm::vec4>(100, glm::normalize(glm::vec4(1, 2, 3, 4))));
    rtg::GlyphInstances copies;
    copies.shape = Shape::Mesh;
    copies.mesh = rtg::testing::Share(rtg::testing::BoxMesh());
    copies.centers = Clutter(10, 50);
    copies.uniformSize = 0.3f;
    copies.rotations.assign(50, glm::normalize(glm::vec4(4, 1, 2, 3)));
    const auto meshes = this->scene.Add();
    this->scene.SetInstances(meshes, copies);
    this->scene.SetMaterial(meshes, thin);
    auto* image = images[structure == rtg::Structure::Tree];
    for (const rtg::Pass pass : { rtg::Pass::Opaque, rtg::Pass::Translucent })
    {
      this->settings.shading = Shading::Local;
      this->Trace(pass);
      *image++ = this->tracer.Means();
    }
    this->scene.SetVisible(balls, false);
    this->scene.SetVisible(meshes, false);
    this->settings.shading = Shading::PathTracing;
    this->Trace();
    *image = this->tracer.Means();
    for (const auto id : { balls, solid, meshes })
    {
      this->scene.Remove(id);
    }
  }
  for (std::size_t i = 0; i < std::size(images[0]); ++i)
  {
    EXPECT_GT(
      std::count_if(images[0][i].begin(), images[0][i].end(), [](const glm::vec4& m) { return m.a > 0.0f; }), 500);
    EXPECT_EQ(std::mismatch(images[0][i].begin(), images[0][i].end(), images[1][i].begin()).first, images[0][i].end())
      << "image " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Structures, TranslucencyTest, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree),
  [](const auto& info) { return ::testing::PrintToString(info.param); });
