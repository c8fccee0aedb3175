// Meshes that move as a whole or position by position, against boxes in double and against themselves at rest.
#include "BoxMesh.h"
#include "MovingGlyphs.h"

#include <cstring>
#include <numbers>

using namespace moving;

namespace
{

// A sphere of radius 1 as rings * 2 rings quadrilaterals.
rtg::TriangleMesh SphereMesh(std::uint32_t rings)
{
  rtg::TriangleMesh mesh;
  const std::uint32_t columns = 2 * rings;
  for (std::uint32_t row = 0; row <= rings; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const double polar = std::numbers::pi * row / rings, around = 2.0 * std::numbers::pi * column / columns;
      mesh.positions.emplace_back(
        std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
    }
  }
  for (std::uint32_t row = 0; row < rings; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const std::uint32_t a = row * columns + column, b = row * columns + (column + 1) % columns;
      mesh.triangles.push_back({ a, a + columns, b });
      mesh.triangles.push_back({ b, a + columns, b + columns });
    }
  }
  return mesh;
}

using rtg::testing::BoxMesh;
using rtg::testing::Share;

class MovingMesh : public MotionTest
{
};

// Positions that go apart from the middle while it goes along a parabola: a box at all times, of which `At` gives the
// size.
struct GrowingBox
{
  const glm::dvec3 velocity{ 0.6, -0.3, 0.4 };
  const glm::dvec3 acceleration{ -1.5, 3.0, 1.0 };
  const glm::dvec3 growth{ 0.8, -0.6, 0.3 };         // of a unit of length, per time
  const glm::dvec3 growthOfGrowth{ -0.5, 1.0, 0.4 }; // per time squared

  rtg::TriangleMesh Mesh() const
  {
    // Its frame's origin is elsewhere than its middle.
    rtg::TriangleMesh mesh = BoxMesh(glm::vec3(0.2f, 0.1f, -0.3f));
    for (const glm::vec3& position : mesh.positions)
    {
      const glm::dvec3 x = glm::dvec3(position) - this->Middle();
      mesh.motion.velocities.emplace_back(this->velocity + this->growth * x);
      mesh.motion.accelerations.emplace_back(this->acceleration + this->growthOfGrowth * x);
    }
    return mesh;
  }

  glm::dvec3 Middle() const { return glm::dvec3(glm::vec3(0.2f, 0.1f, -0.3f)); }

  Double::Glyph At(double time) const
  {
    Double::Glyph box{};
    box.center = this->Middle() + this->velocity * time + this->acceleration * (0.5 * time * time);
    box.size = 1.0 + this->growth * time + this->growthOfGrowth * (0.5 * time * time);
    return box;
  }

  rtg::GlyphInstances Instances() const
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Mesh;
    instances.identifyTriangles = true;
    instances.centers = { glm::vec3(0.0f) };
    instances.mesh = Share(this->Mesh());
    instances.motion.shutterOpen = -0.4f;
    instances.motion.shutterClose = 0.6f;
    return instances;
  }
};

} // namespace

TEST_P(MovingMesh, GlyphsAreWhereTheyShouldBe)
{
  MovingGlyphs make(4);
  rtg::GlyphInstances instances = make.Make(rtg::Shape::Box, 40, true, true);
  instances.motion.shutterOpen = -0.7f;
  instances.motion.shutterClose = 0.4f;
  rtg::GlyphInstances meshes = instances;
  meshes.shape = rtg::Shape::Mesh;
  meshes.mesh = Share(BoxMesh());
  this->Add(meshes);
  this->ExpectRaysMeet(
    rtg::Shape::Box, meshes, [&](std::size_t i, double time) { return GlyphAt(instances, i, time); }, false);
}

TEST_P(MovingMesh, PositionsAreWhereTheyShouldBe)
{
  const GrowingBox box;
  const rtg::GlyphInstances instances = box.Instances();
  this->Add(instances);
  this->ExpectRaysMeet(
    rtg::Shape::Box, instances, [&](std::size_t, double time) { return box.At(time); }, true);
}

TEST_P(MovingMesh, GlyphCoversAsBruteForce)
{
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Box;
  instances.centers = { { -0.1f, 0.05f, 0.0f } };
  instances.sizes3 = { { 0.7f, 0.4f, 0.2f } };
  instances.rotations = { glm::normalize(glm::vec4(0.1f, 0.2f, 0.3f, 0.9f)) };
  instances.motion.velocities = { { 0.5f, -0.4f, 0.0f } };
  instances.motion.accelerations = { { 1.0f, 5.0f, 0.5f } };
  instances.motion.angularVelocities = { { 0.3f, 0.5f, 2.5f } };
  const BruteForce share(instances, 150);
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  this->Add(instances);
  this->settings.width = this->settings.height = 30;
  this->settings.samples = 64;
  this->ExpectCoverage(share);
}

