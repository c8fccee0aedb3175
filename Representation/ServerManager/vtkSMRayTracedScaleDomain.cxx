#include "vtkSMRayTracedScaleDomain.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <vector>

vtkStandardNewMacro(vtkSMRayTracedScaleDomain);

//----------------------------------------------------------------------------
vtkSMRayTracedScaleDomain::vtkSMRayTracedScaleDomain() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedScaleDomain::~vtkSMRayTracedScaleDomain() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedScaleDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedScaleDomain::Update(vtkSMProperty*)
{
  vtkSMProperty* guess = this->GetRequiredProperty("Guess");
  const double factor = guess ? vtkSMPropertyHelper(guess).GetAsDouble() : 0.0;
  this->SetEntries(std::vector<vtkEntry>{ vtkEntry(0.0, factor > 0.0 ? 4.0 * factor : 1.0) });
}

//----------------------------------------------------------------------------
int vtkSMRayTracedScaleDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  vtkSMProperty* fromData = this->GetRequiredProperty("FromData");
  if (!fromData)
  {
    return 0;
  }
  if (vtkSMPropertyHelper(fromData).GetAsInt() == 1)
  {
    fromData->Modified(); // so that the data are asked again
  }
  else
  {
    vtkSMPropertyHelper(fromData).Set(1);
  }
  if (useUncheckedValues && property->GetParent())
  {
    property->GetParent()->UpdateVTKObjects(); // the panel only takes over what it finds unchecked
  }
  return 1;
}
