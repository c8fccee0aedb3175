// Where the light comes from that is seen on a surface: number, name (rtg::Shading), program (Programs/<program>.comp).
// CMakeLists.txt reads these lines, too.
#pragma once

#define RTG_SHADINGS(ENTRY)                                                                                            \
  ENTRY(0, Local, image)                /* the view's lights, as if the surface were alone */                          \
  ENTRY(1, AmbientOcclusion, occlusion) /* times the share of light from all around that reaches it */                 \
  ENTRY(2, PathTracing, path)           /* all around and the view's lights, after up to maximumBounces scatterings */
