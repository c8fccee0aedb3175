// What every program sees: the frame by push constant, one payload.
#extension GL_EXT_ray_tracing : require
#extension GL_EXT_control_flow_attributes : enable
#include "../HostDevice.h"

layout(push_constant, scalar) uniform Push { PushRecord push; };

// What the nearest hit tells the ray generation program.
struct SurfaceHit
{
  float t;          // along the traced ray; negative: nothing hit
  vec3 normal;      // outward, unit, world frame
  vec4 colour;
  uint record;      // index of its GlyphSetRecord
  uint glyph;       // index in the set's sorted order
};

uint LaunchIndex()
{
  return gl_LaunchIDEXT.y * push.frame.value.launchWidth + gl_LaunchIDEXT.x;
}
