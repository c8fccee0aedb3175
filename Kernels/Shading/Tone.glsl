// From light to display colors and back.

// IEC 61966-2-1 (sRGB).
RTG_FN vec3 DisplayToLinear(vec3 color)
{
  return mix(pow((color + 0.055f) / 1.055f, vec3(2.4f)), color / 12.92f, lessThanEqual(color, vec3(0.04045f)));
}

RTG_FN vec3 LinearToDisplay(vec3 light)
{
  return mix(1.055f * pow(light, vec3(1.0f / 2.4f)) - 0.055f, 12.92f * light, lessThanEqual(light, vec3(0.0031308f)));
}

// Of linear light (IEC 61966-2-1).
RTG_FN float Luminance(vec3 light)
{
  return dot(light, vec3(0.2126f, 0.7152f, 0.0722f));
}

// Narkowicz's fit of the ACES reference curve ("ACES Filmic Tone Mapping Curve", 2015).
RTG_FN vec3 Filmic(vec3 light)
{
  return clamp(light * (2.51f * light + 0.03f) / (light * (2.43f * light + 0.59f) + 0.14f), vec3(0.0f), vec3(1.0f));
}

// Keeps light up to 0.9 and hues: all channels are scaled by what brings the largest below 1. The curve is that of
// "Khronos PBR Neutral Tone Mapper" (Khronos Group, 2024), without its offset for a dielectric's reflection and its
// turn toward white, which both change the colors of color tables (Testing/Benchmarks/tone_mapping.py).
RTG_FN vec3 Neutral(vec3 light)
{
  const float start = 0.9f;
  float peak = max(light.x, max(light.y, light.z));
  float shown = 1.0f - (1.0f - start) * (1.0f - start) / (peak + 1.0f - 2.0f * start);
  return peak > start ? light * (shown / peak) : light;
}

// Display color of a pixel's mean color, which is light (`linear`) or a display color already. `toneMapping`:
// rtg::ToneMapping.
RTG_FN vec3 ToneMap(vec3 mean, bool linear, float exposureFactor, uint toneMapping)
{
  vec3 light = (linear ? mean : DisplayToLinear(mean)) * exposureFactor;
  light = toneMapping == 1u ? Filmic(light) : toneMapping == 2u ? Neutral(light) : light;
  return LinearToDisplay(clamp(light, vec3(0.0f), vec3(1.0f)));
}

// A pixel in front of a surface whose light, a fraction of all light in the pixel, is `missing`: what the surface shows
// is darkened by a black layer. Over white it is the display color of the light that is left.
RTG_FN vec4 OverShadow(vec4 shown, float missing, bool linear)
{
  float rest = 1.0f - shown.w;
  float fraction = clamp(missing / max(rest, 1e-30f), 0.0f, 1.0f);
  float opacity = shown.w + rest * (linear ? 1.0f - LinearToDisplay(vec3(1.0f - fraction)).x : fraction);
  return vec4(vec3(shown) * (shown.w / max(opacity, 1e-30f)), opacity);
}
