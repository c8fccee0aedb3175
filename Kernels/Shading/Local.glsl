// Local shading with the view's lights: the formulas of ParaView's own surface rendering (VTK 9,
// vtkOpenGLPolyDataMapper::ReplaceShaderLight), so that glyphs look like the surfaces beside them.

// Colour of a hit. `position` is relative to the scene's origin, `direction` the ray's.
vec3 ShadeLocal(SurfaceHit hit, vec3 position, vec3 direction)
{
  GlyphSetRecord set = SetRecord(hit.record);
  vec3 base = hit.colour.rgb;
  vec3 ambient = set.ambient * (set.coloured != 0u ? base : set.ambientColour);
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
    LightRecord light = frame.lights.at[i];
    vec3 colour = light.colour;

    // A lone headlight shines and is seen along the view axis, in perspective too.
    if (light.kind == 0u)
    {
      float df = max(0.000001, dot(normal, frame.viewAxis));
      diffuse += df * colour;
      specular += pow(df, power) * colour;
      continue;
    }

    // Direction and strength of the light at the hit.
    vec3 incident = light.direction;
    float attenuation = 1.0;
    if (light.kind == 2u)
    {
      incident = position - light.position;
      float distance = length(incident);
      incident /= distance;
      vec3 a = light.attenuation;
      attenuation = 1.0 / (a.x + distance * (a.y + distance * a.z));
      float cosCone = light.cosCone;
      if (cosCone > -1.5)
      {
        float coneDot = dot(incident, light.direction);
        attenuation = coneDot >= cosCone ? attenuation * pow(coneDot, light.exponent) : 0.0;
      }
    }

    float df = max(0.0, attenuation * dot(normal, -incident));
    diffuse += df * colour;
    if (df > 0.0)
    {
      specular += attenuation * pow(max(1e-5, dot(reflect(incident, normal), toViewer)), power) * colour;
    }
  }
  vec3 shaded = ambient + diffuse * set.diffuse * base + specular * set.specular * set.specularColour;
  return clamp(shaded, 0.0, 1.0);
}
