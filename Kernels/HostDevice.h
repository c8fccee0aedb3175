// Structures that the host fills and the programs read: one text for C++ and GLSL (scalar block layout).
// C++ includes it inside namespace rtg::device after glm; GLSL after the buffer_reference extensions.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
namespace rtg::device
{
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
#define RTG_ADDRESS(type) std::uint64_t
#else
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#define RTG_ARRAY(name, type, access, alignment)                                                                       \
  layout(buffer_reference, scalar, buffer_reference_align = alignment) access buffer name                              \
  {                                                                                                                    \
    type at[];                                                                                                         \
  };
RTG_ARRAY(Vec3Array, vec3, readonly, 4)
RTG_ARRAY(Vec4Array, vec4, readonly, 4)
RTG_ARRAY(FloatArray, float, readonly, 4)
RTG_ARRAY(UintArray, uint, readonly, 4)
RTG_ARRAY(Uvec2Array, uvec2, readonly, 8)
RTG_ARRAY(UintImage, uint, , 4)
RTG_ARRAY(FloatImage, float, , 4)
#define RTG_ADDRESS(type) type
#endif

#include "Variants.h"

// A GlyphTree on the device.
struct TreeRecord
{
  RTG_ADDRESS(UintArray) nodes; // GlyphTreeNode
  RTG_ADDRESS(UintArray) order; // slice by slice, the thing at each place, or none (specialized)
  uint levels;
  uint leafBits;
  uint sliceBits;
  uint nodesPerSlice;
};

// What lies between two parallel planes, or before one of them: a normal, and where along it the slab begins and ends,
// as sums of two floats.
struct SectionSlab
{
  vec3 normal;
  vec2 lower;
  vec2 upper;
};

// The record of a set, or of a periodic image of it (the custom index of its instance in the driver's structure). Only
// values of features that the set has are valid.
struct GlyphSetRecord
{
#define RTG_FIELD(number, BIT, type, name, values, words) RTG_ADDRESS(type) name;
  RTG_GLYPH_ARRAYS(RTG_FIELD)
#undef RTG_FIELD
#define RTG_FIELD(type, name, value) type name;
  RTG_GLYPH_NUMBERS(RTG_FIELD)
#undef RTG_FIELD
#define RTG_FIELD(type, name) type name;
  RTG_MATERIAL(RTG_FIELD)
#undef RTG_FIELD
  vec3 lower; // bounds in the scene's coordinates
  vec3 upper;
  TreeRecord tree;      // when the set is traced by it
  vec3 offset;          // of the set's origin from the scene's: high part, as in the transform
  vec3 offsetLow;       // what the high part's rounding left
  uint polynomialWidth; // values of a glyph
  uint variants;        // Variants.h
  uint setId;
  uint glyphCount;
  uint translucent;                  // belongs to the translucent pass
  uint mask;                         // one bit of instance masks
  uint colored;                      // glyphs have colors of their own, also in ambient light
  RTG_ADDRESS(UintArray) colorTable; // of values at ends, when specialized
  uint colorTableSize;
  float coatReflectance; // of the coat at normal incidence
  // Of mesh glyphs, with positions relative to the middle of the mesh
  RTG_ADDRESS(Vec3Array) meshPositions;
  RTG_ADDRESS(UintArray) meshTriangles;  // three a triangle
  RTG_ADDRESS(Vec3Array) meshNormals;    // none unless specialized, as velocities and accelerations
  RTG_ADDRESS(UintArray) meshColors;     // by position or by triangle, or values and their table, or none (specialized)
  RTG_ADDRESS(Vec3Array) meshVelocities; // MeshTree.h
  RTG_ADDRESS(Vec3Array) meshAccelerations;
  uint meshValueCount; // values of positions, behind which the table lies
  uint meshTableSize;
  uint meshTriangleCount;
  vec3 meshMiddle;
  float meshRadius; // of the ball round its middle that holds it all the time
  TreeRecord meshTree;
  uint firstInstance; // of the driver's triangles: the instance of the set's first glyph
  uint meshClosed;    // triangles bound a body
  // A cut: of a convex body, the intersection of so many slabs
  SectionSlab sectionSlab0;
  SectionSlab sectionSlab1;
  SectionSlab sectionSlab2;
  uint sectionSlabs;
  uint sectionKeepsInside; // of the body, else what is outside it
  uint sectionFaces;       // rtg::Section::Faces
  uint sectionColors;      // caps have the color
  vec3 sectionColor;
};

struct LightRecord
{
  uint kind; // 0 headlight, 1 directional, 2 positional
  vec3 color;
  vec3 position; // relative to the scene's origin
  vec3 direction;
  vec3 attenuation;
  float cosCone; // cosine of the half angle; -2: no spot
  float exponent;
  float spread; // 1 - cosine of the angular radius of a directional one
  float radius; // of a positional one
  uint casts;   // shadows
};

// A pixel's sums, when samples will be added later.
struct PixelSums
{
  vec3 color;    // of the samples that hit: color times opacity, as a sum of two floats
  vec3 colorLow; // what rounding has left of it
  float opacity; // likewise
  float opacityLow;
  float missing;     // of the light on the ground, where it is visible: not in the opacity
  float depth;       // view depth of the nearest sample that hit; of the center's, negated, if that hit
  float opaqueDepth; // of the nearest opaque surface, in an image of translucent ones
};

// Sums of what the samples' camera rays hit, for denoising and scripts.
struct PixelFeatures
{
  vec3 normal;
  vec3 albedo;
  float depth; // view depth
  float hits;
};

#ifndef __cplusplus
RTG_ARRAY(PixelSumsImage, PixelSums, , 4)
RTG_ARRAY(PixelFeaturesImage, PixelFeatures, , 4)
RTG_ARRAY(GlyphSetRecords, GlyphSetRecord, readonly, 8)
RTG_ARRAY(LightRecords, LightRecord, readonly, 4)
#endif

// Rays next to each other in a launch that a workgroup traces; launches are whole multiples as wide.
const uint LAUNCH_GROUP = 64u;

// Bits of instance masks. Sets that camera rays do not see shade the others all the same.
const uint OPAQUE_MASK = 1u;
const uint TRANSLUCENT_MASK = 2u;
const uint INDIRECT_OPAQUE_MASK = 4u;
const uint INDIRECT_TRANSLUCENT_MASK = 8u;
const uint ANY_MASK = OPAQUE_MASK | TRANSLUCENT_MASK | INDIRECT_OPAQUE_MASK | INDIRECT_TRANSLUCENT_MASK;

// Layers of translucent surfaces that one traversal gathers at most, and the fraction of light below which what shines
// through them is left out: half a level of a display's 255.
const uint LAYER_CAPACITY = 24u;
const float MIN_TRANSMITTANCE = 1.0f / 512.0f;

// Where a slab begins that has one plane only, and what becomes of glyphs that a cut meets (rtg::Section::Faces).
const float SECTION_UNBOUNDED = -1e30f;
const uint SECTION_CAPS = 0u, SECTION_OPEN = 1u, SECTION_WHOLE = 2u;

// So many lights are uniforms; a light kit has five.
const uint FEW_LIGHTS = 8u;

// A corner's value below the first one is notANumber and, below the second, noValue (TriangleMesh.h); numbers lie above
// -1000.
const float LEAST_NUMBER = -2e3f, LEAST_VALUE = -1e10f;

// Input of a dispatch. A uniform block rather than a buffer's address: CPU devices load uniforms once for all
// lanes, but gather lane by lane behind an address.
struct FrameRecord
{
  RTG_ADDRESS(Uvec2Array) topLevels; // addresses of the driver's top-level structures, one for each slice of time
  uint topLevelCount;
  RTG_ADDRESS(GlyphSetRecords) sets;
  uint setCount;
  uint layerLimit; // layers beyond which nothing shows, or as many as one traversal gathers
  RTG_ADDRESS(LightRecords) lights;
  RTG_ADDRESS(UintImage) color;
  RTG_ADDRESS(FloatImage) depth;
  RTG_ADDRESS(UintImage) setIds;
  RTG_ADDRESS(UintImage) glyphIds;
  RTG_ADDRESS(PixelSumsImage) sums;         // of all pixels when the image accumulates, else of one
  RTG_ADDRESS(PixelFeaturesImage) features; // when it gathers features
  // Camera.h, relative to the scene's origin; eye + eyeLow is exact to double-float precision.
  vec3 eye;
  vec3 eyeLow;
  vec3 eyeRight;
  vec3 eyeUp;
  vec3 forward;
  vec3 right;
  vec3 up;
  vec3 viewPosition; // the eye, for specular highlights
  vec3 viewAxis;     // unit, toward the viewer
  float nearDepth;
  float farDepth;
  float depthA;
  float depthB;
  uint parallel;
  float lensRadius; // 0: rays run through the lens's middle
  float lensAtEye;  // a ray's distance from that through the middle, in those that it has in the lens: at depth 0
  float lensSlope;  // and what it loses of it on each unit of depth
  vec3 lensX;       // unit, in the lens
  vec3 lensY;
  vec3 sceneLower; // bounds of all that is visible, padded
  vec3 sceneUpper;
  uint width;
  uint height;
  uint firstSample;    // number of the first sample of this dispatch
  uint samples;        // that this dispatch adds
  uint accumulates;    // samples are added to earlier ones, or will be
  uint sharedTimeBits; // Shading/ShutterTime.glsl
  uint timeStrata;     // the same; 65536 at most
  uint timeStep;       // has no common divisor with it
  // The tiles of this launch, out of all tiles of the image: numbers firstTile to endTile - 1, scattered over the image
  // by tileStride, which has no common divisor with tileCount.
  uint firstTile;
  uint endTile;
  uint tileStride;
  uint tileCount;
  uint tileColumns;
  uint cullMask;
  uint lightCount;
  uint launchWidth;
  // Light
  vec3 environment;    // mean linear radiance
  vec3 skySlope;       // in a direction d it is 1 + dot(d, skySlope) times that
  float lightFraction; // occlusion: of the light on a surface, that of the view's lights
  float albedoLimit;
  float occlusionRadius;
  // The ground (Shading/Ground.glsl)
  vec3 groundNormal;  // unit
  float groundHeight; // along it, relative to the scene's origin
  vec3 groundSky;     // environment light on it, as that of the sky's mean radiance
  uint raysPerSample; // of a sample at its first hit: occlusion rays or paths
  uint maximumBounces;
  // An environment image (Shading/Environment.glsl), when the program has one
  RTG_ADDRESS(Vec3Array) environmentTexels;
  RTG_ADDRESS(UintArray) environmentCells; // EnvironmentCell
  uvec2 environmentSize;
  uint environmentCellSide;
  uint environmentCellColumns; // 0: nothing to sample
  uint environmentCellRows;
  float environmentThreshold;
  vec3 environmentRight;
  vec3 environmentUp;
  // Resolving
  uint mapsTones; // tone mapping changes colors
  float exposureFactor;
  uint toneMapping; // rtg::ToneMapping
  // Data that all lanes of a CPU device load at once: sets.at[0] again when there is no other set, and few lights.
  LightRecord fewLights[FEW_LIGHTS];
  GlyphSetRecord onlySet; // last: behind it C++ has padding that the device has not
};

#ifdef __cplusplus
#undef RTG_ADDRESS
} // namespace rtg::device
#endif
