/**
 * @class   vtkSMRayTracedScaleDomain
 * @brief   values of ShutterTime: from zero to a few times what the data suggest
 *
 * Required properties: Guess, an information property whose first element is what the data suggest, and FromData, which
 * says whether that counts. The default of the domain is to let it count, chosen anew: the data themselves are asked
 * when the view is next updated.
 *
 * ParaView's panel gives domains of bounds a slider and a reset button.
 */
#ifndef vtkSMRayTracedScaleDomain_h
#define vtkSMRayTracedScaleDomain_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMBoundsDomain.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedScaleDomain : public vtkSMBoundsDomain
{
public:
  static vtkSMRayTracedScaleDomain* New();
  vtkTypeMacro(vtkSMRayTracedScaleDomain, vtkSMBoundsDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* property) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMRayTracedScaleDomain();
  ~vtkSMRayTracedScaleDomain() override;

private:
  vtkSMRayTracedScaleDomain(const vtkSMRayTracedScaleDomain&) = delete;
  void operator=(const vtkSMRayTracedScaleDomain&) = delete;
};

#endif
