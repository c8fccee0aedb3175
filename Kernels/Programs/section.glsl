// Cuts: of a set with SECTION what lies in a convex body, or all but that, is not there. Of a ray one or two parts are
// left. Where one begins at a plane of the body, a glyph that it begins in is closed by a face, or seen from inside.
#ifndef RTG_SECTION
#define RTG_SECTION

// Parts of a ray that are left, at most. Programs that cut nothing have no second round.
const uint partsOfRay = 1u + (someHave & SECTION) / SECTION;

// Of the part that is being traced: where it begins in a plane that is to be closed, and which one, or none; and the
// number of the first crossing on it.
float capStart = -1.0;
uint capPlane = nothing;
uint firstCrossing = 0u;

// A crossing's triangle that stands for the cap in a plane: beyond all triangles.
const uint firstCap = 0xfffffff0u;

bool IsCap(const GlyphSetRecord set, const uint triangle)
{
  return Has(set.variants, SECTION) && triangle >= firstCap && triangle != nothing;
}

// The normal of one of the body's planes, out of it.
vec3 SectionNormal(const GlyphSetRecord set, const uint plane)
{
  uint at = SECTION_NUMBERS * plane;
  return vec3(set.section.at[at], set.section.at[at + 1u], set.section.at[at + 2u]);
}

DoubleWord SectionOffset(const GlyphSetRecord set, const uint plane)
{
  uint at = SECTION_NUMBERS * plane + 3u;
  return DoubleWord(set.section.at[at], set.section.at[at + 1u]);
}

DoubleWord SumOf(const DoubleWord3 a)
{
  return Add(Add(WordX(a), WordY(a)), WordZ(a));
}

// The cap's normal, out of what is left.
vec3 CapNormal(const GlyphSetRecord set, const uint triangle)
{
  vec3 normal = SectionNormal(set, triangle - firstCap);
  return set.sectionKeepsInside != 0u ? normal : -normal;
}

// The ray inside the body.
Span SectionSpan(const GlyphSetRecord set, const GlyphRay ray)
{
  Span span = WholeRay();
  for (uint i = 0u; i < set.sectionPlanes; ++i)
  {
    vec3 normal = SectionNormal(set, i);
    DoubleWord height =
      Subtract(SumOf(Multiply(DoubleWord3(ray.origin, ray.originLow), normal)), SectionOffset(set, i));
    DoubleWord slope = SumOf(TwoProduct(ray.direction, normal));
    span = Intersection(span, Slab(height, slope, Word(-RTG_NEVER), Word(0.0), -1, int(i)));
  }
  return span;
}

// From where to where part 0 or 1 of the ray between tMin and tMax goes; nowhere when it ends before it begins. `body`:
// of a set with SECTION.
vec2 BeginPart(const GlyphSetRecord set, const Span body, const uint part, const float tMin, const float tMax)
{
  bool cuts = Has(set.variants, SECTION) && set.sectionFaces != SECTION_WHOLE;
  bool keeps = cuts && set.sectionKeepsInside != 0u;
  bool meets = cuts && !IsEmpty(body);
  // In the body, or behind it; else up to it.
  bool begins = meets && (keeps || part == 1u);
  bool ends = meets && (keeps || part == 0u);
  float start = keeps ? body.sIn.hi : body.sOut.hi;
  float end = keeps ? body.sOut.hi : body.sIn.hi;
  bool nothingLeft = part == 1u ? keeps || !meets : keeps && !meets;
  bool cut = begins && start > tMin;
  bool closed = cut && set.sectionFaces == SECTION_CAPS;
  capStart = closed ? start : -1.0;
  capPlane = closed ? uint(keeps ? body.faceIn : body.faceOut) : nothing;
  firstCrossing = cut ? part * (maximumPasses / 2u) : 0u;
  return nothingLeft ? vec2(1.0, 0.0) : vec2(cut ? start : tMin, ends ? min(tMax, end) : tMax);
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

// Whether the glyph is not there as a whole.
bool IsLeftOut(const GlyphSetRecord set, const Glyph glyph)
{
  if (!Has(set.variants, SECTION) || set.sectionFaces != SECTION_WHOLE)
  {
    return false;
  }
  bool inside = true;
  for (uint i = 0u; i < set.sectionPlanes; ++i)
  {
    DoubleWord3 centre = DoubleWord3(glyph.centre, glyph.centreLow);
    DoubleWord height = Subtract(SumOf(Multiply(centre, SectionNormal(set, i))), SectionOffset(set, i));
    inside = inside && height.hi <= 0.0;
  }
  return inside != (set.sectionKeepsInside != 0u);
}

#endif
