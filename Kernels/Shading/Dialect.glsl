// The common subset of GLSL and C++ that Frame.glsl, Sobol.glsl, Principled.glsl and Tone.glsl are written in. C++ gets
// the same names from Shading.h.
#ifndef RTG_SHADING_DIALECT
#define RTG_SHADING_DIALECT

#define RTG_SHADING_FN
#define RTG_SHADING_OUT(type) out type

#endif
