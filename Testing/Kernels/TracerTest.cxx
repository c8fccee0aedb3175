// Scene and Tracer on the machine's Vulkan device: what an image holds and what work is done for it.
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/DeviceState.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

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

using rtg::Image;

class TracerTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer* tracer = &rtg::testing::SharedTracer();
  rtg::TraceSettings settings;
  std::vector<rtg::Light> lights{ rtg::Light() };
  rtg::Camera camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * this->LookFrom(5.0));

  void SetUp() override { this->settings.width = this->settings.height = 100; }

  // Of pipelines and memory this test alone shall count.
  void UseOwnTracer()
  {
    this->own_ = std::make_unique<rtg::Tracer>(this->device);
    this->tracer = this->own_.get();
  }

  static glm::dmat4 LookFrom(double z) { return glm::lookAt(glm::dvec3(0, 0, z), glm::dvec3(0), glm::dvec3(0, 1, 0)); }

  rtg::Scene::SetId AddSpheres(const std::vector<glm::vec3>& centres, float size)
  {
    const auto id = this->scene.Add();
    rtg::GlyphInstances instances;
    instances.centres = centres;
    instances.uniformSize = size;
    this->scene.SetInstances(id, instances);
    return id;
  }

  Image Trace(rtg::Pass pass = rtg::Pass::Opaque)
  {
    this->scene.Commit();
    return this->tracer->Trace(this->scene, this->camera, this->lights, this->settings, pass);
  }

  static double Coverage(const Image& image)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::size_t(image.width) * image.height; ++i)
    {
      sum += (image.colour[i] >> 24) / 255.0;
    }
    return sum / (double(image.width) * image.height);
  }

private:
  std::unique_ptr<rtg::Tracer> own_;
};

// With the driver's structure, as on GPUs, and with our tree, as on CPU devices.
class StructureTest
  : public TracerTest
  , public ::testing::WithParamInterface<rtg::Structure>
{
protected:
  void SetUp() override
  {
    RTG_NEEDS(GetParam());
    this->TracerTest::SetUp();
    this->scene.GetState().structure = GetParam();
  }
};

std::vector<glm::vec3> RandomPoints(std::size_t count)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-0.9f, 0.9f);
  std::vector<glm::vec3> points(count);
  for (auto& p : points)
  {
    p = { uniform(random), uniform(random), uniform(random) };
  }
  return points;
}

} // namespace

TEST_P(StructureTest, SphereCoversExactlyThePixelsWhoseCentresItCovers)
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
    instances.centres.emplace_back(-1.0f + cell * (i % side + 0.5f), -1.0f + cell * (i / side + 0.5f), 0.0f);
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
      const double x = std::abs(px - instances.centres[glyph].x) / halfSize;
      const double y = std::abs(py - instances.centres[glyph].y) / halfSize;
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

TEST_F(TracerTest, ExponentsOfOtherShapesAreNotKept)
{
  rtg::GlyphInstances instances;
  instances.centres = RandomPoints(1000);
  instances.uniformSize = 0.1f;
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  const std::uint64_t without = this->scene.GetStatistics().deviceBytes;
  instances.exponents3.assign(1000, glm::vec3(2.0f));
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  EXPECT_EQ(this->scene.GetStatistics().deviceBytes, without);
  instances.shape = rtg::Shape::Superquadric;
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  EXPECT_GE(this->scene.GetStatistics().deviceBytes, without + 12000u);
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

TEST_P(StructureTest, HeadlightShadesAsVtkDoes)
{
  const auto id = this->AddSpheres({ { 0.0f, 0.0f, 0.0f } }, 1.8f);
  rtg::Material material;
  material.colour = { 0.8f, 0.4f, 0.2f };
  material.ambientColour = { 0.2f, 0.9f, 1.0f };
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
    const std::uint32_t colour = image.colour[50 * 100 + x];
    for (int channel = 0; channel < 3; ++channel)
    {
      const double expected =
        material.ambientColour[channel] * 0.1 + material.colour[channel] * 0.7 * nz + 0.3 * std::pow(nz, 20.0);
      EXPECT_NEAR((colour >> (8 * channel)) & 255, 255.0 * std::min(expected, 1.0), 1.0) << x;
    }
  }
}

