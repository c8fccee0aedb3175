// Shadows of the view's lights, and the plane that catches them, against closed forms.
#include "LightFixture.h"
#include "Shading/Shading.h"

#include <glm/gtc/packing.hpp>

namespace
{

using light::Image;
using light::Shading;
using light::Shape;
using light::White;

class ShadowTest : public light::LightTest
{
protected:
  void SetUp() override
  {
    light::LightTest::SetUp();
    this->settings.shadows = true;
    this->settings.independentSamples = false;
  }

  static rtg::Light Down(float angularRadius)
  {
    rtg::Light light;
    light.kind = rtg::Light::Kind::Directional;
    light.direction = { 0, -1, 0 };
    light.angularRadius = angularRadius;
    return light;
  }

  static rtg::Light Ball(const glm::dvec3& position, float radius)
  {
    rtg::Light light;
    light.kind = rtg::Light::Kind::Positional;
    light.position = position;
    light.radius = radius;
    return light;
  }

  // A row of pixels on the floor along x, from -half to half, seen from the side.
  void LookAlongTheFloor(double half, std::uint32_t pixels)
  {
    this->settings.width = pixels;
    this->settings.height = 1;
    this->camera = rtg::Camera::FromWorldToClip(glm::ortho(-half, half, -1e-4, 1e-4, 0.01, 20.0) *
      glm::lookAt(glm::dvec3(0, 0.2, 8), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0)));
  }

  // Where a pixel of that row sees the floor.
  double WindowDepth(int x) const
  {
    const glm::dvec3 start = this->camera.eye + (2.0 * (x + 0.5) / this->settings.width - 1.0) * this->camera.eyeRight;
    return this->camera.depthA - this->camera.depthB * start.y / this->camera.forward.y;
  }

  // Of a ball that shines, the fraction of its solid angle from a place on the floor that another ball leaves free; or
  // of the light that arrives there.
  static double FreeShare(const glm::dvec3& from, const glm::dvec3& shining, double radius, const glm::dvec3& ball,
    double ballRadius, bool ofLight)
  {
    const glm::dvec3 axis = glm::normalize(shining - from);
    const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.2, 0.9)));
    const glm::dvec3 y = glm::cross(axis, x);
    const double spread = 1.0 - std::sqrt(1.0 - std::pow(radius / glm::length(shining - from), 2));
    const double ballSine = ballRadius / glm::length(ball - from);
    const glm::dvec3 toBall = glm::normalize(ball - from);
    const int n = 300;
    double free = 0.0, all = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const double cosine = 1.0 - spread * (i + 0.5) / n;
      for (int j = 0; j < n; ++j)
      {
        const double turn = 2.0 * glm::pi<double>() * (j + 0.5) / n;
        const glm::dvec3 way =
          cosine * axis + std::sqrt(1.0 - cosine * cosine) * (std::cos(turn) * x + std::sin(turn) * y);
        const double along = glm::dot(way, toBall);
        const double weight = ofLight ? way.y : 1.0;
        all += weight;
        free += along < 0.0 || 1.0 - along * along > ballSine * ballSine ? weight : 0.0;
      }
    }
    return free / all;
  }
};

