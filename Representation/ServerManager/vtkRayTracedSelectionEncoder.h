/**
 * @class   vtkRayTracedSelectionEncoder
 * @brief   selects the points of glyphs where cells are asked for and the data have none
 *
 * Glyphs of points without cells give MarkedPoint() in the place of a cell's number. This class makes a selection of
 * points of those, so that picking cells on such glyphs does what the user sees. It takes the place of ParaView's
 * vtkPVEncodeSelectionForServer from the first ray-traced display on.
 */
#ifndef vtkRayTracedSelectionEncoder_h
#define vtkRayTracedSelectionEncoder_h

#include "vtkPVEncodeSelectionForServer.h"

class vtkRayTracedSelectionEncoder : public vtkPVEncodeSelectionForServer
{
public:
  static vtkRayTracedSelectionEncoder* New();
  vtkTypeMacro(vtkRayTracedSelectionEncoder, vtkPVEncodeSelectionForServer);

  /**
   * Makes objects of this class where ParaView asks for its own encoder.
   */
  static void Register();

  bool ProcessSelection(vtkSelection* rawSelection, vtkSMRenderViewProxy* viewProxy, bool multipleSelectionsAllowed,
    vtkCollection* selectedRepresentations, vtkCollection* selectionSources, int modifier, bool selectBlocks) override;

protected:
  vtkRayTracedSelectionEncoder();
  ~vtkRayTracedSelectionEncoder() override;

private:
  vtkRayTracedSelectionEncoder(const vtkRayTracedSelectionEncoder&) = delete;
  void operator=(const vtkRayTracedSelectionEncoder&) = delete;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedSelectionEncoder.h
