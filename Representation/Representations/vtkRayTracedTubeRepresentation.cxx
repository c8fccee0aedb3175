#include "vtkRayTracedTubeRepresentation.h"

#include "RayTracedSurfaceGatherer.h"
#include "RayTracedTubeBuilder.h"
#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedTubeMapper.h"

#include <cmath>

vtkStandardNewMacro(vtkRayTracedTubeRepresentation);

//----------------------------------------------------------------------------
vtkRayTracedTubeRepresentation::vtkRayTracedTubeRepresentation()
  : vtkRayTracedSelectableRepresentation(2)
{
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedTubeRepresentation::Gather(
  vtkDataObject* data, const int* wholeExtent, bool, const rtglyphs::RayTracedParallel::Progress&)
{
  rtglyphs::RayTracedSurfaceGatherer::Settings settings;
  settings.WholeExtent = wholeExtent;
  settings.Lines = true;
  return rtglyphs::RayTracedSurfaceGatherer::Gather(data, settings);
}

//----------------------------------------------------------------------------
// Those of balls at the lines' points, whose hulls the tubes are.
const double* vtkRayTracedTubeRepresentation::GetDataBounds(vtkPolyData* lines)
{
  double unitSize = 1.0;
  return this->GetBoundsOf(lines, { this->GetSizes(lines, unitSize) });
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings vtkRayTracedTubeRepresentation::GetSizes(vtkPolyData* lines, double&)
{
  rtglyphs::GlyphSettings settings;
  settings.ScaleFactor = 2.0 * std::abs(this->Radius);
  settings.Motion = this->GetMotion();
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
double vtkRayTracedTubeRepresentation::LargestOf(vtkDataArray* radii)
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
vtkSmartPointer<vtkRayTracedMapper> vtkRayTracedTubeRepresentation::MakeMapper()
{
  return vtkSmartPointer<vtkRayTracedTubeMapper>::New();
}

//----------------------------------------------------------------------------
void vtkRayTracedTubeRepresentation::Configure(vtkInformation*, vtkPolyData*, bool, bool)
{
  rtglyphs::RayTracedTubeBuilder::Settings settings;
  settings.Radius = this->Radius;
  settings.RadiusArray = this->RadiusArray;
  settings.FlatEnds = this->FlatEnds;
  settings.Joined = this->NeedsOrderedCompositing();
  settings.Motion = this->GetMotion();
  auto* tubes = static_cast<vtkRayTracedTubeMapper*>(this->GetMapper());
  tubes->SetSettings(settings);
  tubes->SetDirectionColoring(this->DirectionColoring);
  this->Key->SetColoring(this->DirectionColoring);
  tubes->SetSelectionColor(this->GetSelectionColor());
}
