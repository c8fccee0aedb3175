// Previews: the coarse pictures that come before the first sample.
#include "ProgressiveImageFixture.h"

namespace rtg::testing
{

TEST_F(ProgressiveImageTest, APreviewIsCoarseLocalAndOnce)
{
  ImageEffort turning = Window(16);
  turning.preview = true;
  turning.pixelStep = 3;
  ASSERT_NE(this->Update(turning), nullptr);
  EXPECT_EQ(this->source.previewStep, 3.0);
  EXPECT_EQ(this->source.previewShading, rtg::Shading::Local);
  EXPECT_EQ(this->image.GetState(), State::Growing);
  const int previews = this->source.previews;
  this->Update(turning);
  EXPECT_EQ(this->source.previews, previews);
  EXPECT_EQ(this->source.traces, 0);
  // A finished image is as good as a preview.
  this->Finish(Window(16));
  const int traces = this->source.traces;
  this->Update(turning);
  EXPECT_EQ(this->source.traces, traces);
}

TEST_F(ProgressiveImageTest, APreviewOfCostlyGlyphsIsCoarser)
{
  this->source.secondsPerSample = 10.0;
  ImageEffort turning = Window(16);
  turning.preview = true;
  this->Update(turning);
  this->view.camera.eye.x += 1.0;
  const double before = this->source.now;
  this->Update(turning);
  EXPECT_LT(this->source.now - before, 0.2);
  EXPECT_GE(this->source.previewStep, 8.0);
}

TEST_F(ProgressiveImageTest, TheFirstPictureMayTakeLonger)
{
  this->source.secondsPerSample = 2.0;
  ImageEffort effort = Window(16);
  for (const double first : { 0.0, 0.8 })
  {
    ++this->view.sceneVersion;
    effort.firstSeconds = first;
    this->Update(effort);
    EXPECT_EQ(this->source.previewStep, first > 0.0 ? 2.0 : 6.0);
  }
}

// The first picture has half the resolution where that can be had in time, also when nothing is known of its cost; it
// stays until all pixels have a sample.
TEST_F(ProgressiveImageTest, APreviewStaysUntilThereIsASample)
{
  this->source.secondsPerSample = 0.3;
  for (std::uint64_t content : { 1u, 2u })
  {
    this->view.sceneVersion = content;
    const double before = this->source.now;
    ASSERT_NE(this->Update(Window(4)), nullptr);
    EXPECT_LT(this->source.now - before, 0.2);
    EXPECT_EQ(this->source.previewStep, 2.0);
    ASSERT_EQ(this->image.Samples(), 0u);
    const std::uint64_t version = this->image.Version();
    int updates = 0;
    for (; this->image.Samples() == 0; ++updates)
    {
      ASSERT_LT(updates, 10);
      EXPECT_EQ(this->image.GetImage().color[0], 5u);
      EXPECT_EQ(this->image.Version(), version);
      ASSERT_NE(this->Update(Window(4)), nullptr);
    }
    EXPECT_GT(updates, 1);
    EXPECT_EQ(this->image.GetImage().color[0], 7u);
  }
}

// What was seen before other light was chosen shows more than a preview.
TEST_F(ProgressiveImageTest, OtherLightHasNoPreview)
{
  this->source.secondsPerSample = 0.3;
  this->Finish(Window(2));
  const int previews = this->source.previews;
  this->view.settings.shading = rtg::Shading::PathTracing;
  int updates = 0;
  for (; this->image.Samples() == 0 || updates == 0; ++updates)
  {
    ASSERT_LT(updates, 10);
    ASSERT_NE(this->Update(Window(2)), nullptr);
    EXPECT_EQ(this->image.HasPicture(), this->image.Samples() > 0);
  }
  EXPECT_GT(updates, 1);
  EXPECT_EQ(this->source.previews, previews);
  this->view.camera.eye.x += 1.0;
  ASSERT_NE(this->Update(Window(2)), nullptr);
  EXPECT_TRUE(this->image.HasPicture());
  EXPECT_GT(this->source.previews, previews);
}

// The program of previews may be the one that lacks.
TEST_F(ProgressiveImageTest, PreviewsThatAreCompiledHoldNothingUp)
{
  this->source.previewCompilingSeconds = 1e9;
  const int updates = this->Finish(Window(8));
  EXPECT_LT(updates, 20);
  EXPECT_EQ(this->source.previews, 0);
}

// Where both programs are compiled the first picture is a preview, and no part of a sample.
TEST_F(ProgressiveImageTest, PreviewsComeFirstOnceTheyAreCompiled)
{
  this->source.previewCompilingSeconds = 0.3;
  this->source.compilingSeconds = 0.1;
  this->source.secondsPerSample = 4.0;
  for (int i = 0; i < 20 && !this->image.HasPicture(); ++i)
  {
    ASSERT_NE(this->Update(Window(8)), nullptr);
  }
  EXPECT_EQ(this->source.previews, 1);
  EXPECT_LT(this->image.GetImage().width, width);
}

} // namespace rtg::testing
