/**
 * How large the glyphs of points are, before the actor's matrix. GlyphMagnitudes is what the data make of the unit
 * glyph, and sees no settings but those of GlyphScaling; GlyphSizes adds the factor, limits and radii.
 *
 * Threads may use one object, each with Tuples of its own.
 */
#ifndef GlyphSizes_h
#define GlyphSizes_h

#include "GlyphOutcomes.h"
#include "GlyphSettings.h"
#include "GlyphTuples.h"

#include <glm/gtc/quaternion.hpp>

#include <memory>
#include <string>
#include <vector>

namespace rtglyphs
{

class GlyphMagnitudes
{
public:
  /**
   * `chosen`: the points that have glyphs, for the exponents of tensors (GlyphTensors). Arrays that are missing or
   * do not fit scale nothing.
   */
  GlyphMagnitudes(
    vtkPolyData* points, const GlyphScaling& scaling, const std::vector<vtkIdType>& chosen = std::vector<vtkIdType>());

  struct Tuples
  {
    explicit Tuples(const GlyphMagnitudes& magnitudes)
      : Scales(magnitudes.ScaleArray)
      , Forms(magnitudes.FormArray)
    {
    }
    GlyphTuples Scales, Forms;
  };

  /// Whether the point is of a block that lacks an array of scales, tensors or polynomials, which others have: it has
  /// no glyph.
  bool Lacks(vtkIdType point, Tuples& tuples) const
  {
    return this->RankLacksScales || (tuples.Scales && !tuples.Scales.Has(point)) ||
      (tuples.Forms && !tuples.Forms.Has(point)) || this->MissingTensors.Has(point);
  }
  bool HasScales() const { return this->ScaleArray != nullptr; }
  bool ScalesByComponents() const { return this->ByComponents; }

  ///@{
  /**
   * Null: none are shown. GetProblem() says why where some are wanted, with the remedy.
   */
  const GlyphTensors* GetTensors() const { return this->Tensors.get(); }
  const GlyphForms* GetForms() const { return this->Forms.get(); }
  const std::string& GetProblem() const { return this->Problem; }
  ///@}

  /**
   * Factors along the glyph's axes by the scale array, with its signs.
   */
  glm::dvec3 Scale(vtkIdType point, Tuples& tuples) const;

  /**
   * Factor along the longest axis by everything; 0: the point has no glyph. It is no less than the exact one, and
   * hardly more.
   */
  double Magnitude(vtkIdType point, Tuples& tuples) const;

protected:
  /**
   * Upper bounds of the factors along each axis by everything. `form` is that of the polynomial, if there is one; its
   * `bound` takes no part.
   */
  glm::dvec3 Bound(vtkIdType point, Tuples& tuples, rtg::FormExtent& form) const;

private:
  const GlyphScaling Scaling;
  vtkDataArray *ScaleArray, *FormArray;
  const bool ByComponents, RankLacksScales;
  std::unique_ptr<const GlyphTensors> Tensors;
  RayTracedRanges MissingTensors;
  std::unique_ptr<const GlyphForms> Forms;
  std::string Problem;
};

class GlyphSizes : public GlyphMagnitudes
{
public:
  /**
   * The settings stay the caller's.
   */
  GlyphSizes(vtkPolyData* points, const GlyphSettings& settings,
    const std::vector<vtkIdType>& chosen = std::vector<vtkIdType>());

  struct Tuples : GlyphMagnitudes::Tuples
  {
    explicit Tuples(const GlyphSizes& sizes)
      : GlyphMagnitudes::Tuples(sizes)
      , Radii(sizes.RadiusArray)
      , Reduced(sizes.ReducedArray)
    {
    }
    GlyphTuples Radii, Reduced;
  };

  bool HasRadii() const { return this->RadiusArray != nullptr; }
  bool IsReduced() const { return this->ReducedArray != nullptr; }

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
  GlyphOutcomes::Outcome Make(vtkIdType point, Tuples& tuples, Glyph& glyph, float* polynomial) const;

  /**
   * The cone of a vector whose covariance's ellipsoid the glyph is.
   */
  GlyphOutcomes::Outcome
  MakeCone(const Glyph& glyph, GlyphTuples& vectors, vtkIdType point, GlyphTensors::Cone& cone) const;

  /**
   * Positive extents, no less than the exact ones; `part`: the part of them that is left when the polynomial's own
   * shape counts, instead of all it may become.
   */
  glm::dvec3 Extents(vtkIdType point, Tuples& tuples, glm::dvec3& part) const;

private:
  void Finish(vtkIdType point, Tuples& tuples, glm::dvec3& size) const;

  const GlyphSettings& Settings;
  vtkDataArray *RadiusArray, *ReducedArray;
};

} // namespace rtglyphs

#endif