TEST_P(MovingMesh, SurfaceCoversAsBruteForce)
{
  const GrowingBox box;
  rtg::GlyphInstances instances = box.Instances();
  instances.uniformSize = 0.6f;
  this->Add(instances);
  this->settings.width = this->settings.height = 30;
  this->settings.samples = 64;
  constexpr int times = 400;
  this->ExpectCoverage(
    [&](glm::dvec2 p)
    {
      int covered = 0;
      for (int i = 0; i < times; ++i)
      {
        // Sizes of both are of the glyph: its frame is that of the mesh times 0.6.
        const Double::Glyph at = box.At(instances.motion.Time((i + 0.5) / times));
        const glm::dvec2 away = glm::abs(p - double(0.6f) * glm::dvec2(at.center));
        covered += away.x < 0.5 * double(0.6f) * at.size.x && away.y < 0.5 * double(0.6f) * at.size.y;
      }
      return double(covered) / times;
    });
}

TEST_P(MovingMesh, NormalsTurnWithTheirTriangles)
{
  // A plate whose far edge rises.
  rtg::TriangleMesh mesh;
  mesh.positions = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.motion.velocities = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 2 }, { 0, 0, 2 } };
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.centers = { glm::vec3(0.0f) };
  instances.mesh = Share(mesh);
  instances.motion.shutterOpen = 0.0f;
  instances.motion.shutterClose = 1.0f;
  this->Add(instances);
  std::vector<rtg::testing::Probe> probes;
  for (const float time : { 0.0f, 0.3f, 0.9f })
  {
    probes.push_back({ { 0.2, 0.1, 5 }, { 0, 0, -1 }, time });
  }
  const auto found = rtg::testing::TraceProbes(this->scene, probes);
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    EXPECT_NEAR(found[i].t, 5.0f - 1.1f * probes[i].time, 1e-5f);
    const glm::vec3 wanted = glm::normalize(glm::vec3(0.0f, -probes[i].time, 1.0f));
    EXPECT_LT(glm::distance(found[i].normal, wanted), 1e-5f) << probes[i].time;
  }
}

TEST_P(MovingMesh, NoRayFindsAGapBetweenTriangles)
{
  // From inside a ball of narrow triangles whose positions all go their own ways, many rays through edges and corners.
  MovingGlyphs make(3);
  rtg::TriangleMesh mesh = SphereMesh(24);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
  {
    mesh.motion.velocities.push_back(make.Vector(0.05f));
  }
  // The poles and their copies stay together.
  const std::size_t columns = 48;
  for (std::size_t i = 0; i < columns; ++i)
  {
    mesh.motion.velocities[i] = mesh.motion.velocities[0];
    mesh.motion.velocities[mesh.positions.size() - 1 - i] = mesh.motion.velocities.back();
    mesh.positions[i] = mesh.positions[0];
    mesh.positions[mesh.positions.size() - 1 - i] = mesh.positions.back();
  }
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.centers = { glm::vec3(0.3f) };
  instances.mesh = Share(mesh);
  this->Add(instances);
  std::vector<rtg::testing::Probe> probes;
  for (int i = 0; i < 20000; ++i)
  {
    rtg::testing::Probe probe;
    probe.time = make.Uniform(0.0f, 0.9999f);
    probe.origin = glm::dvec3(0.3) + glm::dvec3(make.Vector(0.3f));
    const double time = instances.motion.Time(probe.time);
    const auto at = [&](std::uint32_t corner)
    { return glm::dvec3(mesh.positions[corner]) + time * glm::dvec3(mesh.motion.velocities[corner]); };
    // At a corner, or somewhere on an edge.
    const glm::uvec3& corner = mesh.triangles[i % mesh.triangles.size()];
    const double share = i % 3 == 0 ? 0.0 : make.Uniform(0.0f, 1.0f);
    const glm::dvec3 aim = glm::dvec3(0.3f) + glm::mix(at(corner.x), at(corner.y), share);
    probe.direction = glm::vec3(aim - probe.origin);
    probes.push_back(probe);
  }
  const auto found = rtg::testing::TraceProbes(this->scene, probes);
  EXPECT_EQ(0, std::count_if(found.begin(), found.end(), [](const auto& hit) { return !std::isfinite(hit.t); }));
  // A box of the tree that were too small would also lose what lies behind the first triangles.
  int near = 0;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    near += std::abs(found[i].t - 1.0f) < 0.01f;
  }
  EXPECT_GT(near, 19000);
}

