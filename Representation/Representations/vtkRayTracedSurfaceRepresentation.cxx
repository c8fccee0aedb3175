#include "vtkRayTracedSurfaceRepresentation.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkProperty.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedSurfaceGatherer.h"
#include "vtkRayTracedSurfaceMapper.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkRayTracedSurfaceRepresentation);

//----------------------------------------------------------------------------
vtkRayTracedSurfaceRepresentation::vtkRayTracedSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
vtkRayTracedSurfaceRepresentation::~vtkRayTracedSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Smooth: " << this->Smooth << endl;
  os << indent << "NonlinearSubdivisionLevel: " << this->NonlinearSubdivisionLevel << endl;
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceRepresentation::SetInterpolation(int interpolation)
{
  const bool smooth = interpolation != VTK_FLAT;
  this->GetActor()->GetProperty()->SetInterpolation(interpolation);
  if (this->Smooth != smooth)
  {
    this->Smooth = smooth;
    this->MarkModified(); // normals may be missing
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedSurfaceRepresentation::SetNonlinearSubdivisionLevel(int level)
{
  if (this->NonlinearSubdivisionLevel != level)
  {
    this->NonlinearSubdivisionLevel = level;
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
// Where unstructured data are spread over processes, ghost cells tell the faces between two pieces from outer ones.
int vtkRayTracedSurfaceRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(i);
    auto* levels = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
    info->Set(levels, info->Get(levels) + vtkProcessModule::GetNumberOfGhostLevelsToRequest(info));
  }
  return 1;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSurfaceRepresentation::Gather(vtkDataObject* input, const int* wholeExtent)
{
  vtkRayTracedSurfaceGatherer::Settings settings;
  if (vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController())
  {
    settings.Process = controller->GetLocalProcessId();
    settings.Processes = controller->GetNumberOfProcesses();
  }
  settings.WholeExtent = wholeExtent;
  settings.ComputesNormals = this->Smooth;
  settings.NonlinearSubdivisionLevel = this->NonlinearSubdivisionLevel;
  return vtkRayTracedSurfaceGatherer::Gather(input, settings);
}

//----------------------------------------------------------------------------
// Those of glyphs without size at the surface's points.
const double* vtkRayTracedSurfaceRepresentation::GetDataBounds(vtkPolyData* surface)
{
  double unitSize = 1.0;
  return this->GetBoundsOf(surface, { this->GetSizes(surface, unitSize) });
}

//----------------------------------------------------------------------------
vtkGlyphSettings vtkRayTracedSurfaceRepresentation::GetSizes(vtkPolyData*, double&)
{
  vtkGlyphSettings settings;
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
  settings.InterpolateValues = this->GetInterpolateScalarsBeforeMapping();
  settings.Motion = this->GetMotion();
  static_cast<vtkRayTracedSurfaceMapper*>(this->GetMapper())->SetSettings(settings);
}
