/**
 * @class   GlyphMaker
 * @brief   a point's glyph: its position, size, rotation and shape, or why there is none
 *
 * Arrays mean what they mean to vtkGlyph3DMapper: magnitudes of scale arrays of any length, components of arrays of
 * three; orientation by direction (the same half turn, so that also boxes agree), by angles about z, x, y in degrees
 * or by quaternion (w, x, y, z).
 *
 * Superquadrics have exponents, the same for all or from an array: with one component the same on every axis, with two
 * the first across (x and y) and the second along z, with three one for each axis. For Nested Superquadric the first is
 * that along z, the second that across, as blockiness is given in granular matter codes; one component is both.
 *
 * With a table of meshes the magnitude of the index array's tuple, truncated and clamped to the table, is
 * the index of a point's mesh.
 *
 * A negative scale component mirrors the glyph. That changes nothing about a sphere, box or cylinder; cones and arrows
 * point the other way, as 3D Glyphs shows them; meshes are mirrored. Shapes other than arrows and cones are not turned
 * where their direction is zero.
 */
#ifndef GlyphMaker_h
#define GlyphMaker_h

#include "GlyphOutcomes.h"
#include "GlyphPlacement.h"
#include "GlyphSettings.h"
#include "GlyphSizes.h"
#include "GlyphTuples.h"
#include "Tensor.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMatrix4x4;
class vtkPolyData;

namespace rtglyphs
{

class GlyphMaker
{
public:
  /**
   * Takes the arrays that exist and fit; `messages` gets a warning for others. The settings and their `sizes` stay the
   * caller's.
   */
  GlyphMaker(vtkPolyData* points, const GlyphSettings& settings, vtkMatrix4x4* modelToWorld, const GlyphSizes& sizes,
    std::vector<std::string>& messages);

  /**
   * Values of one thread.
   */
  class Tuples
  {
  public:
    explicit Tuples(const GlyphMaker& maker)
      : Positions(maker.Positions)
      , Sizes(maker.Sizes)
      , Named(maker.Arrays.begin(), maker.Arrays.end())
    {
    }
    GlyphTuples& operator[](GlyphArrays::Id id) { return this->Named[id]; }
    GlyphTuples Positions;
    GlyphSizes::Tuples Sizes;

  private:
    std::vector<GlyphTuples> Named; // by GlyphArrays::Id
  };

  struct Glyph
  {
    glm::dvec3 Center{ 0.0 }; // from the origin
    glm::vec3 Size{ 0.0f };   // extents; negative ones mirror a mesh
    glm::vec4 Turn = NoTurn;  // quaternion (x, y, z, w)
    rtg::TensorGlyph Tensor;
    glm::vec3 Exponents{ 2.0f };
    float Radius = 0.0f; // of a polynomial: the |f| that half the size stands for, in units of the array

    float SmallestExtent() const
    {
      const glm::vec3 extent(glm::abs(this->Size));
      return std::min({ extent.x, extent.y, extent.z });
    }
  };

  /**
   * One of the glyphs of a point, by its number below Parts(). Where it is SHOWN, `glyph` is what it is, and the values
   * of its polynomial, if it is one, are at `polynomial`. For several threads at the same time.
   */
  GlyphOutcomes::Outcome
  Make(vtkIdType point, int part, const glm::dvec3& origin, Tuples& tuples, Glyph& glyph, float* polynomial) const;

  /**
   * Where most of the points are: the median of some of them, axis by axis, so that outliers do not count.
   */
  glm::dvec3 MiddleOf(const std::vector<vtkIdType>& points) const;

  bool Has(GlyphArrays::Id id) const { return this->Arrays[id] != nullptr; }
  const GlyphSizes& GetSizes() const { return this->Sizes; }
  const GlyphPlacement& GetPlacement() const { return this->Placement; }
  int Parts() const { return this->NumberOfParts; } // glyphs of each point

  ///@{
  /**
   * Values that differ between glyphs, so each has its own: sizes, those along axes, rotations. Glyphs that look the
   * same from all sides are not rotated.
   */
  bool HasSameSizes() const { return this->SameSizes; }
  bool HasOneSize() const { return this->OneSize; }
  bool IsTurned() const { return this->Turned || this->Flips; }
  bool IsRound() const { return this->Sphere && this->OneSize; }
  ///@}

  /**
   * Of all glyphs, where no array has them.
   */
  const glm::vec3& GetSameExponents() const { return this->SameExponents; }

  /**
   * A tuple's exponents as the kernels want them; false: there are none.
   */
  static bool MakeExponents(rtg::Shape shape, const double* tuple, int components, glm::vec3& exponents);

  static constexpr glm::vec4 NoTurn{ 0.0f, 0.0f, 0.0f, 1.0f };

private:
  glm::dvec3 PlaceOf(vtkIdType point, Tuples& tuples) const;
  bool IsOfThisForm(vtkIdType point, Tuples& tuples, GlyphOutcomes::Outcome& otherwise) const;
  GlyphOutcomes::Outcome Turn(vtkIdType point, Tuples& tuples, glm::dquat& rotation) const;

  const GlyphSettings& How;
  const GlyphSizes& Sizes;
  const GlyphPlacement Placement;
  const bool ChoosesForm, OwnExponents, Sphere, Pointed;
  const double AnchorShift; // of the unit glyph
  const int NumberOfParts;
  vtkDataArray* const Positions;
  std::array<vtkDataArray*, GlyphArrays::NUMBER_OF_IDS> Arrays{}; // null: none, or it does not fit
  int OrientationMode = GlyphSettings::DIRECTION;                 // of the array that was found
  bool SameSizes = false, OneSize = false;                        // for all glyphs; for all axes of one
  bool Turned = false, Flips = false;
  bool GoodExponents = false; // of the settings
  glm::vec3 SameExponents{ 2.0f };
};

} // namespace rtglyphs

#endif
