// Frame.glsl, Sobol.glsl and Principled.glsl as C++: what the samplers and the scattering model promise.
#include "Shading/Shading.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using namespace rtg::shading;

// Dimension 0 .. 15 of the sequence of that seed.
static uint Value(uint index, uint seed, uint dimension)
{
  const uvec2 pair = ScrambledSobol(index, seed, dimension / 2);
  return dimension % 2 ? pair.y : pair.x;
}

// Whether 2^(sum of bits) numbers from `start` on, a multiple of that, put one into each cell that bits[i] cuts of
// dimension dimensions[i] make.
static bool IsNet(uint start, uint seed, const std::vector<uint>& dimensions, const std::vector<uint>& bits)
{
  const uint all = std::accumulate(bits.begin(), bits.end(), 0u);
  std::set<uint> cells;
  for (uint i = 0; i < (1u << all); ++i)
  {
    uint cell = 0;
    for (std::size_t d = 0; d < bits.size(); ++d)
    {
      if (bits[d] > 0)
      {
        cell = (cell << bits[d]) | Value((start << all) + i, seed, dimensions[d]) >> (32 - bits[d]);
      }
    }
    cells.insert(cell);
  }
  return cells.size() == std::size_t(1) << all;
}

constexpr uint seeds[] = { 0u, 1u, 0x12345678u, 0xffffffffu };

// Every pair is a (0, 2)-sequence in base 2.
TEST(Sobol, EveryAlignedRunOfAPairIsANet)
{
  for (uint seed : seeds)
  {
    for (uint pair = 0; pair < 8; ++pair)
    {
      for (uint k = 1; k <= 8; ++k)
      {
        for (uint start : { 0u, 3u, 17u })
        {
          for (uint a = 0; a <= k; ++a)
          {
            ASSERT_TRUE(IsNet(start, seed, { 2 * pair, 2 * pair + 1 }, { a, k - a }))
              << seed << ' ' << pair << ' ' << k << ' ' << a;
          }
        }
      }
    }
  }
}

// Two pairs are a (0, 4)-sequence in base 4: 256 numbers are one in each of 4 x 4 x 4 x 4 cells.
TEST(Sobol, TwoPairsAreNetsInBaseFour)
{
  for (uint first = 0; first < 16; first += 4)
  {
    const std::vector<uint> dimensions = { first, first + 1, first + 2, first + 3 };
    for (uint k = 1; k <= 5; ++k)
    {
      for (uint a = 0; a <= k; ++a)
      {
        for (uint b = 0; a + b <= k; ++b)
        {
          for (uint c = 0; a + b + c <= k; ++c)
          {
            ASSERT_TRUE(IsNet(first + 5, seeds[first / 4], dimensions, { 2 * a, 2 * b, 2 * c, 2 * (k - a - b - c) }))
              << first << ' ' << k << ' ' << a << b << c;
          }
        }
      }
    }
  }
}

// All are a (0, 16)-sequence in base 16: 256 numbers are one in each of 16 x 16 cells of any two dimensions.
TEST(Sobol, AllPairsAreNetsInBaseSixteen)
{
  for (uint d = 0; d < 16; ++d)
  {
    for (uint e = 0; e < d; ++e)
    {
      ASSERT_TRUE(IsNet(2, 9u + d, { d, e }, { 4, 4 })) << d << ' ' << e;
    }
    ASSERT_TRUE(IsNet(1, 7u, { d, (d + 3) % 16, (d + 11) % 16 }, { 4, 4, 4 })) << d;
  }
}

TEST(Sobol, SeedsGiveIndependentNumbers)
{
  // Over many seeds each number is uniform, and two dimensions and neighbors in the sequence are uncorrelated.
  constexpr int count = 20000;
  double mean = 0.0, cross = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const uvec2 p = ScrambledSobol(5, Hash(i), 0u);
    const double x = UnitInterval(p.x) - 0.5, y = UnitInterval(p.y) - 0.5;
    mean += x / count;
    cross += x * y / count;
  }
  // Deviations sqrt(1/12) and 1/12 of one value; five of the means'.
  EXPECT_NEAR(mean, 0.0, 5.0 * std::sqrt(1.0 / 12.0 / count));
  EXPECT_NEAR(cross, 0.0, 5.0 / 12.0 / std::sqrt(double(count)));
}

namespace
{

struct Case
{
  const char* name;
  Surface surface;
};

std::vector<Case> Cases()
{
  const vec3 gold(1.0f, 0.7f, 0.3f), white(1.0f);
  return {
    { "diffuse", { gold, 0, 0.8f, 0, white, 0, 0, 0, white } },
    { "plastic", { gold, 0, 0.4f, 0.04f, white, 0, 0, 0, white } },
    { "rough metal", { gold, 1, 1.0f, 0, white, 0, 0, 0, white } },
    { "metal", { gold, 1, 0.5f, 0, white, 0, 0, 0, white } },
    { "mixed, tinted", { gold, 0.4f, 0.6f, 0.08f, { 0.5f, 1, 1 }, 0, 0, 0, white } },
    { "coated", { gold, 0.3f, 0.7f, 0.04f, white, 0.9f, 0.5f, 0.11f, { 1, 0.5f, 0.5f } } },
  };
}

} // namespace

