#include "ProgressiveImage.h"

#include "Tiles.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace rtg
{

namespace
{

constexpr std::uint32_t firstPreviewStep = 8; ///< of one that measures the cost of a ray
constexpr std::uint32_t coarsestPreviewStep = 64;

std::size_t Pixels(const ImageView& view)
{
  return std::size_t(view.settings.width) * view.settings.height;
}

} // namespace

ImageView Settled(ImageView view, const ImageView& kept)
{
  if (!view.camera.IsNear(kept.camera))
  {
    return view;
  }
  constexpr float rounding = 1e-6f; // of a direction
  const auto settle = [](std::vector<Light>& lights, const std::vector<Light>& as)
  {
    for (std::size_t i = 0; i < std::min(lights.size(), as.size()); ++i)
    {
      const double place = 1e-13 * glm::length(as[i].position);
      if (glm::distance(lights[i].position, as[i].position) <= place &&
        glm::distance(lights[i].direction, as[i].direction) <= rounding)
      {
        lights[i].position = as[i].position;
        lights[i].direction = as[i].direction;
      }
    }
  };
  view.camera = kept.camera;
  settle(view.lights, kept.lights);
  settle(view.previewLights, kept.previewLights);
  if (glm::distance(view.settings.skySlope, kept.settings.skySlope) <= rounding)
  {
    view.settings.skySlope = kept.settings.skySlope;
  }
  return view;
}

bool Denoises(const ImageView& view, const ImageEffort& effort)
{
  const bool grows = !effort.exact || effort.seconds > 0.0 || effort.samplesAtOnce > 0;
  return TraitsOf(view.settings).scatters &&
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
  // The callback of work that takes the image's progress to that value.
  Interrupt MakeInterrupt(double to) const
  {
    if (!this->IsTimed() && !this->interrupt)
    {
      return {};
    }
    return [this, to](double fraction)
    { return (this->IsTimed() && this->Left() <= 0.0) || (this->interrupt && this->interrupt(fraction * to)); };
  }
  bool Denoises() const { return rtg::Denoises(this->view, this->effort); }
};

ProgressiveImage::~ProgressiveImage()
{
  this->StopSmoothing();
}

// The image is no longer shown.
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
  this->traced_ = this->preview_ = {};
  this->hasPicture_ = false;
  this->previewStep_ = 0;
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
  return std::min(0.999, this->traced_.fraction * this->settings_.samples / std::max(1u, this->wanted_));
}

bool ProgressiveImage::MayTryAgain(const ImageSource& source, const ImageView& view, const ImageEffort& effort) const
{
  if (view.sceneVersion != this->failedView_.sceneVersion)
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
    const bool lacksFeatures = (effort.features || request.Denoises()) && !this->settings_.features;
    const std::uint32_t begun = this->settings_.samples;
    const bool cannotGrow = 0 < begun && begun < effort.samples && !this->settings_.keepSums;
    const bool hasNumber = this->traced_.complete && begun == effort.samples;
    const bool otherNumber =
      effort.exact && !hasNumber && (this->settings_.plannedSamples != effort.samples || begun > effort.samples);
    const bool needsFeatures =
      lacksFeatures && (effort.features || effort.denoising == Denoising::Always || !this->Has(effort.samples));
    if (this->state_ == State::Empty || this->state_ == State::Failed || !(view == this->view_) ||
      (!effort.preview && (cannotGrow || otherNumber || needsFeatures)))
    {
      this->Restart(request);
    }

    if (effort.preview)
    {
      const bool sharp = this->IsComplete() || (this->previewStep_ > 0 && this->previewStep_ <= effort.pixelStep);
      if (!sharp)
      {
        this->Preview(request);
      }
    }
    else
    {
      this->Grow(request);
      this->Smooth(request);
      this->ExpectOtherLight(request);
    }
    const bool smoothed = effort.denoising != Denoising::Always || !request.Denoises() || !this->settings_.features ||
      effort.preview || this->smoothSamples_ == this->traced_.samples;
    this->state_ = this->Has(effort.samples) && smoothed ? State::Finished : State::Growing;
    this->lostDevice_ = false;
    return &this->GetImage();
  }
  catch (const std::exception& error)
  {
    this->Fail(request, prepared, error);
  }
  return nullptr;
}

