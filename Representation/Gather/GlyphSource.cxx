#include "GlyphSource.h"

#include "vtkArrowSource.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>

namespace
{
const char* const arrayName = "RayTracedGlyphSource";

bool IsZero(const double* v)
{
  return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

bool IsFull(vtkSphereSource* sphere)
{
  return sphere->GetStartTheta() == 0.0 && sphere->GetEndTheta() == 360.0 && sphere->GetStartPhi() == 0.0 &&
    sphere->GetEndPhi() == 180.0;
}

// Half balls for its ends, which are not those of the kernels' capsule, came with VTK 9.3.
bool HasFlatEnds(auto* cylinder)
{
  if constexpr (requires { cylinder->GetCapsuleCap(); })
  {
    return cylinder->GetCapping() && !cylinder->GetCapsuleCap();
  }
  return cylinder->GetCapping();
}

// The arrow's origin came with VTK 9.3, too.
bool BeginsAtOrigin(auto* arrow)
{
  if constexpr (requires { arrow->GetArrowOrigin(); })
  {
    return arrow->GetArrowOrigin() == vtkArrowSource::ArrowOrigins::Default;
  }
  return true;
}

rtg::Shape ShapeOf(vtkAlgorithm* algorithm, glm::dvec3& size, rtg::ArrowForm& proportions)
{
  if (auto* sphere = vtkSphereSource::SafeDownCast(algorithm))
  {
    size = glm::dvec3(2.0 * sphere->GetRadius());
    return IsZero(sphere->GetCenter()) && IsFull(sphere) ? rtg::Shape::Sphere : rtg::Shape::Mesh;
  }
  if (auto* box = vtkCubeSource::SafeDownCast(algorithm))
  {
    size = { box->GetXLength(), box->GetYLength(), box->GetZLength() };
    return IsZero(box->GetCenter()) ? rtg::Shape::Box : rtg::Shape::Mesh;
  }
  if (auto* cylinder = vtkCylinderSource::SafeDownCast(algorithm))
  {
    size = { 2.0 * cylinder->GetRadius(), cylinder->GetHeight(), 2.0 * cylinder->GetRadius() };
    return IsZero(cylinder->GetCenter()) && HasFlatEnds(cylinder) ? rtg::Shape::Cylinder : rtg::Shape::Mesh;
  }
  if (auto* cone = vtkConeSource::SafeDownCast(algorithm))
  {
    size = { cone->GetHeight(), 2.0 * cone->GetRadius(), 2.0 * cone->GetRadius() };
    const double* direction = cone->GetDirection();
    const bool alongX = direction[0] > 0.0 && direction[1] == 0.0 && direction[2] == 0.0;
    return IsZero(cone->GetCenter()) && alongX && cone->GetCapping() ? rtg::Shape::Cone : rtg::Shape::Mesh;
  }
  if (auto* arrow = vtkArrowSource::SafeDownCast(algorithm))
  {
    proportions.shaftRadius = static_cast<float>(arrow->GetShaftRadius());
    proportions.tipRadius = static_cast<float>(arrow->GetTipRadius());
    proportions.tipLength = static_cast<float>(arrow->GetTipLength());
    const bool slender = arrow->GetShaftRadius() <= 0.5 && arrow->GetTipRadius() <= 0.5;
    return slender && arrow->GetTipLength() >= 0.001 && !arrow->GetInvert() && BeginsAtOrigin(arrow) ? rtg::Shape::Arrow
                                                                                                     : rtg::Shape::Mesh;
  }
  return rtg::Shape::Mesh;
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSource::GlyphSource(vtkAlgorithm* algorithm)
{
  // ParaView's filters behind each source pass its triangles on.
  while (algorithm && algorithm->IsA("vtkPVPostFilter"))
  {
    algorithm = algorithm->GetInputAlgorithm();
  }
  glm::dvec3 size(1.0);
  rtg::ArrowForm proportions;
  const rtg::Shape shape = ShapeOf(algorithm, size, proportions);
  if (shape != rtg::Shape::Mesh && std::min({ size.x, size.y, size.z }) > 0.0)
  {
    this->Shape = shape;
    this->UnitSize = size;
    this->Arrow = proportions;
  }
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSource::GlyphSource(vtkPolyData* triangles)
{
  vtkDataArray* array = triangles ? triangles->GetFieldData()->GetArray(arrayName) : nullptr;
  if (array && array->GetNumberOfComponents() == 7)
  {
    std::array<double, 7> values;
    array->GetTuple(0, values.data());
    this->Shape = static_cast<rtg::Shape>(values[0]);
    this->UnitSize = { values[1], values[2], values[3] };
    this->Arrow.shaftRadius = static_cast<float>(values[4]);
    this->Arrow.tipRadius = static_cast<float>(values[5]);
    this->Arrow.tipLength = static_cast<float>(values[6]);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSource::StoreIn(vtkPolyData* triangles) const
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(arrayName);
  array->SetNumberOfComponents(7);
  const std::array<double, 7> values = { static_cast<double>(this->Shape), this->UnitSize.x, this->UnitSize.y,
    this->UnitSize.z, this->Arrow.shaftRadius, this->Arrow.tipRadius, this->Arrow.tipLength };
  array->InsertNextTuple(values.data());
  triangles->GetFieldData()->AddArray(array);
}
