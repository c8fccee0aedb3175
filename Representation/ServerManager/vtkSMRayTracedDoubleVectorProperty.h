/**
 * @class   vtkSMRayTracedDoubleVectorProperty
 * @brief   numbers of this plugin that somebody else sets
 *
 * Its value counts as the default where the data have chosen it, which a property of the same name with FromData behind
 * it says, and where it is but another name of one of ParaView's own; see vtkSMRayTracedDefault.
 */
#ifndef vtkSMRayTracedDoubleVectorProperty_h
#define vtkSMRayTracedDoubleVectorProperty_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMDoubleVectorProperty.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedDoubleVectorProperty : public vtkSMDoubleVectorProperty
{
public:
  static vtkSMRayTracedDoubleVectorProperty* New();
  vtkTypeMacro(vtkSMRayTracedDoubleVectorProperty, vtkSMDoubleVectorProperty);

  bool IsValueDefault() override;

protected:
  vtkSMRayTracedDoubleVectorProperty() = default;
  ~vtkSMRayTracedDoubleVectorProperty() override = default;

private:
  vtkSMRayTracedDoubleVectorProperty(const vtkSMRayTracedDoubleVectorProperty&) = delete;
  void operator=(const vtkSMRayTracedDoubleVectorProperty&) = delete;

  bool IsFromData();
};

#endif
