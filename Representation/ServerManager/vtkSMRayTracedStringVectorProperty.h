/**
 * @class   vtkSMRayTracedStringVectorProperty
 * @brief   an array's name, or another text, of this plugin
 *
 * Its value counts as the default where ParaView has chosen it and nothing ray traced is shown; see
 * vtkSMRayTracedDefault.
 */
#ifndef vtkSMRayTracedStringVectorProperty_h
#define vtkSMRayTracedStringVectorProperty_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMStringVectorProperty.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "vtkSMRayTracedDefault.h"
#endif

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedStringVectorProperty : public vtkSMStringVectorProperty
{
public:
  static vtkSMRayTracedStringVectorProperty* New();
  vtkTypeMacro(vtkSMRayTracedStringVectorProperty, vtkSMStringVectorProperty);

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
  vtkSMRayTracedStringVectorProperty() = default;
  ~vtkSMRayTracedStringVectorProperty() override = default;

private:
  vtkSMRayTracedStringVectorProperty(const vtkSMRayTracedStringVectorProperty&) = delete;
  void operator=(const vtkSMRayTracedStringVectorProperty&) = delete;

#ifndef __VTK_WRAP__
  vtkSMRayTracedDefault Default;
#endif
};

#endif
