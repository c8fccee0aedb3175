// Camera::FromWorldToClip must give the rays that the matrix's rasterization sees.
#include "Camera.h"
#include "Glyphs.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace
{

// Every point of a pixel's ray must project back to that pixel, at the window depth the camera states.
void ExpectRaysProjectBack(const glm::dmat4& matrix, bool parallel)
{
  const rtg::Camera camera = rtg::Camera::FromWorldToClip(matrix);
  EXPECT_EQ(camera.parallel, parallel);
  for (double x : { -1.0, -0.3, 0.0, 0.8 })
  {
    for (double y : { -0.9, 0.0, 0.45, 1.0 })
    {
      for (double f : { 0.0, 0.1, 0.5, 1.0 })
      {
        const double s = camera.nearDepth + f * (camera.farDepth - camera.nearDepth);
        const glm::dvec3 origin = camera.eye + x * camera.eyeRight + y * camera.eyeUp;
        const glm::dvec3 point = origin + s * (camera.forward + x * camera.right + y * camera.up);
        const glm::dvec4 clip = matrix * glm::dvec4(point, 1.0);
        EXPECT_NEAR(clip.x / clip.w, x, 1e-9);
        EXPECT_NEAR(clip.y / clip.w, y, 1e-9);
        const double depth = camera.depthA + (parallel ? camera.depthB * s : camera.depthB / s);
        EXPECT_NEAR(0.5 * clip.z / clip.w + 0.5, depth, 1e-9);
      }
    }
  }
}

const glm::dmat4 view = glm::lookAt(glm::dvec3(3, -2, 5), glm::dvec3(0.5, 0.25, -1), glm::dvec3(0.1, 1, 0));

} // namespace

TEST(Camera, Perspective)
{
  ExpectRaysProjectBack(glm::perspective(0.6, 1.5, 0.2, 40.0) * view, false);
}

TEST(Camera, Parallel)
{
  ExpectRaysProjectBack(glm::ortho(-2.0, 2.0, -1.5, 1.5, 0.5, 30.0) * view, true);
}

TEST(Camera, OffAxisFrustum)
{
  ExpectRaysProjectBack(glm::frustum(-0.3, 0.1, -0.05, 0.2, 0.5, 30.0) * view, false);
}

TEST(Camera, EyeIsTheViewpoint)
{
  const rtg::Camera camera = rtg::Camera::FromWorldToClip(glm::perspective(0.6, 1.0, 0.2, 40.0) * view);
  EXPECT_NEAR(glm::distance(camera.eye, glm::dvec3(3, -2, 5)), 0.0, 1e-10);
}

TEST(Camera, SingularMatrixIsAnError)
{
  EXPECT_THROW(rtg::Camera::FromWorldToClip(glm::dmat4(0.0)), rtg::Error);
}
