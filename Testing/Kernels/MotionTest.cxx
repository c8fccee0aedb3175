// Glyphs that move while the shutter is open, against closed forms and against brute-force integration in double.
#include "GlyphBoxes.h"
#include "MovingGlyphs.h"
#include "Probes.h"

#include <cstring>

using namespace moving;

namespace
{

// A box that is higher than the picture and moves along x from -0.75 on, in one unit of time.
rtg::GlyphInstances MovingWall(float thickness, float way)
{
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Box;
  instances.centers = { glm::vec3(-0.75f, 0.0f, 0.0f) };
  instances.sizes3 = { glm::vec3(thickness, 4.0f, thickness) };
  instances.motion.velocities = { { way, 0.0f, 0.0f } };
  instances.motion.shutterOpen = 0.0f;
  instances.motion.shutterClose = 1.0f;
  return instances;
}

} // namespace

// Few programs a test: compiling one takes the device seconds.
TEST_P(MotionTest, SpheresCoverAsTheirPathsSay)
{
  // Straight: in closed form.
  constexpr double radius = 0.3, path = 1.0;
  rtg::GlyphInstances instances;
  instances.centers = { { 0.1f, -0.05f, 0.0f } };
  instances.uniformSize = 2.0 * radius;
  // Half the speed for twice the time.
  instances.motion.velocities = { { 0.5f * path, 0.0f, 0.7f } };
  instances.motion.accelerations = { glm::vec3(0.0f) };
  instances.motion.shutterOpen = -1.0f;
  instances.motion.shutterClose = 1.0f;
  const auto id = this->Add(instances);
  this->settings.samples = 64;
  this->ExpectCoverage(
    [&](glm::dvec2 p)
    {
      const double x = p.x - double(0.1f), y = p.y - double(-0.05f);
      const double half = std::sqrt(std::max(radius * radius - y * y, 0.0));
      // Displacements between -path / 2 and path / 2 that bring the chord over x.
      return std::max(std::min(x + half, path / 2) - std::max(x - half, -path / 2), 0.0) / path;
    });

  // Along a parabola that turns back: by brute force.
  instances.centers = { glm::vec3(0.0f) };
  instances.uniformSize = 0.5f;
  instances.motion.velocities = { { 0.9f, 0.3f, 0.0f } };
  instances.motion.accelerations = { { -2.5f, 2.0f, 0.0f } };
  instances.motion.shutterOpen = 0.0f;
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  constexpr int times = 1000;
  std::vector<glm::dvec2> centers;
  for (int i = 0; i < times; ++i)
  {
    centers.emplace_back(GlyphAt(instances, 0, (i + 0.5) / times).center);
  }
  this->ExpectCoverage(
    [&](glm::dvec2 p)
    {
      const auto hits = std::count_if(centers.begin(), centers.end(),
        [&](const glm::dvec2& center) { return glm::dot(p - center, p - center) < 0.0625; });
      return double(hits) / times;
    });
}

TEST_P(MotionTest, NoVelocityIsTheImageAtRest)
{
  MovingGlyphs make(9);
  rtg::GlyphInstances instances;
  for (int i = 0; i < 200; ++i)
  {
    instances.centers.push_back(make.Vector(0.9f));
  }
  instances.uniformSize = 0.2f;
  const auto id = this->Add(instances);
  this->settings.samples = 4;
  const std::vector<glm::vec4> atRest = this->Means();
  instances.motion.velocities.assign(200, glm::vec3(0.0f));
  instances.motion.accelerations.assign(200, glm::vec3(0.0f));
  this->scene.SetInstances(id, instances);
  this->scene.Commit();
  const std::vector<glm::vec4> moving = this->Means();
  // The samples are the same, but are added in another order.
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    ASSERT_LT(glm::length(moving[i] - atRest[i]), 1e-6f) << "pixel " << i;
  }
}

