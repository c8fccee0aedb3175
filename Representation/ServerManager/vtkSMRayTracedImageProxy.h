/**
 * @class   vtkSMRayTracedImageProxy
 * @brief   the settings of a view's ray-traced image, as one of the view's displays has them
 *
 * On the client only. Once the display is in a view they are those of the view's vtkSMRayTracedViewProxy.
 * RenderStatistics are the view's and the display's own.
 */
#ifndef vtkSMRayTracedImageProxy_h
#define vtkSMRayTracedImageProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkSMRayTracedViewProxy;

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedImageProxy : public vtkSMProxy
{
public:
  static vtkSMRayTracedImageProxy* New();
  vtkTypeMacro(vtkSMRayTracedImageProxy, vtkSMProxy);

  /**
   * Of a display; null where it has none.
   */
  static vtkSMRayTracedImageProxy* Of(vtkSMProxy* display);

  /**
   * The display is in this view now.
   */
  void EnterView(vtkSMProxy* view);

  vtkSMRayTracedViewProxy* GetView();

  /**
   * Whether the display is visible and shown as something ray traced.
   */
  bool IsShown();

  void SetStatistics(const std::string& statistics);

protected:
  vtkSMRayTracedImageProxy();
  ~vtkSMRayTracedImageProxy() override;

  void SetPropertyModifiedFlag(const char* name, int flag) override;
  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMRayTracedImageProxy(const vtkSMRayTracedImageProxy&) = delete;
  void operator=(const vtkSMRayTracedImageProxy&) = delete;

  void Pushed(vtkObject*, unsigned long, void* name);

  vtkSmartPointer<vtkSMRayTracedViewProxy> View; // null: the display is in none
};

#endif
