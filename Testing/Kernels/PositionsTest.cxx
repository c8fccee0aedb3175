// Every glyph stands where it is, to 1e-6 of its size, whatever lies elsewhere: of every shape, at rest and in motion.
#include "BoxMesh.h"
#include "CaseRays.h"
#include "Probes.h"
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace
{

using rtg::Shape;
using rtg::Structure;
using rtg::Tracer;

constexpr float size = 0.01f;

class PositionsTest : public ::testing::TestWithParam<std::tuple<Structure, bool>>
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  Tracer& tracer = rtg::testing::SharedTracer();

  void SetUp() override { RTG_NEEDS(std::get<0>(GetParam())); }

  // Turned glyphs at these places, which move or not.
  static rtg::GlyphInstances Glyphs(Shape shape, const std::vector<glm::dvec3>& places, const glm::dvec3& origin)
  {
    rtg::GlyphInstances glyphs;
    glyphs.shape = shape;
    glyphs.uniformExponents =
      shape == Shape::NestedSuperquadric ? glm::vec3(0.7f, 0.8f, 0.8f) : glm::vec3(2.5f, 3.0f, 4.0f);
    glyphs.origin = origin;
    if (shape == Shape::Mesh)
    {
      glyphs.mesh = rtg::testing::Share(rtg::testing::BoxMesh());
    }
    for (const glm::dvec3& place : places)
    {
      const glm::dvec3 exact = place - origin;
      glyphs.centers.emplace_back(exact);
      glyphs.centersLow.emplace_back(exact - glm::dvec3(glyphs.centers.back()));
      glyphs.sizes3.emplace_back(size, 0.8f * size, 0.9f * size);
      glyphs.rotations.push_back(glm::normalize(glm::vec4(0.3f, -0.2f, 0.5f, 0.8f)));
      if (std::get<1>(GetParam()))
      {
        glyphs.motion.velocities.emplace_back(size, -size, 0.5f * size);
        glyphs.motion.angularVelocities.emplace_back(0.4f, 0.1f, -0.3f);
      }
    }
    return glyphs;
  }

  std::vector<rtg::testing::ProbeHit>
  Probe(const rtg::GlyphInstances& glyphs, const std::vector<rtg::testing::Probe>& probes)
  {
    rtg::Scene scene(this->device);
    scene.GetState().structure = std::get<0>(GetParam());
    const auto id = scene.Add();
    scene.SetInstances(id, glyphs);
    scene.Commit();
    return rtg::testing::TraceProbes(scene, probes);
  }

  // Probes meet that set where they meet the same glyph alone, at the origin.
  void ExpectAsAlone(rtg::Scene& scene, const std::vector<rtg::testing::Probe>& probes, rtg::Scene::SetId set,
    const std::vector<rtg::testing::ProbeHit>& alone)
  {
    const auto hits = rtg::testing::TraceProbes(scene, probes);
    int met = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      ASSERT_EQ(std::isfinite(hits[i].t), std::isfinite(alone[i].t)) << i;
      if (std::isfinite(alone[i].t))
      {
        ++met;
        EXPECT_EQ(hits[i].setId, set);
        const float length = glm::length(probes[i].direction);
        EXPECT_NEAR(hits[i].t * length, alone[i].t * length, 2e-6 * size + 1e-7);
      }
    }
    EXPECT_GT(met, 5);
  }
};

} // namespace

