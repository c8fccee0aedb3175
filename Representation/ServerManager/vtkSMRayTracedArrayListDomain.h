/**
 * @class   vtkSMRayTracedArrayListDomain
 * @brief   a list of arrays whose default is chosen by what the arrays are
 *
 * ParaView's own list takes the active attribute, and without one whatever comes first. The attribute `choice` in the
 * XML says what is looked for:
 * - direction: the active vectors, unless they are normals and there is better, else of three components one that is
 * named as a direction (velocity before displacement, force, normal, others), else a quaternion, else any that is not
 * named as a position, angle, color or length.
 * - velocity: one named velocity, else the active vectors, unless they are normals.
 * - tensor: the active tensors, else of nine or six components one that is named as a tensor, else any that is not
 * named as a rotation.
 * - scale: one named radius or diameter, else the active scalars, else a direction, else any of one component but
 * labels; for arrows a direction first. Without any: None. See GlyphArrayNames for the names.
 */
#ifndef vtkSMRayTracedArrayListDomain_h
#define vtkSMRayTracedArrayListDomain_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMArrayListDomain.h"

#include <string>

class vtkPVDataSetAttributesInformation;
class vtkSMProxy;

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedArrayListDomain : public vtkSMArrayListDomain
{
public:
  static vtkSMRayTracedArrayListDomain* New();
  vtkTypeMacro(vtkSMRayTracedArrayListDomain, vtkSMArrayListDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

#ifndef __VTK_WRAP__
  /**
   * Whether the glyphs' GlyphType is an arrow, which is as long as its direction's array says where nothing else is
   * chosen.
   */
  static bool AreArrows(vtkSMProxy* glyphs);

  /**
   * Whether there is what `direction` or `tensor` would choose, whatever the list.
   */
  static bool HasDirectionsOrTensors(vtkPVDataSetAttributesInformation* attributes);
#endif

protected:
  vtkSMRayTracedArrayListDomain();
  ~vtkSMRayTracedArrayListDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMRayTracedArrayListDomain(const vtkSMRayTracedArrayListDomain&) = delete;
  void operator=(const vtkSMRayTracedArrayListDomain&) = delete;

  std::string Choose();

  std::string Choice;
};

#endif
