// Local shading with the view's lights: the formulas of ParaView's own surface rendering (VTK 9,
// vtkOpenGLPolyDataMapper::ReplaceShaderLight), so that glyphs look like the surfaces beside them.
#include "Lights.glsl"

// The material's ambient term.
vec3 AmbientOf(const SurfaceHit hit)
{
  GlyphSetRecord set = SetRecord(hit.record);
  return set.ambient * (hit.colored ? hit.color.rgb : set.ambientColor);
}

// Light of the view's lights on a surface.
struct LocalLight
{
  vec3 diffuse;
  vec3 specular;
};

// A surface shows its lit side to the viewer, the inside of a cut glyph too.
vec3 LitNormal(const SurfaceHit hit, const vec3 direction)
{
  return dot(hit.shadingNormal, direction) > 0.0 ? -hit.shadingNormal : hit.shadingNormal;
}

void AddLight(inout LocalLight sum, const LightRecord light, const Incidence at, const vec3 normal, const vec3 toViewer,
  const float power)
{
  float df = max(at.alongView ? 0.000001 : 0.0, at.attenuation * dot(normal, -at.direction));
  sum.diffuse += df * light.color;
  if (df > 0.0)
  {
    float highlight = at.alongView ? df : max(1e-5, dot(reflect(at.direction, normal), toViewer));
    sum.specular += at.attenuation * pow(highlight, power) * light.color;
  }
}

vec3 ReflectLocal(const GlyphSetRecord set, const vec3 base, const vec3 ambient, const LocalLight sum)
{
  vec3 shaded = ambient + sum.diffuse * set.diffuse * base + sum.specular * set.specular * set.specularColor;
  return clamp(shaded, 0.0, 1.0);
}

// Color of a hit, added to its ambient term. `position` is relative to the scene's origin, `direction` the ray's.
vec3 ShadeLocal(const SurfaceHit hit, const vec3 position, const vec3 direction, const vec3 ambient)
{
  GlyphSetRecord set = SetRecord(hit.record);
  vec3 base = hit.color.rgb;
  if (set.lighting == 0u)
  {
    return clamp(ambient + set.diffuse * base, 0.0, 1.0);
  }

  vec3 normal = LitNormal(hit, direction);
  vec3 toViewer = normalize(frame.viewPosition - position);
  LocalLight sum = LocalLight(vec3(0.0), vec3(0.0));
  for (uint i = 0u; i < frame.lightCount; ++i)
  {
    LightRecord light = LightAt(i);
    AddLight(sum, light, ArriveAt(light, position), normal, toViewer, set.specularPower);
  }
  return ReflectLocal(set, base, ambient, sum);
}
