/**
 * The light that a representation asks for. It is the view's, for its representations are one scene: the highest
 * shading mode that any visible one asks for counts, with the other values of the first that asks for it.
 */
#ifndef vtkRayTracedGlyphLight_h
#define vtkRayTracedGlyphLight_h

#include <array>
#include <tuple>

struct vtkRayTracedGlyphLight
{
  int ShadingMode = 0;                                     // as rtg::Shading, in [0, 2]
  double AmbientOcclusionRadius = 0.0;                     // world units, >= 0; 0: unbounded
  int AmbientOcclusionRays = 8;                            // a sample, in [1, 64]
  int PathsPerSample = 4;                                  // in [1, 64]
  int MaximumBounces = 10;                                 // of path tracing, in [1, 1000]
  double LightIntensity = 1.0;                             // in [0, 1e6]
  std::array<double, 3> EnvironmentColor{ 1.0, 1.0, 1.0 }; // in [0, 1]
  int ToneMapping = 0;                                     // as rtg::ToneMapping, in [0, 1]
  double Exposure = 0.0;                                   // stops, in [-100, 100]
  int Denoising = 1; // 0: never, 1: images that are being refined, 2: always

  bool operator==(const vtkRayTracedGlyphLight& other) const
  {
    const auto all = [](const vtkRayTracedGlyphLight& l)
    {
      return std::tie(l.ShadingMode, l.AmbientOcclusionRadius, l.AmbientOcclusionRays, l.PathsPerSample,
        l.MaximumBounces, l.LightIntensity, l.EnvironmentColor, l.ToneMapping, l.Exposure, l.Denoising);
    };
    return all(*this) == all(other);
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedGlyphLight.h
