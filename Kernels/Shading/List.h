// Shading modes: number, name (rtg::Shading), program (Programs/<program>.comp),
// and what else it differs in (rtg::ShadingTraits):
//   scatters: rays leave surfaces in random directions, so that images are noisy; with shadows all are
//   linear: images are light in linear units, else display colors
//   layers: translucent surfaces are composited front to back; else rays pass them at random
//   environmentImage: an image may be the environment light
//   withShadows: the mode whose program traces this one with TraceSettings::shadows; none: lights always cast them
//   rays: the setting that says how many start from what a camera ray hits
//   atOnce: log2 of the camera rays of a dispatch
// CMakeLists.txt reads these lines, too.
#pragma once

// clang-format off
#define RTG_SHADINGS(ENTRY)                                                                                            \
  /* the view's lights, as if the surface were alone */                                                                \
  ENTRY(0, Local, image, /*scatters*/ false, /*linear*/ false, /*layers*/ true, /*environmentImage*/ false,            \
    /*withShadows*/ Shading::AmbientOcclusion, nullptr, 28)                                                            \
  /* times the unoccluded fraction of environment light */                                                             \
  ENTRY(1, AmbientOcclusion, occlusion, true, true, true, false, Shading::AmbientOcclusion,                            \
    &TraceSettings::occlusionRays, 26)                                                                                 \
  /* all around and the view's lights, after up to maximumBounces scatterings */                                       \
  ENTRY(2, PathTracing, path, true, true, false, true, std::nullopt, &TraceSettings::paths, 23)
// clang-format on
