#include "vtkRayTracedScene.h"

#include "RayTracedContent.h"
#include "RayTracedEdges.h"
#include "RayTracedFXAA.h"
#include "RayTracedFeatureImage.h"
#include "RayTracedFrameStatus.h"
#include "RayTracedImageRequest.h"
#include "RayTracedOpenGL.h"
#include "RayTracedPicker.h"
#include "RayTracedProgress.h"
#include "RayTracedPythonClass.h"
#include "RayTracedRendererState.h"
#include "RayTracedSignal.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedMapper.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <vector>

vtkInformationKeyMacro(vtkRayTracedScene, SCENE, ObjectBase);
vtkStandardNewMacro(vtkRayTracedScene);

namespace
{
// Above this, in frames a second, a window asks for speed: ParaView renders interactively at 5, at rest at 0.002.
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
struct vtkRayTracedScene::Drawn
{
  rtglyphs::RayTracedImages::Place Place;
  rtglyphs::RayTracedImages::Entry* Entry;
  const rtg::Image* Image; // null: it failed
  double EyeDepth;
};

//----------------------------------------------------------------------------
struct vtkRayTracedScene::Internals
{
  vtkNew<vtkRayTracedImageActor> Actor;
  vtkNew<vtkCallbackCommand> MapperEvents;
  rtglyphs::RayTracedContent Content;
  rtglyphs::RayTracedImageSettings Settings;
  bool Capture = false, Collective = false, Ordered = false, Stopped = false;
  std::string FeatureFile;
  rtglyphs::RayTracedPicker Picker;
  rtglyphs::RayTracedFXAA FXAA;
  rtglyphs::RayTracedRendererState::Environment Environment;

  std::vector<Drawn> Frame; // its images
  bool Interactive = false;
  rtglyphs::RayTracedFrameStatus Status; // of the last frame

  std::string Reported, CameraReported; // the last failures, until there is an image again
  bool PassReported = false, GroundReported = false, ExportReported = false, CutReported = false;
  rtglyphs::RayTracedProgress Progress;

  rtglyphs::RayTracedEdges Edges;

  vtkMultiProcessController* OtherRanks() const;
  // Of what the ground lies below, in the image that shows it. Of several ranks' pictures compositing takes no more
  // than what lies before the bounds of their data.
  vtkBoundingBox GroundBounds(int pass) const
  {
    const bool first = pass == opaque || !this->Content.Displays.Shows(opaque);
    return first && !this->OtherRanks() ? this->Content.Displays.ComputeShownBounds() : vtkBoundingBox();
  }
  bool HasBothPasses() const
  {
    return this->Content.Displays.Shows(opaque) && this->Content.Displays.Shows(translucent);
  }
};

//----------------------------------------------------------------------------
vtkRayTracedScene::vtkRayTracedScene()
  : Self(std::make_unique<Internals>())
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
  this->Self->Content.Sorting = [this](double share) { this->Self->Progress.Tell("Sorting Glyphs", share); };
}

