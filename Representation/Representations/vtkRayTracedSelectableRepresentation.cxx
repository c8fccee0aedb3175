#include "vtkRayTracedSelectableRepresentation.h"

#include "GlyphSelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPVRenderView.h"

#include <algorithm>

//----------------------------------------------------------------------------
vtkRayTracedSelectableRepresentation::vtkRayTracedSelectableRepresentation(int ports)
  : SelectionPort(ports - 1)
{
  this->SetNumberOfInputPorts(ports);
}

//----------------------------------------------------------------------------
// On all ranks alike, whether or not any of it is on this one. ParaView puts a filter that does nothing behind the one
// that extracts what is selected, whose second input is the selection.
bool vtkRayTracedSelectableRepresentation::HasSelection()
{
  const int port = this->SelectionPort;
  vtkAlgorithm* producer = this->GetNumberOfInputConnections(port) > 0 ? this->GetInputAlgorithm(port, 0) : nullptr;
  while (producer && producer->GetNumberOfInputPorts() == 1 && producer->GetNumberOfInputConnections(0) > 0)
  {
    producer = producer->GetInputAlgorithm(0, 0);
  }
  return producer && producer->GetNumberOfInputPorts() > 1 && producer->GetNumberOfInputConnections(1) > 0;
}

//----------------------------------------------------------------------------
int vtkRayTracedSelectableRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformationVector* selection = inputVector[this->SelectionPort];
  this->Extracted = this->HasSelection() ? vtkDataObject::GetData(selection, 0) : nullptr;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject>
vtkRayTracedSelectableRepresentation::GatherTree(vtkDataObject* input, const int* wholeExtent)
{
  // Another selection is no reason to gather the same points again. Sources that fill the same data object anew differ
  // by the time of its update.
  const std::array<vtkMTimeType, 2> times{ input->GetUpdateTime(), input->GetMTime() };
  if (!this->Gathered || input != this->GatheredInput || times != this->GatheredTimes)
  {
    this->Gathered = this->Superclass::GatherTree(input, wholeExtent);
    this->GatheredInput = input;
    this->GatheredTimes = times;
  }
  return rtglyphs::GlyphSelection::Mark(this->Gathered, this->Extracted);
}

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::SetSelectionColor(double red, double green, double blue)
{
  this->SelectionColor = rtglyphs::RayTracedNumbers::ColorInRange(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::SetGlyphDirectionColoring(int kind)
{
  this->DirectionColoring = std::clamp<int>(kind, rtglyphs::DirectionColors::NONE, rtglyphs::DirectionColors::SPHERE);
}

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::SetGlyphDirectionKey(int place)
{
  this->Key->SetPlace(place);
}

//----------------------------------------------------------------------------
void vtkRayTracedSelectableRepresentation::ShowLayers(bool visible)
{
  for (vtkRayTracedLegend* legend : this->GetLegends())
  {
    legend->SetVisibility(visible);
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedSelectableRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    for (vtkRayTracedLegend* legend : this->GetLegends())
    {
      legend->AddTo(renderView);
    }
  }
  return this->Superclass::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkRayTracedSelectableRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    for (vtkRayTracedLegend* legend : this->GetLegends())
    {
      legend->RemoveFrom(renderView);
    }
  }
  return this->Superclass::RemoveFromView(view);
}
