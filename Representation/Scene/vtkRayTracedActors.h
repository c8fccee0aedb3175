/**
 * The two kinds of actors of a vtkRayTracedScene.
 */
#ifndef vtkRayTracedActors_h
#define vtkRayTracedActors_h

#include "vtkMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkPVLODActor.h"
#include "vtkWeakPointer.h"

class vtkRayTracedScene;

/**
 * Stands for one mapper of a scene: it is picked, moved and hidden, but draws nothing itself besides ids.
 */
class vtkRayTracedActor : public vtkPVLODActor
{
public:
  static vtkRayTracedActor* New();
  vtkTypeMacro(vtkRayTracedActor, vtkPVLODActor);

  ///@{
  /// The superclass chooses between two mappers, and renders another actor in its place.
  vtkMapper* GetMapper() override { return this->Mapper; }
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override { mapper->Render(renderer, this); }
  ///@}
  vtkTypeBool HasOpaqueGeometry() override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }

protected:
  vtkRayTracedActor() = default;
  ~vtkRayTracedActor() override = default;
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

  /// Called by exporters on the actors of a renderer; the scene then warns that it is not in the file.
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
  int Draw(vtkViewport* viewport, int pass);

  vtkWeakPointer<vtkRayTracedScene> Scene;
};

#endif
