#include "RayTracedFrame.h"

#include "RayTracedFrameStatus.h"
#include "RayTracedOpenGLState.h"
#include "RayTracedProgress.h"
#include "RayTracedRanks.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace
{
// Ctrl+C while an image is traced. A Python interpreter only takes note of the signal and acts when it runs again,
// which may be minutes later; while an object of this class lives Arrived() is true after the signal. It is passed on
// when the object goes. Programs without a handler of their own are left alone: there the signal ends the program.
class InterruptSignal
{
public:
  InterruptSignal()
  {
    const Handler before = std::signal(SIGINT, Handle);
    if (before == SIG_DFL || before == SIG_IGN || before == SIG_ERR || before == Handle)
    {
      std::signal(SIGINT, before == SIG_ERR ? SIG_DFL : before);
      return;
    }
    Raised = 0;
    this->Before = before;
  }
  ~InterruptSignal()
  {
    if (this->Before)
    {
      std::signal(SIGINT, this->Before);
      if (Raised)
      {
        std::raise(SIGINT);
      }
    }
  }
  InterruptSignal(const InterruptSignal&) = delete;
  InterruptSignal& operator=(const InterruptSignal&) = delete;

  bool Arrived() const { return this->Before && Raised; }

private:
  using Handler = void (*)(int);
  static void Handle(int) { Raised = 1; }

  static inline volatile std::sig_atomic_t Raised = 0;
  Handler Before = nullptr;
};
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedFrame::RayTracedFrame(
  rtglyphs::RayTracedImages& images, rtglyphs::RayTracedProgress& progress, Listener listener)
  : Images(images)
  , Progress(progress)
  , To(std::move(listener))
{
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFrame::Start(const Kind& kind)
{
  this->Own = kind;
  this->All.clear();
  this->Images.StartFrame(kind.Capture);
}

//----------------------------------------------------------------------------
const rtglyphs::RayTracedFrame::Drawn* rtglyphs::RayTracedFrame::Trace(int pass,
  const rtglyphs::RayTracedImageSettings& settings, vtkRenderer* renderer, vtkOpenGLRenderWindow* window,
  std::uint32_t width, std::uint32_t height)
{
  // A camera that sees nothing is no failure of the glyphs: the next one may be good.
  rtg::ImageView view;
  try
  {
    view = rtglyphs::RayTracedImageRequest::ViewOf(settings, renderer, static_cast<rtg::Pass>(pass), width, height,
      pass == this->Own.GroundPass ? this->Own.Shown : vtkBoundingBox(), this->Environment);
    this->BlindFor.clear();
  }
  catch (const rtg::Error& error)
  {
    if (std::exchange(this->BlindFor, error.what()) != error.what())
    {
      this->To.Blind(error.what());
    }
    return nullptr;
  }
  view.sceneVersion = this->Own.Content;
  const rtg::ImageEffort effort = rtglyphs::RayTracedImageRequest::EffortOf(settings, this->Own);
  // Ranks that all have everything trace a part each, and compositing joins these.
  if (this->Own.Collective && settings.IsReplicated() && !effort.preview && !effort.features &&
    !rtg::Denoises(view, effort))
  {
    view.settings.part = static_cast<std::uint32_t>(rtglyphs::RayTracedRanks::Own());
    view.settings.parts = static_cast<std::uint32_t>(rtglyphs::RayTracedRanks::Count());
  }

  rtglyphs::RayTracedImages::Place place;
  place.Pass = pass;
  place.Width = view.settings.width;
  place.Height = view.settings.height;
  place.Eye = renderer->GetActiveCamera()->GetLeftEye();
  window->GetTileViewport(place.Tile.data());
  rtglyphs::RayTracedImages::Entry& entry = this->Images.Get(place);
  view = rtg::Settled(std::move(view), entry.Image.View());
  const auto drawn = std::find_if(this->All.begin(), this->All.end(), [&](const auto& d) { return d.Place == place; });
  if (drawn != this->All.end() && entry.Image.View() == view)
  {
    return &*drawn;
  }

  // The user may have moved the camera to see more.
  const bool stays = this->IsStopped() && entry.Image.View() == view;
  this->Stopped = this->Own.Capture ? this->Stopped : stays;
  const bool growing = entry.Image.GetState() == rtg::ProgressiveImage::State::Growing;
  // The user may stop it; ParaView's progress bar shows its progress.
  const InterruptSignal signal;
  this->Progress.Start();
  const rtg::Interrupt interrupt = [&](double share)
  {
    this->Progress.Report(rtglyphs::RayTracedFrameStatus::NameOfStep(entry.Image.IsCompiling()), share);
    return window->CheckAbortStatus() != 0 || signal.Arrived();
  };
  // The progress callback may switch the OpenGL context: Qt makes its own current, and binds framebuffers of widgets in
  // ours.
  rtglyphs::RayTracedOpenGLState::Save(window);
  const rtg::Image* image =
    stays && growing ? &entry.Image.GetImage() : this->Images.Update(entry, view, effort, interrupt);
  rtglyphs::RayTracedOpenGLState::Restore(window);
  this->All.push_back(
    { place, &entry, image, glm::dot(view.camera.eye - view.camera.position, glm::dvec3(view.camera.forward)) });
  this->To.Traced(this->All.back());
  return &this->All.back();
}
