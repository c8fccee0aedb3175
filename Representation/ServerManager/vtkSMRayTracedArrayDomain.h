/**
 * @class   vtkSMRayTracedArrayDomain
 * @brief   the arrays that glyphs of an input can use: of its points, or of its cells, by GlyphLocation
 *
 * In the server manager's XML it is written as an InputArrayDomain of point arrays.
 */
#ifndef vtkSMRayTracedArrayDomain_h
#define vtkSMRayTracedArrayDomain_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMInputArrayDomain.h"

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedArrayDomain : public vtkSMInputArrayDomain
{
public:
  static vtkSMRayTracedArrayDomain* New();
  vtkTypeMacro(vtkSMRayTracedArrayDomain, vtkSMInputArrayDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int GetAttributeType() override;

protected:
  vtkSMRayTracedArrayDomain();
  ~vtkSMRayTracedArrayDomain() override;

private:
  vtkSMRayTracedArrayDomain(const vtkSMRayTracedArrayDomain&) = delete;
  void operator=(const vtkSMRayTracedArrayDomain&) = delete;
};

#endif
