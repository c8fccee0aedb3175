/**
 * @class   vtkSMRayTracedInputProperty
 * @brief   an input of this plugin that is chosen from a list of sources
 *
 * The list's default source counts as the default where nothing ray traced is shown; see vtkSMRayTracedDefault.
 */
#ifndef vtkSMRayTracedInputProperty_h
#define vtkSMRayTracedInputProperty_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMInputProperty.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedInputProperty : public vtkSMInputProperty
{
public:
  static vtkSMRayTracedInputProperty* New();
  vtkTypeMacro(vtkSMRayTracedInputProperty, vtkSMInputProperty);

  bool IsValueDefault() override;

protected:
  vtkSMRayTracedInputProperty() = default;
  ~vtkSMRayTracedInputProperty() override = default;

private:
  vtkSMRayTracedInputProperty(const vtkSMRayTracedInputProperty&) = delete;
  void operator=(const vtkSMRayTracedInputProperty&) = delete;
};

#endif