TEST_P(PositionsTest, SurviveOutliers)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
  // The marked glyph is the first; 1e6 away lies another crowd.
  for (const glm::dvec3& middle : { glm::dvec3(0.0), glm::dvec3(1e6, -3e5, 2e5) })
  {
    const glm::dvec3 marked = middle + glm::dvec3(0.123456789012, -0.3141592653589, 0.2718281828459);
    std::vector<rtg::testing::Probe> probes, aloneProbes;
    for (int i = 0; i < 40; ++i)
    {
      const glm::dvec3 from = 0.1 * glm::normalize(vector());
      const glm::dvec3 to = 0.3 * size * vector();
      probes.push_back({ marked + from, glm::vec3(to - from), 0.75f });
      aloneProbes.push_back({ from, probes.back().direction, 0.75f });
    }
    for (std::uint32_t shape = 0; shape <= static_cast<std::uint32_t>(Shape::Mesh); ++shape)
    {
      // Each shape sees both structures, rest and motion, in two combinations; the long tests take all four.
      const auto [structure, moves] = GetParam();
      if (rtg::testing::TimesRays() == 1 && (shape + (structure == Structure::Tree) + moves) % 2 != 0)
      {
        continue;
      }
      const auto alone = this->Probe(Glyphs(Shape(shape), { glm::dvec3(0.0) }, glm::dvec3(0.0)), aloneProbes);
      for (const double outlier : { 1e5, 1e30 })
      {
        std::vector<glm::dvec3> places{ marked, glm::dvec3(outlier, -0.5 * outlier, 0.7 * outlier) };
        for (int i = 0; i < 6; ++i)
        {
          places.push_back((i < 3 ? glm::dvec3(0.0) : glm::dvec3(1e6, -3e5, 2e5)) + glm::dvec3(2.0) + vector());
        }
        const auto hits = this->Probe(Glyphs(Shape(shape), places, glm::dvec3(0.5, 0.25, -0.5)), probes);
        int met = 0;
        for (std::size_t i = 0; i < hits.size(); ++i)
        {
          const bool found = std::isfinite(alone[i].t);
          met += found;
          ASSERT_EQ(std::isfinite(hits[i].t), found) << "shape " << shape << ", outlier at " << outlier;
          if (found)
          {
            EXPECT_EQ(hits[i].glyphId, 0u);
            // Both are right to 1e-6 sizes and to some ulp of t.
            const float length = glm::length(probes[i].direction);
            EXPECT_NEAR(hits[i].t * length, alone[i].t * length, 2e-6 * size + 1e-7)
              << "shape " << shape << ", outlier at " << outlier;
          }
        }
        EXPECT_GT(met, 5) << "shape " << shape;
      }
    }
  }
}

// A box is thinner here than what rounding moves the places by at which a ray meets its planes, because the ray comes
// from afar, or the set's origin lies far from the scene's. Some rays hardly leave a plane at all.
TEST_P(PositionsTest, NeedlesAreMet)
{
  constexpr int count = 64;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto& [origin, distance] : { std::pair(0.0, 1000.0), std::pair(123456.789, 1.0) })
  {
    rtg::GlyphInstances needles;
    needles.shape = Shape::Cylinder;
    needles.origin = glm::dvec3(origin);
    for (int i = 0; i < count + 2; ++i)
    {
      // The last two only make the scene so large that rays start within it.
      const float aside = i < count ? 0.0f : i == count ? 1500.0f : -1500.0f;
      needles.centers.emplace_back(2.0f * i + aside, aside, aside);
      needles.sizes3.emplace_back(1.0f, 1e-5f, 1e-5f);
      if (std::get<1>(GetParam()))
      {
        needles.motion.velocities.emplace_back(0.25f, 0.0f, 0.0f);
      }
    }
    std::vector<rtg::testing::Probe> probes;
    for (int i = 0; i < 10 * count; ++i)
    {
      glm::vec3 direction = glm::normalize(glm::vec3(uniform(random), uniform(random), uniform(random)));
      if (i % 4 == 0)
      {
        direction.y = std::copysign(1e-9f, direction.y);
      }
      const glm::dvec3 onAxis = origin + glm::dvec3(2.0 * (i % count) + 0.4 * uniform(random), 0.0, 0.0);
      probes.push_back({ onAxis - distance * glm::dvec3(direction), direction, 0.5f });
    }
    rtg::Scene scene(this->device);
    scene.GetState().structure = std::get<0>(GetParam());
    scene.SetInstances(scene.Add(), Glyphs(Shape::Sphere, { glm::dvec3(-1.0) }, glm::dvec3(0.0)));
    const auto set = scene.Add();
    scene.SetInstances(set, needles);
    scene.Commit();
    const auto hits = rtg::testing::TraceProbes(scene, probes);
    int missed = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      missed += hits[i].setId != set || hits[i].glyphId != i % count;
    }
    EXPECT_EQ(missed, 0) << "of " << hits.size() << " from " << distance << " away, at " << origin;
  }
}

