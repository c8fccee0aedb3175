#include "vtkSMRayTracedGlyphRepresentationProxy.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkRayTracedGlyphRepresentation.h"

vtkStandardNewMacro(vtkSMRayTracedGlyphRepresentationProxy);

//----------------------------------------------------------------------------
vtkSMRayTracedGlyphRepresentationProxy::vtkSMRayTracedGlyphRepresentationProxy() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedGlyphRepresentationProxy::~vtkSMRayTracedGlyphRepresentationProxy() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedGlyphRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedGlyphRepresentationProxy::UpdatePropertyInformationInternal(
  vtkSMProperty* property)
{
  this->CreateVTKObjects();
  auto* local = vtkRayTracedGlyphRepresentation::SafeDownCast(this->GetClientSideObject());
  const vtkTypeUInt32 everywhere = this->Location;
  if (everywhere != 0 && local && local->GetRenderedRemotely())
  {
    this->Location = vtkPVSession::RENDER_SERVER_ROOT;
  }
  this->Superclass::UpdatePropertyInformationInternal(property);
  this->Location = everywhere;
}
