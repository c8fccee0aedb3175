/**
 * @class   vtkRayTracedGlyphScene
 * @brief   all ray-traced glyphs of one renderer: what is traced together, and drawn as one image
 *
 * There is one scene a renderer, made when first asked for and gone when no mapper uses it any more. At the start of
 * every frame it looks which actors of its renderer have a vtkRayTracedGlyphMapper, and hands what has changed to the
 * kernels. The first of the actors to be drawn in a pass draws the image of all.
 *
 * Images are kept: nothing is traced when camera, lights, glyphs and size are those of the image at hand.
 *
 * Edges of glyphs are blended with what lies behind them, which must so be drawn before: the scene moves its actors
 * behind the others of the renderer.
 */
#ifndef vtkRayTracedGlyphScene_h
#define vtkRayTracedGlyphScene_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>

class vtkActor;
class vtkRayTracedGlyphMapper;
class vtkRenderer;
class vtkWindow;

class vtkRayTracedGlyphScene : public vtkObject
{
public:
  vtkTypeMacro(vtkRayTracedGlyphScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The scene of a renderer. Whoever asks keeps it alive.
   */
  static vtkSmartPointer<vtkRayTracedGlyphScene> Of(vtkRenderer* renderer);

  /**
   * Draws the image in the place of `actor`, once for all actors of the scene; for a selector, the ids of this actor.
   */
  void Render(vtkActor* actor, vtkRayTracedGlyphMapper* mapper);

  /**
   * Takes a mapper's glyphs out.
   */
  void Remove(vtkRayTracedGlyphMapper* mapper);

  void ReleaseGraphicsResources(vtkWindow* window);

  /**
   * Null when the renderer is gone.
   */
  vtkRenderer* GetRenderer() const { return this->Renderer; }

  ///@{
  /**
   * Information about the kernels: counters as JSON with those of one mapper, the device, samples a pixel of the
   * last image.
   */
  std::string GetStatistics(vtkRayTracedGlyphMapper* mapper);
  std::string GetDeviceName();
  int GetAccumulatedSamples();
  ///@}

protected:
  vtkRayTracedGlyphScene();
  ~vtkRayTracedGlyphScene() override;

private:
  vtkRayTracedGlyphScene(const vtkRayTracedGlyphScene&) = delete;
  void operator=(const vtkRayTracedGlyphScene&) = delete;
  static vtkRayTracedGlyphScene* New();

  void StartFrame();
  void DrawLast();
  void Synchronise();
  void Show(vtkActor* actor, vtkRayTracedGlyphMapper* mapper);
  bool UpdateImage(int pass, bool forIds);
  void WriteFeatures(const std::string& fileName, double eyeDepth);
  void DrawIds(vtkActor* actor, vtkRayTracedGlyphMapper* mapper);
  void Fail(const std::string& message);

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;

  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
