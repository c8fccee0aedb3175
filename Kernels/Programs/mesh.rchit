#version 460
#extension GL_GOOGLE_include_directive : require
// A triangle of a mesh glyph or of a surface that moves.
#include "bindings.glsl"
#include "glyph.glsl"
#include "triangle.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;

// The shortest turn that takes the direction `from` to the direction `to`, both unit, of v.
vec3 TurnAlong(vec3 from, vec3 to, vec3 v)
{
  float c = 1.0 + dot(from, to);
  vec3 sum = from + to;
  return c > 1e-6 ? v + 2.0 * dot(from, v) * to - (dot(sum, v) / c) * sum : -v;
}

void main()
{
  uint record = gl_InstanceCustomIndexEXT;
  GlyphSetRecord set = SetRecord(record);
  uint glyph = hasTree ? frame.rays.at[LaunchIndex()].glyph : gl_PrimitiveID;
  uint triangle = frame.rays.at[LaunchIndex()].triangle;
  Glyph found = FetchGlyph(CurrentSource(), glyph);

  uvec3 corner = CornersOf(set, triangle);
  float time = MeshTime(set);
  vec3 a = CornerAt(set, corner.x, time), b = CornerAt(set, corner.y, time), c = CornerAt(set, corner.z, time);
  float s;
  vec3 weight;
  MeetsTriangle(Shear(ToMesh(CurrentRay(), found, set)), a, b, c, s, weight);

  vec3 normal = cross(b - a, c - a);
  vec3 smoothed = normal;
  if (smoothNormals)
  {
    smoothed = SmoothNormal(set, corner, weight, normal);
    if (meshVelocities || meshAccelerations)
    {
      // The corners' normals are those of the mesh at rest: they turn as the triangle does.
      vec3 rest = set.meshPositions.at[corner.x];
      vec3 before = cross(set.meshPositions.at[corner.y] - rest, set.meshPositions.at[corner.z] - rest);
      bool flat_ = min(dot(before, before), dot(normal, normal)) <= 0.0;
      smoothed = !flat_ ? TurnAlong(normalize(before), normalize(normal), smoothed) : smoothed;
    }
  }
  hit.t = gl_HitTEXT;
  // Normals turn with the inverse transpose.
  hit.shadingNormal = normalize(RotateToWorld(found, smoothed / found.size));
  hit.normal = OnSideOf(hit.shadingNormal, normalize(RotateToWorld(found, normal / found.size)));
  hit.record = record;
  hit.glyph = set.identifiesTriangles != 0u ? triangle : set.firstGlyph + glyph;
  vec3 size = abs(found.size);
  hit.error = leavesSurface ? 2e-6 * set.meshRadius * max(size.x, max(size.y, size.z)) : 0.0;
  hit.colour = TriangleColour(set, corner, weight, triangle, glyph);
}
