/**
 * How numbers of the data become sizes of glyphs: a function of their magnitude, and limits of the result. Ratios
 * between the lengths of one glyph are kept.
 */
#ifndef GlyphSizing_h
#define GlyphSizing_h

#include "Finite.h"
#include "RayTracedNumbers.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace rtglyphs
{

/**
 * A magnitude as Digit times ten to the Power. The digit is in [1, 10) in single precision, which glyphs have: what
 * rounds to 10 there is 1 of the next power. Zero is 0; NaN and infinity are digits.
 */
struct SplitNumber
{
  explicit SplitNumber(double magnitude)
    : Power(rtg::IsPositive(magnitude) ? static_cast<int>(std::floor(std::log10(magnitude))) : 0)
    , Digit(static_cast<float>(magnitude / std::pow(10.0, this->Power)))
  {
    if (this->Digit >= 10.0 && std::isfinite(this->Digit))
    {
      this->Digit = 1.0;
      ++this->Power;
    }
  }
  double Length() const { return 0.1 * (this->Digit + std::abs(this->Power)); } // of its glyph
  int Power;
  double Digit;
};

struct GlyphSizing
{
  enum Functions
  {
    LINEAR = 0,
    SQUARE_ROOT = 1,
    CUBE_ROOT = 2,
    LOGARITHM = 3, // log10(1 + magnitude)
    UNIT = 4       // 1 for every magnitude
  };
  RayTracedEnum<Functions, LINEAR, UNIT> Function;
  double Least = 0.0; // of a glyph's longest extent, in world units; 0: none
  double Most = 0.0;  // the same

  bool operator==(const GlyphSizing&) const = default;

  /**
   * Scale of a glyph by its magnitude. 0 stays 0, so that it makes no glyph; NaN stays NaN.
   */
  double operator()(double magnitude) const
  {
    switch (this->Function)
    {
      case SQUARE_ROOT:
        return std::sqrt(magnitude);
      case CUBE_ROOT:
        return std::cbrt(magnitude);
      case LOGARITHM:
        return std::log1p(magnitude) / std::log(10.0);
      case UNIT:
        return magnitude > 0.0 ? 1.0 : magnitude;
      default:
        return magnitude;
    }
  }

  /**
   * The same for lengths along a glyph's axes: the largest magnitude becomes its function, the others follow.
   */
  glm::dvec3 operator()(const glm::dvec3& lengths) const
  {
    const double largest = Largest(lengths);
    return this->Function == LINEAR || !(largest > 0.0) ? lengths : lengths * ((*this)(largest) / largest);
  }

  ///@{
  /**
   * The extents within the limits.
   */
  glm::dvec3 Limited(const glm::dvec3& extents) const
  {
    const double largest = Largest(extents);
    const double limited = this->Limited(largest);
    return limited == largest || !(largest > 0.0) ? extents : extents * (limited / largest);
  }

  double Limited(double extent) const
  {
    const double atLeast = this->Least > 0.0 ? std::max(extent, this->Least) : extent;
    return this->Most > 0.0 ? std::min(atLeast, this->Most) : atLeast;
  }
  ///@}

  /**
   * Of the magnitudes; NaN where one of them is.
   */
  static double Largest(const glm::dvec3& lengths)
  {
    const glm::dvec3 l(glm::abs(lengths));
    return std::isnan(l.x + l.y + l.z) ? std::nan("") : std::max({ l.x, l.y, l.z });
  }
};

} // namespace rtglyphs

#endif
