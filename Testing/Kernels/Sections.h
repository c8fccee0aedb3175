// Cuts for tests.
#pragma once

#include "Glyphs.h"

#include <vector>

namespace rtg::testing
{

/// The planes of a box with that center and those half extents along a rotation's columns.
inline std::vector<Section::Plane> BoxPlanes(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half)
{
  std::vector<Section::Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      planes.push_back({ center + side * half[axis] * axes[axis], side * axes[axis] });
    }
  }
  return planes;
}

/// A material with that cut.
inline Material CutBy(const Section& section, Material material = {})
{
  material.section = section;
  return material;
}

} // namespace rtg::testing
