/**
 * @class   GlyphTensors
 * @brief   an array of tensors as the sizes, rotations and exponents of glyphs
 *
 * Of matrices the symmetric part counts. See Kernels/Tensor.h for what the glyphs are.
 */
#ifndef GlyphTensors_h
#define GlyphTensors_h

#include "GlyphOutcomes.h"
#include "RayTracedNumbers.h"
#include "Tensor.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace rtglyphs
{

class GlyphTensors
{
public:
  enum Colorings
  {
    NONE = 0,
    FRACTIONAL_ANISOTROPY = 1,
    TRACE = 2,
    SIGN = 3,        // of x^T D x at each point x of a glyph's surface, seen from its center
    EIGENVALUES = 4, // their magnitudes as red, green and blue
    MAJOR_EIGENVALUE = 5,
    MIDDLE_EIGENVALUE = 6,
    MINOR_EIGENVALUE = 7,
    RADIUS = 8 // |f| at each point of a polynomial's surface
  };

  /**
   * Orders of the components of tuples, in GlyphTensors.cxx by their indices.
   */
  enum TensorLayouts
  {
    VTK_ORDER = 0,
    ROW = 1,
    LAMMPS = 2,
    MATRIX = 3,
    LOWER = 4,
    VOIGT = 5
  };

  /**
   * Reads tuples of an array: by the names of its components, where these are indices such as xx or 11, else as the
   * layout says for their number; nine are always a matrix, and seven a confidence before Row. Without confidence there
   * is no tensor.
   */
  class Order
  {
  public:
    Order(vtkDataArray* array, int layout);
    /// Whether there is an order for so many components.
    explicit operator bool() const { return !this->Places.empty(); }
    rtg::SymmetricTensor operator()(const double* tuple) const;

  private:
    struct Place
    {
      double rtg::SymmetricTensor::*To;
      double Weight;
    };
    std::vector<Place> Places; // of each component; null: a confidence
  };

  /**
   * Whether a coloring is one number for each tensor.
   */
  static bool IsNumber(int coloring)
  {
    return coloring == FRACTIONAL_ANISOTROPY || coloring == TRACE ||
      (coloring >= MAJOR_EIGENVALUE && coloring <= MINOR_EIGENVALUE);
  }

  /**
   * Settings of the glyphs' size.
   */
  struct Source
  {
    bool On = false;   // whether the glyphs show tensors at all
    std::string Array; // empty or "None": none
    RayTracedEnum<TensorLayouts, VTK_ORDER, VOIGT> Layout{};
    bool Covariances = false; // of Gaussians; their glyphs are the ellipsoids that hold a fraction of each
    double Confidence = 0.95; // that fraction

    bool operator==(const Source&) const = default;
  };

  struct Settings : Source
  {
    rtg::TensorGlyphKind Kind = rtg::TensorGlyphKind::Ellipsoid;
    double Sharpness = 3.0;
    RayTracedEnum<Colorings, NONE, RADIUS> Coloring{};
    ///@{
    // Where x^T D x is zero or more, and where it is less; with SIGN.
    std::array<double, 3> PositiveColor{ { 0.839, 0.376, 0.302 } };
    std::array<double, 3> NegativeColor{ { 0.263, 0.576, 0.765 } };
    ///@}
    bool Axes = false; // arrows along the axes of the antisymmetric parts instead of glyphs of the symmetric ones

    bool operator==(const Settings&) const = default;
    bool HasRange() const { return this->On && (IsNumber(this->Coloring) || this->Coloring == EIGENVALUES); }
    bool ColorsBySign() const { return this->On && !this->Axes && this->Coloring == SIGN; }

    /// With all that has no effect on instances at its default: colors, but for whether the glyphs need forms of signs.
    Settings Effective() const;
  };

  /**
   * The array that the settings name when they are on; null when there is none.
   */
  static vtkDataArray* Array(vtkPolyData* points, const Settings& settings);

  /**
   * Why the array cannot be shown, with the remedy; empty when it can.
   */
  static std::string Problem(vtkDataArray* array, const Settings& settings);

  /**
   * For an array without a problem. Exponents of tensors below a millionth of the largest of `points` go to those of a
   * ball.
   */
  GlyphTensors(vtkDataArray* array, const Settings& settings, const std::vector<vtkIdType>& points);

  /**
   * How many standard deviations the ellipsoid of a Gaussian in three dimensions reaches that holds this fraction of
   * it.
   */
  static double RadiusOf(double confidence);

  /**
   * Of a Gaussian of vectors: the cone of tangents from zero to that ellipsoid of the covariance round the mean with
   * which it holds a fraction of all directions; and the lengths along its axis, x, between which the same fraction of
   * all vectors lies. False: no cone of less than 75 degrees does.
   */
  struct Cone
  {
    double Least = 0.0, Most = 0.0;
    double Slopes[2] = { 0.0, 0.0 }; // of its sides, along y and z
    glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  };
  static bool
  ConeOf(const glm::dvec3& mean, const glm::dvec3& deviations, const glm::dquat& frame, double confidence, Cone& cone);

  /**
   * Factor of the longest extent of a unit glyph: the largest magnitude of an eigenvalue, of a covariance
   * the ellipsoid's diameter, of axes the axis's length. Zero where it is not finite.
   */
  double Extent(vtkIdType point) const;

  /**
   * The vector w of a matrix A of nine components with (A - A^T) / 2 x = w cross x, in units of the tensor: of a
   * velocity gradient (row i, column j: d v_i / d x_j) the angular velocity, half the vorticity. False: there is none,
   * because A is symmetric to a millionth of its largest component, not finite, or given by six numbers.
   */
  bool Axis(vtkIdType point, glm::dvec3& axis) const;

  /**
   * SHOWN, or why there is no glyph.
   */
  GlyphOutcomes::Outcome Glyph(vtkIdType point, rtg::TensorGlyph& glyph) const;

  /**
   * Eigenvalues, largest first, in units of the tensor, and eigenvectors; false: the tensor is zero or not finite.
   */
  bool Decompose(vtkIdType point, rtg::Eigensystem& eigen) const;

  /**
   * The unit eigenvector of the eigenvalue with the largest magnitude; zero where there is none.
   */
  glm::dvec3 PrincipalDirection(vtkIdType point) const;

  /**
   * The number of the coloring: the fractional anisotropy of the eigenvalues; or, in units of the tensor, the trace or
   * one eigenvalue, of EIGENVALUES the largest magnitude of one. False as above.
   */
  bool Number(vtkIdType point, double& value) const;

private:
  rtg::SymmetricTensor Tensor(vtkIdType point) const;

  vtkDataArray* Tensors;
  Settings How;
  Order Read;
  double Noise = 0.0;
  double Radius = 0.0; // RadiusOf() the confidence, of covariances
};

} // namespace rtglyphs

#endif