TEST_P(StructureTest, EachGlyphShowsItsOwnColourAndId)
{
  const std::vector<glm::vec3> centres = { { -0.5f, -0.5f, 0 }, { 0.5f, -0.5f, 0 }, { -0.5f, 0.5f, 0 },
    { 0.5f, 0.5f, 0 }, { 0.0f, 0.0f, 0.2f } };
  const auto id = this->AddSpheres(centres, 0.5f);
  const std::vector<std::uint32_t> colours = { 0xff0000ff, 0xff00ff00, 0xffff0000, 0xff00ffff, 0xffff00ff };
  this->scene.SetColours(id, colours);
  rtg::Material material;
  material.lighting = false;
  this->scene.SetMaterial(id, material);
  const Image image = this->Trace();
  for (std::size_t i = 0; i < centres.size(); ++i)
  {
    const int x = static_cast<int>((centres[i].x + 1.0f) * 50.0f);
    const int y = static_cast<int>((centres[i].y + 1.0f) * 50.0f);
    EXPECT_EQ(image.colour[y * 100 + x], colours[i]);
    EXPECT_EQ(this->scene.OriginalGlyph(id, image.glyphIds[y * 100 + x]), i);
    EXPECT_EQ(image.setIds[y * 100 + x], id);
  }
}

TEST_P(StructureTest, EveryStepRedoesOnlyWhatItsInputChanged)
{
  this->UseOwnTracer();
  const auto id = this->AddSpheres(RandomPoints(500), 0.1f);
  this->scene.SetColours(id, std::vector<std::uint32_t>(500, 0xff808080u));
  this->Trace();
  const rtg::Statistics first = this->scene.GetStatistics();
  const std::uint64_t pipelineBuilds = this->tracer->GetStatistics().pipelineBuilds;
  EXPECT_EQ(first.structureBuilds, 1u);
  EXPECT_EQ(first.instanceUploads, 1u);
  EXPECT_EQ(first.colourUploads, 1u);
  EXPECT_EQ(this->tracer->GetStatistics().primaryRays, 10000u);

  // Camera moved: trace only.
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * this->LookFrom(5.5));
  this->Trace();
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 1u);
  EXPECT_EQ(this->scene.GetStatistics().topLevelBuilds, first.topLevelBuilds);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 1u);
  EXPECT_EQ(this->scene.GetStatistics().colourUploads, 1u);
  EXPECT_EQ(this->tracer->GetStatistics().pipelineBuilds, pipelineBuilds);

  // Colours changed: colours only.
  this->scene.SetColours(id, std::vector<std::uint32_t>(500, 0xff8080ffu));
  this->Trace();
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 1u);
  EXPECT_EQ(this->scene.GetStatistics().topLevelBuilds, first.topLevelBuilds);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 1u);
  EXPECT_EQ(this->scene.GetStatistics().colourUploads, 2u);

  // Hidden and shown: sent again in the order that is known.
  this->scene.SetVisible(id, false);
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  this->scene.SetVisible(id, true);
  EXPECT_GT(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 2u);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 2u);
  EXPECT_EQ(this->scene.GetStatistics().sorts, first.sorts);
}

// As a further view does, or one that is made anew.
TEST_P(StructureTest, FurtherTracersCompileNothing)
{
  this->AddSpheres(RandomPoints(50), 0.1f);
  this->Trace();
  this->UseOwnTracer();
  EXPECT_GT(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->tracer->GetStatistics().pipelineBuilds, 0u);
}

TEST_P(StructureTest, WhatIsHiddenHoldsNoMemory)
{
  this->UseOwnTracer();
  this->AddSpheres(RandomPoints(100), 0.1f);
  this->Trace();
  const std::uint64_t alone = this->scene.GetStatistics().deviceBytes;
  const auto id = this->AddSpheres(RandomPoints(20000), 0.1f);
  this->scene.SetColours(id, std::vector<std::uint32_t>(20000, 0xff8080ffu));
  const Image image = this->Trace();
  const std::vector<std::uint32_t> shown(image.colour, image.colour + 10000);
  const std::uint64_t both = this->scene.GetStatistics().deviceBytes;
  EXPECT_GT(both, alone + 20000u * 16u);
  for (int i = 0; i < 3; ++i)
  {
    this->scene.SetVisible(id, false);
    this->Trace();
    EXPECT_LT(this->scene.GetStatistics().deviceBytes, alone + 10000u);
    this->scene.SetVisible(id, true);
    const Image again = this->Trace();
    EXPECT_EQ(this->scene.GetStatistics().deviceBytes, both);
    EXPECT_EQ(shown, std::vector<std::uint32_t>(again.colour, again.colour + 10000));
  }
}

