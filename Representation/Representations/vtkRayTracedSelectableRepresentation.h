/**
 * @class   vtkRayTracedSelectableRepresentation
 * @brief   ray-traced representation that shows in another color what ParaView's selection has of its data, and
 * directions as colors: of glyphs and tubes
 *
 * The filter that extracts the selection of the input is one more input. Another selection gathers nothing anew.
 *
 * @sa GlyphSelection
 */
#ifndef vtkRayTracedSelectableRepresentation_h
#define vtkRayTracedSelectableRepresentation_h

#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkRayTracedRepresentation.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "vtkDirectionLegend.h"
#endif

#include <array>
#include <vector>

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedSelectableRepresentation : public vtkRayTracedRepresentation
{
public:
  vtkTypeMacro(vtkRayTracedSelectableRepresentation, vtkRayTracedRepresentation);

  /**
   * The color of what is selected; default is ParaView's, magenta.
   */
  void SetSelectionColor(double red, double green, double blue);

  ///@{
  /**
   * How directions become colors (rtglyphs::DirectionColors), and where in the view their key is. Default is not at
   * all, and the upper right corner.
   */
  void SetGlyphDirectionColoring(int kind);
  void SetGlyphDirectionKey(int place);
  ///@}

protected:
  /**
   * The last of the ports is that of what is selected.
   */
  explicit vtkRayTracedSelectableRepresentation(int ports);
  ~vtkRayTracedSelectableRepresentation() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  vtkSmartPointer<vtkDataObject> GatherTree(vtkDataObject* input, const int* wholeExtent) final;
  void ShowLayers(bool visible) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /**
   * The same input is gathered again.
   */
  void ForgetGathered() { this->Gathered = nullptr; }

  const std::array<double, 3>& GetSelectionColor() const { return this->SelectionColor; }

  /**
   * What comes, goes and is hidden with the representation in the views' corners.
   */
  virtual std::vector<vtkRayTracedLegend*> GetLegends() { return { this->Key }; }

  /**
   * What the key shows is what the representation does with it.
   */
  int DirectionColoring = rtglyphs::DirectionColors::NONE;
  vtkNew<vtkDirectionLegend> Key;

private:
  bool HasSelection();

  const int SelectionPort;
  vtkSmartPointer<vtkDataObject> Gathered; // of an input of these times; null: they must be gathered
  vtkDataObject* GatheredInput = nullptr;  // only to be compared
  std::array<vtkMTimeType, 2> GatheredTimes{};
  vtkSmartPointer<vtkDataObject> Extracted; // what is selected of the input; null: no selection
  std::array<double, 3> SelectionColor{ { 1.0, 0.0, 1.0 } };
};

#endif
