#include "RayTracedFXAA.h"

#include "vtkFXAAOptions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFXAA::Disable(vtkRenderer* renderer)
{
  this->WasOn = renderer->GetUseFXAA();
  if (this->WasOn)
  {
    renderer->UseFXAAOff();
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFXAA::Restore(vtkRenderer* renderer)
{
  if (this->WasOn)
  {
    renderer->UseFXAAOn();
    this->WasOn = false;
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFXAA::Apply(vtkRenderer* renderer, const std::function<void(vtkTextureObject*)>& drawKept)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->WasOn || !glRenderer || !window)
  {
    return;
  }
  int size[2], corner[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  if (!this->Pixels->GetHandle() || static_cast<int>(this->Pixels->GetWidth()) != size[0] ||
    static_cast<int>(this->Pixels->GetHeight()) != size[1])
  {
    this->Pixels->SetContext(window);
    this->Pixels->Allocate2D(size[0], size[1], 4, VTK_UNSIGNED_CHAR);
    this->Pixels->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Pixels->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->Pixels->CopyFromFrameBuffer(corner[0], corner[1], 0, 0, size[0], size[1]);
  if (vtkFXAAOptions* options = renderer->GetFXAAOptions())
  {
    this->Filter->UpdateConfiguration(options);
  }
  this->Filter->Execute(glRenderer);
  drawKept(this->Pixels);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFXAA::ReleaseGraphicsResources()
{
  this->Filter->ReleaseGraphicsResources();
  this->Pixels->ReleaseGraphicsResources(this->Pixels->GetContext());
}
