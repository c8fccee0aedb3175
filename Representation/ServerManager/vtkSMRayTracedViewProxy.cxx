#include "vtkSMRayTracedViewProxy.h"

#include "RayTracedDefault.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkCompositeRepresentation.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkRayTracedView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedRepresentationProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <cstring>

vtkStandardNewMacro(vtkSMRayTracedViewProxy);

namespace
{
vtkSMProxy* SettingsOf(vtkSMProxy* display)
{
  return display->GetProperty("ShadingMode")->GetParent();
}

// What a display shows, when it is ray traced.
vtkRayTracedRepresentation* ShownBy(vtkSMProxy* display)
{
  auto* all = vtkCompositeRepresentation::SafeDownCast(display->GetClientSideObject());
  return all ? vtkRayTracedRepresentation::SafeDownCast(all->GetActiveRepresentation()) : nullptr;
}
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::vtkSMRayTracedViewProxy()
{
  rtglyphs::RayTracedDefault::Register();
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::~vtkSMRayTracedViewProxy() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy* vtkSMRayTracedViewProxy::Of(vtkSMProxy* view)
{
  const vtkSMPropertyHelper displays(view, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; i < displays.GetNumberOfElements(); ++i)
  {
    vtkSMProperty* one = displays.GetAsProxy(i) ? displays.GetAsProxy(i)->GetProperty("RenderStatistics") : nullptr;
    auto* glyphs = one ? vtkSMRayTracedRepresentationProxy::SafeDownCast(one->GetParent()) : nullptr;
    if (glyphs && glyphs->GetView() && glyphs->GetView()->View == view)
    {
      return glyphs->GetView();
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkSMRayTracedViewProxy> vtkSMRayTracedViewProxy::Add(vtkSMProxy* display, vtkSMProxy* view)
{
  vtkSMProxy* settings = SettingsOf(display);
  vtkSmartPointer<vtkSMRayTracedViewProxy> owner = Of(view);
  if (owner)
  {
    settings->Copy(owner);
  }
  else
  {
    owner.TakeReference(vtkSMRayTracedViewProxy::SafeDownCast(
      display->GetSessionProxyManager()->NewProxy("internal_representations", "RayTracedView")));
    owner->Copy(settings);
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
  owner->Displays.emplace_back(display);
  settings->AddObserver(vtkCommand::PropertyModifiedEvent, owner.Get(), &vtkSMRayTracedViewProxy::Take);
  settings->AddObserver(vtkCommand::UpdatePropertyEvent, owner.Get(), &vtkSMRayTracedViewProxy::Push);
  return owner;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::Remove(vtkSMProxy* display)
{
  std::erase(this->Displays, display);
}

//----------------------------------------------------------------------------
// A display has another value.
void vtkSMRayTracedViewProxy::Take(vtkObject* settings, unsigned long, void* name)
{
  vtkSMProperty* property = vtkSMProxy::SafeDownCast(settings)->GetProperty(static_cast<const char*>(name));
  if (!this->Sharing && this->Has(property))
  {
    this->GetProperty(static_cast<const char*>(name))->Copy(property);
    if (this->GetSession()->IsProcessingRemoteNotification())
    {
      this->UpdateVTKObjects(); // another client has set it, and what it pushed was for its own view
    }
  }
}

//----------------------------------------------------------------------------
// It is to be used.
void vtkSMRayTracedViewProxy::Push(vtkObject* settings, unsigned long, void* name)
{
  vtkSMProperty* property = vtkSMProxy::SafeDownCast(settings)->GetProperty(static_cast<const char*>(name));
  if (this->Has(property))
  {
    this->UpdateVTKObjects();
    if (strcmp(property->GetClassName(), "vtkSMProperty") == 0)
    {
      this->InvokeCommand(static_cast<const char*>(name));
    }
  }
}

//----------------------------------------------------------------------------
// Whether it is of a display that has not gone to another view.
bool vtkSMRayTracedViewProxy::Has(vtkSMProperty* property)
{
  vtkSMProxy* display = property->GetParent()->GetTrueParentProxy();
  return std::find(this->Displays.begin(), this->Displays.end(), display) != this->Displays.end();
}

//----------------------------------------------------------------------------
vtkSMProxy* vtkSMRayTracedViewProxy::GetView()
{
  return this->View;
}

//----------------------------------------------------------------------------
vtkSMProxy* vtkSMRayTracedViewProxy::GetShownDisplay(vtkSMProxy* input)
{
  for (vtkSMProxy* display : this->Displays)
  {
    vtkRayTracedRepresentation* shown = display ? ShownBy(display) : nullptr;
    if (shown && shown->GetVisibility() && (!input || vtkSMPropertyHelper(display, "Input").GetAsProxy() == input))
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
    for (vtkSMProxy* display : this->Displays)
    {
      if (display)
      {
        SettingsOf(display)->GetProperty(name)->Copy(this->GetProperty(name));
      }
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
    for (vtkSMProxy* display : this->Displays)
    {
      if (display)
      {
        display->UpdateVTKObjects();
      }
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
bool vtkSMRayTracedViewProxy::IsRenderedRemotely()
{
  auto* local = vtkRayTracedView::SafeDownCast(this->GetClientSideObject());
  return local && local->GetRenderedRemotely();
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedViewProxy::FindPlace(int x, int y, double place[3])
{
  const bool remote = this->IsRenderedRemotely();
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "FindPlace" << x << y << vtkClientServerStream::End;
  this->ExecuteStream(stream, /*ignore_errors=*/false, remote ? vtkPVSession::RENDER_SERVER : vtkPVSession::CLIENT);
  std::string result;
  if (!this->GetLastResult(remote ? vtkPVSession::RENDER_SERVER_ROOT : vtkPVSession::CLIENT).GetArgument(0, 0, &result))
  {
    return false;
  }
  const auto found = nlohmann::json::parse(result).get<std::vector<double>>();
  std::copy(found.begin(), found.end(), place);
  return !found.empty();
}

//----------------------------------------------------------------------------
// With remote rendering nothing happens on the client, and the server's first rank has the statistics.
void vtkSMRayTracedViewProxy::UpdateStatistics()
{
  const vtkTypeUInt32 renders = this->IsRenderedRemotely() ? vtkPVSession::RENDER_SERVER_ROOT : vtkPVSession::CLIENT;
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetRenderStatistics" << vtkClientServerStream::End;
  this->ExecuteStream(stream, /*ignore_errors=*/false, renders);
  std::string statistics;
  if (!this->GetLastResult(renders).GetArgument(0, 0, &statistics))
  {
    return;
  }
  auto all = nlohmann::ordered_json::parse(statistics);
  this->Progress = all.value("RefinementProgress", 1.0);
  this->Step = all.value("RefinementStep", "");
  this->Samples = all.value("AccumulatedSamples", 0);
  const auto ofRepresentations = all.value("representations", all.object());
  all.erase("representations");
  for (vtkSMProxy* display : this->Displays)
  {
    if (display)
    {
      vtkRayTracedRepresentation* shown = ShownBy(display);
      auto own = all;
      own.update(ofRepresentations.value(std::to_string(shown ? shown->GetUniqueIdentifier() : 0), all.object()));
      vtkSMPropertyHelper(display, "RenderStatistics").Set(own.dump().c_str());
    }
  }
}
