/**
 * The ray-traced displays of a view: what each shows in a frame, what other ranks have near it, and what of both the
 * kernels have.
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
struct RayTracedImageSettings;

class RayTracedDisplays
{
public:
  struct Display
  {
    vtkRayTracedMapper* Mapper = nullptr; // takes itself out before it goes
    vtkWeakPointer<vtkActor> Actor;
    rtg::Scene::SetId Set = 0;
    rtg::Material Material;
    rtg::PeriodicImages Images;
    bool Shown = false;       // in this frame
    bool Translucent = false; // and then in the translucent pass

    // In the kernels.
    std::uint64_t Scene = 0; // number of the kernels' scene that has the set; 0: none
    std::uint64_t SentInstances = 0, SentColors = 0, SentMaterial = 0;
    std::uint64_t MaterialVersion = 0;
  };

  /**
   * In the order in which they were added; those that are shown by their sets.
   */
  const std::vector<Display>& GetAll() const { return this->All; }
  const Display* Find(const vtkRayTracedMapper* mapper) const;
  std::map<rtg::Scene::SetId, vtkRayTracedMapper*> GetShownMappers() const;

  ///@{
  /**
   * Both may be called again. Remove() takes the glyphs out of the kernels' scene, too.
   */
  void Add(vtkActor* actor, vtkRayTracedMapper* mapper);
  void Remove(vtkRayTracedMapper* mapper, RayTracedImages& images);
  ///@}

  /**
   * Brings instances and colors of all visible displays up to date and, where the settings want it and all ranks render
   * together, receives from these what they have near. Returns whether the frame shows something else than the last one
   * did. `report` gets what could not be made.
   */
  bool Update(vtkRenderer* renderer, const RayTracedImageSettings& settings, bool collective, RayTracedImages& images,
    const std::function<void(const std::string&)>& report);

  /**
   * Grows with what is shown.
   */
  std::uint64_t GetVersion() const { return this->Version; }

  const RayTracedNeighbors& GetNeighbors() const { return this->Neighbors; }

  /**
   * Whether a pass (of rtg::Pass), or any, has something to draw.
   */
  bool Shows(int pass) const;
  bool ShowsAnything() const { return this->Shows(0) || this->Shows(1); }

  /**
   * Whether any display is visible, with or without data in this process.
   */
  bool AnyVisible() const;

  /**
   * Bounds of what the frame shows.
   */
  vtkBoundingBox ComputeShownBounds() const;

  /**
   * Hands the kernels' scene of that number what has changed since it had it.
   */
  void Commit(rtg::Scene& scene, std::uint64_t sceneNumber, vtkRenderer* renderer);

  /**
   * The scene's representations. Instances that the kernels have been handed are theirs; where they have been given
   * back they are built again, into `built`.
   */
  std::vector<RayTracedNeighbors::Shown>
  GetShown(RayTracedImages& images, std::vector<rtg::GlyphInstances>& built) const;

private:
  // Versions of instances, colors and material of each shown display, and that of the neighbors: two frames
  // with the same list draw the same picture.
  using Versions = std::vector<std::array<std::uint64_t, 3>>;

  Versions
  UpdateAll(vtkRenderer* renderer, RayTracedImages& images, const std::function<void(const std::string&)>& report);
  void ReportMessages(bool collective);
  rtg::Material GetMaterial(int display, vtkRenderer* renderer) const; // by its number

  std::vector<Display> All;
  std::uint64_t MaterialVersions = 0;
  RayTracedNeighbors Neighbors;
  Versions Shown;         // in the last frame
  Versions ShownToOthers; // when neighbors were last exchanged
  std::uint64_t Version = 0;
};

} // namespace rtglyphs

#endif
