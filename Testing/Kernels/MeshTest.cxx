// Mesh glyphs and surfaces through the pipeline.
#include "BoxMesh.h"
#include "Probes.h"
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/DeviceState.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using rtg::Image;

using rtg::testing::BoxMesh;
using rtg::testing::Share;

// A ball of diameter 1 with so many segments round its axis and half as many rings, its normals those of the round one.
rtg::TriangleMesh FacetedBall(int segments)
{
  rtg::TriangleMesh mesh;
  const int rings = segments / 2;
  for (int ring = 0; ring <= rings; ++ring)
  {
    const float down = glm::pi<float>() * float(ring) / float(rings);
    for (int segment = 0; segment < segments; ++segment)
    {
      const float round = glm::two_pi<float>() * float(segment) / float(segments);
      mesh.normals.emplace_back(std::sin(down) * std::cos(round), std::cos(down), -std::sin(down) * std::sin(round));
      mesh.positions.push_back(0.5f * mesh.normals.back());
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int segment = 0; segment < segments; ++segment)
    {
      const glm::uint a = ring * segments + segment, b = ring * segments + (segment + 1) % segments;
      mesh.triangles.push_back({ a, a + segments, b + segments });
      mesh.triangles.push_back({ a, b + segments, b });
    }
  }
  return mesh;
}

class MeshTest : public ::testing::Test
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer& tracer = rtg::testing::SharedTracer();
  std::mt19937 random{ 7 };

  float Uniform(float lower, float upper) { return std::uniform_real_distribution<float>(lower, upper)(this->random); }

  glm::vec4 RandomRotation()
  {
    std::normal_distribution<float> normal;
    return glm::normalize(
      glm::vec4(normal(this->random), normal(this->random), normal(this->random), normal(this->random)));
  }

  // Boxes of all sizes, turned, far from the world's origin.
  rtg::GlyphInstances RandomBoxes(std::size_t count)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Box;
    instances.origin = glm::dvec3(1000.0, -500.0, 20.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      instances.centers.push_back({ this->Uniform(-5, 5), this->Uniform(-5, 5), this->Uniform(-5, 5) });
      instances.sizes3.push_back({ this->Uniform(0.3f, 1), this->Uniform(0.3f, 1), this->Uniform(0.3f, 1) });
      instances.rotations.push_back(this->RandomRotation());
    }
    return instances;
  }

  std::vector<rtg::testing::Probe> RandomProbes(std::size_t count, const glm::dvec3& around)
  {
    std::vector<rtg::testing::Probe> probes;
    for (std::size_t i = 0; i < count; ++i)
    {
      const glm::dvec3 from(this->Uniform(-9, 9), this->Uniform(-9, 9), this->Uniform(0, 1) < 0.5f ? -9 : 9);
      const glm::dvec3 to(this->Uniform(-4, 4), this->Uniform(-4, 4), this->Uniform(-4, 4));
      probes.push_back({ around + from, glm::vec3(to - from) });
    }
    return probes;
  }

  std::vector<rtg::testing::ProbeHit> Probe(const std::vector<rtg::testing::Probe>& probes)
  {
    this->scene.Commit();
    return rtg::testing::TraceProbes(this->scene, probes);
  }

  // One triangle in the plane z = 0 that fills the view's lower left half, traced without lighting.
  Image TracePlain(rtg::TriangleMesh mesh, bool identifyTriangles = false)
  {
    const auto id = this->scene.Add();
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Mesh;
    instances.mesh = Share(std::move(mesh));
    instances.centers = { glm::vec3(0.0f) };
    instances.identifyTriangles = identifyTriangles;
    this->scene.SetInstances(id, instances);
    rtg::Material material;
    material.lighting = false;
    this->scene.SetMaterial(id, material);
    this->scene.Commit();
    const rtg::Camera camera = rtg::Camera::FromWorldToClip(
      glm::ortho(0.0, 1.0, 0.0, 1.0, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
    rtg::TraceSettings settings;
    settings.width = settings.height = 64;
    return this->tracer.Trace(this->scene, camera, {}, settings);
  }
};

} // namespace

