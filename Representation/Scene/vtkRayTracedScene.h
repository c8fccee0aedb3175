/**
 * @class   vtkRayTracedScene
 * @brief   everything ray-traced in one renderer: what is traced together, and drawn as one image
 *
 * A renderer has at most one scene. The view's settings are those of its vtkRayTracedView. Representations add their
 * actors and mappers; an actor of the scene's own draws the image, behind the other actors of the
 * renderer, because anti-aliased edges are blended with what lies behind them. The actors that were added draw only
 * ids, for a selector.
 *
 * At the start of every frame the mappers of visible actors bring instances and colors up to date; what changed is
 * handed to the kernels when an image needs it. A mapper that is hidden gives its device memory back. Images are kept
 * (RayTracedImages), and each decides by itself what is to be traced (rtg::ProgressiveImage). While a program is
 * compiled that one of them needs, the last frame is drawn again if the camera sees the same.
 */
#ifndef vtkRayTracedScene_h
#define vtkRayTracedScene_h

#include "Glyphs.h"
#include "RayTracedImageSettings.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>

namespace rtg
{
class ProgressiveImage;
}
class vtkActor;
class vtkMapper;
class vtkInformationObjectBaseKey;
class vtkRayTracedMapper;
class vtkRenderer;
class vtkWindow;

class vtkRayTracedScene : public vtkObject
{
public:
  vtkTypeMacro(vtkRayTracedScene, vtkObject);

  ///@{
  /**
   * The scene of a renderer, which keeps it. Find() makes none.
   */
  static vtkRayTracedScene* Of(vtkRenderer* renderer);
  static vtkRayTracedScene* Find(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Adds an actor, which the renderer has, with its mapper; or takes the mapper out. Both may be called again.
   */
  void Add(vtkActor* actor, vtkRayTracedMapper* mapper);
  void Remove(vtkRayTracedMapper* mapper);
  ///@}

  ///@{
  /**
   * The view's settings, in range.
   */
  void SetSettings(const rtglyphs::RayTracedImageSettings& settings);
  const rtglyphs::RayTracedImageSettings& GetSettings() const;
  ///@}

  /**
   * Purpose of the next frames. `capture`: pictures that ParaView takes without showing them, and only once: each has
   * all samples. `collective`: all ranks render them together. `ordered`: what they draw is blended in the order in
   * which their data lie, and not put together by depth.
   */
  void SetFrameKind(bool capture, bool collective, bool ordered);

  ///@{
  /**
   * Says that the next frame shows something preliminary, and another one must follow. And whether the last frame did
   * not wait for programs.
   */
  void ExpectAnother();
  bool HasPicture() const;
  ///@}

  /**
   * The next finished image also leaves a file; see WriteFeatureImage.
   */
  void SaveFeatureImage(const std::string& fileName);

  /**
   * Images that are not finished stay as they are until something else changes them.
   */
  void Stop();

  ///@{
  /**
   * For the scene's own actor: whether a pass (of rtg::Pass) has something to draw, and drawing it.
   */
  bool HasPass(int pass) const;
  void DrawImage(int pass, vtkActor* imageActor, vtkMapper* mapper);
  ///@}

  /**
   * For the scene's own actor, when all else of the frame is drawn: the view's FXAA, but for the image.
   */
  void SmoothFrame();

  /**
   * Draws a number in the place of each of the actor's pixels, 24 bits of it, as the renderer's selector needs.
   */
  void DrawIds(vtkActor* actor, vtkRayTracedMapper* mapper);

  /**
   * The point of the nearest ray-traced surface, of any display, that the camera sees in a pixel of the renderer;
   * false: none.
   */
  bool PlaceAt(int x, int y, double place[3]);

  /**
   * Visits the representations of the last frame, for exporters.
   */
  void ForEachShown(
    const std::function<void(const rtg::GlyphInstances&, const rtg::GlyphColors&, const rtg::Material&)>& visit);

  /**
   * Warns, once after each frame, that exporters leave ray-traced displays out.
   */
  void ReportExport();

  void ReleaseGraphicsResources(vtkWindow* window);

  /**
   * Information as JSON; see RayTracedFrameStatus.
   */
  std::string GetStatistics();

  /// Key of the scene in a renderer's information.
  static vtkInformationObjectBaseKey* SCENE();

protected:
  vtkRayTracedScene();
  ~vtkRayTracedScene() override;

private:
  static vtkRayTracedScene* New();

  void DisableFXAA();
  void StartFrame();
  void EndFrame();
  void Report(const std::string& message, std::string what = {});
  void ReportFailure(const rtg::ProgressiveImage& image);
  void CheckImage(const rtg::ProgressiveImage& image, bool failed);
  void ExchangeEdges();

  vtkWeakPointer<vtkRenderer> Renderer;

  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
