// Cuts through each shape, at rest and taken along, against constructive geometry: what the 113-bit reference says of a
// ray and a glyph, less what is removed.
#include "CaseRays.h"
#include "Measure.h"
#include "Probes.h"
#include "Sections.h"
#include "SharedDevice.h"
#include "SubjectName.h"

#include "SceneState.h"
#include "Tracer.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{

using namespace rtg::testing;
using rtg::Section;
using rtg::Shape;
using rtg::Tracer;

struct Expected
{
  bool hit = false;
  bool cap = false;
  double t = 0.0;
  glm::dvec3 normal{ 0.0 }; ///< of a cap
  bool certain = true;      ///< nothing is decided by less than `tolerance`
};

/// What of the crossings of a line is left, and where the cut closes it. The ray begins at t = 0.
Expected
Cut(const std::vector<ReferenceCrossing>& crossings, const HardRay& ray, const Section& section, double tolerance)
{
  double in = -INFINITY, out = INFINITY, inBefore = -INFINITY, outBehind = INFINITY;
  glm::dvec3 inNormal(0.0), outNormal(0.0);
  for (const Section::Plane& plane : section.planes)
  {
    const glm::dvec3 normal(glm::vec3(glm::normalize(plane.normal)));
    const double height = glm::dot(normal, ray.origin - plane.point);
    const double slope = glm::dot(normal, glm::dvec3(ray.direction));
    const double at = -height / slope;
    if (slope < 0.0)
    {
      inBefore = std::max(inBefore, std::min(in, at));
      inNormal = at > in ? normal : inNormal;
      in = std::max(in, at);
    }
    if (slope > 0.0)
    {
      outBehind = std::min(outBehind, std::max(out, at));
      outNormal = at < out ? normal : outNormal;
      out = std::min(out, at);
    }
  }
  Expected expected;
  // Nor does the ray pass an edge of the body.
  expected.certain = std::abs(in - out) > tolerance && std::abs(in) > tolerance && std::abs(out) > tolerance &&
    !(in - inBefore <= tolerance) && !(outBehind - out <= tolerance);
  struct Part
  {
    double begin, end;
    bool cut;
    glm::dvec3 normal;
  };
  std::vector<Part> parts;
  if (section.keepsInside)
  {
    parts.push_back({ std::max(in, 0.0), out, in > 0.0, inNormal });
  }
  else if (in <= out)
  {
    parts.push_back({ 0.0, in, false, inNormal });
    parts.push_back({ std::max(out, 0.0), INFINITY, out > 0.0, -outNormal });
  }
  else
  {
    parts.push_back({ 0.0, INFINITY, false, inNormal });
  }
  for (const ReferenceCrossing& crossing : crossings)
  {
    const double t = double(crossing.t);
    expected.certain =
      expected.certain && std::abs(t - in) > tolerance && std::abs(t - out) > tolerance && std::abs(t) > tolerance;
  }
  for (const Part& part : parts)
  {
    if (expected.hit || !(part.begin <= part.end))
    {
      continue;
    }
    const auto next = std::find_if(
      crossings.begin(), crossings.end(), [&](const auto& crossing) { return double(crossing.t) >= part.begin; });
    const bool inside = (next - crossings.begin()) % 2 != 0;
    if (part.cut && inside && section.faces == Section::Faces::Caps)
    {
      expected.hit = expected.cap = true;
      expected.t = part.begin;
      expected.normal = part.normal;
    }
    else if (next != crossings.end() && double(next->t) <= part.end)
    {
      expected.hit = true;
      expected.t = double(next->t);
    }
  }
  return expected;
}

/// What is left of one glyph, as a scene of its own and by the reference, both at one time.
class SectionShapesTest : public ::testing::TestWithParam<Subject>
{
protected:
  glm::dvec3 Vector()
  {
    return { this->uniform(this->engine), this->uniform(this->engine), this->uniform(this->engine) };
  }

  glm::dmat3 Axes()
  {
    const glm::dvec3 x = glm::normalize(this->Vector()), y = glm::normalize(glm::cross(x, this->Vector()));
    return { x, y, glm::cross(x, y) };
  }

  // A plane, three planes, and boxes both ways through places inside a glyph of that size, from which rays go on. That
  // of the first place meets the first plane's cap.
  std::vector<Section> Sections(const std::vector<HardRay>& inside, double size)
  {
    std::vector<Section> sections(6);
    const auto near = [&] { return inside[this->engine() % inside.size()].origin; };
    for (Section& section : sections)
    {
      section.planes = BoxPlanes(near(), this->Axes(), 0.25 * size * (glm::abs(this->Vector()) + 0.3));
    }
    const HardRay& toward = inside.front();
    const glm::dvec3 normal = 3.0 * this->Vector();
    sections[0].planes = { { toward.origin, glm::faceforward(normal, -normal, glm::dvec3(toward.direction)) } };
    sections[1].planes = { { near(), this->Vector() }, { near(), this->Vector() }, { near(), this->Vector() } };
    sections[1].keepsInside = true;
    sections[3].keepsInside = true;
    sections[4].faces = Section::Faces::Open;
    sections[5].faces = Section::Faces::Open;
    sections[5].keepsInside = true;
    return sections;
  }

  // Glyph i of a case alone.
  static rtg::GlyphInstances Only(const rtg::GlyphInstances& instances, std::uint32_t i)
  {
    rtg::GlyphInstances one = instances;
    const auto keep = [&](auto& values)
    { values = values.empty() ? values : std::decay_t<decltype(values)>{ values[i] }; };
    keep(one.centers);
    keep(one.sizes1);
    keep(one.sizes3);
    keep(one.rotations);
    keep(one.exponents3);
    keep(one.before);
    keep(one.after);
    if (!instances.polynomials.empty())
    {
      const float* values = instances.polynomials[i];
      one.polynomials.values.assign(values, values + instances.polynomials.width);
    }
    return one;
  }

