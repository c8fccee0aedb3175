#include "RayTracedDefault.h"

#include "GlyphKeptGuess.h"
#include "RayTracedDomains.h"
#include "vtkCommand.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMDomain.h"
#include "vtkSMDomainIterator.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <cstring>
#include <string>

namespace
{
bool AreEqual(vtkSMProperty* one, vtkSMProperty* other)
{
  vtkSMPropertyHelper left(one), right(other);
  bool equal = left.GetNumberOfElements() == right.GetNumberOfElements();
  for (unsigned int i = 0; equal && i < left.GetNumberOfElements(); ++i)
  {
    equal = left.GetAsVariant(i) == right.GetAsVariant(i);
  }
  return equal;
}

// A property of the same display.
vtkSMProperty* Sibling(vtkSMProperty* property, const std::string& name)
{
  vtkSMProxy* owner = property->GetParent();
  return owner ? owner->GetTrueParentProxy()->GetProperty(name.c_str()) : nullptr;
}

bool IsRayTraced(vtkSMProperty* property)
{
  vtkSMProperty* type = Sibling(property, "Representation");
  const char* name = type ? vtkSMPropertyHelper(type).GetAsString() : nullptr;
  return name && strncmp(name, "Ray Traced", 10) == 0;
}

// While the data choose a number, which a property of the same name with FromData behind it says.
vtkSMProperty* FromDataOf(vtkSMProperty* property)
{
  return Sibling(property, std::string(property->GetXMLName()) + "FromData");
}

// A list of arrays prefers the default of the XML to arrays of the data.
bool Prefers(vtkSMDomain* domain, vtkSMProperty* property)
{
  auto* list = vtkSMStringListDomain::SafeDownCast(domain);
  auto* strings = vtkSMStringVectorProperty::SafeDownCast(property);
  const char* xmlDefault = list && strings ? strings->GetDefaultValue(0) : nullptr;
  unsigned int index = 0;
  return xmlDefault && list->IsInDomain(xmlDefault, index);
}

using rtglyphs::RayTracedDefault::Where;

struct Default
{
  virtual ~Default() = default;

