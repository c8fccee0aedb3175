// Periodic images of a set beside the same glyphs copied.
#include "LightFixture.h"
#include "SceneState.h"

namespace
{

using light::Image;
using light::Shading;
using light::Shape;
using light::White;

constexpr std::size_t glyphs = 40;

class PeriodicTest : public rtg::testing::WithStructure<light::LightTest>
{
protected:
  void SetUp() override
  {
    this->WithStructure::SetUp();
    this->settings.samples = 16;
    this->settings.width = this->settings.height = 64;
    // A box that leans in all directions
    this->images.edges = { glm::dvec3(1.7, 0.1, 0.0), glm::dvec3(0.3, 1.6, 0.0), glm::dvec3(-0.2, 0.2, 1.8) };
  }

  static rtg::GlyphInstances Instances(Shape shape, bool moves)
  {
    rtg::GlyphInstances instances;
    instances.shape = shape;
    instances.centers = light::Clutter(7, glyphs);
    for (const glm::vec3& center : instances.centers)
    {
      instances.sizes3.push_back(glm::vec3(0.35f, 0.25f, 0.3f) + 0.1f * center);
      instances.rotations.push_back(glm::normalize(glm::vec4(center, 0.7f)));
      if (moves)
      {
        instances.motion.velocities.emplace_back(0.5f * center.y, 0.4f, center.x);
      }
    }
    instances.motion.shutterClose = moves ? 1.0f : 0.0f;
    return instances;
  }

  rtg::Scene::SetId AddInstances(rtg::GlyphInstances instances)
  {
    const auto id = this->scene.Add();
    this->scene.SetInstances(id, std::move(instances));
    this->scene.SetMaterial(id, White());
    return id;
  }

  // Those that are neighbors, in two sets: what is shown, and what only shades it. The original comes first.
  void AddCopies(const rtg::GlyphInstances& original)
  {
    rtg::GlyphInstances shown = original, lit = original;
    lit.centers.clear();
    lit.sizes3.clear();
    lit.rotations.clear();
    lit.motion.velocities.clear();
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        for (int k = -1; k <= 1; ++k)
        {
          const glm::ivec3 place(i, j, k);
          if (place == glm::ivec3(0))
          {
            continue;
          }
          rtg::GlyphInstances& into = glm::all(glm::lessThanEqual(glm::abs(place), this->images.shown)) ? shown : lit;
          const glm::vec3 offset(
            double(i) * this->images.edges[0] + double(j) * this->images.edges[1] + double(k) * this->images.edges[2]);
          for (std::size_t g = 0; g < glyphs; ++g)
          {
            into.centers.push_back(original.centers[g] + offset);
            into.sizes3.push_back(original.sizes3[g]);
            into.rotations.push_back(original.rotations[g]);
            if (!original.motion.velocities.empty())
            {
              into.motion.velocities.push_back(original.motion.velocities[g]);
            }
          }
        }
      }
    }
    this->AddInstances(std::move(shown));
    if (!lit.centers.empty())
    {
      this->scene.SetCameraVisible(this->AddInstances(std::move(lit)), false);
    }
  }

  void Clear()
  {
    for (rtg::Scene::SetId id = 0; id < 100; ++id)
    {
      this->scene.Remove(id);
    }
  }

  rtg::PeriodicImages images;
};

