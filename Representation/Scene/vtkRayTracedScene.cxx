#include "vtkRayTracedScene.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
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
#include "vtkRayTracedFXAA.h"
#include "vtkRayTracedFeatureImage.h"
#include "vtkRayTracedIdBuffer.h"
#include "vtkRayTracedImageRequest.h"
#include "vtkRayTracedImages.h"
#include "vtkRayTracedMapper.h"
#include "vtkRayTracedNeighbors.h"
#include "vtkRayTracedOpenGL.h"
#include "vtkRayTracedProgress.h"
#include "vtkRayTracedPythonClass.h"
#include "vtkRayTracedRendererState.h"
#include "vtkRayTracedSignal.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <map>
#include <new>
#include <vector>

vtkInformationKeyMacro(vtkRayTracedScene, SCENE, ObjectBase);
vtkStandardNewMacro(vtkRayTracedScene);

namespace
{
// Above this, in frames a second, a window asks for speed: ParaView renders interactively at 5, at rest at 0.002.
constexpr double interactiveRate = 1.0;

constexpr const char* compilingText = "Compiling Programs";
constexpr const char* tracingText = "Ray Tracing";

// In what is summed over all ranks; behind the view's numbers come two of each member.
enum Numbers
{
  DEVICE_BYTES,
  PRIMARY_RAYS,
  NEIGHBOR_GLYPHS,
  NEIGHBOR_BYTES,
  VIEW_NUMBERS
};
constexpr std::size_t memberNumbers = 2;

constexpr int opaque = static_cast<int>(rtg::Pass::Opaque);
constexpr int translucent = static_cast<int>(rtg::Pass::Translucent);
}

//----------------------------------------------------------------------------
struct vtkRayTracedScene::Internals
{
  // A mapper's glyph set, and what of it the kernels have.
  struct Member
  {
    vtkRayTracedMapper* Mapper = nullptr; // takes itself out before it goes
    vtkWeakPointer<vtkActor> Actor;
    std::uint64_t Scene = 0; // number of the kernels' scene that has the set; 0: none
    rtg::Scene::SetId Set = 0;
    std::uint64_t SentInstances = 0, SentColors = 0, SentMaterial = 0;
    rtg::Material Material;
    std::uint64_t MaterialVersion = 0;
    bool Shown = false;       // in this frame
    bool Translucent = false; // and then in the translucent pass
  };

  vtkNew<vtkRayTracedImageActor> Actor;
  std::vector<Member> Members; // in the order in which they were added
  Member* Find(const vtkRayTracedMapper* mapper);
  vtkRayTracedImageSettings Settings;
  bool Capture = false, Collective = false, Stopped = false;
  std::string FeatureFile;
  vtkRayTracedImages Images;
  vtkRayTracedImageQuad IdQuad;
  vtkRayTracedFXAA FXAA;
  vtkRayTracedRendererState::Environment Environment;

  // What can be seen: of each shown member the versions of instances, colors and material. Two frames with the same
  // list look the same; each new list has a number.
  std::vector<std::array<std::uint64_t, 3>> Content;
  std::uint64_t ContentNumber = 0, MaterialVersions = 0;

  // The images of this frame
  struct Drawn
  {
    vtkRayTracedImages::Entry* Entry;
    double EyeDepth;
  };
  std::vector<Drawn> Frame;
  bool Wants[vtkRayTracedImages::Passes] = { false, false };
  bool Interactive = false;

  // Of the last frame, on all ranks that rendered it together; of each eye its own.
  bool Compiling = false; // some image of the last frame
  double Done[2] = { 1.0, 1.0 };
  double Samples[2] = { 0.0, 0.0 };
  bool Stereo = false;
  int Eye = 0; // of the last frame

  std::string Reported, CameraReported; // the last failures, until there is an image again
  bool PassReported = false, ExportReported = false, CutReported = false;
  vtkRayTracedProgress Progress;

