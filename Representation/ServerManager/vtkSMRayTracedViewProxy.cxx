#include "vtkSMRayTracedViewProxy.h"

#include "RayTracedDomains.h"
#include "RayTracedExplanation.h"
#include "vtkCallbackCommand.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkCompositeRepresentation.h"
#include "vtkObjectFactory.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkPVXMLElement.h"
#include "vtkRayTracedRepresentation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedPickingHelperProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMRayTracedViewProxy);

namespace
{
// Owners by view, which keeps its own. Proxies of a script that exits connected outlive static objects.
auto& owners = *new std::map<vtkSMProxy*, vtkSMRayTracedViewProxy*>;

// The present speed is the mean of so long to twice as long: of a step's fraction, but no more seconds.
constexpr double fractionOfSpeed = 0.25, secondsOfSpeed = 20.0;

// Seconds of the wall clock since a fixed time.
double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

vtkSMProxy* SettingsOf(vtkSMProxy* display)
{
  return display->GetProperty("ShadingMode")->GetParent();
}

// A display's ray-traced representation.
vtkRayTracedRepresentation* ShownBy(vtkSMProxy* display)
{
  auto* all = vtkCompositeRepresentation::SafeDownCast(display->GetClientSideObject());
  return all ? vtkRayTracedRepresentation::SafeDownCast(all->GetActiveRepresentation()) : nullptr;
}
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::vtkSMRayTracedViewProxy()
{
  rtglyphs::RayTracedDomains::Register();
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy::~vtkSMRayTracedViewProxy()
{
  std::erase_if(owners, [this](const auto& owned) { return owned.second == this; });
}

//----------------------------------------------------------------------------
vtkSMRayTracedViewProxy* vtkSMRayTracedViewProxy::Of(vtkSMProxy* view)
{
  const auto found = owners.find(view);
  return found != owners.end() && found->second->View == view ? found->second : nullptr; // another may be in its place
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkSMRayTracedViewProxy> vtkSMRayTracedViewProxy::Add(vtkSMProxy* display, vtkSMProxy* view)
{
  vtkSMRayTracedPickingHelperProxy::Install(display);
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
    // Settings stay while nothing ray-traced is in the view.
    vtkNew<vtkCallbackCommand> keeps;
    keeps->SetClientData(owner.Get());
    owner->Register(nullptr);
    keeps->SetClientDataDeleteCallback(
      [](void* kept) { static_cast<vtkSMRayTracedViewProxy*>(kept)->UnRegister(nullptr); });
    view->AddObserver(vtkCommand::DeleteEvent, keeps);
    owners[view] = owner;
  }
  owner->Displays.emplace_back(display);
  settings->AddObserver(vtkCommand::PropertyModifiedEvent, owner.Get(), &vtkSMRayTracedViewProxy::DisplayModified);
  settings->AddObserver(vtkCommand::UpdatePropertyEvent, owner.Get(), &vtkSMRayTracedViewProxy::DisplayPushed);
  return owner;
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::Remove(vtkSMProxy* display)
{
  std::erase(this->Displays, display);
}

//----------------------------------------------------------------------------
// A display's property has another value, which the view's gets.
void vtkSMRayTracedViewProxy::DisplayModified(vtkObject* settings, unsigned long, void* name)
{
  vtkSMProperty* property = vtkSMProxy::SafeDownCast(settings)->GetProperty(static_cast<const char*>(name));
  if (!this->Sharing && this->IsOfDisplay(property))
  {
    this->GetProperty(static_cast<const char*>(name))->Copy(property);
    if (this->GetSession()->IsProcessingRemoteNotification())
    {
      this->UpdateVTKObjects(); // another client has set it, and what it pushed was for its own view
    }
  }
}

//----------------------------------------------------------------------------
// A display's property is pushed to the servers, and so is the view's.
void vtkSMRayTracedViewProxy::DisplayPushed(vtkObject* settings, unsigned long, void* name)
{
  vtkSMProperty* property = vtkSMProxy::SafeDownCast(settings)->GetProperty(static_cast<const char*>(name));
  if (this->IsOfDisplay(property))
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
bool vtkSMRayTracedViewProxy::IsOfDisplay(vtkSMProperty* property)
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
  if (!this->View)
  {
    return nullptr;
  }
  // One that was deleted may live on, in a script for example.
  const vtkSMPropertyHelper all(this->View, "Representations", /*quiet=*/true);
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* display = all.GetAsProxy(i);
    const bool own = std::find(this->Displays.begin(), this->Displays.end(), display) != this->Displays.end();
    vtkRayTracedRepresentation* shown = own && display ? ShownBy(display) : nullptr;
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
    this->ApplyQuality(name);
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
// The properties that a quality's hints name, with their values.
std::vector<std::pair<std::string, int>> vtkSMRayTracedViewProxy::SettingsOfQuality(int quality)
{
  std::vector<std::pair<std::string, int>> meant;
  vtkPVXMLElement* hints = this->GetProperty("RenderingQuality")->GetHints();
  for (unsigned int i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* one = hints->GetNestedElement(i);
    int values[4] = {};
    if (quality > 0 && one->GetVectorAttribute("values", 4, values) >= quality)
    {
      meant.emplace_back(one->GetAttributeOrEmpty("property"), values[quality - 1]);
    }
  }
  return meant;
}

//----------------------------------------------------------------------------
// One of the properties that gets another value than the quality's ends that.
void vtkSMRayTracedViewProxy::ApplyQuality(const std::string& name)
{
  vtkSMPropertyHelper quality(this, "RenderingQuality");
  for (const auto& [property, value] : this->SettingsOfQuality(quality.GetAsInt()))
  {
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
// The process that renders answers; with remote rendering that is the server's first rank.
std::string vtkSMRayTracedViewProxy::Ask(const vtkClientServerStream& question, bool ofAllRanks)
{
  auto* local = this->View ? vtkPVRenderView::SafeDownCast(this->View->GetClientSideObject()) : nullptr;
  const bool remote = local && local->GetUseDistributedRenderingForRender();
  const vtkTypeUInt32 first = remote ? vtkPVSession::RENDER_SERVER_ROOT : vtkPVSession::CLIENT;
  const vtkTypeUInt32 all = vtkPVSession::RENDER_SERVER;
  this->ExecuteStream(question, /*ignore_errors=*/false, remote && ofAllRanks ? all : first);
  std::string json;
  this->GetLastResult(first).GetArgument(0, 0, &json);
  return json;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedViewProxy::FindPlace(int x, int y, double place[3])
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "FindPlace" << x << y << vtkClientServerStream::End;
  const std::string answer = this->Ask(stream, /*ofAllRanks=*/true);
  const auto found = answer.empty() ? std::vector<double>() : nlohmann::json::parse(answer).get<std::vector<double>>();
  std::copy(found.begin(), found.end(), place);
  return !found.empty();
}

//----------------------------------------------------------------------------
void vtkSMRayTracedViewProxy::UpdateStatistics()
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetRenderStatistics" << vtkClientServerStream::End;
  const std::string answer = this->Ask(stream, /*ofAllRanks=*/false);
  if (answer.empty() || !this->View)
  {
    return;
  }
  auto all = nlohmann::ordered_json::parse(answer);
  const double progress = all.value("RefinementProgress", 1.0);
  const std::string step = all.value("RefinementStep", "");
  this->Samples = all.value("AccumulatedSamples", 0);
  if (step != this->Step || progress < this->Progress)
  {
    this->StepStart = Now();
  }
  // What else runs changes the speed; what comes before the first progress, such as a preview, is no part of it.
  const Reached reached{ Now(), progress };
  if (progress <= this->Recent[0].Progress || step != this->Step)
  {
    this->Recent[0] = this->Recent[1] = reached;
  }
  else if (reached.Time - this->Recent[1].Time >
    std::min(secondsOfSpeed, fractionOfSpeed * (reached.Time - this->StepStart)))
  {
    this->Recent[0] = this->Recent[1];
    this->Recent[1] = reached;
  }
  this->Last = reached;
  this->Progress = progress;
  this->Step = step;
  int size[2] = { 0, 0 };
  vtkSMPropertyHelper(this->View, "ViewSize").Get(size, 2);
  if (!std::equal(size, size + 2, this->MeasuredSize))
  {
    std::copy_n(size, 2, this->MeasuredSize);
    this->SecondsPerSample.clear();
  }
  if (this->GetSecondsLeft() >= 0.0)
  {
    all["RefinementSecondsLeft"] = this->GetSecondsLeft();
    const int wanted = vtkSMPropertyHelper(this, "SamplesPerPixel").GetAsInt();
    this->SecondsPerSample[vtkSMPropertyHelper(this, "ShadingMode").GetAsInt()] =
      this->GetSecondsLeft() / ((1.0 - progress) * wanted);
  }
  const auto ofRepresentations = all.value("representations", all.object());
  all.erase("representations");
  for (vtkSMProxy* display : this->Displays)
  {
    if (display)
    {
      vtkRayTracedRepresentation* shown = ShownBy(display);
      auto own = all;
      own.update(ofRepresentations.value(std::to_string(shown ? shown->GetUniqueIdentifier() : 0), all.object()));
      std::vector<std::string> sentences = rtglyphs::RayTracedExplanation::Explain(display);
      if (const std::string section = own.value("section", ""); !section.empty())
      {
        sentences.push_back(section);
      }
      own["choices"] = sentences;
      vtkSMPropertyHelper(display, "RenderStatistics")
        .Set(own.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
    }
  }
}

//----------------------------------------------------------------------------
double vtkSMRayTracedViewProxy::GetSecondsOfStep() const
{
  return Now() - this->StepStart;
}

//----------------------------------------------------------------------------
// An image's first launches are small, and slow for what they do: before a sample is whole only a longer time counts.
double vtkSMRayTracedViewProxy::GetSecondsLeft() const
{
  const double seconds = this->Last.Time - this->Recent[0].Time, done = this->Progress - this->Recent[0].Progress;
  const bool isKnown = seconds > (this->Samples > 0 ? 0.5 : 0.5 * secondsOfSpeed);
  return isKnown && this->Progress < 1.0 && done > 0.0 ? seconds * (1.0 - this->Progress) / done : -1.0;
}

//----------------------------------------------------------------------------
double vtkSMRayTracedViewProxy::GetSecondsOfQuality(int quality)
{
  int mode = -1, samples = 0;
  for (const auto& [property, value] : this->SettingsOfQuality(quality))
  {
    mode = property == "ShadingMode" ? value : mode;
    samples = property == "SamplesPerPixel" ? value : samples;
  }
  const auto found = this->SecondsPerSample.find(mode);
  return found != this->SecondsPerSample.end() ? samples * found->second : -1.0;
}