TEST_P(StructureTest, DevicesWithMemoryOfTheirOwnShowTheSame)
{
  auto& vulkan = this->device->GetState();
  const bool shares = vulkan.sharesMemory;
  struct Seen
  {
    std::vector<std::uint32_t> colours, glyphs;
    std::vector<float> depths;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> means;
    std::vector<float> probes;
    std::uint64_t commit = 0, recolouring = 0;
    bool operator==(const Seen& other) const
    {
      return this->colours == other.colours && this->glyphs == other.glyphs && this->depths == other.depths &&
        this->normals == other.normals && this->means == other.means && this->probes == other.probes;
    }
  };
  const auto look = [&](bool own, bool empty)
  {
    vulkan.sharesMemory = !own;
    Seen seen;
    rtg::Scene scene(this->device);
    scene.GetState().structure = GetParam();
    rtg::Tracer tracer(this->device);
    rtg::Scene::SetId last = 0;
    for (unsigned set = 0; set < 3; ++set)
    {
      rtg::GlyphInstances instances;
      instances.centres = empty ? std::vector<glm::vec3>() : RandomPoints(200 + 50 * set);
      instances.uniformSize = 0.1f + 0.05f * set;
      last = scene.Add();
      scene.SetInstances(last, instances);
    }
    const std::uint64_t before = vulkan.submissions;
    scene.Commit();
    seen.commit = vulkan.submissions - before;
    scene.SetColours(last, std::vector<std::uint32_t>(scene.GlyphCount(last), 0xff4080c0u));
    const std::uint64_t between = vulkan.submissions;
    scene.Commit();
    seen.recolouring = vulkan.submissions - between;
    rtg::TraceSettings wanted = this->settings;
    wanted.width = 101; // images whose bytes are no round number
    wanted.features = wanted.keepSums = true;
    wanted.samples = 2;
    tracer.Trace(scene, this->camera, this->lights, wanted);
    wanted.firstSample = 2;
    const Image image = tracer.Trace(scene, this->camera, this->lights, wanted);
    const std::size_t pixels = 101 * 100;
    seen.colours.assign(image.colour, image.colour + pixels);
    seen.glyphs.assign(image.glyphIds, image.glyphIds + pixels);
    seen.depths.assign(image.depth, image.depth + pixels);
    seen.normals = image.normals;
    seen.means = tracer.Means();
    for (const auto& hit :
      tracer.TraceProbes(scene, { { { 0.1, 0.1, 5 }, { 0, 0, -1 } }, { { 9, 9, 9 }, { 0, 0, 1 } } }))
    {
      seen.probes.push_back(hit.t);
    }
    return seen;
  };
  for (const bool empty : { false, true })
  {
    const Seen shared = look(false, empty), own = look(true, empty);
    EXPECT_TRUE(shared == own) << empty;
    // All copies and builds of a commit are one submission.
    EXPECT_EQ(own.commit, empty ? 0u : 1u);
    EXPECT_EQ(own.recolouring, empty ? 0u : 1u);
  }
  vulkan.sharesMemory = shares;
}

TEST_F(TracerTest, ImagesAreLaunchedInPartsOnAGpuAlone)
{
  auto& vulkan = this->device->GetState();
  const bool cpu = vulkan.cpu;
  this->AddSpheres(RandomPoints(500), 0.2f);
  this->scene.Commit();
  rtg::Scene nothing(this->device);
  nothing.Commit();
  std::vector<std::uint32_t> images[2];
  for (const bool gpu : { false, true })
  {
    vulkan.cpu = !gpu;
    rtg::Tracer tracer(this->device);
    // What a launch leaves out shows what was there before.
    tracer.Trace(nothing, this->camera, this->lights, this->settings);
    const std::uint64_t before = vulkan.submissions;
    const Image image = tracer.Trace(this->scene, this->camera, this->lights, this->settings);
    // Of 169 tiles the first launch is one, the second eight.
    if (gpu)
    {
      EXPECT_GE(vulkan.submissions - before, 3u);
    }
    else
    {
      EXPECT_LE(vulkan.submissions - before, 2u);
    }
    images[gpu].assign(image.colour, image.colour + 10000);
  }
  vulkan.cpu = cpu;
  EXPECT_EQ(images[0], images[1]);
}

