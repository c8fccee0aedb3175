#include "vtkSMRayTracedViewProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkRayTracedView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedDefault.h"
#include "vtkSMRayTracedImageProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <cstring>

vtkStandardNewMacro(vtkSMRayTracedViewProxy);

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::vtkSMRayTracedViewProxy()
{
  vtkSMRayTracedDefault::Register();
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::~vtkSMRayTracedViewProxy() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy* vtkSMRayTracedViewProxy::Of(vtkSMProxy* view)
{
  const vtkSMPropertyHelper displays(view, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; i < displays.GetNumberOfElements(); ++i)
  {
    vtkSMRayTracedImageProxy* image = vtkSMRayTracedImageProxy::Of(displays.GetAsProxy(i));
    if (image && image->GetView() && image->GetView()->View == view)
    {
      return image->GetView();
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkSMRayTracedViewProxy> vtkSMRayTracedViewProxy::Add(vtkSMRayTracedImageProxy* image, vtkSMProxy* view)
{
  vtkSmartPointer<vtkSMRayTracedViewProxy> owner = Of(view);
  if (owner)
  {
    image->Copy(owner);
  }
  else
  {
    owner.TakeReference(vtkSMRayTracedViewProxy::SafeDownCast(
      image->GetSessionProxyManager()->NewProxy("internal_representations", "RayTracedView")));
    owner->Copy(image);
    owner->CreateVTKObjects();
    owner->UpdateVTKObjects();
    owner->View = view;
    view->GetClientSideObject(); // makes it
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(owner) << "SetView" << VTKOBJECT(view)
           << vtkClientServerStream::End;
    owner->ExecuteStream(stream);
    // Before observers that want to know how far the frame is.
    view->AddObserver(vtkCommand::EndEvent, owner.Get(), &vtkSMRayTracedViewProxy::Rendered, 1.0f);
  }
  owner->Images.push_back(image);
  return owner;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::Remove(vtkSMRayTracedImageProxy* image)
{
  this->Images.erase(std::remove(this->Images.begin(), this->Images.end(), image), this->Images.end());
}

//----------------------------------------------------------------------------
vtkSMProxy* vtkSMRayTracedViewProxy::GetView()
{
  return this->View;
}

//----------------------------------------------------------------------------
vtkSMProxy* vtkSMRayTracedViewProxy::GetShownDisplay(vtkSMProxy* input)
{
  for (vtkSMRayTracedImageProxy* image : this->Images)
  {
    vtkSMProxy* display = image->GetTrueParentProxy();
    if (image->IsShown() && (!input || vtkSMPropertyHelper(display, "Input").GetAsProxy() == input))
    {
      return display;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  if (flag && this->View && !this->Sharing)
  {
    this->FollowQuality(name);
    this->Sharing = true;
    for (vtkSMRayTracedImageProxy* image : this->Images)
    {
      image->GetProperty(name)->Copy(this->GetProperty(name));
    }
    this->Sharing = false;
  }
}

//----------------------------------------------------------------------------
// A quality gives other properties the values that its hints name; one of these that gets another value ends it.
void vtkSMRayTracedViewProxy::FollowQuality(const std::string& name)
{
  vtkSMPropertyHelper quality(this, "RenderingQuality");
  vtkPVXMLElement* hints = this->GetProperty("RenderingQuality")->GetHints();
  for (unsigned int i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* meant = hints->GetNestedElement(i);
    int of = 0;
    if (!meant->GetScalarAttribute("quality", &of) || of != quality.GetAsInt())
    {
      continue;
    }
    int value = 0;
    meant->GetScalarAttribute("value", &value);
    const std::string property = meant->GetAttributeOrEmpty("property");
    vtkSMPropertyHelper helper(this, property.c_str());
    if (name == "RenderingQuality")
    {
      helper.Set(value);
    }
    else if (name == property && helper.GetAsInt() != value)
    {
      quality.Set(0);
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::UpdateVTKObjects()
{
  if (this->ArePropertiesModified())
  {
    this->Superclass::UpdateVTKObjects();
    for (vtkSMRayTracedImageProxy* image : this->Images)
    {
      image->GetTrueParentProxy()->UpdateVTKObjects();
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::Rendered(vtkObject*, unsigned long, void* interactive)
{
  this->Interactive = interactive && *static_cast<int*>(interactive);
  if (!this->Interactive)
  {
    this->UpdateStatistics();
  }
}

//----------------------------------------------------------------------------
// With remote rendering nothing happens on the client, and the server's first rank has the statistics.
void vtkSMRayTracedViewProxy::UpdateStatistics()
{
  auto* local = vtkRayTracedView::SafeDownCast(this->GetClientSideObject());
  const vtkTypeUInt32 renders =
    local && local->GetRenderedRemotely() ? vtkPVSession::RENDER_SERVER_ROOT : vtkPVSession::CLIENT;
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetRenderStatistics" << vtkClientServerStream::End;
  this->ExecuteStream(stream, /*ignore_errors=*/false, renders);
  std::string statistics;
  if (!this->GetLastResult(renders).GetArgument(0, 0, &statistics))
  {
    return;
  }
  const auto all = nlohmann::json::parse(statistics);
  this->Progress = all.value("RefinementProgress", 1.0);
  this->Step = all.value("RefinementStep", "");
  this->Samples = all.value("AccumulatedSamples", 0);
  for (vtkSMRayTracedImageProxy* image : this->Images)
  {
    image->SetStatistics(statistics);
  }
}