// Below a ball, a ball of light leaves umbra, penumbra and full light: in each mode that asks for lights.
TEST_F(ShadowTest, BallOfLightAboveABall)
{
  this->Add(Shape::Box, { { 0, -0.5f, 0 } }, { { 100.0f, 1.0f, 100.0f } }, White());
  this->Add(Shape::Sphere, { { 0, 1, 0 } }, { glm::vec3(0.8f) }, White()); // radius 0.4
  const glm::dvec3 place(0.3, 4.0, 0.0);
  const float radius = 0.5f;
  this->lights = { Ball(place, radius) };
  this->settings.samples = 4096;
  this->settings.lightFraction = 1.0f;
  this->settings.lightIntensity = 0.0f;
  this->settings.maximumBounces = 1;
  this->LookAlongTheFloor(1.5, 31);
  for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->settings.shadows = true;
    this->Trace();
    std::vector<float> shaded, lit;
    for (int x = 0; x < 31; ++x)
    {
      shaded.push_back(this->PixelMean(x, 0).r);
    }
    // Path tracing cannot do without shadows: the light of a place without the ball.
    const bool paths = shading == Shading::PathTracing;
    this->settings.shadows = false;
    if (paths)
    {
      this->scene.Remove(1);
    }
    this->Trace();
    int umbra = 0, penumbra = 0;
    for (int x = 0; x < 31; ++x)
    {
      double expected = 0.0; // mean over the pixel's width
      for (int i = 0; i < 16; ++i)
      {
        const glm::dvec3 from(1.5 * (2.0 * (x + (i + 0.5) / 16.0) / 31.0 - 1.0), 0.0, 0.0);
        expected += FreeShare(from, place, radius, glm::dvec3(0, 1, 0), 0.4, paths) / 16.0;
      }
      EXPECT_NEAR(shaded[x] / this->PixelMean(x, 0).r, expected, 0.01) << static_cast<int>(shading) << ' ' << x;
      umbra += expected < 1e-6;
      penumbra += expected > 0.1 && expected < 0.9;
    }
    EXPECT_GE(umbra, 3);
    EXPECT_GE(penumbra, 4);
  }
}

