#include "vtkSMRayTracedDoubleVectorProperty.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <string>

vtkStandardNewMacro(vtkSMRayTracedDoubleVectorProperty);

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::IsValueDefault()
{
  return this->Superclass::IsValueDefault() || this->IsFromData() || this->Default.IsChosen(this);
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::ResetToDomainDefaults(bool useUncheckedValues)
{
  const bool reset = this->Superclass::ResetToDomainDefaults(useUncheckedValues);
  return useUncheckedValues ? reset : this->Default.Take(this, reset);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedDoubleVectorProperty::Modified()
{
  this->Default.Modify();
  this->Superclass::Modified();
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::RenewDefault(vtkSMRayTracedDefault::Where where)
{
  return this->Default.Renew(this, where);
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDoubleVectorProperty::IsFromData()
{
  const std::string name = std::string(this->GetXMLName() ? this->GetXMLName() : "") + "FromData";
  vtkSMProperty* fromData = this->GetParent() ? this->GetParent()->GetProperty(name.c_str()) : nullptr;
  return fromData && vtkSMPropertyHelper(fromData).GetAsInt() != 0;
}
