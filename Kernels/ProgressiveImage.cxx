#include "ProgressiveImage.h"

#include "Parallel.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace rtg
{

namespace
{

constexpr std::uint32_t firstPreviewStep = 8; ///< while nothing is known of what a ray costs
constexpr std::uint32_t coarsestPreviewStep = 64;

std::size_t Pixels(const ImageView& view)
{
  return std::size_t(view.settings.width) * view.settings.height;
}

bool IsNoisy(const ImageView& view)
{
  return TraitsOf(view.settings).scatters;
}

} // namespace

bool Denoises(const ImageView& view, const ImageEffort& effort)
{
  const bool grows = !effort.exact || effort.seconds > 0.0 || effort.samplesAtOnce > 0;
  return IsNoisy(view) &&
    (effort.denoising == Denoising::Always || (effort.denoising == Denoising::WhileGrowing && grows));
}

struct ProgressiveImage::Request
{
  ImageSource& source;
  const ImageView& view;
  const ImageEffort& effort;
  const Interrupt& interrupt;
  double start;

  bool IsTimed() const { return this->effort.seconds > 0.0; }
  double Left() const { return this->start + this->effort.seconds - this->source.Now(); }
  // Of work that takes the image's progress from one value to another.
  Interrupt MakeInterrupt(double from, double to) const
  {
    if (!this->IsTimed() && !this->interrupt)
    {
      return {};
    }
    return [this, from, to](double share)
    {
      return (this->IsTimed() && this->Left() <= 0.0) ||
        (this->interrupt && this->interrupt(from + share * (to - from)));
    };
  }
  bool Denoises() const { return rtg::Denoises(this->view, this->effort); }
};

ProgressiveImage::~ProgressiveImage()
{
  this->StopSmoothing();
}

// What it was for is not shown any more.
void ProgressiveImage::StopSmoothing()
{
  if (this->smoothing_.valid())
  {
    this->stopOfSmoothing_.request_stop();
    this->smoothing_.wait();
    this->smoothing_ = {};
  }
}

void ProgressiveImage::Forget()
{
  this->state_ = State::Empty;
  this->samples_ = 0;
  this->previewStep_ = 0;
  this->pending_ = this->canContinue_ = this->features_ = false;
  this->smooth_.clear();
  this->smoothSamples_ = 0;
  this->StopSmoothing();
}

double ProgressiveImage::Progress() const
{
  if (this->state_ != State::Growing)
  {
    return this->state_ == State::Empty ? 0.0 : 1.0;
  }
  const double part = this->pending_ ? double(this->image_.share) * this->pendingSamples_ : 0.0;
  return std::min(0.999, (this->samples_ + part) / std::max(1u, this->wanted_));
}

bool ProgressiveImage::MayTryAgain(const ImageSource& source, const ImageView& view, const ImageEffort& effort) const
{
  if (view.content != this->failedView_.content)
  {
    return true;
  }
  const bool freed = source.HeldBytes() < this->failedBytes_;
  switch (this->failure_.cause)
  {
    case Cause::Device:
      return this->tryNewDevice_ || source.HasDevice();
    case Cause::Memory:
      return !effort.preview;
    case Cause::Scene:
      return freed;
    default:
      return freed || !(view.settings == this->failedView_.settings) || effort.samples != this->failedSamples_;
  }
}

const Image* ProgressiveImage::Update(
  ImageSource& source, const ImageView& view, const ImageEffort& effort, const Interrupt& interrupt)
{
  if (this->state_ == State::Failed && !this->MayTryAgain(source, view, effort))
  {
    return nullptr;
  }
  const Request request{ source, view, effort, interrupt, source.Now() };
  bool prepared = false;
  try
  {
    if (!source.Prepare())
    {
      this->Forget();
    }
    prepared = true;
    this->wanted_ = effort.samples;
    const bool lacksFeatures = (effort.features || request.Denoises()) && !this->features_;
    const std::uint32_t begun = this->samples_ + (this->pending_ ? this->pendingSamples_ : 0);
    const bool cannotGrow = 0 < begun && begun < effort.samples && !this->canContinue_;
    const bool otherNumber = effort.exact && this->planned_ != effort.samples && this->samples_ != effort.samples;
    if (this->state_ == State::Empty || this->state_ == State::Failed || !(view == this->view_))
    {
      this->Restart(request);
    }
    else if (!effort.preview &&
      (cannotGrow || otherNumber ||
        (lacksFeatures &&
          (effort.features || effort.denoising == Denoising::Always || this->samples_ < effort.samples))))
    {
      this->Restart(request);
    }

    if (effort.preview)
    {
      const bool sharp = this->samples_ > 0 || (this->previewStep_ > 0 && this->previewStep_ <= effort.pixelStep);
      if (!sharp)
      {
        this->Preview(request, effort.pixelStep);
      }
    }
    else
    {
      this->Grow(request);
      this->Smooth(request);
    }
    const bool smoothed = effort.denoising != Denoising::Always || !this->features_ || effort.preview ||
      this->smoothSamples_ == this->samples_;
    this->state_ = this->samples_ >= effort.samples && smoothed ? State::Finished : State::Growing;
    this->lostDevice_ = false;
    return &this->image_;
  }
  catch (const std::bad_alloc&)
  {
    this->Fail(request, prepared, /*memory=*/true,
      "Ray Traced Glyphs: the computer's memory does not suffice for the glyphs or their image. "
      "Show fewer glyphs "
      "(GlyphMode, MaximumNumberOfGlyphs), make the picture smaller, or hide other data.");
  }
  catch (const OutOfMemory& error)
  {
    this->Fail(request, prepared, /*memory=*/true, error.what());
  }
  catch (const std::exception& error)
  {
    this->Fail(request, prepared, /*memory=*/false, error.what());
  }
  return nullptr;
}

void ProgressiveImage::Fail(const Request& request, bool prepared, bool memory, const char* message)
{
  const bool hasDevice = request.source.HasDevice();
  this->Forget();
  this->state_ = State::Failed;
  this->failure_.cause = !hasDevice ? Cause::Device : memory ? Cause::Memory : prepared ? Cause::Image : Cause::Scene;
  this->failure_.message = message;
  const bool lost = request.source.IsDeviceLost();
  this->tryNewDevice_ = lost && !this->lostDevice_;
  this->lostDevice_ |= lost;
  this->failedView_ = request.view;
  this->failedSamples_ = request.effort.samples;
  this->failedBytes_ = request.source.HeldBytes();
}

// No launch is without a share of the work.
bool ProgressiveImage::WaitsForProgram(const Image& image)
{
  this->compiling_ = !image.complete && image.share <= 0.0f;
  return this->compiling_;
}

// The image of a view that there is nothing of yet.
void ProgressiveImage::Restart(const Request& request)
{
  const bool sameSize = Pixels(request.view) == Pixels(this->view_) &&
    request.view.settings.shading == this->view_.settings.shading && request.view.content == this->view_.content;
  this->Forget();
  if (!sameSize)
  {
    this->secondsPerRay_ = 0.0;
  }
  this->view_ = request.view;
  this->planned_ = request.effort.samples;
  this->features_ = request.effort.features || request.Denoises();
}

void ProgressiveImage::Show(const Image& image)
{
  this->image_ = image;
  ++this->version_;
}

// One sample of every pixelStep-th pixel; fewer pixels where the time is limited and rays cost too much.
void ProgressiveImage::Preview(const Request& request, std::uint32_t pixelStep)
{
  TraceSettings settings = this->view_.settings;
  settings.samples = 1;
  settings.plannedSamples = this->planned_;
  // Where an image will grow it takes the same program, which need not be compiled when the camera comes to rest.
  settings.keepSums = !request.effort.exact || this->features_;
  settings.features = this->features_;
  std::uint32_t step = std::max(1u, pixelStep);
  if (request.IsTimed() && this->secondsPerRay_ > 0.0)
  {
    const double seconds = this->secondsPerRay_ * Pixels(this->view_); // of all pixels
    while (step < coarsestPreviewStep && seconds / (double(step) * step) > request.effort.seconds)
    {
      ++step;
    }
  }
  for (;;)
  {
    settings.pixelStep = step;
    if (step > 1)
    {
      // Such an image is not added to, so its samples need not be like others.
      settings.occlusionRays = settings.paths = 1;
      // It is quick: each process that traces a share of the image traces all of it.
      settings.share = 0;
      settings.shares = 1;
    }
    const double before = request.source.Now();
    Image image = request.source.Trace(this->view_, settings, request.MakeInterrupt(0.0, 0.0));
    const double seconds = request.source.Now() - before;
    if (this->WaitsForProgram(image))
    {
      this->pending_ = this->canContinue_ = false;
      this->Show(image);
      return;
    }
    if (image.complete || step >= coarsestPreviewStep)
    {
      this->previewStep_ = step;
      this->pending_ = this->canContinue_ = false;
      if (step == 1)
      {
        this->samples_ = image.complete ? 1 : 0;
        this->pending_ = !image.complete;
        this->canContinue_ = image.complete && settings.keepSums;
        this->previewStep_ = 0;
      }
      else if (this->secondsPerRay_ <= 0.0)
      {
        this->secondsPerRay_ = seconds * step * step / Pixels(this->view_);
      }
      image.samples = 1;
      this->Show(image);
      return;
    }
    if (!request.IsTimed())
    {
      // The caller has stopped it. The tracer holds this preview now, not a sample that was stopped before.
      this->previewStep_ = step;
      this->pending_ = this->canContinue_ = false;
      this->Show(image);
      return;
    }
    step = std::min(coarsestPreviewStep, 2 * step);
  }
}

// Adds samples in full resolution.
void ProgressiveImage::Grow(const Request& request)
{
  const ImageEffort& effort = request.effort;
  const auto pixels = static_cast<double>(Pixels(this->view_));
  if (request.IsTimed() && this->samples_ == 0 && !this->pending_ && this->previewStep_ == 0)
  {
    // Something to see at once, unless a sample of all pixels is as quick.
    const bool quick = this->secondsPerRay_ > 0.0 && this->secondsPerRay_ * pixels < 0.5 * effort.seconds;
    if (!quick)
    {
      this->Preview(request, this->secondsPerRay_ > 0.0 ? effort.pixelStep : firstPreviewStep);
      if (this->previewStep_ == 0 && this->samples_ == 0 && !this->pending_)
      {
        return;
      }
    }
  }
  std::uint32_t added = 0;
  bool interrupted = false;
  const double wanted = effort.samples;
  while (this->samples_ < effort.samples && !interrupted && (effort.samplesAtOnce == 0 || added < effort.samplesAtOnce))
  {
    const double before = request.source.Now();
    Image image;
    if (this->pending_)
    {
      image = request.source.Resume(
        request.MakeInterrupt(this->samples_ / wanted, (this->samples_ + this->pendingSamples_) / wanted));
    }
    else
    {
      TraceSettings settings = this->view_.settings;
      std::uint32_t left = effort.samples - this->samples_;
      if (effort.samplesAtOnce > 0)
      {
        left = std::min(left, effort.samplesAtOnce - added);
      }
      else if (request.IsTimed())
      {
        const double affordable = this->secondsPerRay_ > 0.0 ? request.Left() / (this->secondsPerRay_ * pixels) : 1.0;
        left = std::min(left, static_cast<std::uint32_t>(std::clamp(affordable, 1.0, 1e6)));
      }
      settings.samples = left;
      settings.firstSample = this->samples_;
      settings.plannedSamples = this->planned_;
      settings.features = this->features_;
      settings.keepSums = !effort.exact || this->features_ || this->samples_ + left < effort.samples;
      settings.overPreview = this->samples_ == 0 && this->previewStep_ > 0;
      this->canContinue_ = settings.keepSums;
      this->pendingSamples_ = left;
      image = request.source.Trace(
        this->view_, settings, request.MakeInterrupt(this->samples_ / wanted, (this->samples_ + left) / wanted));
    }
    this->WaitsForProgram(image);
    const std::uint32_t before_ = this->samples_;
    this->pending_ = interrupted = !image.complete;
    if (image.complete)
    {
      this->samples_ = image.samples;
      added += this->samples_ - before_;
      const double cost = (request.source.Now() - before) / (pixels * std::max(1u, this->samples_ - before_));
      this->secondsPerRay_ = this->secondsPerRay_ > 0.0 ? 0.5 * (this->secondsPerRay_ + cost) : cost;
    }
    else if (image.share > 0.0f)
    {
      this->secondsPerRay_ = std::max(this->secondsPerRay_, 1e-12);
    }
    this->Show(image);
    interrupted |= request.IsTimed() && request.Left() <= 0.0;
  }
}

// Colors with less noise, of the image as it is or, where the time is limited, as it was when another thread began.
void ProgressiveImage::Smooth(const Request& request)
{
  const ImageEffort& effort = request.effort;
  const bool finished = this->samples_ >= effort.samples;
  const bool wanted =
    this->features_ && request.Denoises() && this->samples_ > 0 && (effort.denoising == Denoising::Always || !finished);
  if (!wanted)
  {
    if (this->smoothSamples_ > 0)
    {
      this->smooth_.clear();
      this->smoothSamples_ = 0;
      this->image_.colour = this->image_.traced;
      ++this->version_;
    }
    return;
  }
  const auto collect = [this]
  {
    this->smooth_ = this->smoothing_.get();
    this->smoothSamples_ = this->smoothingSamples_;
    ++this->version_;
  };
  if (this->smoothing_.valid() &&
    (!request.IsTimed() || this->smoothing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready))
  {
    collect();
  }
  // Denoising takes about as long as a sample: only when there is a good deal more to see, or nothing more to come.
  const bool worthIt = this->smoothSamples_ == 0 || 2 * this->samples_ >= 3 * this->smoothSamples_ ||
    (finished && this->smoothSamples_ != this->samples_);
  if (!this->smoothing_.valid() && !this->pending_ && worthIt && this->image_.complete)
  {
    this->smoothingSamples_ = this->samples_;
    this->stopOfSmoothing_ = std::stop_source();
    std::packaged_task<std::vector<std::uint32_t>()> denoising(
      request.source.Denoise(this->image_, this->stopOfSmoothing_.get_token()));
    this->smoothing_ = denoising.get_future();
    if (request.IsTimed())
    {
      RunInBackground(std::move(denoising));
    }
    else
    {
      denoising();
      collect();
    }
  }
  if (this->smoothSamples_ > 0)
  {
    this->image_.colour = this->smooth_.data();
  }
}

} // namespace rtg
