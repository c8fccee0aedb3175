#include "vtkSMRayTracedRadiusDomain.h"

#include "Finite.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSMRayTracedRadiusDomain);

//----------------------------------------------------------------------------
vtkSMRayTracedRadiusDomain::vtkSMRayTracedRadiusDomain() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedRadiusDomain::~vtkSMRayTracedRadiusDomain() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedRadiusDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Suggested: " << this->Suggested << endl;
}

//----------------------------------------------------------------------------
// Of the array of points of that name, or else of cells; 1 where there is none.
double vtkSMRayTracedRadiusDomain::LargestValue()
{
  vtkSMProperty* named = this->GetRequiredProperty("Array");
  const char* name = named ? vtkSMPropertyHelper(named).GetAsString() : nullptr;
  vtkPVDataInformation* data = this->GetInputInformation();
  vtkPVArrayInformation* array = nullptr;
  if (data && name)
  {
    array = data->GetPointDataInformation()->GetArrayInformation(name);
    array = array ? array : data->GetCellDataInformation()->GetArrayInformation(name);
  }
  const double* range = array ? array->GetComponentRange(0) : nullptr;
  const double largest = range ? std::max(std::abs(range[0]), std::abs(range[1])) : 1.0;
  return rtg::IsPositive(largest) ? largest : 1.0;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRadiusDomain::Update(vtkSMProperty*)
{
  vtkPVDataInformation* data = this->GetInputInformation();
  double longest = 0.0;
  if (data)
  {
    const double* bounds = data->GetBounds();
    longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  }
  this->Suggested = rtg::IsPositive(longest) ? this->GetScaleFactor() * longest / this->LargestValue() : 0.0;
  this->SetEntries(std::vector<vtkEntry>{ vtkEntry(0.0, this->Suggested > 0.0 ? 4.0 * this->Suggested : 1.0) });
}

//----------------------------------------------------------------------------
int vtkSMRayTracedRadiusDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  this->Update(nullptr); // the array may have changed just now
  if (!(this->Suggested > 0.0))
  {
    return 0;
  }
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUncheckedValues);
  helper.Set(this->Suggested);
  return 1;
}
