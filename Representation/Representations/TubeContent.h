/**
 * @class   TubeContent
 * @brief   the lines and poly-lines of any data set as tubes; vertices and polygons are not shown
 *
 * @sa RayTracedSurfaceGatherer vtkRayTracedTubeMapper
 */
#ifndef TubeContent_h
#define TubeContent_h

#include "RayTracedCache.h"
#include "RayTracedContent.h"
#include "vtkRayTracedTubeMapper.h"

namespace rtglyphs
{

class TubeContent final : public RayTracedContent
{
public:
  using RayTracedContent::RayTracedContent;

  RayTracedTubeBuilder::Settings Settings; // but for what Configure() adds

  vtkSmartPointer<vtkPolyData> Gather(vtkDataObject* data, const int* wholeExtent, bool isBlock,
    const RayTracedParallel::Progress& progress) const override;
  std::array<int, 3> GatherOptions() const override { return { 2, 0, 0 }; }
  GlyphSettings GetSizes(vtkPolyData* lines, double& unitSize) override;

  vtkSmartPointer<vtkRayTracedMapper> MakeMapper() const override
  {
    return vtkSmartPointer<vtkRayTracedTubeMapper>::New();
  }
  void Configure(const Frame& frame) override;

private:
  double LargestOf(vtkDataArray* radii);

  RayTracedCache<vtkMTimeType> KnownRadii;
  double LargestRadius = 0.0;
};

} // namespace rtglyphs

#endif
