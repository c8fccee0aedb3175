#include "vtkRayTracedProgress.h"

#include "vtkAlgorithm.h"
#include "vtkPVProgressHandler.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"

namespace
{
constexpr std::chrono::milliseconds quiet(300);
}

//----------------------------------------------------------------------------
vtkRayTracedProgress::vtkRayTracedProgress() = default;

//----------------------------------------------------------------------------
vtkRayTracedProgress::~vtkRayTracedProgress() = default;

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
    vtkProcessModule* module = vtkProcessModule::GetProcessModule();
    auto* session = module ? vtkPVSession::SafeDownCast(module->GetActiveSession()) : nullptr;
    if (session && session->GetProgressHandler())
    {
      session->GetProgressHandler()->RegisterProgressEvent(this->Teller, 0);
    }
    this->IsKnown = true;
  }
  this->Teller->SetProgressText(text);
  this->Teller->UpdateProgress(share);
}
