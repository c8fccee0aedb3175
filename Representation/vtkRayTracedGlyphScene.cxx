#include "vtkRayTracedGlyphScene.h"

#include "vtkRayTracedGlyphSceneInternals.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkRenderer.h"
#include "vtk_glew.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkRayTracedGlyphScene);

using namespace vtkRayTracedGlyphSceneDetail;

namespace
{
// Above this, in frames a second, a window asks for speed: ParaView renders interactively at 5, at rest at 0.002.
constexpr double interactiveRate = 1.0;
// One step of an image that somebody watches, in seconds: a camera that is turned meanwhile waits so long.
constexpr double stepSeconds = 0.1;

vtkRayTracedGlyphMapper* GlyphMapperOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor ? vtkRayTracedGlyphMapper::SafeDownCast(actor->GetMapper()) : nullptr;
}

rtg::TraceSettings SettingsOf(const vtkRayTracedGlyphLight& light)
{
  rtg::TraceSettings settings;
  settings.shading = static_cast<rtg::Shading>(light.ShadingMode);
  settings.occlusionRadius = static_cast<float>(light.AmbientOcclusionRadius);
  settings.maximumBounces = static_cast<std::uint32_t>(light.MaximumBounces);
  settings.lightIntensity = static_cast<float>(light.LightIntensity);
  settings.environmentColour = glm::vec3(static_cast<float>(light.EnvironmentColor[0]),
    static_cast<float>(light.EnvironmentColor[1]), static_cast<float>(light.EnvironmentColor[2]));
  settings.toneMapping = static_cast<rtg::ToneMapping>(light.ToneMapping);
  settings.exposure = static_cast<float>(light.Exposure);
  return settings;
}

std::map<vtkRenderer*, vtkWeakPointer<vtkRayTracedGlyphScene>>& Registry()
{
  static std::map<vtkRenderer*, vtkWeakPointer<vtkRayTracedGlyphScene>> registry;
  return registry;
}
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphScene::vtkRayTracedGlyphScene()
  : Self(std::make_unique<Internals>())
{
}

