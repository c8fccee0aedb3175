#include "TubeContent.h"

#include "RayTracedSurfaceGatherer.h"
#include "RayTracedTubeBuilder.h"
#include "vtkRayTracedTubeMapper.h"

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
  settings.ScaleFactor = 2.0 * std::abs(this->Radius);
  settings.Motion = this->Common.Time.GetMotion();
  bool ofCells = false;
  rtglyphs::RayTracedTubeBuilder::Settings tubes;
  tubes.RadiusArray = this->RadiusArray;
  if (vtkDataArray* radii = rtglyphs::RayTracedTubeBuilder::RadiusArray(lines, tubes, ofCells))
  {
    if (ofCells)
    {
      settings.ScaleFactor *= this->LargestOf(radii);
    }
    else
    {
      settings.Scaling = true;
      settings.ScaleArray = this->RadiusArray;
    }
  }
  return settings;
}

//----------------------------------------------------------------------------
// Called at each render.
double rtglyphs::TubeContent::LargestOf(vtkDataArray* radii)
{
  if (this->Radii != radii || this->RadiiTime != radii->GetMTime())
  {
    this->Radii = radii;
    this->RadiiTime = radii->GetMTime();
    this->LargestRadius = rtglyphs::RayTracedParallel::Largest(radii->GetNumberOfTuples(),
      [radii](vtkIdType i) { return std::isfinite(radii->GetComponent(i, 0)) ? radii->GetComponent(i, 0) : 0.0; });
  }
  return this->LargestRadius;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkRayTracedMapper> rtglyphs::TubeContent::MakeMapper() const
{
  return vtkSmartPointer<vtkRayTracedTubeMapper>::New();
}

//----------------------------------------------------------------------------
void rtglyphs::TubeContent::Configure(const Frame& frame)
{
  rtglyphs::RayTracedTubeBuilder::Settings settings;
  settings.Radius = this->Radius;
  settings.RadiusArray = this->RadiusArray;
  settings.FlatEnds = this->FlatEnds;
  settings.Joined = frame.Translucent;
  settings.Motion = this->Common.Time.GetMotion();
  auto* tubes = static_cast<vtkRayTracedTubeMapper*>(this->Common.Parts.Mapper.Get());
  tubes->SetSettings(settings);
  tubes->SetDirectionColoring(this->Common.DirectionColoring);
  this->Common.Key->SetColoring(this->Common.DirectionColoring);
  tubes->SetSelectionColor(this->Common.SelectionColor);
}
