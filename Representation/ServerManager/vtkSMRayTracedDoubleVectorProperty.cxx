#include "vtkSMRayTracedDoubleVectorProperty.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRayTracedDoubleVectorProperty);

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::IsValueDefault()
{
  return this->Superclass::IsValueDefault() || vtkSMRayTracedDefault::IsAlias(this) ||
    (!vtkSMRayTracedDefault::IsShown(this) && this->Default.Has(this));
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::ResetToDomainDefaults(bool useUncheckedValues)
{
  const bool reset = this->Superclass::ResetToDomainDefaults(useUncheckedValues);
  if (reset && !useUncheckedValues)
  {
    this->Default.Remember(this);
  }
  return reset;
}
