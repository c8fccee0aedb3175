/**
 * @class   SurfaceContent
 * @brief   the outer surface of any data set
 *
 * The surface is that of ParaView's ordinary surface representation: its triangles, colors, opacity and material.
 * Lines and vertices are not shown.
 *
 * @sa RayTracedSurfaceGatherer vtkRayTracedSurfaceMapper
 */
#ifndef SurfaceContent_h
#define SurfaceContent_h

#include "RayTracedContent.h"
#include "vtkRayTracedSurfaceMapper.h"

namespace rtglyphs
{

class SurfaceContent final : public RayTracedContent
{
public:
  using RayTracedContent::RayTracedContent;

  bool Smooth = true; // the points' normals, computed where the data have none, are interpolated
  int NonlinearSubdivisionLevel = 1;

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const RayTracedParallel::Progress& progress) const override;
  std::array<int, 3> GatherOptions() const override { return { 1, this->Smooth, this->NonlinearSubdivisionLevel }; }
  // Where unstructured data are spread over processes, ghost cells mark the faces between two pieces as inner ones.
  bool NeedsGhostCells() const override { return true; }
  bool MarksSelection() const override { return false; }
  GlyphSettings GetSizes(vtkPolyData* points, double& unitSize) override;

  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() const override
  {
    return vtkSmartPointer<vtkRayTracedSurfaceMapper>::New();
  }
  void Configure(const Frame& frame) override;
  void Show(bool) override { this->RayTracedContent::Show(false); }
};

} // namespace rtglyphs

#endif
