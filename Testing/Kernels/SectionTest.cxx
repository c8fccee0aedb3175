// Cuts through glyphs: caps, light inside what is opened, against closed forms, and what moves. SectionShapesTest has
// the shapes.
#include "BoxMesh.h"
#include "LightFixture.h"
#include "Probes.h"
#include "Sections.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>
#include <optional>

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
using namespace rtg::testing;
using rtg::Section;
using rtg::Tracer;

class SectionTest : public rtg::testing::WithStructure<LightTest>
{
protected:
  // Away with what lies in front of z = height.
  static Section FrontOff(double height)
  {
    Section section;
    section.planes = { { { 0, 0, height }, { 0, 0, -2 } } };
    return section;
  }
};

// A cut beside everything leaves each bit of the picture as it was, in each kind of light, and nothing is built.
TEST_P(SectionTest, NothingCutIsNothingChanged)
{
  rtg::Material half;
  half.opacity = 0.5f;
  const std::vector<glm::vec3> sizes(60, glm::vec3(0.3f));
  const auto balls = this->Add(Shape::Sphere, Clutter(3, 60), sizes, White());
  const auto thin = this->Add(Shape::Cone, Clutter(4, 60), sizes, half);
  // One is cut and one is not, so that both pictures come from the same program.
  Section beside;
  beside.planes = BoxPlanes({ 5, 5, 5 }, glm::dmat3(1.0), glm::dvec3(1.0));
  this->Add(Shape::Sphere, { { 0.9f, 0.9f, 0 } }, { glm::vec3(0.1f) }, White());
  this->Add(Shape::Sphere, { { -0.9f, 0.9f, 0 } }, { glm::vec3(0.1f) }, CutBy(beside));
  this->lights = { rtg::Light() };
  this->settings.samples = 4;
  for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    for (const rtg::Pass pass : { rtg::Pass::Opaque, rtg::Pass::Translucent })
    {
      std::vector<std::uint32_t> pictures[2];
      const auto builds = this->scene.GetStatistics().structureBuilds;
      for (const bool cut : { false, true })
      {
        this->scene.SetMaterial(balls, CutBy(cut ? beside : Section()));
        this->scene.SetMaterial(thin, CutBy(cut ? beside : Section(), half));
        const Image image = this->Trace(pass);
        pictures[cut].assign(image.color, image.color + std::size_t(image.width) * image.height);
      }
      EXPECT_EQ(pictures[0], pictures[1]) << "shading " << int(shading) << ", pass " << int(pass);
      EXPECT_TRUE(builds == 0 || builds == this->scene.GetStatistics().structureBuilds);
    }
  }
}

// Caps have the color, the number and the light of a plane, and hide the shells behind them.
TEST_P(SectionTest, CapsAreFlatFacesOfTheirGlyphs)
{
  rtg::Material red;
  red.color = { 1.0f, 0.0f, 0.0f };
  const auto set =
    this->Add(Shape::Sphere, { { -0.5f, 0, 0 }, { 0.5f, 0, 0.1f } }, { glm::vec3(0.8f), glm::vec3(0.8f) }, red);
  this->settings.width = this->settings.height = 200;
  this->lights = { rtg::Light() };
  Section section = FrontOff(0.1);
  const auto expect = [&](const glm::vec3& left, const glm::vec3& right)
  {
    this->scene.SetMaterial(set, CutBy(section, red));
    const Image image = this->Trace();
    std::size_t wrong = 0, caps = 0;
    for (std::size_t i = 0; i < 40000; ++i)
    {
      const glm::dvec2 p((i % 200 + 0.5) / 100.0 - 1.0, (i / 200 + 0.5) / 100.0 - 1.0);
      const int ball = p.x > 0.0;
      const double radius = ball ? 0.4 : std::sqrt(0.16 - 0.01);
      const double distance = glm::length(p - glm::dvec2(ball ? 0.5 : -0.5, 0.0));
      if (std::abs(distance - radius) < 1e-4 || distance > radius)
      {
        continue;
      }
      ++caps;
      const glm::vec3 color = ball ? right : left;
      const glm::uvec3 bytes(255.0f * color + 0.5f);
      const std::uint32_t wanted = bytes.x | bytes.y << 8 | bytes.z << 16 | 255u << 24;
      wrong += image.color[i] != wanted || image.setIds[i] != set ||
        this->scene.OriginalGlyph(set, image.glyphIds[i]) != std::uint32_t(ball) ||
        std::abs(image.depth[i] - (4.9 - 0.01) / (20.0 - 0.01)) > 1e-6;
    }
    EXPECT_GT(caps, 9000u);
    EXPECT_EQ(wrong, 0u) << "of " << caps;
  };
  expect(red.color, red.color);
  this->scene.SetColors(set, rtg::GlyphColors({ 0xff00ff00u, 0xffff0000u }));
  expect({ 0, 1, 0 }, { 0, 0, 1 });
  section.capColor = glm::vec3(1.0f, 1.0f, 0.0f);
  expect({ 1, 1, 0 }, { 1, 1, 0 });
  // Also where the ambient color of the glyphs is another one.
  this->scene.SetColors(set, {});
  red.ambient = 1.0f;
  red.diffuse = 0.0f;
  expect({ 1, 1, 0 }, { 1, 1, 0 });
  // Bad cuts give a message.
  section.planes[0].normal = glm::dvec3(0.0);
  EXPECT_NE(
    MessageOf([&] { this->scene.SetMaterial(set, CutBy(section)); }).find("normal of length 0 "), std::string::npos);
  section.planes.assign(4, FrontOff(0.0).planes[0]);
  EXPECT_NE(MessageOf([&] { this->scene.SetMaterial(set, CutBy(section)); }).find("4 slabs"), std::string::npos);
}

