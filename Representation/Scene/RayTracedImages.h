/**
 * The kernels' side of a vtkRayTracedScene: device, glyph sets, and the images that are kept. There is one image for
 * each pass and place that a renderer draws to: eyes of a stereo pair, tiles, a capture of another size than the
 * window's.
 */
#ifndef RayTracedImages_h
#define RayTracedImages_h

#include "ProgressiveImage.h"
#include "Scene.h"
#include "ScreenEffects.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include "RayTracedImageQuad.h"

#include <array>
#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <utility>

class vtkActor;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace rtglyphs
{

class RayTracedImages
{
public:
  static constexpr int Passes = 2; // opaque, translucent: as rtg::Pass

  // Where an image is drawn.
  struct Place
  {
    int Pass = 0;
    std::uint32_t Width = 0, Height = 0; // pixels
    int Eye = 0;                         // vtkCamera::GetLeftEye()
    std::array<double, 4> Tile{};        // vtkWindow::GetTileViewport()
    bool OnlyIds = false;                // for selecting, of no light
    auto operator<=>(const Place&) const = default;
  };
  /**
   * `commit` brings the kernels' scene of that number up to date; it may throw.
   */
  using Commit = std::function<void(rtg::Scene& scene, std::uint64_t number)>;
  explicit RayTracedImages(Commit commit)
    : CommitTo(std::move(commit))
  {
  }

  struct Entry
  {
    rtg::ProgressiveImage Image;
    std::unique_ptr<rtg::Tracer> Tracer, PreviewTracer;
    std::uint64_t SceneNumber = 0; // of the scene that the tracer traces
    RayTracedImageQuad Quad;
    rtg::ScreenEffects Effects; // of the picture that the quad has
    std::uint64_t LastUsed = 0; // the frame
    bool Capture = true;        // was used for nothing but pictures that are not shown
    std::uint64_t Drawn = 0;    // the frame in which the quad was drawn; 0: none
    std::uint64_t Shown = 0;    // the frame that its picture is of
  };

  /**
   * Images that no frame of late has used make room; in captures only those of captures, because the window goes on
   * with its own.
   */
  void StartFrame(bool capture);

  /**
   * The image of a place.
   */
  Entry& Get(const Place& place);

  /**
   * The image of a pass that shows this view in full resolution, in any shading mode; null: there is none.
   */
  Entry* FindSame(const rtg::ImageView& view);

  /**
   * Images that the last frame at this place drew, by pass; null: none.
   */
  std::array<Entry*, Passes> GetLast(Place place);

  /**
   * Gives the entry's quad the image with these effects.
   */
  void Send(Entry& entry, const rtg::Image& image, const rtg::ScreenEffects& effects, vtkOpenGLRenderWindow* window);

  ///@{
  /**
   * Draws an entry's quad, with the picture of this frame or, `again`, of the last one; and what is left to draw of all
   * quads that this frame has drawn.
   */
  void Draw(Entry& entry, bool again, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);
  void DrawKept(vtkRenderer* renderer, vtkTextureObject* pixels);
  ///@}

  /**
   * Makes or improves an entry's image, after handing the kernels what has changed since they last had it; null: it
   * failed.
   */
  const rtg::Image*
  Update(Entry& entry, const rtg::ImageView& view, const rtg::ImageEffort& effort, const rtg::Interrupt& interrupt);

  ///@{
  /**
   * Gives device memory back, but for counters and compiled programs. The number of the scene grows with each new one,
   * whose sets are empty.
   */
  void DropImages();
  std::uint64_t GetSceneNumber() const { return this->SceneNumber; }
  rtg::Scene* GetScene() { return this->Scene.get(); }
  ///@}

  rtg::Statistics GetStatistics() const;
  std::string GetDeviceName() const { return this->Device ? this->Device->Name() : std::string(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Source;

  const Commit CommitTo;
  std::shared_ptr<rtg::Device> Device;
  std::unique_ptr<rtg::Scene> Scene;
  std::shared_ptr<rtg::TracerResources> Resources;
  std::uint64_t SceneNumber = 0, Frame = 0;
  bool Capture = false; // this frame
  std::map<Place, std::unique_ptr<Entry>> Entries;
  const std::shared_ptr<rtg::Statistics> Counters = std::make_shared<rtg::Statistics>();
};

} // namespace rtglyphs

#endif
