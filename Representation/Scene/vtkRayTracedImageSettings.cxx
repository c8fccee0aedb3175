#include "vtkRayTracedImageSettings.h"

#include "vtkRayTracedNumbers.h"

#include <algorithm>

//----------------------------------------------------------------------------
vtkRayTracedImageSettings vtkRayTracedImageSettings::InRange() const
{
  const vtkRayTracedImageSettings standard;
  vtkRayTracedImageSettings s = *this;
  const auto number = [](double& value, double lowest, double highest, double otherwise)
  { value = vtkRayTracedNumbers::InRange(value, lowest, highest, otherwise); };
  const auto integer = [](int& value, int lowest, int highest) { value = std::clamp(value, lowest, highest); };
  integer(s.ShadingMode, 0, 2);
  number(s.AmbientOcclusionRadius, 0.0, 1e30, standard.AmbientOcclusionRadius);
  integer(s.AmbientOcclusionRays, 1, 64);
  integer(s.PathsPerSample, 1, 64);
  integer(s.MaximumBounces, 1, 1000);
  number(s.LightIntensity, 0.0, 1e6, standard.LightIntensity);
  for (double& component : s.EnvironmentColor)
  {
    number(component, 0.0, 1.0, 1.0);
  }
  integer(s.ToneMapping, 0, 1);
  number(s.Exposure, -100.0, 100.0, standard.Exposure);
  integer(s.Denoising, 0, 2);
  integer(s.SamplesPerPixel, 1, 65536);
  integer(s.SamplesPerRender, 0, 65536);
  integer(s.InteractiveReduction, 1, 16);
  integer(s.ParallelLight, LocalLight, ReplicatedLight);
  return s;
}
