#ifndef RayTracedPanel_h
#define RayTracedPanel_h

class vtkSMProxy;

namespace rtglyphs::RayTracedPanel
{
/**
 * The panel of a display shows 3D Glyphs' properties at once, path tracing's material not with Interpolation PBR alone,
 * and what has no effect on what is ray traced not beside it.
 */
void Show(vtkSMProxy* display);
}

#endif
