#include "RayTracedDomains.h"

#include "DataSummary.h"
#include "Finite.h"
#include "GlyphArrayRoles.h"
#include "RayTracedChoices.h"
#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace
{
// What an input property is connected to; null: nothing yet.
vtkPVDataInformation* DataOf(vtkSMProperty* property)
{
  const vtkSMPropertyHelper input(property, /*quiet=*/true);
  auto* source =
    property && input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  return source && source->GetOutputPortsCreated() ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
}

// The arrays that glyphs of an input can use: of its points, or of its cells, by GlyphLocation. In XML it is written as
// an InputArrayDomain of point arrays.
class ArrayDomain final : public vtkSMInputArrayDomain
{
public:
  int GetAttributeType() override
  {
    vtkSMProxy* glyphs = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
    if (glyphs && vtkSMPropertyHelper(glyphs, "GlyphLocation", /*quiet=*/true).GetAsInt() == 1)
    {
      return vtkSMInputArrayDomain::CELL;
    }
    vtkPVDataInformation* data = DataOf(this->GetProperty());
    const bool grid = data &&
      (data->GetDataSetType() == VTK_HYPER_TREE_GRID ||
        (data->IsCompositeDataSet() && data->HasDataSetType(VTK_HYPER_TREE_GRID)));
    return grid ? static_cast<int>(vtkSMInputArrayDomain::CELL) : vtkSMInputArrayDomain::GetAttributeType();
  }
};

// Where glyphs stand: on cells (1) where only these have what GlyphShape shows.
class LocationDomain final : public vtkSMEnumerationDomain
{
public:
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override
  {
    vtkSMProxy* glyphs = this->GetProperty()->GetParent();
    vtkPVDataInformation* data = DataOf(glyphs->GetProperty("Input"));
    const int shape = vtkSMPropertyHelper(glyphs, "GlyphShape").GetAsInt();
    const auto atCells = data ? vtkSMRayTracedArrayListDomain::AreAtCells(data, shape) : std::optional<bool>();
    if (atCells)
    {
      vtkSMPropertyHelper helper(property);
      helper.SetUseUnchecked(useUncheckedValues);
      helper.Set(*atCells ? 1 : 0);
    }
    return atCells.has_value();
  }
};

// Values of ShutterTime: from zero, the default, to a few times what the data suggest. Required property: Summary, an
// information property (DataSummary). ParaView's panel gives domains of bounds a slider and a reset button.
class ShutterDomain final : public vtkSMBoundsDomain
{
public:
  void Update(vtkSMProperty*) override
  {
    vtkSMProperty* summary = this->GetRequiredProperty("Summary");
    const double factor = summary ? vtkSMPropertyHelper(summary).GetAsDouble(rtglyphs::DataSummary::SHUTTER_TIME) : 0.0;
    this->SetEntries(std::vector<vtkEntry>{ vtkEntry(0.0, factor > 0.0 ? 4.0 * factor : 1.0) });
  }

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override
  {
    vtkSMPropertyHelper helper(property);
    helper.SetUseUnchecked(useUncheckedValues);
    helper.Set(0.0);
    property->Modified(); // so that the data are asked again
    return 1;
  }
};

constexpr double fewLines = 12.0; // do not hide each other

// Values of TubeRadius: from zero to a few times what the data suggest. Required properties: Input, and Array, the name
// of an array of points or cells that the radius is multiplied by. The default is such that the thickest tube has a
// radius of `scale_factor` times the longest side of the data.
class RadiusDomain final : public vtkSMBoundsDomain
{
public:
  void Update(vtkSMProperty*) override
  {
    vtkPVDataInformation* data = this->GetInputInformation();
    double longest = 0.0;
    if (data)
    {
      const double* bounds = data->GetBounds();
      vtkPVArrayInformation* points = data->GetPointArrayInformation();
      for (int axis = 0; axis < 3; ++axis)
      {
        // Bounds hold separators of lines that are not finite.
        const double* finite = points->GetNumberOfComponents() == 3 ? points->GetComponentFiniteRange(axis) : nullptr;
        const bool known = finite && finite[0] <= finite[1];
        longest = std::max(longest, known ? finite[1] - finite[0] : bounds[2 * axis + 1] - bounds[2 * axis]);
      }
    }
    const double largest = this->LargestValue();
    this->Suggested = rtg::IsPositive(longest) ? this->GetScaleFactor() * longest / largest : 0.0;
    // Radii and diameters are exact where they are possible: as in GlyphScaleGuess.
    vtkSMProperty* named = this->GetRequiredProperty("Array");
    const double diameters =
      named ? rtglyphs::GlyphArrayRoles::DiametersOf(vtkSMPropertyHelper(named).GetAsString()) : 0.0;
    if (diameters > 0.0 && this->Suggested > 0.0 && 0.5 * diameters * largest < 0.2 * longest &&
      0.5 * diameters * largest > 1e-4 * longest)
    {
      this->Suggested = 0.5 * diameters;
    }
    this->SetEntries(std::vector<vtkEntry>{ vtkEntry(0.0, this->Suggested > 0.0 ? 4.0 * this->Suggested : 1.0) });
  }

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override
  {
    this->Update(nullptr); // the array may have changed just now
    if (!(this->Suggested > 0.0))
    {
      return 0;
    }
    vtkSMPropertyHelper helper(property);
    helper.SetUseUnchecked(useUncheckedValues);
    helper.Set(this->Suggested);
    return 1;
  }

private:
  // The largest value of the point array of that name, or else of the cell array. Without one, many lines are thinner.
  double LargestValue()
  {
    vtkSMProperty* named = this->GetRequiredProperty("Array");
    const char* name = named ? vtkSMPropertyHelper(named).GetAsString() : nullptr;
    vtkPVDataInformation* data = this->GetInputInformation();
    vtkPVArrayInformation* array = nullptr;
    if (data && name)
    {
      array = data->GetPointDataInformation()->GetArrayInformation(name);
      array = array ? array : data->GetCellDataInformation()->GetArrayInformation(name);
    }
    const double* range = array ? array->GetComponentFiniteRange(array->GetNumberOfComponents() > 1 ? -1 : 0) : nullptr;
    double largest = range ? std::max(std::abs(range[0]), std::abs(range[1])) : 1.0;
    largest = range && array->GetNumberOfComponents() > 3 ? std::sqrt(largest) : largest; // of covariances
    if (array || !data)
    {
      return rtg::IsPositive(largest) ? largest : 1.0;
    }
    // Cells may be single pieces of lines.
    const double lines = std::min<double>(data->GetNumberOfCells(), data->GetNumberOfPoints() / 32.0);
    return std::max(1.0, std::cbrt(lines / fewLines));
  }

  double Suggested = 0.0; // 0: nothing
};

// A property whose default may be what was chosen from the data. Base: vtkSMStringVectorProperty, ... State files do
// not have defaults of displays that show nothing ray traced.
template <class Base>
class Property final : public Base
{
public:
  bool IsValueDefault() override { return Base::IsValueDefault() || rtglyphs::RayTracedChoices::IsDefault(this); }

  bool ResetToDomainDefaults(bool useUncheckedValues) override
  {
    const rtglyphs::RayTracedChoices::Scope scope;
    bool found = Base::ResetToDomainDefaults(useUncheckedValues);
    if (useUncheckedValues)
    {
      return found;
    }
    if (found)
    {
      this->Found = nullptr;
      if (!Base::IsValueDefault())
      {
        this->Found.TakeReference(this->NewInstance());
        this->Found->Copy(this);
      }
    }
    else if (this->Found) // ParaView resets the input first
    {
      this->Copy(this->Found);
      found = true;
    }
    rtglyphs::RayTracedChoices::Reset(this, found);
    return found;
  }

  // Panels reset what is internal, too, though a display that is reset stays in its window.
  void ResetToXMLDefaults() override
  {
    if (this->GetIsInternal())
    {
      return;
    }
    const rtglyphs::RayTracedChoices::Scope scope;
    Base::ResetToXMLDefaults();
    rtglyphs::RayTracedChoices::Reset(this, false);
  }

  void SaveState(vtkPVXMLElement* parent, const char* name, const char* uid, int saveDomains) override
  {
    vtkSMProxy* owner = this->GetParent();
    const bool shown = owner && rtglyphs::RayTracedChoices::ShowsRayTraced(owner->GetTrueParentProxy());
    if (shown || !(this->GetInformationOnly() || this->IsValueDefault()))
    {
      Base::SaveState(parent, name, uid, saveDomains);
    }
  }

private:
  vtkSmartPointer<vtkSMProperty> Found; // value that its domains found last; null: the XML's default
};

// Makes a class known to the server manager by that name.
template <class T>
void RegisterClass(const char* name)
{
  vtkClientServerInterpreterInitializer::GetGlobalInterpreter()->AddNewInstanceFunction(name,
    [](void*) -> vtkObjectBase*
    {
      auto* made = new T;
      made->InitializeObjectBase();
      return made;
    });
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDomains::Register()
{
  static const bool known = []
  {
    RegisterClass<Property<vtkSMStringVectorProperty>>("vtkSMRayTracedStringVectorProperty");
    RegisterClass<Property<vtkSMDoubleVectorProperty>>("vtkSMRayTracedDoubleVectorProperty");
    RegisterClass<Property<vtkSMIntVectorProperty>>("vtkSMRayTracedIntVectorProperty");
    RegisterClass<ArrayDomain>("vtkSMRayTracedArrayDomain");
    RegisterClass<vtkSMRayTracedArrayListDomain>("vtkSMRayTracedArrayListDomain");
    RegisterClass<LocationDomain>("vtkSMRayTracedLocationDomain");
    RegisterClass<RadiusDomain>("vtkSMRayTracedRadiusDomain");
    RegisterClass<ShutterDomain>("vtkSMRayTracedShutterDomain");
    return true;
  }();
  static_cast<void>(known);
}
