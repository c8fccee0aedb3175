#include "vtkSMRayTracedArrayListDomain.h"

#include "GlyphArrayRoles.h"
#include "RayTracedArrays.h"
#include "RayTracedChoices.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMInputArrayDomain.h"
#include "GlyphShapes.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <vector>

namespace
{
using namespace rtglyphs::GlyphArrayRoles;

constexpr double noise = 0.1; // of an eigenvalue, as a fraction of the largest one

// Of six and nine components without names ParaView says XX, YY, ...
bool AreTensorNames(vtkPVArrayInformation* array)
{
  const int components = array->GetNumberOfComponents();
  bool all = components > 1, known = components == 6 || components == 9;
  for (int i = 0; i < components; ++i)
  {
    const char* name = array->GetComponentName(i);
    const std::string text = name ? name : "";
    const std::string index = text.size() < 2 ? text : text.substr(text.size() - 2);
    all &= index.size() == 2 && index.find_first_not_of("xyzXYZ123") == std::string::npos;
    known &= text.size() == 2 && text.find_first_not_of("XYZ") == std::string::npos;
  }
  return all && !known;
}

// Whether the components' ranges are those of the coordinates.
bool ArePlaces(vtkPVArrayInformation* array, const double bounds[6])
{
  bool same = array->GetNumberOfComponents() == 3;
  for (int axis = 0; same && axis < 3; ++axis)
  {
    const double* range = array->GetComponentFiniteRange(axis);
    const double tolerance = 1e-6 * (bounds[2 * axis + 1] - bounds[2 * axis]);
    same = range && std::abs(range[0] - bounds[2 * axis]) <= tolerance &&
      std::abs(range[1] - bounds[2 * axis + 1]) <= tolerance;
  }
  return same;
}

// By name, because of equal candidates the first is chosen: ParaView 5 has them so, ParaView 6 in the order of the
// data. Null attributes have none; `bounds` may be null.
std::vector<Array> ArraysOf(vtkPVDataSetAttributesInformation* attributes, const double* bounds)
{
  std::vector<Array> arrays;
  for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = attributes->GetArrayInformation(i);
    if (!array || !array->GetName())
    {
      continue;
    }
    const int type = array->GetDataType(), attribute = attributes->IsArrayAnAttribute(i);
    const double* range = array->GetComponentFiniteRange(array->GetNumberOfComponents() > 1 ? -1 : 0);
    const double* first = array->GetComponentFiniteRange(array->GetNumberOfComponents() == 7 ? 1 : 0);
    Array one;
    one.Name = array->GetName();
    one.Components = array->GetNumberOfComponents();
    one.IsColor = type == VTK_UNSIGNED_CHAR || attribute == vtkDataSetAttributes::TCOORDS;
    one.IsWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
    for (Role role : { DIRECTION, ROTATION, LENGTH, VELOCITY })
    {
      one.IsActive[role] = attribute == vtkDataSetAttributes::VECTORS;
    }
    one.IsActive[SIZE] = attribute == vtkDataSetAttributes::SCALARS || attribute == vtkDataSetAttributes::VECTORS;
    one.IsActive[TENSOR] = attribute == vtkDataSetAttributes::TENSORS;
    one.HasTensorNames = AreTensorNames(array);
    one.IsPlace = bounds && ArePlaces(array, bounds);
    one.IsNegative = first && first[0] < -noise * std::max(std::abs(first[0]), std::abs(first[1]));
    one.Least = range ? range[0] : one.Least;
    one.Largest = range ? range[1] : one.Largest;
    arrays.push_back(one);
  }
  std::sort(arrays.begin(), arrays.end(), [](const Array& a, const Array& b) { return a.Name < b.Name; });
  return arrays;
}

// Number of axes along which points are spread, and their volume in these.
int AxesOf(const double bounds[6], double* volume = nullptr)
{
  const double sides[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  const double longest = *std::max_element(sides, sides + 3);
  int axes = 0;
  for (double side : sides)
  {
    const bool spread = side > 1e-3 * longest;
    axes += spread ? 1 : 0;
    if (volume && spread)
    {
      *volume *= side;
    }
  }
  return axes;
}

// The usual distance between points, if they fill their box. 0: not known.
double SpacingOf(vtkPVDataInformation* data)
{
  double volume = 1.0;
  const int axes = AxesOf(data->GetBounds(), &volume);
  const double spacing = std::pow(volume / std::max<double>(1.0, data->GetNumberOfPoints()), 1.0 / std::max(axes, 1));
  return axes > 0 && std::isfinite(spacing) ? spacing : 0.0;
}

// Those of columns.
std::vector<Array> JoinedOf(const std::vector<Array>& arrays, vtkPVDataInformation* data)
{
  std::vector<Array> numbers;
  std::copy_if(arrays.begin(), arrays.end(), std::back_inserter(numbers),
    [](const Array& array) { return array.Components == 1 && !array.IsColor; });
  return rtglyphs::GlyphArrayRoles::Join(numbers, !numbers.empty() && data && AxesOf(data->GetBounds()) < 3);
}

// The same where arrays of zeros may be chosen, too.
std::vector<Array> WithZeros(std::vector<Array> arrays)
{
  for (Array& array : arrays)
  {
    array.Largest = array.IsZero() ? -1.0 : array.Largest; // not known
  }
  return arrays;
}

// With the joined arrays in place of their columns.
std::vector<Array> WithJoined(std::vector<Array> arrays, vtkPVDataInformation* data)
{
  const std::vector<Array> joined = JoinedOf(arrays, data);
  const auto isPart = [&joined](const Array& array)
  {
    return std::any_of(joined.begin(), joined.end(),
      [&](const Array& whole) { return (", " + whole.Name + ',').find(", " + array.Name + ',') != std::string::npos; });
  };
  std::erase_if(arrays, isPart);
  arrays.insert(arrays.end(), joined.begin(), joined.end());
  return arrays;
}
}

