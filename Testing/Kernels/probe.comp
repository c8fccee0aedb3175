#version 460
#extension GL_GOOGLE_include_directive : require
// Traces given rays and reports what they meet (Probes.cxx): the arithmetic of images.
#include "bindings.glsl"
#include "trace.glsl"

struct ProbeRecord
{
  vec3 origin;
  vec3 originLow;
  vec3 direction;
  float time;
};

struct ProbeResult
{
  float t;
  vec3 normal;
  uint setId;
  uint glyph;
};

RTG_ARRAY(ProbeRecords, ProbeRecord, readonly, 4)
RTG_ARRAY(ProbeResults, ProbeResult, writeonly, 4)

void main()
{
  uint index = gl_GlobalInvocationID.x;
  if (index >= frame.width)
  {
    return;
  }
  ProbeRecord probe = ProbeRecords(frame.sums).at[index];
  ProbeResults results = ProbeResults(frame.features);
  DoubleWord3 origin;
  origin.hi = probe.origin;
  origin.lo = probe.originLow;
  shutterTime = moves ? probe.time : 0.0;
  SceneRay ray = EnterScene(origin, probe.direction);
  SurfaceHit hit = Trace(Query(ray, 0.0, 1e38, frame.cullMask, 0u, false), false);

  bool found = hit.t >= 0.0;
  results.at[index].t = found ? hit.t + ray.start : -1.0;
  results.at[index].normal = hit.shadingNormal;
  results.at[index].setId = found ? SetRecord(hit.record).setId : 0xffffffffu;
  results.at[index].glyph = found ? hit.glyph : 0xffffffffu;
}
