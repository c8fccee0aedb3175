// Every way from one state of an image to another; previews, failures and denoising have files of their own.
#include "ProgressiveImageFixture.h"

namespace rtg::testing
{

TEST_F(ProgressiveImageTest, BeginsEmpty)
{
  EXPECT_EQ(this->image.GetState(), State::Empty);
  EXPECT_EQ(this->image.Progress(), 0.0);
}

TEST_F(ProgressiveImageTest, AScriptGetsAllAtOnceAndNothingTwice)
{
  ASSERT_NE(this->Update(Script(16)), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->image.Samples(), 16u);
  EXPECT_FALSE(this->source.last.keepSums);
  const std::uint64_t version = this->image.Version();
  this->Update(Script(16));
  EXPECT_EQ(this->source.traces, 1);
  EXPECT_EQ(this->image.Version(), version);
}

TEST_F(ProgressiveImageTest, AScriptGetsExactlyWhatItAsksFor)
{
  this->Update(Script(16));
  this->Update(Script(4));
  EXPECT_EQ(this->image.Samples(), 4u);
  EXPECT_EQ(this->source.last.plannedSamples, 4u);
  EXPECT_EQ(this->source.rays, 20.0);
  // Also where a window planned as many, and has had more since.
  this->view.sceneVersion = 1;
  this->Finish(Window(4));
  this->Finish(Window(8));
  this->Update(Script(4));
  EXPECT_EQ(this->image.Samples(), 4u);
}

TEST_F(ProgressiveImageTest, AScriptGrowsInSteps)
{
  ImageEffort effort = Script(5);
  effort.samplesAtOnce = 2;
  for (std::uint32_t samples : { 2u, 4u, 5u })
  {
    this->Update(effort);
    EXPECT_EQ(this->image.Samples(), samples);
  }
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->source.rays, 5.0);
}

TEST_F(ProgressiveImageTest, AWindowGrowsWithinItsTime)
{
  double longest = 0.0;
  for (int updates = 0; this->image.GetState() != State::Finished; ++updates)
  {
    ASSERT_LT(updates, 20);
    const double before = this->source.now;
    ASSERT_NE(this->Update(Window(64)), nullptr);
    longest = std::max(longest, this->source.now - before);
  }
  // A launch here is a quarter of what the time allows.
  EXPECT_LT(longest, 0.15);
  EXPECT_EQ(this->image.Samples(), 64u);
  EXPECT_EQ(this->image.Progress(), 1.0);
}

TEST_F(ProgressiveImageTest, ASampleThatTakesLongIsInterruptedAndGoneOnWith)
{
  this->source.secondsPerSample = 20.0;
  const double before = this->source.now;
  ASSERT_NE(this->Update(Window(2)), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Growing);
  EXPECT_EQ(this->image.Samples(), 0u);
  EXPECT_LT(this->image.Progress(), 0.5);
  // The stand-in's launches are a quarter of a sample long.
  EXPECT_LT(this->source.now - before, 5.5);
  const int updates = this->Finish(Window(2));
  EXPECT_EQ(updates, 8); // the first one has time for a preview only
  EXPECT_EQ(this->source.resumes, 6);
  EXPECT_EQ(this->source.rays, 2.0);
}

TEST_F(ProgressiveImageTest, MoreSamplesAreAddedToAFinishedImage)
{
  this->Finish(Window(32));
  const double rays = this->source.rays;
  this->Update(Window(64));
  EXPECT_EQ(this->image.GetState(), State::Growing);
  EXPECT_GT(this->image.Samples(), 32u);
  this->Finish(Window(64));
  EXPECT_EQ(this->source.rays - rays, 32.0);
}

TEST_F(ProgressiveImageTest, FewerSamplesFinishAnImageThatHasThem)
{
  while (this->image.Samples() < 34 || !this->image.GetImage().complete)
  {
    this->Update(Window(64));
  }
  const double rays = this->source.rays;
  this->Update(Window(30));
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->source.rays, rays);
}

TEST_F(ProgressiveImageTest, ACaptureGoesOnWithTheWindowsImageAndTheWindowWithTheCapture)
{
  for (rtg::Shading shading : { rtg::Shading::Local, rtg::Shading::AmbientOcclusion, rtg::Shading::PathTracing })
  {
    this->view = View(shading);
    this->Update(Window(64));
    ASSERT_EQ(this->image.GetState(), State::Growing);
    const double rays = this->source.rays;
    const std::uint32_t had = this->image.Samples();
    ImageEffort capture = Script(64);
    capture.denoising = Denoising::WhileGrowing;
    ASSERT_NE(this->Update(capture), nullptr) << this->image.GetFailure().message;
    EXPECT_EQ(this->image.GetState(), State::Finished);
    EXPECT_EQ(this->source.rays - rays, 64.0 - had);
    EXPECT_EQ(this->image.GetImage().color[0], 7u) << "a finished image is denoised";
    this->Update(Window(64));
    EXPECT_EQ(this->image.GetState(), State::Finished);
    EXPECT_EQ(this->source.rays - rays, 64.0 - had);
  }
}

