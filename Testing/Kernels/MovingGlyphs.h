// Glyphs that move, the same in double, and what their images and rays are held against.
#pragma once

#include "Probes.h"
#include "Scene.h"
#include "SceneState.h"
#include "SharedDevice.h"
#include "Shapes/Shapes.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace moving
{

using rtg::Image;
using Double = rtg::shapes::Kernel<double>;

// Sets of a few glyphs of one shape with random places, turns and motion.
class MovingGlyphs
{
public:
  explicit MovingGlyphs(unsigned seed)
    : random_(seed)
  {
  }

  float Uniform(float lower, float upper) { return std::uniform_real_distribution<float>(lower, upper)(this->random_); }

  glm::vec3 Vector(float reach)
  {
    return { this->Uniform(-reach, reach), this->Uniform(-reach, reach), this->Uniform(-reach, reach) };
  }

  glm::vec4 Rotation()
  {
    std::normal_distribution<float> normal;
    return glm::normalize(
      glm::vec4(normal(this->random_), normal(this->random_), normal(this->random_), normal(this->random_)));
  }

  rtg::GlyphInstances Make(rtg::Shape shape, std::size_t count, bool moves, bool spins)
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    for (std::size_t i = 0; i < count; ++i)
    {
      instances.centers.push_back(this->Vector(0.5f));
      instances.sizes3.push_back({ this->Uniform(0.1f, 0.4f), this->Uniform(0.1f, 0.4f), this->Uniform(0.1f, 0.4f) });
      instances.rotations.push_back(this->Rotation());
      if (moves)
      {
        instances.motion.velocities.push_back(this->Vector(2.0f));
        // Half of the paths turn back.
        instances.motion.accelerations.push_back(this->Vector(8.0f));
      }
      if (spins)
      {
        instances.motion.angularVelocities.push_back(this->Vector(4.0f));
      }
    }
    return instances;
  }

private:
  std::mt19937 random_;
};

inline glm::dvec4 Product(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec3 u(a), v(b);
  return glm::dvec4(a.w * v + b.w * u + glm::cross(u, v), a.w * b.w - glm::dot(u, v));
}

// A glyph in double at a time: the definition in Motion.h, written down once more.
inline Double::Glyph GlyphAt(const rtg::GlyphInstances& instances, std::size_t i, double time)
{
  const rtg::GlyphMotion& motion = instances.motion;
  Double::Glyph glyph{};
  glyph.center = glm::dvec3(instances.centers[i]);
  if (!motion.velocities.empty())
  {
    glyph.center += glm::dvec3(motion.velocities[i]) * time;
  }
  if (!motion.accelerations.empty())
  {
    glyph.center += glm::dvec3(motion.accelerations[i]) * time * time / 2.0;
  }
  glyph.size = instances.sizes3.empty() ? glm::dvec3(instances.uniformSize) : glm::dvec3(instances.sizes3[i]);
  glyph.sameSize = instances.sizes3.empty();
  glyph.rotated = true;
  glyph.rotation = instances.rotations.empty() ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(instances.rotations[i]);
  if (!motion.angularVelocities.empty())
  {
    const glm::dvec3 turn = glm::dvec3(motion.angularVelocities[i]) * time;
    const double angle = glm::length(turn);
    if (angle > 0.0)
    {
      glyph.rotation = Product(glm::dvec4(std::sin(angle / 2.0) / angle * turn, std::cos(angle / 2.0)), glyph.rotation);
    }
  }
  glyph.rotation = glm::normalize(glyph.rotation);
  const rtg::ArrowForm& arrow = instances.arrow;
  glyph.arrow = { arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding };
  glyph.fixedHeads = arrow.fixedHeads;
  glyph.unitLength = arrow.unitLength;
  glyph.exponents = glm::dvec3(instances.uniformExponents);
  return glyph;
}

