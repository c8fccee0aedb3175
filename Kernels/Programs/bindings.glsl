// Input of every program: the frame, and specialization constants.
#extension GL_EXT_spirv_intrinsics : require
#extension GL_EXT_control_flow_attributes : require
// Double words rest on sums and products rounded to nearest even, bracketing solvers on comparisons with NaN and on
// 1/0. What Device.cxx requires of a device is declared here, or its compiler need not keep to it: RoundingModeRTE and
// SignedZeroInfNanPreserve (SPIR-V specification, "Execution Mode") for 32 bits. Denormals are as the device has them.
spirv_execution_mode(capabilities = [4467], 4462, 32);
spirv_execution_mode(capabilities = [4466], 4461, 32);
#include "../HostDevice.h"

// The magnitude of the largest component.
float LargestOf(const vec3 v)
{
  return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

// GLSL's own functions, whose sums drivers order each in their own way.
float Dot(const vec2 a, const vec2 b)
{
  return a.y * b.y + a.x * b.x;
}

float Dot(const vec3 a, const vec3 b)
{
  return (a.z * b.z + a.y * b.y) + a.x * b.x;
}

float Dot(const vec4 a, const vec4 b)
{
  return ((a.w * b.w + a.z * b.z) + a.y * b.y) + a.x * b.x;
}

float Length(const vec2 a)
{
  return sqrt(Dot(a, a));
}

float Length(const vec3 a)
{
  return sqrt(Dot(a, a));
}

// Without overflow.
vec3 Normalize(const vec3 v)
{
  float largest = LargestOf(v);
  vec3 scaled = v / largest;
  return largest > 0.0 ? scaled * (1.0 / Length(scaled)) : v;
}

vec3 Cross(const vec3 a, const vec3 b)
{
  return a.yzx * b.zxy - a.zxy * b.yzx;
}

vec3 Reflect(const vec3 direction, const vec3 normal)
{
  return direction - (2.0 * Dot(direction, normal)) * normal;
}

#define dot Dot
#define length Length
#define normalize Normalize
#define cross Cross
#define reflect Reflect

layout(set = 0, binding = 0, scalar) uniform Frame
{
  FrameRecord frame;
};

#define RTG_DECLARE(id, type, name) layout(constant_id = id) const type name = type(0);
RTG_CONSTANTS(RTG_DECLARE)
#undef RTG_DECLARE

// Whether a set has a variant (Variants.h); `variants`: those of its record. A macro, because Vulkan/Specialize follows
// constants within a function only.
#define Has(variants, variant)                                                                                         \
  ((inAllSets & (variant)) != 0u || ((inSomeSets & (variant)) != 0u && ((variants) & (variant)) != 0u))

// Whether a set is of a shape; `shape`: that of its record. A macro for the same reason.
#define IsOfShape(shape, number) (shapes == 1u << (number) || ((shapes & 1u << (number)) != 0u && (shape) == (number)))

GlyphSetRecord SetRecord(const uint index)
{
  if (alone)
  {
    return frame.onlySet;
  }
  return frame.sets.at[index];
}

// Index of a value in an array of a set, of a glyph or a corner. Compilers may load a value where the condition round
// the load does not hold; sets that lack the array have one value there (SceneRecords.cxx).
#define InSet(set, array, index) (Has((set).variants, array) ? (index) : 0u)

// Index of the value of a glyph that a ray may have hit. Compilers may load it where the condition round it does not
// hold, for rays that hit nothing, too: the index is always one of the set's.
#define InSetIfHit(set, array, glyph) InSet(set, array, min(glyph, (set).glyphCount - 1u))

// A glyph's own color.
vec4 ColorOf(const GlyphSetRecord set, const uint glyph)
{
  return unpackUnorm4x8(set.colors.at[InSetIfHit(set, COLORS, glyph)]);
}

// Opacity of all of a glyph's surface; the alpha of colors multiplies it.
float OpacityOfGlyph(const GlyphSetRecord set, const uint glyph)
{
  return Has(set.variants, OPACITIES) ? set.opacity * set.opacities.at[InSetIfHit(set, OPACITIES, glyph)] : set.opacity;
}

// The color of an interpolated value in a table that begins at that place: from 0 to 1 over all entries but two, that
// of what is no number and that of what has no value.
vec4 TableColor(const UintArray table, const uint first, const uint size, const float value)
{
  uint entries = size - 2u;
  uint entry = value < LEAST_VALUE ? size - 1u
    : value < LEAST_NUMBER         ? entries
                                   : min(uint(clamp(value, 0.0, 1.0) * float(entries)), entries - 1u);
  return unpackUnorm4x8(table.at[first + entry]);
}

// The value between corners for that: the least of the corners, and the interpolated one if all have numbers. A corner
// without one decides for the whole surface between them: its value says what it is, a part of it would not.
float ValueBetween(const float least, const float interpolated)
{
  return least < LEAST_NUMBER ? least : interpolated;
}

const uint nothing = 0xffffffffu; // no glyph, no triangle

// Limit of translucent surfaces that a ray may pass at random; beyond it the ray is blocked.
const uint maximumPasses = 4096u;

// The nearest hit. Every kind of surface fills all members.
struct SurfaceHit
{
  float t;     // along the traced ray; negative: nothing hit
  float error; // world units between hit and exact surface at most, besides the rounding of t; only if leavesSurface
  vec3 normal; // of the surface itself: outward, unit, world frame
  vec3 shadingNormal; // the same, or between corners of triangles interpolated; on the same side of the surface
  vec4 color;
  uint record;  // index of its GlyphSetRecord
  uint glyph;   // index in the set's sorted order
  bool colored; // its color stands for something, also in ambient light
};

SurfaceHit NoHit()
{
  return SurfaceHit(-1.0, 0.0, vec3(0.0), vec3(0.0), vec4(0.0), 0u, 0u, false);
}

// Turns both normals to the side that a ray along `direction` came from: both sides of a surface are the same.
void FaceForward(inout SurfaceHit hit, const vec3 direction)
{
  if (dot(hit.normal, direction) > 0.0)
  {
    hit.normal = -hit.normal;
    hit.shadingNormal = -hit.shadingNormal;
  }
}

// A direction that was chosen about the shading normal of a hit that faces forward. Where that leans away from the
// surface, some such directions point into it: they are mirrored at it, so that a body does not shade itself where it
// is convex.
vec3 OutOfSurface(const SurfaceHit hit, const vec3 direction)
{
  return direction - 2.0 * min(dot(direction, hit.normal), 0.0) * hit.normal;
}

layout(local_size_x = LAUNCH_GROUP) in;
