#include "vtkSMRayTracedInputProperty.h"

#include "vtkObjectFactory.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRayTracedDefault.h"

vtkStandardNewMacro(vtkSMRayTracedInputProperty);

//----------------------------------------------------------------------------
bool vtkSMRayTracedInputProperty::IsValueDefault()
{
  if (this->Superclass::IsValueDefault())
  {
    return true;
  }
  auto* list = this->FindDomain<vtkSMProxyListDomain>();
  return !vtkSMRayTracedDefault::IsShown(this) && list && list->GetNumberOfProxies() > 0 &&
    this->GetNumberOfProxies() == 1 && this->GetProxy(0) == list->GetProxy(0);
}
