#version 460
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

void main()
{
  hit.t = -1.0;
}
