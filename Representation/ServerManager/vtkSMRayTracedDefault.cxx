#include "vtkSMRayTracedDefault.h"

#include "vtkSMDomain.h"
#include "vtkSMDomainIterator.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkVariant.h"

#include <cstring>

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

// A list of arrays prefers the default of the XML to arrays of the data.
bool Prefers(vtkSMDomain* domain, vtkSMProperty* property)
{
  auto* list = vtkSMStringListDomain::SafeDownCast(domain);
  auto* strings = vtkSMStringVectorProperty::SafeDownCast(property);
  const char* xmlDefault = list && strings ? strings->GetDefaultValue(0) : nullptr;
  unsigned int index = 0;
  return xmlDefault && list->IsInDomain(xmlDefault, index);
}
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDefault::IsShown(vtkSMProperty* property)
{
  vtkSMProxy* owner = property->GetParent();
  vtkSMProxy* display = owner ? owner->GetTrueParentProxy() : nullptr;
  vtkSMProperty* type = display ? display->GetProperty("Representation") : nullptr;
  const char* name = type ? vtkSMPropertyHelper(type).GetAsString() : nullptr;
  return name && strncmp(name, "Ray Traced", 10) == 0;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDefault::Take(vtkSMProperty* property, bool chosen)
{
  if (chosen || (!this->Chosen && property->IsValueDefault()))
  {
    this->Chosen.TakeReference(property->NewInstance());
    this->Chosen->Copy(property);
    this->Found = chosen;
    this->ByUser = false;
  }
  else if (this->Chosen)
  {
    property->Copy(this->Chosen);
    this->ByUser = false;
  }
  return this->Found;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDefault::IsChosen(vtkSMProperty* property) const
{
  return this->Chosen && !this->ByUser && AreEqual(property, this->Chosen);
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDefault::Has(vtkSMProperty* property) const
{
  if (this->IsChosen(property))
  {
    return true;
  }
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
bool vtkSMRayTracedDefault::IsMissing(vtkSMProperty* property) const
{
  const char* value = vtkSMPropertyHelper(property).GetAsString();
  return !this->Found || (property->IsA("vtkSMStringVectorProperty") && (!value || strcmp(value, "None") == 0));
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedDefault::Renew(vtkSMProperty* property, Where where)
{
  const bool lost = where == Where::Lost && property->IsInDomains() == vtkSMDomain::NOT_IN_DOMAIN;
  if (!this->IsChosen(property) || !(where == Where::Everywhere || lost || this->IsMissing(property)))
  {
    return false;
  }
  const vtkSmartPointer<vtkSMProperty> before = this->Chosen;
  property->ResetToDomainDefaults();
  return !AreEqual(property, before);
}
