// Cuts: of a set with SECTION what lies in a convex body, or all but that, is not there. Of a ray one or two parts are
// left. Where one begins at a plane of the body, a glyph that it begins in is closed by a face, or seen from inside.
// With SECTION_MOVES each glyph has the body where its motion since time zero brings it.
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

// A normal of the body, as a glyph has rotated it.
vec3 TurnedNormal(const GlyphSetRecord set, const uint number, const vec3 normal)
{
  vec3 turned = normal;
  if (Has(set.variants, SECTION_MOVES) && Has(set.variants, ANGULAR_VELOCITIES))
  {
    vec4 turn = TurnSince(set, number, TimeOf(set));
    turned = Rotate(turn.xyz, turn.w, normal);
  }
  return turned;
}

// The center of a glyph at rest with the body: of one that takes the body along, that at time zero.
DoubleWord3 CentreAtBody(const GlyphSetRecord set, const uint number, const Glyph glyph)
{
  DoubleWord3 centre = DoubleWord3(glyph.centre, glyph.centreLow);
  if (Has(set.variants, SECTION_MOVES) && Has(set.variants, VELOCITIES | ACCELERATIONS))
  {
    centre = Add(centre, DoubleWord3(-Displacement(set, number, TimeOf(set)), vec3(0.0)));
  }
  return centre;
}

// The cap's normal, out of what is left.
vec3 CapNormal(const GlyphSetRecord set, const uint number, const uint triangle)
{
  vec3 normal = TurnedNormal(set, number, SectionNormal(set, triangle - firstCap));
  return set.sectionKeepsInside != 0u ? normal : -normal;
}

// The ray inside the body; with SECTION_MOVES inside the glyph's.
Span SectionSpan(const GlyphSetRecord set, const GlyphRay ray, const uint number, const Glyph glyph)
{
  Span span = WholeRay();
  DoubleWord3 origin = DoubleWord3(ray.origin, ray.originLow);
  DoubleWord3 centre;
  if (Has(set.variants, SECTION_MOVES))
  {
    origin = Add(origin, DoubleWord3(-glyph.centre, -glyph.centreLow));
    centre = CentreAtBody(set, number, glyph);
  }
  for (uint i = 0u; i < set.sectionPlanes; ++i)
  {
    vec3 normal = TurnedNormal(set, number, SectionNormal(set, i));
    DoubleWord height = Subtract(SumOf(Multiply(origin, normal)), SectionOffset(set, i));
    if (Has(set.variants, SECTION_MOVES))
    {
      height = Add(height, SumOf(Multiply(centre, SectionNormal(set, i))));
    }
    DoubleWord slope = SumOf(TwoProduct(ray.direction, normal));
    span = Intersection(span, Slab(height, slope, Word(-RTG_NEVER), Word(0.0), -1, int(i)));
  }
  return span;
}

// From where to where part 0 or 1 of the ray between tMin and tMax goes; nowhere when it ends before it begins. `body`:
// of a set with SECTION. Unless `cuts`, part 0 is all of it.
vec2 BeginPart(
  const GlyphSetRecord set, const bool cuts, const Span body, const uint part, const float tMin, const float tMax)
{
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

// Whether the glyph is not there as a whole.
bool IsLeftOut(const GlyphSetRecord set, const uint number, const Glyph glyph)
{
  if (!Has(set.variants, SECTION) || set.sectionFaces != SECTION_WHOLE)
  {
    return false;
  }
  bool inside = true;
  for (uint i = 0u; i < set.sectionPlanes; ++i)
  {
    DoubleWord3 centre = CentreAtBody(set, number, glyph);
    DoubleWord height = Subtract(SumOf(Multiply(centre, SectionNormal(set, i))), SectionOffset(set, i));
    inside = inside && height.hi <= 0.0;
  }
  return inside != (set.sectionKeepsInside != 0u);
}

#endif
