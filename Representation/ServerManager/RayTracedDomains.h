/**
 * Domains of this plugin's properties: which arrays there are, where glyphs stand, sizes that fit the data.
 */
#ifndef RayTracedDomains_h
#define RayTracedDomains_h

namespace rtglyphs::RayTracedDomains
{
/**
 * Makes them known to the server manager, once.
 */
void Register();
}

#endif
