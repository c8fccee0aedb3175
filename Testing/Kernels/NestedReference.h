// Where a line crosses the surface of Kernels/Shapes/NestedSuperquadric.glsl, by other means: bisection of the gauge's
// slope where the body is convex, else subdivision by bounds that hold in every octant, in 64 bits; then in 113.
#pragma once

#include "Quad.h"

#include <vector>

namespace rtg::testing
{

class NestedReference
{
public:
  struct Crossing
  {
    Quad s = 0;
    Quad gradient[3] = { 0, 0, 0 }; ///< outward, in the frame of the half-lengths
    Quad edgeDistance = 1;          ///< to the rim, tip or seam where there is one, in that frame
  };

  NestedReference(double alpha, double beta, double c);

  /// All crossings of the line o + s d, in the frame of the half-lengths; o is near the center. `precise`: to 113
  /// bits, else to 64 and without gradients.
  std::vector<Crossing> Crossings(const Quad o[3], const Quad d[3], bool precise) const;

private:
  using Long = long double;

  /// log of the p-norm of the two quotients x / Rx, y / Ry, which is 0 on the surface and grows with |x|, |y|, |z|.
  template <class Real>
  Real Value(const Real point[3], Real* gradient) const;
  /// The same and its slope along the line, in 64 bits.
  Long Along(Long s, Long* slope) const;
  void FindConvex(Long from, Long to, std::vector<Long>& roots) const;
  void FindPieces(Long from, Long to, std::vector<Long>& roots) const;
  void Divide(Long from, Long to, Long octantFrom, Long octantTo, std::vector<Long>& roots) const;
  void Finish(Long from, Long to, std::vector<Long>& roots) const;
  Long Bisect(Long from, Long to) const;

  double alpha_, beta_, c_;
  mutable Long o_[3], d_[3];
};

} // namespace rtg::testing