TEST_P(SectionTest, WholeGlyphsGoByTheirCenters)
{
  const auto centers = Clutter(9, 200);
  const auto set = this->Add(Shape::Sphere, centers, std::vector<glm::vec3>(200, glm::vec3(0.1f)), White());
  for (const bool keepsInside : { false, true })
  {
    Section section;
    section.planes = BoxPlanes({ 0.1, 0, 0 }, glm::dmat3(1.0), glm::dvec3(0.6));
    section.keepsInside = keepsInside;
    section.faces = Section::Faces::Whole;
    this->scene.SetMaterial(set, CutBy(section));
    this->scene.Commit();
    std::size_t left = 0;
    for (std::uint32_t i = 0; i < 200; ++i)
    {
      const glm::vec3 c = centers[i];
      const bool inside = std::abs(c.x - 0.1f) < 0.6f && std::abs(c.y) < 0.6f && std::abs(c.z) < 0.6f;
      // From next to the shell, inwards: nothing else is nearer.
      const auto hit = rtg::testing::TraceProbes(this->scene, { { c + glm::vec3(0, 0, 0.0501f), { 0, 0, -1 } } })[0];
      const bool found = hit.t < 0.001f && hit.glyphId == i;
      left += found;
      EXPECT_EQ(found, inside == keepsInside) << "glyph " << i;
    }
    EXPECT_GT(left, 40u);
  }
}

// Inside of a sphere each point sees each other one under the same cosine: of the sky it sees the fraction of the
// sphere's area that is not there.
TEST_P(SectionTest, OpenedSpheresAreDarkAsTheirOpeningsSay)
{
  const auto set = this->Add(Shape::Sphere, { glm::vec3(0.0f) }, { glm::vec3(1.9f) }, White());
  this->settings.shading = Shading::AmbientOcclusion;
  this->settings.samples = 256;
  this->camera = this->LookFrom({ 0, 0, 5 }, { 0, 0, 0 }, 0.5);
  for (const double height : { 0.0, 0.3 })
  {
    Section section = FrontOff(height);
    section.faces = Section::Faces::Open;
    this->scene.SetMaterial(set, CutBy(section));
    this->Trace();
    const double open = 0.5 - height / 1.9;
    const double rays = 24.0 * 24.0 * 256.0;
    EXPECT_NEAR(this->ErrorOf(open).mean, 0.0, certain * std::sqrt(open * (1.0 - open) / rays));
    EXPECT_NEAR(this->ErrorOf(open).square, open * (1.0 - open) / 256.0, 0.2 * open * (1.0 - open) / 256.0);
  }
}

// In the middle of the floor of a box cut out of a box the sky is a rectangle overhead.
TEST_P(SectionTest, CavitiesAreDarkAsTheirOpeningsSay)
{
  const auto set = this->Add(Shape::Box, { glm::vec3(0.0f) }, { glm::vec3(2.0f) }, White());
  Section section;
  section.planes = BoxPlanes({ 0, 0, 1 }, glm::dmat3(1.0), { 0.6, 0.4, 0.7 });
  this->scene.SetMaterial(set, CutBy(section));
  this->settings.samples = 256;
  this->camera = this->LookFrom({ 0, 0, 5 }, { 0, 0, 0 }, 1e-3);
  const double x = 0.6 / 0.7, y = 0.4 / 0.7, a = std::sqrt(1.0 + x * x), b = std::sqrt(1.0 + y * y);
  const double open = 2.0 / std::numbers::pi * (x / a * std::atan(y / a) + y / b * std::atan(x / b));
  const double deviation = certain * std::sqrt(0.25 / (24.0 * 24.0 * 256.0));
  this->settings.shading = Shading::AmbientOcclusion;
  this->Trace();
  EXPECT_NEAR(this->ErrorOf(open).mean, 0.0, deviation);
  // Paths of one bounce are the same.
  this->settings.shading = Shading::PathTracing;
  this->settings.maximumBounces = 1;
  this->Trace();
  EXPECT_NEAR(this->ErrorOf(open).mean, 0.0, deviation);
}

