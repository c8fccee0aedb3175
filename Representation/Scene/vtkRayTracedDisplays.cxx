#include "vtkRayTracedDisplays.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkRayTracedImages.h"
#include "vtkRayTracedMapper.h"
#include "vtkRayTracedRendererState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <new>

//----------------------------------------------------------------------------
const vtkRayTracedDisplays::Display* vtkRayTracedDisplays::Find(const vtkRayTracedMapper* mapper) const
{
  const auto found = std::find_if(
    this->All.begin(), this->All.end(), [mapper](const Display& display) { return display.Mapper == mapper; });
  return found == this->All.end() ? nullptr : &*found;
}

//----------------------------------------------------------------------------
void vtkRayTracedDisplays::Add(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  const Display* known = this->Find(mapper);
  Display& display = known ? this->All[known - this->All.data()] : this->All.emplace_back();
  display.Mapper = mapper;
  display.Actor = actor;
}

//----------------------------------------------------------------------------
void vtkRayTracedDisplays::Remove(vtkRayTracedMapper* mapper, vtkRayTracedImages& images)
{
  const Display* found = this->Find(mapper);
  if (!found)
  {
    return;
  }
  rtg::Scene* scene = images.GetScene();
  if (scene && found->Scene == images.GetSceneNumber())
  {
    scene->Remove(found->Set);
  }
  this->All.erase(this->All.begin() + (found - this->All.data()));
}

//----------------------------------------------------------------------------
void vtkRayTracedDisplays::SetStatistics(vtkRayTracedMapper* mapper, const vtkRayTracedDataStatistics& statistics)
{
  if (const Display* known = this->Find(mapper))
  {
    this->All[known - this->All.data()].Data = statistics;
  }
}

//----------------------------------------------------------------------------
vtkRayTracedDisplays::Content
vtkRayTracedDisplays::Update(vtkRenderer* renderer, const std::function<void(const std::string&)>& report)
{
  Content content;
  for (Display& display : this->All)
  {
    vtkRayTracedMapper* mapper = display.Mapper;
    display.Shown = false;
    vtkActor* actor = display.Actor;
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
      report("Ray Traced Glyphs: the computer's memory does not suffice to make the glyphs "
             "of these data. Show fewer "
             "(GlyphMask, MaximumNumberOfGlyphs) or hide other data.");
      continue;
    }
    if (mapper->GetNumberOfGlyphs() == 0)
    {
      continue;
    }
    const rtg::Material material = this->GetMaterial(static_cast<int>(&display - this->All.data()), renderer);
    if (display.MaterialVersion == 0 || !(display.Material == material))
    {
      display.Material = material;
      display.MaterialVersion = ++this->MaterialVersions;
    }
    display.Shown = true;
    display.Translucent = material.opacity < 1.0f || mapper->IsTranslucent();
    content.push_back({ { mapper->GetInstanceVersion(), mapper->GetColorVersion(), display.MaterialVersion } });
  }
  return content;
}

//----------------------------------------------------------------------------
bool vtkRayTracedDisplays::Shows(int pass) const
{
  const bool translucent = pass == static_cast<int>(rtg::Pass::Translucent);
  return std::any_of(this->All.begin(), this->All.end(),
    [translucent](const Display& display) { return display.Shown && display.Translucent == translucent; });
}

//----------------------------------------------------------------------------
bool vtkRayTracedDisplays::ShowsAnything() const
{
  return std::any_of(this->All.begin(), this->All.end(), [](const Display& display) { return display.Shown; });
}

//----------------------------------------------------------------------------
bool vtkRayTracedDisplays::AnyVisible() const
{
  return std::any_of(this->All.begin(), this->All.end(),
    [](const Display& display) { return display.Actor && display.Actor->GetVisibility(); });
}

//----------------------------------------------------------------------------
void vtkRayTracedDisplays::Commit(rtg::Scene& scene, std::uint64_t sceneNumber)
{
  for (Display& display : this->All)
  {
    vtkRayTracedMapper* mapper = display.Mapper;
    const bool known = display.Scene == sceneNumber;
    if (!display.Shown)
    {
      if (known)
      {
        scene.Remove(display.Set);
        display.Scene = 0;
      }
      continue;
    }
    if (!known)
    {
      display.Set = scene.Add();
      display.Scene = sceneNumber;
      display.SentInstances = display.SentColors = display.SentMaterial = 0;
    }
    if (display.SentInstances != mapper->GetInstanceVersion())
    {
      scene.SetInstances(display.Set, mapper->TakeInstances(display.Actor));
      display.SentInstances = mapper->GetInstanceVersion();
      display.SentColors = 0; // the kernels forget a set's colors with its glyphs
    }
    if (display.SentColors != mapper->GetColorVersion())
    {
      scene.SetColours(display.Set, mapper->GetColors());
      display.SentColors = mapper->GetColorVersion();
    }
    if (display.SentMaterial != display.MaterialVersion)
    {
      scene.SetMaterial(display.Set, display.Material);
      display.SentMaterial = display.MaterialVersion;
    }
  }
}

//----------------------------------------------------------------------------
std::vector<vtkRayTracedNeighbors::Shown>
vtkRayTracedDisplays::GetShown(vtkRayTracedImages& images, std::vector<rtg::GlyphInstances>& built) const
{
  std::vector<vtkRayTracedNeighbors::Shown> shown;
  built.reserve(this->All.size());
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const Display& display = this->All[i];
    if (!display.Shown)
    {
      continue;
    }
    const rtg::GlyphInstances* instances = display.Mapper->GetInstances();
    rtg::Scene* scene = images.GetScene();
    if (!instances && scene && display.Scene == images.GetSceneNumber() &&
      display.SentInstances == display.Mapper->GetInstanceVersion())
    {
      instances = &scene->InstancesOf(display.Set);
    }
    if (!instances)
    {
      instances = &built.emplace_back(display.Mapper->TakeInstances(display.Actor));
    }
    shown.push_back({ static_cast<int>(i), instances, &display.Mapper->GetColors() });
  }
  return shown;
}

//----------------------------------------------------------------------------
rtg::Material vtkRayTracedDisplays::GetMaterial(int display, vtkRenderer* renderer) const
{
  const Display& of = this->All[display];
  rtg::Material material = vtkRayTracedRendererState::MaterialOf(of.Actor->GetProperty(), renderer);
  of.Mapper->AddToMaterial(material);
  return material;
}
