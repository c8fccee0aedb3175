// The common subset of GLSL and C++ that the shapes and much of Shading are written in. C++ gets the same names from
// Shapes.h and Shading.h.
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define RTG_FN
#define RTG_SHAPE uint
#define RTG_IS(shape, number) IsOfShape(shape, number)
#define RTG_OUT(type) out type
#define RTG_UNROLL [[unroll]]
#define RTG_VALUES FloatArray // HostDevice.h
#define RTG_VALUE(glyph, index) glyph.values.at[glyph.firstValue + (index)]
#define RTG_DEGREE(glyph) int(degree) // the largest of a program's polynomials, which it is specialized for

#define RTG_ROUNDOFF 5.9604644775390625e-8 // u = 2^-24, half an ulp of 1
#define RTG_SPLITTER 4097.0                // 2^12 + 1, Dekker's constant for 24 bits
#define RTG_NEVER 1.0e30                   // a ray parameter that no ray reaches
