// Local shading with the view's lights: the formulas of ParaView's own surface rendering (VTK 9,
// vtkOpenGLPolyDataMapper::ReplaceShaderLight), so that glyphs look like the surfaces beside them.
#include "Lights.glsl"

// The material's ambient term.
vec3 AmbientOf(const SurfaceHit hit)
{
  GlyphSetRecord set = SetRecord(hit.record);
  return set.ambient * (set.coloured != 0u ? hit.colour.rgb : set.ambientColour);
}

// Colour of a hit, added to its ambient term. `position` is relative to the scene's origin, `direction` the ray's.
vec3 ShadeLocal(const SurfaceHit hit, const vec3 position, const vec3 direction, const vec3 ambient)
{
  GlyphSetRecord set = SetRecord(hit.record);
  vec3 base = hit.colour.rgb;
  if (set.lighting == 0u)
  {
    return clamp(ambient + set.diffuse * base, 0.0, 1.0);
  }

  // A surface shows its lit side to the viewer, the inside of a cut glyph too.
  vec3 normal = dot(hit.shadingNormal, direction) > 0.0 ? -hit.shadingNormal : hit.shadingNormal;
  vec3 toViewer = normalize(frame.viewPosition - position);
  float power = set.specularPower;
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  for (uint i = 0u; i < frame.lightCount; ++i)
  {
    LightRecord light = LightAt(i);
    Incidence at = ArriveAt(light, position);
    float df = max(at.alongView ? 0.000001 : 0.0, at.attenuation * dot(normal, -at.direction));
    diffuse += df * light.colour;
    if (df > 0.0)
    {
      float highlight = at.alongView ? df : max(1e-5, dot(reflect(at.direction, normal), toViewer));
      specular += at.attenuation * pow(highlight, power) * light.colour;
    }
  }
  vec3 shaded = ambient + diffuse * set.diffuse * base + specular * set.specular * set.specularColour;
  return clamp(shaded, 0.0, 1.0);
}
