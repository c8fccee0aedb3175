// What work is done for an image, and what memory is held.
#include "Probes.h"
#include "TracerFixture.h"
#include "Vulkan/DeviceState.h"

#include <algorithm>
#include <cmath>

using rtg::Image;
using namespace rtg::testing;

TEST_F(TracerTest, ExponentsOfOtherShapesAreNotKept)
{
  rtg::GlyphInstances instances;
  instances.centers = RandomPoints(1000);
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

TEST_P(StructureTest, EveryStepRedoesOnlyWhatItsInputChanged)
{
  this->UseOwnTracer();
  const auto id = this->AddSpheres(RandomPoints(500), 0.1f);
  this->scene.SetColors(id, std::vector<std::uint32_t>(500, 0xff808080u));
  this->Trace();
  const rtg::Statistics first = this->scene.GetStatistics();
  const std::uint64_t pipelineBuilds = this->tracer->GetStatistics().pipelineBuilds;
  EXPECT_EQ(first.structureBuilds, 1u);
  EXPECT_EQ(first.instanceUploads, 1u);
  EXPECT_EQ(first.colorUploads, 1u);
  EXPECT_EQ(this->tracer->GetStatistics().primaryRays, 10000u);

  // Camera moved: trace only.
  this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * this->LookFrom(5.5));
  this->Trace();
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 1u);
  EXPECT_EQ(this->scene.GetStatistics().topLevelBuilds, first.topLevelBuilds);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 1u);
  EXPECT_EQ(this->scene.GetStatistics().colorUploads, 1u);
  EXPECT_EQ(this->tracer->GetStatistics().pipelineBuilds, pipelineBuilds);

  // Colors changed: colors only.
  this->scene.SetColors(id, std::vector<std::uint32_t>(500, 0xff8080ffu));
  this->Trace();
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 1u);
  EXPECT_EQ(this->scene.GetStatistics().topLevelBuilds, first.topLevelBuilds);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 1u);
  EXPECT_EQ(this->scene.GetStatistics().colorUploads, 2u);

  // Hidden and shown: sent again in the order that is known.
  this->scene.SetVisible(id, false);
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  this->scene.SetVisible(id, true);
  EXPECT_GT(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 2u);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 2u);
  EXPECT_EQ(this->scene.GetStatistics().sorts, first.sorts);

  // Kept while it is hidden: nothing is sent again.
  this->scene.SetVisible(id, false, true);
  EXPECT_EQ(Coverage(this->Trace()), 0.0);
  this->scene.SetVisible(id, true);
  EXPECT_GT(Coverage(this->Trace()), 0.0);
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, 2u);
  EXPECT_EQ(this->scene.GetStatistics().instanceUploads, 2u);
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

// What users turn on and off, and what steps of time bring. Of the program's tests this one alone has boxes, so that
// none has compiled its programs before.
TEST_P(StructureTest, ColorsAndExposureCompileNothing)
{
  this->UseOwnTracer();
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Box;
  instances.centers = RandomPoints(50);
  instances.uniformSize = 0.2f;
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  const auto pixels = [this]
  {
    const Image image = this->Trace();
    return std::vector<std::uint32_t>(image.color, image.color + 10000);
  };
  const auto plain = pixels();
  const std::uint64_t builds = this->tracer->GetStatistics().pipelineBuilds;
  EXPECT_GT(builds, 0u);

  this->scene.SetColors(id, std::vector<std::uint32_t>(50, 0xff2040ffu));
  const auto colored = pixels();
  EXPECT_NE(colored, plain);
  this->settings.exposure = 1.0f;
  EXPECT_NE(pixels(), colored);
  this->settings.exposure = 0.0f;
  this->settings.keepSums = true;
  EXPECT_EQ(pixels(), colored);
  this->scene.SetInstances(id, instances);
  EXPECT_EQ(pixels(), plain);
  EXPECT_EQ(this->tracer->GetStatistics().pipelineBuilds, builds);
}