class MotionTest : public ::testing::TestWithParam<rtg::Structure>
{
protected:
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Tracer& tracer = rtg::testing::SharedTracer();
  rtg::TraceSettings settings;
  // The square [-1, 1] x [-1, 1], seen along -z.
  rtg::Camera camera = rtg::Camera::FromWorldToClip(
    glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0) * glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0)));

  void SetUp() override
  {
    RTG_NEEDS(GetParam());
    this->settings.width = this->settings.height = 40;
    this->settings.keepSums = true;
    this->scene.GetState().structure = GetParam();
  }

  // Whether there are several slices of time.
  bool HasSlices() { return this->scene.GetState().records.sliceBits > 0; }

  rtg::Scene::SetId Add(const rtg::GlyphInstances& instances)
  {
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, instances);
    this->scene.Commit();
    return id;
  }

  // Rays at random times meet what `glyphAt` says of each glyph in double.
  void ExpectRaysMeet(rtg::Shape shape, const rtg::GlyphInstances& instances,
    const std::function<Double::Glyph(std::size_t, double)>& glyphAt, bool namesTriangles = false)
  {
    MovingGlyphs make(4);
    const std::size_t count = instances.Count();
    std::vector<rtg::testing::Probe> probes;
    for (int i = 0; i < 1000; ++i)
    {
      // At a glyph where it then is, so that most rays hit.
      rtg::testing::Probe probe;
      probe.time = make.Uniform(0.0f, 0.9999f);
      const Double::Glyph glyph = glyphAt(i % count, instances.motion.Time(probe.time));
      probe.origin = glm::dvec3(make.Vector(1.0f)) + glm::dvec3(0.0, 0.0, 6.0);
      probe.direction = glm::vec3(glyph.center + glm::dvec3(make.Vector(0.1f)) - probe.origin);
      probes.push_back(probe);
    }
    const auto found = rtg::testing::TraceProbes(this->scene, probes);
    int hits = 0, doubtful = 0;
    for (std::size_t i = 0; i < probes.size(); ++i)
    {
      Double::GlyphRay ray{};
      ray.origin = probes[i].origin;
      ray.direction = glm::dvec3(probes[i].direction);
      const double time = instances.motion.Time(probes[i].time);
      double nearest = INFINITY;
      glm::dvec3 normal(0.0);
      std::size_t hit = Image::noGlyph;
      for (std::size_t glyph = 0; glyph < count; ++glyph)
      {
        const Double::Glyph there = glyphAt(glyph, time);
        double t;
        if (Double::IntersectGlyph(shape, ray, there, 0.0, 100.0, t) && t < nearest)
        {
          nearest = t;
          hit = glyph;
          normal = Double::GlyphNormal(shape, ray, there, t);
        }
      }
      // A ray that grazes a glyph or an edge within rounding may see either.
      const bool met = hit != Image::noGlyph;
      hits += met;
      doubtful += met != std::isfinite(found[i].t) ||
        (met &&
          ((!namesTriangles && found[i].glyphId != hit) || std::abs(found[i].t - nearest) > 1e-4 ||
            glm::length(normal - glm::dvec3(found[i].normal)) > 1e-3));
    }
    EXPECT_GT(hits, 500);
    EXPECT_LE(doubtful, 3);
  }

  std::vector<glm::vec4> Means()
  {
    this->tracer.Trace(this->scene, this->camera, { rtg::Light() }, this->settings);
    return this->tracer.Means();
  }

  // Position in the square of sample s of a pixel, as local shading has it (Shading/Sampling.glsl).
  glm::dvec2 Position(std::uint32_t pixel, std::uint32_t s) const
  {
    const std::uint32_t side = this->settings.width;
    const double x = std::fmod(0.5 + s * 0.7548776662466927, 1.0);
    const double y = std::fmod(0.5 + s * 0.5698402909980532, 1.0);
    return (2.0 / side) * glm::dvec2(pixel % side + x, pixel / side + y) - 1.0;
  }

  // Independent times make each sample of each pixel a coin that shows a glyph with the fraction of the shutter's
  // opening for which one covers the sample's position; that fraction is given. The sum over pixels of squared
  // deviations over variances is then chi-squared. Fails by chance once in 10,000.
  void ExpectCoverage(const std::function<double(glm::dvec2)>& share)
  {
    this->settings.independentSamples = true;
    EXPECT_TRUE(this->HasSlices());
    const std::vector<glm::vec4> means = this->Means();
    double chiSquared = 0.0, total = 0.0, expectedTotal = 0.0, variance = 0.0;
    int freedoms = 0;
    for (std::uint32_t pixel = 0; pixel < means.size(); ++pixel)
    {
      double expected = 0.0, spread = 0.0;
      for (std::uint32_t s = 0; s < this->settings.samples; ++s)
      {
        const double p = share(this->Position(pixel, s));
        expected += p;
        spread += p * (1.0 - p);
      }
      const double found = double(means[pixel].a) * this->settings.samples;
      total += found;
      expectedTotal += expected;
      variance += spread;
      // Where chance has next to no part, say a whole pixel on the path's inside, nothing may differ.
      if (spread < 0.5)
      {
        ASSERT_NEAR(found, expected, 6.0) << pixel;
        continue;
      }
      chiSquared += (found - expected) * (found - expected) / spread;
      ++freedoms;
    }
    ASSERT_GT(freedoms, 100);
    // Wilson and Hilferty: the cube root of chi-squared over its freedoms is nearly normal.
    const double tail = 2.0 / (9.0 * freedoms);
    const double deviation = (std::cbrt(chiSquared / freedoms) - (1.0 - tail)) / std::sqrt(tail);
    EXPECT_LT(std::abs(deviation), 3.9) << chiSquared << " of " << freedoms;
    EXPECT_LT(std::abs(total - expectedTotal), 3.9 * std::sqrt(variance)) << total << ' ' << expectedTotal;
  }
};

// The fraction of times, of so many evenly spread, at which the only glyph lies on the ray along -z.
class BruteForce
{
public:
  BruteForce(const rtg::GlyphInstances& instances, int times)
    : shape_(instances.shape)
  {
    for (int i = 0; i < times; ++i)
    {
      Moment moment;
      moment.glyph = GlyphAt(instances, 0, instances.motion.Time((i + 0.5) / times));
      Double::GlyphBounds(this->shape_, moment.glyph, moment.lower, moment.upper);
      this->moments_.push_back(moment);
    }
  }
  double operator()(glm::dvec2 position) const
  {
    Double::GlyphRay ray{};
    ray.origin = { position, 5.0 };
    ray.direction = { 0.0, 0.0, -1.0 };
    double t;
    const auto hits = std::count_if(this->moments_.begin(), this->moments_.end(),
      [&](const Moment& moment)
      {
        return glm::all(glm::greaterThan(position, glm::dvec2(moment.lower))) &&
          glm::all(glm::lessThan(position, glm::dvec2(moment.upper))) &&
          Double::IntersectGlyph(this->shape_, ray, moment.glyph, 0.0, 10.0, t);
      });
    return double(hits) / double(this->moments_.size());
  }

private:
  struct Moment
  {
    Double::Glyph glyph;
    glm::dvec3 lower, upper; // its bounds
  };
  rtg::Shape shape_;
  std::vector<Moment> moments_;
};

// After the names of the tests.
inline std::string StructureName(const ::testing::TestParamInfo<rtg::Structure>& info)
{
  return info.param == rtg::Structure::Boxes ? "Boxes" : "Tree";
}

} // namespace moving
