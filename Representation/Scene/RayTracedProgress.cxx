#include "RayTracedProgress.h"

#include "RayTracedOpenGLState.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
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
rtglyphs::RayTracedProgress::RayTracedProgress()
{
  this->Before->SetClientData(this);
  this->Before->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      if (vtkOpenGLRenderWindow* window = static_cast<rtglyphs::RayTracedProgress*>(self)->Window)
      {
        rtglyphs::RayTracedOpenGLState::Save(window);
      }
    });
  this->After->SetClientData(this);
  this->After->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      if (vtkOpenGLRenderWindow* window = static_cast<rtglyphs::RayTracedProgress*>(self)->Window)
      {
        rtglyphs::RayTracedOpenGLState::Restore(window);
      }
    });
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedProgress::~RayTracedProgress()
{
  this->EndFrame();
}

//----------------------------------------------------------------------------
// Observers that paint have the priority 0.
void rtglyphs::RayTracedProgress::StartFrame(vtkRenderWindow* window)
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
void rtglyphs::RayTracedProgress::EndFrame()
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
void rtglyphs::RayTracedProgress::Report(const char* text, double share)
{
  if (std::chrono::steady_clock::now() - this->Begin < quiet)
  {
    return;
  }
  if (!this->IsKnown)
  {
    if (vtkPVProgressHandler* handler = ActiveHandler())
    {
      handler->RegisterProgressEvent(this->Reporter, 0);
    }
    this->IsKnown = true;
  }
  this->Reporter->SetProgressText(text);
  this->Reporter->UpdateProgress(share);
}
