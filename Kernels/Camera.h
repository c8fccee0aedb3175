#pragma once

#include <glm/glm.hpp>

namespace rtg
{

/// The rays of an image. A ray through normalised device coordinates (x, y) in [-1, 1], y up, starts at
/// eye + x * eyeRight + y * eyeUp and runs along forward + x * right + y * up, whose component along
/// the view axis is 1: a point at ray parameter s lies at view depth s.
/// Perspective: eyeRight = eyeUp = 0. Parallel: right = up = 0.
struct Camera
{
  glm::dvec3 eye{ 0, 0, 1 };
  glm::dvec3 eyeRight{ 0 };
  glm::dvec3 eyeUp{ 0 };
  glm::dvec3 forward{ 0, 0, -1 };
  glm::dvec3 right{ 1, 0, 0 };
  glm::dvec3 up{ 0, 1, 0 };
  double nearDepth = 0.01; ///< view depths of the clipping planes
  double farDepth = 1000.0;
  /// Window depth in [0, 1] of view depth s: depthA + depthB / s (perspective), depthA + depthB * s (parallel).
  double depthA = 0.0;
  double depthB = 0.0;
  bool parallel = false;
  /// Where specular highlights are seen from: the eye. In parallel projection the matrix does not say; VTK then takes
  /// the camera's position, so set it after FromWorldToClip (which puts it on the view axis at depth 0).
  glm::dvec3 position{ 0, 0, 1 };

  /// A thin lens, square to the view axis, through whose middle the rays above run: in world units. Points at that view
  /// depth are in focus. Radius 0: all are. Sample 0 of a pixel runs through the middle.
  double lensRadius = 0.0;
  double focusDepth = 1.0;
  double lensDepth = 0.0; ///< where it stands

  bool operator==(const Camera&) const = default;

  /// Whether nothing but rounding tells it from another one.
  bool IsNear(const Camera& other) const;

  /// The rays that rasterisation with this matrix (OpenGL clip space, column vectors, world to clip) sees.
  /// Handles off-axis frusta (stereo, tiles). Throws rtg::Error when the matrix is singular or not finite.
  static Camera FromWorldToClip(const glm::dmat4& worldToClip);
};

} // namespace rtg
