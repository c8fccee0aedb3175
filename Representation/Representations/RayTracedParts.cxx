#include "RayTracedParts.h"

#include "RayTracedNumbers.h"
#include "vtkMatrix4x4.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkProperty.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//----------------------------------------------------------------------------
void rtglyphs::RayTracedParts::Add(
  vtkPVDataRepresentation* owner, vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
{
  actor->SetMapper(mapper);
  view->GetRenderer()->AddActor(actor);
  view->RegisterPropForHardwareSelection(owner, actor);
  mapper->SetBuildProgress(this->Progress);
  mapper->SetSection(this->Section);
  mapper->SetImages(this->Images);
  vtkRayTracedScene::Of(view->GetRenderer())->Add(actor, mapper);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedParts::Remove(
  vtkPVDataRepresentation* owner, vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper)
{
  vtkRayTracedScene::Of(view->GetRenderer())->Remove(mapper);
  view->UnRegisterPropForHardwareSelection(owner, actor);
  view->GetRenderer()->RemoveActor(actor);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedParts::Copy(vtkActor* from, vtkActor* to)
{
  to->GetProperty()->DeepCopy(from->GetProperty());
  to->GetProperty()->SetAmbientColor(from->GetProperty()->GetAmbientColor()); // which VTK 9.6 does not copy
  vtkNew<vtkMatrix4x4> matrix;
  from->GetMatrix(matrix);
  const double* elements = matrix->GetData();
  if (!std::all_of(elements, elements + 16, [](double element) { return std::isfinite(element); }))
  {
    matrix->Identity();
  }
  to->SetUserMatrix(matrix);
  to->SetPickable(from->GetPickable());
  to->SetVisibility(from->GetVisibility());
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedParts::UpdateActor(vtkActor* actor)
{
  using namespace rtglyphs::RayTracedNumbers;
  Copy(actor, this->Actor);
  vtkProperty* property = this->Actor->GetProperty();
  property->SetOpacity(NumberOr(property->GetOpacity(), 1.0));
  property->SetAmbient(NumberOr(property->GetAmbient(), 0.0));
  property->SetDiffuse(NumberOr(property->GetDiffuse(), 1.0));
  property->SetSpecular(NumberOr(property->GetSpecular(), 0.0));
  property->SetSpecularPower(NumberOr(property->GetSpecularPower(), 100.0));
  property->SetMetallic(NumberOr(property->GetMetallic(), 0.0));
  property->SetRoughness(NumberOr(property->GetRoughness(), 0.5));
  property->SetCoatStrength(NumberOr(property->GetCoatStrength(), 0.0));
  property->SetCoatIOR(NumberOr(property->GetCoatIOR(), 2.0));
  property->SetCoatRoughness(NumberOr(property->GetCoatRoughness(), 0.0));
  const auto inRange = [](const double* color) { return ColorInRange(color[0], color[1], color[2]); };
  property->SetAmbientColor(inRange(property->GetAmbientColor()).data());
  property->SetDiffuseColor(inRange(property->GetDiffuseColor()).data());
  property->SetSpecularColor(inRange(property->GetSpecularColor()).data());
  property->SetCoatColor(inRange(property->GetCoatColor()).data());
}
