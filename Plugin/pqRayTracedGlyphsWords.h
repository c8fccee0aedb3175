/**
 * Texts of the toolbar and of ParaView's progress bar on an image.
 */
#ifndef pqRayTracedGlyphsWords_h
#define pqRayTracedGlyphsWords_h

#include <QString>

class vtkSMRayTracedViewProxy;

namespace pqRayTracedGlyphsWords
{
/**
 * How far the image of a view is and how long the rest takes, or that it waits for programs. `refined`: it goes on.
 */
QString Of(vtkSMRayTracedViewProxy* scene, bool refined);

/**
 * A time, roughly.
 */
QString ForTime(double seconds);
}

#endif
