#include "vtkSMRayTracedStringVectorProperty.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRayTracedStringVectorProperty);

//----------------------------------------------------------------------------
bool vtkSMRayTracedStringVectorProperty::IsValueDefault()
{
  return this->Superclass::IsValueDefault() || (!vtkSMRayTracedDefault::IsShown(this) && this->Default.Has(this));
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedStringVectorProperty::ResetToDomainDefaults(bool useUncheckedValues)
{
  const bool reset = this->Superclass::ResetToDomainDefaults(useUncheckedValues);
  return useUncheckedValues ? reset : this->Default.Take(this, reset);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedStringVectorProperty::Modified()
{
  this->Default.Modify();
  this->Superclass::Modified();
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedStringVectorProperty::RenewDefault(vtkSMRayTracedDefault::Where where)
{
  return this->Default.Renew(this, where);
}