  // Chooses anew where ParaView has chosen. Returns whether that is another value.
  virtual bool Renew(Where where) = 0;
};

// Base: vtkSMStringVectorProperty, ... State files do not have defaults of displays that show nothing ray traced.
template <class Base>
class Plain : public Base
{
public:
  void SaveState(vtkPVXMLElement* parent, const char* name, const char* uid, int saveDomains) override
  {
    if (IsRayTraced(this) || !(this->GetInformationOnly() || this->IsValueDefault()))
    {
      Base::SaveState(parent, name, uid, saveDomains);
    }
  }
};

template <class Base>
class Property final
  : public Plain<Base>
  , public Default
{
public:
  bool IsValueDefault() override
  {
    if (Base::IsValueDefault())
    {
      return true;
    }
    if (vtkSMDoubleVectorProperty::SafeDownCast(this))
    {
      vtkSMProperty* fromData = FromDataOf(this);
      return (fromData && vtkSMPropertyHelper(fromData).GetAsInt() != 0) || this->IsChosen();
    }
    return !IsRayTraced(this) && (this->IsChosen() || rtglyphs::RayTracedDefault::IsOfDomains(this));
  }

  // Where there are no data, as when ParaView resets all properties of a display, the input first, the property gets
  // the value that was chosen before; the default of the XML, while there is none, counts as chosen by ParaView.
  bool ResetToDomainDefaults(bool useUncheckedValues) override
  {
    const bool chosen = Base::ResetToDomainDefaults(useUncheckedValues);
    if (useUncheckedValues)
    {
      return chosen;
    }
    if (chosen || (!this->Chosen && this->IsValueDefault()))
    {
      this->Chosen.TakeReference(this->NewInstance());
      this->Chosen->Copy(this);
      this->Found = chosen;
      this->ByUser = false;
    }
    else if (this->Chosen)
    {
      this->Copy(this->Chosen);
      this->ByUser = false;
    }
    return this->Found;
  }

  void Modified() override
  {
    this->ByUser = true; // unless ResetToDomainDefaults() has done it
    Base::Modified();
  }

  bool Renew(Where where) override
  {
    if (!this->IsChosen() || FromDataOf(this))
    {
      return false;
    }
    const bool isArray = vtkSMStringVectorProperty::SafeDownCast(this);
    auto* list = this->template FindDomain<vtkSMRayTracedArrayListDomain>();
    const bool lost = where == Where::Lost && isArray &&
      (this->IsInDomains() == vtkSMDomain::NOT_IN_DOMAIN ||
        (list && list->HasBetterThan(vtkSMPropertyHelper(this).GetAsString())));
    // GlyphLocation Points may be the default of no arrays.
    const auto isNone = [this, isArray]
    {
      const vtkSMPropertyHelper value(this);
      return isArray ? strcmp(value.GetAsString(), "None") == 0
                     : vtkSMIntVectorProperty::SafeDownCast(this) && value.GetAsInt() == 0;
    };
    if (where != Where::Everywhere && !lost && this->Found && !isNone())
    {
      return false;
    }
    auto before = vtk::TakeSmartPointer(this->NewInstance());
    before->Copy(this);
    this->ResetToDomainDefaults(/*useUncheckedValues=*/false);
    return !AreEqual(this, before);
  }

private:
  // Whether ParaView has chosen the present value, or nothing has.
  bool IsChosen() { return !this->ByUser && (!this->Chosen || AreEqual(this, this->Chosen)); }

  vtkSmartPointer<vtkSMProperty> Chosen; // null: none yet, as in a display of a state file
  bool Found = false;                    // by the data
  bool ByUser = false;                   // the present value
};

bool RenewOne(vtkSMProperty* property, Where where)
{
  auto* ours = dynamic_cast<Default*>(property);
  return ours && ours->Renew(where);
}

bool RenewAll(vtkSMProxy* proxy, Where where)
{
  bool renewed = false;
  auto properties = vtk::TakeSmartPointer(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    renewed |= RenewOne(properties->GetProperty(), where);
  }
  return renewed;
}

// Over time tubes keep their radius, unless the lines, or the values that scale it, become that much larger.
bool RenewRadius(vtkSMProxy* display)
{
  vtkSMProperty* radius = display->GetProperty("TubeRadius");
  auto* domain = radius ? radius->FindDomain<vtkSMBoundsDomain>() : nullptr;
  if (!domain)
  {
    return false;
  }
  constexpr double mostExcess = rtglyphs::GlyphKeptGuess::mostExcess;
  auto suggested = vtk::TakeSmartPointer(radius->NewInstance());
  suggested->Copy(radius);
  domain->SetDefaultValues(suggested, /*use_unchecked_values=*/false);
  const double ratio = vtkSMPropertyHelper(suggested).GetAsDouble() / vtkSMPropertyHelper(radius).GetAsDouble();
  const char* array = vtkSMPropertyHelper(display, "TubeRadiusArray").GetAsString();
  const bool scaled = array && strcmp(array, "None") != 0;
  return (scaled ? mostExcess * ratio < 1.0 : ratio > mostExcess) && RenewOne(radius, Where::Everywhere);
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDefault::Register()
{
  static const bool known = []
  {
    using rtglyphs::RayTracedDomains::Register;
    Register<Property<vtkSMStringVectorProperty>>("vtkSMRayTracedStringVectorProperty");
    Register<Property<vtkSMDoubleVectorProperty>>("vtkSMRayTracedDoubleVectorProperty");
    Register<Property<vtkSMIntVectorProperty>>("vtkSMRayTracedIntVectorProperty");
    Register<Plain<vtkSMStringVectorProperty>>("vtkSMRayTracedPlainStringVectorProperty");
    Register<Plain<vtkSMDoubleVectorProperty>>("vtkSMRayTracedPlainDoubleVectorProperty");
    Register<Plain<vtkSMIntVectorProperty>>("vtkSMRayTracedPlainIntVectorProperty");
    rtglyphs::RayTracedDomains::Register();
    return true;
  }();
  static_cast<void>(known);
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedDefault::IsInWindow(vtkSMProxy* display)
{
  return vtkSMPropertyHelper(display, "SamplesPerRender").GetAsInt() < 0;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedDefault::IsOfDomains(vtkSMProperty* property)
{
  auto other = vtk::TakeSmartPointer(property->NewInstance());
  other->Copy(property);
  auto domains = vtk::TakeSmartPointer(property->NewDomainIterator());
  for (domains->Begin(); !domains->IsAtEnd(); domains->Next())
  {
    vtkSMDomain* domain = domains->GetDomain();
    if (Prefers(domain, property))
    {
      return false;
    }
    if (domain->SetDefaultValues(other, /*use_unchecked_values=*/false))
    {
      return AreEqual(property, other);
    }
  }
  return false;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDefault::Follow(vtkSMProxy* representation, const char* name)
{
  if (strcmp(name, "GlyphShape") == 0)
  {
    RenewOne(representation->GetProperty("GlyphLocation"), Where::Everywhere);
  }
  if (strcmp(name, "GlyphLocation") == 0)
  {
    // The lists of arrays are those of the input that the glyphs stand on.
    representation->GetProperty("Input")->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
    RenewAll(representation, Where::Lost);
  }
  if (strcmp(name, "TubeRadiusArray") == 0)
  {
    RenewOne(representation->GetProperty("TubeRadius"), Where::Everywhere);
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedDefault::Renew(vtkSMProxy* display, bool otherTime)
{
  const bool renewed = RenewAll(display, otherTime ? Where::Missing : Where::Lost);
  return (otherTime && RenewRadius(display)) || renewed;
}