class MotionOfShapes : public MotionTest
{
protected:
  // Glyphs turn along parabolas.
  void ExpectRaysMeetWhatIsThere(rtg::Shape shape)
  {
    MovingGlyphs make(4);
    rtg::GlyphInstances instances = make.Make(shape, 40, true, true);
    instances.motion.shutterOpen = -0.7f;
    instances.motion.shutterClose = 0.4f;
    this->Add(instances);
    EXPECT_TRUE(this->HasSlices());
    this->ExpectRaysMeet(shape, instances, [&](std::size_t i, double time) { return GlyphAt(instances, i, time); });
  }

  // A single glyph that turns along a parabola.
  void ExpectItCoversAsBruteForce(rtg::Shape shape, const glm::vec3& size)
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.centers = { { -0.1f, 0.05f, 0.0f } };
    instances.sizes3 = { size };
    instances.rotations = { glm::normalize(glm::vec4(0.1f, 0.2f, 0.3f, 0.9f)) };
    // The parabola bends by many pixels, and there are samples enough, that a factor of 0.4 for 0.5 is seen: what
    // wrong fractions add to chi-squared grows with the number of samples.
    instances.motion.velocities = { { 0.5f, -0.4f, 0.0f } };
    instances.motion.accelerations = { { 1.0f, 5.0f, 0.5f } };
    instances.motion.angularVelocities = { { 0.3f, 0.5f, 2.5f } };
    this->Add(instances);
    this->settings.width = this->settings.height = 30;
    this->settings.samples = 64;
    this->ExpectCoverage(BruteForce(instances, 150));
  }
};

TEST_P(MotionOfShapes, RaysMeetSpheres)
{
  this->ExpectRaysMeetWhatIsThere(rtg::Shape::Sphere);
}

TEST_P(MotionOfShapes, RaysMeetBoxes)
{
  this->ExpectRaysMeetWhatIsThere(rtg::Shape::Box);
}

TEST_P(MotionOfShapes, RaysMeetCones)
{
  this->ExpectRaysMeetWhatIsThere(rtg::Shape::Cone);
}

TEST_P(MotionOfShapes, RaysMeetArrows)
{
  this->ExpectRaysMeetWhatIsThere(rtg::Shape::Arrow);
}

TEST_P(MotionOfShapes, BoxCoversAsBruteForce)
{
  this->ExpectItCoversAsBruteForce(rtg::Shape::Box, { 0.7f, 0.4f, 0.2f });
}

TEST_P(MotionOfShapes, ArrowCoversAsBruteForce)
{
  this->ExpectItCoversAsBruteForce(rtg::Shape::Arrow, glm::vec3(0.9f));
}

// Nothing but a sphere, which hides nothing from itself: to rays of other times it would, as it is then elsewhere.
class OneTimeAPath : public MotionTest
{
protected:
  void Add(const rtg::Material& material)
  {
    rtg::GlyphInstances instances;
    instances.centers = { glm::vec3(0.0f) };
    instances.uniformSize = 0.6f;
    instances.motion.velocities = { { 0.8f, 0.3f, -0.5f } };
    const auto id = this->MotionTest::Add(instances);
    this->scene.SetMaterial(id, material);
    this->scene.Commit();
    this->settings.samples = 16;
  }
};

TEST_P(OneTimeAPath, NothingHidesTheSphereFromTheSky)
{
  // It is white, so that every sample that hits is as bright as the sky or, if occluded, darker.
  this->Add(rtg::Material());
  this->settings.shading = rtg::Shading::AmbientOcclusion;
  int covered = 0;
  for (const glm::vec4& mean : this->Means())
  {
    EXPECT_EQ(mean.r, mean.a);
    covered += mean.a > 0.0f;
  }
  EXPECT_GT(covered, 300);
}

TEST_P(OneTimeAPath, LightGoesStraightFromTheSphereToTheSky)
{
  // So that further bounces change nothing.
  this->Add(rtg::Material());
  this->settings.shading = rtg::Shading::PathTracing;
  this->settings.maximumBounces = 1;
  const std::vector<glm::vec4> once = this->Means();
  this->settings.maximumBounces = 8;
  const std::vector<glm::vec4> often = this->Means();
  EXPECT_EQ(0, std::memcmp(once.data(), often.data(), once.size() * sizeof(glm::vec4)));
}

