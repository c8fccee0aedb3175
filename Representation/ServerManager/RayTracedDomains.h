/**
 * Domains of this plugin's properties: which arrays there are, where glyphs stand, sizes that fit the data. And the
 * class of the properties, in XML RayTracedStringVectorProperty and so on, which CMakeLists.txt puts in place of
 * StringVectorProperty.
 */
#ifndef RayTracedDomains_h
#define RayTracedDomains_h

namespace rtglyphs::RayTracedDomains
{
/**
 * Makes them known to the server manager. May be called again.
 */
void Register();
}

#endif