TEST_P(StructureTest, WhatIsHiddenHoldsNoMemory)
{
  this->UseOwnTracer();
  this->AddSpheres(RandomPoints(100), 0.1f);
  this->Trace();
  const std::uint64_t alone = this->scene.GetStatistics().deviceBytes;
  const auto id = this->AddSpheres(RandomPoints(20000), 0.1f);
  this->scene.SetColors(id, std::vector<std::uint32_t>(20000, 0xff8080ffu));
  const Image image = this->Trace();
  const std::vector<std::uint32_t> shown(image.color, image.color + 10000);
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
    EXPECT_EQ(shown, std::vector<std::uint32_t>(again.color, again.color + 10000));
  }
}

TEST_P(StructureTest, DevicesWithMemoryOfTheirOwnShowTheSame)
{
  auto& vulkan = this->device->GetState();
  const bool shares = vulkan.sharesMemory, cpu = vulkan.cpu;
  vulkan.cpu = true; // for an image is one launch then
  struct Seen
  {
    std::vector<std::uint32_t> colors, glyphs;
    std::vector<float> depths;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> means;
    std::vector<float> probes;
    std::uint64_t commit = 0, recoloring = 0, tracing = 0;
    bool operator==(const Seen& other) const
    {
      return this->colors == other.colors && this->glyphs == other.glyphs && this->depths == other.depths &&
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
      instances.centers = empty ? std::vector<glm::vec3>() : RandomPoints(200 + 50 * set);
      instances.uniformSize = 0.1f + 0.05f * set;
      last = scene.Add();
      scene.SetInstances(last, instances);
    }
    const std::uint64_t before = vulkan.submissions;
    scene.Commit();
    seen.commit = vulkan.submissions - before;
    scene.SetColors(last, std::vector<std::uint32_t>(scene.InstancesOf(last).Count(), 0xff4080c0u));
    const std::uint64_t between = vulkan.submissions;
    scene.Commit();
    seen.recoloring = vulkan.submissions - between;
    const std::uint64_t idle = vulkan.submissions;
    tracer.Trace(scene, this->camera, this->lights, this->settings);
    seen.tracing = vulkan.submissions - idle;
    rtg::TraceSettings wanted = this->settings;
    wanted.width = 101; // images whose bytes are no round number
    wanted.features = wanted.keepSums = true;
    wanted.samples = 2;
    tracer.Trace(scene, this->camera, this->lights, wanted);
    const Image image = tracer.Resume(scene, 4);
    const std::size_t pixels = 101 * 100;
    seen.colors.assign(image.color, image.color + pixels);
    seen.glyphs.assign(image.glyphIds, image.glyphIds + pixels);
    seen.depths.assign(image.depth, image.depth + pixels);
    seen.normals = tracer.Features().normals;
    seen.means = tracer.Means();
    for (const auto& hit :
      rtg::testing::TraceProbes(scene, { { { 0.1, 0.1, 5 }, { 0, 0, -1 } }, { { 9, 9, 9 }, { 0, 0, 1 } } }))
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
    EXPECT_EQ(own.recoloring, empty ? 0u : 1u);
    if (!empty)
    {
      EXPECT_EQ(own.tracing, 2u); // a launch, and a copy of the image
    }
  }
  vulkan.sharesMemory = shares;
  vulkan.cpu = cpu;
}

