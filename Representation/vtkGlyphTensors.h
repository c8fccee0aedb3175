/**
 * @class   vtkGlyphTensors
 * @brief   an array of tensors as the sizes, rotations and exponents of glyphs
 *
 * Nine components are a matrix row by row whatever the layout, and their symmetric part counts; six are read as the layout
 * says. See Kernels/Tensor.h for what the glyphs are.
 */
#ifndef vtkGlyphTensors_h
#define vtkGlyphTensors_h

#include "Tensor.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

class vtkGlyphTensors
{
public:
  enum Colorings
  {
    NONE = 0,
    PRINCIPAL_DIRECTION = 1,
    FRACTIONAL_ANISOTROPY = 2,
    TRACE = 3
  };

  struct Settings
  {
    bool On = false; // whether the glyphs show tensors at all
    rtg::TensorGlyphKind Kind = rtg::TensorGlyphKind::Ellipsoid;
    std::string Array; // empty or "None": none
    rtg::TensorLayout Layout = rtg::TensorLayout::Vtk;
    double Sharpness = 3.0;
    int Coloring = NONE;
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
  vtkGlyphTensors(
    vtkDataArray* array, const Settings& settings, const std::vector<vtkIdType>& points);

  /**
   * No eigenvalue of the finite tensors is larger in magnitude: the largest Frobenius norm.
   */
  static double Largest(vtkDataArray* array, const Settings& settings);

  /**
   * False: the tensor is zero or not finite.
   */
  bool Glyph(vtkIdType point, rtg::TensorGlyph& glyph) const;

  /**
   * The components' magnitudes of the unit eigenvector of the eigenvalue with the largest magnitude, as red, green and
   * blue in [0, 1]; false as above.
   */
  bool DirectionColor(vtkIdType point, double rgb[3]) const;

  ///@{
  /**
   * The number of the coloring: the fractional anisotropy of the eigenvalues, or the trace, in units of the tensor. False:
   * there is none, as above. NumberRange is its largest magnitude: 1, or that of the trace over the points given.
   */
  bool Number(vtkIdType point, double& value) const;
  double NumberRange() const { return this->Range; }
  ///@}

private:
  rtg::SymmetricTensor Tensor(vtkIdType point) const;

  vtkDataArray* Tensors;
  Settings How;
  double Noise = 0.0;
  double Range = 1.0;
};

#endif
