/**
 * @class   vtkSMRayTracedDoubleVectorProperty
 * @brief   numbers of this plugin that somebody else sets
 *
 * Its value counts as the default where the data have chosen it, which a property of the same name with FromData behind
 * it says, or ParaView, by a domain. See vtkSMRayTracedDefault.
 */
#ifndef vtkSMRayTracedDoubleVectorProperty_h
#define vtkSMRayTracedDoubleVectorProperty_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMDoubleVectorProperty.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "vtkSMRayTracedDefault.h"
#endif

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedDoubleVectorProperty : public vtkSMDoubleVectorProperty
{
public:
  static vtkSMRayTracedDoubleVectorProperty* New();
  vtkTypeMacro(vtkSMRayTracedDoubleVectorProperty, vtkSMDoubleVectorProperty);

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
  vtkSMRayTracedDoubleVectorProperty() = default;
  ~vtkSMRayTracedDoubleVectorProperty() override = default;

private:
  vtkSMRayTracedDoubleVectorProperty(const vtkSMRayTracedDoubleVectorProperty&) = delete;
  void operator=(const vtkSMRayTracedDoubleVectorProperty&) = delete;

  bool IsFromData();

#ifndef __VTK_WRAP__
  vtkSMRayTracedDefault Default;
#endif
};

#endif
