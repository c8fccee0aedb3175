// From light to display colours and back.
#ifndef RTG_TONE
#define RTG_TONE

#ifndef RTG_SHADING_HOST
#include "Dialect.glsl"
#endif

// IEC 61966-2-1 (sRGB).
RTG_SHADING_FN vec3 DisplayToLinear(vec3 colour)
{
  return mix(pow((colour + 0.055f) / 1.055f, vec3(2.4f)), colour / 12.92f, lessThanEqual(colour, vec3(0.04045f)));
}

RTG_SHADING_FN vec3 LinearToDisplay(vec3 light)
{
  return mix(1.055f * pow(light, vec3(1.0f / 2.4f)) - 0.055f, 12.92f * light, lessThanEqual(light, vec3(0.0031308f)));
}

// Narkowicz's fit of the ACES reference curve ("ACES Filmic Tone Mapping Curve", 2015).
RTG_SHADING_FN vec3 Filmic(vec3 light)
{
  return clamp(light * (2.51f * light + 0.03f) / (light * (2.43f * light + 0.59f) + 0.14f), vec3(0.0f), vec3(1.0f));
}

// Display colour of a pixel's mean colour, which is light (`linear`) or a display colour already.
RTG_SHADING_FN vec3 Develop(vec3 mean, bool linear, float exposureFactor, bool filmic)
{
  vec3 light = (linear ? mean : DisplayToLinear(mean)) * exposureFactor;
  if (filmic)
  {
    light = Filmic(light);
  }
  return LinearToDisplay(clamp(light, vec3(0.0f), vec3(1.0f)));
}

#endif
