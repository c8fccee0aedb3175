// One of the view's lights, with vtkLight's meaning, as it arrives at a position relative to the scene's origin. All
// that depends on the kind of light (rtg::Light::Kind) is here.

struct Incidence
{
  vec3 direction;    // in which the light travels, unit
  float distance;    // from where it comes; far for lights at infinity
  float attenuation; // zero: it does not arrive
  bool alongView;    // it shines and is seen along the view axis, in perspective too
  float spread;      // 1 - cosine of the light's angular radius
};

// Light i in a loop over all of them.
LightRecord LightAt(const uint i)
{
  if (manyLights)
  {
    return frame.lights.at[i];
  }
  return frame.fewLights[i];
}

Incidence ArriveAt(const LightRecord light, const vec3 position)
{
  Incidence at;
  at.distance = 1e38;
  at.attenuation = 1.0;
  at.alongView = light.kind == 0u;
  at.direction = at.alongView ? -frame.viewAxis : light.direction;
  at.spread = light.spread;
  if (light.kind == 2u)
  {
    vec3 path = position - light.position;
    at.distance = length(path);
    at.direction = path / at.distance;
    vec3 a = light.attenuation;
    at.attenuation = 1.0 / (a.x + at.distance * (a.y + at.distance * a.z));
    float cosCone = light.cosCone;
    if (cosCone > -1.5)
    {
      float coneDot = dot(at.direction, light.direction);
      at.attenuation *= coneDot >= cosCone ? pow(coneDot, light.exponent) : 0.0;
    }
    // The cone that a ball subtends: Shirley, Wang and Zimmerman, "Monte Carlo Techniques for Direct
    // Lighting Calculations", ACM TOG 15(1), 1996.
    float sine = min(light.radius / at.distance, 1.0);
    at.spread = sine * sine / (1.0 + sqrt(1.0 - sine * sine));
  }
  return at;
}

// The direction to a place of the light, chosen evenly by solid angle, and how far it is.
vec3 SampleLight(const LightRecord light, const Incidence at, const vec2 u, out float distance)
{
  vec3 toLight = -at.direction;
  distance = at.distance;
  if (at.spread > 0.0)
  {
    vec3 middle = toLight;
    toLight = ConeDirection(u, middle, at.spread);
    if (light.kind == 2u)
    {
      vec3 off = at.distance * (middle - dot(toLight, middle) * toLight);
      distance =
        max(at.distance * dot(toLight, middle) - sqrt(max(light.radius * light.radius - dot(off, off), 0.0)), 0.0);
    }
  }
  return toLight;
}