TEST_F(ProgressiveImageTest, AnotherViewBeginsAnew)
{
  this->Finish(Window(8));
  const auto changed = [this](const char* what)
  {
    const double rays = this->source.rays;
    this->Finish(Window(8));
    EXPECT_GE(this->source.rays - rays, 8.0) << what;
  };
  this->view.camera.eye.x += 1.0;
  changed("camera");
  this->view.lights.emplace_back();
  changed("lights");
  this->view.sceneVersion = 1;
  changed("content");
  this->view.settings.shading = rtg::Shading::Local;
  changed("shading");
  this->view.settings.width = 2 * width;
  changed("size");
  this->view.pass = rtg::Pass::Translucent;
  changed("pass");
}

// What rounding alone moves is no other view; the least that can be seen is.
TEST_F(ProgressiveImageTest, RoundingOfTheCameraBeginsNothingAgain)
{
  this->view.lights.resize(1);
  this->view.lights[0].position = glm::dvec3(3.0, 4.0, 5.0);
  const ImageView kept = this->view;
  this->view.camera.eye.z = std::nextafter(kept.camera.eye.z, 2.0);
  this->view.camera.farDepth = std::nextafter(kept.camera.farDepth, 0.0);
  this->view.camera.right.x = std::nextafter(kept.camera.right.x, 2.0);
  this->view.lights[0].position.y = std::nextafter(4.0, 5.0);
  this->view.lights[0].direction.x = 1e-8f;
  this->view.settings.skySlope.x = std::nextafter(kept.settings.skySlope.x, 1.0f);
  EXPECT_FALSE(this->view == kept);
  EXPECT_TRUE(rtg::Settled(this->view, kept) == kept);
  for (double glm::dvec3::*x : { &glm::dvec3::x, &glm::dvec3::y })
  {
    this->view = kept;
    this->view.camera.eye.*x += 1e-9;
    EXPECT_FALSE(rtg::Settled(this->view, kept) == kept);
  }
  this->view = kept;
  this->view.lights[0].direction.x = 1e-3f;
  EXPECT_FALSE(rtg::Settled(this->view, kept) == kept);
}

TEST_F(ProgressiveImageTest, SomebodyStopsATraceAndItGoesOn)
{
  this->source.secondsPerSample = 20.0;
  bool stop = true;
  double told = 0.0;
  const rtg::Interrupt interrupt = [&](double progress)
  {
    told = progress;
    return stop;
  };
  ASSERT_NE(this->image.Update(this->source, this->view, Script(1), interrupt), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Growing);
  EXPECT_NEAR(this->image.Progress(), 0.25, 1e-6);
  EXPECT_NEAR(told, 0.25, 1e-6);
  stop = false;
  this->image.Update(this->source, this->view, Script(1), interrupt);
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->source.rays, 1.0);
}

// A capture keeps no sums: what it has begun is no beginning of an image of more samples.
TEST_F(ProgressiveImageTest, AStoppedCaptureIsNotGoneOnWithForMoreSamples)
{
  this->source.secondsPerSample = 20.0;
  ImageEffort capture = Script(4);
  capture.exact = true;
  ASSERT_NE(this->image.Update(this->source, this->view, capture, [](double) { return true; }), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Growing);
  ImageEffort more = Script(8);
  more.exact = false;
  ASSERT_NE(this->Update(more), nullptr) << this->image.GetFailure().message;
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->image.GetImage().samples, 8u);
}

// Once there is something to see of a window's image, it may be wanted in any light; scripts know what they want.
TEST_F(ProgressiveImageTest, OtherLightIsExpected)
{
  this->Update(Script(4));
  EXPECT_TRUE(this->source.expected.empty());
  this->view.sceneVersion = 1;
  this->source.compilingSeconds = 1.0;
  this->Update(Window(4));
  EXPECT_TRUE(this->source.expected.empty());
  this->Finish(Window(4));
  ASSERT_EQ(this->source.expected.size(), 3u);
  for (const rtg::TraceSettings& settings : this->source.expected)
  {
    EXPECT_EQ(settings.features, settings.shading != rtg::Shading::Local);
  }
}

// Compiling takes longer than an update may: there is no image for a while, and then all is as usual.
TEST_F(ProgressiveImageTest, CompilingHoldsNothingUp)
{
  this->source.compilingSeconds = 1.0;
  int empty = 0;
  for (; empty < 100 && !this->image.IsComplete() && this->source.compilingSeconds > 0.0; ++empty)
  {
    const double before = this->source.now;
    ASSERT_NE(this->Update(Window(8)), nullptr);
    EXPECT_LE(this->source.now - before, 0.15);
    EXPECT_EQ(this->image.GetState(), State::Growing);
    EXPECT_EQ(this->source.rays > 0.0, this->source.compilingSeconds <= 0.0);
  }
  EXPECT_GE(empty, 5);
  for (int i = 0; i < 100 && this->image.GetState() != State::Finished; ++i)
  {
    this->Update(Window(8));
  }
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_GE(this->image.Samples(), 8u);
}

} // namespace rtg::testing