// Sets have origins of their own; the scene's is the first one's, from which the others' need more digits than a float
// has.
TEST_P(PositionsTest, SurviveAnotherOrigin)
{
  const glm::dvec3 first(0.1, 0.2, 0.3), marked = first + glm::dvec3(123.456789012, -314.1592653589, 271.828182846);
  std::vector<rtg::testing::Probe> probes, aloneProbes;
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 from(0.1, 0.0005 * i - 0.005, 0.0003 * i);
    const glm::vec3 direction(-from + glm::dvec3(0.0, 1e-4 * i, 0.0));
    probes.push_back({ marked + from, direction, 0.75f });
    aloneProbes.push_back({ from, direction, 0.75f });
  }
  const auto alone = this->Probe(Glyphs(Shape::Sphere, { glm::dvec3(0.0) }, glm::dvec3(0.0)), aloneProbes);
  rtg::Scene scene(this->device);
  scene.GetState().structure = std::get<0>(GetParam());
  scene.SetInstances(scene.Add(), Glyphs(Shape::Sphere, { first }, first));
  const auto second = scene.Add();
  scene.SetInstances(second, Glyphs(Shape::Sphere, { marked }, marked));
  scene.Commit();
  this->ExpectAsAlone(scene, probes, second, alone);
}

// The driver's triangles are floats, as the transforms of their instances and the origins of rays are to it.
TEST_P(PositionsTest, MeshesSurviveAnotherOrigin)
{
  const glm::dvec3 marked(1e6 + 0.123456789, -3e5 - 0.3141592653, 2e5 + 0.2718281828);
  const auto mesh = [](const glm::dvec3& origin)
  {
    rtg::GlyphInstances glyphs = Glyphs(Shape::Mesh, { origin }, origin);
    glyphs.centersLow.clear();
    return glyphs;
  };
  std::vector<rtg::testing::Probe> probes, aloneProbes;
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 from(0.1, 0.0005 * i - 0.005, 0.0003 * i);
    const glm::vec3 direction(-from + glm::dvec3(0.0, 1e-4 * i, 0.0));
    probes.push_back({ marked + from, direction, 0.75f });
    aloneProbes.push_back({ from, direction, 0.75f });
  }
  const auto alone = this->Probe(mesh(glm::dvec3(0.0)), aloneProbes);
  rtg::Scene scene(this->device);
  scene.GetState().structure = std::get<0>(GetParam());
  const auto first = scene.Add();
  scene.SetInstances(first, Glyphs(Shape::Sphere, { glm::dvec3(0.0) }, glm::dvec3(0.0)));
  const auto second = scene.Add();
  scene.SetInstances(second, mesh(marked));
  // Also where the first set comes and goes, and with it the scene's origin.
  for (const bool both : { true, false, true })
  {
    scene.SetVisible(first, both);
    scene.Commit();
    SCOPED_TRACE(both);
    this->ExpectAsAlone(scene, probes, second, alone);
  }
}

// A set so small, and so far from the scene's origin, that rounding is larger than all of it: rays meet its glyphs and
// nothing else, whatever number of children the root of its tree has.
TEST_P(PositionsTest, SetsSmallerThanRoundingHaveTheirGlyphsOnly)
{
  const glm::dvec3 far(1e7);
  std::vector<rtg::testing::Probe> probes;
  for (int i = -20; i <= 20; ++i)
  {
    for (int k = -20; k <= 20; ++k)
    {
      probes.push_back({ far + glm::dvec3(0.1 * i * size, 0.1 * k * size, 1.0), glm::vec3(0, 0, -1) });
    }
  }
  for (const std::size_t count : { 1, 2, 3, 5, 9, 20, 40 })
  {
    rtg::Scene scene(this->device);
    scene.GetState().structure = std::get<0>(GetParam());
    scene.SetInstances(scene.Add(), Glyphs(Shape::Sphere, { glm::dvec3(0.0) }, glm::dvec3(0.0)));
    const auto second = scene.Add();
    scene.SetInstances(second, Glyphs(Shape::Sphere, std::vector<glm::dvec3>(count, far), far));
    scene.Commit();
    const auto hits = rtg::testing::TraceProbes(scene, probes);
    std::size_t met = 0, others = 0;
    for (const rtg::testing::ProbeHit& hit : hits)
    {
      met += std::isfinite(hit.t);
      others += std::isfinite(hit.t) && (hit.setId != second || hit.glyphId >= count);
    }
    EXPECT_GT(met, 10u) << count << " glyphs";
    EXPECT_EQ(others, 0u) << "of " << met << " hits, " << count << " glyphs";
  }
}

