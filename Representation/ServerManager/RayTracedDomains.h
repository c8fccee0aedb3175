/**
 * Domains of this plugin's properties: which arrays there are, where glyphs stand, sizes that fit the data.
 */
#ifndef RayTracedDomains_h
#define RayTracedDomains_h

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"

namespace rtglyphs::RayTracedDomains
{
/**
 * Makes a class known to the server manager by that name.
 */
template <class T>
void Register(const char* name)
{
  vtkClientServerInterpreterInitializer::GetGlobalInterpreter()->AddNewInstanceFunction(name,
    [](void*) -> vtkObjectBase*
    {
      auto* made = new T;
      made->InitializeObjectBase();
      return made;
    });
}

/**
 * Makes the domains known, once.
 */
void Register();
}

#endif