// A ball of opacity a half with a slab out of its middle: two shells and a cap, whatever counts them.
TEST_P(SectionTest, TranslucentGlyphsHaveCapsAsLayers)
{
  rtg::Material half;
  half.opacity = 0.5f;
  this->settings.samples = 64;
  this->camera = this->LookFrom({ 0, 0, 5 }, { 0, 0, 0 }, 0.3);
  for (const Shape shape : { Shape::Sphere, Shape::Mesh })
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.mesh = Share(BoxMesh());
    instances.centers = { glm::vec3(0.0f) };
    const auto set = this->scene.Add();
    this->scene.SetInstances(set, instances);
    Section slab;
    slab.planes = BoxPlanes({ 0.01, 0.02, 0.0 }, glm::dmat3(1.0), { 5, 5, 0.1 });
    for (const auto& [faces, layers] : { std::pair(Section::Faces::Caps, 3), std::pair(Section::Faces::Open, 2) })
    {
      slab.faces = faces;
      this->scene.SetMaterial(set, CutBy(slab, half));
      const double alpha = 1.0 - std::pow(0.5, layers);
      const double rays = 24.0 * 24.0 * 64.0;
      for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing })
      {
        this->settings.shading = shading;
        this->Trace(rtg::Pass::Translucent);
        double mean = 0.0;
        for (const glm::vec4& pixel : this->tracer.Means())
        {
          mean += pixel.a / (24.0 * 24.0);
        }
        const bool chance = shading == Shading::PathTracing;
        EXPECT_NEAR(mean, alpha, chance ? certain * std::sqrt(alpha * (1.0 - alpha) / rays) : 1e-5)
          << "shape " << int(shape) << ", shading " << int(shading);
      }
    }
    this->scene.Remove(set);
  }
}

TEST_P(SectionTest, MovingGlyphsPassTheCut)
{
  for (const Shape shape : { Shape::Sphere, Shape::Mesh })
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.mesh = Share(BoxMesh());
    instances.centers = { glm::vec3(0.0f) };
    instances.motion.velocities = { { 0.0f, 0.0f, 1.0f } };
    instances.motion.shutterOpen = -1.0f;
    instances.motion.shutterClose = 1.0f;
    const auto set = this->scene.Add();
    this->scene.SetInstances(set, instances);
    Section section = FrontOff(0.1);
    const auto height = [&](float time)
    {
      this->scene.SetMaterial(set, CutBy(section));
      this->scene.Commit();
      return 4.0 - rtg::testing::TraceProbes(this->scene, { { { 0.1, 0.03, 4 }, { 0, 0, -1 }, time } })[0].t;
    };
    const double top = shape == Shape::Sphere ? std::sqrt(0.25 - 0.01 - 0.0009) : 0.5;
    for (const float time : { 0.1f, 0.3f, 0.5f, 0.6f, 0.7f, 0.9f })
    {
      const double z = 2.0 * time - 1.0;
      section.faces = Section::Faces::Caps;
      const double expected = z - top > 0.1 ? -INFINITY : std::min(z + top, 0.1), found = height(time);
      EXPECT_TRUE(found == expected || std::abs(found - expected) < 1e-6) << found << " at time " << time;
      section.faces = Section::Faces::Whole;
      EXPECT_EQ(std::isfinite(height(time)), z < 0.1) << "time " << time;
    }
    this->scene.Remove(set);
  }
}

