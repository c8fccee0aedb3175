#include "RayTracedDomains.h"

#include "DataSummary.h"
#include "Finite.h"
#include "GlyphArrayRoles.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedArrayListDomain.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace
{
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
    vtkSMPropertyHelper input(this->GetProperty(), /*quiet=*/true);
    auto* source = this->GetProperty() && input.GetNumberOfElements() > 0
      ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy(0))
      : nullptr;
    if (source && source->GetOutputPortsCreated())
    {
      vtkPVDataInformation* data = source->GetDataInformation(input.GetOutputPort(0));
      const bool grid = data->GetDataSetType() == VTK_HYPER_TREE_GRID ||
        (data->IsCompositeDataSet() && data->HasDataSetType(VTK_HYPER_TREE_GRID));
      if (grid)
      {
        return vtkSMInputArrayDomain::CELL;
      }
    }
    return vtkSMInputArrayDomain::GetAttributeType();
  }
};

// Where glyphs stand: on cells (1) where only these have what GlyphShape shows.
class LocationDomain final : public vtkSMEnumerationDomain
{
public:
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override
  {
    const vtkSMPropertyHelper input(this->GetProperty()->GetParent(), "Input");
    auto* source = input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
    vtkPVDataInformation* data =
      source && source->GetOutputPortsCreated() ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
    const int shape = vtkSMPropertyHelper(this->GetProperty()->GetParent(), "GlyphShape").GetAsInt();
    const std::optional<bool> atCells =
      data ? vtkSMRayTracedArrayListDomain::AreAtCells(data, shape) : std::optional<bool>();
    if (!atCells)
    {
      return 0;
    }
    vtkSMPropertyHelper helper(property);
    helper.SetUseUnchecked(useUncheckedValues);
    helper.Set(*atCells ? 1 : 0);
    return 1;
  }
};

// Values of ShutterTime: from zero to a few times what the data suggest. Required properties:
// Summary, an information property (DataSummary), and FromData, which says whether what the data suggest counts. The
// default is to let it count: the value is computed when the view is next updated. ParaView's panel gives domains of
// bounds a slider and a reset button.
class ScaleDomain final : public vtkSMBoundsDomain
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
    vtkSMProperty* fromData = this->GetRequiredProperty("FromData");
    if (!fromData)
    {
      return 0;
    }
    if (vtkSMPropertyHelper(fromData).GetAsInt() == 1)
    {
      fromData->Modified(); // so that the value is computed again
    }
    else
    {
      vtkSMPropertyHelper(fromData).Set(1);
    }
    if (useUncheckedValues && property->GetParent())
    {
      property->GetParent()->UpdateVTKObjects(); // the panel only takes over what it finds unchecked
    }
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
  // Of the array of points of that name, or else of cells. Where there is none, many lines are thinner.
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
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedDomains::Register()
{
  Register<ArrayDomain>("vtkSMRayTracedArrayDomain");
  Register<LocationDomain>("vtkSMRayTracedLocationDomain");
  Register<RadiusDomain>("vtkSMRayTracedRadiusDomain");
  Register<ScaleDomain>("vtkSMRayTracedScaleDomain");
}
