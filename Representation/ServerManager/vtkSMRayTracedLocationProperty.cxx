#include "vtkSMRayTracedLocationProperty.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMRayTracedLocationProperty);

//----------------------------------------------------------------------------
bool vtkSMRayTracedLocationProperty::IsValueDefault()
{
  return this->Superclass::IsValueDefault() || (!vtkSMRayTracedDefault::IsShown(this) && this->Default.IsChosen(this));
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedLocationProperty::ResetToDomainDefaults(bool useUncheckedValues)
{
  const vtkSMPropertyHelper input(this->GetParent(), "Input", /*quiet=*/true);
  auto* source = input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  vtkPVDataInformation* data =
    source && source->GetOutputPortsCreated() ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
  const bool ofCells = data &&
    !vtkSMRayTracedArrayListDomain::HasDirectionsOrTensors(data->GetPointDataInformation()) &&
    vtkSMRayTracedArrayListDomain::HasDirectionsOrTensors(data->GetCellDataInformation());
  if (data)
  {
    vtkSMPropertyHelper helper(this);
    helper.SetUseUnchecked(useUncheckedValues);
    helper.Set(ofCells ? 1 : 0);
  }
  return useUncheckedValues ? data != nullptr : this->Default.Take(this, ofCells) || data;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedLocationProperty::Modified()
{
  this->Default.Modify();
  this->Superclass::Modified();
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedLocationProperty::RenewDefault(vtkSMRayTracedDefault::Where where)
{
  return this->Default.Renew(this, where);
}
