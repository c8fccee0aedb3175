/**
 * @class   vtkRayTracedTubeRepresentation
 * @brief   representation that shows the lines and poly-lines of any data set as tubes among the ray-traced glyphs of
 * the view
 *
 * Vertices and polygons are not shown.
 *
 * @sa RayTracedSurfaceGatherer vtkRayTracedTubeMapper
 */
#ifndef vtkRayTracedTubeRepresentation_h
#define vtkRayTracedTubeRepresentation_h

#include "vtkDataArray.h"
#include "vtkRayTracedSelectableRepresentation.h"
#include "vtkWeakPointer.h"

#include <string>

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedTubeRepresentation : public vtkRayTracedSelectableRepresentation
{
public:
  static vtkRayTracedTubeRepresentation* New();
  vtkTypeMacro(vtkRayTracedTubeRepresentation, vtkRayTracedSelectableRepresentation);

  ///@{
  /**
   * Radius in world units, times the values of an array of points or cells; "None" or empty: none. Default is 1, None.
   */
  void SetTubeRadius(double radius) { this->Radius = rtglyphs::RayTracedNumbers::NumberOr(radius, 0.0); }
  void SetTubeRadiusArray(const char* name) { this->RadiusArray = OrEmpty(name); }
  ///@}

  /**
   * 0: lines end in half balls; 1: in discs. Default is 0.
   */
  void SetTubeEnds(int ends) { this->FlatEnds = ends == 1; }

protected:
  vtkRayTracedTubeRepresentation();
  ~vtkRayTracedTubeRepresentation() override = default;

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const rtglyphs::RayTracedParallel::Progress& progress) override;
  const double* GetDataBounds(vtkPolyData* lines) override;
  rtglyphs::GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) override;
  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() override;
  void Configure(vtkInformation* inInfo, vtkPolyData* lines, bool lod, bool collective) override;

private:
  double LargestOf(vtkDataArray* radii);

  double Radius = 1.0;
  std::string RadiusArray;
  bool FlatEnds = false;
  vtkWeakPointer<vtkDataArray> Radii; // of cells, as they were at that time; their largest one
  vtkMTimeType RadiiTime = 0;
  double LargestRadius = 0.0;
};

#endif
