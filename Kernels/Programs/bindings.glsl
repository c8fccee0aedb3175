// What every program sees: the frame and one payload.
#extension GL_EXT_ray_tracing : require
#extension GL_EXT_control_flow_attributes : enable
#include "../HostDevice.h"

layout(set = 0, binding = 0, scalar) uniform Frame { FrameRecord frame; };

layout(constant_id = 15) const bool alone = false;  // the scene has one record

GlyphSetRecord SetRecord(uint index)
{
  if (alone)
  {
    return frame.onlySet;
  }
  return frame.sets.at[index];
}

// What the nearest hit tells the ray generation program. Whatever kind of surface it lies on, it fills all of this.
struct SurfaceHit
{
  float t;            // along the traced ray; negative: nothing hit
  vec3 normal;        // outward, unit, world frame
  vec4 colour;
  uint record;        // index of its GlyphSetRecord
  uint glyph;         // index in the set's sorted order
};

// The normal on the side that a ray along `direction` came from: both sides of a surface are the same.
vec3 FacingNormal(SurfaceHit hit, vec3 direction)
{
  return dot(hit.normal, direction) > 0.0 ? -hit.normal : hit.normal;
}

uint LaunchIndex()
{
  return gl_LaunchIDEXT.y * frame.launchWidth + gl_LaunchIDEXT.x;
}
