/**
 * @class   vtkSMRayTracedGlyphRepresentationProxy
 * @brief   a representation whose information properties speak of the process that renders
 *
 * ParaView asks the client for information about whatever is there too. With remote rendering nothing happens there,
 * and the server's first rank is asked.
 */
#ifndef vtkSMRayTracedGlyphRepresentationProxy_h
#define vtkSMRayTracedGlyphRepresentationProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMRepresentationProxy.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedGlyphRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMRayTracedGlyphRepresentationProxy* New();
  vtkTypeMacro(vtkSMRayTracedGlyphRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMRayTracedGlyphRepresentationProxy();
  ~vtkSMRayTracedGlyphRepresentationProxy() override;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMRayTracedGlyphRepresentationProxy(const vtkSMRayTracedGlyphRepresentationProxy&) = delete;
  void operator=(const vtkSMRayTracedGlyphRepresentationProxy&) = delete;
};

#endif