//----------------------------------------------------------------------------
vtkSMRayTracedArrayListDomain* vtkSMRayTracedArrayListDomain::Of(vtkSMProxy* glyphs, const char* property)
{
  return glyphs->GetProperty(property)->FindDomain<vtkSMRayTracedArrayListDomain>();
}

//----------------------------------------------------------------------------
std::string vtkSMRayTracedArrayListDomain::Named(vtkSMProxy* proxy, const char* property)
{
  const char* name = vtkSMPropertyHelper(proxy, property).GetAsString();
  return name && strcmp(name, "None") != 0 ? name : "";
}

//----------------------------------------------------------------------------
int vtkSMRayTracedArrayListDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  const std::map<std::string, Role> roles{ { "direction", DIRECTION }, { "velocity", VELOCITY }, { "tensor", TENSOR },
    { "harmonics", HARMONICS }, { "exponents", EXPONENTS }, { "scale", SIZE } };
  this->Chosen = roles.at(element->GetAttributeOrEmpty("choice"));
  return this->Superclass::ReadXMLAttributes(property, element);
}

//----------------------------------------------------------------------------
// Of points or of cells.
std::vector<Array> vtkSMRayTracedArrayListDomain::InputArrays()
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkPVDataInformation* data = input ? this->GetInputDataInformation("Input") : nullptr;
  auto* domain = input ? vtkSMInputArrayDomain::SafeDownCast(input->GetDomain(this->InputDomainName)) : nullptr;
  return ArraysOf(data && domain ? data->GetAttributeInformation(domain->GetAttributeType()) : nullptr,
    data ? data->GetBounds() : nullptr);
}

//----------------------------------------------------------------------------
vtkPVDataInformation* vtkSMRayTracedArrayListDomain::GetExtraDataInformation()
{
  // A vertex, as ParaView leaves out arrays of nothing.
  vtkNew<vtkPolyData> columns;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  const vtkIdType point = points->InsertNextPoint(0.0, 0.0, 0.0);
  vertices->InsertNextCell(1, &point);
  columns->SetPoints(points);
  columns->SetVerts(vertices);
  std::vector<Array> extra = JoinedOf(this->InputArrays(), this->GetInputDataInformation("Input"));
  if (this->Chosen == VELOCITY)
  {
    extra.emplace_back().Name = rtglyphs::RayTracedArrays::StepVelocity;
    extra.back().Components = 3;
  }
  for (const Array& array : extra)
  {
    vtkNew<vtkFloatArray> joined;
    joined->SetName(array.Name.c_str());
    joined->SetNumberOfComponents(array.Components);
    joined->SetNumberOfTuples(1);
    joined->Fill(0.0);
    columns->GetPointData()->AddArray(joined);
    columns->GetCellData()->AddArray(joined);
  }
  this->JoinedArrays->CopyFromObject(columns);
  return this->JoinedArrays;
}

//----------------------------------------------------------------------------
std::vector<Array> vtkSMRayTracedArrayListDomain::Listed()
{
  std::vector<Array> arrays = WithJoined(this->InputArrays(), this->GetInputDataInformation("Input"));
  const auto isMissing = [this](const Array& array)
  {
    unsigned int listed = 0;
    return this->IsInDomain(array.Name.c_str(), listed) == 0;
  };
  std::erase_if(arrays, isMissing);
  return arrays;
}

//----------------------------------------------------------------------------
Array vtkSMRayTracedArrayListDomain::Find(const std::string& name)
{
  const std::vector<Array> arrays = this->Listed();
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Array& one) { return one.Name == name; });
  return found != arrays.end() ? *found : Array();
}

