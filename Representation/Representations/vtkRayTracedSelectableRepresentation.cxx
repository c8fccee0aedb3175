#include "vtkRayTracedSelectableRepresentation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkGlyphSelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"

//----------------------------------------------------------------------------
vtkRayTracedSelectableRepresentation::vtkRayTracedSelectableRepresentation(int ports)
  : SelectionPort(ports - 1)
{
  this->SetNumberOfInputPorts(ports);
}

//----------------------------------------------------------------------------
vtkRayTracedSelectableRepresentation::~vtkRayTracedSelectableRepresentation() = default;

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SelectionPort: " << this->SelectionPort << endl;
}

//----------------------------------------------------------------------------
int vtkRayTracedSelectableRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE() && this->GetVisibility())
  {
    this->FollowSelection();
  }
  return this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
}

//----------------------------------------------------------------------------
// As an input of this representation what is selected is brought up to date when the points are. ParaView does not tell
// representations of data that a selection has changed.
void vtkRayTracedSelectableRepresentation::FollowSelection()
{
  const int port = this->SelectionPort;
  vtkAlgorithmOutput* input = this->GetNumberOfInputConnections(0) > 0 ? this->GetInputConnection(0, 0) : nullptr;
  vtkAlgorithmOutput* selection = vtkGlyphSelection::Find(this->GetView(), input);
  vtkAlgorithmOutput* known = this->GetNumberOfInputConnections(port) > 0 ? this->GetInputConnection(port, 0) : nullptr;
  if (selection != known)
  {
    this->SetInputConnection(port, selection);
  }
  auto* pipeline =
    selection ? vtkDemandDrivenPipeline::SafeDownCast(selection->GetProducer()->GetExecutive()) : nullptr;
  if (pipeline)
  {
    pipeline->UpdatePipelineMTime();
    const vtkMTimeType time = pipeline->GetPipelineMTime();
    if (time != this->SelectionTime)
    {
      this->SelectionTime = time;
      this->MarkModified();
    }
  }
}

//----------------------------------------------------------------------------
int vtkRayTracedSelectableRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformationVector* selection = inputVector[this->SelectionPort];
  this->Extracted = selection->GetNumberOfInformationObjects() == 1 ? vtkDataObject::GetData(selection, 0) : nullptr;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSelectableRepresentation::Gather(vtkDataObject* input, const int* wholeExtent)
{
  // Another selection is no reason to gather the same points again. Sources that fill the same data object anew differ
  // by the time of its update.
  const std::array<vtkMTimeType, 2> times =
    input ? std::array<vtkMTimeType, 2>{ input->GetUpdateTime(), input->GetMTime() } : std::array<vtkMTimeType, 2>{};
  if (!this->Gathered || !input || input != this->GatheredInput || times != this->GatheredTimes)
  {
    this->Gathered = this->GatherAnew(input, wholeExtent);
    this->GatheredInput = input;
    this->GatheredTimes = times;
  }
  return vtkGlyphSelection::Mark(this->Gathered, this->Extracted);
}

//----------------------------------------------------------------------------
bool vtkRayTracedSelectableRepresentation::RemoveFromView(vtkView* view)
{
  this->SetInputConnection(this->SelectionPort, nullptr);
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::SetSelectionColor(double red, double green, double blue)
{
  this->SelectionColor = ColorInRange(red, green, blue);
}
