// Emission, reflection and sky of ambient occlusion and path tracing, as linear light.

// Radiance that comes from a unit direction of the sky, without an environment image.
vec3 SkyRadiance(const vec3 direction)
{
  return frame.environment * (1.0 + dot(direction, frame.skySlope));
}

// ParaView's ambient term is emitted light; so is all that is shown without
// lighting.
vec3 EmissionOfHit(const SurfaceHit hit)
{
  GlyphSetRecord set = SetRecord(hit.record);
  vec3 color = hit.colored ? hit.color.rgb : set.ambientColor;
  vec3 emission = set.ambient * DisplayToLinear(color);
  if (set.lighting == 0u)
  {
    emission += set.diffuse * DisplayToLinear(hit.color.rgb);
  }
  return emission;
}

// Factor of the reflection of a surface of that albedo: no material is as white as paper on a
// screen, and light between surfaces that were would never end. Colors that stand for values stay.
float AlbedoScale(const SurfaceHit hit, const vec3 albedo)
{
  float largest = max(albedo.x, max(albedo.y, albedo.z));
  return !hit.colored && largest > frame.albedoLimit ? frame.albedoLimit / largest : 1.0;
}
