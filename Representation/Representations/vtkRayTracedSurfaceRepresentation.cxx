#include "vtkRayTracedSurfaceRepresentation.h"

#include "RayTracedSurfaceGatherer.h"
#include "vtkObjectFactory.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRayTracedSurfaceMapper.h"

vtkStandardNewMacro(vtkRayTracedSurfaceRepresentation);

//----------------------------------------------------------------------------
// Where unstructured data are spread over processes, ghost cells mark the faces between two pieces as inner ones.
vtkRayTracedSurfaceRepresentation::vtkRayTracedSurfaceRepresentation()
{
  this->RequestGhostCellsIfNeeded = true;
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceRepresentation::SetInterpolation(int interpolation)
{
  const bool smooth = interpolation != VTK_FLAT;
  this->Superclass::SetInterpolation(interpolation);
  if (this->Smooth != smooth)
  {
    this->Smooth = smooth;
    this->MarkModified(); // normals may be missing
  }
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSurfaceRepresentation::Gather(
  vtkDataObject* data, const int* wholeExtent, bool, const rtglyphs::RayTracedParallel::Progress&)
{
  rtglyphs::RayTracedSurfaceGatherer::Settings settings;
  settings.WholeExtent = wholeExtent;
  settings.ComputesNormals = this->Smooth;
  settings.NonlinearSubdivisionLevel =
    vtkPVGeometryFilter::SafeDownCast(this->GeometryFilter)->GetNonlinearSubdivisionLevel();
  return rtglyphs::RayTracedSurfaceGatherer::Gather(data, settings);
}

//----------------------------------------------------------------------------
// Those of glyphs without size at the surface's points.
const double* vtkRayTracedSurfaceRepresentation::GetDataBounds(vtkPolyData* surface)
{
  double unitSize = 1.0;
  return this->GetBoundsOf(surface, { this->GetSizes(surface, unitSize) });
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings vtkRayTracedSurfaceRepresentation::GetSizes(vtkPolyData*, double&)
{
  rtglyphs::GlyphSettings settings;
  settings.ScaleFactor = 0.0;
  settings.Motion = this->GetMotion();
  return settings;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkRayTracedMapper> vtkRayTracedSurfaceRepresentation::MakeMapper()
{
  return vtkSmartPointer<vtkRayTracedSurfaceMapper>::New();
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceRepresentation::Configure(vtkInformation*, vtkPolyData*, bool, bool)
{
  vtkRayTracedSurfaceMapper::SurfaceSettings settings;
  settings.Smooth = this->Smooth;
  settings.Motion = this->GetMotion();
  static_cast<vtkRayTracedSurfaceMapper*>(this->GetMapper())->SetSettings(settings);
}