// An edge that moves: its error is much less than the variance of independent times.
TEST_P(MotionTest, TimesAreStratified)
{
  this->Add(MovingWall(0.5f, 1.0f));
  this->settings.samples = 16;
  const std::vector<glm::vec4> means = this->Means();
  double squares = 0.0, variances = 0.0;
  for (std::uint32_t pixel = 0; pixel < means.size(); ++pixel)
  {
    double expected = 0.0;
    for (std::uint32_t s = 0; s < 16; ++s)
    {
      const double x = this->Position(pixel, s).x;
      const double share = std::max(std::min(x + 1.0, 1.0) - std::max(x + 0.5, 0.0), 0.0);
      expected += share / 16.0;
      variances += share * (1.0 - share) / 256.0;
    }
    squares += (means[pixel].a - expected) * (means[pixel].a - expected);
  }
  // Of 16 samples, each of the two times at which an edge passes misplaces one or, where times wrap around, two: in
  // the mean much less than the fraction of independent samples that chance misplaces.
  EXPECT_LT(squares, 0.25 * variances);
}

// A streak is even, whatever the number of samples: its middle is that of the way.
TEST_P(MotionTest, StreaksAreEvenForAnyNumberOfSamples)
{
  this->Add(MovingWall(0.1f, 1.5f));
  for (const rtg::Shading shading : { rtg::Shading::Local, rtg::Shading::AmbientOcclusion })
  {
    this->settings.shading = shading;
    for (const std::uint32_t samples : { 3u, 4u, 5u, 7u, 9u, 16u, 20u, 100u })
    {
      this->settings.samples = samples;
      double sum = 0.0, weights = 0.0;
      const std::vector<glm::vec4> means = this->Means();
      for (std::uint32_t pixel = 0; pixel < means.size(); ++pixel)
      {
        const std::uint32_t width = this->settings.width;
        sum += means[pixel].a * ((pixel % width + 0.5) / width * 2.0 - 1.0);
        weights += means[pixel].a;
      }
      // Each row's pixels have times of their own: the mean of `samples` of them in a part each, or of independent
      // ones.
      const double deviation = 1.5 / std::sqrt(12.0 * samples * this->settings.height);
      EXPECT_NEAR(sum / weights, 0.0, 5.0 * deviation) << samples << " samples, shading " << static_cast<int>(shading);
    }
  }
}

