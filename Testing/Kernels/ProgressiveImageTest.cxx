// Every way from one state of an image to another, with a stand-in for device, scene, tracer and clock.
#include "ProgressiveImage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace
{

using rtg::Denoising;
using rtg::Image;
using rtg::ImageEffort;
using rtg::ImageView;
using rtg::ProgressiveImage;
using State = rtg::ProgressiveImage::State;

constexpr std::uint32_t width = 64, height = 32;

// Traces nothing, but keeps what a tracer keeps and insists on what a tracer insists on. A launch is a quarter of the
// samples asked for.
class Source : public rtg::ImageSource
{
public:
  bool Prepare() override
  {
    if (this->noDevice)
    {
      this->hasDevice = false;
      throw rtg::Error("no device");
    }
    const bool kept = this->hasDevice;
    this->hasDevice = true;
    this->lost = false;
    if (this->sceneFails)
    {
      throw rtg::Error("scene");
    }
    return kept;
  }

  Image Trace(const ImageView&, const rtg::TraceSettings& settings, const rtg::Interrupt& interrupt) override
  {
    ++this->traces;
    if (settings.firstSample > 0 &&
      (!this->keeps || this->done != settings.firstSample || this->launchesLeft > 0 ||
        this->last.features != settings.features))
    {
      throw rtg::Error("cannot continue");
    }
    this->done = settings.firstSample;
    this->last = settings;
    this->launchesLeft = 4;
    return this->Run(interrupt);
  }

  Image Resume(const rtg::Interrupt& interrupt) override
  {
    ++this->resumes;
    return this->Run(interrupt);
  }

  Image Preview(const ImageView& of, const rtg::TraceSettings& settings, const rtg::Interrupt& interrupt) override
  {
    this->previewStep = std::ceil(double(of.settings.width) / settings.width);
    this->previewShading = settings.shading;
    const double pixels = double(settings.width) * settings.height / (double(width) * height);
    Image preview;
    preview.complete = this->previewCompilingSeconds <= 0.0;
    if (!preview.complete)
    {
      preview.share = 0.0f;
      do
      {
        this->now += 0.02;
        this->previewCompilingSeconds -= 0.02;
      } while (!(interrupt && interrupt(0.0)) && this->previewCompilingSeconds > 0.0);
      return preview;
    }
    ++this->previews;
    for (int launch = 0; launch < 4 && preview.complete; ++launch)
    {
      this->now += 0.25 * pixels * this->secondsPerSample;
      preview.complete = launch == 3 || !interrupt || !interrupt(0.25 * (launch + 1));
    }
    preview.width = settings.width;
    preview.height = settings.height;
    preview.colour = preview.traced = this->previewPixels.data();
    return preview;
  }

  void Expect(const ImageView&, const std::vector<rtg::TraceSettings>& settings) override { this->expected = settings; }

  std::function<std::vector<std::uint32_t>()> Denoise(const Image&, std::stop_token stop) override
  {
    ++this->denoisings;
    return [this, stop, n = this->done]
    {
      const auto begin = std::chrono::steady_clock::now();
      while (this->denoisingSeconds > std::chrono::steady_clock::now() - begin && !stop.stop_requested())
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      this->denoisingsStopped += stop.stop_requested();
      return std::vector<std::uint32_t>(width * height, n);
    };
  }

  bool HasDevice() const override { return this->hasDevice; }
  bool IsDeviceLost() const override { return this->lost; }
  std::uint64_t HeldBytes() const override { return this->bytes; }
  double Now() const override { return this->now; }

  Image Run(const rtg::Interrupt& interrupt)
  {
    bool stopped = false;
    while (this->compilingSeconds > 0.0 && !stopped)
    {
      this->now += 0.02;
      this->compilingSeconds -= 0.02;
      stopped = interrupt && interrupt(0.0);
    }
    while (this->launchesLeft > 0 && !stopped)
    {
      if (this->traceFails)
      {
        throw rtg::Error("image");
      }
      if (this->memoryFails)
      {
        throw std::bad_alloc();
      }
      if (this->loseDevice)
      {
        this->loseDevice = this->hasDevice = false;
        this->lost = true;
        throw rtg::Error("lost");
      }
      this->now += 0.25 * this->secondsPerSample * this->last.samples;
      --this->launchesLeft;
      stopped = interrupt && interrupt(1.0 - 0.25 * this->launchesLeft);
    }
    Image image;
    image.width = width;
    image.height = height;
    image.complete = this->launchesLeft == 0;
    image.share = 1.0f - 0.25f * this->launchesLeft;
    if (image.complete)
    {
      this->rays += this->last.samples;
      this->done += this->last.samples;
      this->keeps = this->last.keepSums;
    }
    image.samples = this->done;
    image.colour = image.traced = this->pixels.data();
    return image;
  }

  bool noDevice = false, hasDevice = true, lost = false, sceneFails = false, traceFails = false, memoryFails = false,
       loseDevice = false;
  double compilingSeconds = 0.0, previewCompilingSeconds = 0.0, secondsPerSample = 0.01, now = 0.0, rays = 0.0;
  std::uint64_t bytes = 100;
  int traces = 0, resumes = 0, denoisings = 0, previews = 0;
  double previewStep = 0.0;
  rtg::Shading previewShading = rtg::Shading::PathTracing;
  std::chrono::duration<double> denoisingSeconds{ 0.0 };
  std::atomic<int> denoisingsStopped{ 0 };
  rtg::TraceSettings last;
  std::vector<rtg::TraceSettings> expected;

private:
  std::uint32_t done = 0, launchesLeft = 0;
  bool keeps = false;
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(width * height, 7u);
  std::vector<std::uint32_t> previewPixels = std::vector<std::uint32_t>(width * height, 5u);
};

ImageView View(rtg::Shading shading = rtg::Shading::AmbientOcclusion)
{
  ImageView view;
  view.settings.width = width;
  view.settings.height = height;
  view.settings.shading = shading;
  return view;
}

// As a script asks: all at once.
ImageEffort Script(std::uint32_t samples)
{
  ImageEffort effort;
  effort.samples = samples;
  return effort;
}

// As a window asks at rest.
ImageEffort Window(std::uint32_t samples)
{
  ImageEffort effort = Script(samples);
  effort.seconds = 0.1;
  effort.exact = false;
  effort.denoising = Denoising::WhileGrowing;
  return effort;
}

class ProgressiveImageTest : public testing::Test
{
protected:
  const Image* Update(const ImageEffort& effort) { return this->image.Update(this->source, this->view, effort); }

  // Number of updates until the image is finished.
  int Finish(const ImageEffort& effort)
  {
    int updates = 0;
    do
    {
      this->Update(effort);
      ++updates;
    } while (this->image.GetState() == State::Growing && updates < 100000);
    return updates;
  }

  Source source;
  ImageView view = View();
  ProgressiveImage image;
};

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
  while (this->image.Samples() < 34)
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
    EXPECT_EQ(this->image.GetImage().colour[0], 7u) << "a finished image is denoised";
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
  this->view.content = 1;
  changed("content");
  this->view.settings.shading = rtg::Shading::Local;
  changed("shading");
  this->view.settings.width = 2 * width;
  changed("size");
  this->view.pass = rtg::Pass::Translucent;
  changed("pass");
}

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
    ++this->view.content;
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
    this->view.content = content;
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
      EXPECT_EQ(this->image.GetImage().colour[0], 5u);
      EXPECT_EQ(this->image.Version(), version);
      ASSERT_NE(this->Update(Window(4)), nullptr);
    }
    EXPECT_GT(updates, 1);
    EXPECT_EQ(this->image.GetImage().colour[0], 7u);
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

