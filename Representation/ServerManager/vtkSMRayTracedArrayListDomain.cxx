#include "vtkSMRayTracedArrayListDomain.h"

#include "GlyphArrayNames.h"
#include "HarmonicForms.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkType.h"

#include <cstring>
#include <functional>
#include <vector>

vtkStandardNewMacro(vtkSMRayTracedArrayListDomain);

namespace
{
struct Array
{
  std::string Name;
  int Components, Attribute;
  bool IsColor; // by its type
};
using Arrays = std::vector<Array>;

// Null attributes have none.
Arrays ArraysOf(vtkPVDataSetAttributesInformation* attributes, const std::function<bool(const char*)>& isWanted)
{
  Arrays arrays;
  for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = attributes->GetArrayInformation(i);
    if (array && array->GetName() && isWanted(array->GetName()))
    {
      arrays.push_back({ array->GetName(), array->GetNumberOfComponents(), attributes->IsArrayAnAttribute(i),
        array->GetDataType() == VTK_UNSIGNED_CHAR });
    }
  }
  return arrays;
}

// The name of the array of the lowest rank, the first of several; those with a negative one do not count. Empty: none.
std::string Best(const Arrays& arrays, const std::function<int(const Array&)>& rank)
{
  const Array* best = nullptr;
  for (const Array& array : arrays)
  {
    const int own = rank(array);
    best = own >= 0 && (!best || own < rank(*best)) ? &array : best;
  }
  return best ? best->Name : std::string();
}

std::string First(const Arrays& arrays, const std::function<bool(const Array&)>& wanted)
{
  return Best(arrays, [&](const Array& array) { return wanted(array) ? 0 : -1; });
}

std::string Active(const Arrays& arrays, int attribute)
{
  return First(arrays, [attribute](const Array& array) { return array.Attribute == attribute; });
}

using Choice = std::string (*)(const Arrays&);

std::string FirstOf(const Arrays& arrays, const std::vector<Choice>& choices)
{
  for (Choice choice : choices)
  {
    const std::string found = choice(arrays);
    if (!found.empty())
    {
      return found;
    }
  }
  return {};
}

// Two components are a vector of the plane where the name says so.
int DirectionRank(const Array& array)
{
  const int rank = rtglyphs::GlyphArrayNames::DirectionRank(array.Name);
  const bool fits = array.Components == 3 || (array.Components == 2 && rank != rtglyphs::GlyphArrayNames::unknown);
  return fits && !array.IsColor && array.Attribute != vtkDataSetAttributes::TCOORDS ? rank : -1;
}

std::string NamedDirection(const Arrays& arrays)
{
  return Best(arrays,
    [](const Array& array)
    {
      const int rank = DirectionRank(array);
      return rank == rtglyphs::GlyphArrayNames::unknown ? -1 : rank;
    });
}

// Filters such as Stream Tracer make normals active; a vector that a solver has written is preferred.
std::string ActiveVectors(const Arrays& arrays)
{
  const std::string active = Active(arrays, vtkDataSetAttributes::VECTORS);
  return rtglyphs::GlyphArrayNames::IsNormal(active) ? NamedDirection(arrays) : active;
}

std::string Quaternion(const Arrays& arrays)
{
  return First(arrays,
    [](const Array& array) { return array.Components == 4 && rtglyphs::GlyphArrayNames::IsQuaternion(array.Name); });
}

std::string AnyDirection(const Arrays& arrays)
{
  return Best(arrays, DirectionRank);
}

std::string Velocity(const Arrays& arrays)
{
  return First(arrays,
    [](const Array& array) { return DirectionRank(array) >= 0 && rtglyphs::GlyphArrayNames::IsVelocity(array.Name); });
}

std::string ActiveTensors(const Arrays& arrays)
{
  return Active(arrays, vtkDataSetAttributes::TENSORS);
}

std::string AnyTensor(const Arrays& arrays)
{
  return Best(arrays,
    [](const Array& array)
    {
      const bool fits = array.Components == 9 || array.Components == 6;
      return fits ? rtglyphs::GlyphArrayNames::TensorRank(array.Name) : -1;
    });
}

std::string FourthOrder(const Arrays& arrays)
{
  return Best(arrays,
    [](const Array& array)
    {
      const int n = array.Components;
      return n == 36 || n == 21 || n == 81 || n == 15 ? rtglyphs::GlyphArrayNames::TensorRank(array.Name) : -1;
    });
}

std::string Direction(const Arrays& arrays)
{
  return FirstOf(arrays, { ActiveVectors, NamedDirection, Quaternion, AnyDirection });
}

