// Symmetric tensors and the glyphs that show them: from six numbers to a frame, three lengths and
// three exponents of Shapes/NestedSuperquadric.glsl.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace rtg
{

struct SymmetricTensor
{
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, xz = 0;

  /// Of a matrix that is symmetric.
  static SymmetricTensor Of(const glm::dmat3& m) { return { m[0][0], m[1][1], m[2][2], m[1][0], m[2][1], m[2][0] }; }

  bool IsFinite() const;
  bool IsZero() const;
  /// Component of the largest magnitude, in magnitude.
  double Largest() const;
  glm::dmat3 Matrix() const;
};

/// The vector w with (A - A^T) / 2 x = w cross x, of nine numbers row by row. The tensor of a velocity
/// gradient (row i, column j: d v_i / d x_j) rotates about w at |w| radians a unit of time.
glm::dvec3 AntisymmetricAxis(const double* matrix);

struct Eigensystem
{
  glm::dvec3 values{ 0.0 };  ///< largest first, by sign: l1 >= l2 >= l3
  glm::dmat3 vectors{ 1.0 }; ///< columns; orthonormal and right-handed
};

/// Decomposition by Jacobi's rotations (Golub, Van Loan: Matrix Computations, 4th edition, section 8.5), after
/// scaling by a power of two; then Rayleigh quotients in double words. Eigenvalues are right to a few ulps of
/// themselves up to ratios of 1e12 and more; for an eigenvalue that is zero, to 1e-28 of the largest.
/// The largest component of the first and of the second vector is positive (of several the first one);
/// the third is their cross product. Equal eigenvalues keep the order of the coordinate axes that their
/// vectors started from, so that an isotropic tensor has the identity as its frame.
/// The tensor must be finite.
Eigensystem Decompose(const SymmetricTensor& tensor);

/// sqrt(3/2) |l - mean| / |l|: 0 for equal eigenvalues, 1 for a single positive one, up to sqrt(3/2)
/// for mixed signs; 0 for the zero tensor. Basser, Pierpaoli, J. Magn. Reson. B 111, 1996.
double FractionalAnisotropy(const glm::dvec3& values);

/// Exponents of Shapes/NestedSuperquadric.glsl, in a frame whose z axis lies along one eigenvector.
struct TensorExponents
{
  double alpha = 1.0;      ///< of the cross-section: 1 round, 0 square
  double beta = 1.0;       ///< of the profile over x: 0 cylinder, 1 ball, 2 cone, above that a thorn
  double c = 1.0;          ///< of the profile over y
  bool alongFirst = false; ///< z lies along the first eigenvector; else along the third
};

/// Kindlmann: Superquadric Tensor Glyphs, VisSym 2004, equations 1 to 5. `lengths` are non-negative and
/// in falling order; `sharpness` is gamma >= 0; at 0 every glyph is an ellipsoid.
TensorExponents KindlmannExponents(const glm::dvec3& lengths, double sharpness);

/// A point (u, v) of the square of eigenvalue signs and ratios, both in [0, 1], of Schultz, Kindlmann:
/// Superquadric Glyphs for Symmetric Second-Order Tensors, IEEE TVCG 16(6), 2010, figure 6, with the
/// orientation that Teem gives it: (1, 1) has three equal positive eigenvalues, (0, 0) three
/// negative ones. `values` in falling order, not all zero.
glm::dvec2 EigenvalueSquare(const glm::dvec3& values);

/// Exponents at (u, v) before sharpening; `concave` is beta of the two concave corners,
/// 3 in the publication.
TensorExponents SchultzKindlmannBase(const glm::dvec2& uv, double concave = 3.0);

/// The same sharpened: alpha^gamma; beta, c below 1: to the power of gamma; above 2: (beta - 2) gamma + 2.
TensorExponents SchultzKindlmannExponents(const glm::dvec3& values, double sharpness);

enum class TensorGlyphKind : std::uint32_t
{
  Ellipsoid = 0,         ///< half-lengths |l|
  Superquadric = 1,      ///< Kindlmann 2004, by the magnitudes of the eigenvalues
  SignedSuperquadric = 2 ///< Schultz, Kindlmann 2010
};

/// A glyph with half-lengths equal to the eigenvalues' magnitudes.
struct TensorGlyph
{
  glm::dvec3 values{ 1.0 };                  ///< eigenvalues, with their signs, along the glyph's own axes
  glm::dvec3 halfLengths{ 1.0 };             ///< along the glyph's own axes
  glm::dquat rotation{ 1.0, 0.0, 0.0, 0.0 }; ///< the glyph's own frame to the world
  glm::dvec3 exponents{ 1.0 };               ///< alpha, beta, c
};

/// Smallest ratio of a glyph's half-lengths to its largest: below it the shapes are not tested.
constexpr double thinnestTensorGlyph = 1e-3;

/// No exponent is less than this: a superquadric's edges have at least about this radius.
constexpr double leastTensorExponent = 0.01;

/// The glyph of a finite tensor that is not zero. Below `noise`, in units of the eigenvalues, exponents go
/// smoothly to those of a ball: there the ratios of eigenvalues mean nothing any more. No half-length is less than
/// the fraction `thinnest` of the largest: where an eigenvalue is zero the glyph is thin but visible.
TensorGlyph MakeTensorGlyph(const Eigensystem& eigen, TensorGlyphKind kind, double sharpness, double noise = 0.0,
  double thinnest = thinnestTensorGlyph);

} // namespace rtg