TEST_F(ProgressiveImageTest, AnImageOfTheSceneFailsUntilItsContentChangesOrMemoryIsFreed)
{
  this->source.sceneFails = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Failed);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Scene);
  EXPECT_EQ(this->image.Progress(), 1.0);
  this->source.sceneFails = false;
  this->view.settings.width /= 2;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->source.bytes = 50;
  EXPECT_NE(this->Update(Script(1)), nullptr);

  this->source.sceneFails = true;
  this->view.content = 1;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->source.sceneFails = false;
  this->view.content = 2;
  EXPECT_NE(this->Update(Script(1)), nullptr);
}

TEST_F(ProgressiveImageTest, ATraceFailsUntilSizeLightSamplesContentOrMemoryChange)
{
  const auto fail = [this]
  {
    this->source.traceFails = true;
    this->view.camera.eye.y += 1.0;
    EXPECT_EQ(this->Update(Script(8)), nullptr);
    EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Image);
    this->source.traceFails = false;
    EXPECT_EQ(this->Update(Script(8)), nullptr) << "the same image is tried again";
  };
  fail();
  this->view.settings.width /= 2;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  this->view.settings.shading = rtg::Shading::Local;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  EXPECT_NE(this->Update(Script(4)), nullptr);
  fail();
  this->source.bytes -= 1;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  this->view.content += 1;
  EXPECT_NE(this->Update(Script(8)), nullptr);
}

