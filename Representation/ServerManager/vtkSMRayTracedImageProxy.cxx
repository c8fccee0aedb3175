#include "vtkSMRayTracedImageProxy.h"

#include "vtkCommand.h"
#include "vtkCompositeRepresentation.h"
#include "vtkObjectFactory.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedDefault.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMSession.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <cstring>

vtkStandardNewMacro(vtkSMRayTracedImageProxy);

namespace
{
// What a display shows, when it is ray traced.
vtkRayTracedRepresentation* ShownBy(vtkSMProxy* display)
{
  auto* all = vtkCompositeRepresentation::SafeDownCast(display->GetClientSideObject());
  return all ? vtkRayTracedRepresentation::SafeDownCast(all->GetActiveRepresentation()) : nullptr;
}
}

//----------------------------------------------------------------------------
vtkSMRayTracedImageProxy::vtkSMRayTracedImageProxy()
{
  vtkSMRayTracedDefault::Register();
  this->AddObserver(vtkCommand::UpdatePropertyEvent, this, &vtkSMRayTracedImageProxy::Pushed);
}

//----------------------------------------------------------------------------
vtkSMRayTracedImageProxy::~vtkSMRayTracedImageProxy()
{
  if (this->View)
  {
    this->View->Remove(this);
  }
}

//----------------------------------------------------------------------------
vtkSMRayTracedImageProxy* vtkSMRayTracedImageProxy::Of(vtkSMProxy* display)
{
  vtkSMProperty* one = display ? display->GetProperty("ShadingMode") : nullptr;
  return one ? vtkSMRayTracedImageProxy::SafeDownCast(one->GetParent()) : nullptr;
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy* vtkSMRayTracedImageProxy::GetView()
{
  return this->View;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedImageProxy::IsShown()
{
  vtkRayTracedRepresentation* shown = ShownBy(this->GetTrueParentProxy());
  return shown && shown->GetVisibility();
}

//----------------------------------------------------------------------------
void vtkSMRayTracedImageProxy::EnterView(vtkSMProxy* view)
{
  if (!this->View || this->View->GetView() != view)
  {
    if (this->View)
    {
      this->View->Remove(this);
      this->View = nullptr;
    }
    this->View = vtkSMRayTracedViewProxy::Add(this, view);
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedImageProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  vtkSMProperty* property = this->View && flag ? this->GetProperty(name) : nullptr;
  if (property && !property->GetInformationOnly())
  {
    this->View->GetProperty(name)->Copy(property);
    if (this->GetSession()->IsProcessingRemoteNotification())
    {
      this->View->UpdateVTKObjects(); // another client has set it, and what it pushed was for its own view
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedImageProxy::Pushed(vtkObject*, unsigned long, void* name)
{
  if (this->View)
  {
    this->View->UpdateVTKObjects();
    vtkSMProperty* property = this->GetProperty(static_cast<const char*>(name));
    if (strcmp(property->GetClassName(), "vtkSMProperty") == 0)
    {
      this->View->InvokeCommand(static_cast<const char*>(name));
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedImageProxy::UpdatePropertyInformationInternal(vtkSMProperty*)
{
  if (this->View)
  {
    this->View->UpdateStatistics();
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedImageProxy::SetStatistics(const std::string& statistics)
{
  auto all = nlohmann::ordered_json::parse(statistics);
  vtkRayTracedRepresentation* shown = ShownBy(this->GetTrueParentProxy());
  const auto own = all.value("representations", all.object())
                     .value(std::to_string(shown ? shown->GetUniqueIdentifier() : 0), all.object());
  all.erase("representations");
  all.update(own);
  vtkSMPropertyHelper(this, "RenderStatistics").Set(all.dump().c_str());
}
