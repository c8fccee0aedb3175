#include "RayTracedContent.h"

#include "RayTracedImageSettings.h"

#include <cmath>
#include <vector>

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedContent::Update(vtkRenderer* renderer, const rtglyphs::RayTracedImageSettings& settings,
  vtkMultiProcessController* ranks, const std::function<void(const std::string&)>& report)
{
  rtglyphs::RayTracedDisplays::Content shown = this->Displays.Update(renderer, report);
  const std::uint64_t neighbors = this->UpdateNeighbors(shown, settings, ranks, report);
  shown.push_back({ { neighbors, 0, 0 } });
  if (shown == this->Shown)
  {
    return false;
  }
  this->Shown = std::move(shown);
  ++this->Number;
  return true;
}

//----------------------------------------------------------------------------
// The version of what other ranks have near this one's glyphs, which differs from that of anything else.
std::uint64_t rtglyphs::RayTracedContent::UpdateNeighbors(const rtglyphs::RayTracedDisplays::Content& shown,
  const rtglyphs::RayTracedImageSettings& settings, vtkMultiProcessController* ranks,
  const std::function<void(const std::string&)>& report)
{
  if (!ranks || settings.ParallelLight != rtglyphs::RayTracedImageSettings::NeighborLight ||
    (settings.ShadingMode == static_cast<int>(rtg::Shading::Local) && !settings.Shadows))
  {
    this->Neighbors.Clear();
    return this->Neighbors.GetVersion();
  }
  const bool bounded = settings.ShadingMode == static_cast<int>(rtg::Shading::AmbientOcclusion) &&
    settings.AmbientOcclusionRadius > 0.0 && !settings.Shadows;
  std::vector<rtg::GlyphInstances> built;
  const std::string problem =
    this->Neighbors.Exchange(ranks, bounded ? settings.AmbientOcclusionRadius : HUGE_VAL, shown != this->ShownToOthers,
      static_cast<int>(this->Displays.GetAll().size()), [&] { return this->Displays.GetShown(this->Images, built); });
  this->ShownToOthers = shown;
  if (!problem.empty())
  {
    report(problem);
  }
  return this->Neighbors.GetVersion();
}

//----------------------------------------------------------------------------
const rtg::Image* rtglyphs::RayTracedContent::Trace(rtglyphs::RayTracedImages::Entry& entry, const rtg::ImageView& view,
  const rtg::ImageEffort& effort, const rtg::Interrupt& interrupt, vtkRenderer* renderer)
{
  return this->Images.Update(entry, view, effort, interrupt,
    [&](rtg::Scene& scene)
    {
      this->Displays.Commit(scene, this->Images.GetSceneNumber());
      this->Neighbors.Commit(scene, this->Images.GetSceneNumber(),
        [&](int display) { return this->Displays.GetMaterial(display, renderer); });
      scene.Commit(this->Sorting);
    });
}
