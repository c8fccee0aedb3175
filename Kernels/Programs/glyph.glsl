// Reads one glyph of the current hit group's set, in the frame of the scene's origin.
// Specialised per hit group, so that absent arrays cost neither a load nor a branch.
layout(constant_id = 0) const uint sizesPerGlyph = 0; // 0: uniformSize, 1, or 3
layout(constant_id = 1) const bool turned = false;
layout(constant_id = 2) const bool coloured = false;
layout(constant_id = 3) const bool fixedHeads = false;
layout(constant_id = 4) const bool hasTree = false;
layout(constant_id = 5) const bool ownExponents = false;
layout(constant_id = 42) const bool exactCentres = false;

#if RTG_SHAPE == 7
#include "mesh.glsl"
#else
#include "../Shapes/Registry.glsl"
#include "motion.glsl"

bool IntersectGlyph(GlyphRay ray, Glyph glyph, float tMin, float tMax, out float t, out uint triangle)
{
  triangle = 0xffffffffu;
  return IntersectGlyph(ray, glyph, tMin, tMax, t);
}
#endif

// Where a set's glyphs are found: read once a program, not once a glyph.
struct GlyphSource
{
  Vec3Array centres;
  Vec3Array centresLow;
  FloatArray sizes;
  Vec4Array rotations;
  FloatArray exponents;
  vec3 offset;
  vec3 offsetLow;
  MotionSource motion;
  Glyph alike; // what all glyphs of the set share
};

GlyphSource SourceOf(GlyphSetRecord set)
{
  GlyphSource source;
  source.centres = set.centres;
  source.centresLow = set.centresLow;
  source.sizes = set.sizes;
  source.rotations = set.rotations;
  source.exponents = set.exponents;
  source.offset = set.offset;
  source.offsetLow = set.offsetLow;
  source.alike.size = vec3(set.uniformSize);
  source.alike.rotation = vec4(0.0, 0.0, 0.0, 1.0);
  source.motion = CurrentMotion(set);
  source.alike.turned = turned || spins;
  source.alike.sameSize = sizesPerGlyph != 3u;
  source.alike.arrow = set.arrow;
  source.alike.unitLength = set.unitLength;
  source.alike.fixedHeads = fixedHeads;
  source.alike.exponents = set.uniformExponents;
  return source;
}

Glyph FetchGlyph(GlyphSource source, uint primitive)
{
  Glyph glyph = source.alike;
  // The set's offset is part of the centre; what rounding would lose stays in the low part.
  DoubleWord3 centre = TwoSum(source.centres.at[primitive], source.offset);
  glyph.centre = centre.hi;
  glyph.centreLow = centre.lo + source.offsetLow;
  if (exactCentres)
  {
    glyph.centreLow += source.centresLow.at[primitive];
  }

  if (sizesPerGlyph == 3u)
  {
    FloatArray sizes = source.sizes;
    glyph.size = vec3(sizes.at[3u * primitive], sizes.at[3u * primitive + 1u], sizes.at[3u * primitive + 2u]);
  }
  else if (sizesPerGlyph == 1u)
  {
    glyph.size = vec3(source.sizes.at[primitive]);
  }
  if (turned)
  {
    glyph.rotation = source.rotations.at[primitive];
  }
  if (ownExponents)
  {
    FloatArray exponents = source.exponents;
    glyph.exponents =
      vec3(exponents.at[3u * primitive], exponents.at[3u * primitive + 1u], exponents.at[3u * primitive + 2u]);
  }
  Move(glyph, source.motion, primitive);
  return glyph;
}

// Translucent surfaces that rays pass by chance: Enderton et al., "Stochastic Transparency", IEEE TVCG 17(8), 2011.
float OpacityOf(GlyphSetRecord set, uint glyph)
{
  return coloured ? set.opacity * unpackUnorm4x8(set.colours.at[glyph]).a : set.opacity;
}

#include "../Shading/Sobol.glsl"

// Whether a ray passes a crossing of a glyph's surface, the first of which is number 0: by chance, so that in the mean
// the share 1 - opacity passes. `seed`: of the ray; 0: it passes none. The same answer however often it is asked.
bool PassesBy(uint seed, GlyphSetRecord set, uint glyph, uint crossing)
{
#if RTG_SHAPE == 7
  // A mesh has opacities by position or triangle: whoever traces the ray asks anew.
  return false;
#endif
  return translucency && seed != 0u && set.translucent != 0u &&
    UnitInterval(Hash(Hash(seed, set.setId), Hash(set.firstGlyph + glyph, crossing))) >= OpacityOf(set, glyph);
}

// How far from t the exact crossing may lie at most: Shapes/README.md's bound, doubled.
float ErrorOfT(GlyphRay ray, Glyph glyph, float t)
{
  return 2e-6 * (max(glyph.size.x, max(glyph.size.y, glyph.size.z)) / length(ray.direction) + t);
}

// More crossings of one glyph than this count as a wall.
const uint maximumCrossings = 64u;

// The first crossing in [tMin, tMax] that the ray does not pass.
bool IntersectStopping(GlyphSetRecord set, GlyphRay ray, uint number, Glyph glyph, uint seed, float tMin, float tMax,
  out float t, out uint triangle)
{
  bool met;
  bool passes = false;
  uint crossing = 0u;
  do
  {
    met = IntersectGlyph(ray, glyph, tMin, tMax, t, triangle);
    passes = met && crossing < maximumCrossings && PassesBy(seed, set, number, crossing);
    tMin = t + ErrorOfT(ray, glyph, t);
    ++crossing;
  } while (passes);
  return met;
}

#ifndef RTG_WHOLE
GlyphSource CurrentSource()
{
  return SourceOf(SetRecord(gl_InstanceCustomIndexEXT));
}

// The exact ray: its origin's low part travels beside it, because intersection programs cannot
// read the payload.
GlyphRay CurrentRay()
{
  GlyphRay ray;
  ray.origin = gl_WorldRayOriginEXT;
  ray.direction = gl_WorldRayDirectionEXT;
  ray.originLow = frame.rays.at[LaunchIndex()].originLow;
  return ray;
}

uint CurrentSeed()
{
  return translucency ? frame.rays.at[LaunchIndex()].seed : 0u;
}
#endif
