// What is refused, and what is named then.
#include "TracerFixture.h"

#include <string>

using rtg::Image;
using namespace rtg::testing;

TEST_F(TracerTest, SetsThatAreNotThereAreNamed)
{
  const auto refused = [](const auto& work)
  {
    try
    {
      work();
      ADD_FAILURE();
    }
    catch (const rtg::Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(" 77"), std::string::npos) << error.what();
    }
  };
  refused([&] { this->scene.SetInstances(77, {}); });
  refused([&] { this->scene.SetColours(77, {}); });
  refused([&] { this->scene.SetMaterial(77, {}); });
  refused([&] { this->scene.SetVisible(77, false); });
  refused([&] { this->scene.GlyphCount(77); });
  refused([&] { this->scene.OriginalGlyph(77, 0); });
  this->scene.Remove(77);
  const auto id = this->AddSpheres(RandomPoints(50), 0.1f);
  this->scene.GetState().structure = rtg::Structure::Tree;
  this->scene.Commit();
  refused([&] { this->scene.OriginalGlyph(id, 77); });
}

TEST_F(TracerTest, BadSettingsAreNamed)
{
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  this->settings.samples = 0;
  try
  {
    this->Trace();
    FAIL() << "no error";
  }
  catch (const rtg::Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("samples per pixel is 0"), std::string::npos) << error.what();
  }
  this->settings.samples = 1;
  this->settings.width = 100000;
  EXPECT_THROW(this->Trace(), rtg::Error);
  EXPECT_THROW(this->scene.SetColours(0, std::vector<std::uint32_t>(7, 0u)), rtg::Error);
}

TEST_F(TracerTest, ArraysOfWrongLengthsAreNamed)
{
  const auto message = [this](const auto& change)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Superquadric;
    instances.centres = RandomPoints(4);
    change(instances);
    const auto id = this->scene.Add();
    try
    {
      this->scene.SetInstances(id, instances);
    }
    catch (const rtg::Error& error)
    {
      EXPECT_EQ(this->scene.GlyphCount(id), 0u);
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names = [&](const char* what, const auto& change)
  { EXPECT_NE(message(change).find(what), std::string::npos) << what << ": " << message(change); };
  names("5 sizes along three axes for 4 glyphs", [](auto& i) { i.sizes3.resize(5, glm::vec3(1.0f)); });
  names("3 sizes for 4 glyphs", [](auto& i) { i.sizes1.resize(3, 1.0f); });
  names("7 low parts of centers for 4 glyphs", [](auto& i) { i.centresLow.resize(7); });
  names("1 rotations for 4 glyphs", [](auto& i) { i.rotations.resize(1); });
  names("8 exponents for 4 glyphs", [](auto& i) { i.exponents3.resize(8, glm::vec3(2.0f)); });
  names("2 quadratic forms for 4 glyphs", [](auto& i) { i.forms.resize(2); });
  names("3 ends before pieces of lines for 4 glyphs", [](auto& i) { i.before.resize(3); });
  names("5 velocities for 4 glyphs", [](auto& i) { i.motion.velocities.resize(5); });
  names("one kind", [](auto& i) { i.sizes1.resize(4, 1.0f), i.sizes3.resize(4, glm::vec3(1.0f)); });
  EXPECT_EQ(message([](auto&) {}), "");
  // The scene still shows what is right.
  EXPECT_GT(Coverage(this->Trace()), 0.0);
}

/// A scene made where another was destroyed is not the one whose image was begun, though its address and the number of
/// its changes are the same.
TEST_F(TracerTest, AnotherScenesImageIsNotGoneOnWith)
{
  const auto makeScene = [this]
  {
    auto made = std::make_unique<rtg::Scene>(this->device);
    rtg::GlyphInstances spheres;
    spheres.centres = { glm::vec3(0.0f) };
    made->SetInstances(made->Add(), std::move(spheres));
    made->Commit();
    return made;
  };
  for (int attempt = 0; attempt < 10; ++attempt)
  {
    this->UseOwnTracer(); // which does not know yet that one launch would do
    auto first = makeScene();
    const Image image = this->tracer->Trace(
      *first, this->camera, this->lights, this->settings, rtg::Pass::Opaque, [](double) { return true; });
    ASSERT_FALSE(image.complete);
    first.reset();
    const auto second = makeScene();
    EXPECT_THROW(this->tracer->Resume(*second), rtg::Error);
  }
}

/// An image without pixels is complete.
TEST_F(TracerTest, NothingIsGoneOnWithAfterAnImageWithoutPixels)
{
  this->UseOwnTracer();
  EXPECT_THROW(this->tracer->Resume(this->scene), rtg::Error);
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  this->scene.Commit();
  const Image image = this->tracer->Trace(
    this->scene, this->camera, this->lights, this->settings, rtg::Pass::Opaque, [](double) { return true; });
  ASSERT_FALSE(image.complete);
  this->settings.width = 0;
  this->Trace();
  EXPECT_THROW(this->tracer->Resume(this->scene), rtg::Error);
}
