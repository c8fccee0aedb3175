#include "RayTracedDisplays.h"

#include "RayTracedImageSettings.h"
#include "RayTracedImages.h"
#include "RayTracedRanks.h"
#include "RayTracedRendererState.h"
#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRayTracedMapper.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>
#include <utility>

namespace
{
// The instances of the mapper's version that the kernels have; null: none.
const rtg::GlyphInstances*
SentInstances(const rtglyphs::RayTracedDisplays::Display& display, rtglyphs::RayTracedImages& images)
{
  rtg::Scene* scene = images.GetScene();
  return scene && display.Scene == images.GetSceneNumber() &&
      display.SentInstances == display.Mapper->GetInstanceVersion()
    ? &scene->InstancesOf(display.Set)
    : nullptr;
}
}

//----------------------------------------------------------------------------
const rtglyphs::RayTracedDisplays::Display* rtglyphs::RayTracedDisplays::Find(const vtkRayTracedMapper* mapper) const
{
  const auto found = std::find_if(
    this->All.begin(), this->All.end(), [mapper](const Display& display) { return display.Mapper == mapper; });
  return found == this->All.end() ? nullptr : &*found;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDisplays::Add(vtkActor* actor, vtkRayTracedMapper* mapper)
{
  const Display* known = this->Find(mapper);
  Display& display = known ? this->All[known - this->All.data()] : this->All.emplace_back();
  display.Mapper = mapper;
  display.Actor = actor;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDisplays::Remove(vtkRayTracedMapper* mapper, rtglyphs::RayTracedImages& images)
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
bool rtglyphs::RayTracedDisplays::Update(vtkRenderer* renderer, const rtglyphs::RayTracedImageSettings& settings,
  bool collective, rtglyphs::RayTracedImages& images, const std::function<void(const std::string&)>& report)
{
  Versions shown = this->UpdateAll(renderer, images, report);
  this->ReportMessages(collective);
  if (collective && settings.ParallelLight == rtglyphs::RayTracedImageSettings::NeighborLight &&
    (settings.ShadingMode != static_cast<int>(rtg::Shading::Local) || settings.Shadows))
  {
    const bool bounded = settings.ShadingMode == static_cast<int>(rtg::Shading::AmbientOcclusion) &&
      settings.AmbientOcclusionRadius > 0.0 && !settings.Shadows;
    std::vector<rtg::GlyphInstances> built;
    const std::string problem = this->Neighbors.Exchange(bounded ? settings.AmbientOcclusionRadius : HUGE_VAL,
      shown != this->ShownToOthers, static_cast<int>(this->All.size()), [&] { return this->GetShown(images, built); });
    this->ShownToOthers = shown;
    if (!problem.empty())
    {
      report(problem);
    }
  }
  else
  {
    this->Neighbors.Clear();
  }
  shown.push_back({ { this->Neighbors.GetVersion(), 0, 0 } });
  const bool changed = shown != this->Shown;
  this->Shown = std::move(shown);
  this->Version += changed;
  return changed;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedDisplays::Versions rtglyphs::RayTracedDisplays::UpdateAll(
  vtkRenderer* renderer, rtglyphs::RayTracedImages& images, const std::function<void(const std::string&)>& report)
{
  Versions versions;
  for (Display& display : this->All)
  {
    vtkRayTracedMapper* mapper = display.Mapper;
    display.Shown = false;
    vtkActor* actor = display.Actor;
    if (!actor || !actor->GetVisibility() || mapper->IsSuspended())
    {
      continue;
    }
    try
    {
      mapper->Update(actor, SentInstances(display, images));
    }
    catch (const std::bad_alloc&)
    {
      report("Ray Traced Glyphs: the computer's memory does not suffice to make the glyphs "
             "of these data. Show fewer "
             "(GlyphMode, MaximumNumberOfGlyphs) or hide other data.");
      continue;
    }
    if (mapper->GetNumberOfGlyphs() == 0)
    {
      continue;
    }
    const rtg::Material material = this->GetMaterial(static_cast<int>(&display - this->All.data()), renderer);
    const rtg::PeriodicImages& periodic = mapper->GetImages();
    if (display.MaterialVersion == 0 || !(display.Material == material) || !(display.Images == periodic))
    {
      display.Material = material;
      display.Images = periodic;
      display.MaterialVersion = ++this->MaterialVersions;
    }
    display.Shown = true;
    display.Translucent = material.opacity < 1.0f || mapper->IsTranslucent();
    versions.push_back({ { mapper->GetInstanceVersion(), mapper->GetColorVersion(), display.MaterialVersion } });
  }
  return versions;
}

//----------------------------------------------------------------------------
// The first rank reports a message of several ranks.
void rtglyphs::RayTracedDisplays::ReportMessages(bool collective)
{
  std::vector<std::pair<vtkRayTracedMapper*, std::string>> own;
  for (const Display& display : this->All)
  {
    for (std::string& message : display.Mapper->TakeMessages())
    {
      own.emplace_back(display.Mapper, std::move(message));
    }
  }
  std::set<std::string> said;
  if (collective && rtglyphs::RayTracedRanks::Largest(own.empty() ? 0.0 : 1.0) > 0.0)
  {
    std::vector<std::string> texts;
    for (const auto& [mapper, message] : own)
    {
      texts.push_back(vtkRayTracedMapper::WithoutCounts(message));
    }
    const std::vector<std::vector<std::string>> ofRanks = rtglyphs::RayTracedRanks::Gather(texts);
    for (int rank = 0; rank < rtglyphs::RayTracedRanks::Own(); ++rank)
    {
      said.insert(ofRanks[rank].begin(), ofRanks[rank].end());
    }
  }
  for (const auto& [mapper, message] : own)
  {
    if (!said.count(vtkRayTracedMapper::WithoutCounts(message)))
    {
      vtkWarningWithObjectMacro(mapper, << message);
    }
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedDisplays::Shows(int pass) const
{
  const bool translucent = pass == static_cast<int>(rtg::Pass::Translucent);
  return std::any_of(this->All.begin(), this->All.end(),
    [translucent](const Display& display) { return display.Shown && display.Translucent == translucent; });
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedDisplays::AnyVisible() const
{
  return std::any_of(this->All.begin(), this->All.end(),
    [](const Display& display) { return display.Actor && display.Actor->GetVisibility(); });
}

//----------------------------------------------------------------------------
vtkBoundingBox rtglyphs::RayTracedDisplays::ComputeShownBounds() const
{
  vtkBoundingBox bounds;
  for (const Display& display : this->All)
  {
    const double* own = display.Shown && display.Actor ? display.Actor->GetBounds() : nullptr;
    if (own && vtkMath::AreBoundsInitialized(own))
    {
      bounds.AddBounds(own);
    }
  }
  return bounds;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDisplays::Commit(rtg::Scene& scene, std::uint64_t sceneNumber, vtkRenderer* renderer)
{
  for (Display& display : this->All)
  {
    vtkRayTracedMapper* mapper = display.Mapper;
    const bool known = display.Scene == sceneNumber;
    if (!display.Shown)
    {
      if (known && mapper->IsSuspended() && display.Actor && display.Actor->GetVisibility())
      {
        scene.SetVisible(display.Set, false, /*keep=*/true);
      }
      else if (known)
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
    scene.SetVisible(display.Set, true);
    if (display.SentInstances != mapper->GetInstanceVersion())
    {
      scene.SetInstances(display.Set, mapper->TakeInstances(display.Actor));
      display.SentInstances = mapper->GetInstanceVersion();
      display.SentColors = 0; // the kernels forget a set's colors with its glyphs
    }
    if (display.SentColors != mapper->GetColorVersion())
    {
      scene.SetColors(display.Set, mapper->GetColors());
      display.SentColors = mapper->GetColorVersion();
    }
    if (display.SentMaterial != display.MaterialVersion)
    {
      scene.SetMaterial(display.Set, display.Material);
      scene.SetImages(display.Set, display.Images);
      display.SentMaterial = display.MaterialVersion;
    }
  }
  this->Neighbors.Commit(scene, sceneNumber, [&](int display) { return this->GetMaterial(display, renderer); });
}

//----------------------------------------------------------------------------
std::vector<rtglyphs::RayTracedNeighbors::Shown>
rtglyphs::RayTracedDisplays::GetShown(rtglyphs::RayTracedImages& images, std::vector<rtg::GlyphInstances>& built) const
{
  std::vector<rtglyphs::RayTracedNeighbors::Shown> shown;
  built.reserve(this->All.size());
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const Display& display = this->All[i];
    if (!display.Shown)
    {
      continue;
    }
    const rtg::GlyphInstances* instances = display.Mapper->GetInstances();
    instances = instances ? instances : SentInstances(display, images);
    if (!instances)
    {
      instances = &built.emplace_back(display.Mapper->TakeInstances(display.Actor));
    }
    shown.push_back({ static_cast<int>(i), instances, &display.Mapper->GetColors() });
  }
  return shown;
}

//----------------------------------------------------------------------------
rtg::Material rtglyphs::RayTracedDisplays::GetMaterial(int display, vtkRenderer* renderer) const
{
  const Display& of = this->All[display];
  rtg::Material material = rtglyphs::RayTracedRendererState::MaterialOf(of.Actor->GetProperty(), renderer);
  of.Mapper->AddToMaterial(material);
  material.section = of.Mapper->GetSection();
  return material;
}

//----------------------------------------------------------------------------
std::map<rtg::Scene::SetId, vtkRayTracedMapper*> rtglyphs::RayTracedDisplays::GetShownMappers() const
{
  std::map<rtg::Scene::SetId, vtkRayTracedMapper*> mappers;
  for (const Display& display : this->GetAll())
  {
    if (display.Shown)
    {
      mappers[display.Set] = display.Mapper;
    }
  }
  return mappers;
}
