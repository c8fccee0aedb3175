/**
 * The cut through a display, as its properties say.
 */
#ifndef RayTracedSection_h
#define RayTracedSection_h

#include "Glyphs.h"
#include "RayTracedNumbers.h"

#include <array>
#include <string>

namespace rtglyphs
{
struct RayTracedSection
{
  enum class Kinds
  {
    None,
    Plane,
    Box
  };
  enum class Faces
  {
    Caps,
    Open,
    WholeGlyphs,
    ColoredCaps
  };

  RayTracedEnum<Kinds, Kinds::None, Kinds::Box> Kind;
  RayTracedEnum<Faces, Faces::Caps, Faces::ColoredCaps> Face;
  bool Invert = true;
  std::array<double, 3> Origin{}; // of the plane
  std::array<double, 3> Normal{ { 1.0, 0.0, 0.0 } };
  double Thickness = 0.0;           // of the slab about the plane; 0: all on one side
  std::array<double, 3> Position{}; // of the box, as vtkPVBox has them
  std::array<double, 3> Rotation{};
  std::array<double, 3> Length{ { 1.0, 1.0, 1.0 } };
  std::array<double, 3> CapColor{ { 1.0, 1.0, 1.0 } };

  /**
   * The same for the kernels. Where there is a `problem`, which is to be reported, nothing is cut.
   */
  rtg::Section Make(std::string& problem) const;
};
}

#endif
