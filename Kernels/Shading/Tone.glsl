// From light to display colours and back.
#ifndef RTG_TONE
#define RTG_TONE

// IEC 61966-2-1 (sRGB).
vec3 DisplayToLinear(vec3 colour)
{
  return mix(pow((colour + 0.055) / 1.055, vec3(2.4)), colour / 12.92, lessThanEqual(colour, vec3(0.04045)));
}

vec3 LinearToDisplay(vec3 light)
{
  return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

// Narkowicz's fit of the ACES reference curve ("ACES Filmic Tone Mapping Curve", 2015).
vec3 Filmic(vec3 light)
{
  return clamp(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0.0, 1.0);
}

// Display colour of a pixel's mean colour, which is light (`linear`) or a display colour already.
vec3 Develop(vec3 mean, bool linear)
{
  vec3 light = (linear ? mean : DisplayToLinear(mean)) * frame.exposureFactor;
  if (frame.filmic != 0u)
  {
    light = Filmic(light);
  }
  return LinearToDisplay(clamp(light, 0.0, 1.0));
}

#endif
