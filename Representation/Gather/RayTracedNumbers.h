/**
 * Numbers that the server manager or a script may set to anything, as what can be worked with. NaN would differ from
 * itself, so that it would seem to change at every render; so would a matrix that is made of infinite numbers.
 */
#ifndef RayTracedNumbers_h
#define RayTracedNumbers_h

#include <algorithm>
#include <array>
#include <cmath>

namespace rtglyphs::RayTracedNumbers
{
inline double NumberOr(double value, double otherwise)
{
  return std::isnan(value) ? otherwise : value;
}

/**
 * The nearest number in the range; of NaN `otherwise`.
 */
inline double InRange(double value, double lowest, double highest, double otherwise)
{
  return std::isnan(value) ? otherwise : std::clamp(value, lowest, highest);
}

///@{
/**
 * The same in place, of numbers of any type and of integers.
 */
template <class Number>
void PutInRange(Number& value, double lowest, double highest, double otherwise)
{
  value = static_cast<Number>(InRange(value, lowest, highest, otherwise));
}
template <class Integer>
void PutInRange(Integer& value, int lowest, int highest)
{
  value = static_cast<Integer>(std::clamp(static_cast<int>(value), lowest, highest));
}
///@}

inline std::array<double, 3> ColorInRange(double red, double green, double blue)
{
  return { InRange(red, 0.0, 1.0, 1.0), InRange(green, 0.0, 1.0, 1.0), InRange(blue, 0.0, 1.0, 1.0) };
}
}

namespace rtglyphs
{
/**
 * An enumerator from `First`, the default, to `Last`: of a number out of this range the nearest.
 */
template <class Enumeration, Enumeration First, Enumeration Last>
class RayTracedEnum
{
public:
  RayTracedEnum() = default;
  template <class Number>
  RayTracedEnum& operator=(Number number)
  {
    const int value = std::clamp(static_cast<int>(number), static_cast<int>(First), static_cast<int>(Last));
    this->Value = static_cast<Enumeration>(value);
    return *this;
  }
  operator Enumeration() const { return this->Value; }

private:
  Enumeration Value = First;
};
}

#endif
