#include "vtkSMRayTracedArrayDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMRayTracedArrayDomain);

//----------------------------------------------------------------------------
vtkSMRayTracedArrayDomain::vtkSMRayTracedArrayDomain() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedArrayDomain::~vtkSMRayTracedArrayDomain() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedArrayDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//----------------------------------------------------------------------------
int vtkSMRayTracedArrayDomain::GetAttributeType()
{
  vtkSMProxy* glyphs = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  if (glyphs && vtkSMPropertyHelper(glyphs, "GlyphLocation", /*quiet=*/true).GetAsInt() == 1)
  {
    return vtkSMInputArrayDomain::CELL;
  }
  vtkSMPropertyHelper input(this->GetProperty(), /*quiet=*/true);
  auto* source = this->GetProperty() && input.GetNumberOfElements() > 0
    ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy(0))
    : nullptr;
  if (source && source->GetOutputPortsCreated())
  {
    vtkPVDataInformation* data = source->GetDataInformation(input.GetOutputPort(0));
    const bool grid = data->GetDataSetType() == VTK_HYPER_TREE_GRID ||
      (data->IsCompositeDataSet() && data->HasDataSetType(VTK_HYPER_TREE_GRID));
    if (grid)
    {
      return vtkSMInputArrayDomain::CELL;
    }
  }
  return this->Superclass::GetAttributeType();
}
