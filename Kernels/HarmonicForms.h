// Arrays of numbers as homogeneous polynomials of the coordinates of a direction: spherical harmonics and tensors.
#pragma once

#include <cstdint>
#include <vector>

namespace rtg
{

/// Real spherical harmonics of even bands l = 0, 2, ..., in each of which m goes from -l to l. K is the normalized
/// associated Legendre function sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!) P_l^|m|(cos theta) with the Condon-Shortley phase
/// (-1)^m, phi the azimuth from x to y; all are multiplied with sqrt(2) where m is not 0.
enum class HarmonicsBasis : std::uint32_t
{
  MRtrix3 = 0,     ///< m < 0: K sin |m| phi; m > 0: K cos m phi. Tournier et al. 2019
  Dipy = 1,        ///< m < 0: (-1)^m K cos m phi; m > 0: K sin m phi. Descoteaux et al. 2007
  DipyLegacy = 2,  ///< m < 0: K cos m phi; m > 0: K sin m phi. DIPY before version 1.2 and by default since
  Orthonormal = 3, ///< as MRtrix3 without the phase: m = 1 is positive where x is
};

constexpr int mostDegree = 12;

/// Coefficients of a homogeneous polynomial of three coordinates.
constexpr int FormTerms(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// Place of the coefficient of x^a y^b z^c (Shapes/PolynomialForm.glsl).
constexpr int FormTerm(int b, int c)
{
  return (b + c) * (b + c + 1) / 2 + c;
}

/// A linear map from the components of an array to the coefficients of a polynomial.
class FormMap
{
public:
  /// Harmonics of 1, 6, 15, 28, 45, 66 or 91 components: bands up to 0, 2, ..., 12. Throws rtg::Error for others.
  static FormMap Harmonics(int components, HarmonicsBasis basis);
  /// n^T s n of xx, yy, zz, xy, yz, xz.
  static FormMap NormalStress();
  /// C_ijkl n_i n_j n_k n_l of 15, 21, 36 or 81 components. 15: those of a symmetric tensor with indices in
  /// alphabetical order, xxxx, xxxy, xxxz, xxyy, ..., zzzz. 36: the matrix of pairs xx, yy, zz, yz, xz, xy, row by row;
  /// 21: its upper triangle, row by row; the numbers are components of the tensor. 81: i, j, k, l, the last one
  /// fastest. Throws rtg::Error for others.
  static FormMap FourthOrder(int components);

  static bool IsHarmonicsLength(int components);
  static bool IsFourthOrderLength(int components);

  int Degree() const { return this->degree_; } ///< even, at least 2
  /// FormTerms(Degree()) coefficients.
  void Apply(const double* components, double* coefficients) const;

private:
  FormMap(int components, int degree);
  double& At(int term, int component) { return this->matrix_[term * this->components_ + component]; }

  int components_, degree_;
  std::vector<double> matrix_; ///< a row for each coefficient
};

} // namespace rtg
