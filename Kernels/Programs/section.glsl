// Cuts: of a set with SECTION what lies in a convex body, or all but that, is not there. Of a ray one or two parts are
// left. Where one begins at a plane of the body, a glyph that it begins in is closed by a face, or seen from inside.

// Parts of a ray that are left, at most. Programs that cut nothing have no second round.
const uint partsOfRay = 1u + (inSomeSets & SECTION) / SECTION;

// The part of the ray that is being traced: where it begins in a plane that is to be closed, and which one, or none;
// and the number of the first crossing on it.
float capStart = -1.0;
uint capPlane = nothing;
uint firstCrossing = 0u;

// A crossing's triangle that stands for the cap in a plane: beyond all triangles.
const uint firstCap = 0xfffffff0u;

bool IsCap(const GlyphSetRecord set, const uint triangle)
{
  return Has(set.variants, SECTION) && triangle >= firstCap && triangle != nothing;
}

// The cap's normal, out of what is left.
vec3 CapNormal(const GlyphSetRecord set, const uint triangle)
{
  uint plane = triangle - firstCap;
  vec3 normal = plane < 2u ? set.sectionSlab0.normal : plane < 4u ? set.sectionSlab1.normal : set.sectionSlab2.normal;
  return (plane % 2u == 1u) == (set.sectionKeepsInside != 0u) ? normal : -normal;
}

// The ray inside one of the body's slabs.
Span SlabSpan(const GlyphRay ray, const SectionSlab slab, const int firstPlane)
{
  DoubleWord height = SumOf(Multiply(DoubleWord3(ray.origin, ray.originLow), slab.normal));
  DoubleWord slope = SumOf(TwoProduct(ray.direction, slab.normal));
  // A plane that is not there is no number to divide by a small slope: the product overflows.
  bool openBelow = slab.lower.x == SECTION_UNBOUNDED && slope.hi != 0.0;
  vec2 lower = openBelow ? slab.upper : slab.lower;
  Span span = Slab(
    height, slope, DoubleWord(lower.x, lower.y), DoubleWord(slab.upper.x, slab.upper.y), firstPlane, firstPlane + 1);
  span.sIn = openBelow && slope.hi > 0.0 ? Word(-RTG_NEVER) : span.sIn;
  span.sOut = openBelow && slope.hi < 0.0 ? Word(RTG_NEVER) : span.sOut;
  return span;
}

// The slabs lie in the record, one by one: CPU devices load them once for all lanes.
Span SectionSpan(const GlyphSetRecord set, const GlyphRay ray)
{
  Span span = SlabSpan(ray, set.sectionSlab0, 0);
  if (set.sectionSlabs > 1u)
  {
    span = Intersection(span, SlabSpan(ray, set.sectionSlab1, 2));
  }
  if (set.sectionSlabs > 2u)
  {
    span = Intersection(span, SlabSpan(ray, set.sectionSlab2, 4));
  }
  return span;
}

// The interval of part 0 or 1 of the ray between tMin and tMax; empty when it ends before it begins. `body`: of a set
// with SECTION. Unless `cuts`, part 0 is all of it.
vec2 BeginPart(
  const GlyphSetRecord set, const bool cuts, const Span body, const uint part, const float tMin, const float tMax)
{
  bool keeps = cuts && set.sectionKeepsInside != 0u;
  bool meets = cuts && !IsEmpty(body);
  // A part lies in the body, or behind it; else it goes up to it.
  bool begins = meets && (keeps || part == 1u);
  bool ends = meets && (keeps || part == 0u);
  float start = keeps ? body.sIn.hi : body.sOut.hi;
  float end = keeps ? body.sOut.hi : body.sIn.hi;
  bool nothingLeft = part == 1u ? keeps || !meets || start >= RTG_NEVER : keeps && !meets;
  bool cut = begins && start > tMin;
  bool closed = cut && set.sectionFaces == SECTION_CAPS;
  capStart = closed ? start : -1.0;
  capPlane = closed ? uint(keeps ? body.faceIn : body.faceOut) : nothing;
  firstCrossing = cut ? part * (maximumPasses / 2u) : 0u;
  return nothingLeft ? vec2(1.0, 0.0) : vec2(cut ? start : tMin, ends ? min(tMax, end) : tMax);
}

// Whether the set's cut goes through glyphs.
bool CutsGlyphs(const GlyphSetRecord set)
{
  return Has(set.variants, SECTION) && set.sectionFaces != SECTION_WHOLE;
}

// The number of a crossing on the whole ray, by which chance lets rays pass.
uint CrossingNumber(const GlyphSetRecord set, const uint crossing)
{
  return Has(set.variants, SECTION) ? firstCrossing + crossing : crossing;
}

// Whether a search from tMin on begins in a plane that is to be closed.
bool StartsAtCap(const GlyphSetRecord set, const float tMin)
{
  return Has(set.variants, SECTION) && capPlane != nothing && tMin == capStart;
}

bool IsBetween(const DoubleWord3 position, const SectionSlab slab)
{
  DoubleWord height = SumOf(Multiply(position, slab.normal));
  return Subtract(height, DoubleWord(slab.lower.x, slab.lower.y)).hi >= 0.0 &&
    Subtract(height, DoubleWord(slab.upper.x, slab.upper.y)).hi <= 0.0;
}

// Whether the glyph is not there as a whole.
bool IsLeftOut(const GlyphSetRecord set, const Glyph glyph)
{
  if (!Has(set.variants, SECTION) || set.sectionFaces != SECTION_WHOLE)
  {
    return false;
  }
  DoubleWord3 center = DoubleWord3(glyph.center, glyph.centerLow);
  bool inside = IsBetween(center, set.sectionSlab0);
  inside = inside && (set.sectionSlabs < 2u || IsBetween(center, set.sectionSlab1));
  inside = inside && (set.sectionSlabs < 3u || IsBetween(center, set.sectionSlab2));
  return inside != (set.sectionKeepsInside != 0u);
}
