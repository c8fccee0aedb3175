/**
 * @class   vtkRayTracedSelectionEncoder
 * @brief   selects the glyphs' points or cells, for selections of either
 *
 * Glyphs of points without cells give a EncodeCellId() number in the place of a cell's, glyphs at the centers of cells
 * one in the place of a point's (RayTracedArrays). This class makes a selection of those points or cells, so that
 * picking such glyphs does what the user sees. It takes the place of ParaView's vtkPVEncodeSelectionForServer from the
 * first ray-traced display on.
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
   * Makes objects of this class in place of ParaView's encoder.
   */
  static void Register();

  bool ProcessSelection(vtkSelection* rawSelection, vtkSMRenderViewProxy* viewProxy, bool multipleSelectionsAllowed,
    vtkCollection* selectedRepresentations, vtkCollection* selectionSources, int modifier, bool selectBlocks) override;

protected:
  vtkRayTracedSelectionEncoder() = default;
  ~vtkRayTracedSelectionEncoder() override = default;
};

#endif
