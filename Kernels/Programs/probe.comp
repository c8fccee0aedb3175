#version 460
#extension GL_GOOGLE_include_directive : require
// Traces given rays and reports what they meet: the pipeline's own arithmetic, for tests.
#include "bindings.glsl"
#include "trace.glsl"

void main()
{
  uint index = gl_GlobalInvocationID.y * frame.launchWidth + gl_GlobalInvocationID.x;
  if (index >= frame.probeCount)
  {
    return;
  }
  ProbeRecord probe = frame.probes.at[index];
  DoubleWord3 origin;
  origin.hi = probe.origin;
  origin.lo = probe.originLow;
  SetShutterTime(probe.time);
  SceneRay ray = EnterScene(origin, probe.direction);
  SurfaceHit hit = Trace(Query(ray, 0.0, 1e38, frame.cullMask, 0u, false), false);

  bool found = hit.t >= 0.0;
  frame.probeResults.at[index].t = found ? hit.t + ray.start : -1.0;
  frame.probeResults.at[index].normal = hit.shadingNormal;
  frame.probeResults.at[index].setId = found ? SetRecord(hit.record).setId : 0xffffffffu;
  frame.probeResults.at[index].glyph = found ? hit.glyph : 0xffffffffu;
}
