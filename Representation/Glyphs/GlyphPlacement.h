/**
 * @class   GlyphPlacement
 * @brief   where the actor's matrix puts glyphs, and how the data rotate them
 *
 * The linear part of the matrix is the identity, a rotation with uniform scale, or a map that also shears.
 */
#ifndef GlyphPlacement_h
#define GlyphPlacement_h

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

class vtkMatrix4x4;

namespace rtglyphs
{

struct GlyphPlacement
{
  bool Identity = true;
  bool Uniform = true; // a rotation with uniform scale
  glm::dmat3 Linear{ 1.0 };
  glm::dvec3 Offset{ 0.0 };
  double Scale = 1.0; // negative: mirrored
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };

  /**
   * Null is the identity.
   */
  explicit GlyphPlacement(vtkMatrix4x4* matrix);

  /**
   * The image of a point.
   */
  glm::dvec3 operator()(const glm::dvec3& x) const { return this->Linear * x + this->Offset; }

  /**
   * Size and rotation of a glyph's image. Exact but for shearing maps of other shapes than spheres: the sheared image
   * is no glyph, and its straight-angled neighbor is taken.
   */
  void Apply(bool sphere, glm::dvec3& size, glm::dquat& rotation) const;

  /**
   * vtkGlyph3DMapper's rotation of a glyph, given a tuple of an orientation array and one of
   * GlyphSettings::OrientationModes. False: the tuple gives no rotation.
   */
  static bool RotationFromTuple(const double* tuple, int mode, glm::dquat& rotation);
};

} // namespace rtglyphs

#endif
