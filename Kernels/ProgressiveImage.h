// One image that is refined, or traced at once: its pixels, its progress, whether it can be
// continued, and its failure. Only this class decides these.
#pragma once

#include "Tracer.h"

#include <cstdint>
#include <functional>
#include <future>
#include <stop_token>
#include <string>
#include <vector>

namespace rtg
{

/// Everything that determines an image. Images of equal views with the same number of samples are the same.
struct ImageView
{
  Camera camera;
  std::vector<Light> lights, previewLights;
  Pass pass = Pass::Opaque;
  TraceSettings settings;         ///< size and light; everything about samples keeps its default
  std::uint64_t sceneVersion = 0; ///< version of what the scene shows

  bool operator==(const ImageView&) const = default;
};

/// `view`, but equal to `kept` where the two differ by rounding only. A camera that is set anew for each frame may be
/// rounded differently each time (two per cent of all view-up vectors are, which are normalized each time), and its
/// image would never finish.
ImageView Settled(ImageView view, const ImageView& kept);

enum class Denoising
{
  Never,
  WhileGrowing, ///< finished images are left as they are
  Always
};

/// How good an image is wanted, and how much of it one Update() may do.
struct ImageEffort
{
  std::uint32_t samples = 1;       ///< samples a pixel of a finished image, >= 1
  std::uint32_t samplesAtOnce = 0; ///< most samples that one Update() adds; 0: as many as there is time for
  double seconds = 0.0;            ///< that one Update() may take, but for a launch; 0: no limit
  double firstSeconds = 0.0;       ///< likewise, where there was nothing to see of the image; at least `seconds`
  bool preview = false;            ///< the camera moves: a preview will do
  std::uint32_t pixelStep = 2; ///< pixels of the image a pixel of a preview, along a side, >= 1; more if time is short
  /// True: the finished image has exactly `samples`, spread as for that number. False: more are as good, and a larger
  /// number is added to what is there.
  bool exact = true;
  Denoising denoising = Denoising::Never;
  bool features = false; ///< the finished image has ImageFeatures
};

/// Whether what is shown of such an image has less noise than its samples, which only whole images can be given.
bool Denoises(const ImageView& view, const ImageEffort& effort);

/// Traces for a ProgressiveImage: a Tracer and its Scene, or a stand-in in tests.
class ImageSource
{
public:
  virtual ~ImageSource() = default;

  /// Brings device and scene up to date. False: samples that the tracer kept are gone.
  virtual bool Prepare() = 0;
  virtual Image Trace(const ImageView& view, const TraceSettings& settings, const Interrupt& interrupt) = 0;
  /// Goes on with that image until it has so many samples.
  virtual Image Resume(std::uint32_t samples, const Interrupt& interrupt) = 0;
  /// Traces an image beside that one, which stays as it is, in the view's previewLights.
  virtual Image Preview(const ImageView& view, const TraceSettings& settings, const Interrupt& interrupt) = 0;
  /// Images of the view may soon be wanted with one of these settings: what that takes is prepared in the background.
  virtual void Expect(const ImageView& view, const std::vector<TraceSettings>& settings) = 0;
  /// The denoising of the last image, to be run in any thread. It returns or throws soon after a stop is requested.
  virtual std::function<std::vector<std::uint32_t>()> Denoise(std::stop_token stop) = 0;

  /// False: there is no device, or it was lost.
  virtual bool HasDevice() const = 0;
  /// There is one, but it was lost.
  virtual bool IsDeviceLost() const = 0;
  /// Bytes that are held on the device by all views.
  virtual std::uint64_t HeldBytes() const = 0;
  /// Seconds since some fixed time.
  virtual double Now() const = 0;
};

/// The image of a view. A first one, of fewer and larger pixels, is there at once: a preview, shaded locally, because a
/// single sample of other light is all noise. Where only the light has changed there is none: what was seen before
/// shows more.
class ProgressiveImage
{
public:
  enum class State
  {
    Empty,    ///< no image was requested yet, or all was forgotten
    Growing,  ///< more samples are to come
    Finished, ///< it has all samples that the last effort wanted
    Failed    ///< there is none; see Failure
  };

