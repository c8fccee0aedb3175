// A stand-in for device, scene, tracer and clock of a ProgressiveImage, for ProgressiveImageTest and its parts.
#pragma once

#include "ProgressiveImage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace rtg::testing
{

using State = ProgressiveImage::State;

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
    this->done = 0;
    this->last = settings;
    this->launchesLeft = 4;
    return this->Run(interrupt);
  }

  Image Resume(std::uint32_t samples, const rtg::Interrupt& interrupt) override
  {
    if (this->launchesLeft > 0)
    {
      ++this->resumes;
      EXPECT_EQ(samples, this->last.samples);
      return this->Run(interrupt);
    }
    if (!this->last.keepSums || samples <= this->done)
    {
      throw rtg::Error("cannot continue");
    }
    this->last.samples = samples;
    this->launchesLeft = 4;
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
      preview.fraction = 0.0;
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
    preview.color = preview.traced = this->previewPixels.data();
    return preview;
  }

  void Expect(const ImageView&, const std::vector<rtg::TraceSettings>& settings) override { this->expected = settings; }

  std::function<std::vector<std::uint32_t>()> Denoise(std::stop_token stop) override
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
    const std::uint32_t added = this->last.samples - this->done;
    const auto fraction = [&] { return (this->done + added * (1.0 - 0.25 * this->launchesLeft)) / this->last.samples; };
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
      this->now += 0.25 * this->secondsPerSample * added;
      --this->launchesLeft;
      stopped = interrupt && interrupt(fraction());
    }
    Image image;
    image.width = width;
    image.height = height;
    image.complete = this->launchesLeft == 0;
    image.fraction = fraction();
    if (image.complete)
    {
      this->rays += added;
      this->done += added;
    }
    image.samples = this->done;
    image.color = image.traced = this->pixels.data();
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
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(width * height, 7u);
  std::vector<std::uint32_t> previewPixels = std::vector<std::uint32_t>(width * height, 5u);
};

inline ImageView View(rtg::Shading shading = rtg::Shading::AmbientOcclusion)
{
  ImageView view;
  view.settings.width = width;
  view.settings.height = height;
  view.settings.shading = shading;
  return view;
}

// As a script asks: all at once.
inline ImageEffort Script(std::uint32_t samples)
{
  ImageEffort effort;
  effort.samples = samples;
  return effort;
}

// As a window asks at rest.
inline ImageEffort Window(std::uint32_t samples)
{
  ImageEffort effort = Script(samples);
  effort.seconds = 0.1;
  effort.exact = false;
  effort.denoising = Denoising::WhileGrowing;
  return effort;
}

class ProgressiveImageTest : public ::testing::Test
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

} // namespace rtg::testing