// In proportion to the cosine: as many numbers of a net in every cell of the disc, of rings and sectors of equal area.
TEST(Frame, CosineDirectionsCoverTheDiscEvenly)
{
  const int rings = 8, sectors = 12;
  const uint count = 1u << 18;
  std::vector<int> cells(rings * sectors);
  for (uint i = 0; i < count; ++i)
  {
    const uvec2 bits = ScrambledSobol(i, 1u, 0u);
    const vec3 to = CosineDirection(vec2(UnitInterval(bits.x), UnitInterval(bits.y)));
    ASSERT_NEAR(glm::length(to), 1.0f, 1e-6f);
    ASSERT_GT(to.z, 0.0f);
    const double ring = rings * (double(to.x) * to.x + double(to.y) * to.y);
    const double sector = sectors * (std::atan2(to.y, to.x) / glm::two_pi<double>() + 0.5);
    ++cells[std::min(int(ring), rings - 1) * sectors + std::min(int(sector), sectors - 1)];
  }
  const double expected = double(count) / (rings * sectors);
  for (const int inside : cells)
  {
    EXPECT_NEAR(inside, expected, std::sqrt(expected)); // independent numbers' standard deviation
  }
}

// What is close in the square is close on the disc, and its corners and middle are directions, too.
TEST(Frame, CosineDirectionsKeepNeighboursTogether)
{
  const int side = 512;
  const auto at = [side](int i, int j) { return CosineDirection(vec2((i + 0.5f) / side, (j + 0.5f) / side)); };
  for (int i = 0; i + 1 < side; ++i)
  {
    for (int j = 0; j + 1 < side; ++j)
    {
      for (const vec3& next : { at(i + 1, j), at(i, j + 1) })
      {
        ASSERT_LT(glm::length(vec2(next) - vec2(at(i, j))), 3.0f / side) << i << ' ' << j;
      }
    }
  }
  for (const vec2& corner : { vec2(0.0f), vec2(0.5f), vec2(0.0f, 0.99999994f), vec2(0.99999994f) })
  {
    EXPECT_NEAR(glm::length(CosineDirection(corner)), 1.0f, 1e-6f);
    EXPECT_GT(CosineDirection(corner).z, 0.0f);
  }
}

// The directions that Scatter() draws, times their weights, have the density that Evaluate() gives: for lights and for
// bounces the surface is the same one. Checked as the light each gets from 5 x 8 regions of the hemisphere.
TEST(Principled, ScattersAsItEvaluates)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  const auto numbers = [&]
  {
    const auto pair = [&]
    {
      const float a = uniform(random);
      return vec2(a, uniform(random));
    };
    ScatterNumbers u;
    u.direction = pair();
    u.lobe = pair();
    u.facet = pair();
    u.coatFacet = pair();
    u.chance = pair();
    return u;
  };
  constexpr int count = 400000;
  constexpr int rings = 5, sectors = 8;
  for (const Case& c : Cases())
  {
    for (float z : { 0.95f, 0.5f, 0.15f })
    {
      const vec3 from(std::sqrt(1.0f - z * z), 0.0f, z);
      double drawn[rings * sectors] = {}, drawn2[rings * sectors] = {};
      double dense[rings * sectors] = {}, dense2[rings * sectors] = {};
      const auto region = [&](vec3 to)
      {
        const float turn = (std::atan2(to.y, to.x) / 6.2831853f + 1.0f);
        return std::min(int(to.z * rings), rings - 1) * sectors +
          std::min(int((turn - std::floor(turn)) * sectors), sectors - 1);
      };
      for (int i = 0; i < count; ++i)
      {
        vec3 to;
        const double weight = Scatter(c.surface, from, numbers(), to).g;
        ASSERT_GT(to.z, 0.0f);
        drawn[region(to)] += weight;
        drawn2[region(to)] += weight * weight;
        // Uniform directions
        const float height = uniform(random), angle = 6.2831853f * uniform(random);
        const float radius = std::sqrt(std::max(1.0f - height * height, 0.0f));
        const vec3 other(radius * std::cos(angle), radius * std::sin(angle), std::max(height, 1e-6f));
        const double value = Evaluate(c.surface, from, other, numbers()).g * 6.2831853;
        dense[region(other)] += value;
        dense2[region(other)] += value * value;
      }
      // What roulette takes for the fraction of the light that comes back is so to a fifth: it leaves out what
      // roughness does.
      const double albedo = std::accumulate(drawn, drawn + rings * sectors, 0.0) / count;
      EXPECT_NEAR(rtg::shading::AlbedoSeen(c.surface, z).g, albedo, 0.2) << c.name << ", z " << z;
      for (int k = 0; k < rings * sectors; ++k)
      {
        const double deviation = std::sqrt(drawn2[k] + dense2[k]) / count;
        EXPECT_NEAR(drawn[k] / count, dense[k] / count, 5.0 * deviation + 1e-6)
          << c.name << ", z " << z << ", region " << k;
      }
    }
  }
}