// Closed meshes have caps whatever way round their triangles are; open ones have none. Surfaces name a triangle.
TEST_P(SectionTest, ClosedMeshesHaveCaps)
{
  rtg::TriangleMesh mesh = BoxMesh();
  std::swap(mesh.triangles[3].x, mesh.triangles[3].y);
  rtg::GlyphInstances instances;
  instances.shape = Shape::Mesh;
  instances.identifyTriangles = true;
  instances.centers = { glm::vec3(0.0f) };
  const auto set = this->scene.Add();
  const auto probe = [&](const rtg::TriangleMesh& source, const Section& section)
  {
    instances.mesh = Share(source);
    this->scene.SetInstances(set, instances);
    this->scene.SetMaterial(set, CutBy(section));
    this->scene.Commit();
    // Also along a diagonal of the far side, an edge of two triangles.
    for (const glm::dvec2& at : { glm::dvec2(0.1, 0.3), glm::dvec2(-0.2, 0.15) })
    {
      const auto hit =
        rtg::testing::TraceProbes(this->scene, { { { at, 4 }, { 0, 0, -1 } }, { { 0, 0, 4 }, { 0, 0, -1 } } })[0];
      EXPECT_NE(hit.glyphId, Image::noGlyph);
      if (source.triangles.size() == 12 && section.faces == Section::Faces::Caps)
      {
        EXPECT_NEAR(hit.t, 3.9, 1e-6);
        EXPECT_NEAR(hit.normal.z, 1.0, 1e-6);
        // The far side's
        EXPECT_TRUE(hit.glyphId == 8 || hit.glyphId == 9) << hit.glyphId;
      }
      else
      {
        EXPECT_NEAR(hit.t, 4.5, 1e-6);
      }
    }
  };
  probe(mesh, FrontOff(0.1));
  Section open = FrontOff(0.1);
  open.faces = Section::Faces::Open;
  probe(mesh, open);
  mesh.triangles.pop_back();
  probe(mesh, FrontOff(0.1));
  // Positions twice, as normals want them.
  rtg::TriangleMesh apart;
  for (const glm::uvec3& corner : BoxMesh().triangles)
  {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    for (int i = 0; i < 3; ++i)
    {
      apart.positions.push_back(BoxMesh().positions[corner[i]]);
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  probe(apart, FrontOff(0.1));
}

// Each point of a line's cap is that of the first piece which holds it, also where the line has moved.
TEST_P(SectionTest, LinesHaveOneCap)
{
  const std::vector<glm::dvec3> points = { { -0.7, -0.3, 0 }, { -0.25, 0.2, 0.1 }, { 0.1, 0.1, -0.05 },
    { 0.7, -0.4, 0 } };
  constexpr double radius = 0.2;
  rtg::GlyphInstances instances;
  instances.shape = Shape::RoundCone;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec3 way = points[i + 1] - points[i], middle = 0.5 * (points[i] + points[i + 1]);
    const glm::dvec3 axis = glm::normalize(way);
    const glm::dquat turn = glm::normalize(glm::dquat(1.0 + axis.x, 0.0, -axis.z, axis.y));
    const auto end = [&](std::size_t at)
    { return glm::vec4(glm::vec3(glm::conjugate(turn) * (points[at] - middle)), float(radius)); };
    instances.centers.emplace_back(middle);
    instances.sizes3.emplace_back(glm::length(way), 2 * radius, 2 * radius);
    instances.rotations.emplace_back(turn.x, turn.y, turn.z, turn.w);
    instances.before.push_back(i > 0 ? end(i - 1) : glm::vec4(0.0f));
    instances.after.push_back(i < 2 ? end(i + 2) : glm::vec4(0.0f));
  }
  const auto set = this->scene.Add();
  for (const bool moves : { false, true })
  {
    constexpr float time = 0.8f;
    if (moves)
    {
      instances.motion.velocities.assign(3, { 0.0f, 0.0f, 1.0f });
    }
    const double lift = instances.motion.Displacement(0, instances.motion.Time(time)).z;
    this->scene.SetInstances(set, instances);
    this->scene.SetMaterial(set, CutBy(FrontOff(0.03 + lift)));
    this->scene.Commit();
    std::vector<rtg::testing::Probe> probes;
    for (int i = 0; i < 60 * 60; ++i)
    {
      probes.push_back({ { (i % 60 + 0.5) / 30.0 - 1.0, (i / 60 + 0.5) / 30.0 - 1.0, 3.0 }, { 0, 0, -1 }, time });
    }
    const auto hits = rtg::testing::TraceProbes(this->scene, probes);
    std::size_t caps = 0, later = 0;
    for (std::size_t k = 0; k < probes.size(); ++k)
    {
      const glm::dvec3 p(probes[k].origin.x, probes[k].origin.y, 0.03);
      std::optional<std::uint32_t> first;
      bool certain = true;
      for (std::uint32_t i = 0; i < 3; ++i)
      {
        const glm::dvec3 way = points[i + 1] - points[i];
        const double along = std::clamp(glm::dot(p - points[i], way) / glm::dot(way, way), 0.0, 1.0);
        const double depth = radius - glm::length(p - points[i] - along * way);
        certain = certain && std::abs(depth) > 1e-5;
        first = !first && depth > 0.0 ? i : first;
      }
      if (certain && first)
      {
        ++caps;
        later += *first > 0;
        EXPECT_NEAR(hits[k].t, 2.97 - lift, 1e-6);
        EXPECT_EQ(hits[k].glyphId, *first) << p.x << " " << p.y;
      }
      else if (certain)
      {
        EXPECT_GT(hits[k].t, 2.97001 - lift);
      }
    }
    EXPECT_GT(later, 200u);
    EXPECT_GT(caps, later + 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Structures, SectionTest, ::testing::Values(rtg::Structure::Tree, rtg::Structure::Boxes),
  ::testing::PrintToStringParamName());

} // namespace