TEST_F(MeshTest, BoxesOfTrianglesAreBoxes)
{
  const rtg::GlyphInstances boxes = this->RandomBoxes(300);
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, boxes);
  const auto probes = this->RandomProbes(4000, boxes.origin);
  const auto exact = this->Probe(probes);

  rtg::GlyphInstances meshes = boxes;
  meshes.shape = rtg::Shape::Mesh;
  meshes.mesh = Share(BoxMesh());
  this->scene.SetInstances(id, meshes);
  const auto found = this->Probe(probes);

  int hits = 0, different = 0;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    hits += std::isfinite(exact[i].t);
    // Triangles are intersected in plain float: at edges the two may differ.
    if (std::isfinite(exact[i].t) != std::isfinite(found[i].t) ||
      (std::isfinite(exact[i].t) && exact[i].glyphId != found[i].glyphId))
    {
      ++different;
      continue;
    }
    if (std::isfinite(exact[i].t))
    {
      ASSERT_NEAR(found[i].t, exact[i].t, 1e-5) << i;
      EXPECT_EQ(found[i].setId, id);
      different += glm::distance(found[i].normal, exact[i].normal) > 1e-4f;
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LE(different, 2);
}

TEST_F(MeshTest, HidesAndIsHiddenByOtherGlyphs)
{
  // The spheres come first, so that the meshes are not the first instances of the top level.
  const auto spheres = this->scene.Add(), meshes = this->scene.Add();
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  instances.centers = { { 0, 0, 0 }, { 3, 0, 0 } };
  this->scene.SetInstances(meshes, instances);
  rtg::GlyphInstances balls;
  balls.centers = { { 0, 0, 2 }, { 3, 0, -2 } };
  this->scene.SetInstances(spheres, balls);
  const auto hits = this->Probe(
    { { { 0.1, 0.1, 9 }, { 0, 0, -1 } }, { { 3.1, 0.1, 9 }, { 0, 0, -1 } }, { { 3.1, 0.1, -9 }, { 0, 0, 1 } } });
  EXPECT_EQ(hits[0].setId, spheres);
  EXPECT_EQ(hits[1].setId, meshes);
  EXPECT_EQ(hits[1].glyphId, 1u);
  EXPECT_FLOAT_EQ(hits[1].t, 8.5f);
  EXPECT_EQ(hits[2].setId, spheres);
  EXPECT_EQ(hits[2].glyphId, 1u);
}

TEST_F(MeshTest, SmoothNormalsAreInterpolatedAndTurnWithTheInverseTranspose)
{
  rtg::TriangleMesh mesh;
  mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  mesh.triangles = { { 0, 1, 2 } };
  mesh.normals = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } };
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(mesh);
  instances.centers = { { 0, 0, 0 } };
  instances.sizes3 = { { 2, 4, 0.5f } };
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  // At weights 0.5, 0.2, 0.3 of the corners.
  const auto hits = this->Probe({ { { 0.4, 1.2, 5 }, { 0, 0, -1 } } });
  const glm::vec3 local(0.2f, 0.3f, 0.5f);
  const glm::vec3 wanted = glm::normalize(local / glm::vec3(2, 4, 0.5f));
  EXPECT_NEAR(glm::distance(hits[0].normal, wanted), 0.0f, 1e-6f);
}

// Of triangles of any size, of glyphs of any size.
TEST_F(MeshTest, NormalsHaveUnitLengthAtEveryScale)
{
  for (const rtg::Structure structure : { rtg::Structure::Tree, rtg::Structure::Boxes })
  {
    if (!rtg::testing::WhatLacksFor(structure).empty())
    {
      continue;
    }
    for (const int exponent : { -40, -20, 0, 20, 40 })
    {
      for (const float size : { 1.0f, std::ldexp(1.0f, -exponent) })
      {
        const float scale = std::ldexp(1.0f, exponent);
        rtg::TriangleMesh mesh;
        mesh.positions = { scale * glm::vec3(-1, -1, -0.5f), scale * glm::vec3(1, -1, 0), scale * glm::vec3(0, 1, 0) };
        mesh.triangles = { { 0, 1, 2 } };
        const glm::vec3 a = mesh.positions[1] / scale - mesh.positions[0] / scale;
        const glm::vec3 b = mesh.positions[2] / scale - mesh.positions[0] / scale;
        rtg::GlyphInstances instances;
        instances.shape = rtg::Shape::Mesh;
        instances.mesh = Share(std::move(mesh));
        instances.centers = { glm::vec3(0.0f) };
        instances.uniformSize = size;
        rtg::Scene own(this->device);
        own.GetState().structure = structure;
        own.SetInstances(own.Add(), instances);
        own.Commit();
        const double world = double(scale) * size;
        const auto hits = rtg::testing::TraceProbes(own, { { glm::dvec3(0, 0, 2.0 * world), glm::vec3(0, 0, -1) } });
        ASSERT_TRUE(std::isfinite(hits[0].t)) << "scale 2^" << exponent;
        EXPECT_LE(glm::distance(hits[0].normal, glm::normalize(glm::cross(a, b))), 1e-5f)
          << "scale 2^" << exponent << ", size " << size;
      }
    }
  }
}

