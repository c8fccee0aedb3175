/**
 * @class   vtkRayTracedLegend
 * @brief   a drawing, and words below it, in a corner of a view
 *
 * It stands clear of color bars, orientation axes and other legends that are in its corner. Subclasses draw.
 */
#ifndef vtkRayTracedLegend_h
#define vtkRayTracedLegend_h

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProp.h"
#include "vtkTextActor.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <vector>

class vtkBoundingBox;
class vtkPVRenderView;
class vtkRenderer;

class vtkRayTracedLegend : public vtkProp
{
public:
  vtkTypeMacro(vtkRayTracedLegend, vtkProp);

  using Box = std::array<glm::dvec2, 2>; // lower left and upper right, in pixels of the view

  enum Places
  {
    NONE = 0,
    LOWER_LEFT = 1,
    LOWER_RIGHT = 2,
    UPPER_LEFT = 3,
    UPPER_RIGHT = 4
  };

  ///@{
  /**
   * Corner of the view, or NONE, which is the default.
   */
  void SetPlace(int place) { this->Place = std::clamp<int>(place, NONE, UPPER_RIGHT); }
  bool IsOn() const { return this->Place != NONE; }
  ///@}

  ///@{
  /**
   * Among what `view` draws over its picture, on the process that shows it.
   */
  void AddTo(vtkPVRenderView* view);
  void RemoveFrom(vtkPVRenderView* view);
  ///@}

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRayTracedLegend();
  ~vtkRayTracedLegend() override = default;

  /**
   * Sets the drawing, in pixels, and its box, and the words, which may be none; both are black or white, whichever
   * stands out from the background, unless the drawing has colors. False: there is nothing to show.
   */
  virtual bool Draw(vtkViewport* viewport, vtkBoundingBox& box) = 0;
  void SetWords(const char* words);

  int Place = NONE;
  vtkNew<vtkPolyData> Drawing;
  vtkNew<vtkActor2D> Actor;
  vtkWeakPointer<vtkRenderer> Scene; // behind the legend

private:
  void Arrange(vtkViewport* viewport);
  std::vector<Box> Obstacles(vtkRenderer* renderer) const;
  glm::dvec2 FindPlace(vtkRenderer* renderer, const Box& wanted, double margin) const;

  vtkNew<vtkPolyDataMapper2D> Mapper;
  vtkNew<vtkTextActor> Text;
  bool Shows = false;
  Box Covered{}; // while it shows
};

#endif
