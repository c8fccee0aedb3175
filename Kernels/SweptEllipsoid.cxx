#include "SweptEllipsoid.h"

#include "Glyphs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rtg
{

namespace
{

glm::vec4 Quaternion(const glm::dquat& q)
{
  return { q.x, q.y, q.z, q.w };
}

glm::dmat3 Thickened(const SymmetricTensor& tensor)
{
  const Eigensystem eigen = Decompose(tensor);
  const double least = thinnestTensorGlyph * thinnestTensorGlyph * eigen.values[0];
  const glm::dmat3& v = eigen.vectors;
  return v *
    glm::dmat3(std::max(eigen.values[0], 0.0) * glm::dvec3(1, 0, 0),
      std::max(eigen.values[1], least) * glm::dvec3(0, 1, 0), std::max(eigen.values[2], least) * glm::dvec3(0, 0, 1)) *
    glm::transpose(v);
}

// `toDiagonal`: the frame in which the matrix of the shared end is diagonal with these squares.
void StoreNext(
  const SweepEnd& end, const SweepEnd& far, const glm::dmat3& toDiagonal, const glm::dvec3& squares, float* values)
{
  const glm::dvec3 inverse = 1.0 / glm::sqrt(squares);
  const glm::dmat3 toBall = glm::dmat3(inverse.x, 0, 0, 0, inverse.y, 0, 0, 0, inverse.z) * toDiagonal;
  const Eigensystem grown =
    Decompose(SymmetricTensor::Of(toBall * Thickened(far.matrix) * glm::transpose(toBall) - glm::dmat3(1.0)));
  const glm::vec4 rotation = Quaternion(glm::quat_cast(grown.vectors));
  const glm::vec3 displacement(glm::transpose(grown.vectors) * toBall * (far.middle - end.middle)),
    growth(grown.values);
  const float all[] = { rotation.x, rotation.y, rotation.z, rotation.w, displacement.x, displacement.y, displacement.z,
    growth.x, growth.y, growth.z };
  std::copy(std::begin(all), std::end(all), values);
}

} // namespace

void StoreSweep(const SweepEnd& first, const SweepEnd& last, std::size_t index, GlyphInstances& instances,
  const std::optional<SweepEnd>& before, const std::optional<SweepEnd>& after)
{
  const glm::dvec3 displacement = last.middle - first.middle;
  const double length = glm::length(displacement);
  const glm::dmat3 firstMatrix = Thickened(first.matrix), lastMatrix = Thickened(last.matrix);
  const glm::dmat3 middle = 0.5 * (firstMatrix + lastMatrix), growth = 0.5 * (lastMatrix - firstMatrix);

  // The outline half-way as seen along the displacement: its axes are y and z.
  const glm::dvec3 x = displacement / length;
  const glm::dvec3 aside = std::abs(x.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  glm::dmat3 axes(x, glm::normalize(aside - glm::dot(aside, x) * x), glm::dvec3(0.0));
  axes[2] = glm::cross(x, axes[1]);
  glm::dmat3 local = glm::transpose(axes) * middle * axes;
  const double angle = 0.5 * std::atan2(2.0 * local[2][1], local[1][1] - local[2][2]);
  const glm::dvec3 y = std::cos(angle) * axes[1] + std::sin(angle) * axes[2];
  axes = glm::dmat3(x, y, glm::cross(x, y));
  local = glm::transpose(axes) * middle * axes;

  // middle = A A^T with A of the unit ball's coordinates v.
  const double across = std::sqrt(local[1][1]), down = std::sqrt(local[2][2]);
  const double shearedY = local[1][0] / across, shearedZ = local[2][0] / down;
  const double along = std::sqrt(std::max(local[0][0] - shearedY * shearedY - shearedZ * shearedZ, 0.0));
  const glm::dmat3 unit = glm::transpose(glm::dmat3(along, shearedY, shearedZ, 0, across, 0, 0, 0, down));
  const glm::dmat3 back = glm::inverse(axes * unit);
  const Eigensystem grown = Decompose(SymmetricTensor::Of(back * growth * glm::transpose(back)));

  const double reach = std::sqrt(std::max(glm::dot(x, firstMatrix * x), glm::dot(x, lastMatrix * x)));
  instances.centers[index] = glm::vec3(0.5 * (first.middle + last.middle));
  instances.sizes3[index] = glm::vec3(length + 2.0 * reach, 2.0 * across, 2.0 * down);
  instances.rotations[index] = Quaternion(glm::quat_cast(axes));
  instances.before[index] = Quaternion(glm::quat_cast(grown.vectors));
  instances.after[index] = glm::vec4(shearedY, shearedZ, along, length);
  instances.exponents3[index] = glm::vec3(glm::clamp(1.0 + grown.values, 1e-9, 2.0));
  if (!instances.polynomials.empty())
  {
    const glm::dmat3 toDiagonal = glm::transpose(grown.vectors) * back;
    const glm::dvec3 stored = glm::dvec3(instances.exponents3[index]) - 1.0;
    float* values = instances.polynomials[index];
    std::fill_n(values, valuesOfNextSweeps, 0.0f);
    if (before)
    {
      StoreNext(first, *before, toDiagonal, glm::max(1.0 - stored, glm::dvec3(1e-9)), values);
    }
    if (after)
    {
      StoreNext(last, *after, toDiagonal, glm::max(1.0 + stored, glm::dvec3(1e-9)), values + valuesOfNextSweeps / 2);
    }
  }
}

} // namespace rtg