  vtkRayTracedNeighbors Neighbors;
  std::vector<std::array<std::uint64_t, 3>> SentContent; // what could be seen when neighbors were last asked for
  rtg::Material MaterialOf(const Member& member, vtkRenderer* renderer) const;
  std::vector<vtkRayTracedNeighbors::Shown> ShownHere(std::vector<rtg::GlyphInstances>& built);
  vtkMultiProcessController* OtherRanks() const;

  // What statistics sum over all ranks: the view's numbers, then glyphs and skipped glyphs of each member. Of the last
  // frame that ranks rendered together, or none.
  std::vector<double> OwnNumbers() const;
  void SumNumbers(vtkMultiProcessController* ranks);
  std::vector<double> SummedNumbers;

  void Commit(rtg::Scene& scene, vtkRenderer* renderer);
  bool HasBothPasses() const { return this->Wants[opaque] && this->Wants[translucent]; }
  bool WantsAnything() const { return this->Wants[opaque] || this->Wants[translucent]; }
};

//----------------------------------------------------------------------------
vtkRayTracedScene::Internals::Member* vtkRayTracedScene::Internals::Find(const vtkRayTracedMapper* mapper)
{
  const auto found = std::find_if(
    this->Members.begin(), this->Members.end(), [mapper](const Member& member) { return member.Mapper == mapper; });
  return found == this->Members.end() ? nullptr : &*found;
}

//----------------------------------------------------------------------------
vtkRayTracedScene::vtkRayTracedScene()
  : Self(std::make_unique<Internals>())
{
  this->Self->Actor->SetScene(this);
}

