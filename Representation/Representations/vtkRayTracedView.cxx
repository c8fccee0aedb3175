#include "vtkRayTracedView.h"

#include "RayTracedRanks.h"
#include "Vulkan/Device.h"
#include "vtkCamera.h"
#include "vtkCommunicator.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkRayTracedScene.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkRayTracedView);

//----------------------------------------------------------------------------
void vtkRayTracedView::SetView(vtkPVView* view)
{
  this->View = vtkPVRenderView::SafeDownCast(view);
  this->Apply();
}

//----------------------------------------------------------------------------
// Null: this process does not have the view.
vtkRayTracedScene* vtkRayTracedView::GetScene() const
{
  return this->View ? vtkRayTracedScene::Of(this->View->GetRenderer()) : nullptr;
}

//----------------------------------------------------------------------------
void vtkRayTracedView::Apply()
{
  if (vtkRayTracedScene* scene = this->GetScene())
  {
    scene->SetSettings(this->Settings.InRange());
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedView::SetParallelLight(int light)
{
  const bool wasReplicated = this->Settings.IsReplicated();
  this->Set(this->Settings.ParallelLight, light);
  if (this->View && this->Settings.IsReplicated() != wasReplicated)
  {
    for (int i = 0; i < this->View->GetNumberOfRepresentations(); ++i)
    {
      if (auto* shown = vtkRayTracedRepresentation::SafeDownCast(this->View->GetRepresentation(i)))
      {
        shown->MarkModified(); // the points must be delivered again
      }
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedView::SaveFeatureImage(const char* fileName)
{
  if (vtkRayTracedScene* scene = this->GetScene())
  {
    scene->SaveFeatureImage(fileName ? fileName : "");
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedView::StopRefinement()
{
  if (vtkRayTracedScene* scene = this->GetScene())
  {
    scene->Stop();
  }
}

//----------------------------------------------------------------------------
const char* vtkRayTracedView::GetRenderStatistics()
{
  vtkRayTracedScene* scene = this->GetScene();
  this->Statistics = scene ? scene->GetStatistics() : "{}";
  return this->Statistics.c_str();
}

//----------------------------------------------------------------------------
const char* vtkRayTracedView::FindPlace(int x, int y)
{
  vtkRayTracedScene* scene = this->GetScene();
  double place[3];
  double distance = HUGE_VAL;
  if (scene && scene->PlaceAt(x, y, place))
  {
    vtkCamera* camera = this->View->GetActiveCamera();
    double offset[3];
    vtkMath::Subtract(place, camera->GetPosition(), offset);
    distance = vtkMath::Dot(offset, camera->GetDirectionOfProjection());
  }
  std::vector<double> nearest{ distance };
  rtglyphs::RayTracedRanks::Reduce(nearest, vtkCommunicator::MIN_OP);
  std::vector<double> found(3, HUGE_VAL);
  if (distance == nearest[0] && distance < HUGE_VAL)
  {
    found.assign(place, place + 3);
  }
  rtglyphs::RayTracedRanks::Reduce(found, vtkCommunicator::MIN_OP);
  this->Place = nlohmann::json(found[0] < HUGE_VAL ? found : std::vector<double>()).dump();
  return this->Place.c_str();
}

//----------------------------------------------------------------------------
bool vtkRayTracedView::FindDevice(std::string& words)
{
  try
  {
    const rtg::Device::Choice chosen = rtg::Device::Chosen();
    words = "Ray Traced Glyphs: this computer traces with '" + chosen.name + "'" +
      (chosen.cpu ? ", its processor; RTGLYPHS_DEVICE chooses another Vulkan device." : ".");
    return true;
  }
  catch (const rtg::Error& error)
  {
    words = error.what();
    return false;
  }
}
