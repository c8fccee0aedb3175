#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace rtg
{

/// Environment light as an image in longitude and latitude. Direction d is at the column of the longitude
/// atan2(d . front, d . right), front = right x up, from -180 degrees at the left edge to 180 at the right one, and at
/// the row of the latitude asin(d . up), from -90 degrees at the lower edge: as VTK's skyboxes and image-based lighting
/// have it.
struct EnvironmentImage
{
  std::uint32_t width = 0, height = 0;       ///< texels, >= 1
  std::vector<glm::vec3> radiance;           ///< linear, >= 0; width x height, the lowest row first
  glm::vec3 right{ 1, 0, 0 }, up{ 0, 1, 0 }; ///< unit, perpendicular, world frame
};

/// Bright part of the image: it is sampled as a light, other rays see only what is below the threshold. A
/// threshold instead of weights by both densities (multiple importance sampling) because the density of a scattering is
/// not known for layered materials, whose lobes are chosen at random.
struct EnvironmentCell
{
  float probability; ///< of taking the cell itself when it was picked; else `alias` is taken (Walker 1977)
  std::uint32_t alias;
  float density; ///< of directions, per steradian
};

/// Sampling of what exceeds the threshold: cells of side x side texels, row by row from the lowest, those at the
/// right and upper edges smaller.
struct EnvironmentCells
{
  float threshold = 0.0f; ///< of each channel
  std::uint32_t side = 1, columns = 0, rows = 0;
  std::vector<EnvironmentCell> cells; ///< empty: nothing exceeds it
};

/// Throws rtg::Error for an image whose sizes do not fit.
EnvironmentCells MakeEnvironmentCells(const EnvironmentImage& image);

/// Irradiance on a surface with that normal (unit), over pi.
glm::vec3 MeanRadiance(const EnvironmentImage& image, const glm::vec3& normal);

} // namespace rtg
