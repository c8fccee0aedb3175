// What is refused, and what is named then.
#include "BoxMesh.h"
#include "TracerFixture.h"
#include "Vulkan/DeviceState.h"

#include <cmath>
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
  refused([&] { this->scene.SetColors(77, {}); });
  refused([&] { this->scene.SetMaterial(77, {}); });
  refused([&] { this->scene.SetVisible(77, false); });
  refused([&] { this->scene.InstancesOf(77); });
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
  EXPECT_THROW(this->scene.SetColors(0, std::vector<std::uint32_t>(7, 0u)), rtg::Error);
}

TEST_F(TracerTest, ArraysOfWrongLengthsAreNamed)
{
  const auto message = [this](const auto& change)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Superquadric;
    instances.centers = RandomPoints(4);
    change(instances);
    const auto id = this->scene.Add();
    const std::string refusal = rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); });
    if (!refusal.empty())
    {
      EXPECT_EQ(this->scene.InstancesOf(id).Count(), 0u);
    }
    return refusal;
  };
  const auto names = [&](const char* what, const auto& change)
  { EXPECT_NE(message(change).find(what), std::string::npos) << what << ": " << message(change); };
  names("5 sizes along three axes for 4 glyphs", [](auto& i) { i.sizes3.resize(5, glm::vec3(1.0f)); });
  names("3 sizes for 4 glyphs", [](auto& i) { i.sizes1.resize(3, 1.0f); });
  names("7 low parts of centers for 4 glyphs", [](auto& i) { i.centersLow.resize(7); });
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

/// What would be read past its end, or is no number, is refused.
TEST_F(TracerTest, GlyphsThatAreNoneAreNamed)
{
  const auto id = this->AddSpheres(RandomPoints(4), 0.5f);
  const auto message = [this, id](const auto& change)
  {
    rtg::GlyphInstances instances;
    instances.centers = RandomPoints(4);
    change(instances);
    return rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); });
  };
  const auto names = [&](const std::string& what, const auto& change)
  { EXPECT_NE(message(change).find(what), std::string::npos) << what << ": " << message(change); };
  using rtg::Shape;
  names("centers is (nan, 0, 0)", [](auto& i) { i.centers[2] = { NAN, 0.0f, 0.0f }; });
  names("low parts of centers is (0, inf, 0)", [](auto& i) { i.centersLow.resize(4), i.centersLow[3].y = INFINITY; });
  names("rotations is (0, 0, 0, nan)", [](auto& i) { i.rotations.resize(4, glm::vec4(0, 0, 0, NAN)); });
  names("sizes is -1", [](auto& i) { i.sizes1 = { 1.0f, 2.0f, -1.0f, 0.0f }; });
  names("sizes along three axes is (1, 0, 1)", [](auto& i) { i.sizes3.resize(4, { 1.0f, 0.0f, 1.0f }); });
  names("size of glyphs is inf", [](auto& i) { i.uniformSize = INFINITY; });
  names(
    "exponents of glyphs are (2, nan, 2)", [](auto& i) { i.shape = Shape::Superquadric, i.uniformExponents.y = NAN; });
  names("exponents is (2, 2, 0)",
    [](auto& i) {
      i.shape = Shape::Superquadric, i.exponents3.resize(4, { 2.0f, 2.0f, 0.0f });
    });
  names("sign of a polynomial", [](auto& i) { i.surfaceColors = rtg::GlyphInstances::SurfaceColors::Sign; });
  // A table's last two colors are not those of numbers.
  for (const std::size_t size : { 1, 2 })
  {
    rtg::GlyphColors colors;
    colors.ends.resize(4);
    colors.table.resize(size);
    EXPECT_THROW(this->scene.SetColors(id, colors), rtg::Error);
  }
  rtg::TriangleMesh mesh = BoxMesh();
  mesh.positions[3].z = NAN;
  names("positions of the mesh is", [&](auto& i) { i.shape = Shape::Mesh, i.mesh = Share(mesh); });
  names("swept ellipsoids lack", [](auto& i) { i.shape = Shape::SweptEllipsoid; });
  // These are glyphs: what mirrors, a piece of a line that ends in a point, and exponents of shapes that have none.
  EXPECT_EQ(message([](auto& i) { i.shape = Shape::Mesh, i.mesh = Share(BoxMesh()), i.uniformSize = -1.0f; }), "");
  EXPECT_EQ(message([](auto& i) { i.shape = Shape::RoundCone, i.sizes3.resize(4, { 1.0f, 1.0f, 0.0f }); }), "");
  EXPECT_EQ(message([](auto& i) { i.uniformExponents = glm::vec3(NAN); }), "");
}

