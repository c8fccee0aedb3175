#include "RayTracedImageSettings.h"

#include "RayTracedNumbers.h"

using namespace rtglyphs::RayTracedNumbers;

//----------------------------------------------------------------------------
rtglyphs::RayTracedImageSettings rtglyphs::RayTracedImageSettings::InRange() const
{
  const rtglyphs::RayTracedImageSettings standard;
  rtglyphs::RayTracedImageSettings s = *this;
  PutInRange(s.ShadingMode, 0, 2);
  PutInRange(s.AmbientOcclusionRadius, 0.0, 1e30, standard.AmbientOcclusionRadius);
  PutInRange(s.Illumination, StudioLight, LightsOfView);
  PutInRange(s.ShadowSoftness, 0.0, 45.0, standard.ShadowSoftness);
  PutInRange(s.GroundShadow, NoGround, GroundAcrossZ);
  PutInRange(s.ToneMapping, 0, AutomaticToneMapping);
  PutInRange(s.Exposure, -100.0, 100.0, standard.Exposure);
  PutInRange(s.Denoising, 0, 2);
  PutInRange(s.SamplesPerPixel, 1, 65536);
  PutInRange(s.SamplesPerRender, WhatTimeAllows, 65536);
  PutInRange(s.OutlineWidth, 0.0, 64.0, standard.OutlineWidth);
  s.OutlineColor = ColorInRange(s.OutlineColor[0], s.OutlineColor[1], s.OutlineColor[2]);
  PutInRange(s.DepthCue, 0.0, 1.0, standard.DepthCue);
  PutInRange(s.ParallelLight, LocalLight, ReplicatedLight);
  return s;
}
