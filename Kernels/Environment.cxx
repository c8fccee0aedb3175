#include "Environment.h"

#include "Glyphs.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace rtg
{

namespace
{

constexpr std::uint32_t mostColumns = 512, mostRows = 256;
// Scattered rays find light below that multiple of the mean often enough.
constexpr double thresholdOverMean = 2.0;

// Sine of the latitude of the lower edge of a row.
double SineOf(std::uint32_t row, std::uint32_t rows)
{
  return -std::cos(glm::pi<double>() * row / rows);
}

// Walker's alias method after Vose, "A linear algorithm for generating random numbers with a given distribution", IEEE
// Transactions on Software Engineering 17(9), 1991.
void FillAliases(const std::vector<double>& weights, double total, std::vector<EnvironmentCell>& cells)
{
  std::vector<double> scaled(weights.size());
  std::vector<std::uint32_t> poor, rich;
  for (std::uint32_t i = 0; i < weights.size(); ++i)
  {
    scaled[i] = weights[i] / total * static_cast<double>(weights.size());
    (scaled[i] < 1.0 ? poor : rich).push_back(i);
  }
  for (std::uint32_t i = 0; i < cells.size(); ++i)
  {
    cells[i].probability = 1.0f;
    cells[i].alias = i;
  }
  while (!poor.empty() && !rich.empty())
  {
    const std::uint32_t from = poor.back(), to = rich.back();
    poor.pop_back();
    cells[from].probability = static_cast<float>(scaled[from]);
    cells[from].alias = to;
    scaled[to] -= 1.0 - scaled[from];
    if (scaled[to] < 1.0)
    {
      rich.pop_back();
      poor.push_back(to);
    }
  }
}

} // namespace

EnvironmentCells MakeEnvironmentCells(const EnvironmentImage& image)
{
  const std::uint32_t w = image.width, h = image.height;
  if (w == 0 || h == 0 || image.radiance.size() != std::size_t(w) * h)
  {
    throw Error("Ray Traced Glyphs: an environment image of " + std::to_string(w) + " x " + std::to_string(h) +
      " texels has " + std::to_string(image.radiance.size()) + " of them; give as many as its sides say.");
  }
  EnvironmentCells result;
  result.side = std::max({ 1u, (w + mostColumns - 1) / mostColumns, (h + mostRows - 1) / mostRows });
  result.columns = (w + result.side - 1) / result.side;
  result.rows = (h + result.side - 1) / result.side;

  const auto solidAngle = [&](std::uint32_t row)
  { return glm::two_pi<double>() / w * (SineOf(row + 1, h) - SineOf(row, h)); };
  double mean = 0.0;
  for (std::uint32_t y = 0; y < h; ++y)
  {
    for (std::uint32_t x = 0; x < w; ++x)
    {
      const glm::vec3& c = image.radiance[std::size_t(y) * w + x];
      mean += solidAngle(y) / (4.0 * glm::pi<double>()) * (double(c.x) + c.y + c.z) / 3.0;
    }
  }
  result.threshold = static_cast<float>(thresholdOverMean * mean);

  std::vector<double> weights(std::size_t(result.columns) * result.rows, 0.0);
  double total = 0.0;
  for (std::uint32_t y = 0; y < h; ++y)
  {
    for (std::uint32_t x = 0; x < w; ++x)
    {
      const glm::vec3 c = image.radiance[std::size_t(y) * w + x];
      const double above = std::max({ c.x, c.y, c.z }) - double(result.threshold);
      if (above > 0.0)
      {
        const double weight = above * solidAngle(y);
        weights[std::size_t(y / result.side) * result.columns + x / result.side] += weight;
        total += weight;
      }
    }
  }
  if (!(total > 0.0))
  {
    return result;
  }
  result.cells.resize(weights.size());
  FillAliases(weights, total, result.cells);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const std::uint32_t column = static_cast<std::uint32_t>(i % result.columns) * result.side;
    const std::uint32_t row = static_cast<std::uint32_t>(i / result.columns) * result.side;
    const double angle = glm::two_pi<double>() / w * (std::min(column + result.side, w) - column) *
      (SineOf(std::min(row + result.side, h), h) - SineOf(row, h));
    result.cells[i].density = static_cast<float>(weights[i] / total / angle);
  }
  return result;
}

glm::vec3 MeanRadiance(const EnvironmentImage& image, const glm::vec3& normal)
{
  const glm::dvec3 front = glm::cross(image.right, image.up);
  glm::dvec3 sum(0.0);
  for (std::uint32_t row = 0; row < image.height; ++row)
  {
    const double sine = 0.5 * (SineOf(row, image.height) + SineOf(row + 1, image.height));
    const double cosine = std::sqrt(std::max(1.0 - sine * sine, 0.0));
    // A texel's solid angle over pi.
    const double overPi = (SineOf(row + 1, image.height) - SineOf(row, image.height)) * 2.0 / image.width;
    for (std::uint32_t column = 0; column < image.width; ++column)
    {
      const double longitude = ((column + 0.5) / image.width - 0.5) * 2.0 * glm::pi<double>();
      const glm::dvec3 direction =
        cosine * (std::cos(longitude) * glm::dvec3(image.right) + std::sin(longitude) * front) +
        sine * glm::dvec3(image.up);
      const double facing = std::max(glm::dot(direction, glm::dvec3(normal)), 0.0);
      sum += overPi * facing * glm::dvec3(image.radiance[std::size_t(row) * image.width + column]);
    }
  }
  return sum;
}

} // namespace rtg
