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

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkRayTracedGlyphScene);

using namespace vtkRayTracedGlyphSceneDetail;

namespace
{
vtkRayTracedGlyphMapper* GlyphMapperOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor ? vtkRayTracedGlyphMapper::SafeDownCast(actor->GetMapper()) : nullptr;
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
  self.FeatureFile.clear();
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
    if (self.FeatureFile.empty())
    {
      self.FeatureFile = mapper->FeatureImageFile;
    }
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
  rtg::Material material = vtkRayTracedGlyphView::MaterialOf(actor->GetProperty(), this->Renderer);
  const vtkGlyphTensors::Settings& tensors = mapper->Glyphs.Tensors;
  material.positiveColour =
    glm::vec3(tensors.PositiveColor[0], tensors.PositiveColor[1], tensors.PositiveColor[2]);
  material.negativeColour =
    glm::vec3(tensors.NegativeColor[0], tensors.NegativeColor[1], tensors.NegativeColor[2]);
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
       << ", \"deviceBytes\": " << s.deviceBytes << ", \"sorts\": " << s.sorts << ", \"sortSeconds\": " << s.sortSeconds
       << ", \"buildSeconds\": " << s.buildSeconds << ", \"uploadSeconds\": " << s.uploadSeconds
       << ", \"traceSeconds\": " << s.traceSeconds << ", \"denoiseSeconds\": " << s.denoiseSeconds
       << " }";
  return json.str();
}
