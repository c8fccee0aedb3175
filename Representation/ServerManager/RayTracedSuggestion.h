/**
 * Numbers that the data suggest until they are set: ScaleFactor and ShutterTime, while the property of that name
 * with FromData behind it is on.
 */
#ifndef RayTracedSuggestion_h
#define RayTracedSuggestion_h

#include "vtkRayTracedGlyphsModule.h" // for export macro

class vtkSMProxy;

namespace rtglyphs::RayTracedSuggestion
{
/**
 * A property is being set, of the representation that the display exposes it of: a number that the user sets no longer
 * follows the data. To be called before observers of the property are, so that undoing both ends with the data's.
 */
void Follow(vtkSMProxy* representation, const char* name);

/**
 * Between the update and the render of a view: processes that have the data have found the numbers of what is shown,
 * and those that render get them.
 */
void Take(vtkSMProxy* shown);

/**
 * Whether it is Take() that sets a number.
 */
VTKRAYTRACEDGLYPHS_EXPORT bool IsTaking();
}

#endif
