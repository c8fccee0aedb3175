/**
 * @class   vtkSMRayTracedRepresentationProxy
 * @brief   the client's side of ray-traced glyphs, surfaces and tubes
 *
 * - What neither the user nor a script has chosen is kept up to date with the data (RayTracedChoices).
 * - Information properties speak of the processes that have the data, of what is shown.
 */
#ifndef vtkSMRayTracedRepresentationProxy_h
#define vtkSMRayTracedRepresentationProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkSmartPointer.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "RayTracedChoices.h"
#endif

class vtkSMRayTracedViewProxy;
class vtkSMSourceProxy;

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMRayTracedRepresentationProxy* New();
  vtkTypeMacro(vtkSMRayTracedRepresentationProxy, vtkSMRepresentationProxy);

  void ViewUpdated(vtkSMProxy* view) override;

#ifndef __VTK_WRAP__
  rtglyphs::RayTracedChoices& GetChoices()
  {
    return this->Choices;
  }
#endif

protected:
  vtkSMRayTracedRepresentationProxy();
  ~vtkSMRayTracedRepresentationProxy() override = default;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;
  void SetPropertyModifiedFlag(const char* name, int flag) override;
  void AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer) override;

private:
  bool IsShown();
  void ConnectMolecule();
  void ConnectSelection();
  void ChooseDefaults();

  vtkSmartPointer<vtkSMRayTracedViewProxy> View;   // the owner of its settings; null: the display is in none
  vtkSmartPointer<vtkSMSourceProxy> AtomsAndBonds; // of a molecule, else null
  double Time = 0.0;                               // of the last update
#ifndef __VTK_WRAP__
  rtglyphs::RayTracedChoices Choices;
#endif
};

#endif