void ProgressiveImage::Fail(const Request& request, bool prepared, const std::exception& error)
{
  const bool hasDevice = request.source.HasDevice();
  const bool exhausted = dynamic_cast<const std::bad_alloc*>(&error);
  const bool memory = exhausted || dynamic_cast<const OutOfMemory*>(&error);
  this->Forget();
  this->state_ = State::Failed;
  this->failure_.cause = !hasDevice ? Cause::Device : memory ? Cause::Memory : prepared ? Cause::Image : Cause::Scene;
  this->failure_.message = exhausted
    ? "Ray Traced Glyphs: the computer's memory does not suffice for the glyphs or their image. Show fewer glyphs "
      "(GlyphMode, MaximumNumberOfGlyphs), make the picture smaller, or hide other data."
    : error.what();
  const bool lost = request.source.IsDeviceLost();
  this->tryNewDevice_ = lost && !this->lostDevice_;
  this->lostDevice_ |= lost;
  this->failedView_ = request.view;
  this->failedSamples_ = request.effort.samples;
  this->failedBytes_ = request.source.HeldBytes();
}

// Each launch has some of the work.
bool ProgressiveImage::WaitsForProgram(const Image& image)
{
  this->compiling_ = !image.complete && image.fraction <= 0.0;
  return this->compiling_;
}

// The image of a view that there is nothing of yet.
void ProgressiveImage::Restart(const Request& request)
{
  const ImageView &was = this->view_, &is = request.view;
  const bool same = is.sceneVersion == was.sceneVersion && is.pass == was.pass &&
    is.settings.width == was.settings.width && is.settings.height == was.settings.height;
  this->onlyLightChanged_ = same && is.camera == was.camera &&
    (this->hasPicture_ || (this->state_ == State::Growing && this->onlyLightChanged_));
  this->Forget();
  if (!same || is.settings.shading != was.settings.shading)
  {
    this->secondsPerRay_ = 0.0;
  }
  this->view_ = request.view;
  this->settings_ = request.view.settings;
  this->settings_.samples = 0;
  this->settings_.plannedSamples = request.effort.samples;
  this->settings_.features = request.effort.features || request.Denoises();
}

// Traces a preview, where the time is limited one of as many pixels as it allows.
void ProgressiveImage::Preview(const Request& request)
{
  const TraceSettings& whole = this->view_.settings;
  TraceSettings settings = whole;
  settings.shading = Shading::Local;
  settings.shadows = false;
  settings.plannedSamples = this->settings_.plannedSamples;
  // It is quick: each process that traces a part of the image traces all of it.
  settings.part = 0;
  settings.parts = 1;
  const auto affordable = [&](double time)
  {
    std::uint32_t step = std::max(1u, request.effort.pixelStep);
    const double all = this->secondsPerPreviewRay_ * Pixels(this->view_);
    while (request.IsTimed() && step < coarsestPreviewStep && all / (double(step) * step) > time)
    {
      ++step;
    }
    return step;
  };
  const double seconds =
    request.effort.preview ? request.effort.seconds : std::max(request.effort.seconds, request.effort.firstSeconds);
  const auto left = [&] { return request.start + seconds - request.source.Now(); };
  // A new preview costs more than a little more time.
  const Interrupt patient = [&](double)
  { return (request.IsTimed() && left() <= -seconds) || (request.interrupt && request.interrupt(0.0)); };
  const bool known = this->secondsPerPreviewRay_ > 0.0 || !request.IsTimed();
  std::uint32_t step = affordable(seconds);
  step = known ? step : std::max(step, firstPreviewStep);
  for (bool final = known;;)
  {
    settings.width = DivideUp(whole.width, step);
    settings.height = DivideUp(whole.height, step);
    const double before = request.source.Now();
    const Image image = request.source.Preview(this->view_, settings, patient);
    if (this->WaitsForProgram(image))
    {
      return;
    }
    if (image.complete)
    {
      this->secondsPerPreviewRay_ = (request.source.Now() - before) / (double(settings.width) * settings.height);
      const std::uint32_t finer = final ? step : affordable(left());
      if (finer < step)
      {
        step = finer;
        final = true;
        continue;
      }
    }
    else if (request.IsTimed() && step < coarsestPreviewStep)
    {
      step = std::min(coarsestPreviewStep, 2 * step);
      final = true;
      continue;
    }
    this->previewStep_ = step;
    this->preview_ = image;
    this->hasPicture_ = true;
    ++this->version_;
    return;
  }
}