//----------------------------------------------------------------------------
Choice vtkSMRayTracedArrayListDomain::Choose(const char* only)
{
  std::vector<Array> arrays = this->Listed();
  if (only)
  {
    std::erase_if(arrays, [only](const Array& array) { return array.Name != only; });
    arrays = WithZeros(arrays);
  }
  vtkSMProxy* glyphs = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  const int shape = glyphs ? vtkSMPropertyHelper(glyphs, "GlyphShape", /*quiet=*/true).GetAsInt() : 0;
  const bool body = IsBody(glyphs);
  if (this->Chosen == DIRECTION && shape != 0 && !body)
  {
    // Tensors and polynomials, which have colors, are given in the data's frame.
    const bool given = rtglyphs::GlyphShapes::IsColored(shape);
    std::erase_if(arrays, [given](const Array& array) { return given || array.Components > 3; });
  }
  const Role role = this->Chosen == DIRECTION && body ? ROTATION
    : this->Chosen == SIZE && AreArrows(glyphs)       ? LENGTH
                                                      : this->Chosen;
  // Lengths of other vectors than the directions would be a wrong figure.
  const std::string direction = role == LENGTH ? Named(glyphs, "SelectOrientationVectors") : "";
  for (const Array& array : arrays)
  {
    if (array.Components <= 3 && array.Name == direction)
    {
      return { array, "the direction of the arrows" };
    }
  }
  const Choice choice = this->ChooseFor(role, arrays);
  auto* choices = glyphs ? rtglyphs::RayTracedChoices::Of(this->GetProperty()) : nullptr;
  const bool waits = choices && choices->WaitsForData(); // for values
  return choice || waits ? choice : this->ChooseFor(role, WithZeros(arrays));
}

//----------------------------------------------------------------------------
// Shapes that 3D Glyphs lacks: it has the same property, and takes no quaternions and matrices beside directions.
bool vtkSMRayTracedArrayListDomain::IsBody(vtkSMProxy* glyphs)
{
  using Shapes = rtglyphs::GlyphShapes;
  const int shape = glyphs ? vtkSMPropertyHelper(glyphs, "GlyphShape", /*quiet=*/true).GetAsInt() : 0;
  return shape == Shapes::CAPSULE || shape == Shapes::SUPERQUADRIC || shape == Shapes::NESTED_SUPERQUADRIC;
}

//----------------------------------------------------------------------------
bool vtkSMRayTracedArrayListDomain::AreArrows(vtkSMProxy* glyphs)
{
  vtkSMProxy* source = glyphs ? vtkSMPropertyHelper(glyphs, "GlyphType", /*quiet=*/true).GetAsProxy() : nullptr;
  const char* type = source ? source->GetXMLName() : "";
  const bool pointed = strcmp(type, "ArrowSource") == 0 || strcmp(type, "ConeSource") == 0;
  return pointed && vtkSMPropertyHelper(glyphs, "GlyphShape", /*quiet=*/true).GetAsInt() == 0;
}

//----------------------------------------------------------------------------
Choice vtkSMRayTracedArrayListDomain::ChooseFor(Role role, const std::vector<Array>& arrays)
{
  vtkPVDataInformation* data = this->GetInputDataInformation("Input");
  return rtglyphs::GlyphArrayRoles::Choose(role, arrays, data ? SpacingOf(data) : 0.0);
}

//----------------------------------------------------------------------------
int vtkSMRayTracedArrayListDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  if (!this->GetRequiredProperty("Input") || !this->GetInputDataInformation("Input"))
  {
    return 0; // nothing can be chosen
  }
  const Choice chosen = this->Choose();
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUncheckedValues);
  helper.Set(chosen ? chosen.Name.c_str() : "None");
  return 1;
}

//----------------------------------------------------------------------------
std::optional<bool> vtkSMRayTracedArrayListDomain::AreAtCells(vtkPVDataInformation* data, int shape)
{
  using Shapes = rtglyphs::GlyphShapes;
  const std::vector<Array> points = WithZeros(WithJoined(ArraysOf(data->GetPointDataInformation(), nullptr), data));
  const std::vector<Array> cells = WithZeros(WithJoined(ArraysOf(data->GetCellDataInformation(), nullptr), data));
  const std::vector<Role> roles = shape == Shapes::SPHERICAL_HARMONICS ? std::vector<Role>{ HARMONICS }
    : Shapes::IsColored(shape)                                         ? std::vector<Role>{ TENSOR }
                                                                       : std::vector<Role>{ DIRECTION, TENSOR, SIZE };
  for (Role role : roles)
  {
    const auto have = [role](const std::vector<Array>& arrays)
    {
      const Choice choice = rtglyphs::GlyphArrayRoles::Choose(role, arrays, 0.0);
      return choice && (role != SIZE || rtglyphs::GlyphArrayRoles::IsSize(choice.Name));
    };
    if (have(points) || have(cells))
    {
      return !have(points);
    }
  }
  return {};
}
