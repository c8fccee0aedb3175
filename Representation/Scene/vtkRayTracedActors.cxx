#include "vtkRayTracedActors.h"

#include "Tracer.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkRayTracedActor);
vtkStandardNewMacro(vtkRayTracedImageActor);

//----------------------------------------------------------------------------
vtkRayTracedImageActor::vtkRayTracedImageActor()
{
  this->PickableOff();
  this->UseBoundsOff();
  // Exporters want a mapper; this one has nothing to write.
  vtkNew<vtkPolyDataMapper> nothing;
  nothing->StaticOn(); // or it complains that it has no input
  this->SetMapper(nothing);
  // Render passes say through these keys what they want of the shader.
  vtkNew<vtkInformation> keys;
  this->SetPropertyKeys(keys);
}

//----------------------------------------------------------------------------
void vtkRayTracedImageActor::SetScene(vtkRayTracedScene* scene)
{
  this->Scene = scene;
}

//----------------------------------------------------------------------------
// Not called while the view is rendered: an actor that draws by itself needs no mapper.
vtkMapper* vtkRayTracedImageActor::GetMapper()
{
  if (this->Scene)
  {
    this->Scene->ReportExport();
  }
  return this->Superclass::GetMapper();
}

//----------------------------------------------------------------------------
vtkTypeBool vtkRayTracedImageActor::HasOpaqueGeometry()
{
  return this->Scene && this->Scene->HasPass(static_cast<int>(rtg::Pass::Opaque));
}

//----------------------------------------------------------------------------
vtkTypeBool vtkRayTracedImageActor::HasTranslucentPolygonalGeometry()
{
  return this->Scene && this->Scene->HasPass(static_cast<int>(rtg::Pass::Translucent));
}

//----------------------------------------------------------------------------
int vtkRayTracedImageActor::Draw(vtkViewport* viewport, int pass)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!this->Scene || !renderer || renderer->GetSelector() || !this->Scene->HasPass(pass))
  {
    return 0;
  }
  this->Scene->DrawImage(pass, this, this->Mapper);
  return 1;
}

//----------------------------------------------------------------------------
int vtkRayTracedImageActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return this->Draw(viewport, static_cast<int>(rtg::Pass::Opaque));
}

//----------------------------------------------------------------------------
int vtkRayTracedImageActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  this->SetIsRenderingTranslucentPolygonalGeometry(true);
  const int drawn = this->Draw(viewport, static_cast<int>(rtg::Pass::Translucent));
  this->SetIsRenderingTranslucentPolygonalGeometry(false);
  return drawn;
}

//----------------------------------------------------------------------------
int vtkRayTracedImageActor::RenderOverlay(vtkViewport*)
{
  if (this->Scene)
  {
    this->Scene->SmoothFrame();
  }
  return 0;
}

//----------------------------------------------------------------------------
void vtkRayTracedImageActor::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Scene)
  {
    this->Scene->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