// Whatever the scene has shown before: its origin follows what is visible.
TEST_P(PositionsTest, SurviveHiddenSetsFarAway)
{
  const glm::dvec3 far(3e14, -1e14, 2e14);
  std::vector<rtg::testing::Probe> probes, aloneProbes;
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 from(0.1, 0.0005 * i - 0.005, 0.0003 * i);
    probes.push_back({ far + from, glm::vec3(-1, 0, 0), 0.75f });
    probes.back().direction = glm::vec3(far - probes.back().origin);
    aloneProbes.push_back({ probes.back().origin - far, probes.back().direction, 0.75f });
  }
  const auto alone = this->Probe(Glyphs(Shape::Sphere, { glm::dvec3(0.0) }, glm::dvec3(0.0)), aloneProbes);
  rtg::Scene scene(this->device);
  scene.GetState().structure = std::get<0>(GetParam());
  const auto first = scene.Add();
  scene.SetInstances(first, Glyphs(Shape::Sphere, { glm::dvec3(0.0) }, glm::dvec3(0.0)));
  scene.Commit();
  const auto second = scene.Add();
  scene.SetInstances(second, Glyphs(Shape::Sphere, { far }, far));
  scene.SetVisible(first, false);
  scene.Commit();
  const auto hits = rtg::testing::TraceProbes(scene, probes);
  int met = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    EXPECT_EQ(hits[i].t, alone[i].t) << i;
    if (std::isfinite(alone[i].t))
    {
      ++met;
      EXPECT_EQ(hits[i].setId, second);
    }
  }
  EXPECT_GT(met, 5);
}

// Rays meet no more boxes in a crowd when one glyph lies far away: the median surface of those of leaves is the same.
TEST(Boxes, AreAsTightBesideAnOutlier)
{
  RTG_NEEDS(Structure::Tree);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  rtg::GlyphInstances crowd;
  crowd.uniformSize = size;
  for (int i = 0; i < 4000; ++i)
  {
    crowd.centers.emplace_back(uniform(random), uniform(random), uniform(random));
  }
  const auto medianSurface = [&]
  {
    rtg::Scene scene(rtg::Device::Shared());
    scene.GetState().structure = Structure::Tree;
    const auto id = scene.Add();
    scene.SetInstances(id, crowd);
    scene.Commit();
    const rtg::PlacedTree& tree = scene.GetState().sets.at(id).placed.tree;
    const std::size_t first = rtg::GlyphTree::LevelOffset(tree.record.levels - 1), end = tree.record.nodesPerSlice;
    std::vector<double> surfaces;
    tree.nodes.Read(end * sizeof(rtg::GlyphTreeNode),
      [&](const void* read)
      {
        const auto* nodes = static_cast<const rtg::GlyphTreeNode*>(read);
        for (std::size_t at = 8 * first; at < 8 * end; ++at)
        {
          const rtg::GlyphTreeNode& node = nodes[at / 8];
          glm::dvec3 extent;
          for (int axis = 0; axis < 3; ++axis)
          {
            extent[axis] =
              std::ldexp(node.planes[axis][1][at % 8] - node.planes[axis][0][at % 8], node.exponent[axis] - 127);
          }
          surfaces.push_back(rtg::HalfSurface(extent));
        }
      });
    std::nth_element(surfaces.begin(), surfaces.begin() + surfaces.size() / 2, surfaces.end());
    return surfaces[surfaces.size() / 2];
  };
  const double alone = medianSurface();
  for (const float outlier : { 1e4f, 1e7f, 1e30f })
  {
    crowd.centers.emplace_back(outlier, -0.5f * outlier, 0.7f * outlier);
    EXPECT_LT(medianSurface(), 1.1 * alone) << outlier;
    crowd.centers.pop_back();
  }
}

INSTANTIATE_TEST_SUITE_P(Structures, PositionsTest,
  ::testing::Combine(::testing::Values(Structure::Boxes, Structure::Tree), ::testing::Bool()),
  [](const auto& info)
  {
    return std::string(std::get<0>(info.param) == Structure::Boxes ? "Boxes" : "Tree") +
      (std::get<1>(info.param) ? "Moving" : "AtRest");
  });
