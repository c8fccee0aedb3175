#include "Camera.h"

#include "Finite.h"
#include "Glyphs.h"

#include <cmath>

namespace rtg
{

Camera Camera::FromWorldToClip(const glm::dmat4& worldToClip)
{
  const glm::dmat4 inverse = glm::inverse(worldToClip);
  const auto unproject = [&](double x, double y, double z)
  {
    const glm::dvec4 p = inverse * glm::dvec4(x, y, z, 1.0);
    return glm::dvec3(p) / p.w;
  };
  const glm::dvec3 near0 = unproject(0, 0, -1);
  const glm::dvec3 nearX = unproject(1, 0, -1);
  const glm::dvec3 nearY = unproject(0, 1, -1);
  const glm::dvec3 far0 = unproject(0, 0, 1);
  const glm::dvec3 farX = unproject(1, 0, 1);
  const glm::dvec3 farY = unproject(0, 1, 1);
  if (!IsFinite(near0) || !IsFinite(nearX) || !IsFinite(nearY) || !IsFinite(far0) || !IsFinite(farX) ||
    !IsFinite(farY) || near0 == far0)
  {
    throw Error("Ray Traced Glyphs: the camera's matrix cannot be inverted; reset the camera or its "
                "clipping range.");
  }

  // Both clipping planes are perpendicular to the view axis, also when the frustum is off-axis.
  Camera camera;
  const glm::dvec3 nearSpanX = nearX - near0;
  const glm::dvec3 nearSpanY = nearY - near0;
  glm::dvec3 axis = glm::normalize(glm::cross(nearSpanX, nearSpanY));
  if (glm::dot(axis, far0 - near0) < 0)
  {
    axis = -axis;
  }
  const double separation = glm::dot(axis, far0 - near0);

  // The last row of the matrix is (0, 0, 0, w) exactly when the projection is parallel.
  const glm::dvec3 wRow(worldToClip[0].w, worldToClip[1].w, worldToClip[2].w);
  camera.parallel = glm::length(wRow) * separation < 1e-12 * std::abs(worldToClip[3].w);
  if (camera.parallel)
  {
    camera.forward = (far0 - near0) / separation;
    camera.right = camera.up = glm::dvec3(0.0);
    camera.eye = near0;
    camera.eyeRight = nearSpanX;
    camera.eyeUp = nearSpanY;
    camera.nearDepth = 0.0;
    camera.farDepth = separation;
    // Window depth runs linearly from 0 to 1 between the planes.
    camera.depthA = 0.0;
    camera.depthB = 1.0 / separation;
    camera.position = near0;
    return camera;
  }

  // The eye is where the rays through the planes' corners meet; w is the view depth up to a factor.
  const double nearW = glm::dot(wRow, near0) + worldToClip[3].w;
  const double wPerDepth = glm::dot(wRow, axis);
  camera.nearDepth = nearW / wPerDepth;
  camera.farDepth = camera.nearDepth + separation;
  camera.forward = (far0 - near0) / separation;
  camera.right = nearSpanX / camera.nearDepth;
  camera.up = nearSpanY / camera.nearDepth;
  camera.eye = near0 - camera.nearDepth * camera.forward;
  camera.eyeRight = camera.eyeUp = glm::dvec3(0.0);
  camera.position = camera.eye;
  const double n = camera.nearDepth;
  const double f = camera.farDepth;
  // (1/n - 1/s) / (1/n - 1/f) = f/(f-n) - f n / ((f-n) s)
  camera.depthA = f / (f - n);
  camera.depthB = -f * n / (f - n);
  return camera;
}

// A matrix whose entries are rounded otherwise moves points by some units in the last place of their coordinates, and
// directions by as much seen from the near plane.
bool Camera::IsNear(const Camera& other) const
{
  constexpr double rounding = 1e-14;
  const double place = rounding * (glm::length(this->eye) + this->farDepth);
  const double direction = rounding + (this->parallel ? place / this->farDepth : place / this->nearDepth);
  return this->parallel == other.parallel && glm::distance(this->eye, other.eye) <= place &&
    glm::distance(this->position, other.position) <= place && glm::distance(this->eyeRight, other.eyeRight) <= place &&
    glm::distance(this->eyeUp, other.eyeUp) <= place && glm::distance(this->forward, other.forward) <= direction &&
    glm::distance(this->right, other.right) <= direction && glm::distance(this->up, other.up) <= direction &&
    std::abs(this->nearDepth - other.nearDepth) <= place && std::abs(this->farDepth - other.farDepth) <= place &&
    this->lensRadius == other.lensRadius && std::abs(this->focusDepth - other.focusDepth) <= place &&
    std::abs(this->lensDepth - other.lensDepth) <= place;
}

} // namespace rtg