  /// Where a failure lies. It is tried again when its cause may have gone.
  enum class Cause
  {
    Device, ///< none, or lost: again once after a loss, then with other content
    Memory, ///< it did not suffice, of the device or of the computer: again with each image that is no preview
    Scene,  ///< it could not be sent or built: again with other content or when memory was given back
    Image ///< it could not be traced: again with another size, light, number of samples, content, or memory given back
  };
  struct Failure
  {
    Cause cause = Cause::Image;
    std::string message;
  };

  ProgressiveImage() = default;
  ~ProgressiveImage();
  ProgressiveImage(const ProgressiveImage&) = delete;
  ProgressiveImage& operator=(const ProgressiveImage&) = delete;

  /// Makes the image of this view, or makes it better. Null: it failed, see GetFailure(). The image, of which there is
  /// nothing unless HasPicture(), is valid until the next call. `interrupt` gets the progress of the image, as
  /// Progress(), and ends the work early; the next call goes on with it. Throws nothing.
  const Image*
  Update(ImageSource& source, const ImageView& view, const ImageEffort& effort, const Interrupt& interrupt = {});

  /// Drops image and failure.
  void Forget();

  State GetState() const { return this->state_; }
  const Failure& GetFailure() const { return this->failure_; }
  /// Samples that all pixels have.
  std::uint32_t Samples() const { return this->traced_.samples; }
  /// In [0, 1]; 1: finished, or failed, so that more calls of the same kind change nothing.
  double Progress() const;
  /// Grows whenever the pixels of the image change.
  std::uint64_t Version() const { return this->version_; }
  /// The image's view, and whether it has full resolution.
  const ImageView& View() const { return this->view_; }
  bool IsComplete() const { return this->traced_.samples > 0; }
  /// The last Update() found that the program it needs is still being compiled.
  bool IsCompiling() const { return this->compiling_; }
  /// False: there is nothing to show of the view yet.
  bool HasPicture() const { return this->hasPicture_; }
  const Image& GetImage() const
  {
    return this->IsComplete() || this->previewStep_ == 0 ? this->traced_ : this->preview_;
  }

private:
  struct Request; ///< of one Update()

  bool MayTryAgain(const ImageSource& source, const ImageView& view, const ImageEffort& effort) const;
  bool WaitsForProgram(const Image& image);
  void Restart(const Request& request);
  void Preview(const Request& request);
  void Grow(const Request& request);
  /// Whether each pixel has that many samples, or more, and all have the same number.
  bool Has(std::uint32_t samples) const { return this->traced_.complete && this->traced_.samples >= samples; }
  bool IsWorthSmoothing(const Request& request) const;
  void Smooth(const Request& request);
  void ExpectOtherLight(const Request& request);
  void StopSmoothing();
  void Fail(const Request& request, bool prepared, const std::exception& error);

  State state_ = State::Empty;
  Failure failure_;
  ImageView view_;
  TraceSettings settings_; ///< of the image's samples that were requested so far
  Image traced_;           ///< of them what the tracer has
  Image preview_;
  bool compiling_ = false, hasPicture_ = false;
  bool onlyLightChanged_ = false; ///< since there was a picture
  std::uint64_t version_ = 0;
  std::uint32_t wanted_ = 1;      ///< samples of a finished image, as last requested
  std::uint32_t previewStep_ = 0; ///< of the preview that is there; 0: none
  double secondsPerRay_ = 0.0;    ///< of a sample; 0: unknown
  double secondsPerPreviewRay_ = 0.0;

  // Denoised colors, and the number of samples that they were made of.
  std::vector<std::uint32_t> smooth_;
  std::uint32_t smoothSamples_ = 0;
  std::future<std::vector<std::uint32_t>> smoothing_;
  std::stop_source stopOfSmoothing_;
  std::uint32_t smoothingSamples_ = 0;

  // The last failure, for MayTryAgain().
  ImageView failedView_;
  std::uint32_t failedSamples_ = 0;
  std::uint64_t failedBytes_ = 0;
  bool tryNewDevice_ = false; ///< once: a second loss is no accident
  bool lostDevice_ = false;   ///< since the last image
};

} // namespace rtg