  // Cuts glyph i of the case in each way. `moves`: where it is at some time, after it has moved and rotated.
  void Judge(const HardCase& hard, std::uint32_t i, bool moves)
  {
    const float shutter = moves ? 0.9f : 0.0f;
    rtg::GlyphInstances one = Only(hard.instances, i), there = one;
    const double size = ReferenceGlyph(one, 0).Size();
    glm::dvec3 displacement(0.0);
    if (moves)
    {
      one.motion.velocities = { glm::vec3(3.0 * size * this->Vector()) };
      one.motion.accelerations = { glm::vec3(3.0 * size * this->Vector()) };
      one.motion.angularVelocities = { glm::vec3(3.0 * this->Vector()) };
      const double time = one.motion.Time(shutter);
      displacement = one.motion.Displacement(0, time);
      const glm::dvec4 before(one.rotations.empty() ? glm::vec4(0, 0, 0, 1) : one.rotations[0]);
      const glm::dquat after = one.motion.RotationAt(0, time) * glm::dquat(before.w, before.x, before.y, before.z);
      there.rotations = { glm::vec4(after.x, after.y, after.z, after.w) };
    }
    const auto set = this->scene.Add();
    this->scene.SetInstances(set, one);
    ReferenceGlyph reference(there, 0);
    std::vector<HardRay> aimed;
    std::vector<rtg::testing::Probe> probes;
    std::vector<std::vector<ReferenceCrossing>> crossings;
    std::vector<HardRay> inside; // the first: of the ray that is longest inside
    Quad longest = 0;
    for (const HardRay& ray : hard.rays)
    {
      if (ray.glyph == i)
      {
        aimed.push_back(ray);
        probes.push_back({ hard.instances.origin + ray.origin + displacement, ray.direction, shutter });
        crossings.push_back(reference.Crossings(ray.origin, ray.direction));
        if (crossings.back().size() > 1)
        {
          const Quad first = crossings.back()[0].t, second = crossings.back()[1].t, between = 0.5 * (first + second);
          inside.push_back({ ray.origin + double(between) * glm::dvec3(ray.direction), ray.direction, i });
          const Quad length = (second - first) * glm::length(glm::dvec3(ray.direction));
          if (length > longest)
          {
            longest = length;
            std::swap(inside.front(), inside.back());
          }
        }
      }
    }
    ASSERT_FALSE(inside.empty());
    for (const Section& section : this->Sections(inside, size))
    {
      Section placed = section;
      for (Section::Plane& plane : placed.planes)
      {
        plane.point += hard.instances.origin + displacement;
      }
      this->scene.SetMaterial(set, CutBy(placed));
      this->scene.Commit();
      const auto answers = rtg::testing::TraceProbes(this->scene, probes);
      for (std::size_t k = 0; k < aimed.size(); ++k)
      {
        const HardRay& ray = aimed[k];
        const double length = glm::length(glm::dvec3(ray.direction));
        const double farthest = glm::length(ray.origin) / length;
        const double tolerance = 2e-5 * size / length + 1e-6 * farthest;
        const Expected expected = Cut(crossings[k], ray, section, tolerance);
        const bool hit = std::isfinite(answers[k].t);
        ++this->rays;
        const bool same = hit == expected.hit && (!hit || std::abs(answers[k].t - expected.t) <= tolerance);
        // Where the line passes near a silhouette it crosses another number of times.
        const bool certain = expected.certain &&
          (same ||
            (reference.Crossings(ray.origin, ray.direction, 1.0 - 2e-5).size() == crossings[k].size() &&
              reference.Crossings(ray.origin, ray.direction, 1.0 + 2e-5).size() == crossings[k].size()));
        if (!certain)
        {
          continue;
        }
        ++this->judged;
        this->hits += hit;
        this->caps += expected.cap;
        EXPECT_TRUE(same) << "ray " << k << " of glyph " << i << (moves ? ", moving: " : ": ") << answers[k].t
                          << " instead of " << (expected.hit ? expected.t : INFINITY)
                          << (expected.cap ? ", a cap" : "");
        if (same && expected.cap)
        {
          EXPECT_LT(glm::length(glm::dvec3(answers[k].normal) - expected.normal), 1e-6);
          EXPECT_EQ(answers[k].glyphId, 0u);
          EXPECT_EQ(answers[k].setId, set);
        }
      }
    }
    this->scene.Remove(set);
  }

  std::mt19937_64 engine{ 5 };
  std::uniform_real_distribution<double> uniform{ -1.0, 1.0 };
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  std::size_t rays = 0, caps = 0, hits = 0, judged = 0;
};

TEST_P(SectionShapesTest, AreCutExactly)
{
  const HardCase hard = Cases(this->GetParam(), 2, 200).Case("turned");
  for (const bool moves : { false, true })
  {
    this->Judge(hard, 0, moves);
    this->Judge(hard, 1, moves);
  }
  EXPECT_GT(40 * this->caps, this->hits);
  EXPECT_GT(this->hits, 25u);
  EXPECT_GT(this->judged, this->rays * 9 / 10);
  std::cout << this->caps << " caps of " << this->hits << " hits of " << this->judged << " judged of " << this->rays
            << " rays\n";
}

INSTANTIATE_TEST_SUITE_P(Shapes, SectionShapesTest, ::testing::ValuesIn(HardSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Polynomials, SectionShapesTest, ::testing::ValuesIn(PolynomialSubjects()), SubjectName);
INSTANTIATE_TEST_SUITE_P(Nested, SectionShapesTest, ::testing::ValuesIn(NestedSubjects()), SubjectName);

} // namespace
