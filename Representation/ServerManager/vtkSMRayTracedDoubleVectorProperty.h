/**
 * @class   vtkSMRayTracedDoubleVectorProperty
 * @brief   numbers of this plugin that depend on the data
 *
 * Its value counts as the default where ParaView has chosen it and nothing ray traced is shown; see
 * vtkSMRayTracedDefault.
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

protected:
  vtkSMRayTracedDoubleVectorProperty() = default;
  ~vtkSMRayTracedDoubleVectorProperty() override = default;

private:
  vtkSMRayTracedDoubleVectorProperty(const vtkSMRayTracedDoubleVectorProperty&) = delete;
  void operator=(const vtkSMRayTracedDoubleVectorProperty&) = delete;

#ifndef __VTK_WRAP__
  vtkSMRayTracedDefault Default;
#endif
};

#endif
