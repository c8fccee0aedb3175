#include "RayTracedSelected.h"

#include "GlyphSelection.h"
#include "vtkAlgorithm.h"

namespace
{
// On all ranks alike, whether or not any of it is on this one. ParaView puts a filter that does nothing behind the one
// that extracts what is selected, whose second input is the selection.
bool HasSelection(vtkAlgorithm* representation, int port)
{
  vtkAlgorithm* producer =
    representation->GetNumberOfInputConnections(port) > 0 ? representation->GetInputAlgorithm(port, 0) : nullptr;
  while (producer && producer->GetNumberOfInputPorts() == 1 && producer->GetNumberOfInputConnections(0) > 0)
  {
    producer = producer->GetInputAlgorithm(0, 0);
  }
  return producer && producer->GetNumberOfInputPorts() > 1 && producer->GetNumberOfInputConnections(1) > 0;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedSelected::Take(vtkAlgorithm* representation, int port, vtkDataObject* extracted)
{
  this->Extracted = HasSelection(representation, port) ? extracted : nullptr;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> rtglyphs::RayTracedSelected::Gather(vtkDataObject* input,
  const std::array<int, 3>& options, bool marks, const std::function<vtkSmartPointer<vtkDataObject>()>& gather)
{
  // Sources that fill the same data object anew differ by the time of its update.
  const std::array<vtkMTimeType, 2> times{ input->GetUpdateTime(), input->GetMTime() };
  if (!this->Gathered || input != this->Input || times != this->Times || options != this->Options)
  {
    this->Gathered = nullptr; // also where the memory does not suffice
    this->Gathered = gather();
    this->Input = input;
    this->Times = times;
    this->Options = options;
  }
  return rtglyphs::GlyphSelection::Mark(this->Gathered, marks ? this->Extracted.Get() : nullptr);
}