//----------------------------------------------------------------------------
vtkRayTracedScene::~vtkRayTracedScene()
{
  for (const rtglyphs::RayTracedDisplays::Display& display : this->Self->Content.Displays.GetAll())
  {
    display.Mapper->RemoveObserver(this->Self->MapperEvents);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << endl;
  os << indent << "Number of displays: " << this->Self->Content.Displays.GetAll().size() << endl;
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
    renderer->AddObserver(vtkCommand::StartEvent, scene, &vtkRayTracedScene::TakeSmoothing, 1.0f);
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
  this->Self->Content.Displays.Add(actor, mapper);
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
  self.Content.Displays.Remove(mapper, self.Content.Images);
  if (self.Content.Displays.GetAll().empty())
  {
    self.Content.Images.DropImages();
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
    this->Self->Stopped = false;
  }
}

//----------------------------------------------------------------------------
const rtglyphs::RayTracedImageSettings& vtkRayTracedScene::GetSettings() const
{
  return this->Self->Settings;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetStatistics(vtkRayTracedMapper* mapper, const rtglyphs::RayTracedDataStatistics& statistics)
{
  this->Self->Content.Displays.SetStatistics(mapper, statistics);
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetFrameKind(bool capture, bool collective, bool ordered)
{
  this->Self->Capture = capture;
  this->Self->Collective = collective;
  this->Self->Ordered = ordered;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SaveFeatureImage(const std::string& fileName)
{
  this->Self->FeatureFile = fileName;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Stop()
{
  this->Self->Stopped = true;
  this->Self->Status.Finish();
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Report(const std::string& message)
{
  this->Report(message, message);
}

//----------------------------------------------------------------------------
// `what` says whether it is the same as before.
void vtkRayTracedScene::Report(const std::string& message, const std::string& what)
{
  if (this->Self->Reported != what)
  {
    this->Self->Reported = what;
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
void vtkRayTracedScene::TakeSmoothing()
{
  if (this->Self->Content.Displays.AnyVisible() && !HasForeignPass(this->Renderer))
  {
    this->Self->FXAA.Take(this->Renderer);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::StartFrame()
{
  Internals& self = *this->Self;
  self.Frame.clear();
  self.Content.Images.StartFrame(self.Capture);
  self.ExportReported = false;
  self.CutReported &= self.Capture; // a picture may be captured in parts
  // On all ranks alike, whether or not they have something to draw.
  self.Interactive = this->Renderer->GetRenderWindow()->GetDesiredUpdateRate() >= interactiveRate && !self.Capture;
  if (self.Content.Displays.GetAll().empty())
  {
    return;
  }
  self.Progress.StartFrame(this->Renderer->GetRenderWindow());
  vtkPropCollection* props = this->Renderer->GetViewProps();
  if (props->GetLastProp() != self.Actor)
  {
    props->RemoveItem(self.Actor);
    props->AddItem(self.Actor);
  }
  if (self.Content.Update(this->Renderer, self.Settings, self.OtherRanks(),
        [this](const std::string& message) { this->Report(message); }))
  {
    self.Stopped = false;
  }
  if (!self.Content.Displays.ShowsAnything())
  {
    // Nothing is shown: device memory goes back, but for compiled programs.
    self.Content.Images.DropImages();
  }
  const bool other = HasForeignPass(this->Renderer);
  if (other && self.Content.Displays.ShowsAnything() && !self.PassReported)
  {
    vtkWarningMacro(<< "Ray-traced glyphs and surfaces are left out while the view's "
                       "EnableRayTracing is on. Switch it "
                       "off, or choose another representation such as 3D Glyphs.");
  }
  self.PassReported = other;
  const bool cannot = self.Settings.GroundShadow != rtglyphs::RayTracedImageSettings::NoGround && self.OtherRanks();
  if (cannot && !self.GroundReported)
  {
    vtkWarningMacro(<< "GroundShadow is left out: several ranks render. Set it to None, or render on one.");
  }
  self.GroundReported = cannot;
  this->ExchangeEdges();
}

//----------------------------------------------------------------------------
// Those that render this frame together with this one; null: there are none.
vtkMultiProcessController* vtkRayTracedScene::Internals::OtherRanks() const
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return this->Collective && controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::HasPass(int pass) const
{
  return this->Self->Content.Displays.Shows(pass);
}

//----------------------------------------------------------------------------
// The image of a pass for a viewport of that size, which is traced once in a frame. Null: the camera sees nothing.
const vtkRayTracedScene::Drawn*
vtkRayTracedScene::TraceImage(int pass, vtkOpenGLRenderWindow* window, std::uint32_t width, std::uint32_t height)
{
  Internals& self = *this->Self;
  // A camera that sees nothing is no failure of the glyphs: the next one may be good.
  rtg::ImageView view;
  try
  {
    view = rtglyphs::RayTracedImageRequest::ViewOf(self.Settings, this->Renderer, static_cast<rtg::Pass>(pass), width,
      height, self.GroundBounds(pass), self.Environment);
    self.CameraReported.clear();
  }
  catch (const rtg::Error& error)
  {
    if (self.CameraReported != error.what())
    {
      self.CameraReported = error.what();
      vtkWarningMacro(<< error.what());
    }
    return nullptr;
  }
  view.content = self.Content.GetNumber();
  const bool capture = self.Capture;
  rtglyphs::RayTracedImageRequest::Frame frame;
  frame.Capture = capture;
  frame.Interactive = self.Interactive;
  frame.Features = !self.FeatureFile.empty() && !self.Interactive;
  frame.Images = (self.HasBothPasses() ? 2 : 1) * (window->GetStereoRender() ? 2 : 1);
  const rtg::ImageEffort effort = rtglyphs::RayTracedImageRequest::EffortOf(self.Settings, frame);
  // Ranks that all have everything trace a share each, and compositing puts these together.
  vtkMultiProcessController* ranks = self.OtherRanks();
  if (ranks && self.Settings.IsReplicated() && !effort.preview && !effort.features && !rtg::Denoises(view, effort))
  {
    view.settings.share = static_cast<std::uint32_t>(ranks->GetLocalProcessId());
    view.settings.shares = static_cast<std::uint32_t>(ranks->GetNumberOfProcesses());
  }

  rtglyphs::RayTracedImages::Place place;
  place.Pass = pass;
  place.Width = view.settings.width;
  place.Height = view.settings.height;
  place.Eye = this->Renderer->GetActiveCamera()->GetLeftEye();
  window->GetTileViewport(place.Tile.data());
  rtglyphs::RayTracedImages::Entry& entry = self.Content.Images.Get(place);
  const auto drawn =
    std::find_if(self.Frame.begin(), self.Frame.end(), [&](const auto& d) { return d.Place == place; });
  if (drawn != self.Frame.end() && entry.Image.View() == view)
  {
    return &*drawn;
  }

  // Another camera, for example, is asked for because somebody wants to see more.
  const bool stays = self.Stopped && !capture && entry.Image.View() == view;
  self.Stopped = capture ? self.Stopped : stays;
  const bool growing = entry.Image.GetState() == rtg::ProgressiveImage::State::Growing;
  // Somebody may not want it any more; and ParaView's progress bar wants to know.
  rtglyphs::RayTracedSignal signal;
  self.Progress.Start();
  const rtg::Interrupt interrupt = [&](double share)
  {
    self.Progress.Tell(rtglyphs::RayTracedFrameStatus::NameOfStep(entry.Image.IsCompiling()), share);
    return window->CheckAbortStatus() != 0 || signal.Arrived();
  };
  // Whoever is told or asked may paint meanwhile: Qt makes its own OpenGL context current, and binds framebuffers of
  // widgets in ours.
  window->GetState()->Push();
  const rtg::Image* image =
    stays && growing ? &entry.Image.GetImage() : self.Content.Trace(entry, view, effort, interrupt, this->Renderer);
  window->MakeCurrent();
  window->GetState()->Pop();
  self.Frame.push_back(
    { place, &entry, image, glm::dot(view.camera.eye - view.camera.position, glm::dvec3(view.camera.forward)) });
  if (!image)
  {
    this->ReportFailure(entry.Image);
    return &self.Frame.back();
  }
  self.Reported.clear();
  if (capture && entry.Image.GetState() == rtg::ProgressiveImage::State::Growing && !self.CutReported)
  {
    self.CutReported = true;
    vtkWarningMacro(<< "Tracing was stopped: the picture that is saved has " << entry.Image.Samples() << " of "
                    << effort.samples << " samples a pixel. Save it again to have them all.");
  }
  return &self.Frame.back();
}

//----------------------------------------------------------------------------
// What other ranks show behind the smooth edges of this one. Before anything is drawn, because compositing makes only
// those ranks draw that have something within the view.
void vtkRayTracedScene::ExchangeEdges()
{
  Internals& self = *this->Self;
  vtkMultiProcessController* ranks = self.OtherRanks();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  // Ordered compositing blends what ranks draw, in the order in which they lie.
  if (!ranks || !window || self.Ordered || self.PassReported || this->Renderer->GetSelector() ||
    self.Settings.IsReplicated() || self.Settings.SamplesPerPixel < 2)
  {
    self.Edges.Clear();
    return;
  }
  const Drawn* drawn = nullptr;
  if (self.Content.Displays.Shows(opaque))
  {
    window->MakeCurrent();
    this->Renderer->UpdateLightsGeometryToFollowCamera();
    int size[2], corner[2];
    this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
    drawn = this->TraceImage(opaque, window, static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]));
  }
  const bool whole = drawn && drawn->Image && drawn->Entry->Image.IsComplete();
  const std::string problem =
    self.Edges.Exchange(ranks, whole ? drawn->Image : nullptr, whole ? drawn->Entry->Image.Version() : 0);
  if (!problem.empty())
  {
    this->Report("Ray Traced Glyphs: smooth edges in front of other ranks' glyphs are mixed with the background (" +
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
    return this->TraceImage(
      of, window, static_cast<std::uint32_t>(viewport[2]), static_cast<std::uint32_t>(viewport[3]));
  };
  const auto waits = [&](int of)
  {
    const Drawn* traced = this->HasPass(of) ? trace(of) : nullptr;
    return traced && traced->Image && !traced->Entry->Image.HasPicture();
  };
  const bool waiting = waits(opaque) || waits(translucent);
  const Drawn* drawn = trace(pass);
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
    self.Content.Images.Send(
      entry, *image, rtglyphs::RayTracedImageRequest::EffectsOf(self.Settings, entry.Image.View(), *image), window);
    entry.Quad.SetCamera(worldToClip);
    self.Content.Images.Draw(entry, /*again=*/false, this->Renderer, imageActor, mapper);
    return;
  }
  // While a program is compiled there is nothing to see of the image that needs it. The last frame stays, which may
  // show what is no longer so; but not from another camera, beside what ParaView draws, nor in files.
  const auto last = self.Content.Images.GetLast(drawn->Place);
  for (int of : { opaque, translucent })
  {
    if (last[of] && !self.Capture && (of == pass || !this->HasPass(of)) && last[of]->Quad.MoveTo(worldToClip))
    {
      self.Content.Images.Draw(*last[of], /*again=*/true, this->Renderer, imageActor, mapper);
    }
  }
}

//----------------------------------------------------------------------------
// A rank's own part of the picture has edges that the whole has not.
void vtkRayTracedScene::SmoothFrame()
{
  Internals& self = *this->Self;
  if (self.OtherRanks())
  {
    return;
  }
  self.FXAA.Apply(
    this->Renderer, [this, &self](vtkTextureObject* pixels) { self.Content.Images.DrawKept(this->Renderer, pixels); });
}

//----------------------------------------------------------------------------
// How far the frame is: the least of its images, over all ranks. Where nothing was drawn nothing is to be done.
void vtkRayTracedScene::EndFrame()
{
  Internals& self = *this->Self;
  self.Progress.EndFrame();
  self.FXAA.GiveBack(this->Renderer);
  if (self.Content.Displays.GetAll().empty() || this->Renderer->GetSelector())
  {
    return;
  }
  rtglyphs::RayTracedFrameStatus::Frame frame;
  frame.Samples = self.Settings.SamplesPerPixel;
  frame.Stereo = this->Renderer->GetRenderWindow()->GetStereoRender() != 0;
  frame.Eye = this->Renderer->GetActiveCamera()->GetLeftEye() != 0;
  bool finished = true;
  for (const Drawn& drawn : self.Frame)
  {
    using State = rtg::ProgressiveImage::State;
    const rtg::ProgressiveImage& image = drawn.Entry->Image;
    const State state = image.GetState();
    frame.Compiling |= state == State::Growing && image.IsCompiling();
    frame.Progress = self.Stopped && !self.Capture ? 1.0 : std::min(frame.Progress, image.Progress());
    frame.Samples = std::min(frame.Samples, state == State::Failed ? 0.0 : double(image.Samples()));
    finished &= state == State::Finished;
  }
  vtkMultiProcessController* ranks = self.OtherRanks();
  self.Status.SetFrame(frame, self.Interactive ? nullptr : ranks);
  if (!ranks)
  {
    self.Status.ForgetSums();
  }
  else if (!self.Interactive)
  {
    self.Status.SumNumbers(ranks, self.Content);
  }

  if (!self.FeatureFile.empty() && finished && !self.Frame.empty() && self.Content.Images.GetScene())
  {
    std::vector<const rtg::Image*> images;
    for (const Drawn& drawn : self.Frame)
    {
      images.push_back(&drawn.Entry->Image.GetImage());
    }
    const std::string problem = rtglyphs::RayTracedFeatureImage::Write(self.FeatureFile, images,
      *self.Content.Images.GetScene(), self.Content.Displays.GetShownMappers(), self.Frame.front().EyeDepth);
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
  return rtglyphs::RayTracedPicker::PlaceAt(this->Self->Content, this->Renderer, x, y, place,
    [this](const rtg::ProgressiveImage& image) { this->ReportFailure(image); });
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::DrawIds(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  this->Self->Picker.DrawIds(this->Self->Content, this->Renderer, actor, mapper,
    [this](const rtg::ProgressiveImage& image) { this->ReportFailure(image); });
}

//----------------------------------------------------------------------------
std::vector<vtkRayTracedScene::Shown> vtkRayTracedScene::CopyShown()
{
  std::vector<Shown> all;
  std::vector<rtg::GlyphInstances> built;
  const rtglyphs::RayTracedDisplays& displays = this->Self->Content.Displays;
  for (const rtglyphs::RayTracedNeighbors::Shown& shown : displays.GetShown(this->Self->Content.Images, built))
  {
    all.push_back({ *shown.Instances, *shown.Colors, displays.GetAll()[shown.Display].Material });
  }
  return all;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ReportExport()
{
  Internals& self = *this->Self;
  rtglyphs::RayTracedPythonClass::Register();
  const bool selecting =
    this->Renderer->GetSelector() != nullptr; // VTK 9.6's selector asks actors for their mappers, too
  if (self.Content.Displays.ShowsAnything() && !selecting && !self.PassReported && !self.ExportReported)
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
  this->Self->Content.Images.ReleaseGraphicsResources(window);
  this->Self->Picker.ReleaseGraphicsResources(window);
  this->Self->Edges.ReleaseGraphicsResources(window);
  this->Self->FXAA.ReleaseGraphicsResources();
}

//----------------------------------------------------------------------------
std::string vtkRayTracedScene::GetStatistics()
{
  return this->Self->Status.GetStatistics(this->Self->Content);
}
