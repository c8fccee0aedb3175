#include "vtkRayTracedGlyphCompanion.h"

#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

//----------------------------------------------------------------------------
vtkRayTracedGlyphCompanion::vtkRayTracedGlyphCompanion()
{
  this->Actor->SetMapper(this->Mapper);
  // Render passes tell the mapper through these keys what they want of its shader.
  vtkNew<vtkInformation> keys;
  this->Actor->SetPropertyKeys(keys);
  this->Actor->VisibilityOff();
  this->Mapper->ScalarVisibilityOff();
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::AddTo(vtkPVRenderView* view, vtkPVDataRepresentation* representation)
{
  view->GetRenderer()->AddActor(this->Actor);
  view->RegisterPropForHardwareSelection(representation, this->Actor);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::RemoveFrom(vtkPVRenderView* view, vtkPVDataRepresentation* representation)
{
  view->GetRenderer()->RemoveActor(this->Actor);
  view->UnRegisterPropForHardwareSelection(representation, this->Actor);
  this->Mapper->Leave(view->GetRenderer());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::Follow(
  vtkPolyData* points, vtkRayTracedGlyphMapper* leader, vtkActor* leadersActor)
{
  if (points != this->Mapper->GetInputDataObject(0, 0))
  {
    this->Mapper->SetInputDataObject(points);
  }
  this->Mapper->Blocks = leader->Blocks;
  this->Mapper->BlocksModified();
  this->Mapper->Light = leader->Light;
  this->Mapper->SetSamplesPerPixel(leader->GetSamplesPerPixel());
  this->Mapper->SetSamplesPerRender(leader->GetSamplesPerRender());
  this->Mapper->SetInteractiveReduction(leader->GetInteractiveReduction());
  this->Mapper->SetStepwiseRendering(leader->GetStepwiseRendering());
  this->Actor->GetProperty()->DeepCopy(leadersActor->GetProperty());
  vtkNew<vtkMatrix4x4> matrix;
  leadersActor->GetMatrix(matrix);
  this->Actor->SetUserMatrix(matrix);
  this->Actor->SetPickable(leadersActor->GetPickable());
  this->Actor->SetVisibility(leadersActor->GetVisibility());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::FollowColors(vtkRayTracedGlyphMapper* leader)
{
  this->Mapper->SetScalarVisibility(leader->GetScalarVisibility());
  this->Mapper->SelectColorArray(leader->GetArrayName());
  this->Mapper->SetUseLookupTableScalarRange(leader->GetUseLookupTableScalarRange());
  this->Mapper->SetScalarMode(leader->GetScalarMode());
  this->Mapper->SetColorMode(leader->GetColorMode());
  this->Mapper->SetInterpolateScalarsBeforeMapping(leader->GetInterpolateScalarsBeforeMapping());
  // Asked for its table, a mapper without one makes one.
  if (leader->GetScalarVisibility())
  {
    this->Mapper->SetLookupTable(leader->GetLookupTable());
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::Hide()
{
  this->Actor->VisibilityOff();
  this->Mapper->SetInputDataObject(nullptr);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphCompanion::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible && this->Mapper->GetInputDataObject(0, 0));
}
