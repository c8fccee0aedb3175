/**
 * The two kinds of actors of a vtkRayTracedScene.
 */
#ifndef vtkRayTracedActors_h
#define vtkRayTracedActors_h

#include "vtkOpenGLActor.h"
#include "vtkWeakPointer.h"

class vtkRayTracedScene;

/**
 * Stands for one mapper of a scene: it is picked, moved and hidden, but draws nothing itself besides ids.
 */
class vtkRayTracedActor : public vtkOpenGLActor
{
public:
  static vtkRayTracedActor* New();
  vtkTypeMacro(vtkRayTracedActor, vtkOpenGLActor);

  vtkTypeBool HasOpaqueGeometry() override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }

protected:
  vtkRayTracedActor() = default;
  ~vtkRayTracedActor() override = default;

private:
  vtkRayTracedActor(const vtkRayTracedActor&) = delete;
  void operator=(const vtkRayTracedActor&) = delete;
};

/**
 * Draws the image of a scene.
 */
class vtkRayTracedImageActor : public vtkOpenGLActor
{
public:
  static vtkRayTracedImageActor* New();
  vtkTypeMacro(vtkRayTracedImageActor, vtkOpenGLActor);

  void SetScene(vtkRayTracedScene* scene);

  /// What exporters ask the actors of a renderer for; the scene then says that it is not in the file.
  vtkMapper* GetMapper() override;

  vtkTypeBool HasOpaqueGeometry() override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  double* GetBounds() override { return nullptr; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRayTracedImageActor();
  ~vtkRayTracedImageActor() override = default;

private:
  vtkRayTracedImageActor(const vtkRayTracedImageActor&) = delete;
  void operator=(const vtkRayTracedImageActor&) = delete;
  int Draw(vtkViewport* viewport, int pass);

  vtkWeakPointer<vtkRayTracedScene> Scene;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedActors.h
