// Sobol.glsl and Principled.glsl as C++: what the samplers and the scattering model promise.
#include "BlueNoise.h"
#include "Shading/Shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace rtg::shading;

// Each aligned run of 2^k numbers has exactly one in every elementary interval of area 2^-k: a (0, 2)-sequence.
TEST(Sobol, EveryAlignedRunIsANet)
{
  for (uint seed : { 0u, 1u, 0x12345678u, 0xffffffffu })
  {
    for (uint k = 1; k <= 10; ++k)
    {
      for (uint start : { 0u, 3u << k, 17u << k })
      {
        for (uint a = 0; a <= k; ++a)
        {
          std::set<std::pair<uint, uint>> cells;
          for (uint i = 0; i < (1u << k); ++i)
          {
            const uvec2 p = ScrambledSobol(start + i, seed);
            cells.insert({ a ? p.x >> (32 - a) : 0, k - a ? p.y >> (32 - (k - a)) : 0 });
          }
          ASSERT_EQ(cells.size(), 1u << k) << seed << ' ' << k << ' ' << a;
        }
      }
    }
  }
}

TEST(Sobol, SeedsGiveIndependentNumbers)
{
  // Over many seeds each number is uniform, and two dimensions and neighbours in the sequence are uncorrelated.
  constexpr int seeds = 20000;
  double mean = 0.0, cross = 0.0;
  for (int i = 0; i < seeds; ++i)
  {
    const uvec2 p = ScrambledSobol(5, Hash(i));
    const double x = UnitInterval(p.x) - 0.5, y = UnitInterval(p.y) - 0.5;
    mean += x / seeds;
    cross += x * y / seeds;
  }
  // Deviations sqrt(1/12) and 1/12 of one value; five of the means'.
  EXPECT_NEAR(mean, 0.0, 5.0 * std::sqrt(1.0 / 12.0 / seeds));
  EXPECT_NEAR(cross, 0.0, 5.0 / 12.0 / std::sqrt(double(seeds)));
}

TEST(Permutation, IsOne)
{
  for (uint count : { 1u, 2u, 3u, 7u, 16u, 100u, 1000u })
  {
    std::set<uint> images;
    for (uint i = 0; i < count; ++i)
    {
      const uint image = Permuted(i, count, 77u);
      ASSERT_LT(image, count);
      images.insert(image);
    }
    EXPECT_EQ(images.size(), count);
  }
}

TEST(StratifiedNumbers, FillEveryCellOnce)
{
  for (uint count : { 4u, 16u, 20u, 100u })
  {
    const uint columns = uint(std::floor(std::sqrt(float(count))));
    const uint rows = count / columns;
    std::set<std::pair<uint, uint>> cells;
    for (uint i = 0; i < rows * columns; ++i)
    {
      const uvec2 p = Stratified(i, count, 9u);
      cells.insert({ uint(UnitInterval(p.x) * columns), uint(UnitInterval(p.y) * rows) });
    }
    EXPECT_EQ(cells.size(), rows * columns);
  }
}

TEST(BlueNoise, IsEvenAndHighFrequency)
{
  const std::uint32_t side = 32;
  const std::vector<std::uint32_t> tile = rtg::BlueNoiseTile(side);
  ASSERT_EQ(tile.size(), side * side);
  std::vector<std::uint32_t> sorted = tile;
  std::sort(sorted.begin(), sorted.end());
  double noise = 0.0, smooth = 0.0;
  for (std::size_t i = 0; i < tile.size(); ++i)
  {
    EXPECT_EQ(sorted[i] >> 22, i); // evenly spread
    // The variance of 3 x 3 means is a ninth of the values' when they are independent; here far less.
    double sum = 0.0;
    for (int k = 0; k < 9; ++k)
    {
      const std::uint32_t x = (i % side + k % 3) % side, y = (i / side + k / 3) % side;
      sum += UnitInterval(tile[y * side + x]) - 0.5;
    }
    smooth += sum * sum / 81.0;
    const double value = UnitInterval(tile[i]) - 0.5;
    noise += value * value;
  }
  EXPECT_LT(smooth, 0.25 * noise / 9.0);
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
        const vec3 other(
          radius * std::cos(angle), radius * std::sin(angle), std::max(height, 1e-6f));
        const double value = Evaluate(c.surface, from, other, numbers()).g * 6.2831853;
        dense[region(other)] += value;
        dense2[region(other)] += value * value;
      }
      for (int k = 0; k < rings * sectors; ++k)
      {
        const double deviation = std::sqrt(drawn2[k] + dense2[k]) / count;
        EXPECT_NEAR(drawn[k] / count, dense[k] / count, 5.0 * deviation + 1e-6)
          << c.name << ", z " << z << ", region " << k;
      }
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
            vec3(radius * std::cos(angle), radius * std::sin(angle),
              std::sqrt(1.0f - radius * radius)),
            roughness);
        }
      }
      EXPECT_NEAR(sum / (rings * sectors), DiffuseAlbedo(z, roughness), 2e-5)
        << roughness << ' ' << z;
    }
  }
}
