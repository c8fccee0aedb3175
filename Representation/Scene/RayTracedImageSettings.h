/**
 * How the image of a view is lit, denoised and displayed, and how many samples it gets.
 */
#ifndef RayTracedImageSettings_h
#define RayTracedImageSettings_h

#include <array>

namespace rtglyphs
{

struct RayTracedImageSettings
{
  int ShadingMode = 0;                 // as rtg::Shading, in [0, 2]
  double AmbientOcclusionRadius = 0.0; // world units, >= 0; 0: unbounded
  int Illumination = 0;                // environment light: that of a studio, uniform, or none
  static constexpr int StudioLight = 0, UniformLight = 1, LightsOfView = 2;
  bool Shadows = false;        // of lights, where the shading mode has a choice
  double ShadowSoftness = 2.0; // degrees, in [0, 45]: angular radius of lights that have no radius
  int GroundShadow = 0;        // the plane that catches shadows: none, or across
  static constexpr int NoGround = 0, GroundBelowView = 1, GroundAcrossX = 2, GroundAcrossZ = 4;
  int ToneMapping = 3;                           // as rtg::ToneMapping, or
  static constexpr int AutomaticToneMapping = 3; // Neutral where the image is light
  double Exposure = 0.0;                         // stops, in [-100, 100]
  int Denoising = 1;                             // as rtg::Denoising, in [0, 2]
  int SamplesPerPixel = 16;                      // of a finished image, in [1, 65536]
  int SamplesPerRender = 0;                      // in [-1, 65536]; 0: all
  static constexpr int WhatTimeAllows = -1;      // the window renders until the image is finished
  double OutlineWidth = 0.0;                     // pixels, in [0, 64]
  std::array<double, 3> OutlineColor{};          // in [0, 1]
  double DepthCue = 0.0;                         // in [0, 1]
  int ParallelLight = 0;                         // of several ranks: what each has of the others' glyphs
  static constexpr int LocalLight = 0, NeighborLight = 1, ReplicatedLight = 2;

  bool IsReplicated() const { return this->ParallelLight >= ReplicatedLight; }
  bool IsStepwise() const { return this->SamplesPerRender == WhatTimeAllows; }

  bool operator==(const RayTracedImageSettings&) const = default;

  /**
   * The same with values out of range replaced by the nearest in it, NaN by the default.
   */
  RayTracedImageSettings InRange() const;
};

} // namespace rtglyphs

#endif