TEST_P(MotionTest, StreaksKeepTheColorsOfTheirGlyphs)
{
  // Whatever else colors mean: thin parts of a streak are more transparent, not darker nor mixed with anything.
  rtg::GlyphInstances instances;
  instances.centers = { { 0.0f, 0.5f, 0.0f }, { 0.0f, -0.5f, 0.0f } };
  instances.uniformSize = 0.4f;
  instances.motion.velocities = { { 1.2f, 0.0f, 0.0f }, { 0.8f, 0.1f, 0.0f } };
  instances.motion.accelerations = { { 3.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
  const auto id = this->Add(instances);
  const std::vector<std::uint32_t> colors = { 0xff2040c0u, 0xffa08010u };
  this->scene.SetColors(id, colors);
  rtg::Material material;
  material.lighting = false;
  this->scene.SetMaterial(id, material);
  this->scene.Commit();
  this->settings.samples = 32;
  const Image image = this->tracer.Trace(this->scene, this->camera, { rtg::Light() }, this->settings);
  int thin = 0;
  for (std::uint32_t i = 0; i < image.width * image.height; ++i)
  {
    const std::uint32_t alpha = image.color[i] >> 24;
    const std::uint32_t wanted = colors[i / image.width >= image.height / 2 ? 0 : 1];
    for (int shift = 0; shift < 24 && alpha > 0; shift += 8)
    {
      ASSERT_NEAR(image.color[i] >> shift & 255, wanted >> shift & 255, 1) << i;
    }
    thin += alpha > 0 && alpha < 128;
  }
  EXPECT_GT(thin, 100);
}

TEST_P(MotionTest, FastSpheresAreSeenForTheirShareOfTheTime)
{
  // A thousand times the view while the shutter is open, there and back.
  constexpr double radius = 0.3, half = 1000.0;
  rtg::GlyphInstances instances;
  instances.centers = { { 0.0f, 0.1f, 0.0f } };
  instances.uniformSize = 2.0 * radius;
  // x(t) = half (2 t - 2 t^2) for t in 0 .. 1 is 0 at both ends, where the speed is 2 half.
  instances.motion.velocities = { { 2.0 * half, 0.0f, 0.0f } };
  instances.motion.accelerations = { { -4.0 * half, 0.0f, 0.0f } };
  instances.motion.shutterOpen = 0.0f;
  instances.motion.shutterClose = 1.0f;
  this->Add(instances);
  this->settings.samples = 1024;
  this->settings.independentSamples = true;
  double found = 0.0, expected = 0.0;
  const std::vector<glm::vec4> means = this->Means();
  for (std::uint32_t pixel = 0; pixel < means.size(); ++pixel)
  {
    found += double(means[pixel].a) * this->settings.samples;
    for (std::uint32_t s = 0; s < this->settings.samples; ++s)
    {
      const glm::dvec2 p = this->Position(pixel, s);
      const double y = p.y - double(0.1f);
      const double chord = std::sqrt(std::max(radius * radius - y * y, 0.0));
      // Times at which it is over p, near either end; the parabola is straight there to a thousandth.
      expected += 2.0 * std::max(p.x + chord - std::max(p.x - chord, 0.0), 0.0) / (2.0 * half);
    }
  }
  EXPECT_GT(expected, 50.0);
  EXPECT_NEAR(found, expected, 3.9 * std::sqrt(expected));
}

TEST_P(MotionTest, SamplesMayBeSharedOutAmongCalls)
{
  MovingGlyphs make(2);
  this->Add(make.Make(rtg::Shape::Box, 50, true, true));
  this->settings.samples = this->settings.plannedSamples = 8;
  const std::vector<glm::vec4> once = this->Means();
  this->settings.samples = 3;
  this->Means();
  this->tracer.Resume(this->scene, 8);
  const std::vector<glm::vec4> twice = this->tracer.Means();
  EXPECT_EQ(0, std::memcmp(once.data(), twice.data(), once.size() * sizeof(glm::vec4)));
}

TEST_P(MotionTest, MovingAndRestingSetsShareAScene)
{
  // A large sphere at rest behind a small one that moves: all pixels are covered, and many mixed.
  rtg::GlyphInstances wall;
  wall.centers = { { 0.0f, 0.0f, -2.0f } };
  wall.uniformSize = 3.5f;
  rtg::Material dark;
  dark.color = glm::vec3(0.0f);
  const auto wallSet = this->Add(wall);
  this->scene.SetMaterial(wallSet, dark);
  rtg::GlyphInstances sphere;
  sphere.centers = { glm::vec3(0.0f) };
  sphere.uniformSize = 0.6f;
  sphere.motion.velocities = { { 1.0f, 0.0f, 0.0f } };
  this->Add(sphere);
  this->settings.samples = 16;
  const std::vector<glm::vec4> means = this->Means();
  int mixed = 0;
  for (const glm::vec4& mean : means)
  {
    EXPECT_EQ(mean.a, 1.0f);
    mixed += mean.r > 0.05f && mean.r < 0.9f;
  }
  EXPECT_GT(mixed, 200);
}

TEST_P(MotionTest, RefusesWhatMakesNoSense)
{
  const auto id = this->scene.Add();
  rtg::GlyphInstances good;
  good.centers = { glm::vec3(0.0f), glm::vec3(1.0f) };
  good.motion.velocities = { glm::vec3(0.0f), glm::vec3(1.0f) };
  const auto message = [&](const std::function<void(rtg::GlyphInstances&)>& change)
  {
    rtg::GlyphInstances instances = good;
    change(instances);
    return rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); });
  };
  EXPECT_EQ(message([](auto&) {}), "");
  EXPECT_NE(
    message([](auto& i) { i.motion.velocities.pop_back(); }).find("1 velocities for 2 glyphs"), std::string::npos);
  EXPECT_NE(message([](auto& i) { i.motion.accelerations.resize(3); }).find("3 accelerations"), std::string::npos);
  EXPECT_NE(message([](auto& i) { i.motion.velocities[1].y = NAN; }).find("(1, nan, 1)"), std::string::npos);
  EXPECT_NE(message([](auto& i) { i.motion.shutterClose = -0.5f; }).find("must close later"), std::string::npos);
  EXPECT_NE(message([](auto& i) { i.motion.shutterOpen = NAN; }).find("must close later"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
  Structures, MotionTest, ::testing::Values(rtg::Structure::Boxes, rtg::Structure::Tree), StructureName);
INSTANTIATE_TEST_SUITE_P(Structures, MotionOfShapes, ::testing::Values(rtg::Structure::Tree), StructureName);
INSTANTIATE_TEST_SUITE_P(Structures, OneTimeAPath, ::testing::Values(rtg::Structure::Tree), StructureName);

TEST(GlyphBoxesOfPaths, HoldEveryTimeAndAreTight)
{
  MovingGlyphs make(6);
  for (const rtg::Shape shape : { rtg::Shape::Sphere, rtg::Shape::Box, rtg::Shape::Arrow })
  {
    for (const int kind : { 1, 2, 3 })
    {
      rtg::GlyphInstances instances = make.Make(shape, 200, kind & 1, kind & 2);
      instances.motion.shutterOpen = -0.3f;
      instances.motion.shutterClose = 1.0f;
      for (const auto& [first, last] : { std::pair(0.0, 1.0), std::pair(0.25, 0.5) })
      {
        const std::vector<rtg::Box> boxes = rtg::GlyphBoxes(instances, first, last);
        double growth = 0.0;
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
          glm::dvec3 lower(INFINITY), upper(-INFINITY);
          for (int step = 0; step <= 200; ++step)
          {
            const double time = instances.motion.Time(first + (last - first) * step / 200);
            glm::dvec3 a(0.0), b(0.0);
            Double::GlyphBounds(shape, GlyphAt(instances, i, time), a, b);
            lower = glm::min(lower, a);
            upper = glm::max(upper, b);
          }
          for (int axis = 0; axis < 3; ++axis)
          {
            ASSERT_LE(boxes[i].lower[axis], lower[axis]);
            ASSERT_GE(boxes[i].upper[axis], upper[axis]);
          }
          const glm::dvec3 extent = upper - lower;
          const glm::dvec3 own = glm::dvec3(boxes[i].upper) - glm::dvec3(boxes[i].lower);
          growth += (own.x + own.y + own.z) / (extent.x + extent.y + extent.z) / 200.0;
        }
        // A path without turning is as tight as can be; turns are bounded by pieces.
        EXPECT_LT(growth, kind == 1 ? 1.0001 : 1.15) << int(shape) << ' ' << kind;
      }
    }
  }
}

TEST(GlyphBoxesOfPaths, LongerPathsHaveMoreSlices)
{
  MovingGlyphs make(8);
  rtg::GlyphInstances instances;
  instances.uniformSize = 0.02f;
  for (int i = 0; i < 1000; ++i)
  {
    instances.centers.push_back(make.Vector(1.0f));
  }
  std::uint32_t before = 0;
  for (const float path : { 0.0f, 0.005f, 0.05f, 0.5f, 5.0f })
  {
    instances.motion.velocities.clear();
    for (int i = 0; i < 1000; ++i)
    {
      instances.motion.velocities.push_back(path * glm::normalize(make.Vector(1.0f)));
    }
    const std::uint32_t bits = rtg::TimeSliceBits(instances, 1000);
    EXPECT_GE(bits, before);
    EXPECT_EQ(bits == 0, path < 0.01f);
    before = bits;
  }
  EXPECT_EQ(before, rtg::maxTimeSliceBits);
  EXPECT_LE(rtg::TimeSliceBits(instances, std::size_t(1) << 28), 1u);
}
