// Reads one glyph of a set, in the frame of the scene's origin, and intersects it. Arrays that no set of the program
// has cost neither a load nor a branch (Variants.h).
#include "../Shapes/Dialect.glsl"
#include "../Shapes/Registry.glsl"
#include "motion.glsl"
#include "../Shading/Sobol.glsl"
#include "mesh.glsl"
#include "section.glsl"

// Where a set's glyphs are found, and when: read once a ray, not once a glyph.
struct GlyphSource
{
  GlyphSetRecord set;
  float time;
  Glyph alike; // values common to all glyphs of the set
};

GlyphSource SourceOf(const GlyphSetRecord set)
{
  GlyphSource source;
  source.set = set;
  source.time = Has(set.variants, MOVING_GLYPHS) ? TimeOf(set) : 0.0;
  source.alike.size = vec3(set.uniformSize);
  source.alike.rotation = vec4(0.0, 0.0, 0.0, 1.0);
  source.alike.rotated = Has(set.variants, ROTATIONS | ANGULAR_VELOCITIES);
  source.alike.sameSize = !Has(set.variants, SIZES_EACH);
  source.alike.joined = IsOfShape(set.shape, RTG_SWEPT) && Has(set.variants, POLYNOMIALS);
  source.alike.arrow = vec4(set.shaftRadius, set.tipRadius, set.tipLength, set.tipRounding);
  source.alike.unitLength = set.unitLength > 0.0 ? set.unitLength : set.uniformSize;
  source.alike.fixedHeads = Has(set.variants, FIXED_HEADS);
  source.alike.exponents = set.uniformExponents;
  source.alike.before = vec4(0.0);
  source.alike.after = vec4(0.0);
  source.alike.values = set.polynomials;
  source.alike.firstValue = 0;
  source.alike.degree = int(set.polynomialDegree);
  return source;
}

Glyph FetchGlyph(const GlyphSource source, const uint primitive)
{
  GlyphSetRecord set = source.set;
  Glyph glyph = source.alike;
  // The set's offset is part of the center; what rounding would lose stays in the low part.
  DoubleWord3 center = TwoSum(set.centers.at[primitive], set.offset);
  glyph.center = center.hi;
  glyph.centerLow = center.lo + set.offsetLow;
  if (Has(set.variants, CENTERS_LOW))
  {
    glyph.centerLow += set.centersLow.at[InSet(set, CENTERS_LOW, primitive)];
  }
#define RTG_FETCH(BIT, type, member, values)                                                                           \
  if (Has(set.variants, BIT))                                                                                          \
  {                                                                                                                    \
    glyph.member = type(set.values.at[InSet(set, BIT, primitive)]);                                                    \
  }
  RTG_FETCH(SIZES_EACH, vec3, size, sizes3)
  RTG_FETCH(SIZE_EACH, vec3, size, sizes1)
  RTG_FETCH(ROTATIONS, vec4, rotation, rotations)
  RTG_FETCH(EXPONENTS, vec3, exponents, exponents)
  RTG_FETCH(BEFORE, vec4, before, before)
  RTG_FETCH(AFTER, vec4, after, after)
#undef RTG_FETCH
  if (Has(set.variants, SIZE_EACH | SIZES_EACH))
  {
    glyph.unitLength = set.unitLength > 0.0 ? set.unitLength : glyph.size.y;
  }
  if (Has(set.variants, POLYNOMIALS))
  {
    glyph.firstValue = int(InSet(set, POLYNOMIALS, primitive) * set.polynomialWidth);
  }
  Move(glyph, set, primitive, source.time);
  return glyph;
}

// Results of Estimate.glsl.
int Estimate(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const float tMin, const float tMax,
  out float low, out float high)
{
  low = tMin;
  high = tMax;
  if (IsLeftOut(set, glyph))
  {
    return RTG_MISSED;
  }
  if (Has(set.variants, MESH_TREE))
  {
    return MissesMesh(set, ray, glyph) ? RTG_MISSED : RTG_UNKNOWN;
  }
  return EstimateGlyph(set.shape, ray, glyph, tMin, tMax, low, high);
}

// A mesh is as large as its triangles are spread.
float ExtentOf(const GlyphSetRecord set, const Glyph glyph)
{
  float largest = LargestOf(glyph.size);
  return IsOfShape(set.shape, RTG_MESH) ? largest * set.meshRadius : largest;
}

// How far from t the exact crossing may lie at most: Shapes/README.md's bound, doubled.
float ErrorOfT(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const float t)
{
  return 2e-6 * (ExtentOf(set, glyph) / length(ray.direction) + t);
}