TEST_F(TracerTest, SetsThatAreNotThereAreNamed)
{
  const auto refused = [](const auto& work)
  {
    try
    {
      work();
      ADD_FAILURE();
    }
    catch (const rtg::Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(" 77"), std::string::npos) << error.what();
    }
  };
  refused([&] { this->scene.SetInstances(77, {}); });
  refused([&] { this->scene.SetColours(77, {}); });
  refused([&] { this->scene.SetMaterial(77, {}); });
  refused([&] { this->scene.SetVisible(77, false); });
  refused([&] { this->scene.GlyphCount(77); });
  refused([&] { this->scene.OriginalGlyph(77, 0); });
  this->scene.Remove(77);
  const auto id = this->AddSpheres(RandomPoints(50), 0.1f);
  this->scene.GetState().structure = rtg::Structure::Tree;
  this->scene.Commit();
  refused([&] { this->scene.OriginalGlyph(id, 77); });
}

TEST_P(StructureTest, SetsFarApartKeepTheirPlaces)
{
  // The second set's own origin is far from the first's, and its glyph sits back at the middle.
  this->AddSpheres({ { -0.5f, 0.0f, 0.0f } }, 0.5f);
  const auto far = this->scene.Add();
  rtg::GlyphInstances instances;
  instances.origin = { 1000.25, 0.0, 0.0 };
  instances.centres = { { -999.75f, 0.0f, 0.0f } };
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
  EXPECT_TRUE(this->scene.HasOpaque());
  EXPECT_TRUE(this->scene.HasTranslucent());
  Image image = this->Trace(rtg::Pass::Opaque);
  EXPECT_EQ(image.setIds[50 * 100 + 25], opaque);
  EXPECT_EQ(image.setIds[50 * 100 + 75], Image::noGlyph);
  image = this->Trace(rtg::Pass::Translucent);
  EXPECT_EQ(image.setIds[50 * 100 + 25], Image::noGlyph);
  EXPECT_EQ(image.setIds[50 * 100 + 75], translucent);
  // Its front and its back, as depth peeling shows them.
  EXPECT_NEAR(image.colour[50 * 100 + 75] >> 24, 0.75 * 255.0, 1.0);
}

TEST_P(StructureTest, SeveralStructuresOfOneSetGiveTheSameImage)
{
  const auto points = RandomPoints(1000);
  std::vector<std::uint32_t> colours;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    colours.push_back(0xff000000u | (i * 2654435761u >> 8));
  }
  const auto whole = this->AddSpheres(points, 0.2f);
  this->scene.SetColours(whole, colours);
  Image image = this->Trace();
  const std::vector<std::uint32_t> expected(image.colour, image.colour + 10000);
  const std::vector<std::uint32_t> ids(image.glyphIds, image.glyphIds + 10000);

  this->scene.Remove(whole);
  this->scene.GetState().glyphsPerRun = 150;
  const auto pieces = this->AddSpheres(points, 0.2f);
  this->scene.SetColours(pieces, colours);
  image = this->Trace();
  if (GetParam() == rtg::Structure::Boxes)
  {
    EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 1u + 7u);
  }
  EXPECT_EQ(expected, std::vector<std::uint32_t>(image.colour, image.colour + 10000));
  EXPECT_EQ(ids, std::vector<std::uint32_t>(image.glyphIds, image.glyphIds + 10000));
}

