/**
 * The ray-traced displays of a view: what each shows in a frame, and what of it the kernels have.
 */
#ifndef RayTracedDisplays_h
#define RayTracedDisplays_h

#include "RayTracedNeighbors.h"
#include "Scene.h"
#include "vtkBoundingBox.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <map>
#include <vector>

class vtkActor;
class vtkRayTracedMapper;
class vtkRenderer;
namespace rtglyphs
{
class RayTracedImages;

/**
 * What a representation does with its data before they are rendered: how often, and the seconds of that.
 */
struct RayTracedDataStatistics
{
  unsigned int Representation = 0; // vtkPVDataRepresentation::GetUniqueIdentifier(); 0: of a layer of another one
  std::uint64_t Gathers = 0, BoundsBuilds = 0;
  double GatherSeconds = 0.0, BoundsSeconds = 0.0;
};

class RayTracedDisplays
{
public:
  struct Display
  {
    vtkRayTracedMapper* Mapper = nullptr; // takes itself out before it goes
    vtkWeakPointer<vtkActor> Actor;
    rtg::Scene::SetId Set = 0;
    rtg::Material Material;
    bool Shown = false;       // in this frame
    bool Translucent = false; // and then in the translucent pass
    RayTracedDataStatistics Data;

    // What the kernels have.
    std::uint64_t Scene = 0; // number of the kernels' scene that has the set; 0: none
    std::uint64_t SentInstances = 0, SentColors = 0, SentMaterial = 0;
    std::uint64_t MaterialVersion = 0;
  };

  /**
   * Of each shown display the versions of its instances, colors and material: two frames with the same list look the
   * same.
   */
  using Content = std::vector<std::array<std::uint64_t, 3>>;

  /**
   * By set.
   */
  std::map<rtg::Scene::SetId, vtkRayTracedMapper*> GetShownMappers() const;

  /**
   * In the order in which they were added.
   */
  const std::vector<Display>& GetAll() const { return this->All; }
  const Display* Find(const vtkRayTracedMapper* mapper) const;

  ///@{
  /**
   * Both may be called again. Remove() takes the glyphs out of the kernels' scene, too.
   */
  void Add(vtkActor* actor, vtkRayTracedMapper* mapper);
  void Remove(vtkRayTracedMapper* mapper, RayTracedImages& images);
  ///@}

  void SetStatistics(vtkRayTracedMapper* mapper, const RayTracedDataStatistics& statistics);

  /**
   * Brings instances and colors of all visible displays up to date, and finds what the frame shows. `report` gets what
   * a display could not make.
   */
  Content Update(vtkRenderer* renderer, const std::function<void(const std::string&)>& report);

  /**
   * Whether a pass (of rtg::Pass), or any, has something to draw.
   */
  bool Shows(int pass) const;
  bool ShowsAnything() const;

  /**
   * Whether any display is visible, with or without data in this process.
   */
  bool AnyVisible() const;

  /**
   * Of what the frame shows.
   */
  vtkBoundingBox ComputeShownBounds() const;

  /**
   * Hands the kernels' scene of that number what has changed since it had it.
   */
  void Commit(rtg::Scene& scene, std::uint64_t sceneNumber);

  /**
   * What is shown. Instances that the kernels have been handed are theirs; where they have been given back they are
   * built again, into `built`.
   */
  std::vector<RayTracedNeighbors::Shown>
  GetShown(RayTracedImages& images, std::vector<rtg::GlyphInstances>& built) const;

  /**
   * The material of a display, by its number.
   */
  rtg::Material GetMaterial(int display, vtkRenderer* renderer) const;

private:
  std::vector<Display> All;
  std::uint64_t MaterialVersions = 0;
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedDisplays.h
