/**
 * @class   vtkDirectionLegend
 * @brief   the sphere of directions with their colors, in the corner of a view
 *
 * It is turned as the view is: a glyph has the color that the sphere has where a glyph from its center along the same
 * direction would leave it. Where opposite directions differ its back is beside it, as if the sphere were of glass.
 */
#ifndef vtkDirectionLegend_h
#define vtkDirectionLegend_h

#include "DirectionColors.h"
#include "vtkRayTracedLegend.h"

class vtkDirectionLegend : public vtkRayTracedLegend
{
public:
  static vtkDirectionLegend* New();
  vtkTypeMacro(vtkDirectionLegend, vtkRayTracedLegend);

  /**
   * Of rtglyphs::DirectionColors; with NONE nothing is shown. Default is NONE.
   */
  void SetColoring(int kind) { this->Coloring = kind; }

protected:
  vtkDirectionLegend() { this->Place = UPPER_RIGHT; }
  ~vtkDirectionLegend() override = default;

  bool Draw(vtkViewport* viewport, vtkBoundingBox& box) override;

private:
  int Coloring = rtglyphs::DirectionColors::NONE;
};

#endif
