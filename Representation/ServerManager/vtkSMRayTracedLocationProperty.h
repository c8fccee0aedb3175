/**
 * @class   vtkSMRayTracedLocationProperty
 * @brief   whether glyphs stand on points (0) or cells (1)
 *
 * The default is cells where only these have directions or tensors. It counts as the default of the XML where nothing
 * ray traced is shown; see vtkSMRayTracedDefault.
 */
#ifndef vtkSMRayTracedLocationProperty_h
#define vtkSMRayTracedLocationProperty_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMIntVectorProperty.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "vtkSMRayTracedDefault.h"
#endif

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedLocationProperty : public vtkSMIntVectorProperty
{
public:
  static vtkSMRayTracedLocationProperty* New();
  vtkTypeMacro(vtkSMRayTracedLocationProperty, vtkSMIntVectorProperty);

  bool IsValueDefault() override;
  bool ResetToDomainDefaults(bool useUncheckedValues = false) override;
  void Modified() override;

#ifndef __VTK_WRAP__
  /**
   * To be called when its domains would choose otherwise; see vtkSMRayTracedDefault::Renew().
   */
  bool RenewDefault(vtkSMRayTracedDefault::Where where);
#endif

protected:
  vtkSMRayTracedLocationProperty() = default;
  ~vtkSMRayTracedLocationProperty() override = default;

private:
  vtkSMRayTracedLocationProperty(const vtkSMRayTracedLocationProperty&) = delete;
  void operator=(const vtkSMRayTracedLocationProperty&) = delete;

#ifndef __VTK_WRAP__
  vtkSMRayTracedDefault Default;
#endif
};

#endif