// The nearest crossing in [tMin, tMax], and which triangle of a mesh is crossed there. With `any` another one will do.
// The normal is that of an analytic shape, where it is wanted. Where tMin lies in a plane of a cut and the glyph is to
// be closed there, it crosses the cap if it is inside: of an analytic shape, if it leaves that at its next crossing; of
// a mesh, if there is an odd number of them.
bool Intersect(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const float tMin, const float tMax,
  const bool any, const bool wantsNormal, out float t, out vec3 normal, out uint triangle)
{
  bool atCap = StartsAtCap(set, tMin);
  bool inside = false;
  bool met = false;
  triangle = nothing;
  if (Has(set.variants, MESH_TREE))
  {
    bool counts = atCap && set.meshClosed != 0u;
    normal = vec3(0.0);
    t = tMin;
    bool again;
    float from = tMin;
    uint crossings = 0u;
    do
    {
      float next;
      uint crossed;
      again = IntersectMesh(set, ray, glyph, from, counts ? RTG_NEVER : tMax, any && !counts, next, crossed);
      if (crossings == 0u)
      {
        met = again && next <= tMax;
        t = next;
        triangle = crossed;
      }
      inside = inside != again;
      ++crossings;
      from = next + ErrorOfT(set, ray, glyph, next);
    } while (counts && again && crossings < maximumPasses);
    inside = inside && counts;
  }
  else
  {
    GlyphHit hit = IntersectGlyph(set.shape, ray, glyph, tMin, atCap ? RTG_NEVER : tMax, wantsNormal);
    met = hit.found;
    t = hit.t;
    normal = hit.normal;
    if (atCap)
    {
      inside = met && hit.leaves;
      if (Has(set.variants, BEFORE | AFTER) && IsOfShape(set.shape, RTG_OWN_ESTIMATE))
      {
        inside = IsInPiece(ray, glyph, tMin);
      }
      if (IsOfShape(set.shape, RTG_SWEPT))
      {
        inside = IsInSweep(ray, glyph, tMin);
      }
      met = met && t <= tMax;
    }
  }
  if (inside)
  {
    t = tMin;
    triangle = firstCap + capPlane;
  }
  return met || inside;
}

// Translucent surfaces that rays pass at random: Enderton et al., "Stochastic Transparency", IEEE TVCG 17(8), 2011.
float OpacityOf(const GlyphSetRecord set, const uint glyph)
{
  float opacity = OpacityOfGlyph(set, glyph);
  return Has(set.variants, COLORS) ? opacity * ColorOf(set, glyph).a : opacity;
}

// The color of a piece of a line where a ray meets it at t, between those of the ends' middles, or of a polynomial,
// between those at its center and farthest from it.
vec4 ColorBetweenEnds(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const uint number, const float t)
{
  float extent = IsOfShape(set.shape, RTG_SWEPT) ? glyph.after.w : glyph.size.x;
  vec3 position = FromCenter(ray, glyph, t) / max(extent, 1e-30);
  float fraction = clamp(
    Has(set.variants, POLYNOMIALS) && !IsOfShape(set.shape, RTG_SWEPT) ? 2.0 * length(position) : position.x + 0.5, 0.0,
    1.0);
  uvec2 ends = set.endColors.at[InSetIfHit(set, END_COLORS, number)];
  vec4 color;
  if (Has(set.variants, END_VALUES))
  {
    vec2 values = uintBitsToFloat(ends);
    float value = ValueBetween(min(values.x, values.y), values.x + fraction * (values.y - values.x));
    color = TableColor(set.colorTable, 0u, set.colorTableSize, value);
  }
  else
  {
    vec4 first = unpackUnorm4x8(ends.x);
    color = first + fraction * (unpackUnorm4x8(ends.y) - first);
  }
  return color * vec4(vec3(1.0), OpacityOf(set, number));
}

// Whether the ray passes translucent surfaces of the set at random. `seed`: of the ray; 0: it passes none.
bool MayPass(const GlyphSetRecord set, const uint seed)
{
  return translucency && seed != 0u && set.translucent != 0u;
}

// Whether it passes the crossing of that number, or triangle, of a glyph: at random, so that on average the fraction
// 1 - opacity passes. The result is the same at each call.
bool Passes(const GlyphSetRecord set, const uint seed, const uint glyph, const uint crossing, const float opacity)
{
  return UnitInterval(Hash(Hash(seed, set.setId), Hash(glyph, crossing))) >= opacity;
}

bool PassesTriangle(const GlyphSetRecord set, const GlyphRay ray, const uint seed, const uint number, const Glyph glyph,
  const uint triangle)
{
  return Passes(set, seed, number, triangle, TriangleColor(set, ray, glyph, number, triangle).a);
}

// The first crossing in [tMin, tMax] that the ray does not pass.
bool IntersectStopping(const GlyphSetRecord set, const GlyphRay ray, const uint number, const Glyph glyph,
  const uint seed, float tMin, const float tMax, const bool any, const bool wantsNormal, out float t, out vec3 normal,
  out uint triangle)
{
  bool chance = MayPass(set, seed);
  bool met;
  bool passes = false;
  uint crossing = 0u;
  do
  {
    met = Intersect(set, ray, glyph, tMin, tMax, any && !chance, wantsNormal, t, normal, triangle);
    passes = false;
    if (met && chance && crossing < maximumPasses)
    {
      float opacity =
        Has(set.variants, END_COLORS) ? ColorBetweenEnds(set, ray, glyph, number, t).a : OpacityOf(set, number);
      passes = Passes(set, seed, number, CrossingNumber(set, crossing), opacity);
      if (Has(set.variants, MESH_TREE) && !IsCap(set, triangle))
      {
        passes = PassesTriangle(set, ray, seed, number, glyph, triangle);
      }
    }
    tMin = t + ErrorOfT(set, ray, glyph, t);
    ++crossing;
  } while (passes);
  return met;
}
