#include "vtkSMRayTracedPickingHelperProxy.h"

#include "vtkInteractorObserver.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkRenderer.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRayTracedViewProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <cmath>
#include <cstring>

vtkStandardNewMacro(vtkSMRayTracedPickingHelperProxy);

namespace
{
// Whether the two points are where the ray of one pixel enters and leaves what the renderer shows; and that pixel.
bool FindPixel(vtkRenderer* renderer, const double a[3], const double b[3], int pixel[2])
{
  constexpr double tolerance = 1e-3; // in pixels, and for depths
  double entry[3], exit[3];
  vtkInteractorObserver::ComputeWorldToDisplay(renderer, a[0], a[1], a[2], entry);
  vtkInteractorObserver::ComputeWorldToDisplay(renderer, b[0], b[1], b[2], exit);
  for (int i = 0; i < 2; ++i)
  {
    pixel[i] = static_cast<int>(std::lround(entry[i]));
    if (std::abs(entry[i] - pixel[i]) > tolerance || std::abs(exit[i] - pixel[i]) > tolerance)
    {
      return false;
    }
  }
  return std::abs(entry[2]) <= tolerance && std::abs(exit[2] - 1.0) <= tolerance;
}
}

//----------------------------------------------------------------------------
// The class of a proxy is the name of its definition's element.
void vtkSMRayTracedPickingHelperProxy::Install(vtkSMProxy* proxy)
{
  vtkSMProxyDefinitionManager* definitions = proxy->GetSessionProxyManager()->GetProxyDefinitionManager();
  if (vtkPVXMLElement* helper = definitions->GetCollapsedProxyDefinition("misc", "PickingHelper", nullptr, false))
  {
    helper->SetName("RayTracedPickingHelperProxy");
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedPickingHelperProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->Superclass::UpdatePropertyInformationInternal(property);
  const char* name = property ? this->GetPropertyName(property) : nullptr;
  double place[3];
  if (name && strcmp(name, "Intersection") == 0 && this->FindPlace(place))
  {
    vtkSMPropertyHelper(property).Set(place, 3);
  }
}

//----------------------------------------------------------------------------
// False where the ray hits no ray-traced display of the input.
bool vtkSMRayTracedPickingHelperProxy::FindPlace(double place[3])
{
  vtkSMProxy* input = vtkSMPropertyHelper(this, "Input").GetAsProxy();
  double a[3], b[3];
  vtkSMPropertyHelper(this, "PointA").Get(a, 3);
  vtkSMPropertyHelper(this, "PointB").Get(b, 3);
  if (vtkSMPropertyHelper(this, "SnapOnMeshPoint").GetAsInt())
  {
    return false; // asks for a point of the data
  }
  vtkNew<vtkSMProxyIterator> views;
  views->SetSession(this->GetSession());
  views->SetModeToOneGroup();
  for (views->Begin("views"); !views->IsAtEnd(); views->Next())
  {
    auto* view = vtkSMRenderViewProxy::SafeDownCast(views->GetProxy());
    vtkRenderer* renderer = view ? view->GetRenderer() : nullptr;
    vtkSMRayTracedViewProxy* owner = vtkSMRayTracedViewProxy::Of(view);
    int pixel[2];
    if (renderer && owner && owner->GetShownDisplay(input) && FindPixel(renderer, a, b, pixel))
    {
      return owner->FindPlace(pixel[0], pixel[1], place);
    }
  }
  return false;
}