TEST_P(StructureTest, FindsTheNearestOfManyGlyphsOfAnyCount)
{
  // Against brute force, from counts that make the smallest trees, with even and odd depth, upwards.
  // Then so densely that rays drop what lies behind their hits.
  const std::pair<std::size_t, float> scenes[] = { { 1, 0.6f }, { 2, 0.6f }, { 3, 0.6f }, { 4, 0.6f }, { 5, 0.6f },
    { 7, 0.6f }, { 8, 0.6f }, { 9, 0.6f }, { 16, 0.6f }, { 17, 0.6f }, { 33, 0.6f }, { 100, 0.6f }, { 1000, 0.6f },
    { 1000, 4.0f }, { 4100, 4.0f }, { 33000, 1.5f } };
  for (const auto& [count, filling] : scenes)
  {
    const auto points = RandomPoints(count);
    const float size = filling / std::cbrt(static_cast<float>(count));
    const auto id = this->AddSpheres(points, size);
    this->scene.Commit();
    const auto& group = this->scene.GetState().sets.at(id).placed.group;
    EXPECT_EQ(group.Has(rtg::device::DROPS_HIDDEN), GetParam() == rtg::Structure::Tree && filling > 1.0f) << count;
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

/// Needles, whose boxes are large and mostly empty: rays meet many before they hit, and drop at every hit what is
/// behind it.
TEST_F(TracerTest, NeedlesInFrontAreNotDropped)
{
  RTG_NEEDS(rtg::Structure::Boxes);
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  rtg::GlyphInstances needles;
  needles.centres = RandomPoints(3000);
  needles.sizes3.assign(needles.centres.size(), glm::vec3(0.01f, 0.01f, 0.5f));
  for (std::size_t i = 0; i < needles.centres.size(); ++i)
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
    EXPECT_EQ(this->scene.GetState().sets.at(id).placed.group.Has(rtg::device::DROPS_HIDDEN),
      structure == rtg::Structure::Tree);
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

/// New instances near where the last ones were keep the order; others do not. The image is right all the same.
TEST_P(StructureTest, SortsOnlyWhenTheOrderHasDecayed)
{
  auto points = RandomPoints(4096); // one glyph a leaf: leaves alone would notice nothing
  const auto id = this->AddSpheres(points, 0.05f);
  const auto move = [&](float way, bool mixed)
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-way, way);
    for (glm::vec3& point : points)
    {
      point += glm::vec3(uniform(random), uniform(random), uniform(random));
    }
    if (mixed)
    {
      std::shuffle(points.begin(), points.end(), random);
    }
    rtg::GlyphInstances instances;
    instances.centres = points;
    instances.uniformSize = 0.05f;
    const auto sorts = this->scene.GetStatistics().sorts;
    this->scene.SetInstances(id, instances);
    const Image image = this->Trace();
    std::vector<std::uint32_t> found(image.glyphIds, image.glyphIds + 10000);
    for (std::uint32_t& glyph : found)
    {
      glyph = glyph == Image::noGlyph ? glyph : this->scene.OriginalGlyph(id, glyph);
    }
    const auto again = this->scene.GetStatistics().sorts - sorts;

    rtg::Scene fresh(this->device);
    fresh.GetState().structure = GetParam();
    const auto other = fresh.Add();
    fresh.SetInstances(other, instances);
    fresh.Commit();
    const Image expected = this->tracer->Trace(fresh, this->camera, this->lights, this->settings, rtg::Pass::Opaque);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const std::uint32_t glyph = expected.glyphIds[i];
      EXPECT_EQ(found[i], glyph == Image::noGlyph ? glyph : fresh.OriginalGlyph(other, glyph)) << i;
    }
    return again;
  };
  this->Trace();
  // Boxes on a GPU are sorted by its driver.
  const unsigned sorted = GetParam() == rtg::Structure::Tree || this->device->IsCpu() ? 1u : 0u;
  EXPECT_EQ(move(0.002f, false), 0u);
  EXPECT_EQ(move(0.002f, false), 0u);
  EXPECT_EQ(move(0.0f, true), sorted);
  EXPECT_EQ(move(0.3f, false), sorted);
  EXPECT_EQ(move(0.002f, false), 0u);
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

TEST_F(TracerTest, CoarseImageRepeatsEveryNthPixel)
{
  this->AddSpheres(RandomPoints(200), 0.2f);
  this->settings.width = 101; // not a multiple of the step
  this->settings.pixelStep = 3;
  const std::uint64_t before = this->tracer->GetStatistics().primaryRays;
  const Image image = this->Trace();
  for (std::size_t y = 0; y < 100; ++y)
  {
    for (std::size_t x = 0; x < 101; ++x)
    {
      ASSERT_EQ(image.colour[y * 101 + x], image.colour[y / 3 * 3 * 101 + x / 3 * 3]);
    }
  }
  EXPECT_GT(Coverage(image), 0.1);
  EXPECT_EQ(this->tracer->GetStatistics().primaryRays - before, 34u * 34u);
}

TEST_P(StructureTest, EmptyThingsAreFine)
{
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  const auto id = this->AddSpheres({}, 1.0f);
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->scene.GlyphCount(id), 0u);
  this->settings.width = 0;
  EXPECT_EQ(this->Trace().colour, nullptr);
  this->settings.width = this->settings.height = 1;
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  EXPECT_EQ(Coverage(this->Trace()), 1.0);
}