/// What a progress callback does with the device does not wait for the uploads that it reports.
TEST_F(TracerTest, AnImageTracedWhileGlyphsAreSentIsTheSame)
{
  auto& vulkan = this->device->GetState();
  const bool shares = vulkan.sharesMemory;
  vulkan.sharesMemory = false;
  this->AddSpheres(RandomPoints(50), 0.3f);
  this->scene.Commit();
  this->lights.assign(rtg::device::FEW_LIGHTS + 1, rtg::Light());
  for (rtg::Light& light : this->lights)
  {
    light.color = glm::vec3(0.1f);
  }
  const auto trace = [this]
  {
    this->UseOwnTracer();
    const Image image = this->tracer->Trace(this->scene, this->camera, this->lights, this->settings);
    return std::vector<std::uint32_t>(image.color, image.color + 10000);
  };
  const auto expected = trace();
  EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [](std::uint32_t color) { return (color & 255) > 100; }));
  {
    rtg::Scene other(this->device);
    rtg::GlyphInstances spheres;
    spheres.centers = RandomPoints(100);
    other.SetInstances(other.Add(), std::move(spheres));
    int traced = 0;
    other.Commit(
      [&](double)
      {
        ++traced;
        EXPECT_EQ(trace(), expected);
      });
    EXPECT_GT(traced, 1);
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
  this->settings.width = this->settings.height = 400;
  std::vector<std::uint32_t> images[2];
  std::uint64_t launches[2];
  for (const bool gpu : { false, true })
  {
    vulkan.cpu = !gpu;
    rtg::Tracer tracer(this->device);
    // What a launch leaves out shows what was there before.
    tracer.Trace(nothing, this->camera, this->lights, this->settings);
    const std::uint64_t before = vulkan.submissions;
    const Image image = tracer.Trace(this->scene, this->camera, this->lights, this->settings);
    launches[gpu] = vulkan.submissions - before;
    images[gpu].assign(image.color, image.color + 160000);
  }
  vulkan.cpu = cpu;
  // Of 2500 tiles the first launch on a GPU has so many as fill it.
  EXPECT_LE(launches[0], 2u);
  EXPECT_GT(launches[1], launches[0]);
  EXPECT_EQ(images[0], images[1]);
}

/// Few pixels with many samples are few threads with much work each: launches are cut by samples, too.
TEST_F(TracerTest, ALaunchOfFewPixelsHasFewSamples)
{
  this->AddSpheres(RandomPoints(5), 0.5f);
  this->scene.Commit();
  this->settings.width = this->settings.height = 8;
  this->settings.shading = rtg::Shading::PathTracing;
  this->settings.samples = 1u << 20;
  this->UseOwnTracer();
  const auto trace = [this](const rtg::Interrupt& interrupt)
  { return this->tracer->Trace(this->scene, this->camera, this->lights, this->settings, rtg::Pass::All, interrupt); };
  const auto stop = [](double) { return true; };
  Image image = trace(stop);
  // At first the interrupt ends the wait for the program.
  while (image.samples == 0)
  {
    image = this->tracer->Resume(this->scene, this->settings.samples, stop);
  }
  EXPECT_LE(image.samples, 32u);
  this->settings.paths = 64;
  EXPECT_EQ(trace(stop).samples, 1u);

  // Also where the image began without a callback.
  this->settings.paths = 1;
  this->settings.samples = 1;
  this->settings.keepSums = true;
  trace({});
  EXPECT_LE(this->tracer->Resume(this->scene, 1u << 20, stop).samples, 33u);
  this->settings.keepSums = false;

  // Of launches that turn out to be quick the next ones have more, step by step.
  this->settings.samples = 5000;
  std::vector<double> steps;
  double before = 0.0;
  image = trace(
    [&](double share)
    {
      steps.push_back(share - before);
      before = share;
      return false;
    });
  EXPECT_TRUE(image.complete);
  ASSERT_GT(steps.size(), 2u);
  for (std::size_t i = 1; i < steps.size(); ++i)
  {
    EXPECT_LE(steps[i], 8.001 * steps[i - 1]);
  }
  const std::vector<std::uint32_t> inParts(image.color, image.color + 64);

  // A GPU's display stands still during a launch, whether or not the image can be interrupted.
  auto& vulkan = this->device->GetState();
  const bool cpu = vulkan.cpu;
  for (const bool gpu : { false, true })
  {
    vulkan.cpu = !gpu;
    const std::uint64_t submissions = vulkan.submissions;
    image = trace({});
    if (gpu)
    {
      EXPECT_GE(vulkan.submissions - submissions, 3u);
    }
    EXPECT_EQ(inParts, std::vector<std::uint32_t>(image.color, image.color + 64));
  }
  vulkan.cpu = cpu;
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
    instances.centers = points;
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
