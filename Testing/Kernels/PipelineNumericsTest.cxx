// The hard cases through the programs: the same bounds as for the kernels in C++.
#include "CaseRays.h"
#include "Measure.h"
#include "Probes.h"
#include "Scene.h"
#include "SharedDevice.h"
#include "SubjectName.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{

using namespace rtg;
using namespace rtg::testing;

/// A set of only one of the glyphs, so that no other hides it.
GlyphInstances Single(const GlyphInstances& all, std::uint32_t index)
{
  GlyphInstances one = all;
  const auto keep = [&](auto& values)
  {
    if (!values.empty())
    {
      values = { values[index] };
    }
  };
  keep(one.centers);
  keep(one.sizes1);
  keep(one.sizes3);
  keep(one.rotations);
  keep(one.exponents3);
  keep(one.before);
  keep(one.after);
  if (!all.polynomials.empty())
  {
    one.polynomials.values.assign(all.polynomials[index], all.polynomials[index] + all.polynomials.width);
  }
  return one;
}

/// How far the normal at the crossing at t turns where the ray moves by what the pipeline's 48 bits of a place leave of
/// it.
double TurnOfNormal(ReferenceGlyph& glyph, const HardRay& ray, const glm::vec3& center, double t)
{
  const auto normalAt = [&](const glm::dvec3& origin)
  {
    const std::vector<ReferenceCrossing> crossings = glyph.Crossings(origin, ray.direction);
    const auto nearest = std::min_element(crossings.begin(), crossings.end(),
      [&](const auto& a, const auto& b) { return std::abs(double(a.t) - t) < std::abs(double(b.t) - t); });
    return nearest == crossings.end() ? glm::dvec3(0.0) : ToDouble(nearest->normal);
  };
  const double moved = 0x1p-47 * glm::max(std::abs(center.x), glm::max(std::abs(center.y), std::abs(center.z)));
  const glm::dvec3 normal = normalAt(ray.origin);
  double turn = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -moved, moved })
    {
      glm::dvec3 origin = ray.origin;
      origin[axis] += side;
      turn = std::max(turn, glm::length(normalAt(origin) - normal));
    }
  }
  return turn;
}

class PipelineNumericsTest : public ::testing::TestWithParam<Subject>
{
protected:
  std::vector<Verdict> JudgePipeline(const HardCase& hard)
  {
    std::vector<Verdict> verdicts;
    for (std::uint32_t i = 0; i < hard.instances.Count(); ++i)
    {
      std::vector<HardRay> rays;
      std::vector<rtg::testing::Probe> probes;
      for (const HardRay& ray : hard.rays)
      {
        if (ray.glyph == i)
        {
          rays.push_back(ray);
          probes.push_back({ hard.instances.origin + ray.origin, ray.direction });
        }
      }
      if (rays.empty())
      {
        continue;
      }
      this->scene_.SetInstances(this->set_, Single(hard.instances, i));
      this->scene_.Commit();
      const std::vector<rtg::testing::ProbeHit> hits = rtg::testing::TraceProbes(this->scene_, probes);
      ReferenceGlyph reference(hard.instances, i);
      for (std::size_t k = 0; k < rays.size(); ++k)
      {
        const Answer answer{ std::isfinite(hits[k].t), hits[k].t, glm::dvec3(hits[k].normal) };
        verdicts.push_back(
          Judge<float>(reference, reference.Crossings(rays[k].origin, rays[k].direction), rays[k], 0.0, answer));
        Verdict& verdict = verdicts.back();
        if (verdict.hasNormal && !(verdict.normalExcess <= 1.0))
        {
          verdict.normalExcess = verdict.radians /
            (boundRadians + 2.0 * TurnOfNormal(reference, rays[k], hard.instances.centers[i], verdict.t));
        }
      }
    }
    return verdicts;
  }

  std::shared_ptr<Device> device_ = Device::Shared();
  Scene scene_{ device_ };
  Tracer& tracer_ = SharedTracer();
  Scene::SetId set_ = scene_.Add();
};

TEST_P(PipelineNumericsTest, KeepsTheBounds)
{
  std::vector<Verdict> all;
  for (const HardCase& hard : Cases(this->GetParam(), 3, 20).All())
  {
    SCOPED_TRACE(hard.subject + ": " + hard.situation);
    const std::vector<Verdict> verdicts = this->JudgePipeline(hard);
    const CaseReport report = Summarise(verdicts);
    EXPECT_EQ(report.falseHits, 0u);
    EXPECT_EQ(report.falseMisses, 0u);
    EXPECT_EQ(report.outOfBound, 0u) << "worst: " << report.maxExcess << " times the bound";
    EXPECT_EQ(report.normalsOutOfBound, 0u)
      << "worst: " << report.maxRadians << " radians, " << report.maxNormalExcess << " times the bound";
    all.insert(all.end(), verdicts.begin(), verdicts.end());
  }
  const CaseReport report = Summarise(all);
  EXPECT_GT(7 * report.compared, report.rays);
  std::cout << report.hits << " hits of " << report.rays << " rays; t: median " << report.medianUlps << " ulps, "
            << report.medianSizes << " sizes, worst " << report.maxExcess << " of the bound; normal: worst "
            << report.maxRadians << " radians; false hits " << report.falseHits << ", misses " << report.falseMisses
            << "\n";
}

INSTANTIATE_TEST_SUITE_P(Shapes, PipelineNumericsTest, ::testing::ValuesIn(HardSubjects()), SubjectName);

INSTANTIATE_TEST_SUITE_P(Polynomials, PipelineNumericsTest, ::testing::ValuesIn(PolynomialSubjects()), SubjectName);

INSTANTIATE_TEST_SUITE_P(Nested, PipelineNumericsTest, ::testing::ValuesIn(NestedSubjects()), SubjectName);

} // namespace
