/**
 * How large the glyphs of points are, before the actor's matrix. vtkGlyphMagnitudes is what the data make of the unit
 * glyph, and sees no settings but those of vtkGlyphScaling; vtkGlyphSizes adds the factor, limits and radii.
 *
 * Threads may share an object, each with Tuples of its own.
 */
#ifndef vtkGlyphSizes_h
#define vtkGlyphSizes_h

#include "vtkGlyphOutcomes.h"
#include "vtkGlyphSettings.h"
#include "vtkGlyphTuples.h"

#include <glm/gtc/quaternion.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkGlyphMagnitudes
{
public:
  /**
   * `chosen`: the points that have glyphs, for the exponents of tensors (vtkGlyphTensors). Arrays that are missing or
   * do not fit scale nothing.
   */
  vtkGlyphMagnitudes(vtkPolyData* points, const vtkGlyphScaling& scaling,
    const std::vector<vtkIdType>& chosen = std::vector<vtkIdType>());

  struct Tuples
  {
    explicit Tuples(const vtkGlyphMagnitudes& magnitudes)
      : Scales(magnitudes.ScaleArray)
      , Forms(magnitudes.FormArray)
    {
    }
    vtkGlyphTuples Scales, Forms;
  };

  bool HasScales() const { return this->ScaleArray != nullptr; }
  bool ScalesByComponents() const { return this->ByComponents; }

  ///@{
  /**
   * Null: none are shown. GetProblem() says why where some are wanted, with the remedy.
   */
  const vtkGlyphTensors* GetTensors() const { return this->Tensors.get(); }
  const vtkGlyphForms* GetForms() const { return this->Forms.get(); }
  const std::string& GetProblem() const { return this->Problem; }
  ///@}

  /**
   * By the scale array along the glyph's axes, with its signs.
   */
  glm::dvec3 Scale(vtkIdType point, Tuples& tuples) const;

  /**
   * By everything, along the longest axis; 0: the point has no glyph. No less than the exact one, and hardly more.
   */
  double Magnitude(vtkIdType point, Tuples& tuples) const;

protected:
  /**
   * By everything along each axis, bounded from above. `form` is that of the polynomial, if there is one; its `bound`
   * takes no part.
   */
  glm::dvec3 Bound(vtkIdType point, Tuples& tuples, rtg::FormExtent& form) const;

private:
  const vtkGlyphScaling Scaling;
  vtkDataArray *ScaleArray, *FormArray;
  const bool ByComponents;
  std::unique_ptr<const vtkGlyphTensors> Tensors;
  std::unique_ptr<const vtkGlyphForms> Forms;
  std::string Problem;
};

class vtkGlyphSizes : public vtkGlyphMagnitudes
{
public:
  /**
   * The settings stay the caller's.
   */
  vtkGlyphSizes(vtkPolyData* points, const vtkGlyphSettings& settings,
    const std::vector<vtkIdType>& chosen = std::vector<vtkIdType>());

  struct Tuples : vtkGlyphMagnitudes::Tuples
  {
    explicit Tuples(const vtkGlyphSizes& sizes)
      : vtkGlyphMagnitudes::Tuples(sizes)
      , Radii(sizes.RadiusArray)
    {
    }
    vtkGlyphTuples Radii;
  };

  bool HasRadii() const { return this->RadiusArray != nullptr; }

  /**
   * Length of the arrow whose fixed head has the proportions of the unit arrow; 0: each glyph's width stands for it.
   */
  double ArrowUnit() const;

  struct Glyph
  {
    glm::dvec3 Size{ 0.0 };                    // extents; negative ones mirror
    glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 }; // of tensors
    rtg::TensorGlyph Tensor;
    float Radius = 0.0f; // of a polynomial: the |f| that half the size stands for, in units of the array
  };

  /**
   * The glyph, and the values of its polynomial, where it is SHOWN.
   */
  vtkGlyphOutcomes::Outcome Make(vtkIdType point, Tuples& tuples, Glyph& glyph, float* polynomial) const;

  /**
   * Positive extents, no less than the exact ones; `part`: the part of them that is left when the polynomial's own
   * shape counts, instead of all it may become.
   */
  glm::dvec3 Extents(vtkIdType point, Tuples& tuples, glm::dvec3& part) const;

private:
  void Finish(vtkIdType point, Tuples& tuples, glm::dvec3& size) const;

  const vtkGlyphSettings& Settings;
  vtkDataArray* RadiusArray;
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphSizes.h
