/**
 * @class   GlyphForms
 * @brief   an array of spherical harmonics or tensors as polynomials whose magnitude is the radius of a glyph
 *
 * See Kernels/HarmonicForms.h for what the components are.
 */
#ifndef GlyphForms_h
#define GlyphForms_h

#include "GlyphTensors.h"
#include "FormExtents.h"
#include "HarmonicForms.h"
#include "RayTracedNumbers.h"
#include "Tensor.h"
#include "vtkType.h"

#include <array>
#include <string>

class vtkDataArray;
class vtkPolyData;
namespace rtglyphs
{
class GlyphTuples;

class GlyphForms
{
public:
  enum Kinds
  {
    HARMONICS = 0,
    REYNOLDS = 1,    // normal stress of tensors of second order
    FOURTH_ORDER = 2 // of those of fourth order
  };

  struct Settings
  {
    bool On = false; // whether the glyphs show polynomials at all
    int Kind = HARMONICS;
    std::string Array;                    // empty or "None": none
    int Layout = GlyphTensors::VTK_ORDER; // of tensors of second order
    RayTracedEnum<rtg::HarmonicsBasis, rtg::HarmonicsBasis::MRtrix3, rtg::HarmonicsBasis::Orthonormal> Basis;
    int Coloring = 0; // GlyphTensors::SIGN or RADIUS count

    bool operator==(const Settings&) const = default;

    /// With all that has no effect on instances at its default.
    Settings Effective() const;
    bool ColorsByRadius() const { return this->On && this->Coloring == GlyphTensors::RADIUS; }
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
   * For an array without a problem. The members that follow serve several threads at the same time; a thread's tuples
   * are its own.
   */
  GlyphForms(vtkDataArray* array, const Settings& settings);

  int Degree() const { return this->Meter.Degree(); }
  int Width() const { return 3 + rtg::FormTerms(this->Degree()); } // values of a glyph

  /**
   * How large |f| becomes, in units of the array; its radius is zero where components are not finite or all zero.
   * `values` become those that the kernels take. Roughly: see rtg::FormMeter.
   */
  rtg::FormExtent Measure(GlyphTuples& tuples, vtkIdType point, float* values) const;
  rtg::FormExtent MeasureRoughly(GlyphTuples& tuples, vtkIdType point) const;

  /**
   * The largest |f| of all tuples in units of the array; 0: there is none.
   */
  static double LargestRadius(vtkDataArray* array, const Settings& settings);

private:
  // Of the polynomial that a point shows.
  using Coefficients = std::array<double, rtg::FormTerms(rtg::mostDegree)>;
  Coefficients CoefficientsOf(GlyphTuples& tuples, vtkIdType point) const;

  Settings How;
  GlyphTensors::Order Read; // of tensors of second order
  rtg::FormMap Map;
  rtg::FormMeter Meter;
};

} // namespace rtglyphs

#endif
