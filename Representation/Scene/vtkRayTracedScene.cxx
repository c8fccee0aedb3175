#include "vtkRayTracedScene.h"

#include "RayTracedDisplays.h"
#include "RayTracedEdges.h"
#include "RayTracedFXAA.h"
#include "RayTracedFeatureImage.h"
#include "RayTracedFrame.h"
#include "RayTracedFrameStatus.h"
#include "RayTracedImages.h"
#include "RayTracedOpenGL.h"
#include "RayTracedPicker.h"
#include "RayTracedPoints.h"
#include "RayTracedProgress.h"
#include "RayTracedRanks.h"
#include "RayTracedRendererState.h"
#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedMapper.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>
#include <vector>

vtkInformationKeyMacro(vtkRayTracedScene, SCENE, ObjectBase);
vtkStandardNewMacro(vtkRayTracedScene);

namespace
{
// Above this, in frames per second, a render is interactive: ParaView renders interactively at 5, at rest at 0.002.
constexpr double interactiveRate = 1.0;

constexpr int opaque = static_cast<int>(rtg::Pass::Opaque);
constexpr int translucent = static_cast<int>(rtg::Pass::Translucent);

// Another ray tracer draws all of the view.
bool HasForeignPass(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  return pass && pass->IsA("vtkOSPRayPass");
}
}

//----------------------------------------------------------------------------
struct vtkRayTracedScene::Internals
{
  explicit Internals(vtkRayTracedScene& scene)
    : Images(
        [&](rtg::Scene& kernels, std::uint64_t number)
        {
          this->Displays.Commit(kernels, number, scene.Renderer);
          kernels.Commit([this](double share) { this->Progress.Report("Sorting Glyphs", share); });
        })
    , Frame(this->Images, this->Progress,
        { [&](const rtglyphs::RayTracedFrame::Drawn& drawn)
          { scene.CheckImage(drawn.Entry->Image, drawn.Image == nullptr); },
          [&](const std::string& why) { vtkWarningWithObjectMacro(&scene, << why); } })
  {
  }

  vtkNew<vtkRayTracedImageActor> Actor;
  vtkNew<vtkCallbackCommand> MapperEvents;
  rtglyphs::RayTracedDisplays Displays;
  rtglyphs::RayTracedImages Images;
  rtglyphs::RayTracedImageSettings Settings;
  bool Capture = false, Collective = false, Ordered = false; // of the next frames
  bool ExpectsAnother = false;                               // after the next one
  std::string FeatureFile;
  rtglyphs::RayTracedPicker Picker;
  rtglyphs::RayTracedFXAA FXAA;
  rtglyphs::RayTracedProgress Progress;
  rtglyphs::RayTracedFrame Frame;
  rtglyphs::RayTracedFrameStatus Status; // of the last frame
  rtglyphs::RayTracedEdges Edges;
  rtglyphs::RayTracedPoints Points;

  std::string Reported; // the last failure, until there is an image again
  bool PassReported = false, GroundReported = false, ExportReported = false, CutReported = false;

  bool HasOtherRanks() const { return this->Collective && rtglyphs::RayTracedRanks::Count() > 1; }
};

//----------------------------------------------------------------------------
vtkRayTracedScene::vtkRayTracedScene()
  : Self(std::make_unique<Internals>(*this))
{
  this->Self->Actor->SetScene(this);
  this->Self->MapperEvents->SetClientData(this);
  this->Self->MapperEvents->SetCallback(
    [](vtkObject* caller, unsigned long event, void* self, void* actor)
    {
      auto* scene = static_cast<vtkRayTracedScene*>(self);
      auto* mapper = static_cast<vtkRayTracedMapper*>(caller);
      event == vtkCommand::DeleteEvent ? scene->Remove(mapper) : scene->DrawIds(static_cast<vtkActor*>(actor), mapper);
    });
}

//----------------------------------------------------------------------------
vtkRayTracedScene::~vtkRayTracedScene()
{
  for (const rtglyphs::RayTracedDisplays::Display& display : this->Self->Displays.GetAll())
  {
    display.Mapper->RemoveObserver(this->Self->MapperEvents);
  }
}

