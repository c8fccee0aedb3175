#include "TubeContent.h"

#include "RayTracedSurfaceGatherer.h"
#include "vtkDataArray.h"
#include "vtkMath.h"

#include <cmath>

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> rtglyphs::TubeContent::Gather(
  vtkDataObject* data, const int* wholeExtent, bool, const rtglyphs::RayTracedParallel::Progress&) const
{
  rtglyphs::RayTracedSurfaceGatherer::Settings settings;
  settings.WholeExtent = wholeExtent;
  settings.Lines = true;
  return rtglyphs::RayTracedSurfaceGatherer::Gather(data, settings);
}

//----------------------------------------------------------------------------
// Balls at the lines' points, whose hulls the tubes are.
rtglyphs::GlyphSettings rtglyphs::TubeContent::GetSizes(vtkPolyData* lines, double&)
{
  rtglyphs::GlyphSettings settings;
  settings.ScaleFactor = 2.0 * std::abs(this->Settings.Radius);
  settings.Motion = this->Common.Time.GetMotionOfPoints();
  bool ofCells = false;
  if (vtkDataArray* radii = rtglyphs::RayTracedTubeBuilder::RadiusArray(lines, this->Settings, ofCells))
  {
    if (ofCells || radii->GetNumberOfComponents() > 3)
    {
      settings.ScaleFactor *= this->LargestOf(radii);
    }
    else
    {
      settings.Scaling = true;
      settings.ScaleArray = this->Settings.RadiusArray;
    }
  }
  return settings;
}

//----------------------------------------------------------------------------
// Called at each render.
double rtglyphs::TubeContent::LargestOf(vtkDataArray* radii)
{
  const auto radiusOf = [radii](vtkIdType i)
  {
    const int components = radii->GetNumberOfComponents();
    double tuple[9];
    radii->GetTuple(i, tuple);
    // No eigenvalue is larger than the root of a matrix's sum of squares, of which six numbers have at least half.
    const double norm = components == 1 ? tuple[0] : vtkMath::Norm(tuple, components);
    const double radius = components > 3 ? std::sqrt(std::sqrt(2.0) * norm) : norm;
    return std::isfinite(radius) ? radius : 0.0;
  };
  this->KnownRadii.Update(radii->GetMTime(),
    [&] { this->LargestRadius = rtglyphs::RayTracedParallel::Largest(radii->GetNumberOfTuples(), radiusOf); });
  return this->LargestRadius;
}

//----------------------------------------------------------------------------
void rtglyphs::TubeContent::Configure(const Frame& frame)
{
  rtglyphs::RayTracedTubeBuilder::Settings settings = this->Settings;
  settings.Joined = frame.Translucent;
  settings.Motion = this->Common.Time.GetMotionOfPoints();
  auto* tubes = static_cast<vtkRayTracedTubeMapper*>(this->Common.Parts.Mapper.Get());
  tubes->SetSettings(settings);
  tubes->SetDirectionColoring(this->Common.DirectionColoring);
  this->Common.Key->SetColoring(this->Common.DirectionColoring);
  tubes->SetSelectionColor(this->Common.SelectionColor);
}