// Light and picture are those of copies, and each image has the ids of the original.
TEST_P(PeriodicTest, LooksLikeCopies)
{
  this->camera = this->LookFrom({ 1.0, 2.0, 5.0 }, { 0, 0, 0 }, 1.6);
  for (const Shape shape : { Shape::Sphere, Shape::Superquadric })
  {
    for (const bool moves : { false, true })
    {
      const rtg::GlyphInstances original = Instances(shape, moves);
      for (const glm::ivec3& shown : { glm::ivec3(0), glm::ivec3(1, 0, 1) })
      {
        this->images.shown = shown;
        this->images.lit = glm::ivec3(1);
        for (const Shading shading : { Shading::Local, Shading::AmbientOcclusion })
        {
          this->settings.shading = shading;
          this->settings.samples = shading == Shading::Local ? 1 : 16;
          this->lights = { rtg::Light() };
          this->Clear();
          this->AddCopies(original);
          const Image image = this->Trace();
          const std::vector<glm::vec4> copied = this->tracer.Means();
          std::vector<std::uint32_t> ids;
          for (std::size_t i = 0; i < copied.size(); ++i)
          {
            const bool hit = image.glyphIds[i] != Image::noGlyph;
            ids.push_back(hit ? this->scene.OriginalGlyph(image.setIds[i], image.glyphIds[i]) % glyphs : 999u);
          }
          this->Clear();
          const auto id = this->AddInstances(original);
          this->scene.SetImages(id, this->images);
          const Image repeated = this->Trace();
          const std::vector<glm::vec4> means = this->tracer.Means();
          double difference = 0.0;
          std::size_t covered = 0, otherIds = 0;
          for (std::size_t i = 0; i < means.size(); ++i)
          {
            difference += glm::length(means[i] - copied[i]) / static_cast<double>(means.size());
            covered += means[i].a > 0.0f;
            const bool hit = repeated.glyphIds[i] != Image::noGlyph;
            otherIds += (hit ? this->scene.OriginalGlyph(repeated.setIds[i], repeated.glyphIds[i]) : 999u) != ids[i];
          }
          EXPECT_LT(difference, 0.5 / 255.0) << int(shape) << moves << shown.x << int(shading);
          EXPECT_LE(otherIds, 4u) << int(shape) << moves << shown.x << int(shading);
          EXPECT_GT(covered, 500u);
        }
      }
    }
  }
}

// Light comes through the boundary though no image is seen; images take no memory to speak of.
TEST_P(PeriodicTest, ShadesAcrossTheBoundary)
{
  this->settings.shading = Shading::AmbientOcclusion;
  const auto id = this->AddInstances(Instances(Shape::Sphere, false));
  const auto mean = [this]
  {
    this->Trace();
    double sum = 0.0, count = 0.0;
    for (const glm::vec4& pixel : this->tracer.Means())
    {
      sum += pixel.r;
      count += pixel.a;
    }
    return glm::dvec2(sum / count, count);
  };
  const glm::dvec2 alone = mean();
  const auto bytes = this->scene.GetStatistics().deviceBytes;
  this->images.lit = glm::ivec3(1);
  this->scene.SetImages(id, this->images);
  const glm::dvec2 among = mean();
  EXPECT_EQ(among.y, alone.y); // what is seen
  EXPECT_LT(among.x, 0.8 * alone.x);
  EXPECT_LT(this->scene.GetStatistics().deviceBytes, bytes + 27 * 2048);
  this->scene.SetImages(id, {});
  EXPECT_EQ(mean(), alone);
}

TEST_P(PeriodicTest, RefusesWhatMakesNoSense)
{
  const auto id = this->AddInstances(Instances(Shape::Sphere, false));
  this->images.shown = glm::ivec3(2, 0, 0);
  this->images.lit = glm::ivec3(1);
  EXPECT_THROW(this->scene.SetImages(id, this->images), rtg::Error);
  this->images.lit = glm::ivec3(20);
  EXPECT_THROW(this->scene.SetImages(id, this->images), rtg::Error);
  this->images.lit = glm::ivec3(5); // one more than the most that a display shows
  this->scene.SetImages(id, this->images);
  this->images.lit = glm::ivec3(2, 0, 0);
  this->images.edges[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(this->scene.SetImages(id, this->images), rtg::Error);
}

INSTANTIATE_TEST_SUITE_P(Structures, PeriodicTest, ::testing::Values(rtg::Structure::Tree, rtg::Structure::Boxes),
  [](const auto& info) { return info.param == rtg::Structure::Tree ? "Tree" : "Boxes"; });

} // namespace