//----------------------------------------------------------------------------
vtkRayTracedScene* vtkRayTracedScene::Of(vtkRenderer* renderer)
{
  vtkRayTracedScene* scene = Find(renderer);
  if (!scene)
  {
    auto made = vtkSmartPointer<vtkRayTracedScene>::Take(vtkRayTracedScene::New());
    scene = made;
    renderer->GetInformation()->Set(SCENE(), scene);
    scene->Renderer = renderer;
    // Before ParaView's own observers: those put pictures of several processes together, and smooth the whole.
    renderer->AddObserver(vtkCommand::StartEvent, scene, &vtkRayTracedScene::DisableFXAA, 1.0f);
    renderer->AddObserver(vtkCommand::StartEvent, scene, &vtkRayTracedScene::StartFrame);
    renderer->AddObserver(vtkCommand::EndEvent, scene, &vtkRayTracedScene::EndFrame);
  }
  return scene;
}

//----------------------------------------------------------------------------
vtkRayTracedScene* vtkRayTracedScene::Find(vtkRenderer* renderer)
{
  return vtkRayTracedScene::SafeDownCast(renderer->GetInformation()->Get(SCENE()));
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Add(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  this->Self->Displays.Add(actor, mapper);
  mapper->RemoveObserver(this->Self->MapperEvents); // added again
  mapper->AddObserver(vtkCommand::RenderEvent, this->Self->MapperEvents);
  mapper->AddObserver(vtkCommand::DeleteEvent, this->Self->MapperEvents);
  if (this->Renderer && !this->Renderer->HasViewProp(this->Self->Actor))
  {
    this->Renderer->AddActor(this->Self->Actor);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Remove(vtkRayTracedMapper* mapper)
{
  Internals& self = *this->Self;
  mapper->RemoveObserver(self.MapperEvents);
  self.Displays.Remove(mapper, self.Images);
  if (self.Displays.GetAll().empty())
  {
    self.Images.DropImages();
    if (this->Renderer)
    {
      this->Renderer->RemoveActor(self.Actor);
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetSettings(const rtglyphs::RayTracedImageSettings& settings)
{
  if (!(this->Self->Settings == settings))
  {
    this->Self->Settings = settings;
    this->Self->Frame.SetStopped(false);
  }
}

//----------------------------------------------------------------------------
const rtglyphs::RayTracedImageSettings& vtkRayTracedScene::GetSettings() const
{
  return this->Self->Settings;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetFrameKind(bool capture, bool collective, bool ordered)
{
  this->Self->Capture = capture;
  this->Self->Collective = collective;
  this->Self->Ordered = ordered;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ExpectAnother()
{
  this->Self->ExpectsAnother = true;
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::HasPicture() const
{
  const std::vector<rtglyphs::RayTracedFrame::Drawn>& all = this->Self->Frame.GetAll();
  return std::none_of(all.begin(), all.end(),
    [](const auto& drawn)
    {
      const rtg::ProgressiveImage& image = drawn.Entry->Image;
      return image.GetState() == rtg::ProgressiveImage::State::Growing && !image.HasPicture();
    });
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SaveFeatureImage(const std::string& fileName)
{
  this->Self->FeatureFile = fileName;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Stop()
{
  this->Self->Frame.SetStopped(true);
  this->Self->Status.Finish();
}

//----------------------------------------------------------------------------
// A message about the same `what`, which is its text unless it is given, as the last one is not repeated.
void vtkRayTracedScene::Report(const std::string& message, std::string what)
{
  what = what.empty() ? message : what;
  if (std::exchange(this->Self->Reported, what) != what)
  {
    vtkErrorMacro(<< message);
  }
}

//----------------------------------------------------------------------------
// A device that is lost twice in a row may be lost at another place.
void vtkRayTracedScene::ReportFailure(const rtg::ProgressiveImage& image)
{
  const rtg::ProgressiveImage::Failure& failure = image.GetFailure();
  this->Report(failure.message, failure.cause == rtg::ProgressiveImage::Cause::Device ? "device" : failure.message);
}

//----------------------------------------------------------------------------
// A client whose server renders has displays without data.
void vtkRayTracedScene::DisableFXAA()
{
  if (this->Self->Displays.AnyVisible() && !HasForeignPass(this->Renderer))
  {
    this->Self->FXAA.Disable(this->Renderer);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::StartFrame()
{
  Internals& self = *this->Self;
  self.ExportReported = false;
  self.CutReported &= self.Capture; // a picture may be captured in parts
  // On all ranks alike, whether or not they have something to draw.
  vtkRenderWindow* window = this->Renderer->GetRenderWindow();
  rtglyphs::RayTracedFrame::Kind kind;
  kind.Capture = self.Capture;
  kind.Interactive = window->GetDesiredUpdateRate() >= interactiveRate && !self.Capture;
  kind.Features = !self.FeatureFile.empty() && !kind.Interactive;
  kind.Collective = self.HasOtherRanks();
  if (self.Displays.GetAll().empty())
  {
    self.Frame.Start(kind);
    return;
  }
  self.Progress.StartFrame(window);
  vtkPropCollection* props = this->Renderer->GetViewProps();
  if (props->GetLastProp() != self.Actor)
  {
    props->RemoveItem(self.Actor);
    props->AddItem(self.Actor);
  }
  if (self.Displays.Update(this->Renderer, self.Settings, kind.Collective, self.Images,
        [this](const std::string& message) { this->Report(message); }))
  {
    self.Frame.SetStopped(false);
  }
  kind.Content = self.Displays.GetVersion();
  kind.Images =
    (self.Displays.Shows(opaque) && self.Displays.Shows(translucent) ? 2 : 1) * (window->GetStereoRender() ? 2 : 1);
  const bool ground = self.Settings.GroundShadow != rtglyphs::RayTracedImageSettings::NoGround;
  if (ground && !kind.Collective)
  {
    // Compositing of several ranks' pictures leaves out what lies behind the bounds of their data.
    kind.GroundPass = self.Displays.Shows(opaque) ? opaque : translucent;
    kind.Shown = self.Displays.ComputeShownBounds();
  }
  self.Frame.Start(kind);
  if (!self.Displays.ShowsAnything())
  {
    // Nothing is shown: device memory goes back, but for compiled programs.
    self.Images.DropImages();
  }
  const bool other = HasForeignPass(this->Renderer);
  if (other && self.Displays.ShowsAnything() && !self.PassReported)
  {
    vtkWarningMacro(<< "Ray-traced glyphs and surfaces are left out while the view's EnableRayTracing is on. Switch it "
                       "off, or choose another representation such as 3D Glyphs.");
  }
  self.PassReported = other;
  const bool cannot = ground && kind.Collective;
  if (cannot && !self.GroundReported)
  {
    vtkWarningMacro(<< "GroundShadow is left out: several ranks render. Set it to None, or render on one.");
  }
  self.GroundReported = cannot;
  this->ExchangeEdges();
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::HasPass(int pass) const
{
  return this->Self->Displays.Shows(pass);
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::CheckImage(const rtg::ProgressiveImage& image, bool failed)
{
  Internals& self = *this->Self;
  if (failed)
  {
    this->ReportFailure(image);
    return;
  }
  self.Reported.clear();
  if (self.Capture && image.GetState() == rtg::ProgressiveImage::State::Growing && !self.CutReported)
  {
    self.CutReported = true;
    vtkWarningMacro(<< "Tracing was stopped: the picture that is saved has " << image.Samples() << " of "
                    << self.Settings.SamplesPerPixel << " samples per pixel. Save it again to have them all.");
  }
}

//----------------------------------------------------------------------------
// Colors of other ranks behind the anti-aliased edges of this one. Before anything is drawn, because compositing makes
// only those ranks draw that have something within the view.
void vtkRayTracedScene::ExchangeEdges()
{
  Internals& self = *this->Self;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  // Ordered compositing blends what ranks draw, in the order in which they lie.
  if (!self.HasOtherRanks() || !window || self.Ordered || self.PassReported || this->Renderer->GetSelector() ||
    self.Settings.IsReplicated() || self.Settings.SamplesPerPixel < 2)
  {
    self.Edges.Clear();
    return;
  }
  const rtglyphs::RayTracedFrame::Drawn* drawn = nullptr;
  if (self.Displays.Shows(opaque))
  {
    window->MakeCurrent();
    this->Renderer->UpdateLightsGeometryToFollowCamera();
    int size[2], corner[2];
    this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
    drawn = self.Frame.Trace(opaque, self.Settings, this->Renderer, window, static_cast<std::uint32_t>(size[0]),
      static_cast<std::uint32_t>(size[1]));
  }
  const bool whole = drawn && drawn->Image && drawn->Entry->Image.IsComplete();
  const std::string problem =
    self.Edges.Exchange(whole ? drawn->Image : nullptr, whole ? drawn->Entry->Image.Version() : 0);
  if (!problem.empty())
  {
    this->Report("Ray Traced Glyphs: anti-aliased edges show the background instead of other ranks' glyphs (" +
      problem + "). Make the picture smaller, or set ParallelLight to Replicated.");
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::DrawImage(int pass, vtkActor* imageActor, vtkMapper* mapper)
{
  Internals& self = *this->Self;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (!window || viewport[2] < 1 || viewport[3] < 1)
  {
    return;
  }

  const auto trace = [&](int of)
  {
    return self.Frame.Trace(of, self.Settings, this->Renderer, window, static_cast<std::uint32_t>(viewport[2]),
      static_cast<std::uint32_t>(viewport[3]));
  };
  const auto waits = [&](int of)
  {
    const rtglyphs::RayTracedFrame::Drawn* traced = this->HasPass(of) ? trace(of) : nullptr;
    return traced && traced->Image && !traced->Entry->Image.HasPicture();
  };
  const bool waiting = waits(opaque) || waits(translucent);
  const rtglyphs::RayTracedFrame::Drawn* drawn = trace(pass);
  const rtg::Image* image = drawn ? drawn->Image : nullptr;
  if (!image)
  {
    return;
  }
  const glm::dmat4 worldToClip = rtglyphs::RayTracedRendererState::WorldToClip(this->Renderer);
  if (!waiting)
  {
    rtglyphs::RayTracedImages::Entry& entry = *drawn->Entry;
    self.Edges.Draw(image, window, this->Renderer, imageActor, mapper);
    self.Images.Send(
      entry, *image, rtglyphs::RayTracedImageRequest::EffectsOf(self.Settings, entry.Image.View(), *image), window);
    entry.Quad.SetCamera(worldToClip);
    self.Images.Draw(entry, /*again=*/false, this->Renderer, imageActor, mapper);
    return;
  }
  // While a program is compiled there is nothing to see of the image that needs it. The last frame stays, which may
  // show what is no longer so; but not from another camera, beside what ParaView draws, nor in files. Else there are
  // points.
  bool again = self.Capture;
  const auto last = self.Images.GetLast(drawn->Place);
  for (int of : { opaque, translucent })
  {
    if (last[of] && !self.Capture && (of == pass || !this->HasPass(of)) && last[of]->Quad.MoveTo(worldToClip))
    {
      self.Images.Draw(*last[of], /*again=*/true, this->Renderer, imageActor, mapper);
      again = true;
    }
  }
  if (!again)
  {
    self.Points.Draw(self.Displays, self.Images, this->Renderer, imageActor);
  }
}

//----------------------------------------------------------------------------
// A rank's own part of the picture has edges that the whole has not. Without a GPU, smoothing takes longer than all
// else that OpenGL does for a frame: while an image is refined or the camera turned, the user would wait for it.
void vtkRayTracedScene::SmoothFrame()
{
  Internals& self = *this->Self;
  const std::vector<rtglyphs::RayTracedFrame::Drawn>& all = self.Frame.GetAll();
  const bool last = self.Frame.IsStopped() ||
    std::all_of(all.begin(), all.end(), [](const auto& drawn) { return drawn.Entry->Image.Progress() >= 1.0; });
  if (self.HasOtherRanks() || !last)
  {
    return;
  }
  self.FXAA.Apply(
    this->Renderer, [this, &self](vtkTextureObject* pixels) { self.Images.DrawKept(this->Renderer, pixels); });
}

//----------------------------------------------------------------------------
// How far the frame is: the least of its images, over all ranks. Where nothing was drawn nothing is to be done.
void vtkRayTracedScene::EndFrame()
{
  Internals& self = *this->Self;
  self.Progress.EndFrame();
  self.FXAA.Restore(this->Renderer);
  if (self.Displays.GetAll().empty() || this->Renderer->GetSelector())
  {
    return;
  }
  rtglyphs::RayTracedFrameStatus::Frame frame;
  frame.Samples = self.Settings.SamplesPerPixel;
  frame.Stereo = this->Renderer->GetRenderWindow()->GetStereoRender() != 0;
  frame.Eye = this->Renderer->GetActiveCamera()->GetLeftEye() != 0;
  bool finished = true;
  for (const rtglyphs::RayTracedFrame::Drawn& drawn : self.Frame.GetAll())
  {
    using State = rtg::ProgressiveImage::State;
    const rtg::ProgressiveImage& image = drawn.Entry->Image;
    const State state = image.GetState();
    frame.Compiling |= state == State::Growing && image.IsCompiling();
    frame.Progress = self.Frame.IsStopped() ? 1.0 : std::min(frame.Progress, image.Progress());
    frame.Samples = std::min(frame.Samples, state == State::Failed ? 0.0 : double(image.Samples()));
    finished &= state == State::Finished;
  }
  if (std::exchange(self.ExpectsAnother, false))
  {
    frame.Progress = frame.Samples = 0.0;
  }
  const bool interactive = self.Frame.GetKind().Interactive;
  self.Status.SetFrame(frame, self.HasOtherRanks() && !interactive);
  if (!self.HasOtherRanks())
  {
    self.Status.ForgetSums();
  }
  else if (!interactive)
  {
    self.Status.SumNumbers(self.Displays, self.Images);
  }

  const std::vector<rtglyphs::RayTracedFrame::Drawn>& all = self.Frame.GetAll();
  const bool kept =
    std::all_of(all.begin(), all.end(), [](const auto& drawn) { return drawn.Entry->Tracer != nullptr; });
  if (self.Frame.GetKind().Features && finished && kept && !all.empty() && self.Images.GetScene())
  {
    std::string problem;
    try
    {
      std::vector<std::pair<const rtg::Image*, rtg::ImageFeatures>> images;
      for (const rtglyphs::RayTracedFrame::Drawn& drawn : all)
      {
        images.emplace_back(&drawn.Entry->Image.GetImage(), drawn.Entry->Tracer->Features());
      }
      problem = rtglyphs::RayTracedFeatureImage::Write(
        self.FeatureFile, images, *self.Images.GetScene(), self.Displays.GetShownMappers(), all.front().EyeDepth);
    }
    catch (const std::exception& error) // the device may be lost, or memory run out
    {
      problem = error.what();
    }
    self.FeatureFile.clear();
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem);
    }
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::PlaceAt(int x, int y, double place[3])
{
  return rtglyphs::RayTracedPicker::PlaceAt(this->Self->Displays, this->Self->Images, this->Renderer, x, y, place,
    [this](const rtg::ProgressiveImage& image) { this->ReportFailure(image); });
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::DrawIds(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  this->Self->Picker.DrawIds(this->Self->Displays, this->Self->Images, this->Renderer, actor, mapper,
    [this](const rtg::ProgressiveImage& image) { this->ReportFailure(image); });
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ForEachShown(
  const std::function<void(const rtg::GlyphInstances&, const rtg::GlyphColors&, const rtg::Material&)>& visit)
{
  std::vector<rtg::GlyphInstances> built;
  const rtglyphs::RayTracedDisplays& displays = this->Self->Displays;
  for (const rtglyphs::RayTracedNeighbors::Shown& shown : displays.GetShown(this->Self->Images, built))
  {
    visit(*shown.Instances, *shown.Colors, displays.GetAll()[shown.Display].Material);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ReportExport()
{
  Internals& self = *this->Self;
  const bool selecting =
    this->Renderer->GetSelector() != nullptr; // VTK 9.6's selector asks actors for their mappers, too
  if (self.Displays.ShowsAnything() && !selecting && !self.PassReported && !self.ExportReported)
  {
    vtkWarningMacro(<< "Ray-traced glyphs and surfaces are left out of the exported file: they have no polygons. "
                       "Export the glyphs by themselves (Ray-traced glyphs, .usda or .glb), choose another "
                       "representation such as 3D Glyphs or Surface to export them here, or save a screenshot.");
    self.ExportReported = true;
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Self->Images.ReleaseGraphicsResources(window);
  this->Self->Picker.ReleaseGraphicsResources(window);
  this->Self->Edges.ReleaseGraphicsResources(window);
  this->Self->Points.ReleaseGraphicsResources(window);
  this->Self->FXAA.ReleaseGraphicsResources();
}

//----------------------------------------------------------------------------
std::string vtkRayTracedScene::GetStatistics()
{
  return this->Self->Status.GetStatistics(this->Self->Displays, this->Self->Images);
}