// Values of the model as the papers write them, in double: Burley 2012 (widths, diffuse lobe, Schlick's F), Walter et
// al., "Microfacet Models for Refraction", EGSR 2007 (D), Heitz, "Understanding the Masking-Shadowing Function", JCGT
// 3(2), 2014 (G of both directions, equation 99).
TEST(Principled, HasThePapersValues)
{
  const double pi = 3.14159265358979324;
  const double angles[][3] = { // of `from`, of `to`, between them around the normal
    { 0.1, 0.2, 0.0 }, { 0.1, 0.2, 3.1 }, { 0.7, 0.7, 3.14 }, { 0.7, 0.9, 1.0 }, { 1.2, 0.3, 2.0 }, { 1.2, 1.3, 3.0 },
    { 1.4, 1.4, 3.14 }, { 1.4, 0.05, 0.5 }, { 0.0, 0.8, 0.0 }, { 0.3, 1.45, 2.5 }, { 1.5, 1.5, 3.1 }, { 1.0, 1.0, 0.0 }
  };
  for (const auto& [a, b, turn] : angles)
  {
    const glm::dvec3 v(std::sin(a), 0.0, std::cos(a));
    const glm::dvec3 l(std::sin(b) * std::cos(turn), std::sin(b) * std::sin(turn), std::cos(b));
    const glm::dvec3 h = glm::normalize(v + l);
    const double fifth = std::pow(1.0 - glm::dot(l, h), 5);
    for (const double roughness : { 0.2, 0.5, 1.0 })
    {
      const double alpha = roughness * roughness, square = alpha * alpha;
      const double d = square / (pi * std::pow(h.z * h.z * (square - 1.0) + 1.0, 2));
      const auto lambda = [square](const glm::dvec3& w)
      { return 0.5 * (std::sqrt(1.0 + square * (1.0 - w.z * w.z) / (w.z * w.z)) - 1.0); };
      const double g = 1.0 / (1.0 + lambda(v) + lambda(l));
      // Black below its reflection. Of an index near that of air less is reflected at grazing angles: 50 times that at
      // normal incidence at most.
      for (const double f0 : { 0.04, 0.08, 0.03, 0.004 })
      {
        const double f = f0 + (std::min(50.0 * f0, 1.0) - f0) * fifth;
        const Surface surface{ vec3(0), 0, float(roughness), float(f0), vec3(1), 0, 0, 0, vec3(1) };
        const double expected = d * g * f / (4.0 * v.z);
        EXPECT_NEAR(Evaluate(surface, vec3(v), vec3(l), {}).g, expected, 2e-5 * expected + 1e-7)
          << a << ' ' << b << ' ' << turn << ", roughness " << roughness << ", reflectance " << f0;
      }
      const double fd90 = 0.5 + 2.0 * glm::dot(l, h) * glm::dot(l, h) * roughness;
      const double diffuse =
        (1.0 + (fd90 - 1.0) * std::pow(1.0 - l.z, 5)) * (1.0 + (fd90 - 1.0) * std::pow(1.0 - v.z, 5));
      EXPECT_NEAR(DiffuseShape(vec3(v), vec3(l), float(roughness)), diffuse, 1e-5 * diffuse);
      // Metal's color at a facet.
      const vec3 gold(1.0f, 0.7f, 0.3f);
      const vec3 seen = rtg::shading::MetalFresnel(gold, float(glm::dot(l, h)));
      EXPECT_NEAR(seen.b, 0.3 + 0.7 * fifth, 1e-5);
    }
  }
}

// DiffuseAlbedo against the sum over a fine grid of directions.
TEST(Principled, DiffuseAlbedoIsTheIntegral)
{
  for (float roughness : { 0.0f, 0.3f, 1.0f })
  {
    for (float z : { 0.01f, 0.2f, 0.5f, 1.0f })
    {
      const vec3 from(std::sqrt(1.0f - z * z), 0.0f, z);
      double sum = 0.0;
      const int rings = 8000, sectors = 32;
      for (int i = 0; i < rings; ++i)
      {
        // Cosine-distributed: equal areas of the unit disc.
        const float radius = std::sqrt((i + 0.5f) / rings);
        for (int j = 0; j < sectors; ++j)
        {
          const float angle = 6.2831853f * j / sectors;
          sum += DiffuseShape(from,
            vec3(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - radius * radius)), roughness);
        }
      }
      EXPECT_NEAR(sum / (rings * sectors), DiffuseAlbedo(z, roughness), 2e-5) << roughness << ' ' << z;
    }
  }
}