/// What no device of the kind could hold is not the fault of other data.
TEST_F(TracerTest, WhatIsTooLargeForTheDeviceIsNamed)
{
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  this->scene.Commit();
  this->UseOwnTracer();
  auto& vulkan = this->device->GetState();
  const auto message = [this]
  {
    try
    {
      this->Trace();
    }
    catch (const rtg::OutOfMemory& error)
    {
      return std::string("out of memory: ") + error.what();
    }
    catch (const rtg::Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const vk::DeviceSize most = vulkan.mostOfBuffer;
  EXPECT_GE(most, std::size_t(1) << 30);
  if (this->device->IsCpu())
  {
    this->settings.width = this->settings.height = 32768;
    EXPECT_NE(message().find("16384 MiB are needed in one buffer"), std::string::npos) << message();
  }
  this->settings.width = this->settings.height = 1000;
  vulkan.mostOfBuffer = std::size_t(5) << 20;
  EXPECT_NE(message().find("15 MiB are needed in one buffer, of which '" + this->device->Name() + "' allows 5 MiB"),
    std::string::npos)
    << message();
  vulkan.mostOfBuffer = most;
  EXPECT_EQ(message(), "");
}

/// Indices are 32 bits wide, with a sign.
TEST_F(TracerTest, MoreThanIndicesCountIsNamed)
{
  const auto id = this->scene.Add();
  this->scene.GetState().mostElements = 30;
  const auto message = [this, id](const rtg::GlyphInstances& instances)
  { return rtg::testing::MessageOf([&] { this->scene.SetInstances(id, instances); }); };
  rtg::GlyphInstances instances;
  instances.centers = RandomPoints(30);
  EXPECT_EQ(message(instances), "");
  instances.centers = RandomPoints(31);
  EXPECT_NE(message(instances).find("31 glyphs; the most that one can hold is 30"), std::string::npos);
  // Their values are numbered, too.
  rtg::GlyphInstances values = instances;
  values.centers.resize(2);
  values.polynomials.values.assign(32, 0.0f);
  values.polynomials.width = 16;
  EXPECT_NE(message(values).find("2 glyphs of 16 values each have more values than a set can hold, which is 30"),
    std::string::npos);
  // Three corners a triangle.
  instances.centers.resize(1);
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = Share(BoxMesh());
  EXPECT_NE(message(instances).find("12 triangles; the most that one can have is 10"), std::string::npos);
  this->scene.GetState().mostElements = 36;
  EXPECT_EQ(message(instances), "");
  // The colors of a mesh's values lie behind these.
  rtg::TriangleMesh mesh = BoxMesh();
  mesh.positionValues.resize(8);
  mesh.valueColors.resize(29);
  instances.mesh = Share(mesh);
  EXPECT_NE(message(instances).find("8 positions; the most that one can have is 7"), std::string::npos);
}

/// A scene made where another was destroyed is not the one whose image was begun, though its address and the number of
/// its changes are the same.
TEST_F(TracerTest, AnotherScenesImageIsNotGoneOnWith)
{
  const auto makeScene = [this]
  {
    auto made = std::make_unique<rtg::Scene>(this->device);
    rtg::GlyphInstances spheres;
    spheres.centers = { glm::vec3(0.0f) };
    made->SetInstances(made->Add(), std::move(spheres));
    made->Commit();
    return made;
  };
  for (int attempt = 0; attempt < 10; ++attempt)
  {
    this->UseOwnTracer(); // which has not measured yet that one launch suffices
    auto first = makeScene();
    const Image image = this->tracer->Trace(
      *first, this->camera, this->lights, this->settings, rtg::Pass::Opaque, [](double) { return true; });
    ASSERT_FALSE(image.complete);
    first.reset();
    const auto second = makeScene();
    EXPECT_THROW(this->tracer->Resume(*second, 1), rtg::Error);
  }
}

/// An image without pixels is complete.
TEST_F(TracerTest, NothingIsGoneOnWithAfterAnImageWithoutPixels)
{
  this->UseOwnTracer();
  EXPECT_THROW(this->tracer->Resume(this->scene, 1), rtg::Error);
  this->AddSpheres({ { 0, 0, 0 } }, 1.0f);
  this->scene.Commit();
  const Image image = this->tracer->Trace(
    this->scene, this->camera, this->lights, this->settings, rtg::Pass::Opaque, [](double) { return true; });
  ASSERT_FALSE(image.complete);
  this->settings.width = 0;
  this->Trace();
  const Image none = this->tracer->Resume(this->scene, 1);
  EXPECT_TRUE(none.complete);
  EXPECT_EQ(none.color, nullptr);
}