// Adds samples in full resolution.
void ProgressiveImage::Grow(const Request& request)
{
  const ImageEffort& effort = request.effort;
  const auto pixels = static_cast<double>(Pixels(this->view_));
  const bool begun = this->settings_.samples > 0 && this->traced_.fraction > 0.0;
  if (request.IsTimed() && !begun && !this->hasPicture_ && !this->onlyLightChanged_)
  {
    // Something to see at once, unless a sample of all pixels is as quick.
    const bool quick = this->secondsPerRay_ > 0.0 && this->secondsPerRay_ * pixels < 0.5 * effort.seconds;
    if (!quick)
    {
      this->Preview(request);
    }
    if (this->hasPicture_ && request.Left() <= 0.0)
    {
      return;
    }
  }
  const std::uint32_t had = this->traced_.samples;
  bool interrupted = false;
  while (!this->Has(effort.samples) && !interrupted &&
    (effort.samplesAtOnce == 0 || this->traced_.samples - had < effort.samplesAtOnce))
  {
    const double start = request.source.Now();
    const bool begins = this->settings_.samples == 0;
    const double samples = this->traced_.fraction * this->settings_.samples;
    if (this->traced_.complete)
    {
      std::uint32_t left = effort.samples - this->traced_.samples;
      if (effort.samplesAtOnce > 0)
      {
        left = std::min(left, had + effort.samplesAtOnce - this->traced_.samples);
      }
      else if (request.IsTimed())
      {
        const double affordable = this->secondsPerRay_ > 0.0 ? request.Left() / (this->secondsPerRay_ * pixels) : 1.0;
        left = std::min(left, static_cast<std::uint32_t>(std::clamp(affordable, 1.0, 1e6)));
      }
      this->settings_.samples += left;
    }
    const Interrupt interrupt = request.MakeInterrupt(double(this->settings_.samples) / effort.samples);
    if (begins)
    {
      this->settings_.keepSums = !effort.exact || this->settings_.features || this->settings_.samples < effort.samples;
      this->traced_ = request.source.Trace(this->view_, this->settings_, interrupt);
    }
    else
    {
      this->traced_ = request.source.Resume(this->settings_.samples, interrupt);
    }
    interrupted = !this->traced_.complete;
    const double added = this->traced_.fraction * this->settings_.samples - samples;
    const bool waits = this->WaitsForProgram(this->traced_);
    if (added > 0.0)
    {
      const double cost = (request.source.Now() - start) / (pixels * added);
      this->secondsPerRay_ = this->secondsPerRay_ > 0.0 ? 0.5 * (this->secondsPerRay_ + cost) : cost;
    }
    // A first sample that not all pixels have is shown only where there is nothing else.
    if (this->IsComplete() || (!waits && this->previewStep_ == 0 && !(request.IsTimed() && this->onlyLightChanged_)))
    {
      this->hasPicture_ = true;
      ++this->version_;
    }
    interrupted |= request.IsTimed() && (request.Left() <= 0.0 || this->IsWorthSmoothing(request));
  }
}

// Denoising takes about as long as a sample: only when there is a good deal more to see, or nothing more to come.
bool ProgressiveImage::IsWorthSmoothing(const Request& request) const
{
  const std::uint32_t samples = this->traced_.samples;
  const bool more = this->smoothSamples_ == 0 || 2 * samples >= 3 * this->smoothSamples_ ||
    (this->Has(request.effort.samples) && this->smoothSamples_ != samples);
  return more && this->settings_.features && request.Denoises() && this->Has(1) && !this->smoothing_.valid();
}

// Colors with less noise, of the image as it is or, where the time is limited, as it was when another thread began.
void ProgressiveImage::Smooth(const Request& request)
{
  const ImageEffort& effort = request.effort;
  const bool wanted = this->settings_.features && request.Denoises() && this->IsComplete() &&
    (effort.denoising == Denoising::Always || !this->Has(effort.samples));
  if (!wanted)
  {
    if (this->smoothSamples_ > 0)
    {
      this->smooth_.clear();
      this->smoothSamples_ = 0;
      this->traced_.color = this->traced_.traced;
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
  if (this->IsWorthSmoothing(request))
  {
    this->smoothingSamples_ = this->traced_.samples;
    this->stopOfSmoothing_ = std::stop_source();
    const auto denoising = std::make_shared<std::packaged_task<std::vector<std::uint32_t>()>>(
      request.source.Denoise(this->stopOfSmoothing_.get_token()));
    this->smoothing_ = denoising->get_future();
    bool apart = request.IsTimed();
    try
    {
      if (apart)
      {
        std::thread([denoising] { (*denoising)(); }).detach();
      }
    }
    catch (const std::system_error&) // no thread can be started
    {
      apart = false;
    }
    if (!apart)
    {
      (*denoising)();
      collect();
    }
  }
  if (this->smoothSamples_ > 0)
  {
    this->traced_.color = this->smooth_.data();
  }
}

// The user may switch to another shading mode.
void ProgressiveImage::ExpectOtherLight(const Request& request)
{
  if (!request.IsTimed() || !this->IsComplete())
  {
    return;
  }
  std::vector<TraceSettings> expected;
  ImageView other = request.view;
#define RTG_EXPECTED(number, Name, ...)                                                                                \
  other.settings.shading = Shading::Name;                                                                              \
  other.settings.features = request.effort.features || rtg::Denoises(other, request.effort);                           \
  expected.push_back(other.settings);
  RTG_SHADINGS(RTG_EXPECTED)
#undef RTG_EXPECTED
  request.source.Expect(request.view, expected);
}

} // namespace rtg
