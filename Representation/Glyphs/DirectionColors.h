/**
 * Directions as colors, of glyphs, tubes and the key (vtkDirectionLegend). No color changes by more than five of 255
 * levels in a degree.
 */
#ifndef DirectionColors_h
#define DirectionColors_h

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace rtglyphs
{

struct DirectionColors
{
  enum Kinds
  {
    NONE = 0,
    AXES = 1,  // red, green and blue: |x|, |y|, |z|
    SPHERE = 2 // opposite directions differ
  };

  /**
   * Of a direction of unit length. The sphere of SPHERE is the color cube on its black corner: light upwards in z, dark
   * downwards, the hue once round in between, red at x. Each of red, green and blue follows the sine of the component
   * along one of three axes at right angles, so it changes by 3.5 levels in a degree at most. Gray is added below: on
   * black no shading can be seen.
   */
  static std::array<double, 3> Of(const glm::dvec3& direction, int kind)
  {
    std::array<double, 3> rgb{};
    const double below = std::min(direction.z, 0.0);
    for (int i = 0; i < 3; ++i)
    {
      const double hue = 2.0943951023931953 * i, pi = 3.141592653589793;
      const double along = std::sqrt(2.0 / 3.0) * (direction.x * std::cos(hue) + direction.y * std::sin(hue)) +
        std::sqrt(1.0 / 3.0) * direction.z;
      rgb[i] = kind == AXES ? std::abs(direction[i]) : 0.5 + 0.5 * std::sin(0.5 * pi * along) + 0.16 * below * below;
    }
    return rgb;
  }
};

} // namespace rtglyphs

#endif
