// Local shading with the view's lights: the formulas of ParaView's own surface rendering (VTK 9,
// vtkOpenGLPolyDataMapper::ReplaceShaderLight), so that glyphs look like the surfaces beside them.

// Colour of a hit. `position` is relative to the scene's origin, `direction` the ray's.
vec3 ShadeLocal(SurfaceHit hit, vec3 position, vec3 direction)
{
  FrameRecord frame = push.frame.value;
  GlyphSetRecords sets = frame.sets;
  uint record = hit.record;
  vec3 base = hit.colour.rgb;
  vec3 ambient = sets.at[record].ambient * (sets.at[record].coloured != 0u ? base : sets.at[record].ambientColour);
  if (sets.at[record].lighting == 0u)
  {
    return clamp(ambient + sets.at[record].diffuse * base, 0.0, 1.0);
  }

  // A surface shows its lit side to the viewer, the inside of a cut glyph too.
  vec3 normal = dot(hit.normal, direction) > 0.0 ? -hit.normal : hit.normal;
  vec3 toViewer = normalize(frame.viewPosition - position);
  float power = sets.at[record].specularPower;
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  for (uint i = 0u; i < frame.lightCount; ++i)
  {
    uint kind = frame.lights.at[i].kind;
    vec3 colour = frame.lights.at[i].colour;

    // A lone headlight shines and is seen along the view axis, in perspective too.
    if (kind == 0u)
    {
      float df = max(0.000001, dot(normal, frame.viewAxis));
      diffuse += df * colour;
      specular += pow(df, power) * colour;
      continue;
    }

    // Direction and strength of the light at the hit.
    vec3 incident = frame.lights.at[i].direction;
    float attenuation = 1.0;
    if (kind == 2u)
    {
      incident = position - frame.lights.at[i].position;
      float distance = length(incident);
      incident /= distance;
      vec3 a = frame.lights.at[i].attenuation;
      attenuation = 1.0 / (a.x + distance * (a.y + distance * a.z));
      float cosCone = frame.lights.at[i].cosCone;
      if (cosCone > -1.5)
      {
        float coneDot = dot(incident, frame.lights.at[i].direction);
        attenuation = coneDot >= cosCone ? attenuation * pow(coneDot, frame.lights.at[i].exponent) : 0.0;
      }
    }

    float df = max(0.0, attenuation * dot(normal, -incident));
    diffuse += df * colour;
    if (df > 0.0)
    {
      specular += attenuation * pow(max(1e-5, dot(reflect(incident, normal), toViewer)), power) * colour;
    }
  }
  vec3 shaded = ambient + diffuse * sets.at[record].diffuse * base +
    specular * sets.at[record].specular * sets.at[record].specularColour;
  return clamp(shaded, 0.0, 1.0);
}
