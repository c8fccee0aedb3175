// Crossings of a line with the surface |p| = |f(p / |p|)| of a homogeneous polynomial f, by other means than
// Kernels/Shapes/Polynomial.glsl: all real roots of the polynomial |p|^(2k+2) - f(p)^2 of the line's parameter, between
// those of its derivatives.
#pragma once

#include "Reference.h"

#include <vector>

namespace rtg::testing
{

class PolynomialReference
{
public:
  struct Crossing
  {
    Quad s;
    Quad gradient[3]; ///< of |p| - |f|, outwards
    Quad fromCenter;
  };

  /// `coefficients` in the order of Kernels/Shapes/PolynomialForm.glsl, exact; `degree` even.
  PolynomialReference(std::vector<Quad> coefficients, int degree);

  /// In the frame where the half-lengths are 1; s is in lengths of the direction, in order.
  std::vector<Crossing> Crossings(const Quad origin[3], const Quad direction[3]) const;

  /// f at a point, and its derivatives by the coordinates where there is room for them.
  Quad Value(const Quad point[3], Quad gradient[3] = nullptr) const;

private:
  std::vector<Quad> coefficients_;
  int degree_;
};

} // namespace rtg::testing