std::string Tensor(const Arrays& arrays)
{
  return FirstOf(arrays, { ActiveTensors, AnyTensor, FourthOrder });
}

// Those of one and six components are seldom harmonics.
std::string Harmonics(const Arrays& arrays)
{
  return First(arrays,
    [](const Array& array) { return array.Components > 9 && rtg::FormMap::IsHarmonicsLength(array.Components); });
}

std::string Size(const Arrays& arrays)
{
  return First(arrays,
    [](const Array& array)
    {
      return array.Components == 1 &&
        (rtglyphs::GlyphArrayNames::IsRadius(array.Name) || rtglyphs::GlyphArrayNames::IsDiameter(array.Name));
    });
}

std::string ActiveScalars(const Arrays& arrays)
{
  return Active(arrays, vtkDataSetAttributes::SCALARS);
}

std::string AnyNumber(const Arrays& arrays)
{
  return First(arrays,
    [](const Array& array) { return array.Components == 1 && !rtglyphs::GlyphArrayNames::IsLabel(array.Name); });
}
}

//----------------------------------------------------------------------------
vtkSMRayTracedArrayListDomain::vtkSMRayTracedArrayListDomain() = default;

//----------------------------------------------------------------------------
vtkSMRayTracedArrayListDomain::~vtkSMRayTracedArrayListDomain() = default;

//----------------------------------------------------------------------------
void vtkSMRayTracedArrayListDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Choice: " << this->Choice << endl;
}

//----------------------------------------------------------------------------
int vtkSMRayTracedArrayListDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  this->Choice = element->GetAttributeOrEmpty("choice");
  return this->Superclass::ReadXMLAttributes(property, element);
}

//----------------------------------------------------------------------------
// Empty: none.
std::string vtkSMRayTracedArrayListDomain::Choose()
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkPVDataInformation* data = input ? this->GetInputDataInformation("Input") : nullptr;
  auto* domain = input ? vtkSMInputArrayDomain::SafeDownCast(input->GetDomain(this->InputDomainName)) : nullptr;
  vtkPVDataSetAttributesInformation* attributes =
    data && domain ? data->GetAttributeInformation(domain->GetAttributeType()) : nullptr;
  const Arrays arrays = ArraysOf(attributes,
    [this](const char* name)
    {
      unsigned int listed = 0;
      return this->IsInDomain(name, listed) != 0;
    });
  if (this->Choice == "direction")
  {
    return Direction(arrays);
  }
  if (this->Choice == "velocity")
  {
    const std::string velocity = FirstOf(arrays, { Velocity, ActiveVectors });
    return rtglyphs::GlyphArrayNames::IsNormal(velocity) ? std::string() : velocity;
  }
  if (this->Choice == "tensor")
  {
    return Tensor(arrays);
  }
  if (this->Choice == "harmonics")
  {
    return Harmonics(arrays);
  }
  vtkSMProxy* glyphs = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  if (glyphs && AreArrows(glyphs))
  {
    const std::string direction = vtkSMPropertyHelper(glyphs, "SelectOrientationVectors").GetAsString();
    const std::string followed = First(arrays,
      [&](const Array& array) { return array.Name == direction && (array.Components == 2 || array.Components == 3); });
    return !followed.empty() ? followed
                             : FirstOf(arrays, { ActiveVectors, AnyDirection, Size, ActiveScalars, AnyNumber });
  }
  return FirstOf(arrays, { Size, ActiveScalars, ActiveVectors, AnyDirection, AnyNumber });
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedArrayListDomain::AreArrows(vtkSMProxy* glyphs)
{
  vtkSMProxy* source = vtkSMPropertyHelper(glyphs, "GlyphType", /*quiet=*/true).GetAsProxy();
  return source && strcmp(source->GetXMLName(), "ArrowSource") == 0;
}

//----------------------------------------------------------------------------
int vtkSMRayTracedArrayListDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  if (!this->GetRequiredProperty("Input") || !this->GetInputDataInformation("Input"))
  {
    return 0; // nothing can be chosen
  }
  const std::string chosen = this->Choose();
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUncheckedValues);
  helper.Set(chosen.empty() ? "None" : chosen.c_str());
  return 1;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedArrayListDomain::HasDirectionsOrTensors(vtkPVDataSetAttributesInformation* attributes)
{
  const Arrays arrays = ArraysOf(attributes, [](const char*) { return true; });
  return !Direction(arrays).empty() || !Tensor(arrays).empty();
}