TEST_F(ProgressiveImageTest, ALostDeviceIsReplacedOnce)
{
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Device);
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->source.traces, 2);
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->source.traces, 2) << "a device that was lost twice is tried a third time";
  this->view.content = 1;
  EXPECT_NE(this->Update(Script(4)), nullptr);
  // After an image a loss is an accident again.
  this->view.content = 2;
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_NE(this->Update(Script(4)), nullptr);
}

TEST_F(ProgressiveImageTest, SamplesOnALostDeviceAreGone)
{
  this->Update(Window(64));
  this->source.hasDevice = false; // another view's image lost it
  this->Finish(Window(64));
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->image.Samples(), 64u);
}

TEST_F(ProgressiveImageTest, NoDeviceIsAskedForAgainWithOtherContent)
{
  this->source.noDevice = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Device);
  this->source.noDevice = false;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->view.content = 1;
  EXPECT_NE(this->Update(Script(1)), nullptr);
}

TEST_F(ProgressiveImageTest, LackOfMemoryIsAFailureInWords)
{
  this->source.memoryFails = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_NE(this->image.GetFailure().message.find("memory"), std::string::npos);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Memory);
  EXPECT_EQ(this->image.Progress(), 1.0) << "a window would render for ever";
  // Memory may be free again at any time; a turning camera does not ask for it with each picture.
  this->source.memoryFails = false;
  ImageEffort turning = Window(1);
  turning.preview = true;
  EXPECT_EQ(this->Update(turning), nullptr);
  EXPECT_NE(this->Update(Script(1)), nullptr);
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

TEST_F(ProgressiveImageTest, GrowingImagesAreDenoisedAndFinishedOnesNotUnlessAlways)
{
  ImageEffort effort = Script(8);
  effort.samplesAtOnce = 2;
  effort.denoising = Denoising::WhileGrowing;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().colour[0], 2u);
  this->Finish(effort);
  EXPECT_EQ(this->image.GetImage().colour[0], 7u);

  effort.denoising = Denoising::Always;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().colour[0], 8u);
  EXPECT_EQ(this->image.GetState(), State::Finished);
}

TEST_F(ProgressiveImageTest, AMoveOfTheCameraStopsTheDenoisingOfWhatItLeaves)
{
  this->source.denoisingSeconds = std::chrono::seconds(20);
  this->Update(Window(64));
  ASSERT_EQ(this->source.denoisings, 1);
  EXPECT_EQ(this->source.denoisingsStopped, 0);
  this->view.camera.eye.x += 1.0;
  ImageEffort turning = Window(64);
  turning.preview = true;
  ASSERT_NE(this->Update(turning), nullptr) << this->image.GetFailure().message;
  EXPECT_EQ(this->source.denoisingsStopped, 1);
}

TEST_F(ProgressiveImageTest, AFinishedImageIsTracedAnewForTheDenoiser)
{
  ImageEffort effort = Script(4);
  this->Update(effort);
  effort.denoising = Denoising::WhileGrowing;
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 1);
  effort.denoising = Denoising::Always;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().colour[0], 4u);
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 2);
}

TEST_F(ProgressiveImageTest, LocalLightHasNoNoiseToTakeAway)
{
  this->view = View(rtg::Shading::Local);
  ImageEffort effort = Window(8);
  effort.denoising = Denoising::Always;
  this->Finish(effort);
  EXPECT_EQ(this->source.denoisings, 0);
  EXPECT_FALSE(this->source.last.features);
}

TEST_F(ProgressiveImageTest, FeaturesOfAFinishedImageAreTracedWhereTheyLack)
{
  this->Update(Script(4));
  ImageEffort effort = Script(4);
  effort.features = true;
  this->Update(effort);
  EXPECT_TRUE(this->source.last.features);
  EXPECT_EQ(this->source.traces, 2);
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 2);
}

// Once there is something to see of a window's image, it may be wanted in any light; scripts know what they want.
TEST_F(ProgressiveImageTest, OtherLightIsExpected)
{
  this->Update(Script(4));
  EXPECT_TRUE(this->source.expected.empty());
  this->view.content = 1;
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

} // namespace
