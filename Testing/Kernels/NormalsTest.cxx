// The normals that pictures are shaded with, up to the silhouette: those of the kernel in double. They are computed by
// another compilation of the formulas than the tests of numerics use, which a driver's compiler may get wrong by
// itself.
#include "Scene.h"
#include "Shapes/Shapes.h"
#include "SharedDevice.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace rtg;
using Kernel = shapes::Kernel<double>;

struct Subject
{
  const char* name;
  Shape shape;
  glm::vec3 exponents;
};

void PrintTo(const Subject& subject, std::ostream* out)
{
  *out << subject.name;
}

constexpr Subject subjects[] = {
  { "Sphere", Shape::Sphere, glm::vec3(0.0f) },
  { "Capsule", Shape::Capsule, glm::vec3(0.0f) },
  { "Box", Shape::Box, glm::vec3(0.0f) },
  { "Cylinder", Shape::Cylinder, glm::vec3(0.0f) },
  { "Cone", Shape::Cone, glm::vec3(0.0f) },
  { "Arrow", Shape::Arrow, glm::vec3(0.0f) },
  { "Superquadric", Shape::Superquadric, glm::vec3(3.0f, 1.5f, 2.5f) },
  { "NestedConvex", Shape::NestedSuperquadric, glm::vec3(1.0f, 1.0f, 1.0f) },
  { "NestedSharp", Shape::NestedSuperquadric, glm::vec3(4.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f) },
  { "NestedTwoProfiles", Shape::NestedSuperquadric, glm::vec3(0.8f, 2.4f, 0.6f) },
};

constexpr int side = 160;

} // namespace

class NormalsTest : public ::testing::TestWithParam<Subject>
{
};

TEST_P(NormalsTest, ShadePicturesUpToTheSilhouette)
{
  const Subject& subject = GetParam();
  GlyphInstances instances;
  instances.shape = subject.shape;
  instances.centers = { glm::vec3(0.0f) };
  instances.sizes3 = { glm::vec3(1.0f, 0.7f, 0.5f) };
  instances.rotations = { glm::normalize(glm::vec4(0.1f, -0.2f, 0.25f, 0.9f)) };
  instances.exponents3 = { subject.exponents };
  Kernel::Glyph glyph{};
  glyph.size = instances.sizes3[0];
  glyph.rotation = instances.rotations[0];
  glyph.rotated = true;
  glyph.exponents = subject.exponents;
  const ArrowForm& arrow = instances.arrow;
  glyph.arrow = glm::dvec4(arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding);
  glyph.fixedHeads = arrow.fixedHeads;
  glyph.unitLength = arrow.unitLength;

  Scene scene(Device::Shared());
  scene.SetInstances(scene.Add(), instances);
  scene.Commit();
  const glm::dvec3 eye(1.5, 1.2, 3.6), forward = glm::normalize(-eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))), up = glm::cross(right, forward);
  const Camera camera = Camera::FromWorldToClip(
    glm::ortho(-0.7, 0.7, -0.7, 0.7, 1.0, 9.0) * glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0, 1, 0)));
  TraceSettings settings;
  settings.width = settings.height = side;
  settings.samples = 8;
  // A light beside the camera: the color is the cosine.
  const Image image = rtg::testing::SharedTracer().Trace(scene, camera, { Light() }, settings);
  std::vector<double> cosines(side * side, -2.0); // where the reference misses
  for (int at = 0; at < side * side; ++at)
  {
    const double x = 1.4 * ((at % side + 0.5) / side - 0.5), y = 1.4 * ((at / side + 0.5) / side - 0.5);
    const Kernel::GlyphRay ray{ eye + x * right + y * up, glm::dvec3(0.0), forward };
    double t = 0.0;
    if (Kernel::IntersectGlyph(subject.shape, ray, glyph, 0.0, 1e30, t))
    {
      cosines[at] = -glm::dot(Kernel::GlyphNormal(subject.shape, ray, glyph, t), forward);
    }
  }
  int hits = 0, wrong = 0, largest = 0;
  for (int at = 0; at < side * side; ++at)
  {
    // Between the least and the largest cosine around the pixel
    double least = 1.0, most = -2.0;
    for (const int dy : { -side, 0, side })
    {
      for (const int dx : { -1, 0, 1 })
      {
        const int beside = std::clamp(at + dx + dy, 0, side * side - 1);
        least = std::min(least, cosines[beside]);
        most = std::max(most, cosines[beside]);
      }
    }
    if (least > -2.0)
    {
      ++hits;
      const double found = (image.color[at] & 0xff) / 255.0;
      const double error = std::max({ least - found, found - most, 0.0 });
      wrong += error > 0.02;
      largest = std::max(largest, int(255.0 * error));
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_EQ(wrong, 0) << "of " << hits << " pixels, by up to " << largest << " of 255";
}

INSTANTIATE_TEST_SUITE_P(AllShapes, NormalsTest, ::testing::ValuesIn(subjects),
  [](const ::testing::TestParamInfo<Subject>& info) { return std::string(info.param.name); });