//----------------------------------------------------------------------------
vtkRayTracedScene::~vtkRayTracedScene()
{
  for (const Internals::Member& member : this->Self->Members)
  {
    member.Mapper->SetScene(nullptr);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << endl;
  os << indent << "Number of mappers: " << this->Self->Members.size() << endl;
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
  Internals::Member* member = this->Self->Find(mapper);
  if (!member)
  {
    member = &this->Self->Members.emplace_back();
    member->Mapper = mapper;
  }
  member->Actor = actor;
  mapper->SetScene(this);
  if (this->Renderer && !this->Renderer->HasViewProp(this->Self->Actor))
  {
    this->Renderer->AddActor(this->Self->Actor);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Remove(vtkRayTracedMapper* mapper)
{
  Internals& self = *this->Self;
  Internals::Member* found = self.Find(mapper);
  if (!found)
  {
    return;
  }
  rtg::Scene* scene = self.Images.GetScene();
  if (scene && found->Scene == self.Images.GetSceneNumber())
  {
    scene->Remove(found->Set);
  }
  self.Members.erase(self.Members.begin() + (found - self.Members.data()));
  if (self.Members.empty())
  {
    self.Images.DropImages();
    self.Wants[opaque] = self.Wants[translucent] = false;
    if (this->Renderer)
    {
      this->Renderer->RemoveActor(self.Actor);
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetSettings(const vtkRayTracedImageSettings& settings)
{
  if (!(this->Self->Settings == settings))
  {
    this->Self->Settings = settings;
    this->Self->Stopped = false;
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SetFrameKind(bool capture, bool collective)
{
  this->Self->Capture = capture;
  this->Self->Collective = collective;
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
  std::fill_n(this->Self->Done, 2, 1.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::Report(const std::string& message)
{
  if (this->Self->Reported != message)
  {
    this->Self->Reported = message;
    vtkErrorMacro(<< message);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::StartFrame()
{
  Internals& self = *this->Self;
  self.Frame.clear();
  self.Wants[opaque] = self.Wants[translucent] = false;
  self.ExportReported = false;
  self.CutReported &= self.Capture; // a picture may be captured in parts
  // On all ranks alike, whether or not they have something to draw.
  self.Interactive = this->Renderer->GetRenderWindow()->GetDesiredUpdateRate() >= interactiveRate && !self.Capture;
  if (self.Members.empty())
  {
    return;
  }
  vtkPropCollection* props = this->Renderer->GetViewProps();
  if (props->GetLastProp() != self.Actor)
  {
    props->RemoveItem(self.Actor);
    props->AddItem(self.Actor);
  }
  if (!this->UpdateMappers())
  {
    // Nothing is shown: device memory goes back, but for compiled programs.
    self.Images.DropImages();
  }
  vtkRenderPass* pass = this->Renderer->GetPass();
  const bool other = pass && pass->IsA("vtkOSPRayPass");
  if (other && self.WantsAnything() && !self.PassReported)
  {
    vtkWarningMacro(<< "Ray-traced glyphs and surfaces are left out while the view's "
                       "EnableRayTracing is on. Switch it "
                       "off, or choose another representation such as 3D Glyphs.");
  }
  self.PassReported = other;
  if (self.WantsAnything() && !other)
  {
    self.FXAA.Take(this->Renderer);
  }
}

//----------------------------------------------------------------------------
// Instances and colors of all visible members; false: nothing is to be seen.
bool vtkRayTracedScene::UpdateMappers()
{
  Internals& self = *this->Self;
  std::vector<std::array<std::uint64_t, 3>> content;
  for (Internals::Member& member : self.Members)
  {
    vtkRayTracedMapper* mapper = member.Mapper;
    member.Shown = false;
    vtkActor* actor = member.Actor;
    if (!actor || !actor->GetVisibility())
    {
      continue;
    }
    try
    {
      mapper->Update(actor);
    }
    catch (const std::bad_alloc&)
    {
      this->Report("Ray Traced Glyphs: the computer's memory does not suffice to make the glyphs "
                   "of these data. Show fewer "
                   "(GlyphMask, MaximumNumberOfGlyphs) or hide other data.");
      continue;
    }
    if (mapper->GetNumberOfGlyphs() == 0)
    {
      continue;
    }
    const rtg::Material material = self.MaterialOf(member, this->Renderer);
    if (member.MaterialVersion == 0 || !(member.Material == material))
    {
      member.Material = material;
      member.MaterialVersion = ++self.MaterialVersions;
    }
    member.Shown = true;
    member.Translucent = material.opacity < 1.0f || mapper->IsTranslucent();
    self.Wants[member.Translucent ? translucent : opaque] = true;
    content.push_back({ { mapper->GetInstanceVersion(), mapper->GetColorVersion(), member.MaterialVersion } });
  }
  const std::uint64_t neighbors = this->UpdateNeighbors(content);
  content.push_back({ { neighbors, 0, 0 } });
  if (content != self.Content)
  {
    self.Content = std::move(content);
    ++self.ContentNumber;
    self.Stopped = false;
  }
  return self.WantsAnything();
}

//----------------------------------------------------------------------------
// Those that render this frame together with this one; null: there are none.
vtkMultiProcessController* vtkRayTracedScene::Internals::OtherRanks() const
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return this->Collective && controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

//----------------------------------------------------------------------------
rtg::Material vtkRayTracedScene::Internals::MaterialOf(const Member& member, vtkRenderer* renderer) const
{
  rtg::Material material = vtkRayTracedRendererState::MaterialOf(member.Actor->GetProperty(), renderer);
  member.Mapper->AddToMaterial(material);
  return material;
}

//----------------------------------------------------------------------------
// Instances that the kernels have been handed are theirs; where they have been given back they are built again.
std::vector<vtkRayTracedNeighbors::Shown>
vtkRayTracedScene::Internals::ShownHere(std::vector<rtg::GlyphInstances>& built)
{
  std::vector<vtkRayTracedNeighbors::Shown> shown;
  built.reserve(this->Members.size());
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    const Member& member = this->Members[i];
    if (!member.Shown)
    {
      continue;
    }
    const rtg::GlyphInstances* instances = member.Mapper->GetInstances();
    rtg::Scene* scene = this->Images.GetScene();
    if (!instances && scene && member.Scene == this->Images.GetSceneNumber() &&
      member.SentInstances == member.Mapper->GetInstanceVersion())
    {
      instances = &scene->InstancesOf(member.Set);
    }
    if (!instances)
    {
      instances = &built.emplace_back(member.Mapper->TakeInstances(member.Actor));
    }
    shown.push_back({ static_cast<int>(i), instances, &member.Mapper->GetColors() });
  }
  return shown;
}

//----------------------------------------------------------------------------
// What other ranks have near this one's glyphs, where that is wanted. The number differs from that of anything else.
std::uint64_t vtkRayTracedScene::UpdateNeighbors(const std::vector<std::array<std::uint64_t, 3>>& content)
{
  Internals& self = *this->Self;
  const vtkRayTracedImageSettings& settings = self.Settings;
  vtkMultiProcessController* ranks = self.OtherRanks();
  if (!ranks || settings.ParallelLight != vtkRayTracedImageSettings::NeighborLight ||
    settings.ShadingMode == static_cast<int>(rtg::Shading::Local))
  {
    self.Neighbors.Clear();
    return self.Neighbors.GetVersion();
  }
  const bool bounded =
    settings.ShadingMode == static_cast<int>(rtg::Shading::AmbientOcclusion) && settings.AmbientOcclusionRadius > 0.0;
  std::vector<rtg::GlyphInstances> built;
  const std::string problem = self.Neighbors.Exchange(ranks, bounded ? settings.AmbientOcclusionRadius : HUGE_VAL,
    content != self.SentContent, static_cast<int>(self.Members.size()), [&] { return self.ShownHere(built); });
  self.SentContent = content;
  if (!problem.empty())
  {
    this->Report(problem);
  }
  return self.Neighbors.GetVersion();
}

//----------------------------------------------------------------------------
// What has changed since the kernels last had it.
void vtkRayTracedScene::Internals::Commit(rtg::Scene& scene, vtkRenderer* renderer)
{
  for (Member& member : this->Members)
  {
    vtkRayTracedMapper* mapper = member.Mapper;
    const bool known = member.Scene == this->Images.GetSceneNumber();
    if (!member.Shown)
    {
      if (known)
      {
        scene.Remove(member.Set);
        member.Scene = 0;
      }
      continue;
    }
    if (!known)
    {
      member.Set = scene.Add();
      member.Scene = this->Images.GetSceneNumber();
      member.SentInstances = member.SentColors = member.SentMaterial = 0;
    }
    if (member.SentInstances != mapper->GetInstanceVersion())
    {
      scene.SetInstances(member.Set, mapper->TakeInstances(member.Actor));
      member.SentInstances = mapper->GetInstanceVersion();
      member.SentColors = 0; // the kernels forget a set's colors with its glyphs
    }
    if (member.SentColors != mapper->GetColorVersion())
    {
      scene.SetColours(member.Set, mapper->GetColors());
      member.SentColors = mapper->GetColorVersion();
    }
    if (member.SentMaterial != member.MaterialVersion)
    {
      scene.SetMaterial(member.Set, member.Material);
      member.SentMaterial = member.MaterialVersion;
    }
  }
  this->Neighbors.Commit(scene, this->Images.GetSceneNumber(),
    [&](int display) { return this->MaterialOf(this->Members[display], renderer); });
  scene.Commit([this](double share) { this->Progress.Tell("Sorting Glyphs", share); });
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::HasPass(int pass) const
{
  return this->Self->Wants[pass];
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

  // A camera that sees nothing is no failure of the glyphs: the next one may be good.
  rtg::ImageView view;
  try
  {
    view = vtkRayTracedImageRequest::ViewOf(self.Settings, this->Renderer, static_cast<rtg::Pass>(pass),
      static_cast<std::uint32_t>(viewport[2]), static_cast<std::uint32_t>(viewport[3]), self.Environment);
    self.CameraReported.clear();
  }
  catch (const rtg::Error& error)
  {
    if (self.CameraReported != error.what())
    {
      self.CameraReported = error.what();
      vtkWarningMacro(<< error.what());
    }
    return;
  }
  view.content = self.ContentNumber;
  const bool capture = self.Capture;
  vtkRayTracedImageRequest::Frame frame;
  frame.Capture = capture;
  frame.Interactive = self.Interactive;
  frame.Features = !self.FeatureFile.empty() && !self.Interactive;
  frame.Images = (self.HasBothPasses() ? 2 : 1) * (window->GetStereoRender() ? 2 : 1);
  const rtg::ImageEffort effort = vtkRayTracedImageRequest::EffortOf(self.Settings, frame);
  // Ranks that all have everything trace a share each, and compositing puts these together.
  vtkMultiProcessController* ranks = self.OtherRanks();
  if (ranks && self.Settings.ParallelLight == vtkRayTracedImageSettings::ReplicatedLight && !effort.preview &&
    !effort.features && !rtg::Denoises(view, effort))
  {
    view.settings.share = static_cast<std::uint32_t>(ranks->GetLocalProcessId());
    view.settings.shares = static_cast<std::uint32_t>(ranks->GetNumberOfProcesses());
  }

  vtkRayTracedImages::Place place;
  place.Pass = pass;
  place.Width = view.settings.width;
  place.Height = view.settings.height;
  place.Eye = this->Renderer->GetActiveCamera()->GetLeftEye();
  window->GetTileViewport(place.Tile.data());
  vtkRayTracedImages::Entry& entry = self.Images.Get(place);

  // Another camera, for example, is asked for because somebody wants to see more.
  const bool stays = self.Stopped && !capture && entry.Image.View() == view;
  self.Stopped = capture ? self.Stopped : stays;
  const bool growing = entry.Image.GetState() == rtg::ProgressiveImage::State::Growing;
  // Somebody may not want it any more; and ParaView's progress bar wants to know.
  vtkRayTracedSignal signal;
  self.Progress.Start();
  const rtg::Interrupt interrupt = [&](double share)
  {
    self.Progress.Tell(entry.Image.IsCompiling() ? compilingText : tracingText, share);
    return window->CheckAbortStatus() != 0 || signal.Arrived();
  };
  // Whoever is told or asked may paint meanwhile: Qt makes its own OpenGL context current, and binds framebuffers of
  // widgets in ours.
  window->GetState()->Push();
  const rtg::Image* image = stays && growing
    ? &entry.Image.GetImage()
    : self.Images.Update(
        entry, view, effort, interrupt, [this](rtg::Scene& scene) { this->Self->Commit(scene, this->Renderer); });
  window->MakeCurrent();
  window->GetState()->Pop();
  self.Frame.push_back({ &entry, glm::dot(view.camera.eye - view.camera.position, glm::dvec3(view.camera.forward)) });
  if (!image)
  {
    this->Report(entry.Image.GetFailure().message);
    return;
  }
  self.Reported.clear();
  if (capture && entry.Image.GetState() == rtg::ProgressiveImage::State::Growing && !self.CutReported)
  {
    self.CutReported = true;
    vtkWarningMacro(<< "Tracing was stopped: the picture that is saved has " << entry.Image.Samples() << " of "
                    << effort.samples << " samples a pixel. Save it again to have them all.");
  }
  if (entry.Uploaded != entry.Image.Version() || !entry.Quad.HasImage())
  {
    entry.Quad.SetImage(window, image->width, image->height, image->colour, image->depth);
    entry.Uploaded = entry.Image.Version();
  }
  entry.Quad.Draw(this->Renderer, imageActor, mapper, vtkRayTracedImageQuad::BLEND);
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::SmoothFrame()
{
  Internals& self = *this->Self;
  self.FXAA.Apply(this->Renderer,
    [this, &self](vtkTextureObject* pixels)
    {
      for (const Internals::Drawn& drawn : self.Frame)
      {
        drawn.Entry->Quad.DrawKept(this->Renderer, pixels);
      }
    });
}

//----------------------------------------------------------------------------
// How far the frame is: the least of its images, over all ranks. Where nothing was drawn nothing is to be done.
void vtkRayTracedScene::EndFrame()
{
  Internals& self = *this->Self;
  self.FXAA.GiveBack(this->Renderer);
  if (self.Members.empty() || this->Renderer->GetSelector())
  {
    return;
  }
  double progress = 1.0;
  double samples = self.Settings.SamplesPerPixel;
  bool finished = true;
  self.Compiling = false;
  for (const Internals::Drawn& drawn : self.Frame)
  {
    const rtg::ProgressiveImage& image = drawn.Entry->Image;
    self.Compiling |= image.GetState() == rtg::ProgressiveImage::State::Growing && image.IsCompiling();
    progress = self.Stopped && !self.Capture ? 1.0 : std::min(progress, image.Progress());
    samples =
      std::min(samples, image.GetState() == rtg::ProgressiveImage::State::Failed ? 0.0 : double(image.Samples()));
    finished &= image.GetState() == rtg::ProgressiveImage::State::Finished;
  }
  vtkMultiProcessController* controller = self.OtherRanks();
  if (controller && !self.Interactive)
  {
    const double own[2] = { progress, samples };
    double least[2];
    controller->AllReduce(own, least, 2, vtkCommunicator::MIN_OP);
    progress = least[0];
    samples = least[1];
  }
  if (!controller)
  {
    self.SummedNumbers.clear();
  }
  else if (!self.Interactive)
  {
    self.SumNumbers(controller);
  }
  self.Stereo = this->Renderer->GetRenderWindow()->GetStereoRender() != 0;
  self.Eye = this->Renderer->GetActiveCamera()->GetLeftEye() != 0;
  self.Done[self.Eye] = progress;
  self.Samples[self.Eye] = samples;

  if (!self.FeatureFile.empty() && finished && !self.Frame.empty() && self.Images.GetScene())
  {
    std::vector<const rtg::Image*> images;
    for (const Internals::Drawn& drawn : self.Frame)
    {
      images.push_back(&drawn.Entry->Image.GetImage());
    }
    std::map<rtg::Scene::SetId, vtkRayTracedMapper*> mappers;
    for (const Internals::Member& member : self.Members)
    {
      if (member.Shown)
      {
        mappers[member.Set] = member.Mapper;
      }
    }
    const std::string problem = vtkRayTracedFeatureImage::Write(
      self.FeatureFile, images, *self.Images.GetScene(), mappers, self.Frame.front().EyeDepth);
    self.FeatureFile.clear();
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem);
    }
  }
}

//----------------------------------------------------------------------------
// Images of both passes that know what the camera sees in each pixel; none where it sees nothing.
std::vector<const rtg::Image*> vtkRayTracedScene::ImagesWithIds(int width, int height)
{
  Internals& self = *this->Self;
  std::vector<const rtg::Image*> images;
  rtg::ImageView view;
  try
  {
    view.camera =
      vtkRayTracedRendererState::CameraOf(this->Renderer, vtkRayTracedRendererState::WorldToClip(this->Renderer));
  }
  catch (const rtg::Error&)
  {
    return images;
  }
  view.content = self.ContentNumber;
  view.settings.width = static_cast<std::uint32_t>(width);
  view.settings.height = static_cast<std::uint32_t>(height);
  for (int pass : { opaque, translucent })
  {
    if (!self.Wants[pass])
    {
      continue;
    }
    // The image that is shown knows the ids; without it one ray a pixel finds them.
    view.pass = static_cast<rtg::Pass>(pass);
    if (vtkRayTracedImages::Entry* shown = self.Images.FindSame(view))
    {
      images.push_back(&shown->Image.GetImage());
      continue;
    }
    vtkRayTracedImages::Entry& own =
      self.Images.Get({ pass, view.settings.width, view.settings.height, 0, {}, /*OnlyIds=*/true });
    const rtg::Image* image = self.Images.Update(
      own, view, rtg::ImageEffort(), {}, [this](rtg::Scene& scene) { this->Self->Commit(scene, this->Renderer); });
    if (image)
    {
      images.push_back(image);
    }
    else
    {
      this->Report(own.Image.GetFailure().message);
    }
  }
  return images;
}

//----------------------------------------------------------------------------
bool vtkRayTracedScene::PlaceAt(int x, int y, double place[3])
{
  const int* size = this->Renderer ? this->Renderer->GetSize() : nullptr;
  if (!size || x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return false;
  }
  const auto width = static_cast<std::uint32_t>(size[0]), height = static_cast<std::uint32_t>(size[1]);
  const std::size_t pixel = std::size_t(y) * width + x;
  float depth = 1.0f;
  for (const rtg::Image* image : this->ImagesWithIds(size[0], size[1]))
  {
    depth = std::min(depth, image->depth[pixel]);
  }
  if (!(depth < 1.0f))
  {
    return false;
  }
  const glm::dmat4 clipToWorld = glm::inverse(vtkRayTracedRendererState::WorldToClip(this->Renderer));
  const glm::dvec3 at = vtkRayTracedRendererState::PlaceOf(pixel, width, height, depth, clipToWorld);
  std::copy_n(&at[0], 3, place);
  return true;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::DrawIds(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  Internals& self = *this->Self;
  vtkHardwareSelector* selector = this->Renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  const Internals::Member* member = self.Find(mapper);
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (!window || !member || !member->Shown || viewport[2] < 1 || viewport[3] < 1)
  {
    return;
  }
  selector->BeginRenderProp();
  const std::vector<const rtg::Image*> images = this->ImagesWithIds(viewport[2], viewport[3]);
  if (!images.empty() && self.Images.GetScene())
  {
    vtkRayTracedIdBuffer buffer;
    buffer.Fill(images, *self.Images.GetScene(), member->Set, vtkRayTracedRendererState::WorldToClip(this->Renderer),
      mapper, selector);
    if (selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      selector->UpdateMaximumCellId(buffer.LargestId);
    }
    else
    {
      selector->UpdateMaximumPointId(buffer.LargestId);
    }
    self.IdQuad.SetImage(
      window, images.front()->width, images.front()->height, buffer.Values.data(), buffer.Depths.data());
    self.IdQuad.Draw(this->Renderer, actor, mapper, vtkRayTracedImageQuad::IDS);
  }
  selector->EndRenderProp();
}

//----------------------------------------------------------------------------
std::vector<vtkRayTracedScene::Shown> vtkRayTracedScene::CopyShown()
{
  std::vector<Shown> all;
  std::vector<rtg::GlyphInstances> built;
  for (const vtkRayTracedNeighbors::Shown& shown : this->Self->ShownHere(built))
  {
    all.push_back({ *shown.Instances, *shown.Colors, this->Self->Members[shown.Display].Material });
  }
  return all;
}

//----------------------------------------------------------------------------
void vtkRayTracedScene::ReportExport()
{
  Internals& self = *this->Self;
  vtkRayTracedPythonClass::Register();
  const bool selecting =
    this->Renderer->GetSelector() != nullptr; // VTK 9.6's selector asks actors for their mappers, too
  if (self.WantsAnything() && !selecting && !self.PassReported && !self.ExportReported)
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
  this->Self->IdQuad.ReleaseGraphicsResources(window);
  this->Self->FXAA.ReleaseGraphicsResources();
}

//----------------------------------------------------------------------------
std::string vtkRayTracedScene::GetDeviceName() const
{
  return this->Self->Images.GetDeviceName();
}

//----------------------------------------------------------------------------
int vtkRayTracedScene::GetAccumulatedSamples() const
{
  const Internals& self = *this->Self;
  return static_cast<int>(self.Stereo ? std::min(self.Samples[0], self.Samples[1]) : self.Samples[self.Eye]);
}

//----------------------------------------------------------------------------
double vtkRayTracedScene::GetProgress() const
{
  const Internals& self = *this->Self;
  return self.Stereo ? std::min(self.Done[0], self.Done[1]) : self.Done[self.Eye];
}

//----------------------------------------------------------------------------
const char* vtkRayTracedScene::GetStep() const
{
  const Internals& self = *this->Self;
  return self.Compiling ? compilingText : this->GetProgress() < 1.0 ? tracingText : "";
}

//----------------------------------------------------------------------------
std::vector<double> vtkRayTracedScene::Internals::OwnNumbers() const
{
  const rtg::Statistics s = this->Images.GetStatistics();
  std::vector<double> numbers(VIEW_NUMBERS);
  numbers[DEVICE_BYTES] = static_cast<double>(s.deviceBytes);
  numbers[PRIMARY_RAYS] = static_cast<double>(s.primaryRays);
  numbers[NEIGHBOR_GLYPHS] = static_cast<double>(this->Neighbors.GetNumberOfGlyphs());
  numbers[NEIGHBOR_BYTES] = static_cast<double>(this->Neighbors.GetNumberOfBytes());
  for (const Member& member : this->Members)
  {
    numbers.push_back(static_cast<double>(member.Mapper->GetNumberOfGlyphs()));
    numbers.push_back(static_cast<double>(member.Mapper->GetSkippedGlyphs()));
  }
  return numbers;
}

//----------------------------------------------------------------------------
// Where ranks have different displays, which should not be, each keeps its own numbers.
void vtkRayTracedScene::Internals::SumNumbers(vtkMultiProcessController* ranks)
{
  const std::vector<double> own = this->OwnNumbers();
  const int lengths[2] = { static_cast<int>(own.size()), -static_cast<int>(own.size()) };
  int largest[2];
  ranks->AllReduce(lengths, largest, 2, vtkCommunicator::MAX_OP);
  this->SummedNumbers.clear();
  if (largest[0] == -largest[1])
  {
    this->SummedNumbers.resize(own.size());
    ranks->AllReduce(
      own.data(), this->SummedNumbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  }
}

//----------------------------------------------------------------------------
std::string vtkRayTracedScene::GetStatistics(vtkRayTracedMapper* mapper, const DataStatistics& data) const
{
  const Internals& self = *this->Self;
  const rtg::Statistics s = self.Images.GetStatistics();
  std::vector<double> numbers = self.OwnNumbers();
  if (self.SummedNumbers.size() == numbers.size())
  {
    numbers = self.SummedNumbers;
  }
  const auto member = std::find_if(self.Members.begin(), self.Members.end(),
    [mapper](const Internals::Member& candidate) { return candidate.Mapper == mapper; });
  const auto count = [&](std::size_t number) { return static_cast<std::uint64_t>(numbers[number]); };
  const auto ofMember = [&](std::size_t number)
  {
    const std::size_t place = member - self.Members.begin();
    return member == self.Members.end() ? 0 : count(VIEW_NUMBERS + memberNumbers * place + number);
  };
  const nlohmann::ordered_json json = {
    { "DeviceName", this->GetDeviceName() },
    { "AccumulatedSamples", this->GetAccumulatedSamples() },
    { "glyphs", ofMember(0) },
    { "skippedGlyphs", ofMember(1) },
    { "unfinished", mapper ? mapper->GetUnfinished() : std::string() },
    { "neighborGlyphs", count(NEIGHBOR_GLYPHS) },
    { "neighborBytes", count(NEIGHBOR_BYTES) },
    { "gathers", data.Gathers },
    { "boundsBuilds", data.BoundsBuilds },
    { "instanceBuilds", mapper ? mapper->GetInstanceBuilds() : 0 },
    { "colorBuilds", mapper ? mapper->GetColorBuilds() : 0 },
    { "structureBuilds", s.structureBuilds },
    { "topLevelBuilds", s.topLevelBuilds },
    { "instanceUploads", s.instanceUploads },
    { "colorUploads", s.colourUploads },
    { "pipelineBuilds", s.pipelineBuilds },
    { "dispatches", s.dispatches },
    { "primaryRays", count(PRIMARY_RAYS) },
    { "deviceBytes", count(DEVICE_BYTES) },
    { "sorts", s.sorts },
    { "gatherSeconds", data.GatherSeconds },
    { "boundsSeconds", data.BoundsSeconds },
    { "instanceSeconds", mapper ? mapper->GetInstanceSeconds() : 0.0 },
    { "colorSeconds", mapper ? mapper->GetColorSeconds() : 0.0 },
    { "sortSeconds", s.sortSeconds },
    { "buildSeconds", s.buildSeconds },
    { "uploadSeconds", s.uploadSeconds },
    { "traceSeconds", s.traceSeconds },
    { "denoiseSeconds", s.denoiseSeconds },
  };
  return json.dump();
}