TEST_P(MovingMesh, NothingHidesItFromTheSky)
{
  // Convex, so that only rays of another time would meet it.
  const GrowingBox box;
  this->Add(box.Instances());
  this->settings.samples = 16;
  this->settings.shading = rtg::Shading::AmbientOcclusion;
  int covered = 0;
  for (const glm::vec4& mean : this->Means())
  {
    EXPECT_EQ(mean.r, mean.a);
    covered += mean.a > 0.0f;
  }
  EXPECT_GT(covered, 300);
}

TEST_P(MovingMesh, WithoutMotionItIsTheMeshAtRest)
{
  MovingGlyphs make(9);
  rtg::GlyphInstances instances = make.Make(rtg::Shape::Mesh, 30, false, false);
  rtg::TriangleMesh mesh = BoxMesh(glm::vec3(0.3f));
  mesh.triangleColors.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    mesh.triangleColors[i] = 0xff000000u + 20u * static_cast<std::uint32_t>(i);
  }
  instances.mesh = Share(mesh);
  const auto id = this->Add(instances);
  this->settings.samples = 4;
  const std::vector<glm::vec4> atRest = this->Means();
  mesh.motion.velocities.assign(mesh.positions.size(), glm::vec3(0.0f));
  instances.mesh = Share(mesh);
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  const std::vector<glm::vec4> still = this->Means();
  // Edges may fall on either side.
  int different = 0, covered = 0;
  for (std::size_t i = 0; i < still.size(); ++i)
  {
    different += glm::length(still[i] - atRest[i]) > 1e-3f;
    covered += atRest[i].a > 0.0f;
  }
  EXPECT_GT(covered, 200);
  EXPECT_LE(different, 2);
  // And back again.
  mesh.motion = rtg::GlyphMotion();
  instances.mesh = Share(mesh);
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  const std::vector<glm::vec4> again = this->Means();
  EXPECT_EQ(0, std::memcmp(atRest.data(), again.data(), again.size() * sizeof(again[0])));
}

TEST_P(MovingMesh, IsBuiltOnceForGlyphsElsewhere)
{
  MovingGlyphs make(5);
  rtg::GlyphInstances instances = make.Make(rtg::Shape::Mesh, 10, true, false);
  instances.mesh = Share(BoxMesh());
  const auto id = this->Add(instances);
  const auto before = this->scene.GetStatistics().structureBuilds;
  instances.centers[3] += 0.1f;
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  // Of the glyphs, not of the mesh.
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, before + 1);
}

/// Both in one Commit(), on a device with memory of its own: the new colors must not go to a buffer that another tree
/// replaces.
TEST_P(MovingMesh, ChangesColorsAndShutterAtOnce)
{
  auto& vulkan = this->device->GetState();
  const bool shares = vulkan.sharesMemory;
  vulkan.sharesMemory = false;
  {
    rtg::GlyphInstances instances = GrowingBox().Instances();
    const auto colored = [](std::uint32_t color)
    {
      rtg::TriangleMesh mesh = GrowingBox().Mesh();
      mesh.triangleColors.assign(mesh.triangles.size(), color);
      return Share(std::move(mesh));
    };
    instances.mesh = colored(0xff2040f0u);
    const auto id = this->Add(instances);
    instances.mesh = colored(0xfff08020u);
    instances.motion.shutterClose = 0.3f;
    this->scene.SetInstances(id, instances);
    this->scene.Commit();
    const std::vector<glm::vec4> changed = this->Means();
    this->scene.Remove(id);
    this->Add(instances);
    const std::vector<glm::vec4> expected = this->Means();
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [](const glm::vec4& mean) { return mean.b > mean.r; }));
    EXPECT_EQ(changed, expected);
  }
  vulkan.sharesMemory = shares;
}

TEST_P(MovingMesh, RefusesWhatMakesNoSense)
{
  const auto id = this->scene.Add();
  const auto message = [&](const std::function<void(rtg::TriangleMesh&, rtg::GlyphMotion&)>& change)
  {
    rtg::TriangleMesh mesh = GrowingBox().Mesh();
    rtg::GlyphInstances instances = GrowingBox().Instances();
    change(mesh, instances.motion);
    instances.mesh = Share(mesh);
    return rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); });
  };
  EXPECT_EQ(message([](auto&, auto&) {}), "");
  EXPECT_NE(message([](auto& mesh, auto&) { mesh.motion.velocities.pop_back(); }).find("7 velocities; it must have 8"),
    std::string::npos);
  EXPECT_NE(message([](auto& mesh, auto&) { mesh.motion.accelerations[2].x = NAN; }).find("nan"), std::string::npos);
  EXPECT_NE(
    message([](auto& mesh, auto&) { mesh.motion.angularVelocities.resize(8); }).find("angular"), std::string::npos);
  EXPECT_NE(message([](auto&, auto& shutter) { shutter.shutterClose = shutter.shutterOpen; }).find("must close later"),
    std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
  Structures, MovingMesh, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree), StructureName);
