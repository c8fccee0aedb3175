#include "GlyphPlacement.h"

#include "GlyphSettings.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Under a map other than a rotation with uniform scale. The image of a sphere is an ellipsoid.
void Deform(const glm::dmat3& linear, bool sphere, glm::dvec3& size, glm::dquat& rotation)
{
  glm::dmat3 image = linear * glm::mat3_cast(rotation);
  for (int i = 0; i < 3; ++i)
  {
    image[i] *= size[i];
  }
  if (!sphere)
  {
    for (int i = 0; i < 3; ++i)
    {
      size[i] = glm::length(image[i]);
      if (size[i] > 0.0)
      {
        image[i] /= size[i];
      }
    }
  }
  // Row by row, as VTK has them: the transposed ones.
  const auto rows = [](glm::dmat3& matrix) { return reinterpret_cast<double(*)[3]>(&matrix); };
  glm::dmat3 a = glm::transpose(image), u, vt;
  glm::dvec3 w;
  vtkMath::SingularValueDecomposition3x3(rows(a), rows(u), &w.x, rows(vt));
  glm::dmat3 turn = glm::transpose(sphere ? u : vt * u);
  if (glm::determinant(turn) < 0.0)
  {
    turn = -turn;
  }
  if (sphere)
  {
    size = glm::abs(w);
  }
  rotation = glm::normalize(glm::quat_cast(turn));
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphPlacement::GlyphPlacement(vtkMatrix4x4* matrix)
{
  if (!matrix || matrix->IsIdentity())
  {
    return;
  }
  this->Identity = false;
  const glm::dmat4 columns = glm::transpose(glm::make_mat4(matrix->GetData()));
  this->Linear = glm::dmat3(columns);
  this->Offset = glm::dvec3(columns[3]);
  const glm::dmat3 gram = glm::transpose(this->Linear) * this->Linear;
  const double square = (gram[0][0] + gram[1][1] + gram[2][2]) / 3.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      this->Uniform &= std::abs(gram[i][j] - (i == j ? square : 0.0)) <= 1e-9 * square;
    }
  }
  if (this->Uniform && square > 0.0)
  {
    // A mirror image is the negative of a turned one: the sign goes into the scale.
    this->Scale = std::copysign(std::sqrt(square), glm::determinant(this->Linear));
    this->Rotation = glm::normalize(glm::quat_cast(this->Linear / this->Scale));
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphPlacement::Apply(bool sphere, glm::dvec3& size, glm::dquat& rotation) const
{
  if (!this->Uniform)
  {
    Deform(this->Linear, sphere, size, rotation);
  }
  else if (!this->Identity)
  {
    size *= this->Scale;
    rotation = this->Rotation * rotation;
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphPlacement::RotationFromTuple(const double* tuple, int mode, glm::dquat& rotation)
{
  const int length = mode == rtglyphs::GlyphSettings::QUATERNION ? 4 : mode == rtglyphs::GlyphSettings::MATRIX ? 9 : 3;
  double largest = 0.0;
  for (int i = 0; i < length; ++i)
  {
    if (!std::isfinite(tuple[i]))
    {
      return false;
    }
    largest = std::max(largest, std::abs(tuple[i]));
  }
  if (mode == rtglyphs::GlyphSettings::ROTATION)
  {
    const glm::dvec3 half = 0.5 * glm::radians(glm::dvec3(tuple[0], tuple[1], tuple[2]));
    rotation = glm::dquat(std::cos(half.z), 0.0, 0.0, std::sin(half.z)) *
      glm::dquat(std::cos(half.x), std::sin(half.x), 0.0, 0.0) *
      glm::dquat(std::cos(half.y), 0.0, std::sin(half.y), 0.0);
    return true;
  }
  if (largest == 0.0)
  {
    return false;
  }
  // Scaled first: the square of a tiny or huge component would leave the range of double.
  if (mode == rtglyphs::GlyphSettings::QUATERNION)
  {
    rotation =
      glm::normalize(glm::dquat(tuple[0] / largest, tuple[1] / largest, tuple[2] / largest, tuple[3] / largest));
    return true;
  }
  if (mode == rtglyphs::GlyphSettings::MATRIX)
  {
    glm::dmat3 axes = glm::transpose(glm::make_mat3(tuple)) / largest; // column by column
    // Lengths say nothing, nor do small angles that rounding has left; a mirror image is no rotation.
    axes[0] = glm::normalize(axes[0]);
    axes[1] = glm::normalize(axes[1] - glm::dot(axes[0], axes[1]) * axes[0]);
    const glm::dvec3 third = glm::cross(axes[0], axes[1]);
    if (!(glm::dot(third, axes[2]) > 0.0))
    {
      return false; // NaN where an axis is zero or parallel to another
    }
    axes[2] = third;
    rotation = glm::normalize(glm::quat_cast(axes));
    return true;
  }
  // A half turn about the middle between +x and the direction. It is +z for -x, as in vtkGlyph3DMapper.
  const glm::dvec3 direction = glm::normalize(glm::dvec3(tuple[0], tuple[1], tuple[2]) / largest);
  if (direction.y == 0.0 && direction.z == 0.0)
  {
    rotation = direction.x < 0.0 ? glm::dquat(0.0, 0.0, 1.0, 0.0) : glm::dquat(1.0, 0.0, 0.0, 0.0);
    return true;
  }
  // 1 + x loses its digits where the direction is nearly -x; there (y^2 + z^2) / (1 - x) is the same.
  const double yz = direction.y * direction.y + direction.z * direction.z;
  const double x = direction.x < 0.0 ? yz / (1.0 - direction.x) : 1.0 + direction.x;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(x, direction.y, direction.z));
  rotation = glm::dquat(0.0, axis.x, axis.y, axis.z);
  return true;
}
