/**
 * @class   vtkSMRayTracedPickingHelperProxy
 * @brief   the point in space under a pixel, where that pixel shows glyphs
 *
 * ParaView picks points in space (the center of rotation, those of widgets) by intersecting a cell of the data with the
 * ray of the pixel. The cells of glyphs are vertices, or there are none, and no ray hits those: where the data are
 * shown ray traced, the point is that of the surface traced in the pixel. It takes the place of ParaView's
 * PickingHelper proxy from the first display on, and does what that does for everything else.
 */
#ifndef vtkSMRayTracedPickingHelperProxy_h
#define vtkSMRayTracedPickingHelperProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMProxy.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedPickingHelperProxy : public vtkSMProxy
{
public:
  static vtkSMRayTracedPickingHelperProxy* New();
  vtkTypeMacro(vtkSMRayTracedPickingHelperProxy, vtkSMProxy);

  /**
   * Makes proxies of this class, with ParaView's definition, in the session of a proxy.
   */
  static void Install(vtkSMProxy* proxy);

protected:
  vtkSMRayTracedPickingHelperProxy() = default;
  ~vtkSMRayTracedPickingHelperProxy() override = default;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  bool FindPlace(double place[3]);
};

#endif
