/**
 * Domains of this plugin's properties: which arrays there are, where glyphs stand, sizes that fit the data.
 */
#ifndef vtkSMRayTracedDomains_h
#define vtkSMRayTracedDomains_h

namespace vtkSMRayTracedDomains
{
/**
 * Makes them known to the server manager, once.
 */
void Register();
}

#endif
// VTK-HeaderTest-Exclude: vtkSMRayTracedDomains.h
