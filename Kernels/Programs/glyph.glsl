// Reads one glyph of the current hit group's set, in the frame of the scene's origin.
// Specialised per hit group, so that absent arrays cost neither a load nor a branch.
layout(constant_id = 0) const uint sizesPerGlyph = 0;   // 0: uniformSize, 1, or 3
layout(constant_id = 1) const bool turned = false;
layout(constant_id = 2) const bool coloured = false;
layout(constant_id = 3) const bool fixedHeads = false;

#include "../Shapes/Registry.glsl"

GlyphSetRecord CurrentSet()
{
  return push.frame.value.sets.at[gl_InstanceCustomIndexEXT];
}

Glyph FetchGlyph(uint primitive)
{
  GlyphSetRecords sets = push.frame.value.sets;
  uint record = gl_InstanceCustomIndexEXT;

  Glyph glyph;
  // The set's offset is part of the centre; what rounding would lose stays in the low part.
  vec3 local = sets.at[record].centres.at[primitive];
  vec3 offset = sets.at[record].offset;
  DoubleWord3 centre = TwoSum(local, offset);
  glyph.centre = centre.hi;
  glyph.centreLow = centre.lo + sets.at[record].offsetLow;

  if (sizesPerGlyph == 3u)
  {
    FloatArray sizes = sets.at[record].sizes;
    glyph.size = vec3(sizes.at[3u * primitive], sizes.at[3u * primitive + 1u], sizes.at[3u * primitive + 2u]);
  }
  else if (sizesPerGlyph == 1u)
  {
    glyph.size = vec3(sets.at[record].sizes.at[primitive]);
  }
  else
  {
    glyph.size = vec3(sets.at[record].uniformSize);
  }
  glyph.sameSize = sizesPerGlyph != 3u;

  glyph.turned = turned;
  glyph.rotation = vec4(0.0, 0.0, 0.0, 1.0);
  if (turned)
  {
    glyph.rotation = sets.at[record].rotations.at[primitive];
  }

  glyph.arrow = sets.at[record].arrow;
  glyph.unitLength = sets.at[record].unitLength;
  glyph.fixedHeads = fixedHeads;
  return glyph;
}

// The exact ray: its origin's low part travels beside it, because intersection programs cannot
// read the payload.
GlyphRay CurrentRay()
{
  GlyphRay ray;
  ray.origin = gl_WorldRayOriginEXT;
  ray.direction = gl_WorldRayDirectionEXT;
  uint launch = gl_LaunchIDEXT.y * push.frame.value.launchWidth + gl_LaunchIDEXT.x;
  ray.originLow = push.frame.value.originLow.at[launch];
  return ray;
}
