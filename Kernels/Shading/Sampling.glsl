// Where the samples of a pixel lie. Deterministic: a function of the pixel and the sample's number alone.

// PCG 3D, Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
uvec3 Hash3(uvec3 v)
{
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Sample s >= 1 in [0,1)^2: the R2 sequence (Roberts 2018, the plastic number's additive recurrence) started at the
// pixel's centre, so that with sample 0 there the first samples spread evenly round it.
vec2 PixelSample(uvec2 pixel, uint s)
{
  return fract(vec2(0.5) + float(s) * vec2(0.7548776662466927, 0.5698402909980532));
}