TEST_P(StructureTest, NothingStaysBehind)
{
  this->UseOwnTracer();
  const std::uint64_t before = this->scene.GetStatistics().deviceBytes;
  for (int i = 0; i < 20; ++i)
  {
    const auto id = this->AddSpheres(RandomPoints(1000), 0.1f);
    this->Trace();
    this->scene.Remove(id);
  }
  this->Trace();
  // What the tracer keeps for its next image is all that may remain.
  const std::uint64_t kept = this->scene.GetStatistics().deviceBytes - before;
  EXPECT_LT(kept, 1000000u);
  const auto id = this->AddSpheres(RandomPoints(1000), 0.1f);
  this->Trace();
  this->scene.Remove(id);
  this->Trace();
  EXPECT_EQ(this->scene.GetStatistics().deviceBytes - before, kept);
}

TEST_F(TracerTest, BadSettingsAreNamed)
{
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  this->settings.samples = 0;
  try
  {
    this->Trace();
    FAIL() << "no error";
  }
  catch (const rtg::Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("samples per pixel is 0"), std::string::npos) << error.what();
  }
  this->settings.samples = 1;
  this->settings.width = 100000;
  EXPECT_THROW(this->Trace(), rtg::Error);
  EXPECT_THROW(this->scene.SetColours(0, std::vector<std::uint32_t>(7, 0u)), rtg::Error);
}

TEST_F(TracerTest, ArraysOfWrongLengthsAreNamed)
{
  const auto message = [this](const auto& change)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Superquadric;
    instances.centres = RandomPoints(4);
    change(instances);
    const auto id = this->scene.Add();
    try
    {
      this->scene.SetInstances(id, instances);
    }
    catch (const rtg::Error& error)
    {
      EXPECT_EQ(this->scene.GlyphCount(id), 0u);
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names = [&](const char* what, const auto& change)
  { EXPECT_NE(message(change).find(what), std::string::npos) << what << ": " << message(change); };
  names("5 sizes along three axes for 4 glyphs", [](auto& i) { i.sizes3.resize(5, glm::vec3(1.0f)); });
  names("3 sizes for 4 glyphs", [](auto& i) { i.sizes1.resize(3, 1.0f); });
  names("7 low parts of centers for 4 glyphs", [](auto& i) { i.centresLow.resize(7); });
  names("1 rotations for 4 glyphs", [](auto& i) { i.rotations.resize(1); });
  names("8 exponents for 4 glyphs", [](auto& i) { i.exponents3.resize(8, glm::vec3(2.0f)); });
  names("2 quadratic forms for 4 glyphs", [](auto& i) { i.forms.resize(2); });
  names("3 ends before pieces of lines for 4 glyphs", [](auto& i) { i.before.resize(3); });
  names("5 velocities for 4 glyphs", [](auto& i) { i.motion.velocities.resize(5); });
  names("one kind", [](auto& i) { i.sizes1.resize(4, 1.0f), i.sizes3.resize(4, glm::vec3(1.0f)); });
  EXPECT_EQ(message([](auto&) {}), "");
  // The scene still shows what is right.
  EXPECT_GT(Coverage(this->Trace()), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Structures, StructureTest, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree),
  [](const auto& info) { return ::testing::PrintToString(info.param); });
