#include "vtkRayTracedContent.h"

#include "vtkRayTracedImageSettings.h"

#include <cmath>
#include <vector>

//----------------------------------------------------------------------------
bool vtkRayTracedContent::Update(vtkRenderer* renderer, const vtkRayTracedImageSettings& settings,
  vtkMultiProcessController* ranks, const std::function<void(const std::string&)>& report)
{
  vtkRayTracedDisplays::Content shown = this->Displays.Update(renderer, report);
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
std::uint64_t vtkRayTracedContent::UpdateNeighbors(const vtkRayTracedDisplays::Content& shown,
  const vtkRayTracedImageSettings& settings, vtkMultiProcessController* ranks,
  const std::function<void(const std::string&)>& report)
{
  if (!ranks || settings.ParallelLight != vtkRayTracedImageSettings::NeighborLight ||
    settings.ShadingMode == static_cast<int>(rtg::Shading::Local))
  {
    this->Neighbors.Clear();
    return this->Neighbors.GetVersion();
  }
  const bool bounded =
    settings.ShadingMode == static_cast<int>(rtg::Shading::AmbientOcclusion) && settings.AmbientOcclusionRadius > 0.0;
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
const rtg::Image* vtkRayTracedContent::Trace(vtkRayTracedImages::Entry& entry, const rtg::ImageView& view,
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
