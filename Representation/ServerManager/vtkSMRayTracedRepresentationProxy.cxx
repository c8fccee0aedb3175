#include "vtkSMRayTracedRepresentationProxy.h"

#include "RayTracedDomains.h"
#include "RayTracedPanel.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkRayTracedSelectionEncoder.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <cstring>
#include <utility>

vtkStandardNewMacro(vtkSMRayTracedRepresentationProxy);

//----------------------------------------------------------------------------
vtkSMRayTracedRepresentationProxy::vtkSMRayTracedRepresentationProxy()
{
  vtkRayTracedSelectionEncoder::Register();
  rtglyphs::RayTracedDomains::Register();
}

//----------------------------------------------------------------------------
// At most one of a display's representations is visible.
bool vtkSMRayTracedRepresentationProxy::IsShown()
{
  auto* local = vtkRayTracedRepresentation::SafeDownCast(this->GetClientSideObject());
  return local && local->GetVisibility();
}

//----------------------------------------------------------------------------
// Information on the data comes from the processes that have them.
void vtkSMRayTracedRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  vtkSMProperty* statistics = this->GetProperty("RenderStatistics");
  if (property != statistics && this->IsShown())
  {
    const vtkTypeUInt32 everywhere = this->Location;
    this->Location = vtkPVSession::DATA_SERVER_ROOT;
    this->Superclass::UpdatePropertyInformationInternal(property);
    this->Location = everywhere;
  }
  if ((!property || property == statistics) && this->View)
  {
    this->View->UpdateStatistics();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  const bool byUser = flag && this->Choices.PropertyChanging(this, name);
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  if (flag && strcmp(name, "Input") == 0)
  {
    this->ConnectMolecule();
    this->ConnectSelection();
  }
  if (flag)
  {
    this->Choices.PropertyChanged(this, name, byUser);
  }
}

//----------------------------------------------------------------------------
// Of a molecule's data information ParaView's domains know neither bounds nor arrays: the input, also of what only
// holds properties, is what Molecule To Lines makes of it.
void vtkSMRayTracedRepresentationProxy::ConnectMolecule()
{
  vtkSMProxy* display = this->GetTrueParentProxy();
  const vtkSMPropertyHelper molecule(display, "Input", /*quiet=*/true);
  const bool taken = vtkSMPropertyHelper(this, "Input").GetAsProxy() == this->AtomsAndBonds;
  if (strcmp(display->GetXMLName(), "PVMoleculeRepresentation") != 0 || molecule.GetNumberOfElements() == 0 || taken)
  {
    return;
  }
  if (!this->AtomsAndBonds)
  {
    this->AtomsAndBonds.TakeReference(
      vtkSMSourceProxy::SafeDownCast(this->GetSessionProxyManager()->NewProxy("filters", "MoleculeToLines")));
  }
  vtkSMPropertyHelper(this->AtomsAndBonds, "Input").Set(molecule.GetAsProxy(), molecule.GetOutputPort());
  this->AtomsAndBonds->UpdateVTKObjects();
  for (vtkSMProxy* proxy : { static_cast<vtkSMProxy*>(this), display->GetProperty("ScaleMode")->GetParent() })
  {
    vtkSMPropertyHelper(proxy, "Input").Set(this->AtomsAndBonds); // pushed after the display has pushed the molecule
  }
  this->GetProperty("ColorArrayName")->Copy(display->GetProperty("ColorArrayName")); // links pass no defaults on
}

//----------------------------------------------------------------------------
// ParaView's filter that extracts what is selected of the input; with it as an input a display is brought up to date,
// on all processes, when the selection changes.
void vtkSMRayTracedRepresentationProxy::ConnectSelection()
{
  const vtkSMPropertyHelper input(this, "Input");
  if (auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()))
  {
    source->CreateSelectionProxies();
    vtkSMPropertyHelper(this, "SelectedData").Set(source->GetSelectionOutput(input.GetOutputPort()));
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  vtkSMProxy* display = this->GetTrueParentProxy();
  if (!vtkSMRenderViewProxy::SafeDownCast(consumer) || (this->View && this->View->GetView() == consumer))
  {
    return;
  }
  if (this->View)
  {
    this->View->Remove(display);
  }
  const bool entered = !this->View;
  this->View = vtkSMRayTracedViewProxy::Add(display, consumer);
  if (entered)
  {
    display->GetProperty("Representation")
      ->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMRayTracedRepresentationProxy::ChooseDefaults);
    rtglyphs::RayTracedPanel::Show(display);
    this->ChooseDefaults();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::ChooseDefaults()
{
  if (vtkSMProxy* view = this->AtomsAndBonds ? this->View->GetView() : nullptr)
  {
    this->AtomsAndBonds->UpdatePipeline(vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
  }
  this->Choices.Choose(this);
}

//----------------------------------------------------------------------------
void vtkSMRayTracedRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  const bool shown = this->IsShown();
  const double time = vtkSMPropertyHelper(view, "ViewTime", /*quiet=*/true).GetAsDouble();
  if (shown && this->Choices.Renew(this, std::exchange(this->Time, time) != time))
  {
    this->GetTrueParentProxy()->UpdateVTKObjects();
    vtkSMViewProxy::SafeDownCast(view)->Update();
  }
  this->Choices.Update(this, view, shown);
}
