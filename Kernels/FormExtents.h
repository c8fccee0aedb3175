// Bounds of the glyph |p| = |f(p / |p|)| of a homogeneous polynomial, with proof.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace rtg
{

/// All in units of f.
struct FormExtent
{
  double radius = 0.0;     ///< the largest |f| on the unit sphere, right to 1e-6; 0: there is no glyph
  double bound = 0.0;      ///< certainly not less; less than 2 % more
  glm::dvec3 reach{ 0.0 }; ///< a bound of the glyph's half extent along each axis, not more than `bound`
};

/// Measures polynomials of one degree, by two grids of directions (Shapes/README.md, Polynomials). Several threads may
/// use one.
class FormMeter
{
public:
  explicit FormMeter(int degree);
  int Degree() const { return this->degree_; }

  FormExtent Measure(const double* coefficients) const;

  /// The same by the first grid alone, in a quarter of the time: `radius` is up to 13 % too small, `bound` and `reach`
  /// are up to 14 % too large.
  FormExtent MeasureRoughly(const double* coefficients) const;

  /// Input of the programs (Shapes/PolynomialForm.glsl): the polynomial divided by `extent.bound`, in floats, and
  /// before it the extents of what is left by rounding. 3 + FormTerms(Degree()) values.
  void Store(const double* coefficients, const FormExtent& extent, float* values) const;

private:
  struct Samples;
  Samples Sample(const double* coefficients) const;
  double Value(const double* coefficients, const glm::dvec3& n) const;
  double Climb(const double* coefficients, glm::dvec3 n) const;

  int degree_;
  double side_ = 0.0;                      ///< of a cell of the first grid
  double coarse_ = 1.0, fine_ = 1.0;       ///< cos(m a) of both grids
  std::vector<glm::dvec3> directions_;     ///< of the first grid
  std::vector<glm::dvec3> fineDirections_; ///< of the second, those in each cell of the first one after the other
  std::vector<double> monomials_;          ///< term by term, of all directions
  std::vector<double> largest_;            ///< of each term on the sphere
};

} // namespace rtg
