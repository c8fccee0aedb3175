/**
 * The default light of ambient occlusion and path tracing, which shows shape: a sky that is brighter above than below
 * and, in path tracing, a key light from above on the left, as in a photographer's studio. Both follow the camera.
 * People take light to come from there (Sun and Perona, "Where is the sun?", Nature Neuroscience 1, 1998).
 */
#ifndef RayTracedStudioLight_h
#define RayTracedStudioLight_h

#include "ProgressiveImage.h"

class vtkRenderer;

namespace rtglyphs::RayTracedStudioLight
{
/**
 * Changes the light of an image, whose settings and lights are those of a uniform sky, to that of the studio. Ambient
 * occlusion keeps the view's lights beside the sky. Path tracing takes the key light unless the view has lights that
 * are placed in the scene. A surface that faces the light, without occlusion, shows its color; what no
 * array colors reflects four fifths of the light at most.
 */
void Apply(rtg::ImageView& view, vtkRenderer* renderer);
}

#endif
