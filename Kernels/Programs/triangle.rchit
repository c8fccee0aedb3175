#version 460
#extension GL_GOOGLE_include_directive : require
// A triangle of a mesh glyph or of a surface, both at rest, in the driver's structure.
#include "bindings.glsl"
#include "triangle.glsl"

layout(location = 0) rayPayloadInEXT SurfaceHit hit;
hitAttributeEXT vec2 barycentrics;

void main()
{
  GlyphSetRecord set = SetRecord(gl_InstanceCustomIndexEXT);
  uvec3 corner = CornersOf(set, gl_PrimitiveID);
  vec3 weight = vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics);
  vec3 a = set.meshPositions.at[corner.x];
  vec3 toB = set.meshPositions.at[corner.y] - a;
  vec3 toC = set.meshPositions.at[corner.z] - a;

  vec3 normal = NormalOf(toB, toC);
  vec3 smoothed = Has(set.variants, MESH_NORMALS) ? SmoothNormal(set, corner, weight, normal) : normal;
  hit.t = gl_HitTEXT;
  // Normals turn with the inverse transpose.
  hit.shadingNormal = UnitNormal(smoothed * mat3(gl_WorldToObjectEXT), gl_WorldRayDirectionEXT);
  hit.normal = OnSideOf(hit.shadingNormal, UnitNormal(normal * mat3(gl_WorldToObjectEXT), gl_WorldRayDirectionEXT));
  hit.record = gl_InstanceCustomIndexEXT;
  uint glyph = gl_InstanceID - set.firstInstance;
  hit.glyph = set.identifiesTriangles != 0u ? gl_PrimitiveID : glyph;
  hit.error = 0.0;
  if (leavesSurface)
  {
    // The driver's intersection works in the mesh's frame, where the ray's origin is rounded once more.
    vec3 reach = abs(gl_WorldRayOriginEXT) + abs(gl_WorldRayDirectionEXT) * gl_HitTEXT;
    vec3 size = abs(mat3(gl_ObjectToWorldEXT) * toB) + abs(mat3(gl_ObjectToWorldEXT) * toC);
    hit.error = 1e-6 * (LargestOf(reach) + LargestOf(size));
  }
  hit.colour = TriangleColour(set, corner, weight, gl_PrimitiveID, glyph);
}
