#include "vtkRayTracedProgress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVProgressHandler.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"

namespace
{
constexpr std::chrono::milliseconds quiet(300);

vtkPVProgressHandler* ActiveHandler()
{
  vtkProcessModule* module = vtkProcessModule::GetProcessModule();
  auto* session = module ? vtkPVSession::SafeDownCast(module->GetActiveSession()) : nullptr;
  return session ? session->GetProgressHandler() : nullptr;
}
}

//----------------------------------------------------------------------------
vtkRayTracedProgress::vtkRayTracedProgress()
{
  this->Before->SetClientData(this);
  this->Before->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      if (vtkOpenGLRenderWindow* window = static_cast<vtkRayTracedProgress*>(self)->Window)
      {
        window->GetState()->Push();
      }
    });
  this->After->SetClientData(this);
  this->After->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      if (vtkOpenGLRenderWindow* window = static_cast<vtkRayTracedProgress*>(self)->Window)
      {
        window->MakeCurrent();
        window->GetState()->Pop();
      }
    });
}

//----------------------------------------------------------------------------
vtkRayTracedProgress::~vtkRayTracedProgress()
{
  this->EndFrame();
}

//----------------------------------------------------------------------------
// Whoever paints listens with the priority 0.
void vtkRayTracedProgress::StartFrame(vtkRenderWindow* window)
{
  this->EndFrame();
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
  this->Handler = ActiveHandler();
  if (this->Handler)
  {
    this->Handler->AddObserver(vtkCommand::ProgressEvent, this->Before, 1.0f);
    this->Handler->AddObserver(vtkCommand::ProgressEvent, this->After, -1.0f);
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedProgress::EndFrame()
{
  if (this->Handler)
  {
    this->Handler->RemoveObserver(this->Before);
    this->Handler->RemoveObserver(this->After);
  }
  this->Handler = nullptr;
  this->Window = nullptr;
}

//----------------------------------------------------------------------------
void vtkRayTracedProgress::Start()
{
  this->Begin = std::chrono::steady_clock::now();
}

//----------------------------------------------------------------------------
void vtkRayTracedProgress::Tell(const char* text, double share)
{
  if (std::chrono::steady_clock::now() - this->Begin < quiet)
  {
    return;
  }
  if (!this->IsKnown)
  {
    if (vtkPVProgressHandler* handler = ActiveHandler())
    {
      handler->RegisterProgressEvent(this->Teller, 0);
    }
    this->IsKnown = true;
  }
  this->Teller->SetProgressText(text);
  this->Teller->UpdateProgress(share);
}