//----------------------------------------------------------------------------
vtkRayTracedGlyphScene::~vtkRayTracedGlyphScene()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Observer);
    Registry().erase(this->Renderer);
    if (vtkWindow* window = this->Renderer->GetVTKWindow())
    {
      this->ReleaseGraphicsResources(window);
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << endl;
  os << indent << "Number of mappers: " << this->Self->Members.size() << endl;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkRayTracedGlyphScene> vtkRayTracedGlyphScene::Of(vtkRenderer* renderer)
{
  vtkWeakPointer<vtkRayTracedGlyphScene>& entry = Registry()[renderer];
  // A new renderer may have the address of one that is gone.
  if (entry && entry->Renderer == renderer)
  {
    return entry.Get();
  }
  auto scene = vtkSmartPointer<vtkRayTracedGlyphScene>::Take(vtkRayTracedGlyphScene::New());
  scene->Renderer = renderer;
  scene->Observer =
    renderer->AddObserver(vtkCommand::StartEvent, scene.Get(), &vtkRayTracedGlyphScene::StartFrame);
  entry = scene;
  return scene;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::StartFrame()
{
  Internals& self = *this->Self;
  self.Synchronised = false;
  self.OpaqueDrawn = false;
  self.TranslucentLeader = nullptr;
  this->DrawLast();
  this->Synchronise();
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::DrawLast()
{
  std::vector<vtkSmartPointer<vtkProp>> glyphs;
  bool inFront = false;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (GlyphMapperOf(prop))
    {
      glyphs.emplace_back(prop);
    }
    else
    {
      inFront |= !glyphs.empty();
    }
  }
  if (inFront)
  {
    for (const auto& prop : glyphs)
    {
      props->RemoveItem(prop);
      props->AddItem(prop);
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::Fail(const std::string& message)
{
  Internals& self = *this->Self;
  self.FailedVersion = self.Version;
  const bool lost = self.Device && self.Device->Lost();
  if (lost || !self.Device)
  {
    self.Forget();
  }
  self.TryNewDevice = lost && !self.LostDevice;
  self.LostDevice |= lost;
  self.Failure = message;
  if (self.Reported != message)
  {
    self.Reported = message;
    vtkErrorMacro(<< message);
  }
}

//----------------------------------------------------------------------------
// Hands over to the kernels what has changed since the last frame; touches no graphics.
void vtkRayTracedGlyphScene::Synchronise()
{
  Internals& self = *this->Self;
  self.Synchronised = true;

  // The actors of this frame; mappers of actors that are gone leave
  std::vector<std::pair<vtkActor*, vtkRayTracedGlyphMapper*>> actors;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (vtkRayTracedGlyphMapper* mapper = GlyphMapperOf(prop))
    {
      actors.emplace_back(vtkActor::SafeDownCast(prop), mapper);
    }
  }
  std::vector<vtkRayTracedGlyphMapper*> gone;
  for (const auto& item : self.Members)
  {
    if (std::none_of(actors.begin(), actors.end(),
          [&item](const auto& actor) { return actor.second == item.first; }))
    {
      gone.push_back(item.first);
    }
  }
  for (vtkRayTracedGlyphMapper* mapper : gone)
  {
    this->Remove(mapper);
  }

  // Arrays to instances and colours
  bool any = false;
  std::uint64_t version = 0;
  self.SamplesPerPixel = 1;
  self.SamplesPerRender = 0;
  self.InteractiveReduction = 1;
  self.Stepwise = false;
  self.Light = vtkRayTracedGlyphLight();
  bool lit = false;
  for (const auto& item : actors)
  {
    vtkRayTracedGlyphMapper* mapper = item.second;
    if (!item.first->GetVisibility())
    {
      continue;
    }
    mapper->Update(item.first);
    any |= mapper->GetNumberOfGlyphs() > 0;
    version += mapper->GetInstanceVersion() + mapper->GetColorVersion();
    const auto largest = [](std::uint32_t& value, int other)
    { value = std::max(value, static_cast<std::uint32_t>(other)); };
    largest(self.SamplesPerPixel, mapper->GetSamplesPerPixel());
    largest(self.SamplesPerRender, mapper->GetSamplesPerRender());
    largest(self.InteractiveReduction, mapper->GetInteractiveReduction());
    self.Stepwise |= mapper->GetStepwiseRendering();
    if (!lit || mapper->Light.ShadingMode > self.Light.ShadingMode)
    {
      self.Light = mapper->Light;
      lit = true;
    }
  }
  self.Version = version;
  const bool again = self.TryNewDevice || self.FailedVersion != version;
  if ((!any && !self.Scene) || (!self.Failure.empty() && !again))
  {
    return;
  }
  self.TryNewDevice = false;
  try
  {
    if (!self.Device || self.Device->Lost())
    {
      self.Forget();
      self.Device = rtg::Device::Shared();
    }
    if (!self.Scene)
    {
      self.Scene = std::make_unique<rtg::Scene>(self.Device);
    }
    for (auto& item : self.Members)
    {
      item.second.Shown = false;
    }
    self.Content.clear();
    for (const auto& item : actors)
    {
      if (item.first->GetVisibility() && item.second->GetNumberOfGlyphs() > 0)
      {
        this->Show(item.first, item.second);
      }
    }
    self.Failure.clear();
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
  }
}

//----------------------------------------------------------------------------
// Takes note of what a visible actor has to show.
void vtkRayTracedGlyphScene::Show(vtkActor* actor, vtkRayTracedGlyphMapper* mapper)
{
  Internals& self = *this->Self;
  auto found = self.Members.find(mapper);
  if (found == self.Members.end())
  {
    mapper->Join(this->Renderer);
    Internals::Member member;
    member.Set = self.Scene->Add();
    found = self.Members.emplace(mapper, member).first;
  }
  Internals::Member& member = found->second;
  if (member.Instances != mapper->GetInstanceVersion())
  {
    self.Scene->SetInstances(member.Set, mapper->TakeInstances(actor));
    member.Instances = mapper->GetInstanceVersion();
    member.Colors = 0; // the kernels forget a set's colours with its glyphs
  }
  if (member.Colors != mapper->GetColorVersion())
  {
    self.Scene->SetColours(member.Set, mapper->GetColors());
    member.Colors = mapper->GetColorVersion();
  }
  const rtg::Material material =
    vtkRayTracedGlyphView::MaterialOf(actor->GetProperty(), this->Renderer);
  if (member.MaterialVersion == 0 || !vtkRayTracedGlyphView::Same(member.Material, material))
  {
    self.Scene->SetMaterial(member.Set, material);
    member.Material = material;
    member.MaterialVersion = ++self.MaterialVersion;
  }
  member.Shown = true;
  member.Translucent = material.opacity < 1.0f || mapper->HasTranslucentPolygonalGeometry();
  self.Content.push_back({ { member.Instances, member.Colors, member.MaterialVersion } });
}

//----------------------------------------------------------------------------
// Makes the image of a pass the one of this frame; false: there is nothing to draw.
bool vtkRayTracedGlyphScene::UpdateImage(int pass, bool forIds)
{
  Internals& self = *this->Self;
  const bool translucent = pass == static_cast<int>(rtg::Pass::Translucent);
  const bool wanted = std::any_of(self.Members.begin(), self.Members.end(),
    [translucent](const auto& m) { return m.second.Shown && m.second.Translucent == translucent; });
  if (!self.Scene || !self.Failure.empty() || !wanted)
  {
    return false;
  }
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] < 1 || viewport[3] < 1)
  {
    return false;
  }

  // A camera that sees nothing is no failure of the glyphs: the next one may be good.
  ImageKey key;
  rtg::Camera camera;
  try
  {
    key.WorldToClip = vtkRayTracedGlyphView::WorldToClip(this->Renderer);
    camera = vtkRayTracedGlyphView::CameraOf(this->Renderer, key.WorldToClip);
    self.CameraFailure.clear();
  }
  catch (const rtg::Error& error)
  {
    if (self.CameraFailure != error.what())
    {
      self.CameraFailure = error.what();
      vtkWarningMacro(<< error.what());
    }
    return false;
  }

  PassImage& image = self.Images[pass];
  try
  {
    key.Position = camera.position;
    key.Width = static_cast<std::uint32_t>(viewport[2]);
    key.Height = static_cast<std::uint32_t>(viewport[3]);
    key.Content = self.Content;
    key.Light = self.Light;
    // Headlight and light kit make up for the lack of light from all around; path tracing has that.
    const bool surrounded =
      self.Light.ShadingMode == static_cast<int>(rtg::Shading::PathTracing) &&
      self.Light.LightIntensity > 0.0;
    key.Lights = vtkRayTracedGlyphView::LightsOf(this->Renderer, /*placedOnly=*/surrounded);

    // How good an image this frame wants
    // Identities and depths do not depend on the light.
    if (forIds)
    {
      key.Light = image.Valid ? image.Key.Light : vtkRayTracedGlyphLight();
    }
    const bool same = image.Valid && image.Key == key;
    const bool interactive =
      this->Renderer->GetRenderWindow()->GetDesiredUpdateRate() >= interactiveRate;
    // ParaView captures without showing, and only once
    const bool capturing = this->Renderer->GetRenderWindow()->GetSwapBuffers() == 0;
    rtg::TraceSettings settings = SettingsOf(self.Light);
    settings.width = key.Width;
    settings.height = key.Height;
    if (forIds)
    {
      settings = SettingsOf(key.Light = vtkRayTracedGlyphLight());
      settings.width = key.Width;
      settings.height = key.Height;
      settings.samples = 1;
    }
    else if (interactive && !capturing)
    {
      // Pixels that need more than one ray are spared more of them, for the camera to answer as fast.
      const bool dear = self.Light.ShadingMode != static_cast<int>(rtg::Shading::Local);
      settings.pixelStep = self.InteractiveReduction + (dear && self.InteractiveReduction > 1 ? 1 : 0);
      settings.samples = 1;
    }
    else if ((self.SamplesPerRender > 0 || self.Stepwise) && !capturing)
    {
      const std::uint32_t done = same && image.PixelStep == 1 ? image.Image.samples : 0;
      std::uint32_t step = self.SamplesPerRender;
      if (step == 0)
      {
        step = done == 0 || image.SecondsPerSample <= 0.0
          ? 1
          : static_cast<std::uint32_t>(std::clamp(stepSeconds / image.SecondsPerSample, 1.0, 1e6));
      }
      settings.samples = std::min(self.SamplesPerPixel, done + step);
    }
    else
    {
      settings.samples = self.SamplesPerPixel;
    }
    const bool good = forIds || (interactive && !capturing)
      ? image.Image.samples >= settings.samples
      : image.Image.samples == settings.samples;
    if (same && good && image.PixelStep <= settings.pixelStep)
    {
      self.Samples = image.Image.samples;
      return true;
    }

    // An image that grows step by step keeps its sums, and new samples are added to them. Images of a moving camera
    // do so, too, when steps will follow: they need no other program then, which would first have to be compiled.
    settings.plannedSamples = self.SamplesPerPixel;
    settings.keepSums = !forIds && settings.samples < self.SamplesPerPixel &&
      (settings.pixelStep == 1 || self.Stepwise);
    if (same && image.Kept && image.PixelStep == 1 && settings.pixelStep == 1 && !forIds &&
      image.Image.samples < settings.samples)
    {
      settings.firstSample = image.Image.samples;
      settings.samples -= settings.firstSample;
    }

    // Smooth light in place of noise; surfaces that are lit locally have none. What a step gathers the next ones need.
    const bool noisy = !forIds && self.Light.ShadingMode != static_cast<int>(rtg::Shading::Local);
    const bool unfinished = settings.samples + settings.firstSample < self.SamplesPerPixel;
    const bool inSteps = (self.SamplesPerRender > 0 || self.Stepwise) && !capturing;
    settings.features = noisy && (self.Light.Denoising == 2 || (self.Light.Denoising == 1 && inSteps));
    settings.keepSums |= settings.features;
    const bool denoise = settings.features && settings.pixelStep == 1 &&
      (self.Light.Denoising == 2 || unfinished);

    if (!image.Tracer)
    {
      image.Tracer = std::make_unique<rtg::Tracer>(self.Device);
    }
    image.Valid = image.Kept = image.Sent = false;
    // Only now: what is hidden and shown again before the next image costs nothing.
    for (auto& item : self.Members)
    {
      if (item.second.Visible != item.second.Shown)
      {
        self.Scene->SetVisible(item.second.Set, item.second.Shown);
        item.second.Visible = item.second.Shown;
      }
    }
    self.Scene->Commit();
    const double traced = image.Tracer->GetStatistics().traceSeconds;
    image.Image =
      image.Tracer->Trace(*self.Scene, camera, key.Lights, settings, static_cast<rtg::Pass>(pass));
    if (denoise)
    {
      // Denoising takes about as long as a sample: only when there is a good deal more to see.
      const std::uint32_t samples = image.Image.samples;
      if (settings.firstSample == 0 || image.SmoothSamples == 0 || 2 * samples >= 3 * image.SmoothSamples)
      {
        image.Tracer->Denoise(image.Image);
        image.Smooth.assign(
          image.Image.colour, image.Image.colour + std::size_t(settings.width) * settings.height);
        image.SmoothSamples = samples;
      }
      image.Image.colour = image.Smooth.data();
    }
    else
    {
      image.Smooth.clear();
      image.SmoothSamples = 0;
    }
    image.Key = std::move(key);
    image.PixelStep = settings.pixelStep;
    if (settings.pixelStep == 1)
    {
      image.SecondsPerSample =
        (image.Tracer->GetStatistics().traceSeconds - traced) / settings.samples;
    }
    image.Valid = true;
    image.Kept = settings.keepSums;
    self.Samples = image.Image.samples;
    self.Reported.clear();
    self.LostDevice = false;
    return true;
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
    return false;
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::Render(vtkActor* actor, vtkRayTracedGlyphMapper* mapper)
{
  Internals& self = *this->Self;
  if (!this->Renderer)
  {
    return;
  }
  if (!self.Synchronised)
  {
    this->Synchronise();
  }
  if (this->Renderer->GetSelector())
  {
    this->DrawIds(actor, mapper);
    return;
  }

  // One actor draws for all; in the translucent pass each time, for the pass peels layer by layer
  const bool translucent = actor->IsRenderingTranslucentPolygonalGeometry() != 0;
  if (translucent)
  {
    if (self.TranslucentLeader && self.TranslucentLeader != mapper)
    {
      return;
    }
    self.TranslucentLeader = mapper;
  }
  else
  {
    if (self.OpaqueDrawn)
    {
      return;
    }
    self.OpaqueDrawn = true;
  }

  const int pass = static_cast<int>(translucent ? rtg::Pass::Translucent : rtg::Pass::Opaque);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (window && this->UpdateImage(pass, /*forIds=*/false))
  {
    PassImage& image = self.Images[pass];
    if (!image.Sent)
    {
      image.Quad.SetImage(
        window, image.Image.width, image.Image.height, image.Image.colour, image.Image.depth);
      image.Sent = true;
    }
    image.Quad.Draw(this->Renderer, actor, mapper, vtkRayTracedImageQuad::BLEND);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::Remove(vtkRayTracedGlyphMapper* mapper)
{
  Internals& self = *this->Self;
  const auto found = self.Members.find(mapper);
  if (found == self.Members.end())
  {
    return;
  }
  if (self.Scene)
  {
    try
    {
      self.Scene->Remove(found->second.Set);
    }
    catch (const std::exception& error)
    {
      this->Fail(error.what());
      return;
    }
  }
  self.Members.erase(mapper);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphScene::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Self;
  for (PassImage& image : self.Images)
  {
    image.Quad.ReleaseGraphicsResources(window);
    image.Sent = false;
  }
  self.IdQuad.ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
std::string vtkRayTracedGlyphScene::GetDeviceName()
{
  return this->Self->Device ? this->Self->Device->Name() : std::string();
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphScene::GetAccumulatedSamples()
{
  return static_cast<int>(this->Self->Samples);
}

//----------------------------------------------------------------------------
std::string vtkRayTracedGlyphScene::GetStatistics(vtkRayTracedGlyphMapper* mapper)
{
  const rtg::Statistics s = this->Self->Sum();
  std::string device;
  for (char c : this->GetDeviceName())
  {
    device += c == '"' || c == '\\' ? std::string{ '\\', c } : std::string{ c };
  }
  std::ostringstream json;
  json << "{ \"DeviceName\": \"" << device << "\""
       << ", \"AccumulatedSamples\": " << this->GetAccumulatedSamples()
       << ", \"glyphs\": " << mapper->GetNumberOfGlyphs()
       << ", \"skippedGlyphs\": " << mapper->GetSkippedGlyphs()
       << ", \"structureBuilds\": " << s.structureBuilds
       << ", \"topLevelBuilds\": " << s.topLevelBuilds
       << ", \"instanceUploads\": " << s.instanceUploads
       << ", \"colourUploads\": " << s.colourUploads << ", \"pipelineBuilds\": " << s.pipelineBuilds
       << ", \"dispatches\": " << s.dispatches << ", \"primaryRays\": " << s.primaryRays
       << ", \"deviceBytes\": " << s.deviceBytes << ", \"sortSeconds\": " << s.sortSeconds
       << ", \"buildSeconds\": " << s.buildSeconds << ", \"uploadSeconds\": " << s.uploadSeconds
       << ", \"traceSeconds\": " << s.traceSeconds << ", \"denoiseSeconds\": " << s.denoiseSeconds
       << " }";
  return json.str();
}