// Rounding may let rays meet triangles whose corners lie on a line.
TEST_F(MeshTest, TrianglesWithoutAreaHaveNormals)
{
  const auto whole = [this](int most) { return float(int(this->random() % (2 * most + 1)) - most); };
  rtg::TriangleMesh mesh;
  for (glm::uint i = 0; i < 20000; ++i)
  {
    const glm::vec3 a = glm::vec3(whole(1024), whole(1024), whole(512)) / 1024.0f;
    const glm::vec3 along = glm::vec3(whole(256), whole(256), whole(256)) / 2048.0f;
    mesh.positions.insert(mesh.positions.end(), { a, a + along, a + 2.0f * along });
    mesh.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(std::move(mesh));
  instances.centers = { glm::vec3(0.0f) };
  this->scene.SetInstances(this->scene.Add(), instances);
  std::vector<rtg::testing::Probe> probes;
  for (int i = 0; i < 150000; ++i)
  {
    probes.push_back({ glm::dvec3(this->Uniform(-0.9f, 0.9f), this->Uniform(-0.9f, 0.9f), 5.0), { 0.06f, 0.04f, -1 } });
  }
  int met = 0;
  for (const rtg::testing::ProbeHit& hit : this->Probe(probes))
  {
    met += std::isfinite(hit.t);
    EXPECT_TRUE(!std::isfinite(hit.t) || std::abs(glm::length(hit.normal) - 1.0f) < 1e-5f);
  }
  EXPECT_GT(met, 0);
}

TEST_F(MeshTest, ColorsOfPositionsAreInterpolated)
{
  rtg::TriangleMesh mesh;
  mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  mesh.triangles = { { 0, 1, 2 } };
  mesh.positionColors = { 0xff0000ffu, 0xff00ff00u, 0xffff0000u };
  const Image image = this->TracePlain(mesh);
  for (const auto& [x, y] : { std::pair(3, 5), std::pair(40, 10), std::pair(8, 50) })
  {
    const float u = (x + 0.5f) / 64, v = (y + 0.5f) / 64;
    const std::uint32_t color = image.color[y * 64 + x];
    EXPECT_NEAR(color & 255, 255 * (1 - u - v), 1.0) << x << ' ' << y;
    EXPECT_NEAR(color >> 8 & 255, 255 * u, 1.0) << x << ' ' << y;
    EXPECT_NEAR(color >> 16 & 255, 255 * v, 1.0) << x << ' ' << y;
  }
  EXPECT_EQ(image.glyphIds[63 * 64 + 63], Image::noGlyph);
}

/// A corner without a number or a value takes its whole triangle, and the color of the one is not that of the other.
TEST_F(MeshTest, WhatHasNoValueReachesAsFarAsItsTriangles)
{
  const std::uint32_t number = 0xff00ff00u, noNumber = 0xff0000ffu, none = 0xffff0000u;
  for (const auto structure : { rtg::Structure::Boxes, rtg::Structure::Tree })
  {
    if (!rtg::testing::WhatLacksFor(structure).empty())
    {
      continue;
    }
    this->scene.GetState().structure = structure;
    for (const auto& [values, expected] : { std::pair(std::vector<float>{ 0.2f, 0.9f, rtg::noValue }, none),
           std::pair(std::vector<float>{ 0.2f, rtg::noValue, rtg::notANumber }, none),
           std::pair(std::vector<float>{ 1000.0f, 0.9f, rtg::notANumber }, noNumber),
           std::pair(std::vector<float>{ 0.2f, -1000.0f, 1000.0f }, number) })
    {
      rtg::TriangleMesh mesh;
      mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
      mesh.triangles = { { 0, 1, 2 } };
      mesh.positionValues = values;
      mesh.valueColors = { number, number, noNumber, none };
      // Its first rows of pixels lie near the edge between the first two corners.
      mesh.positions[2].y = 50.0f;
      const Image image = this->TracePlain(mesh);
      for (std::size_t at = 0; at < 64 * 64; ++at)
      {
        if (image.setIds[at] != Image::noGlyph)
        {
          ASSERT_EQ(image.color[at], expected) << at % 64 << ' ' << at / 64 << ' ' << int(structure);
        }
      }
      this->scene.Remove(image.setIds[0]);
    }
  }
}

/// Likewise a piece of a tube.
TEST_F(MeshTest, WhatHasNoValueReachesAsFarAsItsPieceOfATube)
{
  rtg::GlyphInstances tube;
  tube.shape = rtg::Shape::RoundCone;
  tube.centers = { { 0.5f, 0.5f, 0.0f } };
  tube.sizes3 = { { 1.0f, 0.8f, 0.8f } };
  rtg::GlyphColors colors;
  colors.ends = { { glm::floatBitsToUint(0.5f), glm::floatBitsToUint(rtg::noValue) } };
  colors.table = { 0xff00ff00u, 0xff0000ffu, 0xffff0000u };
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, tube);
  this->scene.SetColors(id, colors);
  rtg::Material material;
  material.lighting = false;
  this->scene.SetMaterial(id, material);
  this->scene.Commit();
  const rtg::Camera camera = rtg::Camera::FromWorldToClip(
    glm::ortho(0.0, 0.02, 0.49, 0.51, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  rtg::TraceSettings settings;
  settings.width = settings.height = 16;
  const Image image = this->tracer.Trace(this->scene, camera, {}, settings);
  for (std::size_t at = 0; at < 16 * 16; ++at)
  {
    ASSERT_EQ(image.color[at], colors.table[2]) << at % 16;
  }
}

TEST_F(MeshTest, ColorsAndNamesOfTrianglesFollowThem)
{
  // Stripes in an order that sorting changes.
  constexpr std::uint32_t stripes = 16;
  rtg::TriangleMesh mesh;
  std::vector<std::uint32_t> place(stripes);
  for (std::uint32_t i = 0; i < stripes; ++i)
  {
    place[i] = i * 7 % stripes;
    const float x = float(place[i]) / stripes;
    mesh.positions.insert(
      mesh.positions.end(), { { x, -9, 0 }, { x + 1.0f / stripes, -9, 0 }, { x + 0.5f / stripes, 99, 0 } });
    mesh.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    mesh.triangleColors.push_back(0xff000000u + i);
  }
  const Image image = this->TracePlain(mesh, true);
  for (std::uint32_t i = 0; i < stripes; ++i)
  {
    const std::size_t at = 32 * 64 + place[i] * (64 / stripes) + 2;
    EXPECT_EQ(image.color[at] & 255, i);
    EXPECT_EQ(this->scene.OriginalGlyph(image.setIds[at], image.glyphIds[at]), i);
  }
}

TEST_F(MeshTest, SameMeshElsewhereIsNotBuiltAgain)
{
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  instances.centers = { { 0, 0, 0 } };
  const auto id = this->scene.Add();
  this->scene.SetInstances(id, instances);
  const std::vector<rtg::testing::Probe> probe = { { { 0, 0, 9 }, { 0, 0, -1 } } };
  EXPECT_FLOAT_EQ(this->Probe(probe)[0].t, 8.5f);
  const auto builds = this->scene.GetStatistics().structureBuilds;
  instances.centers = { { 0, 0, -1 } };
  this->scene.SetInstances(id, instances);
  EXPECT_FLOAT_EQ(this->Probe(probe)[0].t, 9.5f);
  EXPECT_EQ(this->scene.GetStatistics().structureBuilds, builds);
}

// Of a convex body all of the light from all around reaches every point, however much the normals of its corners lean.
TEST_F(MeshTest, ConvexBodiesWithSmoothNormalsDoNotShadeThemselves)
{
  const rtg::Camera camera = rtg::Camera::FromWorldToClip(
    glm::ortho(-0.6, 0.6, -0.6, 0.6, 1.0, 9.0) * glm::lookAt(glm::dvec3(3, 1, 4), glm::dvec3(0), glm::dvec3(0, 1, 0)));
  for (const bool moves : { false, true })
  {
    for (const int segments : { 8, 16, 32 })
    {
      rtg::GlyphInstances instances;
      instances.shape = rtg::Shape::Mesh;
      instances.mesh = Share(FacetedBall(segments));
      instances.centers = { glm::vec3(0.0f) };
      if (moves)
      {
        instances.motion.velocities = { glm::vec3(1e-6f) };
      }
      const auto id = this->scene.Add();
      this->scene.SetInstances(id, instances);
      this->scene.Commit();
      rtg::TraceSettings settings;
      settings.width = settings.height = 60;
      settings.samples = 16;
      settings.keepSums = true;
      for (const rtg::Shading shading : { rtg::Shading::AmbientOcclusion, rtg::Shading::PathTracing })
      {
        settings.shading = shading;
        this->tracer.Trace(this->scene, camera, {}, settings);
        double light = 0.0, covered = 0.0, least = 1.0;
        for (const glm::vec4& mean : this->tracer.Means())
        {
          light += mean.r;
          covered += mean.a;
          least = mean.a > 0.0f ? std::min(least, double(mean.r / mean.a)) : least;
        }
        EXPECT_GT(covered, 1000.0);
        EXPECT_NEAR(light / covered, 1.0, 1e-3) << segments << " segments" << (moves ? ", moving" : "");
        // Weights of path tracing differ from direction to direction.
        EXPECT_GT(least, shading == rtg::Shading::PathTracing ? 0.0 : 0.999)
          << segments << " segments" << (moves ? ", moving" : "");
      }
      this->scene.Remove(id);
    }
  }
}

TEST_F(MeshTest, TooManyInstancesAreOneError)
{
  RTG_NEEDS(rtg::Structure::Boxes);
  this->scene.GetState().structure = rtg::Structure::Boxes;
  this->scene.GetState().mostInstances = 7;
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  instances.centers.resize(4);
  const auto first = this->scene.Add();
  const auto second = this->scene.Add();
  this->scene.SetInstances(first, instances);
  this->scene.SetInstances(second, instances);
  try
  {
    this->scene.Commit();
    FAIL() << "no error";
  }
  catch (const rtg::Error& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("8 mesh glyphs"), std::string::npos) << text;
    EXPECT_NE(text.find("is 7"), std::string::npos) << text;
  }
  // Its remedy helps.
  this->scene.SetVisible(second, false);
  this->scene.Commit();
  EXPECT_EQ(this->Probe({ { { 0.2, 0.1, 5 }, { 0, 0, -1 } } })[0].setId, first);
}

/// A compiler may load what a set lacks, and drop it: there is something at every address.
TEST_F(MeshTest, ThereIsSomethingAtEveryAddress)
{
  RTG_NEEDS(rtg::Structure::Boxes);
  this->scene.GetState().structure = rtg::Structure::Boxes;
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  instances.centers = { glm::vec3(0.0f) };
  this->scene.SetInstances(this->scene.Add(), instances);
  this->scene.Commit();
  const rtg::device::GlyphSetRecord& record = this->scene.GetState().records.sets.front();
#define RTG_EXPECT_ADDRESS(number, BIT, type, name, values, words) EXPECT_NE(record.name, 0u) << words;
  RTG_GLYPH_ARRAYS(RTG_EXPECT_ADDRESS)
#undef RTG_EXPECT_ADDRESS
  EXPECT_NE(record.colorTable, 0u);
  EXPECT_NE(record.tree.order, 0u);
}

TEST_F(MeshTest, SaysWhatIsWrongWithAMesh)
{
  const auto id = this->scene.Add();
  const auto message = [&](std::shared_ptr<const rtg::TriangleMesh> mesh)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Mesh;
    instances.mesh = std::move(mesh);
    instances.centers = { { 0, 0, 0 } };
    return rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); });
  };
  EXPECT_NE(message(nullptr).find("no triangle"), std::string::npos);
  EXPECT_NE(message(Share({})).find("no triangle"), std::string::npos);
  rtg::TriangleMesh mesh = BoxMesh();
  mesh.triangles[3].y = 8;
  EXPECT_NE(message(Share(mesh)).find("corner 8 of 8"), std::string::npos);
  mesh = BoxMesh();
  mesh.normals.resize(7);
  EXPECT_NE(message(Share(mesh)).find("7 normals"), std::string::npos);
  EXPECT_EQ(message(Share(BoxMesh())), "");
}
