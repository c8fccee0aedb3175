/**
 * @class   vtkSMRayTracedRadiusDomain
 * @brief   values of TubeRadius: from zero to a few times what the data suggest
 *
 * Required properties: Input, and Array, the name of an array of points or cells that the radius is multiplied by. The
 * default is such that the thickest tube has a radius of `scale_factor` times the longest side of the data.
 *
 * ParaView's panel gives domains of bounds a slider and a reset button.
 */
#ifndef vtkSMRayTracedRadiusDomain_h
#define vtkSMRayTracedRadiusDomain_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMBoundsDomain.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedRadiusDomain : public vtkSMBoundsDomain
{
public:
  static vtkSMRayTracedRadiusDomain* New();
  vtkTypeMacro(vtkSMRayTracedRadiusDomain, vtkSMBoundsDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* property) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMRayTracedRadiusDomain();
  ~vtkSMRayTracedRadiusDomain() override;

private:
  vtkSMRayTracedRadiusDomain(const vtkSMRayTracedRadiusDomain&) = delete;
  void operator=(const vtkSMRayTracedRadiusDomain&) = delete;

  double LargestValue();

  double Suggested = 0.0; // 0: nothing
};

#endif