// Translucent glyphs dim light by their opacity, headlights and lights with shadows switched off cast none, and
// nothing shadows itself: such images are those without shadows.
TEST_F(ShadowTest, WhatCastsNone)
{
  rtg::Material half;
  half.opacity = 0.5f;
  this->Add(Shape::Box, { { 0, -1.0f, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, White());
  const auto roof = this->Add(Shape::Box, { { 0, 0, 0 } }, { { 1000.0f, 0.1f, 1000.0f } }, half);
  this->lights = { Down(0.0f) };
  this->camera = this->LookFrom({ 0, 5, 0.5 }, { 0, 0, 0 });
  this->settings.samples = 1024;
  this->Trace();
  const double interval = light::certain * std::sqrt(0.25 * 0.75 / 1024);
  for (const glm::vec4& mean : this->tracer.Means())
  {
    EXPECT_NEAR(mean.r, 0.25, interval); // two faces
  }

  this->settings.samples = 1; // the pixels' centers
  this->scene.SetMaterial(roof, White());
  this->camera = this->LookFrom({ 0, -0.3, 3 }, { 0, -0.9, 0 });
  rtg::Light other = Down(0.0f), headlight;
  other.castsShadow = false;
  const auto same = [this]
  {
    this->settings.shadows = true;
    this->Trace();
    const std::vector<glm::vec4> with = this->tracer.Means();
    this->settings.shadows = false;
    this->Trace();
    return with == this->tracer.Means();
  };
  for (const rtg::Light& light : { other, headlight })
  {
    this->lights = { light };
    EXPECT_TRUE(same());
    EXPECT_GT(this->PixelMean(12, 12).r, 0.1f);
  }
  this->lights = { Down(0.0f) };
  EXPECT_FALSE(same());
  this->scene.Remove(roof);

  const glm::vec4 turn = glm::normalize(glm::vec4(0.3f, 0.5f, -0.2f, 0.8f));
  float x = 900.0f;
  for (Shape shape : { Shape::Sphere, Shape::Box, Shape::Cylinder, Shape::Capsule, Shape::RoundCone, Shape::Cone })
  {
    this->Add(shape, { { x, 0, x - 900.0f } }, { { 0.5f, 0.01f, 0.2f } }, White(), { turn });
    x += 0.5f;
  }
  this->camera = this->LookFrom({ 901.25, 5, 1.25 }, { 901.25, 0, 1.25 }, 2.0);
  this->lights = { Down(3.0f) };
  EXPECT_TRUE(same());
}

// The ground shows how much of its light a ball keeps from it, and nothing else: over white it is the display color of
// what is left.
TEST_F(ShadowTest, GroundCatchesShadows)
{
  this->Add(Shape::Sphere, { { 0, 1, 0 } }, { glm::vec3(0.8f) }, White());
  this->settings.groundNormal = { 0, 1, 0 };
  this->settings.groundHeight = 0.0;
  this->settings.samples = 4096;
  this->settings.maximumBounces = 1;
  this->LookAlongTheFloor(1.5, 31);
  const glm::dvec3 place(0.3, 4.0, 0.0);
  for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    for (const bool skyOnly : { false, true })
    {
      if (skyOnly && shading == Shading::Local)
      {
        continue;
      }
      this->lights.clear();
      if (!skyOnly)
      {
        this->lights = { Ball(place, 0.5f) };
      }
      this->settings.lightFraction = skyOnly ? 0.0f : 1.0f;
      this->settings.lightIntensity = skyOnly ? 1.0f : 0.0f;
      const Image image = this->Trace();
      for (int x = 0; x < 31; ++x)
      {
        double expected = 0.0;
        for (int i = 0; i < 16; ++i)
        {
          const glm::dvec3 from(1.5 * (2.0 * (x + (i + 0.5) / 16.0) / 31.0 - 1.0), 0.0, 0.0);
          const double distance = glm::length(glm::dvec3(0, 1, 0) - from);
          // A ball of radius r whose center is d away in a direction of cosine c hides c r^2 / d^2 of a uniform sky.
          expected +=
            (skyOnly ? 0.16 / std::pow(distance, 3.0)
                     : 1.0 - FreeShare(from, place, 0.5, glm::dvec3(0, 1, 0), 0.4, shading == Shading::PathTracing)) /
            16.0;
        }
        expected *= shading == Shading::Local ? 0.5 : 1.0; // half of its light comes from elsewhere
        const glm::vec4 shown = glm::unpackUnorm4x8(image.color[x]);
        const double white = 1.0 - shown.a;
        const double light =
          shading == Shading::Local ? white : rtg::shading::DisplayToLinear(glm::vec3(static_cast<float>(white))).x;
        EXPECT_NEAR(1.0 - light, expected, 0.01) << static_cast<int>(shading) << ' ' << skyOnly << ' ' << x;
        EXPECT_EQ(glm::vec3(shown), glm::vec3(0.0f));
        EXPECT_TRUE(shown.a == 0.0f || std::abs(image.depth[x] - this->WindowDepth(x)) < 1e-6) << image.depth[x];
        EXPECT_EQ(image.setIds[x], Image::noGlyph);
      }
    }
  }

  // From below, and over the horizon, there is none.
  this->camera = this->LookFrom({ 0, -3, 0.1 }, { 5, 0, 0 });
  const Image image = this->Trace();
  EXPECT_EQ(std::count(image.color, image.color + image.width * image.height, 0u), image.width * image.height);
}

// Glyphs look the same with and without a ground below them, and their edges hide it.
TEST_F(ShadowTest, GroundChangesNoGlyph)
{
  this->Add(Shape::Sphere, { { 0, 0.5f, 0 } }, { glm::vec3(1.0f) }, White());
  this->lights = { Down(5.0f) };
  this->camera = this->LookFrom({ 0, 2, 3 }, { 0, 0.5, 0 }, 1.0);
  for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion, Shading::PathTracing })
  {
    this->settings.shading = shading;
    this->settings.samples = 4;
    this->settings.groundNormal = glm::vec3(0.0f);
    Image image = this->Trace();
    const std::vector<glm::vec4> without = this->tracer.Means();
    const std::vector<std::uint32_t> before(image.color, image.color + without.size());
    this->settings.groundNormal = { 0, 1, 0 };
    image = this->Trace();
    EXPECT_EQ(this->tracer.Means(), without);
    int caught = 0;
    for (std::size_t i = 0; i < without.size(); ++i)
    {
      // Over any background as much of the glyph's color shows, but for 8 bits.
      const glm::vec4 was = glm::unpackUnorm4x8(before[i]), is = glm::unpackUnorm4x8(image.color[i]);
      EXPECT_GE(is.a, was.a);
      EXPECT_LT(glm::distance(is.a * glm::vec3(is), was.a * glm::vec3(was)), 0.01f);
      caught += is.a > was.a;
    }
    EXPECT_GT(caught, 20);
  }
}

} // namespace
